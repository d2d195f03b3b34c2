// Makes text from files and file names safe for assets and terminals.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace lr::baker {

// Replaces every byte outside a valid UTF-8 character by U+FFFD.
std::string valid_utf8(std::string_view text);

// Valid UTF-8 without control characters, so that a file name cannot send commands to the terminal.
std::string printable(std::string_view text);

inline std::filesystem::path to_path(std::string_view utf8) {
    return std::u8string(utf8.begin(), utf8.end());
}
} // namespace lr::baker
