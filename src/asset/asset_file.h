// Asset bytes to data and back. Reads hostile bytes: FlatBuffers verifier, checksum, then ranges and plausibility.
#pragma once

#include "asset/asset_data.h"
#include "asset/input_faults.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace lr {

// The same data gives the same bytes.
std::vector<uint8_t> write_asset(const AssetData& data);

// False if `faults` received an error; `out` is then unspecified. Bytes of any alignment.
bool read_asset(const void* bytes, size_t size, AssetData& out, Faults& faults);

// Checks values apart from their encoding: finite, positive, symmetric, mass matrix positive definite, valid table and hull.
bool check_asset(const AssetData& data, Faults& faults);
// Checks that lengths, volume, hull and inertia of a file fit each other. For data that passed check_asset.
bool check_plausible(const AssetData& data, Faults& faults);

// The first edge of a hull that is open or concave, for valid indices and finite vertices. A neighbour may rise over a face by 1e-4 of `length`. Flat
// hulls, which have no volume, cannot face inward.
struct HullFlaw {
    size_t triangle;
    FaultId id;
    const char* what;
};
std::optional<HullFlaw> find_hull_flaw(const HullData& hull, double length);

// Hash of everything that affects motion and contact, without names and provenance.
uint64_t content_hash(const AssetData& data);

// Largest off-diagonal entry of inertia and added mass over the geometric mean of its diagonal entries, or offset of buoyancy or loads over d.
double largest_coupling(const AssetData& asset);

// The load axis across the widest face, the last of equal ones.
size_t widest_axis(const AerodynamicData& loads);
// The part of a matrix of twists that is odd under mirroring across that axis.
std::array<double, 36> mirror_odd(const std::array<double, 36>& matrix, const AerodynamicData& loads);
// The largest entry of that part of the mass matrix, scaled as in largest_coupling, or offset of buoyancy or loads along the axis, over d.
double mirror_coupling(const AssetData& asset, const AerodynamicData& loads);

// Couplings up to a millionth count as zero, since a mesh that is symmetric by design is not so to the last bit. Stations couple all motions.
inline constexpr double no_coupling = 1e-6;
inline bool is_diagonal(const AssetData& asset) {
    return asset.stations.empty() && largest_coupling(asset) <= no_coupling;
}
inline bool is_symmetric(const AssetData& asset, const AerodynamicData& loads) {
    return asset.stations.empty() && mirror_coupling(asset, loads) <= no_coupling;
}
} // namespace lr
