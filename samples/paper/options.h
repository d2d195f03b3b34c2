// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

struct Options {
    std::string baked, meshes, output_dir = ".";
    std::vector<std::string> figures; // empty: all
    std::uint64_t seed = 1;
    std::uint32_t falls = 200;
    double cost_seconds = 0.5;

    bool wants(const std::string& figure) const;
};

std::optional<Options> parse_options(int argc, char** argv, int& exit_code);
