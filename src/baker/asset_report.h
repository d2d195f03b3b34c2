// Reports of an asset, as text and as JSON.
#pragma once

#include "baker/bake.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace lr::baker {

// The JSON of `info --json`, in SI units; added mass includes the density of the asset's fluid. Reproducible.
std::string report_json(const AssetData& asset);

// The same with "faults" and "timings" of the bake.
std::string report_json(const AssetData& asset, const Faults& faults, const BakeTimings& timings,
                        const StationErrors& errors = {});

// Whether the report belongs to an asset of this provenance.
bool is_report_of(std::string_view json, const ProvenanceData& provenance);

// 16 hexadecimal digits.
std::string hash_text(uint64_t hash);

// A few lines for a terminal.
std::string summary(const AssetData& asset);
std::string summary(const BakeTimings& timings);
} // namespace lr::baker
