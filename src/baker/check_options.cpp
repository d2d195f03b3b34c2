#include "baker/check_options.h"

#include "baker/aerodynamics/stations.h"
#include "baker/fault_text.h"
#include "baker/file_faults.h"

#include <algorithm>

namespace lr::baker {
namespace {

constexpr std::size_t max_name_bytes = 4096; // limit of check_asset

bool in_range(double value, double low, double high, const char* where, const char* unit, Faults& faults) {
    if (value >= low && value <= high) return true; // false for NaN
    return fail(faults, FaultId::parameter_out_of_range, where,
                "The value " + shortest(value) + " is outside its range.",
                "Give a number from " + shortest(low) + " to " + shortest(high) + unit + ".");
}
} // namespace

bool check_options(const BakeOptions& o, Faults& faults) {
    bool good = in_range(o.density, 1e-3, 1e6, "density", " kg/m^3", faults);
    if (o.card && (!o.sheet || o.sheet->thickness == choose_thickness))
        good = fail(faults, FaultId::parameter_out_of_range, "thickness", "A card has no thickness of its own.",
                    "Give --thickness.");
    if (o.thickness)
        good = in_range(*o.thickness / units_per_metre(o.unit), 1e-8, 10.0, "thickness", " m", faults) && good;
    if (o.sheet && o.sheet->thickness != choose_thickness) {
        const double thickness = o.sheet->thickness / units_per_metre(o.unit);
        good = in_range(thickness, 1e-8, 10.0, "thickness", " m", faults) && good;
        if (good && o.sheet->areal_density)
            good = in_range(*o.sheet->areal_density, 1e-3 * thickness, 1e6 * thickness, "areal density", " kg/m^2",
                            faults);
    }
    if (o.size) good = in_range(*o.size, 1e-6, 1e3, "size", " m", faults) && good;
    if (o.size && (o.semi_axes || o.card))
        good = fail(faults, FaultId::parameter_out_of_range, "size", "Only a mesh has a --size.",
                    "Give the semi-axes of an ellipsoid, or the --width of a card.");
    good = in_range(o.fluid_density, 1e-3, 1e6, "fluid density", " kg/m^3", faults) && good;
    good = in_range(o.fluid_viscosity, 1e-9, 1e3, "fluid viscosity", " m^2/s", faults) && good;
    good = in_range(o.intensity, 1e-6, 10.0, "intensity", "", faults) && good;
    double cells = 1.0;
    const auto [fewest, most] = std::minmax({o.cells[0], o.cells[1], o.cells[2]});
    for (const uint32_t n : o.cells) cells *= n;
    if (!in_range(fewest, 4.0, 512.0, "grid", " cells along each axis", faults) ||
        (most != fewest && !in_range(most, 4.0, 512.0, "grid", " cells along each axis", faults)))
        good = false;
    else if (cells > 4194304.0)
        good = fail(faults, FaultId::parameter_out_of_range, "grid", "The grid has " + shortest(cells) + " cells.",
                    "Give at most 4194304 cells, for instance 160,160,160.");
    good = in_range(o.stations, 1.0, most_stations, "stations", "", faults) && good;
    if (o.center_of_mass)
        for (const double x : *o.center_of_mass) good = in_range(x, -1e9, 1e9, "center of mass", "", faults) && good;
    if (o.mass && (o.semi_axes || o.card))
        good = fail(faults, FaultId::parameter_out_of_range, "mass", "Only a mesh can take its mass from another mesh.",
                    "Bake the body as a mesh.");
    if (o.mass && o.center_of_mass)
        good = fail(faults, FaultId::parameter_out_of_range, "mass",
                    "The mesh of the mass and --center-of-mass both define the centre of mass.", "Give one of them.");
    if (o.semi_axes)
        for (const double x : *o.semi_axes)
            good = in_range(x / units_per_metre(o.unit), 1e-6, 1e3, "semi-axes", " m", faults) && good;
    if (o.name && o.name->size() > max_name_bytes)
        good = fail(faults, FaultId::parameter_out_of_range, "name", "The name is longer than 4096 bytes.",
                    "Give a shorter name.");
    return good;
}
} // namespace lr::baker
