// Asset bytes to data and back. Reading trusts nothing: FlatBuffers verifier, checksum, then ranges and plausibility.
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

// Checks values apart from their encoding: finite, positive, symmetric, mass matrix positive definite, table and hull sane.
bool check_asset(const AssetData& data, Faults& faults);
// More checks for files: lengths, volume, hull and inertia must fit each other. For data that passed check_asset.
bool check_plausible(const AssetData& data, Faults& faults);

// The first edge of a hull that is open or concave; for valid indices and finite vertices. A neighbour can rise over a face by 1e-4 of `length`.
// Flat hulls, without volume, cannot face inward.
struct HullFlaw {
    size_t triangle;
    FaultId id;
    const char* what;
};
std::optional<HullFlaw> find_hull_flaw(const HullData& hull, double length);

// Hash of everything that affects motion and contact, without names and provenance.
uint64_t content_hash(const AssetData& data);

// The largest entry off the diagonals of inertia and added mass, relative to those it couples, or offset of buoyancy or of the loads over d.
double largest_coupling(const AssetData& asset);

// The load axis across the widest face, the last of equal ones.
size_t widest_axis(const AerodynamicData& loads);
// The part of a twist's matrix that changes when the body is mirrored across that axis.
std::array<double, 36> mirror_odd(const std::array<double, 36>& matrix, const AerodynamicData& loads);
// The largest entry of that part of the mass matrix, relative to those it couples, or offset of buoyancy or of the loads along the axis, over d.
double mirror_coupling(const AssetData& asset, const AerodynamicData& loads);

// A mesh that is symmetric by design is not so to the last bit: couplings up to a millionth count as zero. Stations couple all motions.
inline constexpr double no_coupling = 1e-6;
inline bool is_diagonal(const AssetData& asset) {
    return asset.stations.empty() && largest_coupling(asset) <= no_coupling;
}
inline bool is_symmetric(const AssetData& asset, const AerodynamicData& loads) {
    return asset.stations.empty() && mirror_coupling(asset, loads) <= no_coupling;
}
} // namespace lr
