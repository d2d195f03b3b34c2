#include "tools/lr_drop/report.h"

#include "baker/printable_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>

namespace lr::tools {
namespace {

using falls::Statistic;

std::string one_decimal(double x) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.1f", x);
    return buffer;
}

std::string range(const Statistic& s) {
    return "(5 to 95 %: " + number(s.p5) + " to " + number(s.p95) + ")";
}

nlohmann::ordered_json to_json(const Statistic& s) {
    return {{"mean", s.mean}, {"standard_error", s.standard_error}, {"p5", s.p5}, {"p50", s.p50}, {"p95", s.p95}};
}

// Degrees from the wind to the drift, positive to the wind's left as seen from above.
double angle_from_wind(const Eigen::Vector3d& drift, const Eigen::Vector3d& wind) {
    const double along = drift.x() * wind.x() + drift.z() * wind.z(),
                 left = drift.x() * wind.z() - drift.z() * wind.x();
    return std::atan2(left, along) * 180.0 / std::numbers::pi;
}

bool blows(const Eigen::Vector3d& wind) {
    return wind.x() != 0.0 || wind.z() != 0.0;
}

const char* release_name(falls::Release release) {
    return release == falls::Release::flat ? "flat" : release == falls::Release::edge ? "edge" : "random";
}

std::string drift_text(const falls::Falls& f, const Eigen::Vector3d& wind) {
    std::string text = number(f.drift.norm()) + " m";
    if (!blows(wind)) return text + ", without wind";
    const double angle = angle_from_wind(f.drift, wind);
    return text + ", " + one_decimal(std::abs(angle)) + " degrees to the " + (angle < 0.0 ? "right" : "left") +
           " of the wind";
}
} // namespace

std::string number(double x) {
    char buffer[48];
    const double size = std::abs(x);
    const int digits = size < 1e-4 ? 4 : std::max(0, 2 - static_cast<int>(std::floor(std::log10(size))));
    std::snprintf(buffer, sizeof buffer, "%.*f", digits, size < 5e-5 ? 0.0 : x);
    return size < 1e-4 && std::stod(buffer) == 0.0 ? "0" : buffer;
}

std::string title(const DropCommand& command, const Results& results) {
    const falls::Drop& d = command.drop;
    std::string out = std::to_string(results.falls.count) + (results.falls.count == 1 ? " fall of " : " falls of ") +
                      baker::printable(results.shape.name) + " from " + shortest(d.height) + " m, released " +
                      (d.release == falls::Release::edge   ? "on edge"
                       : d.release == falls::Release::flat ? "flat"
                                                           : "at random");
    if (d.wind != Eigen::Vector3d::Zero())
        out += ", wind " + shortest(d.wind.x()) + "," + shortest(d.wind.y()) + "," + shortest(d.wind.z()) + " m/s";
    if (d.turbulence > 0.0) out += ", turbulence " + shortest(d.turbulence) + " m/s";
    if (d.fluid_density > 0.0) out += ", in a fluid of " + shortest(d.fluid_density) + " kg/m^3";
    return out;
}

std::string text(const DropCommand& command, const Results& results) {
    const falls::Falls& f = results.falls;
    std::string out = title(command, results) + "\n";
    const auto line = [&](const char* name, const std::string& value) {
        char buffer[32];
        std::snprintf(buffer, sizeof buffer, "  %-16s", name);
        out += buffer + value + "\n";
    };
    line("summary", falls::sentence(f, results.shape));
    const bool rises = f.descent.mean < 0.0;
    line("terminal speed", number(std::abs(f.descent.mean)) + (rises ? " m/s upward " : " m/s downward ") +
                               (rises ? range({.p5 = -f.descent.p95, .p95 = -f.descent.p5}) : range(f.descent)));
    const auto half = [](const Statistic& quarter) { // the middle half of the bodies
        return number(std::abs(quarter.p25)) + " to " + number(std::abs(quarter.p75));
    };
    if (!f.settled && f.third_quarter.deviation == 0.0 && f.third_quarter.mean == 0.0)
        line("", "not settled: the fall lasts only a few steps. Give more --height");
    else if (!f.settled)
        line("", "not settled: half of the bodies at " + half(f.third_quarter) +
                     " m/s in the third quarter of the time, " + half(f.last_quarter) +
                     " in the last. Give more --height");
    std::string shares;
    std::array<std::size_t, falls::motion_names.size()> order{};
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return f.shares[a] > f.shares[b]; });
    for (const std::size_t i : order)
        if (f.shares[i] > 0.0)
            shares += std::string(", ") + falls::motion_names[i] + " " + one_decimal(100.0 * f.shares[i]) + " %";
    line("regime", falls::summary_word(f) + (": " + shares.substr(2)));
    line("spin", number(f.spin.mean) + " turns/s about the vertical, " + number(f.turnovers.mean) + " across");
    if (f.swings.count > 0) line("swings", number(f.swings.mean) + " /s to and fro, of those that flutter");
    line("horizontal", number(f.horizontal_speed.mean) + " m/s " + range(f.horizontal_speed) +
                           (blows(command.drop.wind) ? ", relative to the wind" : ""));
    line("drift", drift_text(f, command.drop.wind));
    line("landings",
         "half within " + number(f.half_radius) + " m of their mean, 95 % within " + number(f.most_radius) + " m");
    if (f.arrived > 0) line("time of fall", number(f.time.mean) + " s " + range(f.time));
    if (f.arrived < f.count) line("", std::to_string(f.count - f.arrived) + " did not arrive in the time allowed");
    return out;
}

std::string json(const DropCommand& command, const Results& results) {
    const falls::Falls& f = results.falls;
    const falls::Drop& d = command.drop;
    nlohmann::ordered_json j;
    j["asset"] = baker::valid_utf8(results.shape.name);
    j["release"] = release_name(d.release);
    j["height"] = d.height;
    j["count"] = f.count;
    j["wind"] = {d.wind.x(), d.wind.y(), d.wind.z()};
    j["turbulence"] = d.turbulence;
    j["fluid_density"] = results.shape.fluid_density;
    j["seed"] = d.seed;
    j["step"] = results.step;
    j["summary"] = falls::sentence(f, results.shape);
    j["terminal_speed"] = to_json(f.descent);
    j["settled"] = f.settled;
    j["speed_in_quarters"] = {{"third", f.third_quarter.mean}, {"last", f.last_quarter.mean}};
    j["regime"]["word"] = falls::summary_word(f);
    for (std::size_t i = 0; i < f.shares.size(); ++i) j["regime"]["shares"][falls::motion_names[i]] = f.shares[i];
    j["spin_vertical"] = to_json(f.spin);
    j["spin_across"] = to_json(f.turnovers);
    j["swings"] = f.swings.count > 0 ? to_json(f.swings) : nlohmann::ordered_json();
    j["horizontal_speed"] = to_json(f.horizontal_speed);
    j["drift"] = {{"x", f.drift.x()}, {"z", f.drift.z()}, {"distance", f.drift.norm()}};
    j["drift"]["degrees_left_of_wind"] =
        blows(d.wind) ? nlohmann::ordered_json(angle_from_wind(f.drift, d.wind)) : nlohmann::ordered_json();
    j["landing_radius"] = {{"half", f.half_radius}, {"95_percent", f.most_radius}};
    j["arrived"] = f.arrived;
    j["time_of_fall"] = f.arrived > 0 ? to_json(f.time) : nlohmann::ordered_json();
    return j.dump(2) + "\n";
}
} // namespace lr::tools
