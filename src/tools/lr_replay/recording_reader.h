// Reads the records of a recording. Safe for arbitrary bytes.
#pragma once

#include "recording/recording_format.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lr::replay {

struct Record {
    recording::Kind kind{};
    const unsigned char* data = nullptr; // valid until the next record is read
    size_t size = 0;
};

class Reader {
public:
    // Does not copy the bytes. Throws Fault if they are not a recording, or one of a newer format.
    Reader(const unsigned char* bytes, size_t size);

    uint32_t library() const { return library_; } // lr_version() of the recording library
    // False at the end, also if the last record is incomplete. Throws Fault for a damaged record.
    bool next(Record& out);
    bool cut() const { return cut_; } // the recording ended within a record

    // A position to return to.
    struct Place {
        size_t at = 0;
        uint64_t frame = 0;
    };
    Place place() const { return {at_, frame_}; } // of the next record
    void go(Place to) { at_ = to.at, frame_ = to.frame; }

private:
    const unsigned char* bytes_;
    size_t size_;
    size_t at_ = 0;
    uint64_t frame_ = 0;
    uint32_t library_ = 0;
    bool cut_ = false;
    std::vector<unsigned char> joined_;
};
} // namespace lr::replay
