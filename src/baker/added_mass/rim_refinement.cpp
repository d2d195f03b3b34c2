#include "baker/added_mass/rim_refinement.h"

#include "baker/added_mass/mesh_edge.h"
#include "baker/added_mass/quad_diagonal.h"
#include "baker/added_mass/surface_correction.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <utility>

namespace lr::baker {
namespace {

// Panels with a smaller height over longest side are not cut.
constexpr double narrow = 0.25;
// Longest edge over that of a square as large as the mean panel. A fan of thousands of needles has enough panels, but is too coarse along them.
constexpr double most_long = 8.0;

class Refiner {
public:
    Refiner(const Mesh& mesh, bool closed, bool creases, std::vector<uint32_t> origin = {})
        : mesh_(mesh), closed_(closed), creases_(creases), origin_(std::move(origin)) {
        origin_.resize(mesh_.faces.size(), 0);
        for (uint32_t t = 0; t < mesh_.faces.size(); ++t)
            for (std::size_t k = 0; k < 3; ++k) faces_of_[side(t, k)].push_back(t);
    }

    // Halves the longest edge until there are enough panels and most_long holds.
    void halve_longest(std::size_t panels, std::size_t most_halved) {
        struct Candidate {
            float square; // single precision keeps equal edges equal when the body is turned
            Edge edge;
            bool operator<(const Candidate& other) const {
                return square != other.square ? square < other.square : edge > other.edge;
            }
        };
        std::priority_queue<Candidate> queue;
        const auto push = [&](const Edge& e) {
            queue.push({static_cast<float>((mesh_.vertices[e[0]] - mesh_.vertices[e[1]]).squaredNorm()), e});
        };
        for (const auto& [edge, faces] : faces_of_) push(edge);
        const double long_square =
            most_long * most_long * area() / static_cast<double>(std::max<std::size_t>(1, panels));
        while (!queue.empty()) {
            const bool is_long = static_cast<double>(queue.top().square) > long_square;
            if (mesh_.faces.size() >= (is_long ? std::max(most_halved, panels) : panels)) break;
            const Edge edge = queue.top().edge;
            queue.pop();
            if (!faces_of_.contains(edge)) continue;
            for (const Edge& fresh : split(edge)) push(fresh);
        }
    }

    // A panel with all corners on rims could not represent a jump of the potential, so it gets a vertex inside. Narrow sides of a thin solid stay
    // unchanged.
    void open_corners() {
        const std::vector<uint8_t> rim = find_rim();
        std::vector<Edge> chords;
        for (const auto& [edge, faces] : faces_of_)
            if (rim[edge[0]] && rim[edge[1]] && !is_sharp(edge, faces) &&
                !std::any_of(faces.begin(), faces.end(), [&](uint32_t t) { return closed_ && is_narrow(t); }))
                chords.push_back(edge);
        for (const Edge& edge : chords) split(edge);
        std::vector<uint8_t> now = find_rim();
        for (uint32_t t = 0, count = static_cast<uint32_t>(mesh_.faces.size()); t < count; ++t) {
            const Face f = mesh_.faces[t];
            if (!(now[f[0]] && now[f[1]] && now[f[2]]) || (closed_ && is_narrow(t))) continue;
            const auto middle = static_cast<uint32_t>(mesh_.vertices.size());
            mesh_.vertices.push_back((mesh_.vertices[f[0]] + mesh_.vertices[f[1]] + mesh_.vertices[f[2]]) / 3.0);
            now.push_back(0);
            mesh_.faces[t] = {f[0], f[1], middle};
            mesh_.faces.push_back({f[1], f[2], middle});
            mesh_.faces.push_back({f[2], f[0], middle});
            origin_.insert(origin_.end(), 2, origin_[t]);
        }
    }

    // Cuts panels along lines at (n/strips)^2 between the rim (0) and the next vertices (1).
    void cut_strips(std::size_t strips) {
        const std::vector<uint8_t> rim = find_rim();
        std::map<Edge, std::vector<uint32_t>> cuts; // new vertices on an edge, from the rim inwards
        // From the vertex on the rim to the inner vertex, both included.
        const auto line = [&](uint32_t from, uint32_t to) {
            auto [found, fresh] = cuts.try_emplace(make_edge(from, to));
            std::vector<uint32_t>& points = found->second;
            if (fresh) {
                points.push_back(from);
                for (std::size_t n = 1; n < strips; ++n) {
                    const double share = static_cast<double>(n * n) / static_cast<double>(strips * strips);
                    points.push_back(static_cast<uint32_t>(mesh_.vertices.size()));
                    mesh_.vertices.push_back(mesh_.vertices[from] +
                                             share * (mesh_.vertices[to] - mesh_.vertices[from]));
                }
                points.push_back(to);
            }
            return points;
        };
        std::vector<Face> faces;
        std::vector<uint32_t> origin;
        for (std::size_t t = 0; t < mesh_.faces.size(); origin.resize(faces.size(), origin_[t]), ++t) {
            const Face& f = mesh_.faces[t];
            const int on_rim = rim[f[0]] + rim[f[1]] + rim[f[2]];
            if (on_rim == 0 || on_rim == 3) {
                faces.push_back(f);
                continue;
            }
            // a: the only corner of its kind.
            std::size_t k = 0;
            while ((rim[f[k]] != 0) != (on_rim == 1)) ++k;
            const uint32_t a = f[k], b = f[(k + 1) % 3], c = f[(k + 2) % 3];
            const std::vector<uint32_t> left = on_rim == 1 ? line(a, b) : line(b, a);
            const std::vector<uint32_t> right = on_rim == 1 ? line(a, c) : line(c, a);
            for (std::size_t n = 0; n < strips; ++n) add_strip(left, right, n, on_rim == 1, faces);
        }
        mesh_.faces = std::move(faces);
        origin_ = std::move(origin);
    }

    Mesh take(std::vector<uint32_t>* origin) {
        if (origin) *origin = std::move(origin_);
        return std::move(mesh_);
    }

private:
    Edge side(uint32_t t, std::size_t k) const { return make_edge(mesh_.faces[t][k], mesh_.faces[t][(k + 1) % 3]); }

    // Panels between lines n and n + 1. fan: both lines start at one vertex; then `left` precedes `right` around the panel.
    void add_strip(const std::vector<uint32_t>& left, const std::vector<uint32_t>& right, std::size_t n, bool fan,
                   std::vector<Face>& faces) const {
        const uint32_t a = left[n], b = left[n + 1], c = right[n + 1], d = right[n];
        const auto add = [&](uint32_t p, uint32_t q, uint32_t r) {
            if (p == q || q == r || r == p) return;
            faces.push_back(fan ? Face{p, q, r} : Face{q, p, r});
        };
        if (prefers_diagonal(mesh_.vertices, a, c, b, d)) {
            add(a, b, c);
            add(a, c, d);
        } else {
            add(a, b, d);
            add(b, c, d);
        }
    }

    // Vertices where the velocity is singular.
    std::vector<uint8_t> find_rim() const {
        std::vector<uint8_t> rim(mesh_.vertices.size(), 0);
        for (const auto& [edge, faces] : faces_of_)
            if (is_sharp(edge, faces)) rim[edge[0]] = rim[edge[1]] = 1;
        return rim;
    }

    // A free edge of a sheet, or a convex crease of a solid.
    bool is_sharp(const Edge& edge, const std::vector<uint32_t>& faces) const {
        if (!closed_) return faces.size() == 1 || (creases_ && faces.size() == 2 && is_fold(edge, faces));
        const Eigen::Vector3d n = twice_area(faces[0]), m = twice_area(faces[1]);
        if (n.dot(m) > crease_cosine * n.norm() * m.norm()) return false;
        const Face& f = mesh_.faces[faces[1]];
        const uint32_t apex = f[0] != edge[0] && f[0] != edge[1]   ? f[0]
                              : f[1] != edge[0] && f[1] != edge[1] ? f[1]
                                                                   : f[2];
        return n.dot(mesh_.vertices[apex] - mesh_.vertices[edge[0]]) < 0.0;
    }

    // By the directions of both faces away from the edge, since winding is arbitrary.
    bool is_fold(const Edge& edge, const std::vector<uint32_t>& faces) const {
        const Eigen::Vector3d along = (mesh_.vertices[edge[1]] - mesh_.vertices[edge[0]]).normalized();
        std::array<Eigen::Vector3d, 2> away;
        for (std::size_t i = 0; i < 2; ++i)
            for (const uint32_t v : mesh_.faces[faces[i]])
                if (v != edge[0] && v != edge[1]) {
                    const Eigen::Vector3d to = mesh_.vertices[v] - mesh_.vertices[edge[0]];
                    away[i] = (to - to.dot(along) * along).normalized();
                }
        return away[0].dot(away[1]) > -crease_cosine;
    }

    double area() const {
        double sum = 0.0;
        for (uint32_t t = 0; t < mesh_.faces.size(); ++t) sum += 0.5 * twice_area(t).norm();
        return sum;
    }

    Eigen::Vector3d twice_area(uint32_t t) const {
        const Face& f = mesh_.faces[t];
        return (mesh_.vertices[f[1]] - mesh_.vertices[f[0]]).cross(mesh_.vertices[f[2]] - mesh_.vertices[f[0]]);
    }

    bool is_narrow(uint32_t t) const {
        double longest = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            const Edge e = side(t, k);
            longest = std::max(longest, (mesh_.vertices[e[0]] - mesh_.vertices[e[1]]).squaredNorm());
        }
        return twice_area(t).norm() < narrow * longest;
    }

    // Splits an edge at its midpoint; returns the new edges.
    std::vector<Edge> split(const Edge& edge) {
        const std::vector<uint32_t> around = faces_of_.at(edge);
        faces_of_.erase(edge);
        const auto middle = static_cast<uint32_t>(mesh_.vertices.size());
        mesh_.vertices.push_back(0.5 * (mesh_.vertices[edge[0]] + mesh_.vertices[edge[1]]));
        std::vector<Edge> fresh{make_edge(edge[0], middle), make_edge(edge[1], middle)};
        for (const uint32_t t : around) {
            std::size_t k = 0;
            while (side(t, k) != edge) ++k;
            const uint32_t a = mesh_.faces[t][k], b = mesh_.faces[t][(k + 1) % 3], c = mesh_.faces[t][(k + 2) % 3];
            const auto other = static_cast<uint32_t>(mesh_.faces.size());
            mesh_.faces[t] = {a, middle, c};
            mesh_.faces.push_back({middle, b, c});
            origin_.push_back(origin_[t]);
            std::vector<uint32_t>& moved = faces_of_.at(make_edge(b, c));
            std::replace(moved.begin(), moved.end(), t, other);
            faces_of_[make_edge(a, middle)].push_back(t);
            faces_of_[make_edge(middle, b)].push_back(other);
            const Edge inner = make_edge(middle, c);
            faces_of_[inner].insert(faces_of_[inner].end(), {t, other});
            fresh.push_back(inner);
        }
        return fresh;
    }

    Mesh mesh_;
    bool closed_, creases_;
    std::vector<uint32_t> origin_; // of each face
    std::map<Edge, std::vector<uint32_t>> faces_of_;
};

Mesh refine(Refiner refiner, const Refinement& how, std::vector<uint32_t>* origin) {
    refiner.halve_longest(how.panels, how.most_halved);
    refiner.open_corners();
    if (how.strips > 1) refiner.cut_strips(how.strips);
    return refiner.take(origin);
}
} // namespace

Mesh refine_sheet(const Mesh& mesh, const Refinement& how) {
    return refine(Refiner(mesh, false, how.creases), how, nullptr);
}

Mesh refine_solid(const Mesh& mesh, const Refinement& how, std::vector<uint32_t>* origin) {
    return refine(Refiner(mesh, true, true, origin ? *origin : std::vector<uint32_t>()), how, origin);
}
} // namespace lr::baker
