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
    // Bake: one input into files, or any number into folders.
    std::vector<std::string> inputs;     // meshes or images, in addition to `list`
    std::string list;                    // file with more inputs, or empty
    std::string output, report, preview; // files or folders; all but the first can be empty
    std::string plots;                   // a folder, or empty
    bool folders = false;
    bool islands = false; // of a card: one asset each
    unsigned jobs = 0;    // bakes at once; 0: one per processor
    bool if_changed = false;
    bool quiet = false;
    std::string asset; // info, check
    bool json = false;
};

// Nothing after help or version (exit code 0) or wrong usage (2), which are already printed.
std::optional<CommandLine> parse_command_line(int argc, char** argv, int& exit_code);

// For wrong usage detected after parsing. Returns the exit code.
int wrong_usage(const std::string& what);
} // namespace lr::baker
