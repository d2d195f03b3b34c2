#include "baker/asset_report.h"

#include "asset/asset_file.h"
#include "baker/printable_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace lr::baker {
namespace {

using Json = nlohmann::ordered_json;

Json make_json(const ProvenanceData& p) {
    return {{"tool", valid_utf8(p.tool)},
            {"tool_version", valid_utf8(p.tool_version)},
            {"source", valid_utf8(p.source)},
            {"input_hash", hash_text(p.input_hash)},
            {"options", valid_utf8(p.options)},
            {"faces", p.faces},
            {"vertices", p.vertices}};
}

std::array<double, 3> times(std::array<double, 3> v, double factor) {
    for (double& x : v) x *= factor;
    return v;
}

Json make_json(const AerodynamicData& a) {
    Json j{{"axes", a.axes}};
#define LR_ENTRY(name, ...) j[#name] = a.name;
    LR_AERODYNAMIC_VECTORS(LR_ENTRY)
    LR_AERODYNAMIC_NUMBERS(LR_ENTRY)
#undef LR_ENTRY
    return j;
}

Json make_json(const StationData& s) {
    Json j{{"axes", s.axes}};
#define LR_ENTRY(name, ...) j[#name] = s.name;
    LR_STATION_VECTORS(LR_ENTRY)
    LR_STATION_NUMBERS(LR_ENTRY)
#undef LR_ENTRY
    return j;
}

Json make_json(const AssetData& a) {
    const auto times_fluid = [&](std::array<double, 36> m) {
        for (double& v : m) v *= a.fluid_density;
        return m;
    };
    const double rate = a.u0 / a.length_l, dissipation = a.u0 * a.u0 * a.u0 / a.length_l;
    std::vector<double> chi = a.turbulence.chi, epsilon = a.turbulence.epsilon;
    for (double& v : chi) v *= rate;
    for (double& v : epsilon) v *= dissipation;
    const Json loop = a.turbulence.loop_end > a.turbulence.loop_begin
                          ? Json{{"begin", a.turbulence.loop_begin},
                                 {"end", a.turbulence.loop_end},
                                 {"period", (a.turbulence.loop_end - a.turbulence.loop_begin) * a.turbulence.dt / rate}}
                          : Json();
    Json j;
    j["name"] = valid_utf8(a.name);
    j["format_version"] = asset_format_version;
    j["mass"] = a.mass;
    j["volume"] = a.volume;
    j["density"] = a.density;
    j["center_of_mass"] = a.center_of_mass;
    j["inertia"] = a.inertia;
    j["added_mass"] = times_fluid(a.added_mass);
    j["added_mass_error"] = times_fluid(a.added_mass_error);
    j["diagonal"] = is_diagonal(a);
    j["symmetric"] = is_symmetric(a, a.aerodynamics);
    j["center_of_buoyancy"] = a.center_of_buoyancy;
    j["fluid"] = {{"density", a.fluid_density}, {"viscosity", a.fluid_viscosity}};
    j["lengths"] = {{"d", a.length_d}, {"b", a.length_b}, {"l", a.length_l}};
    j["projected_area"] = a.projected_area;
    j["u0"] = a.u0;
    j["reynolds"] = a.reynolds();
    j["c0"] = a.turbulence.c0;
    j["turbulence"] = {{"dt", a.turbulence.dt / rate},
                       {"chi", chi},
                       {"epsilon", epsilon},
                       {"stationary", a.turbulence.stationary},
                       {"intensity", a.turbulence.intensity},
                       {"cells", a.turbulence.cells},
                       {"domain", times(a.turbulence.domain, a.length_d)},
                       {"wake", a.turbulence.wake},
                       {"settled", a.turbulence.settled},
                       {"loop", loop},
                       {"max_divergence", a.turbulence.max_divergence}};
    j["aerodynamics"] = make_json(a.aerodynamics);
    j["stations"] = Json::array();
    for (const StationData& s : a.stations) j["stations"].push_back(make_json(s));
    j["hull"] = {{"vertices", a.hull.vertices.size() / 3}, {"triangles", a.hull.triangles.size() / 3}};
    j["provenance"] = make_json(a.provenance);
    return j;
}

#if defined(__MINGW32__) // there, "printf" means Microsoft's format; libstdc++ uses the C standard's
#define LR_PRINTF gnu_printf
#else
#define LR_PRINTF printf
#endif

__attribute__((format(LR_PRINTF, 2, 3))) void line(std::string& text, const char* format, ...) {
    char buffer[512];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(buffer, sizeof buffer, format, arguments);
    va_end(arguments);
    text += buffer;
    text += '\n';
}
} // namespace

std::string hash_text(uint64_t value) {
    char buffer[17];
    std::snprintf(buffer, sizeof buffer, "%016llx", static_cast<unsigned long long>(value));
    return buffer;
}

std::string report_json(const AssetData& asset) {
    return make_json(asset).dump(2) + "\n";
}

std::string report_json(const AssetData& asset, const Faults& faults, const BakeTimings& timings,
                        const StationErrors& errors) {
    Json j = make_json(asset);
    j["station_errors"] = {{"with_stations", errors.with_stations}, {"without", errors.without}};
    j["faults"] = Json::array();
    for (const Fault& f : faults)
        j["faults"].push_back({{"number", static_cast<uint32_t>(f.id)},
                               {"severity", f.severity == Severity::error ? "error" : "warning"},
                               {"where", valid_utf8(f.where)},
                               {"what", valid_utf8(f.what)},
                               {"remedy", valid_utf8(f.remedy)}});
    j["timings"] = Json::object();
    for (const auto& [phase, seconds] : timings) j["timings"][phase] = seconds;
    return j.dump(2) + "\n";
}

bool is_report_of(std::string_view json, const ProvenanceData& provenance) {
    const Json j = Json::parse(json, nullptr, false);
    return j.is_object() && j.contains("provenance") && j["provenance"] == make_json(provenance);
}

std::string summary(const AssetData& a) {
    std::string text = printable(a.name) + "\n";
    const double rho = a.fluid_density;
    const auto added = [&](std::size_t i) { return rho * a.added_mass[i * 7]; };
    line(text, "  mass            %.5g kg, volume %.5g m^3, density %.5g kg/m^3", a.mass, a.volume, a.density);
    line(text, "  fluid           %.5g kg/m^3, viscosity %.3g m^2/s", rho, a.fluid_viscosity);
    line(text, "  lengths         d %.4g m, b %.4g m, l %.4g m", a.length_d, a.length_b, a.length_l);
    line(text, "  speed U0        %.4g m/s, Reynolds number %.4g", a.u0, a.reynolds());
    line(text, "  inertia         %.5g %.5g %.5g kg m^2", a.inertia[0], a.inertia[4], a.inertia[8]);
    line(text, "  added mass      %.5g %.5g %.5g kg", added(0), added(1), added(2));
    line(text, "  added inertia   %.5g %.5g %.5g kg m^2", added(3), added(4), added(5));
    line(text, "  coupling        at most %.2g of the entries it couples", largest_coupling(a));
    line(text, "  symmetry        %s",
         is_diagonal(a)                    ? "in three planes: the fastest path"
         : is_symmetric(a, a.aerodynamics) ? "across its widest face: the fastest path for AERODYNAMIC loads"
         : a.stations.empty()              ? "none: the general path"
                                           : "not used: it has stations");
    line(text, "  buoyancy        at %.4g %.4g %.4g m from the centre of mass", a.center_of_buoyancy[0],
         a.center_of_buoyancy[1], a.center_of_buoyancy[2]);
    if (a.turbulence.stationary < a.turbulence.chi.size())
        line(text, "  turbulence      %zu samples, chi %.4g /s at the start, C0 %.3g", a.turbulence.chi.size(),
             a.turbulence.chi[0] * a.u0 / a.length_l, a.turbulence.c0);
    if (a.turbulence.wake)
        line(text, "  wake            %s; chi %.4g /s, epsilon %.4g m^2/s^3 at U0",
             !a.turbulence.settled                             ? "not settled"
             : a.turbulence.loop_end > a.turbulence.loop_begin ? "sheds vortices"
                                                               : "steady",
             a.turbulence.chi[a.turbulence.stationary] * a.u0 / a.length_l,
             a.turbulence.epsilon[a.turbulence.stationary] * a.u0 * a.u0 * a.u0 / a.length_l);
    line(text, "  drag            C_D S %.4g %.4g %.4g m^2 along its axes, lift %.4g %.4g %.4g m^2",
         a.aerodynamics.drag[0], a.aerodynamics.drag[1], a.aerodynamics.drag[2], a.aerodynamics.lift[0],
         a.aerodynamics.lift[1], a.aerodynamics.lift[2]);
    if (!a.stations.empty()) line(text, "  stations        %zu", a.stations.size());
    line(text, "  hull            %zu vertices, %zu triangles", a.hull.vertices.size() / 3,
         a.hull.triangles.size() / 3);
    return text;
}

std::string summary(const BakeTimings& timings) {
    std::string text = "  time           ";
    double total = 0.0;
    for (const auto& [phase, seconds] : timings) {
        char buffer[64];
        std::snprintf(buffer, sizeof buffer, " %s %.2f s,", phase.c_str(), seconds);
        text += buffer;
        total += seconds;
    }
    line(text, " total %.2f s", total);
    return text;
}
} // namespace lr::baker
