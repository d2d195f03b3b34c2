#include "baker/turbulence/mac_grid.h"

#include <algorithm>
#include <cmath>

namespace lr::baker {

namespace {

GridField make_field(const std::array<uint32_t, 3>& cells, const GridPoint& spacing, int face_axis) {
    GridField field;
    field.count = {cells[0] + 1, cells[1] + (face_axis == 1 ? 1u : 0u), cells[2] + (face_axis == 2 ? 1u : 0u)};
    for (size_t a = 0; a < 3; ++a) field.inverse_spacing[a] = 1.0 / spacing[a];
    field.offset_y = face_axis == 1 ? 0.0 : 0.5;
    field.offset_z = face_axis == 2 ? 0.0 : 0.5;
    field.inflow_column = face_axis != 0;
    field.values.assign(static_cast<size_t>(field.count[0]) * field.count[1] * field.count[2], 0.0);
    return field;
}
} // namespace

GridPoint GridField::position(uint32_t i, uint32_t j, uint32_t k) const {
    const double x = inflow_column ? (i == 0 ? 0.0 : static_cast<double>(i) - 0.5) : static_cast<double>(i);
    return {x / inverse_spacing[0], (static_cast<double>(j) + offset_y) / inverse_spacing[1],
            (static_cast<double>(k) + offset_z) / inverse_spacing[2]};
}

double GridField::interpolate_cubic(const GridStencil& s) const {
    const size_t sy = count[0], sz = sy * count[1];
    const size_t i = s.base % sy, j = s.base / sy % count[1], k = s.base / sz;
    const size_t first = inflow_column ? 2 : 1;
    if (i < first || i + 2 >= count[0] || j < 1 || j + 2 >= count[1] || k < 1 || k + 2 >= count[2])
        return interpolate(s);
    // Uses differences, so that a uniform field keeps its bits.
    const auto cubic = [](double p0, double p1, double p2, double p3, double f) {
        const double a = p1 - p0, b = p2 - p1, c = p3 - p2;
        return p1 + 0.5 * f * (a + b + f * (3.0 * b - 2.0 * a - c + f * (a - 2.0 * b + c)));
    };
    const double* const p = values.data() + s.base;
    double plane[4];
    for (size_t m = 0; m < 4; ++m) {
        double line[4];
        for (size_t n = 0; n < 4; ++n) {
            const double* const q = p + m * sz + n * sy - sz - sy;
            line[n] = cubic(q[-1], q[0], q[1], q[2], s.fx);
        }
        plane[m] = cubic(line[0], line[1], line[2], line[3], s.fy);
    }
    const double value = cubic(plane[0], plane[1], plane[2], plane[3], s.fz);
    double low = p[0], high = p[0];
    for (const size_t corner : {size_t{1}, sy, sy + 1, sz, sz + 1, sz + sy, sz + sy + 1}) {
        low = std::min(low, p[corner]);
        high = std::max(high, p[corner]);
    }
    return std::clamp(value, low, high);
}

MacGrid::MacGrid(const std::array<uint32_t, 3>& cell_counts, const GridPoint& lengths) : cells(cell_counts) {
    for (size_t a = 0; a < 3; ++a) spacing[a] = lengths[a] / static_cast<double>(cells[a]);
    for (int a = 0; a < 3; ++a) {
        velocity[static_cast<size_t>(a)] = make_field(cells, spacing, a);
        prescribed[static_cast<size_t>(a)].resize(velocity[static_cast<size_t>(a)].values.size());
    }
    solid.resize(static_cast<size_t>(cells[0]) * cells[1] * cells[2]);
    set_solid({});
}

GridPoint MacGrid::cell_centre(uint32_t i, uint32_t j, uint32_t k) const {
    return {(static_cast<double>(i) + 0.5) * spacing[0], (static_cast<double>(j) + 0.5) * spacing[1],
            (static_cast<double>(k) + 0.5) * spacing[2]};
}

GridField MacGrid::make_centred_field() const {
    return make_field(cells, spacing, -1);
}

void MacGrid::set_solid(const std::vector<uint8_t>& mask, const ClosedFaces& closed) {
    const auto [nx, ny, nz] = cells;
    // Flood the fluid from the outflow; the flood misses solids and closed pockets.
    std::fill(solid.begin(), solid.end(), uint8_t{1});
    std::vector<size_t> front;
    const auto wet = [&](uint32_t i, uint32_t j, uint32_t k) {
        const size_t c = cell(i, j, k);
        if (solid[c] == 0 || (!mask.empty() && mask[c] != 0)) return;
        solid[c] = 0;
        front.push_back(c);
    };
    for (uint32_t k = 0; k < nz; ++k)
        for (uint32_t j = 0; j < ny; ++j) wet(nx - 1, j, k);
    const size_t stride[3] = {1, nx, static_cast<size_t>(nx) * ny};
    const auto is_closed = [&](size_t axis, size_t c) { return !closed[axis].empty() && closed[axis][c] != 0; };
    while (!front.empty()) {
        const size_t c = front.back();
        front.pop_back();
        const uint32_t at[3] = {static_cast<uint32_t>(c % nx), static_cast<uint32_t>(c / nx % ny),
                                static_cast<uint32_t>(c / nx / ny)};
        for (size_t a = 0; a < 3; ++a)
            for (const bool forward : {false, true}) {
                if (forward ? at[a] + 1 == cells[a] : at[a] == 0) continue;
                if (is_closed(a, forward ? c + stride[a] : c)) continue;
                uint32_t to[3] = {at[0], at[1], at[2]};
                to[a] = forward ? at[a] + 1 : at[a] - 1;
                wet(to[0], to[1], to[2]);
            }
    }

    for (size_t a = 0; a < 3; ++a) {
        GridField& field = velocity[a];
        for (uint32_t k = 0; k < field.count[2]; ++k)
            for (uint32_t j = 0; j < field.count[1]; ++j)
                for (uint32_t i = 0; i < field.count[0]; ++i) {
                    const size_t f = field.index(i, j, k);
                    const bool inflow = i == 0;
                    const bool side = (a == 1 && (j == 0 || j == ny)) || (a == 2 && (k == 0 || k == nz));
                    bool wall = false;
                    if (!side && !(inflow && field.inflow_column)) {
                        // The face is between cell `upper` and the cell before it along the axis.
                        const uint32_t upper_i = field.inflow_column ? i - 1 : i;
                        if (upper_i < nx) wall = solid[cell(upper_i, j, k)] != 0;
                        if (a == 0 && i > 0) wall = wall || solid[cell(i - 1, j, k)] != 0;
                        if (a == 1) wall = wall || solid[cell(upper_i, j - 1, k)] != 0;
                        if (a == 2) wall = wall || solid[cell(upper_i, j, k - 1)] != 0;
                        if (upper_i < nx && !(a == 0 && i == 0)) wall = wall || is_closed(a, cell(upper_i, j, k));
                    }
                    prescribed[a][f] = inflow || side || wall;
                    if (side || wall) field.values[f] = 0.0;
                }
    }
}

GridPoint MacGrid::velocity_at(const GridPoint& p) const {
    return {velocity[0].sample(p), velocity[1].sample(p), velocity[2].sample(p)};
}

GridPoint MacGrid::trace_back(const GridPoint& p, double dt) const {
    const GridPoint v0 = velocity_at(p);
    const double h = 0.5 * dt;
    const GridPoint v1 = velocity_at({p[0] - h * v0[0], p[1] - h * v0[1], p[2] - h * v0[2]});
    return {p[0] - dt * v1[0], p[1] - dt * v1[1], p[2] - dt * v1[2]};
}

double MacGrid::divergence(uint32_t i, uint32_t j, uint32_t k) const {
    const GridField &u = velocity[0], &v = velocity[1], &w = velocity[2];
    return (u.values[u.index(i + 1, j, k)] - u.values[u.index(i, j, k)]) * u.inverse_spacing[0] +
           (v.values[v.index(i + 1, j + 1, k)] - v.values[v.index(i + 1, j, k)]) * v.inverse_spacing[1] +
           (w.values[w.index(i + 1, j, k + 1)] - w.values[w.index(i + 1, j, k)]) * w.inverse_spacing[2];
}

double MacGrid::max_divergence() const {
    double largest = 0.0;
    for (uint32_t k = 0; k < cells[2]; ++k)
        for (uint32_t j = 0; j < cells[1]; ++j)
            for (uint32_t i = 0; i < cells[0]; ++i)
                if (solid[cell(i, j, k)] == 0) largest = std::max(largest, std::abs(divergence(i, j, k)));
    return largest;
}
} // namespace lr::baker
