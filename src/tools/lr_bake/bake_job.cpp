#include "tools/lr_bake/bake_job.h"

#include "asset/asset_file.h"
#include "baker/asset_report.h"
#include "baker/file_io.h"
#include "baker/plot/plots.h"
#include "tools/falls/how_it_falls.h"
#include "tools/lr_bake/preview.h"

#include <chrono>
#include <exception>
#include <filesystem>
#include <memory>
#include <string_view>
#include <system_error>

namespace lr::baker {
namespace {

constexpr std::size_t max_output_bytes = std::size_t{1} << 30;

std::size_t plot_count(const BakeJob& job) {
    return job.plots.empty() ? 0 : plot_names.size();
}

std::string without_slash(std::string path) {
    while (path.size() > 1 && path.back() == '/') path.pop_back();
    return path;
}

bool exists(const std::string& path_utf8) {
    std::error_code error;
    return std::filesystem::exists(std::filesystem::path(std::u8string(path_utf8.begin(), path_utf8.end())), error);
}

bool check_outputs(const BakeJob& job, Faults& faults) {
    const std::vector<std::string> outputs = job.outputs();
    // The plots' folder is created just before the plots are written.
    const std::string folder = without_slash(job.plots);
    const bool to_be_made = !folder.empty() && !exists(folder);
    bool good = !to_be_made || check_output(folder, faults);
    for (std::size_t i = 0; i < outputs.size() - (to_be_made ? plot_count(job) : 0); ++i)
        good = check_output(outputs[i], faults) && good;
    const auto differ = [&](const std::string& output, const std::string& other, const std::string& what) {
        if (!is_same_file(output, other)) return true;
        faults.push_back({FaultId::parameter_out_of_range, Severity::error, output, what, "Choose another file name."});
        return false;
    };
    const auto kind = [&](const std::string& path) {
        return std::string(path == job.output    ? "The asset"
                           : path == job.report  ? "The report"
                           : path == job.preview ? "The preview"
                                                 : "A plot");
    };
    for (std::size_t i = 0; good && i < outputs.size(); ++i) {
        if (!job.bake.semi_axes)
            good = differ(outputs[i], job.bake.mesh_path, kind(outputs[i]) + " would overwrite its input.");
        if (job.bake.mass)
            good = good &&
                   differ(outputs[i], job.bake.mass->path, kind(outputs[i]) + " would overwrite the mesh of the mass.");
        for (std::size_t j = 0; good && j < i; ++j)
            good = differ(outputs[i], outputs[j],
                          kind(outputs[i]) + " would overwrite " + (j == 0 ? "the asset." : "another output."));
    }
    return good;
}

std::string_view as_text(const std::vector<uint8_t>& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// Whether every output exists, is valid, and was made by this baker from the same input bytes with the same options.
bool is_current(const BakeJob& job) {
    if (!job.preview.empty()) return false; // a picture has no provenance
    std::vector<uint8_t> bytes;
    Faults ignored;
    AssetData asset;
    if (!read_file(job.output, max_output_bytes, bytes, ignored) ||
        !read_asset(bytes.data(), bytes.size(), asset, ignored))
        return false;
    const ProvenanceData& made = asset.provenance;
    if (made.tool != "lr_bake" || made.tool_version != baker_version() || made.options != canonical_options(job.bake) ||
        made.source != source_name(job.bake) || asset.name != asset_name(job.bake))
        return false;
    const std::vector<std::string> outputs = job.outputs();
    if (!job.report.empty() &&
        (!read_file(job.report, max_output_bytes, bytes, ignored) || !is_report_of(as_text(bytes), made)))
        return false;
    for (std::size_t i = outputs.size() - plot_count(job); i < outputs.size(); ++i)
        if (!read_file(outputs[i], max_output_bytes, bytes, ignored) || !is_plot_of(as_text(bytes), made)) return false;
    return find_input_hash(job.bake) == made.input_hash;
}

// Empty if the runtime refuses the asset: the bake itself must not fail.
std::string fall_of(const std::vector<uint8_t>& bytes) {
    lr_asset* loaded = nullptr;
    if (lr_asset_load_memory(bytes.data(), bytes.size(), &loaded) != LR_OK) return "";
    const std::unique_ptr<lr_asset, decltype(&lr_asset_release)> asset(loaded, lr_asset_release);
    try {
        return falls::how_it_falls(asset.get());
    } catch (const std::exception&) {
        return "";
    }
}

std::vector<uint8_t> to_bytes(const std::string& text) {
    return {text.begin(), text.end()};
}
} // namespace

std::vector<std::string> BakeJob::outputs() const {
    std::vector<std::string> paths{output};
    if (!report.empty()) paths.push_back(report);
    if (!preview.empty()) paths.push_back(preview);
    const std::string folder = plots.empty() || plots.back() == '/' ? plots : plots + "/";
    for (std::size_t i = 0; i < plot_count(*this); ++i) paths.push_back(folder + plot_prefix + plot_names[i]);
    return paths;
}

BakeOutcome make_outputs(const BakeJob& job, const BakeProgress& progress, const BakeHooks& given) {
    const auto start = std::chrono::steady_clock::now();
    BakeOutcome outcome;
    Mesh body;
    BakeHooks hooks = given;
    if (!job.plots.empty() || !job.preview.empty()) hooks.body = &body;
    StationErrors errors;
    hooks.station_errors = &errors;
    if (check_outputs(job, outcome.faults)) {
        if (job.if_changed && is_current(job)) {
            outcome.state = BakeOutcome::State::unchanged;
        } else if (bake(job.bake, outcome.asset, outcome.faults, &outcome.timings, progress, hooks)) {
            outcome.state = BakeOutcome::State::baked;
            outcome.files.push_back(write_asset(outcome.asset));
            if (!job.report.empty())
                outcome.files.push_back(to_bytes(report_json(outcome.asset, outcome.faults, outcome.timings, errors)));
            if (job.drop || !job.preview.empty()) outcome.fall = fall_of(outcome.files[0]);
            if (!job.preview.empty()) outcome.files.push_back(draw_preview(outcome.asset, body, outcome.fall));
            if (!job.plots.empty())
                for (const std::string& plot : make_plots(outcome.asset, body)) outcome.files.push_back(to_bytes(plot));
        }
    }
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return outcome;
}

void write_outputs(const BakeJob& job, BakeOutcome& outcome) {
    if (outcome.state != BakeOutcome::State::baked) return;
    const std::vector<std::string> paths = job.outputs();
    std::vector<OutputFile> files;
    for (std::size_t i = 0; i < paths.size(); ++i) files.push_back({paths[i], outcome.files[i]});
    bool made = false;
    if ((job.plots.empty() || make_folder(job.plots, outcome.faults, &made)) && write_files(files, outcome.faults))
        return;
    outcome.state = BakeOutcome::State::failed;
    std::error_code ignored;
    if (made)
        std::filesystem::remove(std::filesystem::path(std::u8string(job.plots.begin(), job.plots.end())), ignored);
}
} // namespace lr::baker
