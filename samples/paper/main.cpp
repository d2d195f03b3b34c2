// SPDX-License-Identifier: MIT
#include <cstdio>
#include <exception>
#include <filesystem>

#include "failure.h"
#include "figure_numbers.h"
#include "figures.h"
#include "options.h"
#include "output_file.h"

namespace {

void run(const Options& options) {
    std::error_code error;
    std::filesystem::create_directories(options.output_dir, error);
    OutputFile json(options.output_dir + "/numbers.json"), markdown(options.output_dir + "/numbers.md");
    Numbers numbers;
    if (options.wants("2")) figure_2(options, numbers);
    if (options.wants("3a")) figure_3(options, "3a", numbers);
    if (options.wants("3b")) figure_3(options, "3b", numbers);
    if (options.wants("4")) figure_4(options, numbers);
    if (options.wants("5")) figure_5(options, numbers);
    if (options.wants("table2")) table_2(options, numbers);
    const std::string text = numbers.markdown();
    json.write(numbers.json(options.seed, options.falls));
    json.commit();
    markdown.write(text);
    markdown.commit();
    if (std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0) {
        throw Failure("cannot write the numbers to stdout", "");
    }
}

} // namespace

int main(int argc, char** argv) {
    try {
        int exit_code = 0;
        const auto options = parse_options(argc, argv, exit_code);
        if (!options) return exit_code;
        run(*options);
        return 0;
    } catch (const Failure& failure) {
        tell("paper_figures", failure);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "paper_figures: %s\n", error.what());
    }
    return 2;
}
