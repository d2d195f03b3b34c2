// Whole files in and out. What is written appears complete under its name or not at all.
#pragma once

#include "asset/input_faults.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace lr::baker {

// Regular files only. Faults 101, 102, 104.
bool read_file(const std::string& path_utf8, std::size_t max_bytes, std::vector<uint8_t>& out, Faults& faults);

// Can a file be written there, as far as one can tell without doing it? Asked before the work, not after. Fault 103.
bool check_output(const std::string& path_utf8, Faults& faults);

// One regular file, whatever the names, or one name for a file that does not exist yet.
bool is_same_file(const std::string& path_utf8, const std::string& other_utf8);

// Makes the last folder of the path unless it is there, and says whether it did. Fault 103.
bool make_folder(const std::string& path_utf8, Faults& faults, bool* made = nullptr);

struct OutputFile {
    std::string path_utf8;
    std::span<const uint8_t> bytes;
};

// What killed bakes may have left aside in the folder of this output, or in this folder (with a slash at its end): removed, but
// for what another process still writes.
void clear_abandoned(const std::string& path_utf8);

// All of them or none: each is written aside in the folder of its target, flushed to the disk, and then renamed over
// the target. Signals wait until that is done. Devices and pipes are written directly. Fault 103.
bool write_files(const std::vector<OutputFile>& files, Faults& faults);

} // namespace lr::baker
