// SPDX-License-Identifier: MIT
#include "options.h"

#include <CLI/CLI.hpp>

#include <algorithm>

bool Options::wants(const std::string& figure) const {
    return figures.empty() || std::find(figures.begin(), figures.end(), figure) != figures.end();
}

std::optional<Options> parse_options(int argc, char** argv, int& exit_code) {
    Options options;
    CLI::App app{"The figures of the paper, made anew: pictures and numbers.", "paper_figures"};
    app.option_defaults()->always_capture_default();
    app.footer("Exit code: 0 done, 1 bad usage, 2 something failed while running (it says what, and what to do).");
    app.add_option("--baked", options.baked, "folder that samples/paper/bake.sh wrote")
        ->required()
        ->default_str("")
        ->check(CLI::ExistingDirectory);
    app.add_option("--meshes", options.meshes, "folder assets of the project: what is drawn")
        ->required()
        ->default_str("")
        ->check(CLI::ExistingDirectory);
    app.add_option("--output-dir", options.output_dir, "folder for figure_*.png, numbers.json and numbers.md");
    app.add_option("--figure", options.figures, "one of them; may be given again; without: all")
        ->type_name("2|3a|3b|4|5|table2")
        ->default_str("")
        ->check(CLI::IsMember({"2", "3a", "3b", "4", "5", "table2"}));
    app.add_option("--seed", options.seed, "of releases and turbulence");
    app.add_option("--falls", options.falls, "that the numbers are averages of")->check(CLI::Range(1, 100000));
    app.add_option("--cost-seconds", options.cost_seconds, "of measurement for each number of Table 2")
        ->check(CLI::Range(0.001, 100.0));
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        exit_code = app.exit(error) == 0 ? 0 : 1;
        return std::nullopt;
    }
    return options;
}
