#include "baker/turbulence/voxelise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace lr::baker {
namespace {

// In cells. Far above the rounding of positions (2e-16 times 512 cells), far below the size of any body.
constexpr double slack = 1e-9;
// A flatter triangle, seen along the axis, has no reliable plane; only its edges count.
constexpr double edge_on = 1e-6;

struct Corner {
    double p, q, depth; // p, q: across the axis, depth: along it; in cells, cell centres at whole numbers
};

struct Interval {
    double low = 1e300, high = -1e300;
    void add(double x) {
        low = std::min(low, x);
        high = std::max(high, x);
    }
};

// Depths of the part of the edge within `reach` of the line.
void clip_edge(const Corner& a, const Corner& b, double p, double q, double reach, Interval& depths) {
    const double ep = b.p - a.p, eq = b.q - a.q, length2 = ep * ep + eq * eq;
    const double to_p = p - a.p, to_q = q - a.q;
    double from = 0.0, to = 1.0;
    if (length2 > 0.0) {
        const double nearest = (to_p * ep + to_q * eq) / length2;
        const double dp = to_p - nearest * ep, dq = to_q - nearest * eq;
        const double rest = reach * reach - dp * dp - dq * dq;
        if (!(rest >= 0.0)) return;
        const double half = std::sqrt(rest / length2);
        from = std::max(0.0, nearest - half);
        to = std::min(1.0, nearest + half);
        if (from > to) return;
    } else if (to_p * to_p + to_q * to_q > reach * reach) {
        return;
    }
    depths.add(a.depth + from * (b.depth - a.depth));
    depths.add(a.depth + to * (b.depth - a.depth));
}

// Depths at which the line of cell centres (p, q) along the axis intersects the triangle.
Interval meet(const Corner (&t)[3], double p, double q) {
    Interval depths;
    double side[3], longest = 0.0;
    for (size_t e = 0; e < 3; ++e) {
        const Corner &a = t[e], &b = t[(e + 1) % 3];
        side[e] = (b.p - a.p) * (q - a.q) - (b.q - a.q) * (p - a.p);
        longest = std::max(longest, std::sqrt((b.p - a.p) * (b.p - a.p) + (b.q - a.q) * (b.q - a.q)));
    }
    const double twice_area = (t[1].p - t[0].p) * (t[2].q - t[0].q) - (t[1].q - t[0].q) * (t[2].p - t[0].p);
    const double height = longest > 0.0 ? std::abs(twice_area) / longest : 0.0;
    if (height > edge_on) {
        const double sign = twice_area > 0.0 ? 1.0 : -1.0;
        if (sign * side[0] >= 0.0 && sign * side[1] >= 0.0 && sign * side[2] >= 0.0)
            depths.add((side[1] * t[0].depth + side[2] * t[1].depth + side[0] * t[2].depth) / twice_area);
    }
    const double reach = height > edge_on ? slack : slack + edge_on;
    for (size_t e = 0; e < 3; ++e) clip_edge(t[e], t[(e + 1) % 3], p, q, reach, depths);
    return depths;
}
} // namespace

ClosedFaces voxelise(const Mesh& mesh, const std::array<uint32_t, 3>& cells, const GridPoint& lengths) {
    const size_t stride[3] = {1, cells[0], static_cast<size_t>(cells[0]) * cells[1]};
    ClosedFaces closed;
    for (std::vector<uint8_t>& faces : closed) faces.assign(stride[2] * cells[2], 0);

    const auto in_cells = [&](const Eigen::Vector3d& v, size_t axis) {
        return v[static_cast<Eigen::Index>(axis)] / lengths[axis] * cells[axis] - 0.5;
    };
    // Lines within the box of the triangle.
    const auto lines = [](double low, double high, uint32_t count, uint32_t& first, uint32_t& last) {
        const double from = std::ceil(low - slack), to = std::floor(high + slack);
        if (!(to >= 0.0 && from <= count - 1.0 && from <= to)) return false;
        first = static_cast<uint32_t>(std::max(from, 0.0));
        last = static_cast<uint32_t>(std::min(to, count - 1.0));
        return true;
    };
    for (size_t axis = 0; axis < 3; ++axis) {
        const size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
        for (const Face& face : mesh.faces) {
            Corner t[3];
            Interval p, q;
            for (size_t n = 0; n < 3; ++n) {
                const Eigen::Vector3d& v = mesh.vertices[face[n]];
                t[n] = {in_cells(v, a), in_cells(v, b), in_cells(v, axis)};
                p.add(t[n].p);
                q.add(t[n].q);
            }
            uint32_t p0, p1, q0, q1;
            if (!lines(p.low, p.high, cells[a], p0, p1) || !lines(q.low, q.high, cells[b], q0, q1)) continue;
            for (uint32_t line_q = q0; line_q <= q1; ++line_q)
                for (uint32_t line_p = p0; line_p <= p1; ++line_p) {
                    const Interval depths = meet(t, line_p, line_q);
                    // Face n is between the centres n - 1 and n.
                    const double from = std::max(std::ceil(depths.low - slack), 1.0);
                    const double to = std::min(std::floor(depths.high + slack) + 1.0, cells[axis] - 1.0);
                    if (!(from <= to)) continue;
                    const size_t row = line_p * stride[a] + line_q * stride[b];
                    for (size_t n = static_cast<size_t>(from); n <= static_cast<size_t>(to); ++n)
                        closed[axis][row + n * stride[axis]] = 1;
                }
        }
    }
    return closed;
}
} // namespace lr::baker
