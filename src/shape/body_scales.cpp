#include "shape/body_scales.h"

#include <algorithm>
#include <cmath>

namespace lr::shape {

BodyScales body_scales(double largest_extent, double smallest_extent, double volume, double projected_area,
                       double broadside_added_mass, double density, double fluid_density) {
    BodyScales s{};
    s.d = largest_extent;
    // Volume over area is the mean thickness of a sheet, however curled; 3/2 of it is the full thickness of an
    // ellipsoid, which has its extent there anyway. A flat box keeps its true thickness by its extent.
    s.b = std::min(smallest_extent, 1.5 * volume / projected_area);
    // Half the depth of the layer of fluid that moves along broadside. With the paper's 100 % intensity this lets 70
    // g/m^2 paper discs fall as measured ones do (docs/maintainers/physics.md, "Scales").
    s.l = 0.5 * broadside_added_mass / projected_area;
    s.u0 = speed_scale(density, fluid_density, s.b);
    return s;
}

double speed_scale(double density, double fluid_density, double thickness) {
    // A neutrally buoyant body has no fall speed; the floor keeps its scales finite.
    return std::max(1e-6, std::sqrt(std::abs(density / fluid_density - 1.0) * standard_gravity * thickness));
}

} // namespace lr::shape
