// SPDX-License-Identifier: MIT
// Faults of files, with the same text on every system.
#pragma once

#include "asset/input_faults.h"

#include <cerrno>
#include <string>
#include <string_view>
#include <system_error>

namespace lr::baker {

// Repositories with Git LFS hold these in place of large files.
inline bool is_placeholder(std::string_view file) {
    return file.starts_with("version https://git-lfs");
}

// reason: errno.
inline bool cannot_write(Faults& faults, const std::string& path, int reason) {
    const char* remedy = "Check that the folder exists and that you have the right to write to it.";
    if (reason == ENOSPC || reason == EFBIG) remedy = "Free some space there, or write elsewhere.";
#if defined(EDQUOT)
    if (reason == EDQUOT) remedy = "Free some space there, or write elsewhere.";
#endif
    if (reason == EISDIR) remedy = "Give a file name in that folder.";
    return fail(faults, FaultId::file_write, path,
                "It cannot be written: " + std::generic_category().message(reason) + ".", remedy);
}

inline bool cannot_read(Faults& faults, const std::string& path, int reason, const char* remedy) {
    return fail(faults, FaultId::file_read, path, "It cannot be read: " + std::generic_category().message(reason) + ".",
                remedy);
}

inline bool no_such_file(Faults& faults, const std::string& path) {
    return fail(faults, FaultId::file_not_found, path, "The file does not exist.", "Check the path and its spelling.");
}

inline bool not_a_file(Faults& faults, const std::string& path) {
    return fail(faults, FaultId::file_read, path, "It is not a file.",
                "Give the path of a file, not of a folder or a device.");
}

inline bool too_large(Faults& faults, const std::string& path, std::size_t max_bytes) {
    return fail(faults, FaultId::file_too_large, path,
                "The file is larger than " + std::to_string(max_bytes) + " bytes.", "Reduce its size.");
}

inline bool not_a_folder(Faults& faults, const std::string& path) {
    return fail(faults, FaultId::file_write, path, "It is a file, not a folder.", "Give a folder name.");
}
} // namespace lr::baker
