#include "baker/mesh/self_intersection.h"

#include "baker/mesh/exact_predicates.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace lr::baker {
namespace {

using Vector = Eigen::Vector3d;
using Triangle = std::array<Vector, 3>;

constexpr std::size_t leaf_faces = 4;
// Tests per face after which the search gives up; takes seconds. A valid surface needs about 30.
constexpr std::size_t most_tests = 1000;
// Bound of the rounding of a projection relative to the coordinates; a larger gap is real.
constexpr double projection_rounding = 1e-14;

bool flat_segments_meet(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                        const Eigen::Vector2d& d) {
    const int abc = orientation(a, b, c), abd = orientation(a, b, d);
    const int cda = orientation(c, d, a), cdb = orientation(c, d, b);
    if (abc * abd > 0 || cda * cdb > 0) return false;
    const auto overlap = [](double p, double q, double r, double s) {
        return std::max(p, q) >= std::min(r, s) && std::max(r, s) >= std::min(p, q);
    };
    return overlap(a.x(), b.x(), c.x(), d.x()) && overlap(a.y(), b.y(), c.y(), d.y());
}

bool segment_meets_in_plane(const Vector& s, const Vector& t, const Triangle& f) {
    for (int axis = 0; axis < 3; ++axis) {
        const auto flat = [&](const Vector& v) { return Eigen::Vector2d(v[(axis + 1) % 3], v[(axis + 2) % 3]); };
        const Eigen::Vector2d a = flat(f[0]), b = flat(f[1]), c = flat(f[2]), p = flat(s), q = flat(t);
        const int turn = orientation(a, b, c);
        if (turn == 0) continue; // projects onto a line
        if (flat_segments_meet(p, q, a, b) || flat_segments_meet(p, q, b, c) || flat_segments_meet(p, q, c, a))
            return true;
        return orientation(a, b, p) == turn && orientation(b, c, p) == turn && orientation(c, a, p) == turn;
    }
    return false;
}

// Closed segment and closed triangle.
bool segment_meets(const Vector& s, const Vector& t, const Triangle& f) {
    const int from = orientation(f[0], f[1], f[2], s), to = orientation(f[0], f[1], f[2], t);
    if (from * to > 0) return false;
    if (from == 0 && to == 0) return segment_meets_in_plane(s, t, f);
    const int ab = orientation(s, t, f[0], f[1]), bc = orientation(s, t, f[1], f[2]),
              ca = orientation(s, t, f[2], f[0]);
    return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

// Whether a plane separates the triangles by more than rounding: nearly always saves the exact test.
bool clearly_apart(const Triangle& a, const Triangle& b) {
    const Vector& o = a[0];
    Vector p[3], q[3];
    double size = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        p[i] = a[i] - o;
        q[i] = b[i] - o;
        size = std::max({size, a[i].cwiseAbs().maxCoeff(), b[i].cwiseAbs().maxCoeff()});
    }
    const auto separates = [&](const Vector& axis) {
        double low_p = HUGE_VAL, high_p = -HUGE_VAL, low_q = HUGE_VAL, high_q = -HUGE_VAL;
        for (std::size_t i = 0; i < 3; ++i) {
            const double u = axis.dot(p[i]), v = axis.dot(q[i]);
            low_p = std::min(low_p, u), high_p = std::max(high_p, u);
            low_q = std::min(low_q, v), high_q = std::max(high_q, v);
        }
        const double gap = projection_rounding * size * axis.cwiseAbs().sum();
        return low_p - high_q > gap || low_q - high_p > gap;
    };
    const Vector normal_p = p[1].cross(p[2]), normal_q = (q[1] - q[0]).cross(q[2] - q[0]);
    if (separates(normal_p) || separates(normal_q)) return true;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector e = p[(i + 1) % 3] - p[i], f = q[(i + 1) % 3] - q[i];
        if (separates(normal_p.cross(e)) || separates(normal_q.cross(f))) return true;
        for (std::size_t k = 0; k < 3; ++k)
            if (separates(e.cross(q[(k + 1) % 3] - q[k]))) return true;
    }
    return false;
}

// Whether two triangles with a[0] == b[0] and no other common vertex meet elsewhere.
bool meet_beyond_corner(const Triangle& a, const Triangle& b) {
    const Vector p = a[1] - a[0], q = a[2] - a[0], r = b[1] - a[0], s = b[2] - a[0];
    const Vector axis = p.normalized() + q.normalized() - r.normalized() - s.normalized();
    const double size = std::max(a[0].cwiseAbs().maxCoeff(), b[0].cwiseAbs().maxCoeff());
    const auto beyond = [&](const Vector& v, double side) {
        return side * axis.dot(v) > projection_rounding * (size + v.norm()) * axis.cwiseAbs().sum();
    };
    if (beyond(p, 1.0) && beyond(q, 1.0) && beyond(r, -1.0) && beyond(s, -1.0)) return false;
    // Both are convex, so a common ray from the corner leaves one of them first, through its far edge, inside the other.
    return segment_meets(a[1], a[2], b) || segment_meets(b[1], b[2], a);
}

// Whether two triangles with a[0] == b[0] and a[1] == b[1] are folded onto each other.
bool fold_flat(const Triangle& a, const Triangle& b) {
    const Vector edge = (a[1] - a[0]).normalized(), p = a[2] - a[0], q = b[2] - a[0];
    const Vector u = p - edge.dot(p) * edge, v = q - edge.dot(q) * edge;
    if (u.dot(v) < 0.0) return false; // normals less than a right angle apart: not folded, whatever the rounding
    return orientation(a[0], a[1], a[2], b[2]) == 0;
}

bool faces_meet(Triangle a, Triangle b) {
    std::size_t shared = 0;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = shared; k < 3; ++k)
            if (shared <= i && a[i] == b[k]) {
                std::swap(a[shared], a[i]);
                std::swap(b[shared], b[k]);
                ++shared;
                break;
            }
    switch (shared) {
    case 0:
        break;
    case 1:
        return meet_beyond_corner(a, b);
    case 2:
        return fold_flat(a, b);
    default:
        return true;
    }
    if (clearly_apart(a, b)) return false;
    for (std::size_t i = 0; i < 3; ++i)
        if (segment_meets(a[i], a[(i + 1) % 3], b) || segment_meets(b[i], b[(i + 1) % 3], a)) return true;
    return false;
}

// Bounding volume hierarchy: each node halves its faces along the longest side of the box of their centres.
class Hierarchy {
public:
    Hierarchy(const Mesh& mesh, std::size_t most) : mesh_(mesh), most_(most), faces_(mesh.faces.size()) {
        std::iota(faces_.begin(), faces_.end(), 0U);
        tests_left_ = most_tests * std::max<std::size_t>(mesh.faces.size(), 10000);
        if (!faces_.empty()) build(0, faces_.size());
    }

    SelfIntersections search() {
        if (!nodes_.empty()) within(0);
        std::sort(found_.pairs.begin(), found_.pairs.end());
        return std::move(found_);
    }

private:
    struct Node {
        Eigen::AlignedBox3d box;
        std::size_t first, end;
        std::size_t right = 0; // right child; the left child follows the node. 0: a leaf
    };

    Triangle triangle(uint32_t face) const {
        const Face& f = mesh_.faces[face];
        return {mesh_.vertices[f[0]], mesh_.vertices[f[1]], mesh_.vertices[f[2]]};
    }
    Vector middle(uint32_t face) const {
        const Triangle t = triangle(face);
        return t[0] + t[1] + t[2];
    }

    std::size_t build(std::size_t first, std::size_t end) {
        const std::size_t index = nodes_.size();
        nodes_.push_back({{}, first, end});
        Eigen::AlignedBox3d box, middles;
        for (std::size_t i = first; i < end; ++i) {
            for (const Vector& v : triangle(faces_[i])) box.extend(v);
            middles.extend(middle(faces_[i]));
        }
        nodes_[index].box = box;
        if (end - first <= leaf_faces) return index;
        Eigen::Index axis = 0;
        middles.sizes().maxCoeff(&axis);
        const auto half = static_cast<std::ptrdiff_t>((first + end) / 2);
        std::nth_element(faces_.begin() + static_cast<std::ptrdiff_t>(first), faces_.begin() + half,
                         faces_.begin() + static_cast<std::ptrdiff_t>(end), [&](uint32_t a, uint32_t b) {
                             const double p = middle(a)[axis], q = middle(b)[axis];
                             return p != q ? p < q : a < b;
                         });
        build(first, static_cast<std::size_t>(half));
        const std::size_t right = build(static_cast<std::size_t>(half), end);
        nodes_[index].right = right;
        return index;
    }

    bool done() {
        if (found_.pairs.size() < most_ && tests_left_ > 0) return false;
        found_.complete = false;
        return true;
    }

    void within(std::size_t node) {
        const Node& n = nodes_[node];
        if (n.right == 0) {
            for (std::size_t i = n.first; i < n.end; ++i)
                for (std::size_t k = i + 1; k < n.end; ++k) test(faces_[i], faces_[k]);
            return;
        }
        within(node + 1);
        within(n.right);
        between(node + 1, n.right);
    }

    void between(std::size_t a, std::size_t b) {
        const Node &p = nodes_[a], &q = nodes_[b];
        if (done() || !p.box.intersects(q.box)) return;
        --tests_left_;
        if (p.right == 0 && q.right == 0) {
            for (std::size_t i = p.first; i < p.end; ++i)
                for (std::size_t k = q.first; k < q.end; ++k) test(faces_[i], faces_[k]);
        } else if (q.right == 0 || (p.right != 0 && p.end - p.first >= q.end - q.first)) {
            between(a + 1, b);
            between(p.right, b);
        } else {
            between(a, b + 1);
            between(a, q.right);
        }
    }

    void test(uint32_t a, uint32_t b) {
        if (done()) return;
        --tests_left_;
        const Triangle p = triangle(a), q = triangle(b);
        for (int axis = 0; axis < 3; ++axis) {
            const auto [low_p, high_p] = std::minmax({p[0][axis], p[1][axis], p[2][axis]});
            const auto [low_q, high_q] = std::minmax({q[0][axis], q[1][axis], q[2][axis]});
            if (low_p > high_q || low_q > high_p) return;
        }
        if (faces_meet(p, q)) found_.pairs.push_back(std::minmax(a, b));
    }

    const Mesh& mesh_;
    const std::size_t most_;
    std::vector<uint32_t> faces_;
    std::vector<Node> nodes_;
    std::size_t tests_left_;
    SelfIntersections found_;
};
} // namespace

SelfIntersections find_self_intersections(const Mesh& mesh, std::size_t most) {
    return Hierarchy(mesh, most).search();
}
} // namespace lr::baker
