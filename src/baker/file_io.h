// Reads and writes whole files. An output appears complete or not at all.
#pragma once

#include "asset/input_faults.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace lr::baker {

// Reads a regular file. Faults 101, 102, 104.
bool read_file(const std::string& path_utf8, std::size_t max_bytes, std::vector<uint8_t>& out, Faults& faults);

// Whether a file can probably be written there; call before a long bake. Fault 103.
bool check_output(const std::string& path_utf8, Faults& faults);

// Whether both paths name one regular file, or are equal if the file does not exist.
bool is_same_file(const std::string& path_utf8, const std::string& other_utf8);

// Creates the last folder of the path if it does not exist. made: whether it was created. Fault 103.
bool make_folder(const std::string& path_utf8, Faults& faults, bool* made = nullptr);

struct OutputFile {
    std::string path_utf8;
    std::span<const uint8_t> bytes;
};

// Removes temporary files of killed bakes in the output's folder, or in this folder if the path ends with a slash. Files that another process still
// writes stay.
void clear_abandoned(const std::string& path_utf8);

// Writes all files or none: each to a temporary file in its target's folder, flushed to disk, then renamed to the target. Signals are blocked
// meanwhile. Devices and pipes are written directly. Fault 103.
bool write_files(const std::vector<OutputFile>& files, Faults& faults);
} // namespace lr::baker
