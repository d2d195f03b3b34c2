#include "asset/closed_forms/ellipsoid_asset.h"

#include "asset/closed_forms/ellipsoid_formulas.h"
#include "asset/closed_forms/turbulence_closure.h"
#include "base/matrix6.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace lr::shape {

bool in_range(double value, double low, double high, const char* name, Faults& faults) {
    if (value >= low && value <= high) return true; // false for NaN
    return fail(faults, FaultId::parameter_out_of_range, name,
                "The value " + shortest(value) + " is outside its range.",
                "Give a value from " + shortest(low) + " to " + shortest(high) + ".");
}

namespace {

// An icosahedron, each face split once into four: 42 points on the unit sphere.
HullData ellipsoid_hull(const std::array<double, 3>& axes, const std::array<double, 3>& origin) {
    const double g = std::numbers::phi;
    std::vector<std::array<double, 3>> points = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                                                 {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                                                 {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
    const uint32_t icosahedron[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                         {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                         {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                         {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
    const auto middle = [&](uint32_t a, uint32_t b) {
        const auto [at, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<uint32_t>(points.size()));
        if (is_new) {
            std::array<double, 3> p{};
            for (size_t i = 0; i < 3; ++i) p[i] = points[a][i] + points[b][i];
            points.push_back(p);
        }
        return at->second;
    };
    HullData hull;
    for (const auto& f : icosahedron) {
        const uint32_t m[3] = {middle(f[0], f[1]), middle(f[1], f[2]), middle(f[2], f[0])};
        for (uint32_t i : {f[0], m[0], m[2], f[1], m[1], m[0], f[2], m[2], m[1], m[0], m[1], m[2]})
            hull.triangles.push_back(i);
    }
    for (const auto& p : points) {
        const double r = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        for (size_t i = 0; i < 3; ++i) hull.vertices.push_back(static_cast<float>(p[i] / r * axes[i] - origin[i]));
    }
    return hull;
}
} // namespace

BodyScales body_scales(double largest_extent, double smallest_extent, double volume, double projected_area,
                       double broadside_added_mass, double density, double fluid_density) {
    BodyScales s{};
    s.d = largest_extent;
    // Volume over area is the mean thickness of a sheet, however curled; 3/2 of it is the thickness of an ellipsoid. A flat box has its smallest
    // extent.
    s.b = std::min(smallest_extent, 1.5 * volume / projected_area);
    // Half the depth of the fluid carried along broadside. With the paper's 100 % intensity, paper discs of 70 g/m^2 then fall as measured.
    s.l = 0.5 * broadside_added_mass / projected_area;
    s.u0 = speed_scale(density, fluid_density, s.b);
    return s;
}

// m/s^2, for scales; motion uses the world's gravity.
constexpr double standard_gravity = 9.80665;

double speed_scale(double density, double fluid_density, double thickness) {
    // A neutrally buoyant body has no fall speed; the floor keeps its scales finite.
    return std::max(1e-6, std::sqrt(std::abs(density / fluid_density - 1.0) * standard_gravity * thickness));
}

bool ellipsoid_body(const EllipsoidSpec& spec, AssetData& out, Faults& faults) {
    const auto& a = spec.semi_axes;
    bool ok = true;
    for (size_t i = 0; i < 3; ++i) {
        const char* names[3] = {"semi-axis A", "semi-axis B", "semi-axis C"};
        ok = in_range(a[i], 1e-6, 1e3, names[i], faults) && ok;
    }
    ok = in_range(spec.density, 1e-3, 1e6, "density", faults) && ok;
    ok = in_range(spec.fluid_density, 1e-3, 1e6, "fluid density", faults) && ok;
    ok = in_range(spec.fluid_viscosity, 1e-9, 1e3, "fluid viscosity", faults) && ok;
    ok = in_range(spec.intensity, 0.0, 10.0, "intensity", faults) && ok;
    if (!ok) return false;

    const auto [smallest, largest] = std::minmax({a[0], a[1], a[2]});
    if (largest > 1e4 * smallest)
        return fail(faults, FaultId::parameter_out_of_range, "semi-axes",
                    "The largest is more than 10000 times the smallest.", "Give a thicker body.");
    double depth = 0.0; // 1 on the surface
    for (size_t i = 0; i < 3; ++i) depth += spec.center_of_mass[i] * spec.center_of_mass[i] / (a[i] * a[i]);
    if (!(depth < 1.0))
        return fail(faults, FaultId::parameter_out_of_range, "center of mass", "It does not lie inside the ellipsoid.",
                    "Give an offset from the centre that does.");
    out = AssetData{};
    out.name = "ellipsoid";
    out.volume = 4.0 / 3.0 * std::numbers::pi * a[0] * a[1] * a[2];
    out.density = spec.density;
    out.mass = spec.density * out.volume;
    for (size_t i = 0; i < 3; ++i) {
        const double p = a[(i + 1) % 3], q = a[(i + 2) % 3];
        out.inertia[i * 4] = out.mass / 5.0 * (p * p + q * q);
    }
    const EllipsoidAddedMass added = lamb_added_mass(a);
    for (size_t i = 0; i < 3; ++i) {
        out.added_mass[i * 7] = added.translation[i];
        out.added_mass[(i + 3) * 7] = added.rotation[i];
        out.center_of_mass[i] = spec.center_of_mass[i];
        out.center_of_buoyancy[i] = 0.0 - spec.center_of_mass[i]; // not -0
    }
    shift_added_mass(out.added_mass, spec.center_of_mass);
    out.fluid_density = spec.fluid_density;
    out.fluid_viscosity = spec.fluid_viscosity;

    set_scales(a, added.translation, out);
    out.aerodynamics = default_aerodynamics(ellipsoid_geometry(a));
    out.hull = ellipsoid_hull(a, spec.center_of_mass);
    out.provenance.source = "ellipsoid";
    return true;
}

void set_scales(const std::array<double, 3>& a, const std::array<double, 3>& added_mass, AssetData& out) {
    const size_t thin = static_cast<size_t>(std::min_element(a.begin(), a.end()) - a.begin());
    const auto [smallest, largest] = std::minmax({a[0], a[1], a[2]});
    out.projected_area = std::numbers::pi * a[(thin + 1) % 3] * a[(thin + 2) % 3];
    const BodyScales scales = body_scales(2.0 * largest, 2.0 * smallest, out.volume, out.projected_area,
                                          added_mass[thin], out.density, out.fluid_density);
    out.length_d = scales.d;
    out.length_b = scales.b;
    out.length_l = scales.l;
    out.u0 = scales.u0;
}

TurbulenceData decay_table(const AssetData& asset, double intensity) {
    TurbulenceData table;
    constexpr size_t samples = 256;
    constexpr double duration = 32.0; // t* = t u0/l
    table.intensity = intensity;
    table.dt = duration / static_cast<double>(samples - 1);
    const double u0 = asset.u0, l = asset.length_l;
    const TurbulenceState start = inflow_state(u0, intensity, l);
    for (size_t i = 0; i < samples; ++i) {
        const TurbulenceState s = decay(start, static_cast<double>(i) * table.dt * l / u0);
        const bool quiet = !(s.k > 0.0);
        table.chi.push_back(quiet ? 0.0 : s.epsilon / s.k * l / u0);
        table.epsilon.push_back(quiet ? 0.0 : s.epsilon * l / (u0 * u0 * u0));
    }
    if (start.k > 0.0) table.c0 = kolmogorov_c0(taylor_reynolds(start, asset.fluid_viscosity));
    return table;
}
} // namespace lr::shape
