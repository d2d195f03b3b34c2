// What a bake starts from: a mesh file with what it refers to, bytes, or arrays.
#pragma once

#include "baker/bake.h"
#include "baker/mesh/input_files.h"

#include <cstdint>
#include <string>

namespace lr::baker {

// Of meshes, not of ellipsoids.
bool read_input(const BakeOptions& options, Mesh& mesh, InputFiles& input, Faults& faults);

// The mesh of options.mass, after read_input.
bool read_mass_input(const BakeOptions& options, Mesh& mesh, InputFiles& input, Faults& faults);

// What the mesh of options.mass is called, without folders.
std::string mass_name(const BakeOptions& options);

// As it stands in the asset. `options`: the canonical ones.
uint64_t input_hash(const InputFiles& input, const std::string& options);

} // namespace lr::baker
