// The per-body state of a batch: a table of columns by dense index. Allocation, moves, hashes and snapshots loop over it.
#pragma once

#include "base/allocator.h"
#include "base/bit_cast.h"
#include "collision/contact_cache.h"
#include "kernel/limits.h"

#include <array>
#include <cfloat>
#include <cstdint>

namespace lr {

// Memory is allocated by part: part_body in each batch, the others when first needed.
enum ColumnPart : uint32_t {
    part_body,
    part_sleep,
    part_gust,
    part_life,
    part_forces,
    part_contact,
    part_user,
    column_parts
};

enum class Hashed : uint8_t {
    never,
    always,
    awake,  // of awake bodies
    rare,   // values other than 0, which are few
    birth,  // of sleeping bodies
    remnant // of awake bodies, values other than 0
};

struct Column {
    ColumnPart part = part_body;
    uint32_t width = 0; // bytes of a value, 4 or 8
    Hashed hashed = Hashed::never;
    uint32_t tag = 0;              // in the hash
    float low = 0.0f, high = 0.0f; // allowed range in a snapshot; both 0: checked elsewhere
    bool saved = true;
    uint32_t empty = 0; // bits of unused lanes
};

// In the order of hashing. Columns before column_birth are BatchArrays::field.
enum ColumnIndex : uint32_t {
    column_birth = field_gust_x,
    column_gust,
    column_life = column_gust + wake_fields,
    column_force,
    column_stillness = column_force + force_components,
    column_touching,
    column_stay = column_touching + most_touches,
    column_lee = column_stay + stay_rows,
    column_floor,
    column_noted,
    column_noise_seed,
    column_ids,
    column_user,
    column_count
};

constexpr std::array<Column, column_count> make_columns() {
    constexpr float most = FLT_MAX;
    constexpr auto one = bit_cast<uint32_t>(1.0f);
    std::array<Column, column_count> all{};
    const auto rows = [&all](size_t first, size_t count, Column column) {
        for (size_t i = first; i < first + count; ++i, ++column.tag) all[i] = column;
    };
    using enum Hashed;
    // Velocities have no limits here, since a step checks them for divergence.
    rows(field_x, 3, {part_body, 4, always, field_x, -farthest_place, farthest_place});
    rows(field_qx, 10, {part_body, 4, always, field_qx, -most, most});
    all[field_qw].empty = one;
    rows(field_scale, 1, {part_body, 4, always, field_scale, least_scale, most_scale, true, one});
    rows(field_age, 1, {part_body, 4, awake, field_age, 0.0f, most_age});
    rows(field_age_remainder, 1, {part_body, 4, remnant, field_age_remainder, -most, most});
    rows(column_birth, 1, {part_sleep, 8, birth}); // s, on the clock of sleeping bodies
    rows(column_gust, wake_fields, {part_gust, 4, always, field_gust_x, -most, most});
    rows(column_life, 1, {part_life, 4, rare, field_count}); // how often a body has respawned
    rows(column_force, force_components, {part_forces, 4, rare, 64, -most, most});
    // ContactCache: share of the time to sleep; touched things; time in place, and displacement and turn since.
    rows(column_stillness, 1, {part_contact, 4, rare, 128, 0.0f, most});
    rows(column_touching, most_touches, {part_contact, 4, rare, 129});
    rows(column_stay, 1, {part_contact, 4, rare, 136, 0.0f, most});
    rows(column_stay + 1, stay_rows - 1, {part_contact, 4, rare, 137, -most, most});
    // Share of the wind's speed that an awake body loses to shelter: 0 to 1, or lee_unknown.
    rows(column_lee, 1, {part_contact, 4, rare, 143, lee_unknown, 1.0f});
    rows(column_floor, 1, {part_contact, 4, rare, 144}); // side of a mesh that the body is on: MeshFloor::up
    rows(column_noted, 1, {part_contact, 4, never, 0, 0.0f, 0.0f, false}); // marked for sleep or waking
    rows(column_noise_seed, 1, {part_body, 4, never});
    rows(column_ids, 1, {part_body, 8, never});
    rows(column_user, 1, {part_user, 8, never});
    return all;
}
inline constexpr std::array<Column, column_count> body_columns = make_columns();

class BodyColumns {
public:
    // Allocates an empty part for `lanes` bodies, a multiple of lane_block. False when out of memory.
    bool reserve(Allocator& allocator, ColumnPart part, size_t lanes);
    bool has(ColumnPart part) const { return memory_[part].size() != 0; }

    // Null if its part is not allocated.
    unsigned char* bytes(size_t column) const { return data_[column]; }
    template <class T> T* row(size_t column) const { return static_cast<T*>(static_cast<void*>(data_[column])); }

    void copy(uint32_t from, uint32_t to);
    void swap(uint32_t a, uint32_t b);
    // Clears lanes [begin, end) of `count` columns from `first`.
    void clear(uint32_t begin, uint32_t end, size_t first = 0, size_t count = column_count);

    // Whether any of the first `count` bodies has a value other than 0 there.
    bool any(size_t column, uint32_t count) const;
    // A sum over bodies, independent of their order. The first `awake` are awake.
    uint64_t hash(uint32_t awake, uint32_t count) const;

private:
    unsigned char* data_[column_count] = {};
    Buffer<unsigned char> memory_[column_parts];
};
} // namespace lr
