#include "baker/added_mass/mixed_added_mass.h"

#include "baker/added_mass/error_estimates.h"
#include "baker/eigensystem.h"
#include "baker/mesh/convex_hull.h"
#include "baker/mesh/disjoint_sets.h"
#include "baker/mesh/mesh_check.h"
#include "baker/mesh/solid_region.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace lr::baker {
namespace {

// Most faces of the solved surface, reduced while the equations are singular, as for nearly coincident layers and needles.
constexpr std::size_t most_faces[] = {5000, 2500, 1000, 400};
// Including the strips that refine its free rims: the limit of a dense matrix.
constexpr std::size_t most_panels = 8000;
constexpr double rough = 0.1;         // error estimate above which the hull is tried as a bound
constexpr double too_much_lost = 0.2; // result of make_positive above which a coarser surface is tried
constexpr double needle_shape = 1e-4; // face_shape() below which coarser meshes leave a face out
constexpr double trapped_error =
    0.05;                            // of the trapped fluid's inertia: a box of 48 cells has 1 to 2 %, thin walls more
constexpr double nearly_full = 0.1;  // hollow share of the convex hull
constexpr double coarse_error = 2.0; // relative, times the size of cubes over that of the body

Eigen::Vector3d normal_of(const Mesh& mesh, const Face& f) {
    const Eigen::Vector3d& a = mesh.vertices[f[0]];
    return (mesh.vertices[f[1]] - a).cross(mesh.vertices[f[2]] - a).normalized();
}

struct Shell {
    BodyParts parts; // copies and needles included, since they bound the region
    Mesh skin;
    double cube = 0.0;
};

Shell make_shell(const BodyParts& parts, std::size_t most, bool coarsen) {
    Shell shell{parts, {}, 0.0};
    Mesh& mesh = shell.parts.mesh;
    if (coarsen || mesh.faces.size() > most) shell.cube = cluster(mesh, std::min(most, mesh.faces.size() * 3 / 4 + 1));
    shell.skin = outer_skin(shell.parts).mesh;
    if (shell.cube > 0.0)
        shell.skin.faces.erase(
            std::remove_if(shell.skin.faces.begin(), shell.skin.faces.end(),
                           [&](const Face& f) { return !(face_shape(shell.skin, f) > needle_shape); }),
            shell.skin.faces.end());
    shell.skin.faces = without_copies(shell.skin.faces);
    drop_unused_vertices(shell.skin);
    return shell;
}

double size_of(const Mesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& v : mesh.vertices) box.extend(v);
    return box.sizes().maxCoeff();
}

// Inertia of fluid that moves with a body, about a point. arm: from the point to the fluid's centroid; own: inertia of its turning about the
// centroid.
Matrix6 fluid_inertia(double volume, const Eigen::Vector3d& arm, const Eigen::Matrix3d& own) {
    Eigen::Matrix3d across;
    across << 0, -arm.z(), arm.y(), arm.z(), 0, -arm.x(), -arm.y(), arm.x(), 0;
    Matrix6 m;
    m << volume * Eigen::Matrix3d::Identity(), -volume * across, volume * across, own - volume * across * across;
    return m;
}

// Inertia of the fluid inside the solids, about the centre. In translation it moves as if frozen; overlaps of parts are in the error.
Matrix6 trapped_fluid(const BodyParts& parts, const Eigen::Vector3d& centre, Matrix6& error) {
    error.setZero();
    Mesh solids{parts.mesh.vertices, parts.solids(), {}};
    const SolidRegion region(solids, solids.faces);
    if (region.empty()) return Matrix6::Zero(); // a coarse surface can have nothing left of thin solids
    const double size = size_of(solids);
    const RegionMoments moments = region.moments(compute_mass_properties(solids));
    if (!(moments.volume > 1e-9 * size * size * size) || !moments.first.allFinite()) return Matrix6::Zero();
    const Eigen::Vector3d centroid = moments.first / moments.volume;
    const Eigen::Matrix3d spread = moments.second - moments.volume * centroid * centroid.transpose();
    const Eigen::Matrix3d own =
        trapped_fluid_inertia(region, centroid, spread.trace() * Eigen::Matrix3d::Identity() - spread);
    error.bottomRightCorner<3, 3>() = trapped_error * own.cwiseAbs();
    const double twice = std::abs(moments.counted - moments.volume);
    error.topLeftCorner<3, 3>().diagonal().setConstant(0.05 * twice);
    return fluid_inertia(moments.volume, centroid - centre, own);
}

// Eigenvalues of an inertia whose lengths are in units of the body's size, so that turns and translations compare.
struct Modes {
    using Values = Eigen::Matrix<double, 6, 1>;
    Values scale;
    Eigensystem<Matrix6> found;

    Modes(const Matrix6& m, double size) {
        scale.head<3>().setOnes();
        scale.tail<3>().setConstant(1.0 / size);
        found = eigensystem(Matrix6(scale.asDiagonal() * m * scale.asDiagonal()));
    }
    Matrix6 with(const Values& values) const {
        const Values back = scale.cwiseInverse();
        const Matrix6 m =
            back.asDiagonal() * (found.vectors * values.asDiagonal() * found.vectors.transpose()) * back.asDiagonal();
        return 0.5 * (m + m.transpose());
    }
};

// Raises eigenvalues below a thousandth of the largest: rounding and coarseness can make them negative in directions in which the body hardly moves
// fluid. Adds the change to the error of all such directions. Returns the most negative one over the largest.
double make_positive(Matrix6& m, Matrix6& error, double size) {
    const Modes modes(m, size);
    const double largest = modes.found.values.maxCoeff();
    if (!(largest > 0.0)) return HUGE_VAL;
    const Modes::Values values = modes.found.values.cwiseMax(1e-3 * largest);
    if (values == modes.found.values) return 0.0;
    m = modes.with(values);
    const double less = std::max(0.0, -modes.found.values.minCoeff());
    error.diagonal() += (less + 1e-3 * largest) * modes.scale.cwiseInverse().cwiseAbs2();
    return less / largest;
}

// Raises `m` to no less than `least` in any motion, within its error as far as that goes.
void raise_to(const AddedMass& least, double size, Matrix6& m, Matrix6& error) {
    const Modes more(m - least.value, size);
    const Modes::Values values = more.found.values.cwiseMax(0.0);
    if (values == more.found.values) return;
    const Matrix6 raised = least.value + more.with(values);
    error = least.error.cwiseMax(error - (raised - m).cwiseAbs());
    m = raised;
}

// The convex hull with few faces; where it is flat, only one side.
struct Hull {
    Mesh mesh;
    bool is_flat = false;
    MassProperties filled; // of the hull as a solid
};

bool make_hull(const Mesh& mesh, Hull& out) {
    constexpr std::size_t most = 600;
    constexpr double flat = 1e-4; // of the width: a needle is not flat
    Mesh& solid = out.mesh = mesh;
    Faults found;
    drop_unused_vertices(solid);
    for (double cube = size_of(mesh) / 256.0;; cube *= 2.0) {
        ConvexHull hull;
        if (!compute_convex_hull(solid.vertices, hull, found)) return false;
        solid.vertices = hull.vertices;
        solid.faces = hull.faces;
        if (solid.faces.size() <= most) break;
        cluster_to(solid, cube);
    }
    out.filled = compute_mass_properties(solid);
    const Eigen::Vector3d up = normal_of(solid, solid.faces[0]);
    const double width = std::min(size_of(mesh), out.filled.projected_areas.maxCoeff() / size_of(mesh));
    out.is_flat = std::all_of(solid.vertices.begin(), solid.vertices.end(), [&](const Eigen::Vector3d& v) {
        return std::abs(up.dot(v - solid.vertices[solid.faces[0][0]])) < flat * width;
    });
    if (out.is_flat) std::erase_if(solid.faces, [&](const Face& f) { return normal_of(solid, f).dot(up) < 0.0; });
    return true;
}

// Takes the hull for the body: if the body nearly fills it, and as the last resort. Fluid in hollows may move with the body or not. share: hollow
// part of the hull.
bool solve_hull(const Hull& hull, double share, const Eigen::Vector3d& centre, AddedMass& out, Faults& faults,
                const Progress& progress, AddedMassOptions options) {
    Faults found;
    options.patient = true; // it has few faces
    if (!(hull.is_flat ? compute_sheet_added_mass(hull.mesh, centre, {}, out, found, progress, options)
                       : compute_added_mass(hull.mesh, centre, out, found, progress, options)))
        return false;
    out.error += share * out.value.cwiseAbs();
    if (!hull.is_flat) {
        const Eigen::Vector3d arm = hull.filled.centroid - centre;
        out.error.diagonal().head<3>().array() += share * hull.filled.volume;
        out.error.diagonal().tail<3>() +=
            share * (hull.filled.inertia.diagonal() +
                     hull.filled.volume * (Eigen::Vector3d::Constant(arm.squaredNorm()) - arm.cwiseAbs2()));
    }
    const bool full = share < nearly_full;
    faults.push_back(
        {FaultId::mesh_ill_conditioned, Severity::warning, "mesh",
         full ? "The added mass is that of the convex hull, which the body nearly fills."
              : "The added mass is that of the convex hull: faces cross, or lie so close to each other that the flow "
                "between them cannot be computed.",
         full ? "None needed: the report has the error."
              : "Delete one of two layers that lie on each other, and unite parts that cross (boolean union)."});
    return true;
}
Matrix6 frozen(const MassProperties& body, const Eigen::Vector3d& centre = {0, 0, 0}) {
    return fluid_inertia(body.volume, body.centroid - centre, body.inertia);
}

// displaced: inertia of the fluid that the body displaces.
void bound(const Hull& hull, const Matrix6& displaced, const Eigen::Vector3d& centre, AddedMass& out,
           const AddedMassOptions& options) {
    AddedMass most, between = out;
    Faults found;
    if (!solve_hull(hull, 0.0, centre, most, found, {}, options)) return;
    most.value += most.error - displaced;
    if (!hull.is_flat) most.value += frozen(hull.filled, centre);
    between.value = 0.5 * (out.value + most.value);
    between.error = bound_of_energy(0.5 * (most.value - out.value));
    make_positive(between.value, between.error, size_of(hull.mesh)); // a hull of few faces can be smaller than the body
    if (between.largest_share() < out.largest_share()) out = between;
}
} // namespace

BodyParts outer_skin(const BodyParts& parts) {
    BodyParts out = parts;
    if (parts.solid_faces == 0) return out;
    const SolidRegion region(parts.mesh, parts.solids());
    const double away = 1e-6 * size_of(parts.mesh);
    const auto inside = [&](const Face& f, double off) {
        const Mesh& mesh = parts.mesh;
        const Eigen::Vector3d middle = (mesh.vertices[f[0]] + mesh.vertices[f[1]] + mesh.vertices[f[2]]) / 3.0;
        const Eigen::Vector3d out_of = off * normal_of(mesh, f);
        if (!region.contains(middle + out_of)) return false;
        for (const uint32_t v : f)
            if (!region.contains(0.1 * middle + 0.9 * mesh.vertices[v] + out_of)) return false;
        return true;
    };
    std::vector<Face> kept[2]; // of solids, of sheets
    for (std::size_t i = 0; i < parts.mesh.faces.size(); ++i) {
        const Face& f = parts.mesh.faces[i];
        if (f[0] == f[1] || f[1] == f[2] || f[2] == f[0]) continue;
        const bool sheet = i >= parts.solid_faces;
        if (inside(f, away) && (!sheet || inside(f, -away))) continue;
        kept[sheet].push_back(f);
    }
    out.solid_faces = kept[0].size();
    out.mesh.faces = std::move(kept[0]);
    out.mesh.faces.insert(out.mesh.faces.end(), kept[1].begin(), kept[1].end());
    return out;
}

std::vector<Face> covered_sheets(const BodyParts& parts, std::vector<Face> outside) {
    DisjointSets sets(parts.mesh.vertices.size());
    std::vector<Face> all = parts.sheets(), covered;
    for (const Face& f : all)
        for (const uint32_t v : f) sets.join(f[0], v);
    std::set<std::size_t> open;
    for (const Face& f : outside) open.insert(sets.find(f[0]));
    std::sort(all.begin(), all.end());
    std::sort(outside.begin(), outside.end());
    std::set_difference(all.begin(), all.end(), outside.begin(), outside.end(), std::back_inserter(covered));
    std::erase_if(covered, [&](const Face& f) { return !open.contains(sets.find(f[0])); });
    return covered;
}

namespace {

// Of the sheets of a body that has solids too, with what they have within these.
bool solve_sheets(const BodyParts& parts, const Eigen::Vector3d& centre, AddedMass& out,
                  const AddedMassOptions& options) {
    if (parts.solid_faces == 0 || !parts.has_sheets()) return false;
    Mesh sheets{parts.mesh.vertices, parts.sheets(), {}};
    sheets.faces.insert(sheets.faces.end(), parts.covered.begin(), parts.covered.end());
    drop_unused_vertices(sheets);
    Faults found;
    return compute_sheet_added_mass(sheets, centre, {}, out, found, {}, options);
}
} // namespace

void bound_by_hull(const Mesh& mesh, bool is_sheet, AddedMass& out, const AddedMassOptions& options) {
    Hull hull;
    if (make_hull(mesh, hull))
        bound(hull, is_sheet ? Matrix6::Zero() : frozen(compute_mass_properties(mesh)), {0, 0, 0}, out, options);
}

bool compute_mixed_added_mass(const BodyParts& parts, const Eigen::Vector3d& centre, AddedMass& out, Faults& faults,
                              const Progress& progress, const AddedMassOptions& options) {
    const double size = size_of(parts.mesh);
    Hull hull;
    const bool has_hull = make_hull(parts.mesh, hull);
    double hollow = 1.0;
    if (has_hull && parts.solid_faces > 0 && !hull.is_flat) {
        const Mesh solids{parts.mesh.vertices, parts.solids(), {}};
        const MassProperties sum = compute_mass_properties(solids);
        const auto left = [&](double volume) { return std::clamp(1.0 - volume / hull.filled.volume, 0.0, 1.0); };
        hollow = left(sum.volume);
        if (hollow < nearly_full) hollow = left(SolidRegion(solids, solids.faces).moments(sum).volume);
    }
    if (hollow < nearly_full && solve_hull(hull, hollow, centre, out, faults, progress, options)) return true;
    Faults found;
    AddedMass of_sheets;
    const bool has_least = solve_sheets(parts, centre, of_sheets, options);
    for (std::size_t round = 0; round < std::size(most_faces); ++round) {
        const Shell shell = make_shell(parts, most_faces[round], round > 0);
        if (shell.skin.faces.empty()) break;
        Refinement refinement;
        refinement.creases = true;
        bool fits = false;
        while (!(fits = refine_sheet(shell.skin, refinement).faces.size() <= most_panels) && refinement.strips > 1)
            refinement.creases = --refinement.strips > 1;
        if (!fits && round + 1 < std::size(most_faces)) continue; // without a dense matrix this takes a minute
        found.clear();
        if (!compute_sheet_added_mass(shell.skin, centre, refinement, out, found, progress, options)) continue;
        Matrix6 error;
        const Matrix6 trapped = trapped_fluid(shell.parts, centre, error);
        if (has_least) raise_to(of_sheets, size, out.value, out.error);
        out.error += error;
        out.value -= trapped;
        if (has_hull && shell.cube == 0.0 && out.largest_share() > rough) bound(hull, trapped, centre, out, options);
        out.error += std::min(0.5, coarse_error * shell.cube / size) * out.value.cwiseAbs();
        const double lost = make_positive(out.value, out.error, size);
        if (lost > (round + 1 < std::size(most_faces) ? too_much_lost : 1.0)) continue;
        if (shell.cube > 0.0)
            faults.push_back({FaultId::mesh_ill_conditioned, Severity::warning, "mesh",
                              "The added mass was solved on a coarser surface of " +
                                  std::to_string(shell.skin.faces.size()) + " faces, with details below " +
                                  shortest(std::round(1000.0 * shell.cube / size) / 10.0) +
                                  " % of the size joined: the mesh has " + std::to_string(parts.mesh.faces.size()) +
                                  " faces, or layers and needles too close to each other.",
                              "None needed: mass and hull are of all faces, and the report has the error. A simpler "
                              "mesh is more exact."});
        return true;
    }
    if (has_hull && solve_hull(hull, std::max(0.5, hollow), centre, out, faults, progress, options)) return true;
    if (found.empty())
        found.push_back({FaultId::mesh_ill_conditioned, Severity::error, "mesh",
                         "The flow around the body cannot be computed: it is too thin, or its faces cross.",
                         "Model a thin body by its middle surface and bake it with --sheet, or by lr_bake ellipsoid."});
    faults.insert(faults.end(), found.begin(), found.end());
    return false;
}
} // namespace lr::baker
