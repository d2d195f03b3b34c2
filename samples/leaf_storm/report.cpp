// SPDX-License-Identifier: MIT
#include "report.h"

#include <cstdarg>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>

namespace {

__attribute__((format(printf, 1, 2))) std::string text(const char* format, ...) {
    char buffer[512];
    std::va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(buffer, sizeof buffer, format, arguments);
    va_end(arguments);
    return buffer;
}

std::string grouped(std::uint64_t number) {
    const std::string digits = std::to_string(number);
    std::string out;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) out += ',';
        out += digits[i];
    }
    return out;
}

std::string library_version() {
    const std::uint32_t v = lr_version();
    return text("%u.%u.%u", v >> 22, (v >> 12) & 0x3ffu, v & 0xfffu);
}

// Work in body-steps: one body through one substep.
double body_steps(const Options& options, const Measured& measured) {
    return static_cast<double>(measured.steps) * options.substeps * static_cast<double>(options.count);
}

} // namespace

std::string table_report(const Options& options, const Storm& storm, const Measured& measured) {
    const Summary& s = measured.summary;
    const lr_world_info info = storm.info();
    const double work = body_steps(options, measured), stepping = storm.stepping_seconds();
    std::string out;
    for (const Storm::Kind& kind : storm.kinds()) {
        out += text("asset                      %s (%s, %.3g g, %.3g cm): %s bodies\n", kind.path.c_str(),
                    kind.info.name, 1e3 * kind.info.mass, 1e2 * kind.info.length_d, grouped(kind.count).c_str());
    }
    out += text("bodies                     %s, in a box of %.1f x %.1f x %.1f m\n", grouped(options.count).c_str(),
                static_cast<double>(storm.box().size(0)), static_cast<double>(storm.box().size(1)),
                static_cast<double>(storm.box().size(2)));
    out += text("time                       %.3f s: %s steps of %.3f ms, %u substeps each\n", info.time,
                grouped(measured.steps).c_str(), 1e3 * options.dt, options.substeps);
    out += text("wind                       %.2f %.2f %.2f m/s\n", static_cast<double>(options.wind[0]),
                static_cast<double>(options.wind[1]), static_cast<double>(options.wind[2]));
    out += text("descent speed              mean %.3f, median %.3f, 5-95 %% %.3f to %.3f m/s\n", s.mean_descent,
                s.median_descent, s.descent_5, s.descent_95);
    out += text("horizontal speed in wind   mean %.3f m/s\n", s.horizontal);
    out +=
        text("spin                       mean %.2f rad/s, %.2f turns/s\n", s.spin, s.spin / (2.0 * std::numbers::pi));
    out += text("  (over %.1f to %.1f s, %llu samples per body, relative to the air)\n", s.from, s.to,
                static_cast<unsigned long long>(s.samples));
    if (options.ground)
        out += text("left the ground            %s over its edges, %s through it\n",
                    grouped(storm.blown_away()).c_str(), grouped(storm.fell_through()).c_str());
    else
        out += text("bodies that re-entered     %s\n", grouped(storm.reentries()).c_str());
    if (!measured.lying.empty())
        out += "on the ground         at s   bodies  at rest   moving  2 mm in it (trodden)  deepest mm  2 mm over it  "
               "on edge  "
               "tilt\n";
    for (const Lying& at : measured.lying) {
        out += text("%26.2f %8s %8s %8s %11s %9s %11.2f %13s %8s %5.1f\n", at.time, grouped(at.bodies).c_str(),
                    grouped(at.at_rest).c_str(), grouped(at.near_awake).c_str(), grouped(at.below).c_str(),
                    text("(%s)", grouped(at.trodden).c_str()).c_str(), 1e3 * at.deepest, grouped(at.hovering).c_str(),
                    grouped(at.on_edge).c_str(), at.median_tilt);
    }
    out += text("wall time in stepping      %.3f s of %.3f s in all\n", stepping, measured.wall);
    out += text("body-steps                 %.3g, %.2f million/s, %.2f ns each (one body, one substep)\n", work,
                1e-6 * work / stepping, 1e9 * stepping / work);
    out += text("processor                  %s, %u thread%s\n", lr_simd_target_name(info.simd_target),
                info.worker_count + 1, info.worker_count == 0 ? "" : "s");
    out += text("memory                     %.1f MB\n", 1e-6 * static_cast<double>(info.memory_bytes));
    out += text("state hash                 %016llx (langevin_rigid %s)\n",
                static_cast<unsigned long long>(storm.hash()), library_version().c_str());
    return out;
}

std::string json_report(const Options& options, const Storm& storm, const Measured& measured) {
    const Summary& s = measured.summary;
    const lr_world_info info = storm.info();
    const double work = body_steps(options, measured), stepping = storm.stepping_seconds();
    nlohmann::ordered_json assets = nlohmann::ordered_json::array();
    for (const Storm::Kind& kind : storm.kinds()) {
        assets.push_back({{"path", kind.path},
                          {"name", kind.info.name},
                          {"count", kind.count},
                          {"content_hash", text("%016llx", static_cast<unsigned long long>(kind.info.content_hash))}});
    }
    nlohmann::ordered_json report = {
        {"library_version", library_version()},
        {"assets", assets},
        {"bodies", options.count},
        {"steps", measured.steps},
        {"substeps", options.substeps},
        {"dt_s", options.dt},
        {"time_s", info.time},
        {"seed", options.seed},
        {"wind_m_s", {options.wind[0], options.wind[1], options.wind[2]}},
        {"stepping_wall_s", stepping},
        {"wall_s", measured.wall},
        {"body_steps", work},
        {"body_steps_per_s", work / stepping},
        {"ns_per_body_step", 1e9 * stepping / work},
        {"averaged_from_s", s.from},
        {"averaged_to_s", s.to},
        {"descent_m_s",
         {{"mean", s.mean_descent}, {"median", s.median_descent}, {"p5", s.descent_5}, {"p95", s.descent_95}}},
        {"horizontal_m_s", s.horizontal},
        {"spin_rad_s", s.spin},
        {"spin_turns_s", s.spin / (2.0 * std::numbers::pi)},
        {"mean_abs_cos_tilt", s.tilt},
        {"reentries", storm.reentries()},
        {"memory_bytes", info.memory_bytes},
        {"simd", lr_simd_target_name(info.simd_target)},
        {"threads", info.worker_count + 1},
        {"state_hash", text("%016llx", static_cast<unsigned long long>(storm.hash()))},
    };
    if (options.ground) {
        nlohmann::ordered_json lying = nlohmann::ordered_json::array();
        for (const Lying& at : measured.lying) {
            lying.push_back({{"time_s", at.time},
                             {"bodies", at.bodies},
                             {"at_rest", at.at_rest},
                             {"move_on_the_ground", at.near_awake},
                             {"below_2_mm", at.below},
                             {"trodden_below_2_mm", at.trodden},
                             {"above_2_mm", at.hovering},
                             {"deepest_m", at.deepest},
                             {"highest_m", at.highest},
                             {"on_edge", at.on_edge},
                             {"median_tilt_degrees", at.median_tilt}});
        }
        report["ground"] = {
            {"blown_away", storm.blown_away()}, {"fell_through", storm.fell_through()}, {"checks", lying}};
    }
    return report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string csv_report(const Measured& measured) {
    std::string out = "time_s,bodies,descent_m_s,horizontal_m_s,spin_rad_s,mean_abs_cos_tilt,at_rest\n";
    for (const Sample& s : measured.samples) {
        out += text("%.6f,%llu,%.6f,%.6f,%.6f,%.6f,%llu\n", s.time, static_cast<unsigned long long>(s.bodies),
                    s.descent, s.horizontal, s.spin, s.tilt, static_cast<unsigned long long>(s.at_rest));
    }
    return out;
}
