#include "baker/boundary_operators.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lr::baker {
namespace {

constexpr double four_pi = 4.0 * std::numbers::pi;
// Panels closer than this many times the sum of their radii are integrated analytically on the inner side.
constexpr double near_ratio = 1.5;

using Mode = Eigen::Matrix<double, 6, 1>;

Mode normal_velocity(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
    Mode q;
    q << normal, point.cross(normal);
    return q;
}

struct NearPair {
    uint32_t panel;
    double single_layer; // double integral of 1/r, outer rule on the row's panel
};

class Assembler {
public:
    Assembler(const Mesh& mesh, const std::function<void(double)>& progress, BoundaryOperators& out)
        : mesh_(mesh), progress_(progress), out_(out), near_(mesh.faces.size()) {}

    void run() {
        const auto vertices = static_cast<Eigen::Index>(mesh_.vertices.size());
        for (const Face& f : mesh_.faces)
            out_.panels.push_back(make_panel(mesh_.vertices[f[0]], mesh_.vertices[f[1]], mesh_.vertices[f[2]]));
        for (const Panel& panel : out_.panels) out_.self.push_back(self_interaction(panel) / four_pi);
        out_.moments = RigidModes::Zero(vertices, 6);
        out_.right_side = RigidModes::Zero(vertices, 6);
        find_edges();
        add_far_double_layer();
        for (int levels = 0; levels < 3; ++levels) rules_.push_back(dunavant_rule(levels));
        find_near_pairs();
        for (std::size_t t = 0; t < out_.panels.size(); ++t) {
            integrate_near(t);
            if (t % 64 == 0) progress_(0.1 + 0.4 * static_cast<double>(t) / static_cast<double>(out_.panels.size()));
        }
        out_.right_side -= 0.5 * out_.moments;
        assemble_hypersingular();
    }

private:
    // The rule with nodes at the middles of the edges is exact to degree 2, and neighbours share its nodes.
    void find_edges() {
        struct Half {
            uint32_t low, high, face, side;
        };
        std::vector<Half> halves;
        for (uint32_t i = 0; i < mesh_.faces.size(); ++i)
            for (uint32_t k = 0; k < 3; ++k) {
                const uint32_t a = mesh_.faces[i][k], b = mesh_.faces[i][(k + 1) % 3];
                halves.push_back({std::min(a, b), std::max(a, b), i, k});
            }
        std::sort(halves.begin(), halves.end(), [](const Half& a, const Half& b) {
            if (a.low != b.low) return a.low < b.low;
            return a.high != b.high ? a.high < b.high : a.face < b.face;
        });
        panel_edges_.resize(mesh_.faces.size());
        for (std::size_t i = 0; i < halves.size(); ++i) {
            const Half& half = halves[i];
            const bool fresh = i == 0 || half.low != halves[i - 1].low || half.high != halves[i - 1].high;
            if (fresh) {
                edges_.push_back({half.low, half.high});
                middle_.push_back(0.5 * (mesh_.vertices[half.low] + mesh_.vertices[half.high]));
            }
            panel_edges_[half.face][half.side] = static_cast<uint32_t>(edges_.size() - 1);
        }
    }

    // Every pair of edge middles, also of near panels; integrate_near takes those out again. Structure of arrays, and
    // the inner loop has no sum across lanes.
    void add_far_double_layer() {
        const std::size_t n = edges_.size();
        std::vector<Mode> flux(n, Mode::Zero());
        std::array<std::vector<double>, 3> position, normal;
        std::array<std::vector<double>, 6> sum;
        for (auto& axis : position) axis.resize(n);
        for (auto& axis : normal) axis.assign(n, 0.0);
        for (auto& mode : sum) mode.assign(n, 0.0);
        for (std::size_t e = 0; e < n; ++e)
            for (std::size_t k = 0; k < 3; ++k) position[k][e] = middle_[e][static_cast<Eigen::Index>(k)];
        for (std::size_t t = 0; t < out_.panels.size(); ++t) {
            const Panel& panel = out_.panels[t];
            for (const uint32_t e : panel_edges_[t]) {
                flux[e] += panel.area / 3.0 * normal_velocity(middle_[e], panel.normal);
                for (std::size_t k = 0; k < 3; ++k)
                    normal[k][e] += panel.area / 3.0 * panel.normal[static_cast<Eigen::Index>(k)];
            }
        }
        std::vector<double> kernel(n);
        for (std::size_t e = 0; e < n; ++e) {
            const double x = position[0][e], y = position[1][e], z = position[2][e];
            const double *px = position[0].data(), *py = position[1].data(), *pz = position[2].data();
            const double *nx = normal[0].data(), *ny = normal[1].data(), *nz = normal[2].data();
            for (std::size_t s = 0; s < n; ++s) {
                const double dx = x - px[s], dy = y - py[s], dz = z - pz[s];
                const double square = dx * dx + dy * dy + dz * dz;
                const double cube = square * std::sqrt(square);
                kernel[s] = cube > 0.0 ? (nx[s] * dx + ny[s] * dy + nz[s] * dz) / cube : 0.0;
            }
            for (std::size_t m = 0; m < 6; ++m) {
                const double q = flux[e][static_cast<Eigen::Index>(m)];
                double* const target = sum[m].data();
                for (std::size_t s = 0; s < n; ++s) target[s] += q * kernel[s];
            }
            if (e % 256 == 0) progress_(0.1 * static_cast<double>(e) / static_cast<double>(n));
        }
        // Both hat functions of an edge are 1/2 in its middle, the third of the triangle is 0.
        for (std::size_t e = 0; e < n; ++e)
            for (const uint32_t vertex : edges_[e])
                for (std::size_t m = 0; m < 6; ++m)
                    out_.right_side(vertex, static_cast<Eigen::Index>(m)) -= 0.5 / four_pi * sum[m][e];
    }

    void find_near_pairs() {
        const std::vector<Panel>& panels = out_.panels;
        level_.assign(panels.size(), 0);
        for (std::size_t t = 0; t < panels.size(); ++t) {
            double smallest = panels[t].radius;
            for (std::size_t s = 0; s < panels.size(); ++s) {
                const double reach = panels[t].radius + panels[s].radius;
                const double square = (panels[t].centroid - panels[s].centroid).squaredNorm();
                if (s == t || square > near_ratio * near_ratio * reach * reach) continue;
                near_[t].push_back({static_cast<uint32_t>(s), 0.0});
                if (square < reach * reach) smallest = std::min(smallest, panels[s].radius);
            }
            // The outer rule must see the hat functions of much finer neighbours.
            const double ratio = panels[t].radius / smallest;
            level_[t] = ratio > 3.0 ? 2 : (ratio > 1.5 ? 1 : 0);
        }
    }

    // Outer quadrature on panel t, closed forms on the panels around it. One set of outer points for all of them: the
    // double layer of a single panel of a thin body is nearly a step, only the sum over neighbours is smooth.
    void integrate_near(std::size_t t) {
        const Panel& outer = out_.panels[t];
        const TriangleRule& rule = rules_[level_[t]];
        std::vector<Eigen::Vector3d> points;
        std::vector<Mode> velocities;
        for (std::size_t g = 0; g < rule.weights.size(); ++g) {
            const Eigen::Vector3d& node = rule.nodes[g];
            points.emplace_back(node[0] * outer.corner[0] + node[1] * outer.corner[1] + node[2] * outer.corner[2]);
            velocities.emplace_back(rule.weights[g] * outer.area * normal_velocity(points.back(), outer.normal));
            for (std::size_t k = 0; k < 3; ++k)
                out_.moments.row(mesh_.faces[t][k]) +=
                    node[static_cast<Eigen::Index>(k)] * velocities.back().transpose();
        }
        for (NearPair& pair : near_[t]) {
            const Panel& inner = out_.panels[pair.panel];
            std::array<Mode, 3> sum = {Mode::Zero(), Mode::Zero(), Mode::Zero()};
            for (std::size_t g = 0; g < points.size(); ++g) {
                const PanelPotential potential = panel_potential(inner, points[g]);
                pair.single_layer += rule.weights[g] * outer.area * potential.single_layer;
                for (std::size_t k = 0; k < 3; ++k) sum[k] += potential.double_layer[k] * velocities[g];
            }
            subtract_far(t, pair.panel, sum);
            for (std::size_t k = 0; k < 3; ++k)
                out_.right_side.row(mesh_.faces[pair.panel][k]) -= sum[k].transpose() / four_pi;
        }
        std::array<Mode, 3> sum = {Mode::Zero(), Mode::Zero(), Mode::Zero()};
        subtract_far(t, t, sum);
        for (std::size_t k = 0; k < 3; ++k) out_.right_side.row(mesh_.faces[t][k]) -= sum[k].transpose() / four_pi;
    }

    void subtract_far(std::size_t t, std::size_t s, std::array<Mode, 3>& sum) const {
        const Panel &outer = out_.panels[t], &inner = out_.panels[s];
        for (std::size_t b = 0; b < 3; ++b) {
            const Eigen::Vector3d& source = middle_[panel_edges_[s][b]];
            Mode flux = Mode::Zero();
            for (const uint32_t a : panel_edges_[t]) {
                const Eigen::Vector3d d = middle_[a] - source;
                const double square = d.squaredNorm();
                const double cube = square * std::sqrt(square);
                if (cube > 0.0) flux += inner.normal.dot(d) / cube * normal_velocity(middle_[a], outer.normal);
            }
            flux *= 0.5 * outer.area / 3.0 * inner.area / 3.0;
            sum[b] -= flux;
            sum[(b + 1) % 3] -= flux;
        }
    }

    // The value whose outer rule is on the smaller panel, where the inner potential varies least.
    double near_single_layer(std::size_t t, const NearPair& pair) const {
        const std::vector<NearPair>& others = near_[pair.panel];
        const auto mirror = std::lower_bound(others.begin(), others.end(), t,
                                             [](const NearPair& p, std::size_t panel) { return p.panel < panel; });
        const double ratio = out_.panels[t].radius / out_.panels[pair.panel].radius;
        if (ratio < 0.7) return pair.single_layer;
        if (ratio > 1.0 / 0.7) return mirror->single_layer;
        return 0.5 * (pair.single_layer + mirror->single_layer);
    }

    void assemble_hypersingular() {
        const std::size_t n = out_.panels.size();
        const auto vertices = static_cast<Eigen::Index>(mesh_.vertices.size());
        std::array<std::vector<double>, 3> centroid;
        std::array<std::vector<double>, 6> moment; // second moments over the area: xx yy zz xy yz zx
        std::vector<double> area(n), single_layer(n);
        for (auto& axis : centroid) axis.resize(n);
        for (auto& component : moment) component.resize(n);
        std::vector<std::array<Eigen::Vector3d, 3>> curls(n);
        for (std::size_t t = 0; t < n; ++t) {
            const Panel& panel = out_.panels[t];
            Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
            for (std::size_t k = 0; k < 3; ++k) {
                const Eigen::Vector3d p = panel.corner[k] - panel.centroid;
                second += p * p.transpose() / 12.0;
                centroid[k][t] = panel.centroid[static_cast<Eigen::Index>(k)];
                curls[t][k] = hat_curl(panel, k);
            }
            area[t] = panel.area;
            const std::array<double, 6> parts = {second(0, 0), second(1, 1), second(2, 2),
                                                 second(0, 1), second(1, 2), second(2, 0)};
            for (std::size_t k = 0; k < 6; ++k) moment[k][t] = parts[k];
        }
        out_.hypersingular = Eigen::MatrixXd::Zero(vertices, vertices);
        Eigen::Matrix<double, 3, Eigen::Dynamic> currents(3, vertices);
        for (std::size_t t = 0; t < n; ++t) {
            far_single_layer(t, centroid, moment, area, single_layer);
            for (const NearPair& pair : near_[t]) single_layer[pair.panel] = near_single_layer(t, pair) / four_pi;
            single_layer[t] = out_.self[t];
            currents.setZero();
            for (std::size_t s = 0; s < n; ++s)
                for (std::size_t k = 0; k < 3; ++k) currents.col(mesh_.faces[s][k]) += single_layer[s] * curls[s][k];
            for (std::size_t k = 0; k < 3; ++k)
                out_.hypersingular.col(mesh_.faces[t][k]).noalias() += currents.transpose() * curls[t][k];
            if (t % 64 == 0) progress_(0.5 + 0.3 * static_cast<double>(t) / static_cast<double>(n));
        }
    }

    // Double integral of G with panel t, by centroids and second moments: error of third order in size over distance.
    static void far_single_layer(std::size_t t, const std::array<std::vector<double>, 3>& centroid,
                                 const std::array<std::vector<double>, 6>& moment, const std::vector<double>& area,
                                 std::vector<double>& result) {
        const double x = centroid[0][t], y = centroid[1][t], z = centroid[2][t], scale = area[t] / four_pi;
        const double mxx = moment[0][t], myy = moment[1][t], mzz = moment[2][t];
        const double mxy = moment[3][t], myz = moment[4][t], mzx = moment[5][t];
        const double *px = centroid[0].data(), *py = centroid[1].data(), *pz = centroid[2].data();
        const double *sxx = moment[0].data(), *syy = moment[1].data(), *szz = moment[2].data();
        const double *sxy = moment[3].data(), *syz = moment[4].data(), *szx = moment[5].data();
        const double* const a = area.data();
        double* const out = result.data();
        const std::size_t n = area.size();
        for (std::size_t s = 0; s < n; ++s) {
            const double dx = x - px[s], dy = y - py[s], dz = z - pz[s];
            const double square = dx * dx + dy * dy + dz * dz;
            const double inverse = 1.0 / std::sqrt(square); // infinite for s = t, which the caller replaces
            const double inverse2 = inverse * inverse;
            const double xx = mxx + sxx[s], yy = myy + syy[s], zz = mzz + szz[s];
            const double twice_mixed =
                2.0 * ((mxy + sxy[s]) * dx * dy + (myz + syz[s]) * dy * dz + (mzx + szx[s]) * dz * dx);
            const double along = (xx * dx * dx + yy * dy * dy + zz * dz * dz + twice_mixed) * inverse2;
            out[s] = scale * a[s] * inverse * (1.0 + 0.5 * inverse2 * (3.0 * along - (xx + yy + zz)));
        }
    }

    const Mesh& mesh_;
    const std::function<void(double)>& progress_;
    BoundaryOperators& out_;
    std::vector<std::array<uint32_t, 2>> edges_;
    std::vector<std::array<uint32_t, 3>> panel_edges_;
    std::vector<Eigen::Vector3d> middle_;
    std::vector<std::vector<NearPair>> near_;
    std::vector<std::size_t> level_;
    std::vector<TriangleRule> rules_;
};

} // namespace

BoundaryOperators assemble_boundary_operators(const Mesh& mesh, const std::function<void(double)>& progress) {
    BoundaryOperators out;
    Assembler(mesh, progress, out).run();
    return out;
}

} // namespace lr::baker
