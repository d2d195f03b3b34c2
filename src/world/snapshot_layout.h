// A snapshot's bytes as pieces: headers and columns, without a world.
#pragma once

#include "world/snapshot_format.h"

#include <cstdint>

namespace lr {

struct SnapshotPiece {
    uint64_t key;          // what it is: ascending in a snapshot, and the same in others
    uint64_t begin, words; // 32-bit words
};

class SnapshotLayout {
public:
    // False when the bytes do not begin as a snapshot of this version does, or are fewer than it says.
    bool begin(const unsigned char* bytes, uint64_t size);
    // And when they are damaged.
    bool open(const unsigned char* bytes, uint64_t size) {
        return begin(bytes, size) && seal_of(bytes, header_.size) == header_.seal;
    }
    const SnapshotHeader& header() const { return header_; }
    const unsigned char* bytes() const { return bytes_; }
    uint64_t words() const { return header_.size / 4; }

    // The next that is not empty. Together they are all of the snapshot. False at its end, and where it makes no sense.
    bool next(SnapshotPiece& piece);
    bool sensible() const { return !wrong_ && at_ == words(); } // after the last

private:
    bool take(SnapshotPiece& piece, uint64_t key, uint64_t words);
    uint64_t words_of_head(uint32_t piece) const; // 0 where it makes no sense

    const unsigned char* bytes_ = nullptr;
    SnapshotHeader header_{};
    SnapshotBatch batch_{};
    uint64_t at_ = 0;     // words
    uint32_t head_ = 0;   // pieces before the batches
    uint32_t index_ = 0;  // of the batch
    uint32_t column_ = 0; // of it; 0: its header
    bool wrong_ = false;
};

} // namespace lr
