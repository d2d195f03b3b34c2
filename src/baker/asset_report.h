// What an asset says, for people and for programs.
#pragma once

#include "baker/bake.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace lr::baker {

// The JSON of `info --json`, SI units, the density of the asset's fluid included in the added mass. Reproducible.
std::string report_json(const AssetData& asset);

// The same, with what happened on the way: "faults" and "timings".
std::string report_json(const AssetData& asset, const Faults& faults, const BakeTimings& timings);

// Was this report written with an asset of this provenance?
bool is_report_of(std::string_view json, const ProvenanceData& provenance);

// 16 hexadecimal digits.
std::string hash_text(uint64_t hash);

// A few lines for a terminal.
std::string summary(const AssetData& asset);
std::string summary(const BakeTimings& timings);

} // namespace lr::baker
