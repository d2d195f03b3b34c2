// Staggered (marker-and-cell) grid of the mean flow: storage, cell flags, sampling and back-tracing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lr::baker {

using GridPoint = std::array<double, 3>;

// The position of a point between eight samples of a field: the lowest sample and the fractions towards the others.
struct GridStencil {
    uint32_t base;
    double fx, fy, fz;
};

// Samples on a regular lattice, x fastest. All fields except the x-velocity start half a cell inside along x and have one
// more column, at x = 0, with the inflow value. So all fields are nx + 1 samples wide.
struct GridField {
    std::array<uint32_t, 3> count{};
    std::array<double, 3> inverse_spacing{};
    double offset_y = 0.0, offset_z = 0.0; // of the first sample, in cells
    bool inflow_column = false;
    std::vector<double> values;

    size_t index(uint32_t i, uint32_t j, uint32_t k) const {
        return (static_cast<size_t>(k) * count[1] + j) * count[0] + i;
    }
    GridPoint position(uint32_t i, uint32_t j, uint32_t k) const;
    GridStencil locate(const GridPoint& p) const;
    double interpolate(const GridStencil& s) const { return interpolate(values.data(), s); }
    double interpolate(const double* data, const GridStencil& s) const;
    double sample(const GridPoint& p) const { return interpolate(locate(p)); }
    // Catmull-Rom cubic along each axis, clamped to the eight samples around the point: third order for smooth fields, no new
    // extremes. Linear within two samples of the ends of the domain.
    double interpolate_cubic(const GridStencil& s) const;
};

// For each axis one value per cell, x fastest: non-zero if the face before the cell is closed. Empty: no closed faces along that
// axis. Sheets and bodies thinner than a cell are closed faces between fluid cells.
using ClosedFaces = std::array<std::vector<uint8_t>, 3>;

// Boundaries: inflow at x = 0 (velocity prescribed), outflow at x-max (pressure zero), free slip at the four sides.
// Velocity is zero on closed faces and on all faces of solid cells.
struct MacGrid {
    std::array<uint32_t, 3> cells{};
    GridPoint spacing{};
    std::array<GridField, 3> velocity;              // on the x, y and z faces
    std::array<std::vector<uint8_t>, 3> prescribed; // 1: advection and pressure do not change the face
    std::vector<uint8_t> solid;                     // one per cell, x fastest

    MacGrid(const std::array<uint32_t, 3>& cell_counts, const GridPoint& lengths);

    size_t cell_count() const { return solid.size(); }
    size_t cell(uint32_t i, uint32_t j, uint32_t k) const {
        return (static_cast<size_t>(k) * cells[1] + j) * cells[0] + i;
    }
    GridPoint cell_centre(uint32_t i, uint32_t j, uint32_t k) const;
    GridField make_centred_field() const;

    // Sets the mask (one per cell, x fastest; empty: no solid) and the closed faces. Also makes cells solid that have no path to the
    // outflow, such as the inside of a closed surface, because the pressure of a pocket is undetermined. Zeroes the velocity on
    // solid and closed faces.
    void set_solid(const std::vector<uint8_t>& mask, const ClosedFaces& closed = {});

    // The face before the cell along the axis: a sample of velocity[axis].
    size_t face_before(size_t axis, uint32_t i, uint32_t j, uint32_t k) const {
        return velocity[axis].index(i + (axis == 0 ? 0 : 1), j, k);
    }
    // Whether a wall separates the cell from the cell before it; the ends of the domain are not walls.
    bool wall_before(size_t axis, uint32_t i, uint32_t j, uint32_t k) const {
        const uint32_t at[3] = {i, j, k};
        return at[axis] > 0 && prescribed[axis][face_before(axis, i, j, k)] != 0;
    }

    // Velocity at any point; outside the domain, at the nearest point of its boundary.
    GridPoint velocity_at(const GridPoint& p) const;

    // Position, a time dt ago, of the parcel now at p: midpoint rule (second order).
    GridPoint trace_back(const GridPoint& p, double dt) const;

    // Net outflow of a cell over its volume.
    double divergence(uint32_t i, uint32_t j, uint32_t k) const;
    // Largest absolute divergence over the fluid cells.
    double max_divergence() const;
};

inline GridStencil GridField::locate(const GridPoint& p) const {
    double gx = p[0] * inverse_spacing[0];
    if (inflow_column) gx = gx < 0.5 ? 2.0 * gx : gx + 0.5;
    double g[3] = {gx, p[1] * inverse_spacing[1] - offset_y, p[2] * inverse_spacing[2] - offset_z};
    uint32_t n[3];
    for (size_t a = 0; a < 3; ++a) {
        const double last = static_cast<double>(count[a] - 1);
        g[a] = g[a] > 0.0 ? (g[a] < last ? g[a] : last) : 0.0;
        const uint32_t whole = static_cast<uint32_t>(static_cast<int32_t>(g[a]));
        n[a] = whole < count[a] - 2 ? whole : count[a] - 2;
        g[a] -= static_cast<double>(static_cast<int32_t>(n[a]));
    }
    return {static_cast<uint32_t>(index(n[0], n[1], n[2])), g[0], g[1], g[2]};
}

// Uses a + f (b - a), so that a uniform field keeps its bits.
inline double GridField::interpolate(const double* data, const GridStencil& s) const {
    const size_t sy = count[0], sz = sy * count[1];
    const double* p = data + s.base;
    const double c00 = p[0] + s.fx * (p[1] - p[0]);
    const double c10 = p[sy] + s.fx * (p[sy + 1] - p[sy]);
    const double c01 = p[sz] + s.fx * (p[sz + 1] - p[sz]);
    const double c11 = p[sy + sz] + s.fx * (p[sy + sz + 1] - p[sy + sz]);
    const double c0 = c00 + s.fy * (c10 - c00);
    const double c1 = c01 + s.fy * (c11 - c01);
    return c0 + s.fz * (c1 - c0);
}
} // namespace lr::baker
