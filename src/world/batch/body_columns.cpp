#include "world/batch/body_columns.h"

#include "base/counter_random.h"
#include "world/snapshot/snapshot_bytes.h"

#include <algorithm>
#include <cstring>

namespace lr {
namespace {

// Calls fn for each allocated column; the width of values is a compile-time constant.
template <class Function> void each(unsigned char* const (&data)[column_count], const Function& function) {
    for (size_t i = 0; i < column_count; ++i) {
        if (!data[i]) continue;
        if (body_columns[i].width == 4)
            function(data[i], uint32_t{});
        else
            function(data[i], uint64_t{});
    }
}

void mix_in(const Column& column, const unsigned char* from, uint32_t count, bool asleep, uint64_t* bodies) {
    const auto mixed = [&](uint32_t i) {
        return mix64(bodies[i] ^ (value_at<uint32_t>(from, i) + (uint64_t{column.tag} << 32)));
    };
    const bool only_awake = column.hashed == Hashed::awake || column.hashed == Hashed::remnant;
    if (column.hashed == Hashed::never || (only_awake && asleep) || (column.hashed == Hashed::birth && !asleep)) return;
    if (column.hashed == Hashed::birth)
        for (uint32_t i = 0; i < count; ++i) bodies[i] = mix64(bodies[i] ^ mix64(value_at<uint64_t>(from, i) + 1));
    else if (column.hashed == Hashed::rare || column.hashed == Hashed::remnant)
        for (uint32_t i = 0; i < count; ++i) bodies[i] = value_at<uint32_t>(from, i) != 0 ? mixed(i) : bodies[i];
    else
        for (uint32_t i = 0; i < count; ++i) bodies[i] = mixed(i);
}
} // namespace

bool BodyColumns::reserve(Allocator& allocator, ColumnPart part, size_t lanes) {
    if (has(part)) return true;
    uint64_t width = 0;
    for (const Column& column : body_columns) width += column.part == part ? column.width : 0;
    if (!memory_[part].allocate(allocator, width * lanes)) return false;
    unsigned char* at = memory_[part].data();
    for (size_t i = 0; i < column_count; ++i) {
        if (body_columns[i].part != part) continue;
        data_[i] = at;
        at += body_columns[i].width * lanes;
        clear(0, static_cast<uint32_t>(lanes), i, 1);
    }
    return true;
}

void BodyColumns::copy(uint32_t from, uint32_t to) {
    each(data_, [=](unsigned char* data, auto value) {
        std::memcpy(data + sizeof value * to, data + sizeof value * from, sizeof value);
    });
}

void BodyColumns::swap(uint32_t a, uint32_t b) {
    each(data_, [=](unsigned char* data, auto value) {
        std::memcpy(&value, data + sizeof value * a, sizeof value);
        std::memcpy(data + sizeof value * a, data + sizeof value * b, sizeof value);
        std::memcpy(data + sizeof value * b, &value, sizeof value);
    });
}

void BodyColumns::clear(uint32_t begin, uint32_t end, size_t first, size_t count) {
    for (size_t i = first; i < first + count && begin < end; ++i) {
        const Column& c = body_columns[i];
        if (!data_[i]) continue;
        if (c.empty != 0)
            std::fill(row<uint32_t>(i) + begin, row<uint32_t>(i) + end, c.empty);
        else
            std::memset(data_[i] + size_t{c.width} * begin, 0, size_t{c.width} * (end - begin));
    }
}

bool BodyColumns::any(size_t column, uint32_t count) const {
    const uint32_t words = count * body_columns[column].width / 4;
    uint32_t bits = 0; // of all values, for the vectoriser
    for (uint32_t i = 0; data_[column] && i < words; ++i) bits |= row<uint32_t>(column)[i];
    return bits != 0;
}

uint64_t BodyColumns::hash(uint32_t awake, uint32_t count) const {
    constexpr uint32_t block = 128;
    uint64_t bodies[block], sum = 0;
    for (uint32_t at = 0, here = 0; at < count; at += here) {
        const bool asleep = at >= awake;
        here = std::min(block, (asleep ? count : awake) - at);
        for (uint32_t i = 0; i < here; ++i) bodies[i] = mix64(row<uint32_t>(column_noise_seed)[at + i] + 1ull);
        for (size_t c = 0; c < column_count; ++c)
            if (data_[c]) mix_in(body_columns[c], data_[c] + size_t{body_columns[c].width} * at, here, asleep, bodies);
        for (uint32_t i = 0; i < here; ++i) sum += bodies[i];
    }
    return sum;
}
} // namespace lr
