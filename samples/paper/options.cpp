// SPDX-License-Identifier: MIT
#include "options.h"

#include <CLI/CLI.hpp>

#include <algorithm>

bool Options::wants(const std::string& figure) const {
    return figures.empty() || std::find(figures.begin(), figures.end(), figure) != figures.end();
}

std::optional<Options> parse_options(int argc, char** argv, int& exit_code) {
    Options options;
    CLI::App app{"Reproduces the figures of the paper: pictures and numbers.", "paper_figures"};
    app.option_defaults()->always_capture_default();
    app.footer("Exit code: 0 success, 1 bad usage, 2 run-time failure, with a message that says what to do.");
    app.add_option("--baked", options.baked, "folder written by samples/paper/bake.sh")
        ->required()
        ->default_str("")
        ->check(CLI::ExistingDirectory);
    app.add_option("--meshes", options.meshes, "folder assets of the project, with the meshes to draw")
        ->required()
        ->default_str("")
        ->check(CLI::ExistingDirectory);
    app.add_option("--output-dir", options.output_dir, "folder for figure_*.png, numbers.json and numbers.md");
    app.add_option("--figure", options.figures, "figure to make; can be repeated; default: all")
        ->type_name("2|3a|3b|4|5|table2")
        ->default_str("")
        ->check(CLI::IsMember({"2", "3a", "3b", "4", "5", "table2"}));
    app.add_option("--seed", options.seed, "seed of releases and turbulence");
    app.add_option("--falls", options.falls, "number of falls that the numbers average")->check(CLI::Range(1, 100000));
    app.add_option("--cost-seconds", options.cost_seconds, "seconds of measurement for each number of Table 2")
        ->check(CLI::Range(0.001, 100.0));
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        exit_code = app.exit(error) == 0 ? 0 : 1;
        return std::nullopt;
    }
    return options;
}
