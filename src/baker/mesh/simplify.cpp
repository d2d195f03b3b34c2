#include "baker/mesh/simplify.h"

#include "baker/mesh/body_parts.h"
#include "baker/mesh/half_edges.h"
#include "baker/mesh/mesh_check.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <queue>

namespace lr::baker {
namespace {

constexpr double most_turn = 0.7;    // least cosine between a face before and after, so that it does not turn over
constexpr double least_shape = 1e-4; // face_shape() below which a face must not become narrower

class Simplifier {
public:
    Simplifier(const Mesh& mesh, double tolerance)
        : mesh_(mesh), limit_(tolerance * tolerance), around_(mesh.vertices.size()),
          planes_(mesh.vertices.size(), Eigen::Matrix4d::Zero()), held_(mesh.vertices.size(), 0) {
        for (uint32_t t = 0; t < mesh_.faces.size(); ++t) {
            const Face& f = mesh_.faces[t];
            const Eigen::Vector3d normal = normal_of(f).normalized();
            for (const uint32_t v : f) {
                around_[v].push_back(t);
                add_plane(v, normal, at(f[0]));
            }
        }
        const std::vector<HalfEdge> halves = sorted_half_edges(mesh_);
        for (std::size_t i = 0, end = 0; i < halves.size(); i = end) {
            while (end < halves.size() && same_edge(halves[i], halves[end])) ++end;
            const uint32_t a = halves[i].low, b = halves[i].high;
            push(a, b);
            if (end - i > 2) held_[a] = held_[b] = 1;
            if (end - i != 1) continue;
            const Eigen::Vector3d across = normal_of(mesh_.faces[halves[i].face]).cross(at(b) - at(a)).normalized();
            for (const uint32_t v : {a, b}) add_plane(v, across, at(a));
        }
    }

    Mesh run() {
        while (!queue_.empty()) {
            const auto [square, a, b] = queue_.top();
            queue_.pop();
            if (!around_[a].empty() && !around_[b].empty() && !move(a, b)) move(b, a);
        }
        std::erase_if(mesh_.faces, [](const Face& f) { return f[0] == f[1]; });
        drop_unused_vertices(mesh_);
        return std::move(mesh_);
    }

private:
    struct Candidate {
        float square; // single precision keeps equal edges equal when the body is turned
        uint32_t a, b;
        bool operator<(const Candidate& o) const {
            return square != o.square ? square > o.square : std::pair(a, b) > std::pair(o.a, o.b);
        }
    };

    const Eigen::Vector3d& at(uint32_t v) const { return mesh_.vertices[v]; }
    Eigen::Vector3d normal_of(const Face& f) const { return (at(f[1]) - at(f[0])).cross(at(f[2]) - at(f[0])); }
    void push(uint32_t a, uint32_t b) {
        queue_.push({static_cast<float>((at(a) - at(b)).squaredNorm()), std::min(a, b), std::max(a, b)});
    }
    void add_plane(uint32_t v, const Eigen::Vector3d& normal, const Eigen::Vector3d& point) {
        const Eigen::Vector4d plane(normal.x(), normal.y(), normal.z(), -normal.dot(point));
        planes_[v] += plane * plane.transpose();
    }

    std::vector<uint32_t> neighbours(uint32_t v) const {
        std::vector<uint32_t> out;
        for (const uint32_t t : around_[v])
            for (const uint32_t w : mesh_.faces[t])
                if (w != v) out.push_back(w);
        std::sort(out.begin(), out.end());
        return out;
    }
    // around: neighbours(). An edge with one face names its other end only once.
    static bool on_rim(const std::vector<uint32_t>& around) {
        for (std::size_t i = 0, end = 0; i < around.size(); i = end) {
            while (end < around.size() && around[end] == around[i]) ++end;
            if (end - i == 1) return true;
        }
        return false;
    }

    // Collapses the edge from `from` to `to`, unless that changes the surface.
    bool move(uint32_t from, uint32_t to) {
        if (held_[from]) return false;
        const Eigen::Vector4d place = at(to).homogeneous();
        if (place.dot(planes_[from] * place) > limit_) return false;
        for (const uint32_t t : around_[from]) {
            Face f = mesh_.faces[t];
            if (std::count(f.begin(), f.end(), to) > 0) continue;
            const Eigen::Vector3d before = normal_of(f);
            const double shape = face_shape(mesh_, f);
            std::replace(f.begin(), f.end(), from, to);
            const Eigen::Vector3d after = normal_of(f);
            if (before.dot(after) < most_turn * before.norm() * after.norm() ||
                face_shape(mesh_, f) < 0.9 * std::min(shape, least_shape))
                return false;
        }
        // Common neighbours other than the corners of the faces between the two would pinch the surface.
        std::vector<uint32_t> a = neighbours(from), b = neighbours(to);
        const auto between = std::count(a.begin(), a.end(), to);
        if (between == 2 && on_rim(a) && on_rim(b)) return false;
        a.erase(std::unique(a.begin(), a.end()), a.end());
        b.erase(std::unique(b.begin(), b.end()), b.end());
        std::vector<uint32_t> common;
        std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
        // At least two faces must stay, of a closed surface more.
        if (common.size() != static_cast<std::size_t>(between) ||
            a.size() + b.size() - common.size() < static_cast<std::size_t>(between) + 3)
            return false;
        for (const uint32_t t : around_[from]) {
            Face& f = mesh_.faces[t];
            if (std::count(f.begin(), f.end(), to) > 0) {
                for (const uint32_t v : f)
                    if (v != from) std::erase(around_[v], t);
                f = {};
            } else {
                std::replace(f.begin(), f.end(), from, to);
                around_[to].push_back(t);
            }
        }
        around_[from].clear();
        planes_[to] += planes_[from];
        for (const uint32_t v : a)
            if (v != to) push(v, to);
        return true;
    }

    Mesh mesh_;
    double limit_;
    std::vector<std::vector<uint32_t>> around_; // faces at each vertex
    // Quadric of each vertex: sum of squared distances from the planes of its faces.
    std::vector<Eigen::Matrix4d> planes_;
    std::vector<char> held_;
    std::priority_queue<Candidate> queue_;
};
} // namespace

Mesh simplified(const Mesh& mesh, double tolerance) {
    return Simplifier(mesh, tolerance).run();
}
} // namespace lr::baker
