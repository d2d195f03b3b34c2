// A snapshot's bytes as pieces (headers and columns), without a world, for tests that change a piece.
#pragma once

#include "body_contact/pair_cache.h"
#include "world/snapshot/snapshot_format.h"

#include <cstdint>
#include <cstring>

namespace lr {

struct SnapshotPiece {
    uint64_t key;          // identifies the piece in any snapshot; ascending
    uint64_t begin, words; // 32-bit words
};

class SnapshotLayout {
public:
    // False if the bytes do not begin like a snapshot of this version, or are fewer than stated.
    bool begin(const unsigned char* bytes, uint64_t size);
    const SnapshotHeader& header() const { return header_; }
    const unsigned char* bytes() const { return bytes_; }
    uint64_t words() const { return header_.size / 4; }

    // The next piece that is not empty; all pieces together are the snapshot. False at its end, and for invalid contents.
    bool next(SnapshotPiece& piece);

private:
    bool take(SnapshotPiece& piece, uint64_t key, uint64_t words);
    uint64_t words_of_head(uint32_t piece) const; // 0 for invalid contents

    const unsigned char* bytes_ = nullptr;
    SnapshotHeader header_{};
    SnapshotBatch batch_{};
    uint64_t at_ = 0;     // words
    uint32_t head_ = 0;   // pieces before the batches
    uint32_t index_ = 0;  // the present batch
    uint32_t column_ = 0; // of the batch; 0: its header
    bool wrong_ = false;
};

enum HeadPiece : uint32_t { head_header, head_wind, head_colliders, head_pairs, head_cached_pairs, head_pieces };
inline constexpr uint32_t column_bits = 16;
static_assert(batch_pieces < 1u << column_bits && head_pieces < 1u << column_bits);

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
    switch (piece) {
    case head_header:
        return sizeof(SnapshotHeader) / 4;
    case head_wind:
        return WindSnapshot::bytes(header_.wind_field) / 4;
    case head_colliders:
        return ColliderSnapshot::bytes(header_.colliders) / 4;
    case head_pairs:
        return padded_bytes(4 * uint64_t{header_.link_count}) / 4;
    default:
        return sizeof(CachedPair) / 4 * header_.cached_pair_count;
    }
}

inline bool SnapshotLayout::next(SnapshotPiece& piece) {
    while (!wrong_ && head_ < head_pieces) {
        const uint32_t head = head_++;
        const uint64_t words = words_of_head(head);
        if (words != 0) return take(piece, head, words);
        wrong_ = head == head_header;
    }
    while (!wrong_ && index_ < header_.batch_slots) {
        const uint64_t key = (uint64_t{index_} + 1) << column_bits | column_;
        if (column_ == 0) {
            if (!take(piece, key, sizeof batch_ / 4)) return false;
            std::memcpy(&batch_, bytes_ + 4 * piece.begin, sizeof batch_);
            if (batch_.capacity == 0)
                ++index_;
            else
                column_ = 1;
            return true;
        }
        const uint64_t bytes = padded_bytes(piece_bytes(batch_, column_ - 1));
        if (column_ == batch_pieces)
            ++index_, column_ = 0;
        else
            ++column_;
        if (bytes != 0) return take(piece, key, bytes / 4);
    }
    return false;
}

} // namespace lr
