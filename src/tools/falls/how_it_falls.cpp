#include "tools/falls/how_it_falls.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lr::falls {
namespace {

constexpr uint32_t at_once = 128; // bodies in a world: bounds the memory of their tracks

std::string two_digits(double x) {
    const double power = std::pow(10.0, std::floor(std::log10(x)) - 1.0);
    char text[32];
    std::snprintf(text, sizeof text, "%.0f", std::round(x / power) * power);
    return text;
}

// "tumbles", or "flutters or tumbles" if no motion has half of the bodies.
std::string manner(const Falls& falls) {
    std::array<const char*, motion_names.size()> words{"keeps its attitude",       "flutters", "tumbles",
                                                       "turns about the vertical", "glides",   "moves chaotically"};
    const auto share = [&](Motion m) { return falls.shares[static_cast<size_t>(m)]; };
    // Swings of a body that flies flatter than 45 degrees between them.
    if (falls.horizontal_speed.p50 > std::abs(falls.descent.p50)) words[1] = "glides to and fro";
    if (falls.spirals > 0.5 * share(Motion::gliding)) words[4] = "glides in spirals";
    std::array<size_t, motion_names.size()> order{0, 1, 2, 3, 4, 5};
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return falls.shares[a] > falls.shares[b]; });
    const std::string first = words[order[0]];
    if (falls.shares[order[0]] < 0.5) return first + " or " + words[order[1]];
    if (order[0] != static_cast<size_t>(Motion::spinning)) return first;
    return first + ", " + two_digits(60.0 * falls.turning.mean) + " turns a minute";
}

// In m/s with two digits, without an exponent.
std::string speed_text(double speed) {
    if (speed < 1e-9) return "0 m/s";
    const auto last_digit = [](double x) { return std::floor(std::log10(x) + 1e-9) - 1.0; };
    const double power = std::pow(10.0, last_digit(speed)), value = std::round(speed / power) * power;
    char text[32];
    std::snprintf(text, sizeof text, "%.*f m/s", std::max(0, static_cast<int>(-last_digit(value))), value);
    return text;
}
} // namespace

Falls drop_and_measure(const lr_asset* asset, const Drop& options, std::vector<Fall>& falls, uint32_t keep,
                       std::vector<Track>* kept) {
    const Shape shape = shape_of(asset, options);
    falls.clear();
    for (uint32_t first = 0; first < options.count; first += at_once) {
        std::vector<Track> tracks = drop(asset, options, first, std::min(at_once, options.count - first));
        for (Track& t : tracks) {
            falls.push_back(measure(t, shape, options.wind));
            if (kept && kept->size() < keep) kept->push_back(std::move(t));
        }
    }
    Falls all = summarise(falls);
    // A fall in turbulence ends in a downdraught more often than not, so its last quarter is always faster.
    all.settled = all.settled || options.turbulence > 0.0;
    return all;
}

std::string sentence(const Falls& falls, const Shape& shape) {
    const double speed = std::abs(falls.descent.p50);
    if (speed < 0.02 * shape.length) return "floats";
    const bool liquid = shape.fluid_density > 100.0;
    const std::string verb = falls.descent.p50 < 0.0 ? "rises" : liquid ? "sinks" : "falls";
    if (!falls.settled)
        return verb + " at " + speed_text(std::abs(falls.last_quarter.p50)) + " (not settled yet), " + manner(falls);
    return verb + " at about " + speed_text(speed) + ", " + manner(falls);
}

std::string how_it_falls(const lr_asset* asset) {
    Drop options;
    options.count = 64;
    const Shape shape = shape_of(asset, options);
    options.step = default_step(shape);
    options.longest = 3000.0 * options.step;
    Falls falls;
    std::vector<Fall> each;
    // Motions take body lengths to develop; speed takes heights of (terminal speed)^2 / g, about thickness times excess density.
    const double excess = std::abs(shape.density / shape.fluid_density - 1.0);
    options.height = std::max(100.0 * shape.length, 5.0 * excess * shape.thickness);
    falls = drop_and_measure(asset, options, each);
    if (!falls.settled && falls.arrived == falls.count) {
        options.height *= 4.0;
        falls = drop_and_measure(asset, options, each);
    }
    return sentence(falls, shape);
}
} // namespace lr::falls
