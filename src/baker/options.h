// The command line of lr_bake.
#pragma once

#include "baker/bake.h"

#include <optional>
#include <string>

namespace lr::baker {

struct CommandLine {
    enum class Command { bake, info, check };
    Command command = Command::bake;
    BakeOptions bake;
    std::string output; // of a bake
    std::string report; // of a bake, or empty
    bool quiet = false;
    std::string asset; // of info and check
    bool json = false;
};

// Nothing when there is nothing to do: help, version (exit code 0) or wrong usage (2), already printed.
std::optional<CommandLine> parse_command_line(int argc, char** argv, int& exit_code);

} // namespace lr::baker
