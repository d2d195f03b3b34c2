// Plots of an asset as SVG. Deterministic.
#pragma once

#include "asset/asset_data.h"
#include "baker/mesh/mesh.h"

#include <array>
#include <string>

namespace lr::baker {

inline constexpr std::array<const char*, 3> plot_names{"turbulence.svg", "added_mass.svg", "entries.svg"};

// k, epsilon and chi over time (the paper's Fig. 2), in SI units.
std::string plot_turbulence(const AssetData& asset);

// Four views of the body with ellipsoids of added mass and added inertia. body: in the body frame.
std::string plot_added_mass(const AssetData& asset, const Mesh& body);

// The entries of the 6x6 matrix relative to the scale of their block, with estimated errors.
std::string plot_entries(const AssetData& asset);

// In the order of plot_names.
std::array<std::string, 3> make_plots(const AssetData& asset, const Mesh& body);

// Whether the plot shows an asset of this provenance.
bool is_plot_of(std::string_view svg, const ProvenanceData& provenance);

// The invisible description in each plot.
std::string plot_description(const AssetData& asset);
} // namespace lr::baker
