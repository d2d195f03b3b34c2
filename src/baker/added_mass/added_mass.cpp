#include "baker/added_mass/added_mass.h"

#include "baker/added_mass/boundary_operators.h"
#include "baker/added_mass/curved_refinement.h"
#include "baker/added_mass/error_estimates.h"
#include "baker/added_mass/fast_system.h"
#include "baker/added_mass/single_cholesky.h"
#include "baker/added_mass/surface_basis.h"
#include "baker/added_mass/surface_correction.h"
#include "baker/eigensystem.h"
#include "baker/mesh/half_edges.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

// The potential phi of a moving body, with grad phi . n = q on its surface, solves the hypersingular integral equation
//   W phi = -(1/2 + K') q
// in continuous linear elements (Galerkin). W reduces to integrals of 1/r between surface curls (Maue 1949, Nedelec 1982), so closed forms for
// constant panels suffice, the matrix is symmetric and positive, and the added mass -integral phi q, an energy, converges twice as fast as phi.
// Unlike an equation of the second kind it stays well posed for a thin solid, where the doublets of both sides nearly cancel.

namespace lr::baker {
namespace {

// A sphere with this many panels takes 4 GB.
constexpr std::size_t max_panels = 1000000;
// Matrix entries in near blocks: 4 GB, three times the need of the largest sphere.
constexpr std::size_t max_stored_entries = 1000000000;
// Without patience: pairs of near panels (a regular mesh has twelve for each panel), and points of their integrals.
constexpr std::size_t few_pairs = 4000000, few_pairs_each = 60;
constexpr double few_points = 4e8;
// Without patience: panels of a sheet whose rims are refined. Thousands of narrow strips have twenty times the given triangles.
constexpr std::size_t few_panels = 200000, few_panels_each = 4;
// Without patience. Sheets need fewer than fifty iterations unless layers nearly coincide. Far pairs count in all iterations and take 10 microseconds
// each. The error of the energy is the square of the tolerance.
constexpr std::size_t few_iterations = 100, few_far_pairs = 700000;
constexpr double hasty_tolerance = 1e-4;
// A solid whose error estimate, over the largest entry of its block, is larger is solved again on at most this many finer panels.
constexpr double good_estimate = 0.0025;
constexpr std::size_t max_refined_panels = 5000;
// Without patience: error estimate above which a coarser surface is solved instead, if finer panels would be too many.
constexpr double poor_estimate = 0.05;
// Least scale of rotation, over that of translation: a round body has no added inertia.
constexpr double least_rotation = 0.01;
// The same for the poor estimate: beside the inertia of a ball or a capsule a hundredth of the translation's does not matter.
constexpr double poor_rotation = 0.2;
// The error of a box with two triangles per side comes from the size of the panels, not from the strips.
constexpr std::size_t min_refined_panels = 1000;
constexpr double refined_turn = 0.1; // of the normal along an edge, radians
// Error estimate of a sheet above which extrapolation from coarse and fine panels is better than one solution: narrow strips, folds of few faces.
constexpr double rough_sheet = 0.05;
constexpr std::size_t least_halved = 500, most_quartered = 40000;
// Factor on the estimate where rims have fewer than all strips, since it does not see the flow around them. For needles from rim to rim the true
// error is up to 1.7 times the estimate.
constexpr double rim_doubt = 2.0;
// Condition of the scaled matrix above which phi has less than about six digits.
constexpr double max_condition = 1e10;

// Relative error of the quadrature over neighbouring panels, measured on spheres; it does not depend on the number of panels.
constexpr double quadrature_floor = 5e-4;

// W is singular for constant potentials, which have no energy. Adds the square of the mean of each: this fixes the constant and leaves the added mass
// unchanged.
void fix_constants(const Mesh& mesh, const SurfaceBasis& basis, const std::vector<Panel>& panels,
                   Eigen::MatrixXd& matrix) {
    if (basis.constants.empty()) return;
    Eigen::VectorXd share = Eigen::VectorXd::Zero(matrix.rows());
    for (std::size_t i = 0; i < mesh.faces.size(); ++i)
        for (const CornerUnknowns& corner : basis.corners[i])
            for (const int32_t unknown : {corner.plus, corner.minus})
                if (unknown >= 0) share[unknown] += panels[i].area / 3.0;
    const double scale = matrix.diagonal().mean();
    for (const ConstantPotential& constant : basis.constants) {
        double square = 0.0;
        for (const int32_t i : constant.unknowns) square += share[i] * share[i];
        const double factor = scale * 0.1 * static_cast<double>(constant.unknowns.size()) / square;
        for (std::size_t j = 0; j < constant.unknowns.size(); ++j)
            for (std::size_t i = 0; i < constant.unknowns.size(); ++i) {
                const int32_t row = constant.unknowns[i], column = constant.unknowns[j];
                matrix(row, column) += factor * constant.signs[i] * share[row] * constant.signs[j] * share[column];
            }
    }
}

// Replaces the matrix by the nearest one without negative eigenvalues; returns the largest eigenvalue removed.
double clamp_to_positive(Matrix6& matrix) {
    const Eigensystem<Matrix6> solver = eigensystem(matrix);
    const double lowest = solver.values[0];
    if (lowest >= 0.0) return 0.0;
    const Matrix6 vectors = solver.vectors;
    const Matrix6 result = vectors * solver.values.cwiseMax(0.0).asDiagonal() * vectors.transpose();
    matrix = 0.5 * (result + result.transpose());
    return -lowest;
}

// Scale of each entry for a body of size one: the largest diagonal entry of its block, that of rotation at least this share of that of translation.
Matrix6 entry_scale(const Matrix6& matrix, double least = least_rotation) {
    const double mass = std::max(matrix.diagonal().head<3>().maxCoeff(), 1e-300);
    Eigen::Matrix<double, 6, 1> scale;
    scale.head<3>().setConstant(std::sqrt(mass));
    scale.tail<3>().setConstant(std::sqrt(std::max(matrix.diagonal().tail<3>().maxCoeff(), least * mass)));
    return scale * scale.transpose();
}

struct Solution {
    Eigen::MatrixXd value;
    double condition = 0.0, residual = 0.0;
};

// A lower bound, nearly always close, of the 1-norm of the inverse (Hager 1984, SIAM J. Sci. Stat. Comput. 5).
double inverse_norm(const SingleCholesky& factor, Eigen::Index size) {
    Eigen::MatrixXd x = Eigen::MatrixXd::Constant(size, 1, 1.0 / static_cast<double>(size));
    double norm = 0.0;
    for (int i = 0; i < 2; ++i) {
        Eigen::MatrixXd y = x;
        factor.solve(y);
        norm = std::max(norm, y.lpNorm<1>());
        Eigen::MatrixXd z = y.unaryExpr([](double v) { return v < 0.0 ? -1.0 : 1.0; });
        factor.solve(z);
        Eigen::Index row = 0;
        if (z.col(0).cwiseAbs().maxCoeff(&row) <= std::abs(z.col(0).dot(x.col(0)))) break;
        x.setZero();
        x(row, 0) = 1.0;
    }
    return norm;
}

// Iterative refinement. Each round divides the residual by about 1e7 over the condition, down to the rounding of the residual.
bool solve_refined(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right, Solution& out) {
    constexpr int max_rounds = 8;
    constexpr double good = 1e-12, enough = 1e-10;
    SingleCholesky factor;
    if (!factor.factorise(matrix)) return false;
    out.value = right;
    factor.solve(out.value);
    double last = 1.0;
    for (int i = 0; i < max_rounds; ++i) {
        Eigen::MatrixXd rest = right - matrix.selfadjointView<Eigen::Lower>() * out.value;
        out.residual = rest.norm() / right.norm();
        if (out.residual < good || (out.residual < enough && out.residual > 0.5 * last)) {
            const double norm = matrix.colwise().lpNorm<1>().maxCoeff();
            out.condition = norm * inverse_norm(factor, matrix.rows());
            return true;
        }
        last = out.residual;
        factor.solve(rest);
        out.value += rest;
    }
    return false;
}

bool solve_in_double(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right, Solution& out) {
    const Eigen::LLT<Eigen::MatrixXd> solver(matrix);
    if (solver.info() != Eigen::Success) return false;
    out.value = solver.solve(right);
    out.residual = (matrix.selfadjointView<Eigen::Lower>() * out.value - right).norm() / right.norm();
    out.condition = 1.0 / std::max(solver.rcond(), 1e-300);
    return true;
}

// Sheets that cross or nearly coincide can make the matrix indefinite, because the quadratures of their panels are too coarse. Holds the potential at
// zero at each pivot below `least` (the diagonal is one), which makes the energy smaller.
bool solve_without_weak(Eigen::MatrixXd& matrix, Eigen::MatrixXd& right, Solution& out) {
    constexpr float least = 0.01F;
    constexpr double most = 0.6; // of the unknowns: where two layers coincide, half of them have no effect
    const std::vector<Eigen::Index> weak = SingleCholesky().weak_unknowns(matrix, least);
    if (static_cast<double>(weak.size()) > most * static_cast<double>(matrix.rows())) return false;
    for (const Eigen::Index i : weak) {
        matrix.row(i).setZero();
        matrix.col(i).setZero();
        matrix(i, i) = 1.0;
        right.row(i).setZero();
    }
    return solve_refined(matrix, right, out);
}

bool fail(FaultId id, const char* what, const char* remedy, Faults& faults) {
    faults.push_back({id, Severity::error, "mesh", what, remedy});
    return false;
}

bool refuse_singular(bool sheet, Faults& faults) {
    return fail(FaultId::mesh_ill_conditioned,
                sheet ? "Faces cross, or lie so close to each other that the flow between them cannot be computed."
                      : "Faces cross, or the solid is so thin that the flow around it cannot be computed.",
                sheet ? "Delete one of two layers that lie on each other, and merge vertices by distance."
                      : "Unite parts that cross (boolean union), or model a very thin solid by its middle surface and "
                        "bake it with --sheet.",
                faults);
}

bool refuse_costly(Faults& faults) {
    return fail(FaultId::mesh_too_many_faces,
                "Too many faces are close to too many others: the added mass needs too much time and memory.",
                "Remesh: avoid long faces beside short ones.", faults);
}

// solve_dense and solve_fast set `image` to W times the vertex positions, for the check of the quadrature in solve_surface.
bool solve_dense(const Mesh& unit, const SurfaceBasis& basis, const Eigen::MatrixXd& position, const Progress& report,
                 const AddedMassOptions& options, BoundaryOperators& op, RigidModes& phi, Eigen::MatrixXd& image,
                 AddedMass& out, Faults& faults) {
    NearLimits limits;
    if (!options.patient) limits.points = few_points;
    op = assemble_boundary_operators(unit, basis, report, limits);
    Eigen::MatrixXd& matrix = op.hypersingular;
    if (matrix.size() == 0) return refuse_costly(faults);
    if (position.cols() > 0) image = matrix.selfadjointView<Eigen::Lower>() * position;
    fix_constants(unit, basis, op.panels, matrix);
    const Eigen::VectorXd scaling = matrix.diagonal().cwiseSqrt().cwiseInverse();
    if (!scaling.allFinite()) return refuse_singular(basis.sheet, faults);
    for (Eigen::Index column = 0; column < matrix.cols(); ++column)
        matrix.col(column).array() *= scaling.array() * scaling[column];
    report(0.85);
    Eigen::MatrixXd right = scaling.asDiagonal() * op.right_side;
    Solution solution;
    // Without patience: factors in double precision take too long for large sheets, and rarely help.
    const bool try_double = options.patient || !basis.sheet || matrix.rows() < 3000;
    if (!solve_refined(matrix, right, solution) && !(try_double && solve_in_double(matrix, right, solution)) &&
        !(basis.sheet && solve_without_weak(matrix, right, solution)))
        return refuse_singular(basis.sheet, faults);
    phi = scaling.asDiagonal() * solution.value;
    out.residual = solution.residual;
    out.condition_estimate = solution.condition;
    return true;
}

bool solve_fast(const Mesh& unit, const SurfaceBasis& basis, const Eigen::MatrixXd& position,
                const AddedMassOptions& options, const Progress& report, BoundaryOperators& op, RigidModes& phi,
                Eigen::MatrixXd& image, AddedMass& out, Faults& faults) {
    const auto share = [&](double from, double to) {
        return [&report, from, to](double fraction) { report(from + (to - from) * fraction); };
    };
    NearSingleLayer near;
    NearLimits limits;
    if (!options.patient) limits = {std::max(few_pairs, few_pairs_each * unit.faces.size()), few_points};
    if (!assemble_without_matrix(unit, basis, options.threads, share(0.0, 0.5), op, near, limits))
        return refuse_costly(faults);
    FastSystem system(op, near, basis, options.threads);
    if (system.stored_entries() > (options.patient ? max_stored_entries : max_stored_entries / 5))
        return refuse_costly(faults);
    system.assemble(share(0.2, 0.5));
    if (position.cols() > 0) image = system.multiply(position);
    FastSystem::Result result;
    const std::size_t few =
        std::min(basis.sheet ? few_iterations : SIZE_MAX, few_far_pairs / std::max<std::size_t>(1, system.far_pairs()));
    const bool solved = options.patient ? system.solve(op.right_side, share(0.5, 0.95), result)
                                        : system.solve(op.right_side, share(0.5, 0.95), result, few, hasty_tolerance);
    if (!solved) return refuse_singular(basis.sheet, faults);
    phi = result.value;
    out.residual = result.residual;
    out.condition_estimate = result.condition;
    out.iterations = result.iterations;
    return true;
}

// For a body of size one around the centre. Closed bodies: `curved` has the gap between flat panels and the curved surface. The error estimate
// includes `geometry.curved`; `geometry` receives all geometric errors.
bool solve_surface(const Mesh& unit, const SurfaceBasis& basis, const CurvedSurface* curved, const Doubts& doubts,
                   GeometryErrors& geometry, AddedMass& out, Faults& faults, const AddedMassOptions& options,
                   const Progress& report) {
    Eigen::MatrixXd position, image;
    if (!basis.sheet) {
        position.resize(static_cast<Eigen::Index>(basis.unknowns), 3);
        for (std::size_t i = 0; i < unit.vertices.size(); ++i)
            position.row(static_cast<Eigen::Index>(i)) = unit.vertices[i].transpose();
    }
    BoundaryOperators op;
    RigidModes phi;
    const bool solved = unit.faces.size() <= options.max_dense
                            ? solve_dense(unit, basis, position, report, options, op, phi, image, out, faults)
                            : solve_fast(unit, basis, position, options, report, op, phi, image, out, faults);
    if (!solved) return false;

    const Matrix6 raw = -(phi.transpose() * op.moments);
    Matrix6 value = 0.5 * (raw + raw.transpose());
    const Matrix6 scale = entry_scale(value);
    out.asymmetry = ((raw - raw.transpose()).cwiseAbs().array() / scale.array()).maxCoeff();
    const double removed = clamp_to_positive(value);

    const std::vector<Currents> currents = surface_currents(basis, op.panels, phi);
    Matrix6 error = discretisation_error(unit, basis, op, currents) + 0.5 * (raw - raw.transpose()).cwiseAbs();
    error += quadrature_floor * value.cwiseAbs();
    error += geometry.curved;
    if (curved) {
        geometry = geometry_errors(op, currents, *curved, doubts);
        error += geometry.curved;
    }
    if (!basis.sheet) {
        // For translations the interior potential is x, so W x = (1/2 - K') n up to quadrature errors: a check without extra
        // cost.
        const Eigen::MatrixXd defect = image - op.moments.leftCols(3) - op.right_side.leftCols(3);
        const Eigen::Matrix<double, 6, 3> quadrature = phi.transpose() * defect;
        error.leftCols<3>() += 0.5 * quadrature.cwiseAbs();
        error.topRows<3>() += 0.5 * quadrature.cwiseAbs().transpose();
    }

    out.value = value;
    out.error = error;
    if (!out.value.allFinite()) {
        faults.push_back({FaultId::mesh_ill_conditioned, Severity::error, "mesh", "The added mass is not finite.",
                          "Remesh with better-shaped triangles."});
        return false;
    }
    if (out.condition_estimate > max_condition || out.asymmetry > 0.02 || removed > 1e-3 * value.trace())
        faults.push_back({FaultId::mesh_ill_conditioned, Severity::warning, "mesh",
                          "The added mass is uncertain (condition " + std::to_string(out.condition_estimate) +
                              ", asymmetry " + std::to_string(out.asymmetry) + ").",
                          "Remesh with better-shaped triangles, smaller where surfaces are close together."});
    report(1.0);
    return true;
}

bool check_size(const Mesh& mesh, Faults& faults) {
    if (mesh.faces.size() > max_panels) {
        faults.push_back({FaultId::mesh_too_many_faces, Severity::error, "mesh",
                          "The added mass is limited to " + std::to_string(max_panels) + " triangles; the mesh has " +
                              std::to_string(mesh.faces.size()) + ".",
                          "Decimate the mesh."});
        return false;
    }
    if (mesh.faces.empty()) {
        faults.push_back(
            {FaultId::mesh_empty, Severity::error, "mesh", "The mesh has no faces.", "Check the mesh before baking."});
        return false;
    }
    return true;
}

// Scales to size one around the centre, so that the mesh's unit and position affect only the last digits.
Mesh scale_to_unit(const Mesh& mesh, const Eigen::Vector3d& centre, double& size) {
    size = 0.0;
    for (const Eigen::Vector3d& v : mesh.vertices) size = std::max(size, (v - centre).norm());
    Mesh unit = mesh;
    for (Eigen::Vector3d& v : unit.vertices) v = (v - centre) / size;
    return unit;
}

Progress or_nothing(const Progress& progress) {
    return progress ? progress : [](double) {};
}

void scale_to_size(double size, AddedMass& m) {
    Eigen::Matrix<double, 6, 1> units;
    units.head<3>().setConstant(std::pow(size, 1.5));
    units.tail<3>().setConstant(std::pow(size, 2.5));
    const Matrix6 products = units * units.transpose(); // exactly symmetric, like the value
    m.value = m.value.cwiseProduct(products).eval();
    m.error = m.error.cwiseProduct(products).eval();
}

bool is_within(double share, const AddedMass& m, double least = least_rotation) {
    return (m.error.array() <= share * entry_scale(m.value, least).array()).all();
}

// Refines where the surface is curved and at creases, to at most this many panels.
Mesh refine(const Mesh& unit, std::size_t most, std::vector<uint32_t>& origin) {
    std::vector<uint32_t> first(unit.faces.size());
    std::iota(first.begin(), first.end(), 0U);
    const Mesh curved = refine_curved(unit, refined_turn, most, &first);
    for (std::size_t strips = 3; strips >= 1; --strips) {
        origin = first;
        Mesh fine = refine_solid(curved, {min_refined_panels, strips}, &origin);
        if (fine.faces.size() <= most) return fine;
    }
    // Too many strips for a long thin bar: at least the flow along it is resolved.
    origin = first;
    Refinement halved{min_refined_panels, 1};
    halved.most_halved = most / 2;
    if (Mesh fine = refine_solid(curved, halved, &origin); fine.faces.size() <= most) return fine;
    origin = first;
    return curved;
}

// Extrapolates to infinitely fine panels from three solutions: rims in one strip, in two strips, and panels half as large with rims in two strips.
// Two strips leave a quarter of the error of one, or less where panels at the rim are narrower. Half as large panels leave half of the error at sharp
// folds, and less where the flow is smooth.
AddedMass extrapolated(const AddedMass& whole, const AddedMass& cut, AddedMass fine) {
    const Matrix6 by_strips = cut.value - whole.value, by_panels = fine.value - cut.value;
    fine.value += by_strips / 5.0 + by_panels / 3.0;
    clamp_to_positive(fine.value);
    fine.error =
        bound_of_energy(by_strips) / 6.0 + bound_of_energy(by_panels) / 1.5 + quadrature_floor * fine.value.cwiseAbs();
    return fine;
}

// Swaps the diagonals of bent quads. Diagonals that all run the same way couple motions as a screw does, which a smooth surface does not. False if no
// quad is bent.
bool swap_diagonals(Mesh& mesh) {
    constexpr double
        square = 1.25,
        trapezoid = 0.5,
        flat = 0.01; // ratio of the diagonals; distance of their midpoints, and gap between them, over a diagonal
    const std::vector<HalfEdge> halves = sorted_half_edges(mesh);
    std::vector<char> taken(mesh.faces.size(), 0);
    bool any = false;
    for (std::size_t i = 0, end = 0; i < halves.size(); i = end) {
        while (end < halves.size() && same_edge(halves[i], halves[end])) ++end;
        if (end - i != 2) continue;
        Face &f = mesh.faces[halves[i].face], &g = mesh.faces[halves[i + 1].face];
        const uint32_t a = f[halves[i].side], b = f[(halves[i].side + 1) % 3], c = f[(halves[i].side + 2) % 3];
        const uint32_t d = g[(halves[i + 1].side + 2) % 3];
        if (taken[halves[i].face] || taken[halves[i + 1].face] || g[halves[i + 1].side] != b) continue;
        const auto at = [&](uint32_t v) { return mesh.vertices[v]; };
        const Eigen::Vector3d diagonal = at(b) - at(a), other = at(d) - at(c), apart = at(a) + at(b) - at(c) - at(d);
        const Eigen::Vector3d normal = diagonal.cross(other).normalized();
        const double length = diagonal.norm();
        const auto is_side = [&](uint32_t v, uint32_t w) {
            return (at(v) - at(w)).norm() < std::min(length, other.norm());
        };
        if (!(other.norm() < square * length) || !(length < square * other.norm()) ||
            !(apart.norm() < trapezoid * length) || !(std::abs(apart.dot(normal)) > flat * length) || !is_side(a, c) ||
            !is_side(c, b) || !is_side(b, d) || !is_side(d, a))
            continue;
        taken[halves[i].face] = taken[halves[i + 1].face] = 1;
        f = {a, d, c};
        g = {d, b, c};
        any = true;
    }
    return any;
}

// Half of the change by swapped diagonals, since a smooth surface lies between both. Zero for many faces, where the change is small.
template <class Solve> Matrix6 diagonals_error(const Mesh& mesh, const Solve& solve) {
    constexpr std::size_t few = 1000;
    Mesh swapped = mesh;
    AddedMass first, second;
    if (mesh.faces.size() > few || !swap_diagonals(swapped) || !solve(mesh, first) || !solve(swapped, second))
        return Matrix6::Zero();
    return 0.5 * (first.value - second.value).cwiseAbs();
}

CurvedSurface as_facets(const Mesh& mesh) {
    const std::vector<double> zeros(mesh.faces.size(), 0.0);
    return {mesh, zeros, zeros, std::vector<Eigen::Matrix3d>(mesh.faces.size(), Eigen::Matrix3d::Zero()), zeros};
}

bool solve_solid(const CurvedSurface& surface, const Doubts& doubts, GeometryErrors& geometry, AddedMass& out,
                 Faults& faults, const AddedMassOptions& options, const Progress& report) {
    return solve_surface(surface.mesh, closed_basis(surface.mesh), &surface, doubts, geometry, out, faults, options,
                         report);
}
} // namespace

bool compute_added_mass(const Mesh& mesh, const Eigen::Vector3d& centre, AddedMass& out, Faults& faults,
                        const Progress& progress, const AddedMassOptions& options) {
    if (!check_size(mesh, faults)) return false;
    const double first_share = mesh.faces.size() < max_refined_panels ? 0.2 : 1.0;
    const Progress report = or_nothing(progress);
    double size = 0.0;
    const Mesh unit = scale_to_unit(mesh, centre, size);
    GeometryErrors geometry;
    Faults found;
    const CurvedSurface surface = options.as_given ? as_facets(unit) : restore_curved_volume(unit);
    const Doubts doubts(surface);
    const bool good =
        solve_solid(surface, doubts, geometry, out, found, options, [&](double f) { report(first_share * f); });
    Matrix6 reading = geometry.reading;
    bool better = !good || options.as_given || is_within(good_estimate, out);
    for (std::size_t most = max_refined_panels; !better && unit.faces.size() < most; most = most * 2 / 3) {
        std::vector<uint32_t> origin;
        const Mesh fine = refine(unit, most, origin);
        if (fine.faces.size() <= unit.faces.size()) break;
        AddedMass refined;
        Faults found_then;
        // Finer panels cannot tell the shape between the given vertices: the doubts stay those of the given faces.
        better = solve_solid(restore_curved_volume(fine), doubts.of(origin), geometry, refined, found_then, options,
                             [&](double f) { report(first_share + (1.0 - first_share) * f); });
        if (better) {
            out = refined;
            reading = geometry.reading; // doubts of the given faces, with the velocity of the finer panels
            found = found_then;
        } else if (found_then.back().id != FaultId::mesh_too_many_faces) {
            break;
        }
    }
    const bool poor = good && !better && !options.patient && !is_within(poor_estimate, out, poor_rotation);
    if (poor)
        refuse_costly(faults);
    else
        faults.insert(faults.end(), found.begin(), found.end());
    if (!good) return false;
    if (!options.as_given)
        reading += diagonals_error(unit, [&](const Mesh& faces, AddedMass& m) {
            Faults unread;
            GeometryErrors unused;
            const CurvedSurface facets = as_facets(faces);
            return solve_solid(facets, Doubts(facets), unused, m, unread, options, [](double) {});
        });
    // The errors of shape and of discretisation are independent: squares add.
    out.error = (out.error.array().square() + reading.array().square()).sqrt().matrix().eval();
    scale_to_size(size, out);
    report(1.0);
    return !poor;
}

bool compute_sheet_added_mass(const Mesh& mesh, const Eigen::Vector3d& centre, const Refinement& refinement,
                              AddedMass& out, Faults& faults, const Progress& progress,
                              const AddedMassOptions& options) {
    if (!check_size(mesh, faults)) return false;
    const Progress report = or_nothing(progress);
    double size = 0.0;
    const Mesh unit = scale_to_unit(mesh, centre, size);
    const auto solve = [&](const Mesh& panels, AddedMass& m, Faults& found, bool patient, double from, double to) {
        GeometryErrors geometry;
        AddedMassOptions how = options;
        how.patient = patient;
        if (!patient && panels.faces.size() > std::max(few_panels, few_panels_each * unit.faces.size())) {
            refuse_costly(found);
            return false;
        }
        return solve_surface(panels, sheet_basis(panels), nullptr, {}, geometry, m, found, how,
                             [&](double f) { report(from + (to - from) * f); });
    };
    Faults found;
    bool good = solve(refine_sheet(unit, refinement), out, found, options.patient, 0.0, 0.4);
    if (good && refinement.strips < Refinement{}.strips) out.error *= rim_doubt;
    if (!options.as_given && !(good && is_within(rough_sheet, out))) {
        Refinement how = refinement;
        how.strips = 1;
        how.panels = least_halved;
        const Mesh whole = refine_sheet(unit, how);
        how.strips = 2;
        const Mesh cut = refine_sheet(unit, how);
        how.panels = 4 * whole.faces.size();
        AddedMass m[3];
        Faults found_then;
        if (how.panels <= most_quartered && solve(refine_sheet(unit, how), m[2], found_then, false, 0.4, 0.8) &&
            solve(whole, m[0], found_then, false, 0.8, 0.85) && solve(cut, m[1], found_then, false, 0.85, 1.0)) {
            const AddedMass limit = extrapolated(m[0], m[1], m[2]);
            if (!good || limit.largest_share() < out.largest_share()) out = limit, found = found_then;
            good = true;
        }
    }
    faults.insert(faults.end(), found.begin(), found.end());
    if (!good) return false;
    if (!options.as_given)
        out.error += diagonals_error(unit, [&](const Mesh& faces, AddedMass& m) {
            Faults unread;
            return solve(refine_sheet(faces, {least_halved, 2}), m, unread, false, 1.0, 1.0);
        });
    scale_to_size(size, out);
    report(1.0);
    return true;
}
} // namespace lr::baker
