#include "world/snapshot_delta.h"

#include "world/delta_block.h"
#include "world/snapshot_layout.h"

#include <algorithm>
#include <cstring>

namespace lr {
namespace {

constexpr uint64_t delta_magic = 0x31304453444c524cull; // "LRLDSD01"
constexpr uint32_t delta_version = 1;

struct DeltaHeader {
    uint64_t magic;
    uint32_t version;
    uint32_t snapshot_version;
    uint64_t size; // of everything, a multiple of 8
    uint64_t seal; // of everything but this field
    uint64_t base_size, base_seal;
    uint64_t result_size, result_seal;
};
static_assert(offsetof(DeltaHeader, seal) == seal_offset && sizeof(DeltaHeader) == 64);

// Words that follow each other in the new snapshot, and those in the base that they are compared with, which follow each other too:
// zeros behind its end. As bytes: how many; where in the base, from where the run before would go on, its sign in the lowest bit;
// blocks.
struct Run {
    uint64_t begin, words, base;
};
constexpr uint64_t shortest_run = 64;      // words: a shorter piece goes on with the run before it
constexpr uint64_t run_bytes = 2 * 10 + 1; // at most, its last and shorter block's own byte included
constexpr uint64_t read_over = 7;          // bytes that decoding a block may read behind it
constexpr uint64_t most_words_a_byte = uint64_t{most_equal_blocks} * block_words;

class Writer {
public:
    Writer(unsigned char* memory, uint64_t capacity) : memory_(memory), capacity_(capacity) {}
    void number(uint64_t value) {
        for (; value >= 128; value >>= 7) byte(static_cast<unsigned char>(value | 128));
        byte(static_cast<unsigned char>(value));
    }
    void byte(unsigned char value) {
        if (at_ < capacity_) memory_[at_] = value;
        ++at_;
    }
    void block(const uint32_t* now, const uint32_t* was, uint32_t count) {
        constexpr uint64_t room = most_block_bytes + 7;
        if (at_ + room <= capacity_) {
            at_ += encode_block(now, was, count, memory_ + at_);
            return;
        }
        unsigned char apart[room];
        const uint64_t bytes = encode_block(now, was, count, apart);
        if (at_ + bytes <= capacity_) std::memcpy(memory_ + at_, apart, static_cast<size_t>(bytes));
        at_ += bytes;
    }
    uint64_t at() const { return at_; } // more than the capacity where that is too small

private:
    unsigned char* memory_;
    uint64_t capacity_;
    uint64_t at_ = sizeof(DeltaHeader);
};

class Reader {
public:
    Reader(const unsigned char* bytes, uint64_t size) : bytes_(bytes), size_(size) {}
    bool number(uint64_t& value) {
        value = 0;
        for (uint32_t shift = 0; shift < 64; shift += 7) {
            if (at_ == size_) return false;
            const uint64_t next = bytes_[at_++];
            value |= (next & 127) << shift;
            if (next < 128) return true;
        }
        return false;
    }
    bool byte(uint32_t& value) {
        if (at_ == size_) return false;
        value = bytes_[at_++];
        return true;
    }
    bool block(uint32_t how, const uint32_t* was, uint32_t count, uint32_t* now) {
        const uint64_t bytes = coded_bytes(how, count);
        if (bytes == 0 || bytes > size_ - at_) return false;
        if (bytes + read_over <= size_ - at_) {
            decode_block(how, bytes_ + at_, was, count, now);
        } else {
            unsigned char apart[most_block_bytes + read_over] = {};
            std::memcpy(apart, bytes_ + at_, static_cast<size_t>(bytes));
            decode_block(how, apart, was, count, now);
        }
        at_ += bytes;
        return true;
    }
    bool at_end() const { return size_ - at_ < 8; } // up to the padding

private:
    const unsigned char* bytes_;
    uint64_t size_;
    uint64_t at_ = sizeof(DeltaHeader);
};

// Of `words`, from word `at` on, `count` of them; zeros behind the end.
void words_at(const unsigned char* bytes, uint64_t words, uint64_t at, uint32_t count, uint32_t (&out)[block_words]) {
    const uint64_t there = at < words ? std::min<uint64_t>(count, words - at) : 0;
    if (there != 0) std::memcpy(out, bytes + 4 * at, static_cast<size_t>(4 * there));
    std::fill(out + there, out + count, 0u);
}

uint64_t moved(uint64_t from, uint64_t to) {
    return to >= from ? (to - from) << 1 : (from - to) << 1 | 1;
}

void write_blocks(const SnapshotLayout& base, const SnapshotLayout& snapshot, const Run& run, Writer& writer) {
    uint32_t equal = 0;
    const auto end_equal = [&] {
        if (equal != 0) writer.byte(static_cast<unsigned char>(block_equal + equal - 1));
        equal = 0;
    };
    for (uint64_t i = 0; i < run.words; i += block_words) {
        const auto count = static_cast<uint32_t>(std::min<uint64_t>(block_words, run.words - i));
        const uint64_t at = run.base + i;
        const unsigned char* const now_bytes = snapshot.bytes() + 4 * (run.begin + i);
        uint32_t now[block_words], was[block_words];
        bool same;
        if (at + count <= base.words()) {
            same = std::memcmp(now_bytes, base.bytes() + 4 * at, size_t{4} * count) == 0;
        } else {
            words_at(base.bytes(), base.words(), at, count, was);
            same = std::memcmp(now_bytes, was, size_t{4} * count) == 0;
        }
        if (same) {
            if (++equal == most_equal_blocks) end_equal();
            continue;
        }
        end_equal();
        words_at(base.bytes(), base.words(), at, count, was);
        std::memcpy(now, now_bytes, size_t{4} * count);
        writer.block(now, was, count);
    }
    end_equal();
}

bool read_blocks(const SnapshotLayout& base, const Run& run, unsigned char* to, Reader& reader) {
    to += 4 * run.begin;
    for (uint64_t i = 0; i < run.words;) {
        const uint64_t at = run.base + i;
        uint32_t how = 0;
        if (!reader.byte(how)) return false;
        if (how >= block_equal) {
            const uint64_t equal = std::min<uint64_t>(uint64_t{how - block_equal + 1} * block_words, run.words - i);
            const uint64_t there = at < base.words() ? std::min(equal, base.words() - at) : 0;
            if (there != 0) std::memcpy(to + 4 * i, base.bytes() + 4 * at, static_cast<size_t>(4 * there));
            std::memset(to + 4 * (i + there), 0, static_cast<size_t>(4 * (equal - there)));
            i += equal;
            continue;
        }
        const auto count = static_cast<uint32_t>(std::min<uint64_t>(block_words, run.words - i));
        uint32_t was[block_words], now[block_words];
        words_at(base.bytes(), base.words(), at, count, was);
        if (!reader.block(how, was, count, now)) return false;
        std::memcpy(to + 4 * i, now, size_t{4} * count);
        i += count;
    }
    return true;
}

} // namespace

uint64_t delta_bound(uint64_t snapshot_size) {
    const uint64_t words = snapshot_size / 4;
    // All blocks as long as they can be; runs as short; both more than there are.
    const uint64_t bytes = sizeof(DeltaHeader) + 4 * words + 5 * (words / block_words + 1) +
                           (words / shortest_run + 1) * (run_bytes + 5) + 8;
    return snapshot_size > UINT64_MAX / 2 ? UINT64_MAX : bytes / 8 * 8 + 8;
}

lr_status delta_encode(const unsigned char* base, uint64_t base_size, const unsigned char* snapshot,
                       uint64_t snapshot_size, unsigned char* memory, uint64_t capacity, uint64_t& written) {
    SnapshotLayout from, to;
    if (!from.open(base, base_size) || !to.open(snapshot, snapshot_size)) return LR_ERROR_SNAPSHOT_FORMAT;
    Writer writer(memory, capacity);
    Run run{};
    uint64_t goes_on = 0; // in the base
    const auto end_run = [&] {
        writer.number(run.words);
        writer.number(moved(goes_on, run.base));
        write_blocks(from, to, run, writer);
        goes_on = run.base + run.words;
    };
    SnapshotPiece old{};
    bool more = from.next(old);
    for (SnapshotPiece piece{}; to.next(piece);) {
        while (more && old.key < piece.key) more = from.next(old);
        const uint64_t base_at = more && old.key == piece.key ? old.begin : from.words();
        if (run.words != 0 && (piece.words < shortest_run || base_at - run.base == piece.begin - run.begin)) {
            run.words += piece.words;
            continue;
        }
        if (run.words != 0) end_run();
        run = {piece.begin, piece.words, base_at};
    }
    while (more) more = from.next(old);
    if (!from.sensible() || !to.sensible()) return LR_ERROR_SNAPSHOT_FORMAT;
    end_run();
    const uint64_t used = writer.at(), size = (used + 7) / 8 * 8;
    if (size > capacity) return LR_ERROR_BUFFER_TOO_SMALL;
    std::memset(memory + used, 0, static_cast<size_t>(size - used));
    DeltaHeader header{delta_magic,        delta_version,    snapshot_version, size, 0, from.header().size,
                       from.header().seal, to.header().size, to.header().seal};
    std::memcpy(memory, &header, sizeof header);
    header.seal = seal_of(memory, size);
    std::memcpy(memory, &header, sizeof header);
    written = size;
    return LR_OK;
}

lr_status delta_apply(const unsigned char* base, uint64_t base_size, const unsigned char* delta, uint64_t delta_size,
                      unsigned char* memory, uint64_t capacity, uint64_t& written) {
    DeltaHeader header;
    if (delta_size < sizeof header) return LR_ERROR_SNAPSHOT_FORMAT;
    std::memcpy(&header, delta, sizeof header);
    if (header.magic != delta_magic || header.version != delta_version || header.snapshot_version != snapshot_version ||
        header.size > delta_size || header.size < sizeof header || header.size % 8 != 0 ||
        header.result_size % 8 != 0 || header.result_size < sizeof(SnapshotHeader) ||
        header.result_size / 4 / most_words_a_byte > header.size || seal_of(delta, header.size) != header.seal)
        return LR_ERROR_SNAPSHOT_FORMAT;
    // Damage of the base's columns would be damage of the result, which is looked for below.
    SnapshotLayout from;
    if (!from.begin(base, base_size)) return LR_ERROR_SNAPSHOT_FORMAT;
    if (from.header().size != header.base_size || from.header().seal != header.base_seal)
        return LR_ERROR_SNAPSHOT_MISMATCH;
    if (capacity < header.result_size) {
        written = header.result_size;
        return LR_ERROR_BUFFER_TOO_SMALL;
    }
    Reader reader(delta, header.size);
    const uint64_t words = header.result_size / 4;
    uint64_t goes_on = 0;
    for (uint64_t at = 0; at < words;) {
        uint64_t count = 0, way = 0;
        if (!reader.number(count) || !reader.number(way) || count == 0 || count > words - at)
            return LR_ERROR_SNAPSHOT_FORMAT;
        // Sums that run over are far behind the base's end, or wrong, as the seal will say.
        const Run run{at, count, way & 1 ? goes_on - (way >> 1) : goes_on + (way >> 1)};
        if (run.base > from.words() || !read_blocks(from, run, memory, reader)) return LR_ERROR_SNAPSHOT_FORMAT;
        goes_on = run.base + count;
        at += count;
    }
    SnapshotHeader made;
    std::memcpy(&made, memory, sizeof made);
    if (!reader.at_end() || made.magic != snapshot_magic || made.version != snapshot_version ||
        made.size != header.result_size || made.seal != header.result_seal || seal_of(memory, made.size) != made.seal)
        return LR_ERROR_SNAPSHOT_FORMAT;
    written = made.size;
    return LR_OK;
}

} // namespace lr
