#include "baker/added_mass.h"

#include "baker/boundary_operators.h"
#include "baker/single_cholesky.h"
#include "baker/surface_correction.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

// The potential phi of a moving body, grad phi . n = q on its surface, from the hypersingular integral equation
//   W phi = -(1/2 + K') q
// with continuous linear elements, tested by the same elements (Galerkin). W goes over to integrals of 1/r between
// surface curls (Maue 1949, Nedelec 1982), so that constant panels of closed form suffice, the matrix is symmetric and
// positive, and the energy - the added mass, -integral phi q - converges twice as fast as phi. Unlike equations of the
// second kind it stays well posed for a thin solid, where the doublets of both sides nearly cancel.

namespace lr::baker {
namespace {

constexpr std::size_t max_panels = 8000;
// Condition of the scaled matrix above which less than about six digits of phi are left.
constexpr double max_condition = 1e10;

// What the quadrature over neighbouring panels leaves on a sphere, whatever the number of panels.
constexpr double quadrature_floor = 5e-4;

using Matrix6 = Eigen::Matrix<double, 6, 6>;

// The constant on each closed part of the surface carries no energy: W is singular in these directions. Adds a square
// of the mean over the part, which fixes the constant and changes no added mass.
void fix_constants(const Mesh& mesh, const std::vector<Panel>& panels, Eigen::MatrixXd& matrix) {
    std::vector<uint32_t> root(mesh.vertices.size());
    std::iota(root.begin(), root.end(), 0U);
    const auto find = [&](uint32_t v) {
        while (root[v] != v) v = root[v] = root[root[v]];
        return v;
    };
    for (const Face& f : mesh.faces)
        for (std::size_t k = 1; k < 3; ++k) {
            const uint32_t a = find(f[0]), b = find(f[k]);
            root[std::max(a, b)] = std::min(a, b);
        }
    Eigen::VectorXd weight = Eigen::VectorXd::Zero(matrix.rows());
    for (std::size_t i = 0; i < panels.size(); ++i)
        for (const uint32_t v : mesh.faces[i]) weight[v] += panels[i].area / 3.0;
    const double scale = matrix.diagonal().mean();
    for (uint32_t part = 0; part < root.size(); ++part) {
        if (root[part] != part) continue;
        std::vector<Eigen::Index> members;
        double square = 0.0;
        for (uint32_t v = 0; v < root.size(); ++v)
            if (find(v) == part) {
                members.push_back(v);
                square += weight[v] * weight[v];
            }
        const double factor = scale * 0.1 * static_cast<double>(members.size()) / square;
        for (const Eigen::Index column : members)
            for (const Eigen::Index row : members) matrix(row, column) += factor * weight[row] * weight[column];
    }
}

using Currents = Eigen::Matrix<double, 3, 6>; // n x grad phi on one panel, one column for each mode

std::vector<Currents> surface_currents(const Mesh& mesh, const std::vector<Panel>& panels, const RigidModes& phi) {
    std::vector<Currents> currents(panels.size(), Currents::Zero());
    for (std::size_t t = 0; t < panels.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) currents[t] += hat_curl(panels[t], k) * phi.row(mesh.faces[t][k]);
    return currents;
}

// What linear elements miss: the energy of the difference between the surface current and its average at the vertices
// (Zienkiewicz and Zhu 1987), each panel with its own inductance. Panels influence each other, hence a factor: on cubes
// of 192 to 4800 triangles the error is 1.4 to 1.7 times the sum, on thin plates 0.3 times.
Matrix6 discretisation_error(const Mesh& mesh, const BoundaryOperators& op, const std::vector<Currents>& currents) {
    constexpr double factor = 1.8;
    std::vector<Currents> vertex_current(mesh.vertices.size(), Currents::Zero());
    std::vector<double> weight(mesh.vertices.size(), 0.0);
    for (std::size_t t = 0; t < op.panels.size(); ++t)
        for (const uint32_t v : mesh.faces[t]) {
            vertex_current[v] += op.panels[t].area * currents[t];
            weight[v] += op.panels[t].area;
        }
    Matrix6 error = Matrix6::Zero();
    for (std::size_t t = 0; t < op.panels.size(); ++t) {
        const Panel& panel = op.panels[t];
        Currents total = Currents::Zero();
        Matrix6 squares = Matrix6::Zero();
        for (const uint32_t v : mesh.faces[t]) {
            Currents smooth = vertex_current[v] / weight[v];
            smooth -= panel.normal * (panel.normal.transpose() * smooth).eval();
            const Currents difference = smooth - currents[t];
            total += difference;
            squares += difference.transpose() * difference;
        }
        error += factor / 12.0 * op.self[t] * (squares + total.transpose() * total);
    }
    return error;
}

// What flat panels miss of a curved surface. Moving the surface out by d changes the energy by d times the square of
// the velocity along it, seen from the body (Hadamard); the part of the gap that restore_curved_volume cannot know is
// of second order in the turn of the normal over a panel.
Matrix6 geometry_error(const BoundaryOperators& op, const std::vector<Currents>& currents,
                       const CurvedSurface& surface) {
    constexpr double factor = 0.5; // from ellipsoids up to 1:20 and 10:1
    Matrix6 error = Matrix6::Zero();
    for (std::size_t t = 0; t < op.panels.size(); ++t) {
        const Panel& panel = op.panels[t];
        Currents slip = currents[t]; // n x (grad phi - velocity of the body)
        for (Eigen::Index k = 0; k < 3; ++k) {
            const Eigen::Vector3d axis = Eigen::Vector3d::Unit(k);
            slip.col(k) -= panel.normal.cross(axis);
            slip.col(k + 3) -= panel.normal.cross(axis.cross(panel.centroid));
        }
        const double unknown = std::abs(surface.gap[t]) * std::min(1.0, surface.turn[t] * surface.turn[t]);
        error += factor * panel.area * unknown * (slip.transpose() * slip);
    }
    return error;
}

// Nearest matrix without negative eigenvalues; returns the largest one removed.
double clamp_to_positive(Matrix6& matrix) {
    const Eigen::SelfAdjointEigenSolver<Matrix6> solver(matrix);
    const double lowest = solver.eigenvalues()[0];
    if (lowest >= 0.0) return 0.0;
    const Matrix6 vectors = solver.eigenvectors();
    const Matrix6 result = vectors * solver.eigenvalues().cwiseMax(0.0).asDiagonal() * vectors.transpose();
    matrix = 0.5 * (result + result.transpose());
    return -lowest;
}

// What an entry is to be compared with, for a body of size one: the largest of the diagonal of each block. The turning
// of a round body has no added mass of its own; it is compared with a hundredth of the mass.
Matrix6 entry_scale(const Matrix6& matrix) {
    const double mass = std::max(matrix.diagonal().head<3>().maxCoeff(), 1e-300);
    Eigen::Matrix<double, 6, 1> scale;
    scale.head<3>().setConstant(std::sqrt(mass));
    scale.tail<3>().setConstant(std::sqrt(std::max(matrix.diagonal().tail<3>().maxCoeff(), 0.01 * mass)));
    return scale * scale.transpose();
}

struct Solution {
    Eigen::MatrixXd value;
    double condition = 0.0, residual = 0.0;
};

// Largest norm of a column of the inverse, from below and nearly always close (Hager 1984, SIAM J. Sci. Stat. Comput. 5).
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

// Iterative refinement: each round divides the residual by about 1e7 over the condition, until rounding in the residual
// itself stops it.
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

} // namespace

bool compute_added_mass(const Mesh& mesh, const Eigen::Vector3d& centre, AddedMass& out, Faults& faults,
                        const Progress& progress) {
    if (mesh.faces.size() > max_panels) {
        faults.push_back({FaultId::mesh_too_many_faces, Severity::error, "mesh",
                          "The added mass is solved for at most " + std::to_string(max_panels) +
                              " triangles, this has " + std::to_string(mesh.faces.size()) + ".",
                          "Decimate the mesh."});
        return false;
    }
    if (mesh.faces.empty()) {
        faults.push_back(
            {FaultId::mesh_empty, Severity::error, "mesh", "The mesh has no faces.", "Check the mesh before baking."});
        return false;
    }
    const auto report = [&](double fraction) {
        if (progress) progress(fraction);
    };

    // Size one around the centre: the result is the same to the last digits whatever the unit and place.
    double size = 0.0;
    for (const Eigen::Vector3d& v : mesh.vertices) size = std::max(size, (v - centre).norm());
    Mesh unit = mesh;
    for (Eigen::Vector3d& v : unit.vertices) v = (v - centre) / size;
    const CurvedSurface surface = restore_curved_volume(unit);
    unit = surface.mesh;

    BoundaryOperators op = assemble_boundary_operators(unit, report);
    // For translations the interior potential is x itself, so W x = (1/2 - K') n up to quadrature: a check that is
    // free.
    Eigen::MatrixXd position(op.moments.rows(), 3);
    for (std::size_t i = 0; i < unit.vertices.size(); ++i)
        position.row(static_cast<Eigen::Index>(i)) = unit.vertices[i].transpose();
    const Eigen::MatrixXd defect = op.hypersingular.selfadjointView<Eigen::Lower>() * position -
                                   op.moments.leftCols(3) - op.right_side.leftCols(3);

    Eigen::MatrixXd& matrix = op.hypersingular;
    fix_constants(unit, op.panels, matrix);
    const Eigen::VectorXd scaling = matrix.diagonal().cwiseSqrt().cwiseInverse();
    const bool scalable = scaling.allFinite();
    if (scalable)
        for (Eigen::Index column = 0; column < matrix.cols(); ++column)
            matrix.col(column).array() *= scaling.array() * scaling[column];
    report(0.85);
    const Eigen::MatrixXd right = scaling.asDiagonal() * op.right_side;
    Solution solution;
    if (!scalable || !(solve_refined(matrix, right, solution) || solve_in_double(matrix, right, solution))) {
        faults.push_back({FaultId::mesh_ill_conditioned, Severity::error, "mesh",
                          "The equations for the added mass are singular.",
                          "Look for faces that cross or touch each other and for needle-shaped faces; remesh."});
        return false;
    }
    const RigidModes phi = scaling.asDiagonal() * solution.value;
    out.residual = solution.residual;
    out.condition_estimate = solution.condition;

    const Matrix6 raw = -(phi.transpose() * op.moments);
    Matrix6 value = 0.5 * (raw + raw.transpose());
    const Matrix6 scale = entry_scale(value);
    out.asymmetry = ((raw - raw.transpose()).cwiseAbs().array() / scale.array()).maxCoeff();
    const double removed = clamp_to_positive(value);

    const std::vector<Currents> currents = surface_currents(unit, op.panels, phi);
    Matrix6 error = discretisation_error(unit, op, currents).cwiseAbs() + 0.5 * (raw - raw.transpose()).cwiseAbs();
    error += geometry_error(op, currents, surface).cwiseAbs() + quadrature_floor * value.cwiseAbs();
    const Eigen::Matrix<double, 6, 3> quadrature = phi.transpose() * defect;
    error.leftCols<3>() += 0.5 * quadrature.cwiseAbs();
    error.topRows<3>() += 0.5 * quadrature.cwiseAbs().transpose();

    Eigen::Matrix<double, 6, 1> units;
    units.head<3>().setConstant(std::pow(size, 1.5));
    units.tail<3>().setConstant(std::pow(size, 2.5));
    const Matrix6 unit_product = units * units.transpose(); // symmetric to the last bit, as value is
    out.value = value.cwiseProduct(unit_product);
    out.error = error.cwiseProduct(unit_product);
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

} // namespace lr::baker
