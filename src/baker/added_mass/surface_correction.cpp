#include "baker/added_mass/surface_correction.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lr::baker {
namespace {

// Largest motion of a vertex over its shortest edge: a limit for meshes that are rough instead of curved.
constexpr double max_share = 0.1;

struct Corner {
    uint32_t face;
    uint32_t index; // 0, 1, 2
};

class Correction {
public:
    explicit Correction(const Mesh& mesh)
        : mesh_(mesh), area_(mesh.faces.size()), normal_(mesh.faces.size()), corner_normal_(mesh.faces.size()),
          offset_(mesh.faces.size()), turn_(mesh.faces.size(), 0.0), start_(mesh.vertices.size() + 1, 0),
          corners_(3 * mesh.faces.size()) {
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
        for (std::size_t i = 0; i < mesh_.faces.size(); ++i) offset_[i] = mean_gap(i);
        CurvedSurface result{mesh_, offset_, turn_};
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
            CornerNormal normal{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
            for (const Corner& c : group) {
                const Face& f = mesh_.faces[c.face];
                const Eigen::Vector3d a = at(f[(c.index + 1) % 3]) - at(vertex),
                                      b = at(f[(c.index + 2) % 3]) - at(vertex);
                normal.round += a.cross(b) / (a.squaredNorm() * b.squaredNorm());
                normal.broad += a.cross(b);
            }
            normal.round.normalize();
            normal.broad.normalize();
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

    // A surface with second fundamental form II is above its triangle by 1/2 sum lambda_a lambda_b II(e_ab, e_ab), on average
    // 1/24 sum II(e, e). II(e, e) is the change of the normal along edge e, to second order.
    double mean_gap(std::size_t face) {
        double gap = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            const CornerNormal &from = corner_normal_[face][k], &to = corner_normal_[face][next];
            gap += bend(from, to, at(mesh_.faces[face][next]) - at(mesh_.faces[face][k]));
            turn_[face] = std::max(turn_[face], (to.round - from.round).norm());
        }
        return gap / 24.0;
    }

    // On a crease each side has its own offset along its own normal: least squares, without motion along the
    // crease.
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
    std::vector<double> offset_;
    std::vector<double> turn_;
    std::vector<std::size_t> start_;
    std::vector<Corner> corners_;
};
} // namespace

Eigen::Vector3d least_motion(const Eigen::Matrix3d& normal_matrix, const Eigen::Vector3d& right) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(normal_matrix);
    Eigen::Vector3d move = Eigen::Vector3d::Zero();
    for (Eigen::Index k = 0; k < 3; ++k)
        if (solver.eigenvalues()[k] > 0.01)
            move += solver.eigenvectors().col(k) * (solver.eigenvectors().col(k).dot(right) / solver.eigenvalues()[k]);
    return move;
}

double bend(const CornerNormal& from, const CornerNormal& to, const Eigen::Vector3d& along) {
    // Sufficient for meshes graded by thirds; a long straight side between tight bends stays straight.
    constexpr double most_broad = 1.5, most_other_end = 3.0;
    const auto limited = [](double x, double limit) {
        return x * limit <= 0.0 ? 0.0 : std::abs(x) < std::abs(limit) ? x : limit;
    };
    const double start = -limited(from.round.dot(along), most_broad * from.broad.dot(along));
    const double end = limited(to.round.dot(along), most_broad * to.broad.dot(along));
    return limited(start, most_other_end * end) + limited(end, most_other_end * start);
}

std::vector<std::array<CornerNormal, 3>> corner_normals(const Mesh& mesh) {
    return Correction(mesh).normals();
}

CurvedSurface restore_curved_volume(const Mesh& mesh) {
    return Correction(mesh).run();
}
} // namespace lr::baker
