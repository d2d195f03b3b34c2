#include "baker/added_mass/surface_correction.h"

#include "baker/eigensystem.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lr::baker {
namespace {

// Largest motion of a vertex over its shortest edge: a limit for meshes that are rough rather than curved.
constexpr double max_share = 0.1;

struct Corner {
    uint32_t face;
    uint32_t index; // 0, 1, 2
};

class Correction {
public:
    explicit Correction(const Mesh& mesh)
        : mesh_(mesh), area_(mesh.faces.size()), normal_(mesh.faces.size()), corner_normal_(mesh.faces.size()),
          offset_(mesh.faces.size()), doubt_(mesh.faces.size()), tilt_(mesh.faces.size()),
          turn_(mesh.faces.size(), 0.0), start_(mesh.vertices.size() + 1, 0), corners_(3 * mesh.faces.size()) {
        for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
            const Face& f = mesh.faces[i];
            const Eigen::Vector3d twice = (at(f[1]) - at(f[0])).cross(at(f[2]) - at(f[0]));
            area_[i] = 0.5 * twice.norm();
            normal_[i] = twice / (2.0 * area_[i]);
            for (const uint32_t v : f) ++start_[v + 1];
        }
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v) start_[v + 1] += start_[v];
        std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
        for (uint32_t i = 0; i < mesh.faces.size(); ++i)
            for (uint32_t k = 0; k < 3; ++k) corners_[next[mesh.faces[i][k]]++] = {i, k};
    }

    std::vector<std::array<CornerNormal, 3>> normals() {
        for (uint32_t v = 0; v < mesh_.vertices.size(); ++v) smooth_groups(v);
        return std::move(corner_normal_);
    }

    CurvedSurface run() {
        std::vector<std::vector<std::vector<Corner>>> groups(mesh_.vertices.size());
        for (uint32_t v = 0; v < mesh_.vertices.size(); ++v) groups[v] = smooth_groups(v);
        for (std::size_t i = 0; i < mesh_.faces.size(); ++i) find_gaps(i);
        CurvedSurface result{mesh_, offset_, doubt_, tilt_, turn_};
        for (uint32_t v = 0; v < mesh_.vertices.size(); ++v) result.mesh.vertices[v] += shift(v, groups[v]);
        return result;
    }

private:
    const Eigen::Vector3d& at(uint32_t v) const { return mesh_.vertices[v]; }

    // The corners around a vertex, separated at creases; each group gets its own normal.
    std::vector<std::vector<Corner>> smooth_groups(uint32_t vertex) {
        std::vector<Corner> left(corners_.begin() + static_cast<std::ptrdiff_t>(start_[vertex]),
                                 corners_.begin() + static_cast<std::ptrdiff_t>(start_[vertex + 1]));
        std::vector<std::vector<Corner>> groups;
        while (!left.empty()) {
            std::vector<Corner> group{left.front()};
            left.erase(left.begin());
            for (std::size_t k = 0; k < group.size(); ++k)
                for (std::size_t i = 0; i < left.size();) {
                    if (!joined(group[k].face, left[i].face)) {
                        ++i;
                        continue;
                    }
                    group.push_back(left[i]);
                    left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
                }
            CornerNormal normal{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), 1.0};
            for (const Corner& c : group) {
                const Face& f = mesh_.faces[c.face];
                const Eigen::Vector3d a = at(f[(c.index + 1) % 3]) - at(vertex),
                                      b = at(f[(c.index + 2) % 3]) - at(vertex);
                normal.round += a.cross(b) / (a.squaredNorm() * b.squaredNorm());
                normal.broad += a.cross(b);
            }
            normal.round.normalize();
            normal.broad.normalize();
            normal.smooth = smoothness(group);
            for (const Corner& c : group) corner_normal_[c.face][c.index] = normal;
            groups.push_back(std::move(group));
        }
        return groups;
    }

    bool joined(uint32_t f, uint32_t g) const {
        int shared = 0;
        for (const uint32_t a : mesh_.faces[f])
            for (const uint32_t b : mesh_.faces[g]) shared += a == b;
        return shared >= 2 && normal_[f].dot(normal_[g]) > crease_cosine;
    }

    // With 16 faces or more in a full turn a mesh samples a curved surface, with 8 or fewer it has facets. The finest turn at the vertex decides: the
    // rim of a thin ellipsoid turns sharply across, but little along. Coplanar faces do not count, since they can be halves of a quadrilateral.
    double smoothness(const std::vector<Corner>& group) const {
        constexpr double round_turn = std::numbers::pi / 8.0, facet_turn = std::numbers::pi / 4.0;
        constexpr double flat = 0.1; // of the sharpest turn: edges below count less and less
        std::vector<double> turns;
        double sharpest = 0.0;
        for (const Corner& a : group)
            for (const Corner& b : group) {
                if (mesh_.faces[a.face][(a.index + 1) % 3] != mesh_.faces[b.face][(b.index + 2) % 3]) continue;
                const Eigen::Vector3d &n = normal_[a.face], &m = normal_[b.face];
                turns.push_back(std::atan2(n.cross(m).norm(), n.dot(m)));
                sharpest = std::max(sharpest, turns.back());
            }
        double smooth = 0.0;
        for (const double turn : turns)
            smooth = std::max(smooth, std::min(1.0, turn / (flat * sharpest + 1e-300)) *
                                          std::clamp((facet_turn - turn) / (facet_turn - round_turn), 0.0, 1.0));
        return smooth;
    }

    // A surface with second fundamental form II is above its triangle by 1/2 sum lambda_a lambda_b II(e_ab, e_ab), on average 1/24 sum II(e, e). To
    // second order II(e, e) is the change of the normal along edge e, times e.
    void find_gaps(std::size_t face) {
        const FaceBends bends = bends_of(mesh_, mesh_.faces[face], corner_normal_[face]);
        for (std::size_t k = 0; k < 3; ++k) {
            const CornerNormal &from = corner_normal_[face][k], &to = corner_normal_[face][(k + 1) % 3];
            offset_[face] += bends.used[k] / 24.0;
            doubt_[face] += bends.doubtful[k] / 24.0;
            turn_[face] = std::max(turn_[face], (to.round - from.round).norm());
        }
        tilt_[face] = mean_square_tilt(face, bends.doubtful);
    }

    // Mean square slope of the surface with II(e_k, e_k) = bend[k] along its three edges. At x it is II(x - centroid), and the second moment of a
    // triangle is a 36th of the sum of e_k e_k^T.
    Eigen::Matrix3d mean_square_tilt(std::size_t face, const std::array<double, 3>& bend) const {
        constexpr double steepest = 1.0;
        const Face& f = mesh_.faces[face];
        const Eigen::Vector3d e0 = at(f[1]) - at(f[0]), e1 = at(f[2]) - at(f[1]);
        const double mixed = 0.5 * (bend[2] - bend[0] - bend[1]); // II(e0, e1)
        // In the plane: products with e0 and e1 are one and zero, or zero and one.
        const Eigen::Vector3d across = normal_[face] / (2.0 * area_[face]);
        const Eigen::Vector3d dual0 = e1.cross(across), dual1 = across.cross(e0);
        const Eigen::Vector3d along0 = bend[0] * dual0 + mixed * dual1, along1 = mixed * dual0 + bend[1] * dual1;
        Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
        for (Eigen::Vector3d along : {along0, along1, Eigen::Vector3d(-along0 - along1)}) {
            if (!along.allFinite()) continue;
            if (along.norm() > steepest) along *= steepest / along.norm();
            sum += along * along.transpose() / 36.0;
        }
        return sum;
    }

    // On a crease each side has an offset along its own normal: least squares, without motion along the crease.
    Eigen::Vector3d shift(uint32_t vertex, const std::vector<std::vector<Corner>>& groups) const {
        Eigen::Matrix3d normal_matrix = Eigen::Matrix3d::Zero();
        Eigen::Vector3d right = Eigen::Vector3d::Zero();
        double shortest = std::numeric_limits<double>::infinity();
        for (const std::vector<Corner>& group : groups) {
            double weighted = 0.0, weight = 0.0;
            for (const Corner& c : group) {
                weighted += area_[c.face] * offset_[c.face];
                weight += area_[c.face];
                const Face& f = mesh_.faces[c.face];
                shortest = std::min(shortest, (at(f[(c.index + 1) % 3]) - at(vertex)).norm());
            }
            const Eigen::Vector3d& normal = corner_normal_[group[0].face][group[0].index].round;
            normal_matrix += normal * normal.transpose();
            right += normal * (weighted / weight);
        }
        const Eigen::Vector3d move = least_motion(normal_matrix, right);
        const double limit = max_share * shortest, length = move.norm();
        return length > limit ? Eigen::Vector3d(move * (limit / length)) : move;
    }

    const Mesh& mesh_;
    std::vector<double> area_;
    std::vector<Eigen::Vector3d> normal_;
    std::vector<std::array<CornerNormal, 3>> corner_normal_;
    std::vector<double> offset_, doubt_;
    std::vector<Eigen::Matrix3d> tilt_;
    std::vector<double> turn_;
    std::vector<std::size_t> start_;
    std::vector<Corner> corners_;
};
} // namespace

Eigen::Vector3d least_motion(const Eigen::Matrix3d& normal_matrix, const Eigen::Vector3d& right) {
    const Eigensystem<Eigen::Matrix3d> solver = eigensystem(normal_matrix);
    Eigen::Vector3d move = Eigen::Vector3d::Zero();
    for (Eigen::Index k = 0; k < 3; ++k)
        if (solver.values[k] > 0.01)
            move += solver.vectors.col(k) * (solver.vectors.col(k).dot(right) / solver.values[k]);
    return move;
}

FaceBends bends_of(const Mesh& mesh, const Face& face, const std::array<CornerNormal, 3>& normals) {
    // Sufficient for meshes graded by thirds. A long straight side between tight bends stays straight.
    constexpr double most_broad = 1.5, most_other_end = 3.0;
    const auto limited = [](double x, double limit) {
        return x * limit <= 0.0 ? 0.0 : std::abs(x) < std::abs(limit) ? x : limit;
    };
    FaceBends out;
    std::array<double, 3> start{}, end{};
    for (std::size_t k = 0; k < 3; ++k) {
        const CornerNormal &from = normals[k], &to = normals[(k + 1) % 3];
        const Eigen::Vector3d along = mesh.vertices[face[(k + 1) % 3]] - mesh.vertices[face[k]];
        const double first = -limited(from.round.dot(along), most_broad * from.broad.dot(along));
        const double last = limited(to.round.dot(along), most_broad * to.broad.dot(along));
        start[k] = limited(first, most_other_end * last);
        end[k] = limited(last, most_other_end * first);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        // II(a + b, a + b) <= 2 II(a, a) + 2 II(b, b) unless the surface is a saddle: a face between a flat vertex and an edge is a facet.
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        const double bend = std::abs(start[k] + end[k]);
        const double most = 2.0 * (std::abs(start[i] + end[i]) + std::abs(start[j] + end[j]));
        const double share = bend > most ? most / bend : 1.0;
        const double w = normals[k].smooth, v = normals[i].smooth;
        out.used[k] = share * (w * start[k] + v * end[k]);
        out.doubtful[k] = share * (w * (2.0 - w) * start[k] + v * (2.0 - v) * end[k]);
    }
    return out;
}

std::vector<std::array<CornerNormal, 3>> corner_normals(const Mesh& mesh) {
    return Correction(mesh).normals();
}

CurvedSurface restore_curved_volume(const Mesh& mesh) {
    return Correction(mesh).run();
}
} // namespace lr::baker
