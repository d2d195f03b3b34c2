// The records of a recording, out of its bytes. Trusts nothing.
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
    // Bytes are not copied. Throws Fault: not a recording, or a newer one.
    Reader(const unsigned char* bytes, size_t size);

    uint32_t library() const { return library_; } // lr_version() of who wrote it
    // False at the end, be it that the last record is not whole. Throws Fault where one is damaged.
    bool next(Record& out);
    bool cut() const { return cut_; } // the end was in the middle of a record

    // A place to read from again.
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
