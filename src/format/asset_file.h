// Asset bytes to data and back. Reading trusts nothing: FlatBuffers verifier, checksum, then ranges and plausibility.
#pragma once

#include "format/asset_data.h"
#include "format/fault.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lr {

// The same data gives the same bytes.
std::vector<uint8_t> write_asset(const AssetData& data);

// False when `faults` received an error; `out` is then unspecified. Bytes of any alignment.
bool read_asset(const void* bytes, size_t size, AssetData& out, Faults& faults);

// Range and plausibility checks of values, apart from their encoding: finite, positive, symmetric, mass matrix
// positive definite, table and hull sane.
bool check_asset(const AssetData& data, Faults& faults);
// Of a file besides, which says what a mesh has: lengths, volume, hull and inertia fit each other. For data that passed check_asset.
bool check_plausible(const AssetData& data, Faults& faults);

// Of everything that matters for motion and contact, not of names and provenance.
uint64_t content_hash(const AssetData& data);

} // namespace lr
