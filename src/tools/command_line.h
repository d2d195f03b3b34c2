// Numbers and fluids of a command line, for lr_bake and lr_drop.
#pragma once

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <string_view>
#include <system_error>

namespace lr::baker {

inline constexpr int usage_error = 2;

// The whole text must be a number, in any locale: accepts "1e3"; refuses "1e3x", " 1", "1,5". Accepts infinity and NaN;
// the range checks refuse them with a numbered fault.
template <class Number> Number parse_number(std::string_view text, const char* option, const char* kind = "a number") {
    Number value{};
    const std::from_chars_result end = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end.ec == std::errc::result_out_of_range)
        throw CLI::ValidationError(option, "'" + std::string(text) + "' is too large or too small");
    if (end.ec != std::errc{} || end.ptr != text.data() + text.size())
        throw CLI::ValidationError(option, "'" + std::string(text) + "' is not " + kind);
    return value;
}

template <class Number, std::size_t N> std::array<Number, N> parse_list(std::string_view text, const char* option) {
    std::array<Number, N> values{};
    std::string_view rest = text;
    for (std::size_t i = 0; i < N; ++i) {
        const std::size_t comma = rest.find(',');
        if ((comma == std::string_view::npos) != (i + 1 == N))
            throw CLI::ValidationError(option, "'" + std::string(text) + "' is not " + std::to_string(N) +
                                                   " numbers with commas between them");
        values[i] = parse_number<Number>(rest.substr(0, comma), option);
        if (i + 1 < N) rest.remove_prefix(comma + 1);
    }
    return values;
}

// A picture under the name of another format would not open everywhere. Names without an ending are taken.
inline void check_png_name(const std::string& name, const char* option) {
    const std::size_t dot = name.find_last_of("./\\");
    if (dot == std::string::npos || name[dot] != '.') return;
    std::string ending = name.substr(dot);
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c < 'a' ? static_cast<char>(c | 0x20) : c; });
    if (ending != ".png")
        throw CLI::ValidationError(option, "the picture is a PNG; its name '" + name + "' must end in .png");
}

// Density in kg/m^3 and kinematic viscosity in m^2/s.
inline std::array<double, 2> parse_fluid(std::string_view text) {
    if (text == "air") return {1.2, 1.5e-5};
    if (text == "water") return {998.0, 1.0e-6};
    return parse_list<double, 2>(text, "--fluid");
}
} // namespace lr::baker
