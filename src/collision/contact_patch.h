// Contact patch: the facing sides of two convex cores, seen along the normal, and their overlap.
#pragma once

#include "collision/body_shape.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace lr {

// Axes across a unit normal, u x v = normal.
struct Across {
    Vector u, v, normal;
    explicit Across(Vector n) : u{}, v{}, normal(n) {
        const float s = n.z < 0.0f ? -1.0f : 1.0f; // Duff et al. 2017
        const float a = -1.0f / (s + n.z), b = n.x * n.y * a;
        u = {1.0f + s * n.x * n.x * a, s * b, -s * n.x};
        v = {b, s + n.y * n.y * a, -n.y};
    }
    Vector at(float along_u, float along_v, float height) const { return along_u * u + along_v * v + height * normal; }
};

// A face or an edge, with its height along the normal as a plane over u and v.
struct Side {
    static constexpr uint32_t most = most_shape_points;

    uint32_t count = 0; // of corners in order; 2: an edge; 0: none
    float u[most], v[most];
    bool clockwise = false; // seen against the normal
    float level = 0.0f, slope_u = 0.0f, slope_v = 0.0f;

    float height_at(float along_u, float along_v) const { return level + slope_u * along_u + slope_v * along_v; }
    // Whether a place is over a side with three corners or more.
    bool covers(float along_u, float along_v) const {
        const float sense = clockwise ? -1.0f : 1.0f;
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t next = i + 1 < count ? i + 1 : 0;
            if (sense * ((u[next] - u[i]) * (along_v - v[i]) - (v[next] - v[i]) * (along_u - u[i])) < 0.0f)
                return false;
        }
        return true;
    }
    // From `corners` > 2 corners, corner(i), counter-clockwise seen from outside. False if the face is nearly edge-on.
    template <class Corner>
    bool set_face(const Across& across, Vector outward, uint32_t corners, const Corner& corner) {
        const float up = dot(outward, across.normal);
        if (!(std::abs(up) > edge_on)) return false;
        slope_u = -dot(outward, across.u) / up;
        slope_v = -dot(outward, across.v) / up;
        clockwise = up < 0.0f;
        // If there are too many corners, some are skipped.
        const uint32_t stride = (corners + most - 1) / most;
        for (uint32_t i = 0; i < corners; i += stride) append(across, corner(i));
        return true;
    }
    void set_edge(const Across& across, Vector from, Vector to);

private:
    // Cosine between face and normal; below it the face's edge counts instead.
    static constexpr float edge_on = 0.2f;
    void append(const Across& across, Vector p) {
        u[count] = dot(across.u, p);
        v[count] = dot(across.v, p);
        if (count == 0) level = dot(across.normal, p) - slope_u * u[0] - slope_v * v[0];
        ++count;
    }
};

// The side of a body's core towards the normal or its opposite: a face, or the ends of the part within `band` of the foremost point. Core:
// face_towards(direction), face_normal(f), point(i).
template <class Core>
void set_body_side(const BodyShape& shape, const Core& core, const Across& across, Vector towards, float band,
                   Side& side) {
    if (shape.face_count == 0) return;
    const uint32_t f = core.face_towards(towards);
    const Vector outward = core.face_normal(f);
    const ShapeFace& face = shape.faces[f];
    const auto corner = [&](uint32_t i) { return core.point(shape.corners[face.first + i]); };
    if (side.set_face(across, outward, face.count, corner)) return;
    const Vector along = cross(towards, outward);
    float height[most_shape_points], foremost = dot(towards, core.point(0));
    for (uint32_t i = 0; i < shape.count; ++i) {
        height[i] = dot(towards, core.point(i));
        foremost = std::max(foremost, height[i]);
    }
    uint32_t ends[2] = {};
    float reach[2] = {1e30f, -1e30f};
    for (uint32_t i = 0; i < shape.count; ++i) {
        if (height[i] < foremost - band) continue;
        const float at = dot(along, core.point(i));
        if (at < reach[0]) reach[0] = at, ends[0] = i;
        if (at > reach[1]) reach[1] = at, ends[1] = i;
    }
    if (ends[0] != ends[1]) side.set_edge(across, core.point(ends[0]), core.point(ends[1]));
}

// A convex polygon, a line or nothing; at each corner the gap between upper and lower side.
struct Patch {
    static constexpr uint32_t most = 2 * Side::most + 1, lanes = 4, room = (most + lanes - 1) / lanes * lanes;
    uint32_t count = 0;
    alignas(16) float u[room], v[room], gap[room];
    void pad() { // to whole vectors, by repeating the first
        for (uint32_t i = count; i % lanes != 0; ++i) u[i] = u[0], v[i] = v[0];
    }
    void add(float along_u, float along_v) {
        if (count == most) return; // only if corners are NaN
        u[count] = along_u;
        v[count++] = along_v;
    }
};
// Clips the sides against each other. slack: m, by which a side may extend beyond the other.
void lay_over(const Side& upper, const Side& lower, float slack, Patch& out);
} // namespace lr
