// The input of a bake: a mesh file and the files that it refers to, bytes, or arrays.
#pragma once

#include "baker/bake.h"
#include "baker/mesh/input_files.h"

#include <cstdint>
#include <string>

namespace lr::baker {

// For meshes and cards, not ellipsoids. card: filled for a card.
bool read_input(const BakeOptions& options, Mesh& mesh, CardReport& card, InputFiles& input, Faults& faults);

// Reads the mesh of options.mass. Call after read_input.
bool read_mass_input(const BakeOptions& options, Mesh& mesh, InputFiles& input, Faults& faults);

// The file name of options.mass without folders.
std::string mass_name(const BakeOptions& options);

// The hash stored in the asset. options: canonical_options().
uint64_t input_hash(const InputFiles& input, const std::string& options);
} // namespace lr::baker
