#include "baker/aerodynamics/surface_parts.h"

#include "baker/eigensystem.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace lr::baker {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Share of the area tilted by more than 60 degrees, above which a part is regrouped.
constexpr double steep_share = 0.08;
constexpr double folded = 0.03;    // mean squared sine of the tilt, above which a fold with flat sides is regrouped
constexpr double flat_sides = 0.1; // largest tilt within its sides, over that of the whole
// Root mean square height along the normal, over the root of half the area, above which a group is two walls.
constexpr double walls_apart = 0.25;
constexpr double flat_walls = 0.18; // variance of the height within the walls, over that of the group

void add(Part& part, const Vector3d& a, const Vector3d& b, const Vector3d& c, const Facet& from) {
    const double twice = (b - a).cross(c - a).norm();
    if (twice > 0.0) part.push_back({{a, b, c}, from.sides, from.normal, 0.25 * twice * from.sides, from.open});
}

// Lloyd's iteration: fits two axes to the normals. Returns the misfit; `second` marks faces of the second axis.
double two_axes(const Part& part, Vector3d a, Vector3d b, std::vector<char>& second) {
    second.assign(part.size(), 0);
    double misfit = 0.0;
    for (int round = 0; round < 20; ++round) {
        Matrix3d sum[2] = {Matrix3d::Zero(), Matrix3d::Zero()};
        misfit = 0.0;
        for (std::size_t f = 0; f < part.size(); ++f) {
            const double pa = a.dot(part[f].normal), pb = b.dot(part[f].normal);
            second[f] = pb * pb > pa * pa;
            sum[second[f] ? 1 : 0] += part[f].area * part[f].normal * part[f].normal.transpose();
            misfit += part[f].area * (1.0 - std::max(pa * pa, pb * pb));
        }
        if (sum[0].trace() <= 0.0 || sum[1].trace() <= 0.0) break;
        a = eigensystem(sum[0]).vectors.col(2);
        b = eigensystem(sum[1]).vectors.col(2);
    }
    return misfit;
}

// Divides triangles until no edge is longer; length_of gives the square of a length.
template <class Length> Part divided(const Part& part, double longest, const Length& length_of) {
    Part out, rest = part;
    while (!rest.empty()) {
        const Facet f = rest.back();
        rest.pop_back();
        std::size_t k = 0;
        double most = 0.0;
        for (std::size_t e = 0; e < 3; ++e) {
            const double length = length_of(f.at[(e + 1) % 3] - f.at[e]);
            if (length > most) {
                most = length;
                k = e;
            }
        }
        if (most <= longest * longest) {
            out.push_back(f);
            continue;
        }
        const Vector3d &a = f.at[k], &b = f.at[(k + 1) % 3], &c = f.at[(k + 2) % 3], m = 0.5 * (a + b);
        add(rest, a, m, c, f);
        add(rest, m, b, c, f);
    }
    return out;
}

// Divides in all directions or, where that gives too many triangles, along one only.
Part refined_along(const Part& part, const Vector3d& direction, double longest) {
    constexpr double most = 200000.0;
    double count = 0.0;
    for (const Facet& f : part)
        for (std::size_t e = 0; e < 3; ++e) count += (f.at[(e + 1) % 3] - f.at[e]).squaredNorm() / (longest * longest);
    if (count <= most) return refined(part, longest);
    return divided(part, longest, [&](const Vector3d& v) {
        const double x = direction.dot(v);
        return x * x;
    });
}

// Where a plane across the direction leaves this much of the area below it. Exact, or equal halves of a body would be cut unlike, as their triangles
// are.
double offset_of_area(const Part& part, const Vector3d& direction, double area) {
    struct Slope {
        std::array<double, 3> at; // of the corners, upwards
        double area;
        double below(double x) const {
            if (x <= at[0] || x >= at[2]) return x <= at[0] ? 0.0 : area;
            const double across = at[2] - at[0];
            return x < at[1] ? area * (x - at[0]) * (x - at[0]) / (across * (at[1] - at[0]))
                             : area * (1.0 - (at[2] - x) * (at[2] - x) / (across * (at[2] - at[1])));
        }
    };
    std::vector<Slope> open; // triangles between low and high
    for (const Facet& f : part) {
        Slope s{{direction.dot(f.at[0]), direction.dot(f.at[1]), direction.dot(f.at[2])}, f.area};
        std::sort(s.at.begin(), s.at.end());
        open.push_back(s);
    }
    auto [low, high] = extent_of(part, direction);
    double passed = 0.0;
    for (int round = 0; round < 50; ++round) {
        const double middle = 0.5 * (low + high);
        double below = passed;
        for (const Slope& s : open) below += s.below(middle);
        (below < area ? low : high) = middle;
        std::erase_if(open, [&](const Slope& s) {
            if (s.at[2] <= low) passed += s.area;
            return s.at[2] <= low || s.at[0] >= high;
        });
    }
    return 0.5 * (low + high);
}
} // namespace

Part part_of(const Mesh& mesh, std::size_t solid_faces) {
    Part out;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        const Face& f = mesh.faces[i];
        const double sides = i < solid_faces ? 1.0 : 2.0;
        const Vector3d &a = mesh.vertices[f[0]], &b = mesh.vertices[f[1]], &c = mesh.vertices[f[2]];
        const Vector3d across = (b - a).cross(c - a);
        const double twice = across.norm();
        if (twice > 0.0) out.push_back({{a, b, c}, sides, across / twice, 0.25 * twice * sides});
    }
    return out;
}

std::pair<Part, Part> cut(const Part& part, const Vector3d& direction, double offset) {
    std::pair<Part, Part> out;
    for (const Facet& f : part) {
        std::array<double, 3> h{};
        for (std::size_t v = 0; v < 3; ++v) h[v] = direction.dot(f.at[v]) - offset;
        const auto above = std::count_if(h.begin(), h.end(), [](double x) { return x > 0.0; });
        if (above == 0 || above == 3) {
            (above ? out.second : out.first).push_back(f);
            continue;
        }
        // k: the corner alone on its side.
        std::size_t k = 0;
        while ((h[k] > 0.0) != (above == 1)) ++k;
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        const Vector3d p = f.at[k] + (h[k] / (h[k] - h[i])) * (f.at[i] - f.at[k]);
        const Vector3d q = f.at[k] + (h[k] / (h[k] - h[j])) * (f.at[j] - f.at[k]);
        Part &alone = above == 1 ? out.second : out.first, &pair = above == 1 ? out.first : out.second;
        add(alone, f.at[k], p, q, f);
        add(pair, p, f.at[i], f.at[j], f);
        add(pair, p, f.at[j], q, f);
    }
    return out;
}

Part refined(const Part& part, double longest) {
    return divided(part, longest, [](const Vector3d& v) { return v.squaredNorm(); });
}

PartMoments moments_of(const Part& part) {
    PartMoments out;
    if (part.empty()) return out;
    const Vector3d origin = part.front().at[0];
    Vector3d first = Vector3d::Zero();
    for (const Facet& f : part) {
        out.area += f.area;
        Vector3d sum = Vector3d::Zero();
        Matrix3d squares = Matrix3d::Zero();
        for (const Vector3d& corner : f.at) {
            const Vector3d r = corner - origin;
            sum += r;
            squares += r * r.transpose();
        }
        first += f.area / 3.0 * sum;
        out.second += f.area / 12.0 * (squares + sum * sum.transpose());
        out.normals += f.area * f.normal * f.normal.transpose();
    }
    if (!(out.area > 0.0)) return out;
    first /= out.area;
    out.second = (out.second / out.area - first * first.transpose()).eval();
    out.normals /= out.area;
    out.centroid = origin + first;
    return out;
}

Vector3d common_normal(const PartMoments& moments, const Vector3d& like) {
    const Vector3d n = eigensystem(moments.normals).vectors.col(2);
    return n.dot(like) < 0.0 ? Vector3d(-n) : n;
}

std::pair<double, double> extent_of(const Part& part, const Vector3d& direction) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Facet& f : part)
        for (const Vector3d& corner : f.at) {
            const double x = direction.dot(corner);
            low = std::min(low, x);
            high = std::max(high, x);
        }
    return part.empty() ? std::pair{0.0, 0.0} : std::pair{low, high};
}

std::vector<Part> split_by_normal(Part part, std::size_t most) {
    const PartMoments m = moments_of(part);
    const Eigensystem<Matrix3d> solver = eigensystem(m.normals);
    const Vector3d n = solver.vectors.col(2), e = solver.vectors.col(1);
    const double tilt = 1.0 - solver.values[2];
    if (most < 2 || tilt < folded) return {std::move(part)};
    double steep = 0.0;
    for (const Facet& f : part)
        if (std::abs(f.normal.dot(n)) < 0.5) steep += f.area;
    // Two starts: a fold, whose sides tilt both ways from their mean; and a wing with a keel at right angles.
    std::vector<char> fold, keel;
    const double as_fold = two_axes(part, n + e, n - e, fold), as_keel = two_axes(part, n, e, keel);
    const bool is_keel = as_keel < as_fold * (1.0 - 1e-9);
    const std::vector<char>& second = is_keel ? keel : fold;
    if (steep < steep_share * m.area && std::min(as_fold, as_keel) > flat_sides * tilt * m.area)
        return {std::move(part)};
    Part halves[2];
    double area[2] = {};
    for (std::size_t f = 0; f < part.size(); ++f) {
        halves[second[f] ? 1 : 0].push_back(part[f]);
        area[second[f] ? 1 : 0] += part[f].area;
    }
    if (std::min(area[0], area[1]) < least_share * m.area) return {std::move(part)};
    const std::size_t first = area[1] > area[0] ? 1 : 0;
    std::vector<Part> out = split_by_normal(std::move(halves[first]), most - 1);
    for (Part& p : split_by_normal(std::move(halves[1 - first]), most - out.size())) out.push_back(std::move(p));
    return out;
}

std::vector<Part> split_walls(Part part) {
    const PartMoments m = moments_of(part);
    const Vector3d n = common_normal(m, Vector3d::UnitZ());
    if (n.dot(m.second * n) < 0.5 * walls_apart * walls_apart * m.area) return {std::move(part)};
    auto [below, above] = cut(part, n, n.dot(m.centroid));
    double within = 0.0;
    for (const Part* side : {&below, &above}) {
        const PartMoments s = moments_of(*side);
        within += s.area * n.dot(s.second * n);
    }
    // A long strip that is bent along its length is as high, but no two walls.
    if (within > flat_walls * m.area * n.dot(m.second * n)) return {std::move(part)};
    return {std::move(below), std::move(above)};
}

void Slicer::find_points() {
    const auto [low, high] = extent_of(part_, direction_);
    centre_ = 0.5 * (low + high), scale_ = 0.5 * (high - low);
    if (!(scale_ > 0.0)) return;
    for (const Facet& f : refined_along(part_, direction_, (high - low) / 64.0)) {
        points_.emplace_back((direction_.dot(f.middle()) - centre_) / scale_, f.area);
        area_ += f.area;
    }
    std::sort(points_.begin(), points_.end());
}

std::vector<Slice> Slicer::sliced(std::size_t n) {
    if (n > 1 && points_.empty()) find_points();
    if (points_.empty() || n < 2) return {{part_, direction_.dot(moments_of(part_).centroid)}};
    // Stieltjes' recurrence for orthogonal polynomials, and eigenvalues by Golub and Welsch (1969).
    const auto size = static_cast<Eigen::Index>(n);
    Eigen::MatrixXd jacobi = Eigen::MatrixXd::Zero(size, size);
    std::vector<double> now(points_.size(), 1.0 / std::sqrt(area_)), before(points_.size(), 0.0);
    double beta = 0.0;
    for (Eigen::Index k = 0; k < size; ++k) {
        double alpha = 0.0, square = 0.0;
        for (std::size_t i = 0; i < points_.size(); ++i)
            alpha += points_[i].second * points_[i].first * now[i] * now[i];
        jacobi(k, k) = alpha;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const double next = (points_[i].first - alpha) * now[i] - beta * before[i];
            before[i] = now[i];
            now[i] = next;
            square += points_[i].second * next * next;
        }
        beta = std::sqrt(square);
        if (!(beta > 0.0)) break;
        for (double& p : now) p /= beta;
        if (k + 1 < size) jacobi(k, k + 1) = jacobi(k + 1, k) = beta;
    }
    const Eigensystem<Eigen::MatrixXd> solver = eigensystem(jacobi);
    std::vector<Slice> out;
    Part rest = part_;
    for (Eigen::Index k = 0; k < size; ++k) {
        const double node = centre_ + scale_ * solver.values[k], first = solver.vectors(0, k);
        if (k + 1 == size) {
            out.push_back({std::move(rest), node});
            break;
        }
        auto [below, above] = cut(rest, direction_, offset_of_area(rest, direction_, first * first * area_));
        out.push_back({std::move(below), node});
        rest = std::move(above);
    }
    return out;
}

} // namespace lr::baker
