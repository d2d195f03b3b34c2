// Text that comes from outside or goes to a terminal.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace lr::baker {

// Every byte that does not belong to a UTF-8 character becomes U+FFFD.
std::string valid_utf8(std::string_view text);

// Valid UTF-8 without control characters: a file name must not be able to drive the terminal.
std::string printable(std::string_view text);

inline std::filesystem::path to_path(std::string_view utf8) {
    return std::u8string(utf8.begin(), utf8.end());
}

} // namespace lr::baker
