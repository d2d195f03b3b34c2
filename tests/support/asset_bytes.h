// Asset files for tests; changes and reseals a file, which FlatBuffers' own code cannot do.
#pragma once

#include "asset/asset_data.h"
#include "asset/closed_forms/ellipsoid_asset.h"
#include "base/fnv1a.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace test {

// A leaf with all parts of a baked file.
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

// A leaf with three stations: two halves that are bent, and a stem.
inline lr::AssetData winged_data() {
    lr::AssetData data = leaf_data();
    const lr::AerodynamicData& a = data.aerodynamics;
    const auto share = [](std::array<double, 3> v, double part) {
        for (double& x : v) x *= part;
        return v;
    };
    for (const double along : {0.02, -0.02, 0.038}) {
        const double part = along > 0.03 ? 0.1 : 0.45, sine = along > 0.03 ? 0.0 : along > 0.0 ? 0.28 : -0.28;
        const double cosine = sine == 0.0 ? 1.0 : 0.96;
        lr::StationData s;
        s.axes = {cosine, 0.0, -sine, 0.0, 1.0, 0.0, sine, 0.0, cosine};
        s.place = {along, 0.001 * part, 0.0};
        s.drag = share(a.drag, part), s.drag_blunt = share(a.drag_blunt, part);
        s.drag_layer = share(a.drag_layer, part), s.drag_stokes = share(a.drag_stokes, part);
        s.plate_lift = share(a.plate_lift, part), s.plate_vortex = share(a.plate_vortex, part);
        s.plate_stall = a.plate_stall;
        s.spin_lift = share(a.spin_lift, part), s.spin_drag = share(a.spin_drag, part);
        s.spin_drag_stream = share(a.spin_drag_stream, part), s.spin_drag_stokes = share(a.spin_drag_stokes, part);
        s.plate_drag = part * a.plate_drag;
        s.lift_arm = {0.002, 0.001, 0.0};
        s.hollow = {0.02, -0.01, 0.1};
        s.separated_shedding = 1e-7 * part, s.camber = 0.02;
        data.stations.push_back(s);
    }
    return data;
}

// Byte offset of a field of the root table, from the FlatBuffers layout: root offset, table, vtable. 0 if absent, or if the path to it leads outside
// the bytes.
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

// As if the file had been written without this field.
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
