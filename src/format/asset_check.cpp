#include "format/asset_file.h"
#include "format/checksum.h"
#include "format/hull_check.h"
#include "format/matrix6.h"

#include <bit>
#include <cmath>

namespace lr {
namespace {

class Checker {
public:
    explicit Checker(Faults& faults) : faults_(faults) {}

    void range(double value, const std::string& field, double low, double high) {
        if (!std::isfinite(value)) {
            fail(FaultId::asset_not_finite, field, "The value is not a finite number.");
        } else if (value < low || value > high) {
            fail(FaultId::asset_out_of_range, field,
                 "The value " + shortest(value) + " is outside " + shortest(low) + " to " + shortest(high) + ".");
        }
    }
    template <class Values> bool finite(const Values& values, const char* field) {
        for (size_t i = 0; i < values.size(); ++i)
            if (!std::isfinite(values[i])) {
                fail(FaultId::asset_not_finite, std::string(field) + "[" + std::to_string(i) + "]",
                     "The value is not a finite number.");
                return false;
            }
        return true;
    }
    // `n` rows, row-major; relative to the geometric mean of the diagonal entries.
    template <size_t N> void symmetric(const std::array<double, N>& m, size_t n, const char* field) {
        for (size_t i = 0; i < n; ++i)
            for (size_t j = 0; j < i; ++j) {
                const double a = m[i * n + j], b = m[j * n + i];
                const double size = std::sqrt(std::abs(m[i * n + i] * m[j * n + j])) + std::abs(a) + std::abs(b);
                if (std::abs(a - b) > 1e-6 * size) {
                    fail(FaultId::asset_not_symmetric, entry(field, i, j), "The matrix is not symmetric.");
                    return;
                }
            }
    }
    void fail(FaultId id, std::string where, std::string what, std::string remedy = "Bake the asset again.") {
        faults_.push_back({id, Severity::error, std::move(where), std::move(what), std::move(remedy)});
        ok_ = false;
    }
    static std::string entry(const char* field, size_t i, size_t j) {
        return std::string(field) + "[" + std::to_string(i) + "][" + std::to_string(j) + "]";
    }
    bool ok() const { return ok_; }

private:
    Faults& faults_;
    bool ok_ = true;
};

void check_matrices(const AssetData& d, Checker& check) {
    if (!check.finite(d.inertia, "inertia") || !check.finite(d.added_mass, "added_mass") ||
        !check.finite(d.added_mass_error, "added_mass_error"))
        return;
    check.symmetric(d.inertia, 3, "inertia");
    check.symmetric(d.added_mass, 6, "added_mass");
    if (!check.ok()) return;

    // In units of the body: 1e-10 is far above rounding and below the thinnest needle that an ellipsoid may be.
    Matrix6 body = rigid_mass_matrix(d.mass, d.inertia);
    scale_to_unit(body, d.mass, d.length_d);
    for (size_t i = 3; i < 6; ++i)
        if (!(body[i * 6 + i] > 1e-10 && body[i * 6 + i] < 10.0)) {
            check.fail(FaultId::asset_out_of_range, Checker::entry("inertia", i - 3, i - 3),
                       "The moment of inertia does not fit the mass and the length d.");
            return;
        }
    if (!is_positive_definite(body, 1e-10)) {
        check.fail(FaultId::asset_not_positive, "inertia", "The inertia is not positive definite.");
        return;
    }
    Matrix6 added = d.added_mass;
    const double unit = d.volume + d.projected_area * d.length_d;
    scale_to_unit(added, unit, d.length_d);
    for (double v : added)
        if (std::abs(v) > 100.0) {
            check.fail(FaultId::asset_out_of_range, "added_mass", "An entry is far too large for a body of this size.");
            return;
        }
    // Semi-definite: about an axis of revolution the added inertia is zero, and a solver may leave a little below.
    for (size_t i = 0; i < 6; ++i) added[i * 6 + i] += 1e-5;
    if (!is_positive_definite(added, 0.0))
        check.fail(FaultId::asset_not_positive, "added_mass", "The added mass is not positive semi-definite.");
}

void check_table(const TurbulenceData& t, Checker& check) {
    if (t.chi.empty() || t.chi.size() > 65536) {
        check.fail(FaultId::asset_wrong_length, "turbulence.chi",
                   "A table has 1 to 65536 samples, not " + std::to_string(t.chi.size()) + ".");
        return;
    }
    if (t.epsilon.size() != t.chi.size()) {
        check.fail(FaultId::asset_wrong_length, "turbulence.epsilon",
                   "It has " + std::to_string(t.epsilon.size()) + " samples, chi has " + std::to_string(t.chi.size()) +
                       ".");
        return;
    }
    if (!check.finite(t.chi, "turbulence.chi") || !check.finite(t.epsilon, "turbulence.epsilon")) return;
    for (size_t i = 0; i < t.chi.size(); ++i)
        if (t.chi[i] < 0.0 || t.chi[i] > 1e4 || t.epsilon[i] < 0.0 || t.epsilon[i] > 1e6) {
            check.fail(FaultId::asset_out_of_range, "turbulence[" + std::to_string(i) + "]",
                       "chi* lies within 0 to 1e4 and epsilon* within 0 to 1e6.");
            return;
        }
    if (t.stationary >= t.chi.size())
        check.fail(FaultId::asset_out_of_range, "turbulence.stationary", "It points behind the table.");
    if (t.loop_begin > t.loop_end || t.loop_end > t.chi.size())
        check.fail(FaultId::asset_out_of_range, "turbulence.loop", "It ends before it begins, or behind the table.");
    for (double side : t.domain) check.range(side, "turbulence.domain", 0.0, 1e9);
    check.range(t.max_divergence, "turbulence.max_divergence", 0.0, 1e12);
    check.range(t.dt, "turbulence.dt", 1e-9, 1e9);
    check.range(t.c0, "turbulence.c0", 0.0, 100.0);
    check.range(t.intensity, "turbulence.intensity", 0.0, 100.0);
}

void check_hull(const AssetData& d, Checker& check) {
    const HullData& h = d.hull;
    if (h.vertices.empty() && h.triangles.empty()) return;
    if (h.vertices.size() % 3 != 0 || h.triangles.size() % 3 != 0 || h.vertices.size() < 12 ||
        h.triangles.size() < 12) {
        check.fail(FaultId::asset_bad_hull, "hull", "A hull has at least four vertices and four triangles.");
        return;
    }
    if (!check.finite(h.vertices, "hull.vertices")) return;
    const double reach = 2.0 * d.length_d + 1e-12;
    for (size_t i = 0; i < h.vertices.size(); ++i)
        if (std::abs(static_cast<double>(h.vertices[i])) > reach) {
            check.fail(FaultId::asset_bad_hull, "hull.vertices[" + std::to_string(i) + "]",
                       "The vertex lies far outside the body's largest extent.");
            return;
        }
    for (size_t i = 0; i < h.triangles.size(); ++i)
        if (h.triangles[i] >= h.vertices.size() / 3) {
            check.fail(FaultId::asset_bad_hull, "hull.triangles[" + std::to_string(i) + "]",
                       "The index points behind the vertices.");
            return;
        }
    size_t triangle = 0;
    const HullFlaw flaw = find_flaw(h, d.length_d, triangle);
    const std::string where = "hull.triangles[" + std::to_string(3 * triangle) + "]";
    if (flaw == HullFlaw::open)
        check.fail(FaultId::asset_open_hull, where, "An edge has not exactly two triangles, one on each side.");
    else if (flaw == HullFlaw::dented)
        check.fail(FaultId::asset_hull_not_convex, where, "The hull is not convex here.");
    else if (flaw == HullFlaw::inside_out)
        check.fail(FaultId::asset_hull_not_convex, where, "The triangles face inward.");
}

void check_aerodynamics(const AssetData& d, Checker& check) {
    const AerodynamicData& a = d.aerodynamics;
    if (!check.finite(a.axes, "aerodynamics.axes")) return;
    if (!is_rotation(a.axes, 1e-9))
        check.fail(FaultId::asset_bad_axes, "aerodynamics.axes",
                   "The axes are not three orthogonal unit vectors, right-handed.");

    // In units of the body; folded and bristling surfaces have many times the area of their silhouette.
    constexpr double most = 1e6;
    const double d1 = d.length_d, d2 = d1 * d1, d3 = d2 * d1;
    const auto range = [&](const std::array<double, 3>& values, const char* field, double low, double unit) {
        for (size_t k = 0; k < 3; ++k)
            check.range(values[k], std::string(field) + "[" + std::to_string(k) + "]", low * unit, most * unit);
    };
    range(a.drag, "aerodynamics.drag", 0.0, d2);
    range(a.drag_blunt, "aerodynamics.drag_blunt", 0.0, d2);
    range(a.drag_layer, "aerodynamics.drag_layer", 0.0, d1 * std::sqrt(d1));
    range(a.drag_stokes, "aerodynamics.drag_stokes", 0.0, d1);
    range(a.lift, "aerodynamics.lift", -most, d2);
    range(a.spin_lift, "aerodynamics.spin_lift", -most, d3);
    range(a.lift_moment, "aerodynamics.lift_moment", -most, d3);
    range(a.spin_drag, "aerodynamics.spin_drag", 0.0, d3 * d2);
    range(a.spin_drag_stream, "aerodynamics.spin_drag_stream", 0.0, d2 * d2);
    range(a.spin_drag_stokes, "aerodynamics.spin_drag_stokes", 0.0, d3);
    range(a.roll_damping, "aerodynamics.roll_damping", 0.0, d2 * d2);
    check.range(a.intensity, "aerodynamics.intensity", 0.0, 10.0);
    check.range(a.length, "aerodynamics.length", 1e-9, 1e5);
    check.range(a.wake_reynolds, "aerodynamics.wake_reynolds", 0.0, 1e9);
    check.range(a.lift_stall, "aerodynamics.lift_stall", -10.0, 10.0);
    range(a.lift_moment_stalled, "aerodynamics.lift_moment_stalled", -most, d3);
    for (size_t k = 0; k < 3; ++k)
        check.range(a.center[k], "aerodynamics.center[" + std::to_string(k) + "]", -2.0 * d1, 2.0 * d1);
    for (size_t k = 0; k < 3; ++k)
        check.range(a.broadside[k], "aerodynamics.broadside[" + std::to_string(k) + "]", 0.0, 1.0);
}

} // namespace

bool check_asset(const AssetData& d, Faults& faults) {
    Checker check(faults);
    check.range(d.mass, "mass", 1e-18, 1e12);
    check.range(d.volume, "volume", 1e-21, 1e12);
    check.range(d.density, "density", 1e-6, 1e6);
    check.range(d.fluid_density, "fluid.density", 1e-6, 1e6);
    check.range(d.fluid_viscosity, "fluid.viscosity", 1e-12, 1e6);
    check.range(d.length_d, "lengths.d", 1e-7, 1e4);
    check.range(d.length_b, "lengths.b", 1e-9, 1e4);
    check.range(d.length_l, "lengths.l", 1e-9, 1e4);
    check.range(d.projected_area, "projected_area", 1e-15, 1e9);
    check.range(d.u0, "u0", 1e-9, 1e6);
    check.finite(d.center_of_mass, "center_of_mass");
    check.finite(d.center_of_buoyancy, "center_of_buoyancy");
    if (!check.ok()) return false;

    if (std::abs(d.mass - d.density * d.volume) > 1e-6 * d.mass)
        check.fail(FaultId::asset_inconsistent, "mass", "Mass is not density times volume.");
    for (double c : d.center_of_buoyancy)
        if (std::abs(c) > 2.0 * d.length_d)
            check.fail(FaultId::asset_out_of_range, "center_of_buoyancy", "It lies far outside the body.");
    if (d.name.size() > 4096) check.fail(FaultId::asset_out_of_range, "name", "The name is longer than 4096 bytes.");
    check_matrices(d, check);
    check_table(d.turbulence, check);
    check_hull(d, check);
    check_aerodynamics(d, check);
    return check.ok();
}

uint64_t content_hash(const AssetData& d) {
    Fnv1a hash;
    const auto number = [&](double v) { hash.add_u64(std::bit_cast<uint64_t>(v)); };
    const auto numbers = [&](const auto& values) {
        hash.add_u64(values.size());
        for (auto v : values) number(static_cast<double>(v));
    };
    for (double v : {d.mass, d.volume, d.density, d.fluid_density, d.fluid_viscosity, d.length_d, d.length_b,
                     d.length_l, d.projected_area, d.u0, d.turbulence.dt, d.turbulence.c0})
        number(v);
    numbers(d.center_of_mass);
    numbers(d.center_of_buoyancy);
    numbers(d.inertia);
    numbers(d.added_mass);
    numbers(d.turbulence.chi);
    numbers(d.turbulence.epsilon);
    hash.add_u64(d.turbulence.stationary);
    numbers(d.hull.vertices);
    hash.add_u64(d.hull.triangles.size());
    for (uint32_t i : d.hull.triangles) hash.add_u64(i);
    const AerodynamicData& a = d.aerodynamics;
    numbers(a.axes);
    for (const auto* values :
         {&a.drag, &a.drag_blunt, &a.drag_layer, &a.drag_stokes, &a.lift, &a.spin_lift, &a.lift_moment, &a.spin_drag,
          &a.spin_drag_stream, &a.spin_drag_stokes, &a.broadside, &a.lift_moment_stalled, &a.roll_damping, &a.center})
        numbers(*values);
    for (double v : {a.intensity, a.length, a.wake_reynolds, a.lift_stall}) number(v);
    return hash.value();
}

} // namespace lr
