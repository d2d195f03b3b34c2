#include "baker/plot/plots.h"

#include "baker/asset_report.h"
#include "baker/plot/svg.h"

namespace lr::baker {
namespace {

std::string stamp(const ProvenanceData& p) {
    return "made by " + p.tool + " " + p.tool_version + " from " + p.source + ", input " + hash_text(p.input_hash) +
           ", options: " + p.options;
}
} // namespace

std::string plot_description(const AssetData& asset) {
    return stamp(asset.provenance);
}

bool is_plot_of(std::string_view svg, const ProvenanceData& provenance) {
    // Searches only before the first shape.
    const std::string wanted = "<desc>" + xml_escape(stamp(provenance)) + "</desc>";
    return svg.substr(0, 65536).find(wanted) != std::string_view::npos && svg.ends_with("</svg>\n");
}

std::array<std::string, 3> make_plots(const AssetData& asset, const Mesh& body) {
    return {plot_turbulence(asset), plot_added_mass(asset, body), plot_entries(asset)};
}
} // namespace lr::baker
