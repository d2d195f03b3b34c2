#include "baker/mac_grid.h"

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

void MacGrid::set_solid(const std::vector<uint8_t>& mask) {
    const auto [nx, ny, nz] = cells;
    // Flood the fluid from the outflow; what stays dry is solid or a closed pocket.
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
    while (!front.empty()) {
        const size_t c = front.back();
        front.pop_back();
        const uint32_t i = static_cast<uint32_t>(c % nx);
        const uint32_t j = static_cast<uint32_t>(c / nx % ny);
        const uint32_t k = static_cast<uint32_t>(c / nx / ny);
        if (i > 0) wet(i - 1, j, k);
        if (i + 1 < nx) wet(i + 1, j, k);
        if (j > 0) wet(i, j - 1, k);
        if (j + 1 < ny) wet(i, j + 1, k);
        if (k > 0) wet(i, j, k - 1);
        if (k + 1 < nz) wet(i, j, k + 1);
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
                        // The face lies between cell `upper` and the one before it along the axis.
                        const uint32_t upper_i = field.inflow_column ? i - 1 : i;
                        if (upper_i < nx) wall = solid[cell(upper_i, j, k)] != 0;
                        if (a == 0 && i > 0) wall = wall || solid[cell(i - 1, j, k)] != 0;
                        if (a == 1) wall = wall || solid[cell(upper_i, j - 1, k)] != 0;
                        if (a == 2) wall = wall || solid[cell(upper_i, j, k - 1)] != 0;
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
