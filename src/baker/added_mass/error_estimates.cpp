#include "baker/added_mass/error_estimates.h"

#include "baker/mesh/disjoint_sets.h"
#include "baker/mesh/half_edges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lr::baker {
namespace {

// Groups the panel corners between which the surface current is continuous: at one vertex with the same unknowns. Swapping front and back changes the
// sign of both jump and normal, so such corners are one group.
std::vector<std::array<uint32_t, 3>> group_corners(const Mesh& mesh, const SurfaceBasis& basis, std::size_t& count) {
    struct Corner {
        uint32_t vertex;
        int32_t low, high;
        uint32_t face, index;
        bool same_group(const Corner& o) const { return vertex == o.vertex && low == o.low && high == o.high; }
    };
    std::vector<Corner> corners;
    corners.reserve(3 * mesh.faces.size());
    for (uint32_t t = 0; t < mesh.faces.size(); ++t)
        for (uint32_t k = 0; k < 3; ++k) {
            const CornerUnknowns& c = basis.corners[t][k];
            corners.push_back({mesh.faces[t][k], std::min(c.plus, c.minus), std::max(c.plus, c.minus), t, k});
        }
    std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
        if (a.vertex != b.vertex) return a.vertex < b.vertex;
        if (a.low != b.low) return a.low < b.low;
        if (a.high != b.high) return a.high < b.high;
        return a.face < b.face;
    });
    std::vector<std::array<uint32_t, 3>> groups(mesh.faces.size());
    count = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (i == 0 || !corners[i].same_group(corners[i - 1])) ++count;
        groups[corners[i].face][corners[i].index] = static_cast<uint32_t>(count - 1);
    }
    return groups;
}

// Normal velocity of each rigid mode at a corner.
using Drive = Eigen::Matrix<double, 1, 6>;
Drive drive_at(const Panel& panel, std::size_t corner) {
    Drive q;
    q << panel.normal.transpose(), panel.corner[corner].cross(panel.normal).transpose();
    return q;
}

// Absolute value of a sum of estimates. Terms that cancel are known less well than their sum: on symmetric solids, zero entries are off by up to a
// tenth of them. size: sum of the absolute terms.
Matrix6 with_cancelled(const Matrix6& sum, const Matrix6& size) {
    constexpr double uncancelled = 0.1;
    return sum.cwiseAbs() + uncancelled * (size - sum.cwiseAbs());
}

constexpr double needle = 0.25; // width over length below which a panel is gradually treated as a needle

// The longest side of a panel, and the width across it.
struct Shape {
    explicit Shape(const Panel& panel)
        : side(static_cast<std::size_t>(std::max_element(panel.edge_length.begin(), panel.edge_length.end()) -
                                        panel.edge_length.begin())),
          length(panel.edge_length[side]), width(2.0 * panel.area / length) {}
    bool is_needle() const { return width < needle * length; }

    std::size_t side;
    double length, width;
};

// Second moments of area, over the area, of the row of needles that share long edges with each panel.
std::vector<Eigen::Matrix3d> spreads(const Mesh& mesh, const std::vector<Panel>& panels,
                                     const std::vector<Shape>& shapes) {
    struct Moments {
        double area = 0.0;
        Eigen::Vector3d first = Eigen::Vector3d::Zero();
        Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
    };
    const std::vector<HalfEdge> halves = sorted_half_edges(mesh);
    const auto is_long = [&](const HalfEdge& h) {
        return shapes[h.face].is_needle() && 2.0 * panels[h.face].edge_length[h.side] > shapes[h.face].length;
    };
    DisjointSets sets(panels.size());
    for (std::size_t i = 1; i < halves.size(); ++i)
        if (same_edge(halves[i - 1], halves[i]) && is_long(halves[i - 1]) && is_long(halves[i]))
            sets.join(halves[i - 1].face, halves[i].face);
    std::vector<Moments> moments(panels.size());
    for (std::size_t t = 0; t < panels.size(); ++t) {
        Moments& m = moments[sets.find(t)];
        m.area += panels[t].area;
        m.first += panels[t].area * panels[t].centroid;
        m.second += panels[t].area * panels[t].centroid * panels[t].centroid.transpose();
    }
    std::vector<Eigen::Matrix3d> out;
    for (std::size_t t = 0; t < panels.size(); ++t) {
        const Moments& m = moments[sets.find(t)];
        out.emplace_back(m.second / m.area - m.first * m.first.transpose() / (m.area * m.area));
    }
    return out;
}

} // namespace

std::vector<Currents> surface_currents(const SurfaceBasis& basis, const std::vector<Panel>& panels,
                                       const RigidModes& phi) {
    std::vector<Currents> currents(panels.size(), Currents::Zero());
    for (std::size_t t = 0; t < panels.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const CornerUnknowns& corner = basis.corners[t][k];
            if (corner.plus >= 0) currents[t] += hat_curl(panels[t], k) * phi.row(corner.plus);
            if (corner.minus >= 0) currents[t] -= hat_curl(panels[t], k) * phi.row(corner.minus);
        }
    return currents;
}

// Error of linear elements, in two parts. Potential: the energy of the difference between the surface current and its average at the vertices
// (Zienkiewicz and Zhu 1987), each panel with its own inductance. The factor is for the interaction of panels: on cubes of 192 to 4800 triangles the
// error is 1.4 to 1.7 times the sum, on thin plates 0.3 times.
// Normal velocity: elements too coarse for a flow have hardly any current, so hardly any difference. Where facets of a few panels press the fluid to
// and fro as the body spins, the error is up to 200 times the first part. There the normal velocity jumps at creases: its difference from its average
// at the vertices has the energy of a panel's own sources, times a factor measured on 148 solids (tests/baker/test_error_estimates.cpp).
Matrix6 discretisation_error(const Mesh& mesh, const SurfaceBasis& basis, const BoundaryOperators& op,
                             const std::vector<Currents>& currents) {
    constexpr double factor = 1.8, drive_factor = 2.2;
    constexpr double regular = 0.1514; // self term of a regular triangle over area and edge
    std::size_t count = 0;
    const std::vector<std::array<uint32_t, 3>> groups = group_corners(mesh, basis, count);
    std::vector<Currents> group_current(count, Currents::Zero());
    std::vector<Drive> group_drive(count, Drive::Zero());
    std::vector<double> weight(count, 0.0);
    for (std::size_t t = 0; t < op.panels.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const uint32_t g = groups[t][k];
            group_current[g] += op.panels[t].area * currents[t];
            group_drive[g] += op.panels[t].area * drive_at(op.panels[t], k);
            weight[g] += op.panels[t].area;
        }
    const std::vector<Shape> shapes(op.panels.begin(), op.panels.end());
    const std::vector<Eigen::Matrix3d> spread = spreads(mesh, op.panels, shapes);
    Matrix6 sum = Matrix6::Zero();
    for (std::size_t t = 0; t < op.panels.size(); ++t) {
        const Panel& panel = op.panels[t];
        Currents total = Currents::Zero();
        Matrix6 squares = Matrix6::Zero();
        std::array<Currents, 3> differences;
        for (std::size_t k = 0; k < 3; ++k) {
            const uint32_t g = groups[t][k];
            Currents smooth = group_current[g] / weight[g];
            smooth -= panel.normal * (panel.normal.transpose() * smooth).eval();
            const Currents difference = differences[k] = smooth - currents[t];
            total += difference;
            squares += difference.transpose() * difference;
        }
        sum += factor / 12.0 * op.self[t] * (squares + total.transpose() * total);
        if (!basis.sheet) {
            Eigen::Matrix<double, 3, 6> jumps;
            for (std::size_t k = 0; k < 3; ++k)
                jumps.row(static_cast<Eigen::Index>(k)) =
                    drive_at(panel, k) - group_drive[groups[t][k]] / weight[groups[t][k]];
            const Drive all = jumps.colwise().sum();
            sum += drive_factor / 12.0 * op.self[t] * (jumps.transpose() * jumps + all.transpose() * all);
        }
        // Needles side by side have the inductance of a surface as broad as they are long, or of their whole row if that is narrower: around a thin
        // bar they cancel. On discs of 128 to 4000 needles the error is up to 2.5 times the sum with that.
        const auto [side, length, width] = shapes[t];
        if (shapes[t].is_needle()) {
            const Currents along = differences[(side + 1) % 3] - differences[side];
            const Eigen::Vector3d axis = (panel.corner[(side + 1) % 3] - panel.corner[side]).normalized();
            const double broad = std::sqrt(12.0 * std::max(0.0, spread[t].trace() - axis.dot(spread[t] * axis)));
            sum += factor / 4.5 * (1.0 - width / (needle * length)) *
                   std::max(0.0, regular * panel.area * std::min(length, broad) - op.self[t]) * along.transpose() *
                   along;
        }
    }
    return bound_of_energy(sum);
}

Matrix6 bound_of_energy(const Matrix6& most) {
    const Eigen::Matrix<double, 6, 1> roots = most.diagonal().cwiseMax(0.0).cwiseSqrt();
    return 0.5 * (roots * roots.transpose() + most.cwiseAbs());
}

Doubts::Doubts(const CurvedSurface& surface) : gap(surface.doubt) {
    constexpr double factor = 1.0;
    for (std::size_t t = 0; t < gap.size(); ++t) {
        const Face& f = surface.mesh.faces[t];
        const Panel panel =
            make_panel(surface.mesh.vertices[f[0]], surface.mesh.vertices[f[1]], surface.mesh.vertices[f[2]]);
        // Slopes move fluid in and out on the scale of a face.
        energy.emplace_back(factor * self_interaction(panel) / (2.0 * std::numbers::pi * panel.area) * surface.tilt[t]);
    }
}

Doubts Doubts::of(const std::vector<uint32_t>& origin) const {
    Doubts out;
    for (const uint32_t t : origin) {
        out.gap.push_back(gap[t]);
        out.energy.push_back(energy[t]);
    }
    return out;
}

GeometryErrors geometry_errors(const BoundaryOperators& op, const std::vector<Currents>& currents,
                               const CurvedSurface& surface, const Doubts& doubts) {
    constexpr double factor = 0.2; // measured on ellipsoids up to 1:20 and 20:1
    // First-order changes of the inertia cancel for a body that is nearly round; those of second order remain.
    constexpr double uncancelled = 0.25;
    GeometryErrors errors;
    Matrix6 sum = Matrix6::Zero(), all = Matrix6::Zero(), slopes = Matrix6::Zero();
    double volume = 0.0, doubtful = 0.0;
    for (std::size_t t = 0; t < op.panels.size(); ++t) {
        const Panel& panel = op.panels[t];
        Currents slip = currents[t], rigid; // (grad phi - velocity of the body) x n, and that velocity
        for (Eigen::Index k = 0; k < 3; ++k) {
            const Eigen::Vector3d axis = Eigen::Vector3d::Unit(k);
            rigid.col(k) = axis;
            rigid.col(k + 3) = axis.cross(panel.centroid);
        }
        for (Eigen::Index k = 0; k < 6; ++k) slip.col(k) += panel.normal.cross(rigid.col(k));
        const Matrix6 change = panel.area * (slip.transpose() * slip - rigid.transpose() * rigid);
        errors.curved +=
            factor * std::abs(surface.gap[t]) * std::min(1.0, surface.turn[t] * surface.turn[t]) * change.cwiseAbs();
        sum += doubts.gap[t] * change;
        all += std::abs(doubts.gap[t]) * change.cwiseAbs();
        slopes += panel.area * rigid.transpose() * doubts.energy[t] * rigid;
        volume += panel.area * panel.normal.dot(panel.centroid) / 3.0;
        doubtful += panel.area * std::abs(doubts.gap[t]);
    }
    const double second = std::min(0.5, doubtful / std::max(volume, 1e-300));
    errors.reading = (1.0 + second) * with_cancelled(sum, all) + slopes.cwiseAbs();
    errors.reading.bottomRightCorner<3, 3>() += uncancelled * (all - sum.cwiseAbs()).bottomRightCorner<3, 3>();
    return errors;
}
} // namespace lr::baker
