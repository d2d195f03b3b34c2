// SPDX-License-Identifier: MIT
// What of the command line and the terminal differs between systems.
#pragma once

#include <string>
#include <vector>

namespace lr::baker {

// As UTF-8; patterns such as leaves/*.fbx become the files that they match where no shell has seen to that.
std::vector<std::string> utf8_arguments(int argc, char** argv);

// Makes printed UTF-8 appear as such, and a write beyond a limit an error of that write.
void set_up_console();

// Standard error is looked at by someone, and understands the sequences that erase a line.
bool shows_progress();

// One spelling of folders' ends: slashes, which every system takes.
std::string with_slashes(std::string path);

} // namespace lr::baker
