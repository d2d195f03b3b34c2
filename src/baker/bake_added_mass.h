// Chooses the solver of the added mass that fits the mesh.
#pragma once

#include "asset/asset_data.h"
#include "asset/input_faults.h"
#include "baker/added_mass/added_mass.h"
#include "baker/mesh/body_parts.h"

namespace lr::baker {

struct BodyMesh {
    const Mesh& mesh;
    BodyParts parts; // if mixed
    bool is_sheet = false, is_mixed = false;
};

// About the origin.
bool solve_added_mass(BodyMesh body, const AddedMassOptions& how, AddedMass& out, Faults& faults,
                      const Progress& report);

// Removes couplings of an asset's added mass that are too weak to count.
void drop_noise(AssetData& asset);
} // namespace lr::baker
