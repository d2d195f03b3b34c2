#include "contact/manifold.h"

#include <algorithm>
#include <limits>

namespace lr {
namespace {

// A side of a convex set seen along the normal: a polygon in the plane across it, and its height over that plane.
constexpr uint32_t most_corners = most_shape_points;
struct Side {
    uint32_t count = 0; // 2: a line
    float u[most_corners], v[most_corners];
    float height[most_corners];
    float slope_u = 0.0f, slope_v = 0.0f; // of the height

    float height_at(float pu, float pv) const { return height[0] + slope_u * (pu - u[0]) + slope_v * (pv - v[0]); }
    bool covers(float pu, float pv, float slack) const {
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t j = i + 1 < count ? i + 1 : 0;
            const float du = u[j] - u[i], dv = v[j] - v[i];
            const float off = dv * (pu - u[i]) - du * (pv - v[i]); // positive outside, counter-clockwise
            if (off > 0.0f && off * off > slack * slack * (du * du + dv * dv)) return false;
        }
        return count >= 3;
    }
};

// Axes across a unit normal, u x v = normal.
struct Across {
    Vector u, v, normal;
    explicit Across(Vector n) : u{}, v{}, normal(n) {
        const float s = n.z < 0.0f ? -1.0f : 1.0f; // Duff et al. 2017
        const float a = -1.0f / (s + n.z), b = n.x * n.y * a;
        u = {1.0f + s * n.x * n.x * a, s * b, -s * n.x};
        v = {b, s + n.y * n.y * a, -n.y};
    }
    void append(Side& side, Vector p) const {
        if (side.count == most_corners) return;
        side.u[side.count] = dot(u, p);
        side.v[side.count] = dot(v, p);
        side.height[side.count++] = dot(normal, p);
    }
    // Height of the plane with this outward normal; sides seen edge on are no sides.
    bool set_slope(Side& side, Vector plane) const {
        const float up = dot(plane, normal);
        if (!(std::abs(up) > 0.1f)) return false;
        side.slope_u = -dot(plane, u) / up;
        side.slope_v = -dot(plane, v) / up;
        return true;
    }
};

void wind_counter_clockwise(Side& side) {
    float area = 0.0f;
    for (uint32_t i = 0; i < side.count; ++i) {
        const uint32_t j = i + 1 < side.count ? i + 1 : 0;
        area += (side.u[i] - side.u[0]) * (side.v[j] - side.v[0]) - (side.u[j] - side.u[0]) * (side.v[i] - side.v[0]);
    }
    if (area < 0.0f) {
        std::reverse(side.u, side.u + side.count);
        std::reverse(side.v, side.v + side.count);
        std::reverse(side.height, side.height + side.count);
    }
}

// The side of the body that looks most towards the collider. Count 0: none does.
void body_side(const PlacedBody& body, const Across& across, Side& side) {
    const BodyShape& shape = *body.shape;
    const Vector n = rotate(inverse(body.at.rotation), across.normal);
    uint32_t best = 0;
    float most = std::numeric_limits<float>::infinity();
    for (uint32_t f = 0; f < shape.face_count; ++f) {
        const float along = dot(shape.faces[f].normal, n);
        if (along < most) {
            most = along;
            best = f;
        }
    }
    if (shape.face_count == 0 || !across.set_slope(side, body.face_normal(best))) return;
    const ShapeFace& face = shape.faces[best];
    for (uint32_t i = 0; i < face.count; ++i) across.append(side, body.point(shape.corners[face.first + i]));
    wind_counter_clockwise(side);
}

Vector box_corner(const PlacedCollider& box, uint32_t axis, double sign, uint32_t corner) {
    const double halves[3] = {box.half.x, box.half.y, box.half.z};
    double p[3] = {box.origin.x, box.origin.y, box.origin.z};
    const uint32_t j = (axis + 1) % 3, k = (axis + 2) % 3;
    p[axis] += sign * halves[axis];
    p[j] += (corner == 0 || corner == 3 ? -1.0 : 1.0) * halves[j];
    p[k] += (corner < 2 ? -1.0 : 1.0) * halves[k];
    return to_float({p[0], p[1], p[2]});
}

void box_side(const PlacedCollider& box, const Across& across, Side& side) {
    const float n[3] = {across.normal.x, across.normal.y, across.normal.z};
    uint32_t axis = 0;
    for (uint32_t i = 1; i < 3; ++i)
        if (std::abs(n[i]) > std::abs(n[axis])) axis = i;
    const double sign = n[axis] < 0.0f ? -1.0 : 1.0;
    float plane[3] = {0.0f, 0.0f, 0.0f};
    plane[axis] = static_cast<float>(sign);
    across.set_slope(side, {plane[0], plane[1], plane[2]});
    for (uint32_t corner = 0; corner < 4; ++corner) across.append(side, box_corner(box, axis, sign, corner));
    wind_counter_clockwise(side);
}

void hull_side(const PlacedCollider& collider, const Across& across, Side& side) {
    const HullGeometry& hull = *collider.hull;
    const float* best = hull.faces;
    float most = -2.0f;
    for (uint32_t f = 0; f < hull.face_count; ++f) {
        const float* face = hull.faces + size_t{4} * f;
        const float along = dot(across.normal, {face[0], face[1], face[2]});
        if (along > most) {
            most = along;
            best = face;
        }
    }
    const Vector plane{best[0], best[1], best[2]};
    if (!across.set_slope(side, plane)) return;
    float size = std::abs(best[3]);
    for (size_t i = 0; i < size_t{3} * hull.vertex_count; ++i) size = std::max(size, std::abs(hull.vertices[i]));
    Side corners;
    for (uint32_t i = 0; i < hull.vertex_count; ++i) {
        const Vector p = hull_corner(hull, i);
        if (best[3] - dot(plane, p) < 1e-5f * size) across.append(corners, to_float(collider.origin + to_double(p)));
    }
    if (corners.count < 3) return;
    // In order around their middle.
    float mu = 0.0f, mv = 0.0f;
    for (uint32_t i = 0; i < corners.count; ++i) {
        mu += corners.u[i] / static_cast<float>(corners.count);
        mv += corners.v[i] / static_cast<float>(corners.count);
    }
    uint32_t order[most_corners];
    for (uint32_t i = 0; i < corners.count; ++i) order[i] = i;
    const auto upper = [&](uint32_t i) { return corners.v[i] > mv || (corners.v[i] == mv && corners.u[i] >= mu); };
    for (uint32_t i = 1; i < corners.count; ++i) // few, and nearly sorted from one step to the next does not matter
        for (uint32_t j = i; j > 0; --j) {
            const uint32_t a = order[j - 1], b = order[j];
            const bool a_up = upper(a), b_up = upper(b);
            const float turn = (corners.u[a] - mu) * (corners.v[b] - mv) - (corners.v[a] - mv) * (corners.u[b] - mu);
            if (a_up != b_up ? a_up : turn >= 0.0f) break;
            std::swap(order[j - 1], order[j]);
        }
    side.count = corners.count;
    for (uint32_t i = 0; i < corners.count; ++i) {
        side.u[i] = corners.u[order[i]];
        side.v[i] = corners.v[order[i]];
        side.height[i] = corners.height[order[i]];
    }
}

void collider_side(const PlacedCollider& collider, const Across& across, Side& side) {
    if (collider.hull) return hull_side(collider, across, side);
    if (collider.count == 0) return box_side(collider, across, side);
    if (collider.count == 3) {
        const Vector plane =
            to_float(cross(collider.points[1] - collider.points[0], collider.points[2] - collider.points[0]));
        const float size = length(plane);
        if (!(size > 0.0f) || !across.set_slope(side, 1.0f / size * plane)) return;
    } else if (collider.count != 2) {
        return;
    }
    for (uint32_t i = 0; i < collider.count; ++i) across.append(side, to_float(collider.points[i]));
    if (collider.count == 3) return wind_counter_clockwise(side);
    const float du = side.u[1] - side.u[0], dv = side.v[1] - side.v[0], square = du * du + dv * dv;
    if (!(square > 0.0f)) {
        side.count = 0;
        return;
    }
    const float rise = (side.height[1] - side.height[0]) / square;
    side.slope_u = rise * du;
    side.slope_v = rise * dv;
}

// The part of the line from a to b over a polygon.
bool clip(const Side& polygon, float au, float av, float bu, float bv, float& from, float& to) {
    from = 0.0f;
    to = 1.0f;
    for (uint32_t i = 0; i < polygon.count; ++i) {
        const uint32_t j = i + 1 < polygon.count ? i + 1 : 0;
        const float du = polygon.u[j] - polygon.u[i], dv = polygon.v[j] - polygon.v[i];
        const float off_a = dv * (au - polygon.u[i]) - du * (av - polygon.v[i]);
        const float off_b = dv * (bu - polygon.u[i]) - du * (bv - polygon.v[i]);
        if (off_a > 0.0f && off_b > 0.0f) return false;
        if (off_a > 0.0f)
            from = std::max(from, off_a / (off_a - off_b));
        else if (off_b > 0.0f)
            to = std::min(to, off_a / (off_a - off_b));
    }
    return from <= to;
}

// How far a point is out from the core of a sphere or capsule, and in what direction.
double distance_from(const PlacedCollider& round, Double3 p, Double3& direction) {
    Double3 from = p - round.points[0];
    if (round.count == 2) {
        const Double3 along = round.points[1] - round.points[0];
        from = from - std::clamp(dot(from, along) / dot(along, along), 0.0, 1.0) * along;
    }
    const double distance = length(from);
    direction = distance > 0.0 ? 1.0 / distance * from : Double3{0.0, 1.0, 0.0};
    return distance;
}

// A flat ellipsoid that lies on something round touches at a point that goes from rim to rim with the least tilt. As over the
// ground: also where it would touch if it were tilted a little, and at the other rims. gap: of the point that is nearest.
void add_rims(const PlacedBody& body, const PlacedCollider& round, Double3 normal, float gap, float margin,
              ContactSet& set) {
    Double3 axes[3];
    double size[3], along[3];
    uint32_t shortest = 0, longest = 0;
    for (uint32_t k = 0; k < 3; ++k) {
        size[k] = length(to_double(body.axes[k]));
        axes[k] = 1.0 / size[k] * to_double(body.axes[k]);
        along[k] = dot(normal, axes[k]);
        if (size[k] < size[shortest]) shortest = k;
        if (size[k] > size[longest]) longest = k;
    }
    const double flat = 1.0 - size[shortest] / size[longest];
    if (flat < 0.8 || round.count == 0 || round.count > 2) return;
    const uint32_t first = (shortest + 1) % 3, second = (shortest + 2) % 3;
    // What pushing the nearest point out may press in.
    const float wide = margin + 0.1f * body.reach + 2.0f * std::max(-gap, 0.0f);
    const auto add = [&](double a, double b) {
        const Double3 p = body.support(-(along[shortest] * axes[shortest] + a * axes[first] + b * axes[second]));
        Double3 direction;
        const double out = distance_from(round, p, direction) - round.radius;
        if (out < static_cast<double>(wide)) set.add(to_float(p), to_float(direction), static_cast<float>(out));
    };
    const double a = along[first], b = along[second], tilt = 0.02 * flat * flat;
    add(a + tilt, b), add(a - tilt, b), add(a, b + tilt), add(a, b - tilt);
    add(-a, b), add(a, -b), add(-a, -b);
}

} // namespace

void add_manifold(const PlacedBody& body, const PlacedCollider& collider, const Separation& along, float margin,
                  ContactSet& set) {
    const Vector n = to_float(along.normal);
    const auto rounding = static_cast<float>(collider.radius);
    const uint32_t first = set.count();
    if (body.count > 0) {
        const Across across(n);
        Side on_body, on_collider;
        body_side(body, across, on_body);
        collider_side(collider, across, on_collider);
        const auto add = [&](float u, float v, float body_height, float collider_height) {
            const float gap = body_height - collider_height - rounding;
            if (gap - body.radius < margin) set.add_core(u * across.u + v * across.v + body_height * n, n, gap);
        };
        if (on_collider.count >= 3) {
            const float slack = 1e-5f * body.reach;
            for (uint32_t i = 0; i < body.count; ++i) {
                const Vector p = body.point(i);
                const float u = dot(across.u, p), v = dot(across.v, p), height = dot(n, p);
                const float under = on_collider.height_at(u, v);
                if (height - under - rounding - body.radius < margin && on_collider.covers(u, v, slack))
                    add(u, v, height, under);
            }
        }
        if (on_body.count >= 3 && on_collider.count >= 2) {
            const uint32_t edges = on_collider.count == 2 ? 1 : on_collider.count;
            for (uint32_t i = 0; i < edges; ++i) {
                const uint32_t j = i + 1 < on_collider.count ? i + 1 : 0;
                const float au = on_collider.u[i], av = on_collider.v[i];
                const float bu = on_collider.u[j], bv = on_collider.v[j];
                float ends[2];
                if (!clip(on_body, au, av, bu, bv, ends[0], ends[1])) continue;
                for (uint32_t e = 0; e < 2; ++e) {
                    // The next edge begins where this one ends.
                    if (e == 1 && (ends[1] == ends[0] || (ends[1] == 1.0f && edges > 1))) continue;
                    const float u = au + ends[e] * (bu - au), v = av + ends[e] * (bv - av);
                    const float height =
                        on_collider.height[i] + ends[e] * (on_collider.height[j] - on_collider.height[i]);
                    add(u, v, on_body.height_at(u, v), height);
                }
            }
        }
    }
    const auto gap = static_cast<float>(along.distance) - rounding;
    if (gap - body.radius >= margin) return;
    const float least = set.least_gap(first, std::numeric_limits<float>::infinity());
    if (least <= gap - body.radius + 0.05f * margin) return;
    const Vector point = to_float(along.has_points ? along.on_body : body.support(-along.normal));
    set.add_core(point, n, gap);
    if (body.count == 0) add_rims(body, collider, along.normal, gap, margin, set);
}

} // namespace lr
