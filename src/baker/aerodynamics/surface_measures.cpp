#include "baker/aerodynamics/surface_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lr::shape {
namespace {

using Point = SurfaceMeasures::Point;

Point minus(const Point& a, const Point& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Point middle(const Point& a, const Point& b) {
    return {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2])};
}

// Means over a triangle of c^2 and |c|^3, with c linear from the corners' values. The mean of c^n is 2/((n+1)(n+2)) times the complete homogeneous
// polynomial of degree n.
double mean_square(const Point& c) {
    return (c[0] * c[0] + c[1] * c[1] + c[2] * c[2] + c[0] * c[1] + c[1] * c[2] + c[2] * c[0]) / 6.0;
}

double mean_cube(Point c) {
    const auto h3 = [&] {
        const double pairs = c[0] * c[0] * (c[1] + c[2]) + c[1] * c[1] * (c[2] + c[0]) + c[2] * c[2] * (c[0] + c[1]);
        return c[0] * c[0] * c[0] + c[1] * c[1] * c[1] + c[2] * c[2] * c[2] + pairs + c[0] * c[1] * c[2];
    };
    // The corner alone on its side of c = 0 comes first; the zero line cuts off a triangle with the values (c0, 0, 0).
    const auto apart = [&](size_t i) { return c[i] * c[(i + 1) % 3] < 0.0 && c[i] * c[(i + 2) % 3] < 0.0; };
    for (size_t i = 0; i < 3; ++i)
        if (apart(i)) {
            c = {c[i], c[(i + 1) % 3], c[(i + 2) % 3]};
            const double corner = c[0] / (c[0] - c[1]) * (c[0] / (c[0] - c[2])) * c[0] * c[0] * c[0];
            return std::abs(2.0 * corner - h3()) / 10.0;
        }
    // One corner is on the line, the others on either side of it: the line splits the integral into two such triangles.
    for (size_t i = 0; i < 3; ++i) {
        const double p = c[(i + 1) % 3], q = c[(i + 2) % 3];
        if (c[i] == 0.0 && p * q < 0.0) {
            const double share = p / (p - q);
            return (share * std::abs(p * p * p) + (1.0 - share) * std::abs(q * q * q)) / 10.0;
        }
    }
    return std::abs(h3()) / 10.0;
}

// Mean over a triangle of the cube of the distance to axis k, by a seven-point rule of degree five (Radon 1948) on parts no longer than half their
// distance from the axis. The integrand is smooth except on the axis, where it is so small that ten halvings leave an error of 1e-6 of the whole.
double mean_reach_cubed(const Point& a, const Point& b, const Point& c, size_t k, int halvings) {
    const size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const auto square = [&](double x, double y) { return x * x + y * y; };
    const Point centre{(a[0] + b[0] + c[0]) / 3.0, (a[1] + b[1] + c[1]) / 3.0, (a[2] + b[2] + c[2]) / 3.0};
    const auto length = [&](const Point& p, const Point& q) { return square(q[i] - p[i], q[j] - p[j]); };
    const double ab = length(a, b), bc = length(b, c), ca = length(c, a), longest = std::max({ab, bc, ca});
    if (halvings > 0 && longest > 0.25 * square(centre[i], centre[j])) {
        const auto halved = [&](const Point& p, const Point& q, const Point& top) {
            const Point m = middle(p, q);
            return 0.5 * (mean_reach_cubed(p, m, top, k, halvings - 1) + mean_reach_cubed(m, q, top, k, halvings - 1));
        };
        return ab == longest ? halved(a, b, c) : bc == longest ? halved(b, c, a) : halved(c, a, b);
    }
    const auto cube = [&](double u, double v, double w) {
        const double r2 = square(u * a[i] + v * b[i] + w * c[i], u * a[j] + v * b[j] + w * c[j]);
        return r2 * std::sqrt(r2);
    };
    const double root = std::sqrt(15.0);
    const double near = (6.0 - root) / 21.0, far = (6.0 + root) / 21.0;
    const double near_weight = (155.0 - root) / 1200.0, far_weight = (155.0 + root) / 1200.0;
    double sum = 0.225 * cube(1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0);
    for (const auto [t, weight] : {std::array{near, near_weight}, std::array{far, far_weight}})
        sum += weight * (cube(t, t, 1.0 - 2.0 * t) + cube(t, 1.0 - 2.0 * t, t) + cube(1.0 - 2.0 * t, t, t));
    return sum;
}
} // namespace

SurfaceMeasures::SurfaceMeasures(const std::array<double, 9>& axes, const Point& centre, double size)
    : axes_(axes), centre_(centre), size_(size) {
    low_.fill(std::numeric_limits<double>::infinity());
    high_.fill(-std::numeric_limits<double>::infinity());
}

void SurfaceMeasures::add(const Point& a, const Point& b, const Point& c, double sides) {
    const auto turned = [&](const Point& p) {
        const Point r = minus(p, centre_);
        Point out{};
        for (size_t k = 0; k < 3; ++k)
            out[k] = (axes_[3 * k] * r[0] + axes_[3 * k + 1] * r[1] + axes_[3 * k + 2] * r[2]) / size_;
        for (size_t k = 0; k < 3; ++k) {
            low_[k] = std::min(low_[k], out[k]);
            high_[k] = std::max(high_[k], out[k]);
        }
        return out;
    };
    const std::array<Point, 3> corner{turned(a), turned(b), turned(c)};
    const Point twice = cross(minus(corner[1], corner[0]), minus(corner[2], corner[0]));
    const double length = std::sqrt(twice[0] * twice[0] + twice[1] * twice[1] + twice[2] * twice[2]);
    if (!(length > 0.0)) return;
    const double area = 0.5 * length * sides;
    const Point n{twice[0] / length, twice[1] / length, twice[2] / length};
    surface_ += area;
    for (size_t k = 0; k < 3; ++k) {
        const size_t i = (k + 1) % 3, j = (k + 2) % 3;
        projected_[k] += area * std::abs(n[k]);
        squared_[k] += area * n[k] * n[k];
        Point speed{}; // n.(e_k x r)
        for (size_t v = 0; v < 3; ++v) speed[v] = n[j] * corner[v][i] - n[i] * corner[v][j];
        stroke2_[k] += 0.5 * area * mean_square(speed);
        stroke3_[k] += 0.5 * area * mean_cube(speed);
        rub_[k] += area * mean_reach_cubed(corner[0], corner[1], corner[2], k, 10);
    }
}

AerodynamicGeometry SurfaceMeasures::geometry() const {
    AerodynamicGeometry out;
    const double size2 = size_ * size_, size4 = size2 * size2, size5 = size4 * size_;
    out.axes = axes_;
    out.surface = surface_ * size2;
    for (size_t k = 0; k < 3; ++k) {
        out.extent[k] = std::max(0.0, high_[k] - low_[k]) * size_;
        out.area[k] = 0.5 * projected_[k] * size2;
        out.bluntness[k] = projected_[k] > 0.0 ? squared_[k] / projected_[k] : 0.0;
        out.stroke2[k] = stroke2_[k] * size4;
        out.stroke3[k] = stroke3_[k] * size5;
        out.rub[k] = rub_[k] * size5;
    }
    return out;
}
} // namespace lr::shape
