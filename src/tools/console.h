// SPDX-License-Identifier: MIT
// Differences between operating systems in command line and terminal.
#pragma once

#include <string>
#include <vector>

namespace lr::baker {

// In UTF-8. On Windows, where shells do not expand patterns such as leaves/*.fbx, expands them to the matching files.
std::vector<std::string> utf8_arguments(int argc, char** argv);

// Makes the terminal show UTF-8, and lets a write beyond a file size limit fail instead of ending the program.
void set_up_console();

// Whether standard error is a terminal that can erase a line.
bool shows_progress();

// Replaces backslashes by slashes, which all systems accept.
std::string with_slashes(std::string path);
} // namespace lr::baker
