#include "baker/added_mass/panel_integrals.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lr::baker {

Panel make_panel(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    Panel panel;
    panel.corner = {a, b, c};
    panel.centroid = (a + b + c) / 3.0;
    const Eigen::Vector3d twice_area = (b - a).cross(c - a);
    panel.area = 0.5 * twice_area.norm();
    panel.normal = twice_area / (2.0 * panel.area);
    panel.radius = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Eigen::Vector3d edge = panel.corner[(k + 1) % 3] - panel.corner[k];
        panel.edge_length[k] = edge.norm();
        panel.edge_normal[k] = (edge / panel.edge_length[k]).cross(panel.normal);
        panel.radius = std::max(panel.radius, (panel.corner[k] - panel.centroid).norm());
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t opposite = (k + 1) % 3;
        panel.gradient[k] = -panel.edge_normal[opposite] * (panel.edge_length[opposite] / (2.0 * panel.area));
    }
    return panel;
}

// Line integrals: Wilton et al. 1984 (IEEE Trans. Antennas Propag. 32) and Newman 1986 (J. Eng. Math. 20). Solid angle: van
// Oosterom and Strackee 1983 (IEEE Trans. Biomed. Eng. 30). With x0 the projection of the point onto the plane, h its height,
// L_e the integral of 1/r along edge e, d_e the distance from x0 to the line of e (outward), Omega the solid angle with the
// sign of h:
//   integral 1/r = sum d_e L_e - h Omega
//   integral lambda d/dn_y (1/r) = lambda(x0) Omega - h sum (grad lambda . m_e) L_e
PanelPotential panel_potential(const Panel& panel, const Eigen::Vector3d& point) {
    std::array<Eigen::Vector3d, 3> to;
    std::array<double, 3> distance, line;
    for (std::size_t k = 0; k < 3; ++k) {
        to[k] = panel.corner[k] - point;
        distance[k] = to[k].norm();
    }
    const double height = -panel.normal.dot(to[0]);
    const double numerator = to[0].dot(to[1].cross(to[2]));
    const double denominator = distance[0] * distance[1] * distance[2] + to[0].dot(to[1]) * distance[2] +
                               to[1].dot(to[2]) * distance[0] + to[2].dot(to[0]) * distance[1];
    // In the plane the sign of the height is rounding noise; use the mean of both sides.
    const bool in_plane = std::abs(height) < 1e-13 * panel.radius;
    const double solid_angle = in_plane ? 0.0 : -2.0 * std::atan2(numerator, denominator);

    PanelPotential result;
    result.single_layer = -height * solid_angle;
    for (std::size_t k = 0; k < 3; ++k) {
        const double sum = distance[k] + distance[(k + 1) % 3];
        const double excess = sum - panel.edge_length[k];
        // On the edge L is infinite, but its factors d_e and h are zero.
        line[k] = excess > 1e-14 * sum ? std::log((sum + panel.edge_length[k]) / excess) : 0.0;
        result.single_layer += panel.edge_normal[k].dot(to[k]) * line[k];
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const double lambda = -panel.gradient[k].dot(to[(k + 1) % 3]);
        double slope = 0.0;
        for (std::size_t e = 0; e < 3; ++e) slope += panel.gradient[k].dot(panel.edge_normal[e]) * line[e];
        result.double_layer[k] = lambda * solid_angle - height * slope;
    }
    return result;
}

// Arcioni, Bressan and Perregrini 1997 (IEEE Trans. Microw. Theory Tech. 45).
double self_interaction(const Panel& panel) {
    const double half = 0.5 * (panel.edge_length[0] + panel.edge_length[1] + panel.edge_length[2]);
    double sum = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        // half - edge, without cancellation for slivers.
        const double rest =
            0.5 * (panel.edge_length[(k + 1) % 3] + panel.edge_length[(k + 2) % 3] - panel.edge_length[k]);
        sum += std::log(std::max(rest, 1e-15 * half) / half) / panel.edge_length[k];
    }
    return -4.0 / 3.0 * panel.area * panel.area * sum;
}

double square_distance(const Panel& panel, const Eigen::Vector3d& point) {
    double least = std::numeric_limits<double>::infinity();
    bool above = true;
    for (std::size_t k = 0; k < 3; ++k) {
        const Eigen::Vector3d from = point - panel.corner[k], edge = panel.corner[(k + 1) % 3] - panel.corner[k];
        above = above && panel.edge_normal[k].dot(from) <= 0.0;
        const double along = std::clamp(edge.dot(from) / edge.squaredNorm(), 0.0, 1.0);
        least = std::min(least, (from - along * edge).squaredNorm());
    }
    const double height = panel.normal.dot(point - panel.corner[0]);
    return above ? height * height : least;
}

namespace {

void add_triple(TriangleRule& rule, double a, double weight) {
    const double b = 1.0 - 2.0 * a;
    for (const Eigen::Vector3d& node : {Eigen::Vector3d(b, a, a), Eigen::Vector3d(a, b, a), Eigen::Vector3d(a, a, b)}) {
        rule.nodes.push_back(node);
        rule.weights.push_back(weight);
    }
}

std::array<Eigen::Matrix3d, 4> quarters(const Eigen::Matrix3d& corners) {
    const Eigen::Vector3d a = corners.col(0), b = corners.col(1), c = corners.col(2);
    const Eigen::Vector3d ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
    const std::array<std::array<Eigen::Vector3d, 3>, 4> parts = {{{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {bc, ca, ab}}};
    std::array<Eigen::Matrix3d, 4> out;
    for (std::size_t i = 0; i < 4; ++i) out[i] << parts[i][0], parts[i][1], parts[i][2];
    return out;
}

void add_part(const TriangleRule& rule, const Eigen::Matrix3d& corners, double share, TriangleRule& out) {
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        out.nodes.emplace_back(corners * rule.nodes[i]);
        out.weights.push_back(share * rule.weights[i]);
    }
}

void add_parts(const TriangleRule& rule, const Eigen::Matrix3d& corners, double share, int levels, TriangleRule& out) {
    if (levels == 0) return add_part(rule, corners, share, out);
    for (const Eigen::Matrix3d& quarter : quarters(corners)) add_parts(rule, quarter, 0.25 * share, levels - 1, out);
}
} // namespace

TriangleRule dunavant_rule(int levels) {
    TriangleRule rule;
    const auto add = [&](double a, double b, double c, double weight) {
        rule.nodes.emplace_back(a, b, c);
        rule.weights.push_back(weight);
    };
    add_triple(rule, 0.249286745170910421, 0.116786275726379366);
    add_triple(rule, 0.063089014491502228, 0.050844906370206817);
    const double a = 0.310352451033784405, b = 0.053145049844816947, weight = 0.082851075618373575;
    const double c = 1.0 - a - b;
    add(a, b, c, weight);
    add(a, c, b, weight);
    add(b, a, c, weight);
    add(b, c, a, weight);
    add(c, a, b, weight);
    add(c, b, a, weight);
    TriangleRule result;
    add_parts(rule, Eigen::Matrix3d::Identity(), 1.0, levels, result);
    return result;
}

std::vector<TrianglePart> triangle_parts(int levels) {
    const TriangleRule rule = dunavant_rule(0);
    std::vector<TrianglePart> out;
    std::vector<Eigen::Matrix3d> corners{Eigen::Matrix3d::Identity()};
    double size = 1.0;
    for (int level = 0; level <= levels; ++level, size *= 0.5) {
        std::vector<Eigen::Matrix3d> next;
        for (const Eigen::Matrix3d& c : corners) {
            out.push_back({{}, c.rowwise().mean(), size});
            add_part(rule, c, size * size, out.back().rule);
            for (const Eigen::Matrix3d& quarter : quarters(c)) next.push_back(quarter);
        }
        corners = std::move(next);
    }
    return out;
}

TriangleRule six_point_rule() {
    TriangleRule rule;
    add_triple(rule, 0.445948490915964886, 0.223381589678011466);
    add_triple(rule, 0.091576213509770743, 0.109951743655321868);
    return rule;
}
} // namespace lr::baker
