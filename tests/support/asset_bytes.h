// Asset files for tests; changes a file and reseals it, which FlatBuffers' own code cannot do.
#pragma once

#include "asset/asset_data.h"
#include "asset/closed_forms/ellipsoid_asset.h"
#include "base/fnv1a.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace test {

// A leaf with everything that a baked file contains.
inline lr::AssetData leaf_data() {
    lr::shape::EllipsoidSpec spec;
    spec.semi_axes = {0.04, 0.01, 0.0005};
    spec.density = 800.0;
    spec.center_of_mass = {0.002, 0.0, 0.0};
    lr::AssetData data;
    lr::Faults faults;
    if (!lr::shape::ellipsoid_body(spec, data, faults)) return {};
    data.turbulence = lr::shape::decay_table(data, 1.0);
    data.name = "leaf";
    data.provenance = {"write_fixtures", "0", "leaf.obj", 42, "--unit m", 20, 12};
    return data;
}

// Byte offset of a field of the root table, from the FlatBuffers layout: root offset, table, vtable. 0 if absent, or if the path
// to it leads outside the bytes.
inline size_t root_field(const std::vector<uint8_t>& bytes, size_t id) {
    uint32_t root = 0;
    int32_t back = 0;
    uint16_t offset = 0;
    std::memcpy(&root, bytes.data(), 4);
    if (size_t{root} + 4 > bytes.size()) return 0;
    std::memcpy(&back, bytes.data() + root, 4);
    const int64_t entry = static_cast<int64_t>(root) - back + 4 + 2 * static_cast<int64_t>(id);
    if (entry < 0 || entry + 2 > static_cast<int64_t>(bytes.size())) return 0;
    std::memcpy(&offset, bytes.data() + entry, 2);
    return offset == 0 || size_t{root} + offset + 8 > bytes.size() ? 0 : root + offset;
}

// Writes the correct checksum into changed bytes.
inline void seal(std::vector<uint8_t>& bytes) {
    const size_t at = root_field(bytes, 1);
    if (at == 0) return;
    std::memset(bytes.data() + at, 0, 8);
    lr::Fnv1a hash;
    hash.add(bytes.data(), bytes.size());
    const uint64_t sum = hash.value();
    std::memcpy(bytes.data() + at, &sum, 8);
}

// Like a file written without this field.
inline void drop_root_field(std::vector<uint8_t>& bytes, size_t id) {
    uint32_t root = 0;
    int32_t back = 0;
    std::memcpy(&root, bytes.data(), 4);
    std::memcpy(&back, bytes.data() + root, 4);
    std::memset(bytes.data() + (static_cast<int64_t>(root) - back + 4 + 2 * static_cast<int64_t>(id)), 0, 2);
    seal(bytes);
}

inline void set_format_version(std::vector<uint8_t>& bytes, uint32_t version) {
    std::memcpy(bytes.data() + root_field(bytes, 0), &version, 4);
    seal(bytes);
}

} // namespace test
