// Mass properties of the second mesh, --mass-from.
#pragma once

#include "baker/mesh/mass_properties.h"

namespace lr::baker {

struct WeighOptions {
    bool sheet = false, strict = false, fill = false;
    double thickness = 0.0; // of sheets; 0: default_thickness of their length
};

// Of the layers of a sheet, or of solid parts, repaired as the first mesh is unless strict. For density 1.
bool weigh(Mesh& mesh, const WeighOptions& how, MassProperties& out, Faults& faults);
} // namespace lr::baker
