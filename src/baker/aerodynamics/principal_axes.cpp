#include "baker/aerodynamics/principal_axes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lr::shape {
namespace {

using Vector = std::array<double, 3>;

// Relative to the largest moment. Smaller off-diagonal entries are rounding of a mesh in single precision: zeroing them gives a body with a mirror
// plane an axis exactly normal to it.
constexpr double rounding = 1e-6;
// Moments that differ by less than this fraction of the largest count as equal.
constexpr double equal = 1e-2;

constexpr std::array<double, 9> identity{1, 0, 0, 0, 1, 0, 0, 0, 1};

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

void normalise(Vector& v) {
    const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (double& x : v) x /= length;
}

// Cyclic Jacobi rotations (Golub & Van Loan, 8.5): makes `m` diagonal and the rows of `v` its eigenvectors.
void diagonalise(std::array<double, 9>& m, std::array<Vector, 3>& v) {
    for (int sweep = 0; sweep < 32; ++sweep)
        for (size_t p = 0; p < 2; ++p)
            for (size_t q = p + 1; q < 3; ++q) {
                const double off = m[p * 3 + q];
                if (off == 0.0) continue;
                const double tau = (m[q * 4] - m[p * 4]) / (2.0 * off);
                const double t = (tau >= 0.0 ? 1.0 : -1.0) / (std::abs(tau) + std::sqrt(1.0 + tau * tau));
                const double c = 1.0 / std::sqrt(1.0 + t * t), s = t * c;
                const size_t r = 3 - p - q;
                m[p * 4] -= t * off;
                m[q * 4] += t * off;
                const double mp = m[r * 3 + p], mq = m[r * 3 + q];
                m[p * 3 + q] = m[q * 3 + p] = 0.0;
                m[r * 3 + p] = m[p * 3 + r] = c * mp - s * mq;
                m[r * 3 + q] = m[q * 3 + r] = s * mp + c * mq;
                for (size_t i = 0; i < 3; ++i) {
                    const double vp = v[p][i], vq = v[q][i];
                    v[p][i] = c * vp - s * vq;
                    v[q][i] = s * vp + c * vq;
                }
            }
}

std::array<double, 9> rows(const std::array<Vector, 3>& v) {
    std::array<double, 9> out{};
    for (size_t i = 0; i < 9; ++i) out[i] = v[i / 3][i % 3] + 0.0; // no -0
    return out;
}

// The only defined axis replaces the nearest body axis; the others stay as close to theirs as possible.
std::array<double, 9> about(Vector single) {
    size_t at = 0;
    for (size_t i = 1; i < 3; ++i)
        if (std::abs(single[i]) > std::abs(single[at])) at = i;
    if (single[at] < 0.0)
        for (double& x : single) x = -x;
    const size_t next = (at + 1) % 3;
    std::array<Vector, 3> out{};
    out[at] = single;
    for (size_t i = 0; i < 3; ++i) out[next][i] = (i == next ? 1.0 : 0.0) - single[next] * single[i];
    normalise(out[next]);
    out[(at + 2) % 3] = cross(single, out[next]);
    return rows(out);
}

// The order with the largest sum of |cosines|; the first of equal ones, which keeps cyclic order.
std::array<double, 9> in_body_order(const std::array<Vector, 3>& v) {
    constexpr size_t orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    const size_t* best = orders[0];
    double most = -1.0;
    for (const auto& order : orders) {
        double sum = 0.0;
        for (size_t i = 0; i < 3; ++i) sum += std::abs(v[order[i]][i]);
        if (sum > most + 1e-9) most = sum, best = order;
    }
    std::array<Vector, 3> out{};
    for (size_t i = 0; i < 3; ++i) {
        out[i] = v[best[i]];
        if (out[i][i] < 0.0)
            for (double& x : out[i]) x = -x;
    }
    const Vector third = cross(out[0], out[1]);
    // Far from the body axes the nearest signs can be left-handed.
    if (third[0] * out[2][0] + third[1] * out[2][1] + third[2] * out[2][2] < 0.0)
        for (double& x : out[2]) x = -x;
    return rows(out);
}

using Corners = std::vector<Eigen::Vector2d>;

double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

// The convex outline, counter-clockwise (Andrew 1979).
Corners outline_of(Corners points) {
    std::sort(points.begin(), points.end(),
              [](const auto& a, const auto& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
    Corners out;
    for (const bool upper : {false, true}) {
        const size_t first = out.size();
        for (const Eigen::Vector2d& p : points) {
            while (out.size() >= first + 2 && turn(out.back() - out[out.size() - 2], p - out.back()) <= 0.0)
                out.pop_back();
            out.push_back(p);
        }
        out.pop_back();
        if (!upper) std::reverse(points.begin(), points.end());
    }
    return out;
}

// Direction along which a rectangle around the points is smallest: that of a side of their convex outline (Freeman and Shapira 1975).
Eigen::Vector2d side_of_least_rectangle(const Corners& points) {
    constexpr double worth = 0.99;
    const Corners outline = outline_of(points);
    const auto area_along = [&](const Eigen::Vector2d& d) {
        Eigen::Array2d low(1e300, 1e300), high(-1e300, -1e300);
        for (const Eigen::Vector2d& p : outline) {
            const Eigen::Array2d at(d.dot(p), turn(d, p));
            low = low.min(at);
            high = high.max(at);
        }
        return (high - low).prod();
    };
    Eigen::Vector2d best(1.0, 0.0);
    double least = worth * area_along(best);
    // A thousand sides suffice: of more, as round rims have, none saves much.
    for (size_t i = 0; i < outline.size(); i += 1 + outline.size() / 1024) {
        const Eigen::Vector2d side = (outline[(i + 1) % outline.size()] - outline[i]).normalized();
        const double area = area_along(side);
        if (!(area < least * (1.0 - 1e-9))) continue;
        least = area;
        best = side;
    }
    // The nearest of the four directions of its sides.
    if (std::abs(best.x()) < std::abs(best.y())) best = {best.y(), -best.x()};
    return best.x() < 0.0 ? -best : best;
}
} // namespace

std::array<double, 9> principal_axes(const std::array<double, 9>& inertia) {
    const double largest = std::max({inertia[0], inertia[4], inertia[8]});
    std::array<double, 9> m;
    for (size_t i = 0; i < 9; ++i) m[i] = 0.5 * (inertia[i] + inertia[i % 3 * 3 + i / 3]) / largest;
    for (size_t i = 0; i < 9; ++i)
        if (i % 4 != 0 && std::abs(m[i]) <= rounding) m[i] = 0.0;
    if (m[1] == 0.0 && m[2] == 0.0 && m[5] == 0.0) return identity;

    std::array<Vector, 3> v{Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}};
    diagonalise(m, v);
    std::array<std::pair<double, size_t>, 3> moments{std::pair{m[0], size_t{0}}, {m[4], 1}, {m[8], 2}};
    std::sort(moments.begin(), moments.end());
    const double low = moments[1].first - moments[0].first, high = moments[2].first - moments[1].first;
    const double close = equal * moments[2].first;
    if (low <= close && high <= close) return identity;
    if (low <= close || high <= close) return about(v[moments[low <= high ? 2 : 0].second]);
    for (Vector& axis : v) normalise(axis);
    return in_body_order(v);
}

std::array<double, 9> principal_axes(const std::array<double, 9>& inertia,
                                     const std::vector<Eigen::Vector3d>& corners) {
    const std::array<double, 9> axes = principal_axes(inertia);
    using Matrix = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    Matrix e = Eigen::Map<const Matrix>(axes.data());
    const Eigen::Vector3d m = (e * Eigen::Map<const Matrix>(inertia.data()) * e.transpose()).diagonal();
    const double close = equal * m.maxCoeff();
    for (Eigen::Index k = 0; k < 3; ++k) {
        const Eigen::Index i = (k + 1) % 3, j = (k + 2) % 3;
        if (std::abs(m[i] - m[j]) > close || std::abs(m[i] - m[k]) <= close || std::abs(m[j] - m[k]) <= close) continue;
        Corners points;
        for (const Eigen::Vector3d& p : corners) points.emplace_back(e.row(i).dot(p), e.row(j).dot(p));
        const Eigen::Vector2d side = side_of_least_rectangle(points);
        if (side.y() == 0.0) return axes;
        const Eigen::RowVector3d first = side.x() * e.row(i) + side.y() * e.row(j);
        e.row(j) = side.x() * e.row(j) - side.y() * e.row(i);
        e.row(i) = first;
        std::array<double, 9> out{};
        Eigen::Map<Matrix>(out.data()) = e;
        return out;
    }
    return axes;
}
} // namespace lr::shape
