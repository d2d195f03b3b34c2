#include "baker/bake_added_mass.h"

#include "asset/asset_file.h"
#include "baker/added_mass/mixed_added_mass.h"
#include "baker/fault_text.h"
#include "baker/mesh/mesh_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace lr::baker {
namespace {

constexpr double rough_share = 0.25;

// The narrowest face: what is wrong with a mesh that cannot be solved is most often there.
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
                ": the body is very thin, or its faces are long and narrow.",
            "None needed: the report has the error. Divide long faces across to make it smaller."};
}

bool solve(BodyMesh& body, const AddedMassOptions& how, AddedMass& out, Faults& faults, const Progress& report) {
    const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    const auto as_modelled = [&](Faults& found) {
        return body.is_sheet ? compute_sheet_added_mass(body.mesh, origin, Refinement{}, out, found, report, how)
                             : compute_added_mass(body.mesh, origin, out, found, report, how);
    };
    if (body.is_mixed) return compute_mixed_added_mass(body.parts, origin, out, faults, report, how);
    if (how.patient) return as_modelled(faults);
    Faults found;
    bool good = as_modelled(found), rough = good && out.largest_share() > rough_share;
    if (!good) {
        const AddedMass direct = out;
        body.parts.mesh = body.mesh;
        body.parts.solid_faces = body.is_sheet ? 0 : body.mesh.faces.size();
        found.clear();
        good = compute_mixed_added_mass(body.parts, origin, out, found, report, how);
        rough = direct.value.trace() > 0.0 && !(good && out.largest_share() < direct.largest_share());
        if (rough) out = direct, found.clear(), good = true;
    }
    if (rough) found.push_back(roughness(out.largest_share()));
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

// A body with three mirror planes has a diagonal matrix, for which the runtime has a fast path, but its triangles rarely have
// these planes. The error of a Galerkin energy is itself an energy: off the diagonal it is at most the geometric mean of the
// errors of the two diagonal entries. Couplings below that, and too weak to be visible, are noise. All or none are removed,
// which keeps the matrix positive; or those that a flat body's own mirror plane excludes, by the mean with its mirror image.
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
