// The command line of lr_drop.
#pragma once

#include "asset/input_faults.h"
#include "tools/falls/drop.h"

#include <optional>
#include <string>

namespace lr::tools {

struct DropCommand {
    std::string asset;
    falls::Drop drop;
    bool step_given = false, fluid_given = false;
    std::string png, json; // files, or empty
    bool quiet = false;
};

// Nothing after help or version (exit code 0) or wrong usage (2), which are already printed.
std::optional<DropCommand> parse_command_line(int argc, char** argv, int& exit_code);

// Faults 301 for numbers out of range.
Faults check(const DropCommand& command);
} // namespace lr::tools
