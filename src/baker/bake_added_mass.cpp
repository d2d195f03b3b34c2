#include "baker/bake_added_mass.h"

#include "asset/asset_file.h"
#include "baker/added_mass/mixed_added_mass.h"
#include "baker/fault_text.h"
#include "baker/mesh/double_sheets.h"
#include "baker/mesh/mass_properties.h"
#include "baker/mesh/mesh_check.h"
#include "baker/mesh/simplify.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace lr::baker {
namespace {

constexpr double rough_share = 0.25;

// The narrowest face: most often the cause if the equations cannot be solved.
std::string narrowest_face(const Mesh& mesh) {
    const auto narrowest = std::min_element(mesh.faces.begin(), mesh.faces.end(), [&](const Face& a, const Face& b) {
        return face_shape(mesh, a) < face_shape(mesh, b);
    });
    const Face& f = *narrowest;
    return "mesh, its narrowest face at " +
           place_of(mesh, (mesh.vertices[f[0]] + mesh.vertices[f[1]] + mesh.vertices[f[2]]) / 3.0,
                    std::to_string(narrowest - mesh.faces.begin()));
}

Fault roughness(double share) {
    return {FaultId::mesh_ill_conditioned, Severity::warning, "mesh",
            (share < 1.0 ? "The added mass is uncertain by " + shortest(std::ceil(100.0 * share)) + " %"
                         : std::string("The added mass is a rough guess")) +
                ": the body is very thin, its faces are long and narrow, or its parts are close to each other.",
            "None needed: the report has the error. To make it smaller, divide long faces across, or model many thin "
            "parts side by side as one sheet."};
}

bool are_mostly_needles(const Mesh& mesh) {
    constexpr double needle = 0.02; // face_shape()
    double narrow = 0.0, all = 0.0;
    for (const Face& f : mesh.faces) {
        const double area =
            (mesh.vertices[f[1]] - mesh.vertices[f[0]]).cross(mesh.vertices[f[2]] - mesh.vertices[f[0]]).norm();
        all += area;
        if (face_shape(mesh, f) < needle) narrow += area;
    }
    return 2.0 * narrow > all;
}

// Solves with needles joined to broad faces. Of a very thin solid, between whose sides the equations hardly have a solution, it solves one side as a
// sheet.
bool solve_plainer(const BodyMesh& body, const AddedMassOptions& how, AddedMass& out, Faults& faults,
                   const Progress& report) {
    constexpr std::size_t most_dense = 5000, few_needles = 1000;
    constexpr double nowhere_else = 1e-4,
                     thin = 0.05; // largest motion of faces, over the size and over the thickness
    const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    const double size = box_sides(body.mesh).maxCoeff();
    const MassProperties solid = body.is_sheet ? MassProperties{} : compute_mass_properties(body.mesh);
    double distance = nowhere_else * size;
    if (!body.is_sheet) distance = std::min(distance, thin * 2.0 * solid.volume / solid.area);
    const Mesh plain = simplified(body.mesh, distance);
    if (plain.faces.size() > most_dense) return false;
    const auto solve_it = [&](const Mesh& mesh, bool is_sheet) {
        faults.clear();
        return is_sheet ? compute_sheet_added_mass(mesh, origin, {}, out, faults, report, how)
                        : compute_added_mass(mesh, origin, out, faults, report, how);
    };
    Mesh side;
    if (!body.is_sheet && find_one_side(plain, side) && solve_it(side, true)) {
        out.error.diagonal().head<3>().array() += solid.volume;
        out.error.diagonal().tail<3>() +=
            solid.inertia.diagonal() + solid.volume * solid.centroid.squaredNorm() * Eigen::Vector3d::Ones();
        faults.push_back({FaultId::mesh_ill_conditioned, Severity::warning, "mesh",
                          "The added mass is that of a sheet without thickness: the solid is very thin.",
                          "None needed: the report has the error."});
        return true;
    }
    return 4 * plain.faces.size() < 3 * body.mesh.faces.size() &&
           (body.is_sheet || plain.faces.size() < few_needles || !are_mostly_needles(plain)) &&
           solve_it(plain, body.is_sheet);
}

bool solve(BodyMesh& body, const AddedMassOptions& how, AddedMass& out, Faults& faults, const Progress& report) {
    const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    const auto as_modelled = [&](Faults& found) {
        return body.is_sheet ? compute_sheet_added_mass(body.mesh, origin, Refinement{}, out, found, report, how)
                             : compute_added_mass(body.mesh, origin, out, found, report, how);
    };
    bool good = false;
    const auto is_rough = [&] { return good && out.largest_share() > rough_share; };
    if (body.is_mixed) {
        good = compute_mixed_added_mass(body.parts, origin, out, faults, report, how);
        if (is_rough()) faults.push_back(roughness(out.largest_share()));
        return good;
    }
    if (how.patient) return as_modelled(faults);
    Faults found;
    const auto try_plainer = [&] {
        AddedMass plain;
        Faults found_then;
        if (!solve_plainer(body, how, plain, found_then, report) ||
            plain.largest_share() > (good ? out.largest_share() : rough_share))
            return;
        out = plain;
        found = found_then;
        good = true;
    };
    const bool needles = are_mostly_needles(body.mesh); // slow to solve, and rarely with a result
    if (needles) try_plainer();
    if (!good) {
        good = as_modelled(found);
        if (!needles && (!good || is_rough())) try_plainer();
    }
    bool rough = is_rough();
    if (!good) {
        const AddedMass direct = out;
        body.parts.mesh = body.mesh;
        body.parts.solid_faces = body.is_sheet ? 0 : body.mesh.faces.size();
        found.clear();
        good = compute_mixed_added_mass(body.parts, origin, out, found, report, how);
        rough = direct.value.trace() > 0.0 && !(good && out.largest_share() < direct.largest_share());
        if (rough) out = direct, found.clear(), good = true;
    }
    if (rough) bound_by_hull(body.mesh, body.is_sheet, out, how);
    if (rough || is_rough()) found.push_back(roughness(out.largest_share()));
    faults.insert(faults.end(), found.begin(), found.end());
    return good;
}
} // namespace

bool solve_added_mass(BodyMesh body, const AddedMassOptions& how, AddedMass& out, Faults& faults,
                      const Progress& report) {
    const std::size_t before = faults.size();
    const bool good = solve(body, how, out, faults, report);
    for (std::size_t i = before; !good && i < faults.size(); ++i)
        if (faults[i].where == "mesh") faults[i].where = narrowest_face(body.mesh);
    return good;
}

// A body with three mirror planes has a diagonal matrix, for which the runtime has a fast path, but its triangles rarely have these planes. The error
// of a Galerkin energy is itself an energy, so off the diagonal it is at most the geometric mean of the errors of the two diagonal entries. Smaller
// couplings that are also too weak to be visible are noise. Removing all of them or none keeps the matrix positive, and so does the mean with the
// mirror image in a flat body's own plane, which removes the couplings that this plane excludes.
void drop_noise(AssetData& asset) {
    constexpr double visible = 2e-3;
    auto& m = asset.added_mass;
    auto& error = asset.added_mass_error;
    const auto size = [&](std::size_t n) {
        return m[n * 7] + (n < 3 ? asset.volume : asset.inertia[(n - 3) * 4] / asset.density);
    };
    const auto is_noise = [&](const std::array<double, 36>& part) {
        for (std::size_t i = 0; i < 36; ++i) {
            const std::size_t row = i / 6, column = i % 6;
            const double value = std::abs(part[i]);
            if (value > std::sqrt(error[row * 7] * error[column * 7]) ||
                value > visible * std::sqrt(size(row) * size(column)))
                return false;
        }
        return true;
    };
    std::array<double, 36> part = m;
    for (std::size_t i = 0; i < 6; ++i) part[i * 7] = 0.0;
    if (!is_noise(part)) part = mirror_odd(m, asset.aerodynamics);
    if (!is_noise(part)) return;
    for (std::size_t i = 0; i < 36; ++i) {
        error[i] = std::max(error[i], std::abs(part[i]));
        m[i] -= part[i];
    }
}
} // namespace lr::baker
