// A snapshot's bytes as pieces: headers and columns, without a world. For tests that change one of them.
#pragma once

#include "contact/collider_snapshot.h"
#include "field/surface.h"
#include "field/wind_snapshot.h"
#include "world/batch_pairs.h"

#include "world/snapshot_format.h"
#include "world/snapshot_parts.h"

#include <cstdint>
#include <cstring>

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

enum HeadPiece : uint32_t { head_header, head_wind, head_surface, head_colliders, head_pairs, head_pieces };
inline constexpr uint32_t all_columns = column_parts + part_columns;
inline constexpr uint32_t column_bits = 16;
static_assert(all_columns < 1u << column_bits && head_pieces < 1u << column_bits);

inline bool SnapshotLayout::begin(const unsigned char* bytes, uint64_t size) {
    if (size < sizeof header_) return false;
    std::memcpy(&header_, bytes, sizeof header_);
    bytes_ = bytes;
    return header_.magic == snapshot_magic && header_.version == snapshot_version && header_.size <= size &&
           header_.size >= sizeof header_ && header_.size % 8 == 0;
}

inline bool SnapshotLayout::take(SnapshotPiece& piece, uint64_t key, uint64_t words) {
    if (words > this->words() - at_) {
        wrong_ = true;
        return false;
    }
    piece = {key, at_, words};
    at_ += words;
    return true;
}

inline uint64_t SnapshotLayout::words_of_head(uint32_t piece) const {
    const unsigned char* const from = bytes_ + 4 * at_;
    const uint64_t left = header_.size - 4 * at_;
    switch (piece) {
    case head_header:
        return sizeof(SnapshotHeader) / 4;
    case head_wind:
        return WindSnapshot::bytes(from, left) / 4;
    case head_surface:
        return sizeof(Surface::Record) / 4;
    case head_colliders:
        return ColliderSnapshot::bytes(from, left) / 4;
    default:
        return sizeof(BatchPairs::Pair) / 4 * uint64_t{header_.pair_count};
    }
}

inline bool SnapshotLayout::next(SnapshotPiece& piece) {
    while (!wrong_ && head_ < head_pieces) {
        const uint32_t head = head_++;
        const uint64_t words = words_of_head(head);
        if (words != 0) return take(piece, head, words);
        wrong_ = head != head_pairs;
    }
    while (!wrong_ && index_ < header_.batch_slots) {
        const uint64_t key = (uint64_t{index_} + 1) << column_bits | column_;
        if (column_ == 0) {
            if (!take(piece, key, sizeof batch_ / 4)) return false;
            std::memcpy(&batch_, bytes_ + 4 * piece.begin, sizeof batch_);
            wrong_ = batch_.fields > field_count || (batch_.parts & ~all_parts) != 0;
            if (wrong_) return false;
            if (batch_.capacity == 0)
                ++index_;
            else
                column_ = 1;
            return true;
        }
        const uint32_t column = column_ - 1;
        const uint64_t words = column < column_parts
                                   ? column_words(batch_, column)
                                   : part_column_words(batch_.parts, batch_.count, column - column_parts);
        if (column + 1 == all_columns)
            ++index_, column_ = 0;
        else
            ++column_;
        if (words != 0) return take(piece, key, words);
    }
    return false;
}

} // namespace lr
