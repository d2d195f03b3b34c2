#include "baker/mesh/exact_predicates.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <vector>

namespace lr::baker {
namespace {

constexpr double epsilon = 1.0 / 9007199254740992.0; // 2^-53
constexpr double splitter = 134217729.0;             // 2^27 + 1

int sign(double x) {
    return (x > 0.0) - (x < 0.0);
}

// A sum of non-overlapping doubles, smallest first: Shewchuk 1997, Adaptive precision floating-point arithmetic and fast
// robust geometric predicates.
class Expansion {
public:
    void add(double x) { // Shewchuk's GROW-EXPANSION, without zeros
        std::size_t kept = 0;
        for (const double part : parts_) {
            const double sum = x + part, virtual_part = sum - x;
            const double rest = (x - (sum - virtual_part)) + (part - virtual_part);
            if (rest != 0.0) parts_[kept++] = rest;
            x = sum;
        }
        parts_.resize(kept);
        if (x != 0.0) parts_.push_back(x);
    }

    void add_product(double x, double y) {
        const auto [product, rest] = multiply(x, y);
        add(rest);
        add(product);
    }

    void add_product(double x, double y, double z) {
        const auto [product, rest] = multiply(x, y);
        add_product(rest, z);
        add_product(product, z);
    }

    int sign_of_sum() const { return parts_.empty() ? 0 : sign(parts_.back()); }

private:
    struct Pair {
        double value, rest;
    };
    static Pair multiply(double x, double y) { // Dekker 1971: x y = value + rest, exactly
        const double product = x * y;
        const double cx = splitter * x, cy = splitter * y;
        const double xh = cx - (cx - x), xl = x - xh, yh = cy - (cy - y), yl = y - yh;
        return {product, xl * yl - (((product - xh * yh) - xl * yh) - xh * yl)};
    }

    std::vector<double> parts_;
};

// Adds s times the determinant of three points.
void add_determinant(Expansion& sum, double s, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                     const Eigen::Vector3d& c) {
    sum.add_product(s * a.x(), b.y(), c.z());
    sum.add_product(-s * a.x(), b.z(), c.y());
    sum.add_product(s * a.y(), b.z(), c.x());
    sum.add_product(-s * a.y(), b.x(), c.z());
    sum.add_product(s * a.z(), b.x(), c.y());
    sum.add_product(-s * a.z(), b.y(), c.x());
}
} // namespace

int orientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    const double left = (a.x() - c.x()) * (b.y() - c.y()), right = (a.y() - c.y()) * (b.x() - c.x());
    const double determinant = left - right, size = std::abs(left) + std::abs(right);
    if (size == 0.0) return 0;
    if (std::abs(determinant) > (3.0 + 16.0 * epsilon) * epsilon * size) return sign(determinant);
    Expansion sum;
    sum.add_product(a.x(), b.y());
    sum.add_product(-a.y(), b.x());
    sum.add_product(b.x(), c.y());
    sum.add_product(-b.y(), c.x());
    sum.add_product(c.x(), a.y());
    sum.add_product(-c.y(), a.x());
    return sum.sign_of_sum();
}

int orientation(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                const Eigen::Vector3d& d) {
    const Eigen::Vector3d p = b - a, q = c - a, r = d - a;
    const double xy = q.x() * r.y(), yx = q.y() * r.x(), yz = q.y() * r.z(), zy = q.z() * r.y(), zx = q.z() * r.x(),
                 xz = q.x() * r.z();
    const double determinant = p.z() * (xy - yx) + p.x() * (yz - zy) + p.y() * (zx - xz);
    const double size = (std::abs(xy) + std::abs(yx)) * std::abs(p.z()) +
                        (std::abs(yz) + std::abs(zy)) * std::abs(p.x()) +
                        (std::abs(zx) + std::abs(xz)) * std::abs(p.y());
    if (size == 0.0) return 0;
    if (std::abs(determinant) > (7.0 + 56.0 * epsilon) * epsilon * size) return sign(determinant);
    Expansion sum;
    add_determinant(sum, 1.0, b, c, d);
    add_determinant(sum, -1.0, a, c, d);
    add_determinant(sum, 1.0, a, b, d);
    add_determinant(sum, -1.0, a, b, c);
    return sum.sign_of_sum();
}
} // namespace lr::baker
