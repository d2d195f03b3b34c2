// The command line of lr_bake.
#pragma once

#include "baker/bake.h"

#include <optional>
#include <string>
#include <vector>

namespace lr::baker {

struct CommandLine {
    enum class Command { bake, info, check };
    Command command = Command::bake;
    BakeOptions bake;
    // Of a bake: one input into files, or any number into folders.
    std::vector<std::string> inputs; // meshes, besides those of the list
    std::string list;                // file with more inputs, or empty
    std::string output, report;      // files or folders; report may be empty
    std::string plots;               // a folder, or empty
    bool folders = false;
    unsigned jobs = 0; // at once; 0: one for each processor
    bool if_changed = false;
    bool quiet = false;
    std::string asset; // of info and check
    bool json = false;
};

// Nothing when there is nothing to do: help, version (exit code 0) or wrong usage (2), already printed.
std::optional<CommandLine> parse_command_line(int argc, char** argv, int& exit_code);

// For wrong usage that only shows later. Returns the exit code.
int wrong_usage(const std::string& what);

} // namespace lr::baker
