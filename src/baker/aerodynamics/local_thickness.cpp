#include "baker/aerodynamics/local_thickness.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace lr::baker {
namespace {

using Eigen::Vector3d;

constexpr double much_thicker = 4.0;  // than the thinnest quarter of the surface
constexpr double least_size = 0.03;   // smallest thickness of a lump, over the size of the body
constexpr double least_area = 0.04;   // of the surface
constexpr double farthest = 2.5;      // root mean square distances from the lump's middle
constexpr std::size_t leaf_faces = 8; // of the tree
constexpr std::size_t most_places = 100000;

struct Ray {
    Vector3d from, along;
};

// Distance to a triangle, infinity if missed (Moeller and Trumbore 1997).
double distance(const Ray& ray, const Facet& f) {
    constexpr double missed = std::numeric_limits<double>::infinity();
    const Vector3d e1 = f.at[1] - f.at[0], e2 = f.at[2] - f.at[0], p = ray.along.cross(e2), s = ray.from - f.at[0];
    const double det = e1.dot(p);
    if (det == 0.0) return missed;
    const double u = s.dot(p) / det;
    if (!(u >= 0.0 && u <= 1.0)) return missed;
    const Vector3d q = s.cross(e1);
    const double v = ray.along.dot(q) / det;
    return v >= 0.0 && u + v <= 1.0 ? e2.dot(q) / det : missed;
}

// Bounding boxes around halves of the faces. The nearest hit does not depend on the halving.
class FaceTree {
public:
    explicit FaceTree(const Part& part) : part_(part), order_(part.size()) {
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        build(0, part.size());
    }
    // Distance to the nearest face beyond least, at most most.
    double nearest(const Ray& ray, double least, double most) const {
        double best = most;
        visit(0, ray, least, best, false);
        return best;
    }
    bool hits(const Ray& ray, double least, double most) const { return visit(0, ray, least, most, true); }

private:
    struct Node {
        Eigen::AlignedBox3d box;
        std::size_t begin, end, right; // right: index of the second child, 0 for a leaf
    };
    std::size_t build(std::size_t begin, std::size_t end) {
        const std::size_t at = nodes_.size();
        nodes_.push_back({{}, begin, end, 0});
        Eigen::AlignedBox3d box, middles;
        for (std::size_t i = begin; i < end; ++i) {
            for (const Vector3d& corner : part_[order_[i]].at) box.extend(corner);
            middles.extend(part_[order_[i]].middle());
        }
        nodes_[at].box = box;
        if (end - begin <= leaf_faces) return at;
        Eigen::Index axis = 0;
        middles.sizes().maxCoeff(&axis);
        const std::size_t half = begin + (end - begin) / 2;
        const auto place = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
        std::nth_element(place(begin), place(half), place(end), [&](std::size_t a, std::size_t b) {
            const double x = part_[a].middle()[axis], y = part_[b].middle()[axis];
            return x != y ? x < y : a < b;
        });
        build(begin, half);
        const std::size_t right = build(half, end);
        nodes_[at].right = right;
        return at;
    }
    // Whether any face is hit at a distance up to best; with any the search ends there.
    bool visit(std::size_t at, const Ray& ray, double least, double& best, bool any) const {
        const Node& node = nodes_[at];
        double enter = 0.0, leave = best;
        for (Eigen::Index k = 0; k < 3; ++k) {
            if (ray.along[k] == 0.0) {
                if (ray.from[k] < node.box.min()[k] || ray.from[k] > node.box.max()[k]) return false;
                continue;
            }
            const double a = (node.box.min()[k] - ray.from[k]) / ray.along[k];
            const double b = (node.box.max()[k] - ray.from[k]) / ray.along[k];
            enter = std::max(enter, std::min(a, b));
            leave = std::min(leave, std::max(a, b));
        }
        if (enter > leave * (1.0 + 1e-9) + 1e-300) return false;
        if (node.right) {
            const bool left = visit(at + 1, ray, least, best, any);
            return (left && any) || visit(node.right, ray, least, best, any) || left;
        }
        bool hit = false;
        for (std::size_t i = node.begin; i < node.end && !(hit && any); ++i) {
            const double t = distance(ray, part_[order_[i]]);
            if (t <= least || t > best) continue;
            best = t;
            hit = true;
        }
        return hit;
    }

    const Part& part_;
    std::vector<std::size_t> order_;
    std::vector<Node> nodes_;
};
} // namespace

std::pair<Part, Part> split_lump(const Part& part, double size) {
    const Part fine = refined(part, size / 32.0);
    const FaceTree tree(part);
    std::vector<std::pair<double, double>> sorted;
    std::vector<double> thickness;
    double area = 0.0;
    for (const Facet& f : fine) {
        const double t = tree.nearest({f.middle(), -f.normal}, 1e-9 * size, size);
        thickness.push_back(t);
        sorted.emplace_back(t, f.area);
        area += f.area;
    }
    std::sort(sorted.begin(), sorted.end());
    double passed = 0.0, thin = 0.0;
    for (const auto& [t, a] : sorted) {
        thin = t;
        passed += a;
        if (passed > 0.25 * area) break;
    }
    std::vector<char> lump(fine.size());
    for (std::size_t i = 0; i < fine.size(); ++i)
        lump[i] = thickness[i] > much_thicker * thin && thickness[i] > least_size * size;
    double lump_area = 0.0;
    for (int round = 0; round < 4; ++round) {
        Vector3d middle = Vector3d::Zero();
        double square = 0.0;
        lump_area = 0.0;
        for (std::size_t i = 0; i < fine.size(); ++i)
            if (lump[i]) {
                lump_area += fine[i].area;
                middle += fine[i].area * fine[i].middle();
            }
        if (lump_area < least_area * area || lump_area > (1.0 - least_area) * area) return {{}, part};
        middle /= lump_area;
        for (std::size_t i = 0; i < fine.size(); ++i)
            if (lump[i]) square += fine[i].area * (fine[i].middle() - middle).squaredNorm();
        const double most = farthest * farthest * square / lump_area;
        for (std::size_t i = 0; i < fine.size(); ++i)
            if ((fine[i].middle() - middle).squaredNorm() > most) lump[i] = 0;
    }
    std::pair<Part, Part> out;
    for (std::size_t i = 0; i < fine.size(); ++i) (lump[i] ? out.first : out.second).push_back(fine[i]);
    return out;
}

void find_open_sides(Part& part, double size) {
    const FaceTree tree(part);
    // Of thousands of long strips, fewer places each are enough: stations have the mean of their faces.
    double longest = size / 16.0;
    const auto places = [&] {
        std::size_t sum = 0;
        for (const Facet& f : part) sum += refined({f}, longest).size();
        return sum;
    };
    while (longest < size && places() > most_places) longest *= 2.0;
    for (Facet& f : part) {
        double area = 0.0, open = 0.0;
        for (const Facet& piece : refined({f}, longest))
            for (const double side : {1.0, -1.0}) {
                if (side < 0.0 && f.sides < 2.0) continue;
                area += piece.area;
                if (!tree.hits({piece.middle(), side * f.normal}, 1e-9 * size, size)) open += piece.area;
            }
        f.open = area > 0.0 ? open / area : 1.0;
    }
}
} // namespace lr::baker
