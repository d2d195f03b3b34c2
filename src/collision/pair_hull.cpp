#include "collision/body_narrow_phase.h"

#include "base/float4.h"
#include "collision/local_pair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace lr {
namespace {

// Ellipsoids flatter than this, thinnest axis over second, become plates.
constexpr double flat_ellipsoid = 0.2;
constexpr uint32_t outline_points = 16;
// Scale at which the hull of sphere_points() has the ball's volume.
constexpr double filled_sphere = 1.06122;

// A plate with the outline, volume and mean thickness of a flat ellipsoid.
BodyShape plate_of(const BodyShape& ellipsoid, uint32_t across) {
    const uint32_t k = (across + 1) % 3, l = (across + 2) % 3;
    const double radius = 2.0 / 3.0 * wide(ellipsoid.semi_axes[across]);
    // Every 22.5 degrees. Corners lie as far outside the ellipse as edges lie inside.
    const double root2 = std::numbers::sqrt2, sine = 0.5 * std::sqrt(2.0 - root2),
                 cosine = 0.5 * std::sqrt(2.0 + root2);
    const double grow = std::sqrt(std::numbers::pi / (0.5 * outline_points * sine));
    const double semi_k = grow * (wide(ellipsoid.semi_axes[k]) - radius),
                 semi_l = grow * (wide(ellipsoid.semi_axes[l]) - radius);
    std::vector<shape::HullPoint> outline;
    double x = 1.0, y = 0.0;
    for (uint32_t i = 0; i < outline_points; ++i) {
        const Double3 at = to_double(ellipsoid.center) + along_axis(k, semi_k * x) + along_axis(l, semi_l * y);
        outline.push_back({at.x, at.y, at.z});
        const double next = cosine * x - sine * y;
        y = sine * x + cosine * y;
        x = next;
    }
    BodyShape shape{};
    set_outline(shape, outline, along_axis(across, 1.0), radius);
    return shape;
}

// Corners of an icosahedron and a dodecahedron, on the unit sphere.
std::array<Double3, 32> sphere_points() {
    const double phi = std::numbers::phi;
    std::array<Double3, 32> points{};
    size_t count = 0;
    const auto add = [&](Double3 p) { points[count++] = 1.0 / length(p) * p; };
    for (uint32_t signs = 0; signs < 4; ++signs) {
        const double s = (signs & 1u) != 0 ? 1.0 : -1.0, t = (signs & 2u) != 0 ? 1.0 : -1.0;
        add({0.0, s, t * phi});
        add({s, t * phi, 0.0});
        add({t * phi, 0.0, s});
        add({s / phi, 0.0, t * phi});
        add({0.0, t * phi, s / phi});
        add({t * phi, s / phi, 0.0});
        add({s, t, 1.0});
        add({s, t, -1.0});
    }
    return points;
}

// A rounded hull with about the ellipsoid's volume. The rounding is half the least radius of curvature, since more would add volume to long
// ones, and nearly all of it for a ball: with half, the 32 corners turned its normals by up to ten degrees.
BodyShape solid_of(const BodyShape& ellipsoid) {
    const Double3 semi = to_double(ellipsoid.semi_axes);
    const double most = std::max({semi.x, semi.y, semi.z}), thinnest = std::min({semi.x, semi.y, semi.z});
    const double round = thinnest / most, square = round * round;
    const double radius = (0.5 + 0.499 * square * square) * round * thinnest;
    std::vector<shape::HullPoint> points;
    for (const Double3& p : sphere_points())
        points.push_back({wide(ellipsoid.center.x) + filled_sphere * (semi.x - radius) * p.x,
                          wide(ellipsoid.center.y) + filled_sphere * (semi.y - radius) * p.y,
                          wide(ellipsoid.center.z) + filled_sphere * (semi.z - radius) * p.z});
    BodyShape shape{};
    set_hull(shape, points);
    shape.radius = static_cast<float>(radius);
    shape.reach += shape.radius;
    shape.thickness += 2.0f * shape.radius;
    return shape;
}

// A plate with fewer corners, since each costs time in each pair.
BodyShape coarse_plate(const BodyShape& plate) {
    std::vector<shape::HullPoint> points, outline;
    for (uint32_t i = 0; i < plate.count; ++i) {
        const Double3 p = to_double(plate.point(i));
        points.push_back({p.x, p.y, p.z});
    }
    const uint8_t* const in_turn = plate.corners + plate.faces[0].first;
    std::vector<uint32_t> corners(in_turn, in_turn + plate.count);
    drop_corners(points, corners, 1e-3 * wide(plate.reach), outline_points);
    for (const uint32_t i : corners) outline.push_back(points[i]);
    BodyShape shape{};
    set_outline(shape, outline, to_double(plate.faces[0].normal), wide(plate.radius));
    return shape;
}

bool is_plate(const BodyShape& shape) {
    return shape.face_count == 2 && shape.faces[0].count == shape.count;
}

BodyShape hull_for(const BodyShape& shape) {
    if (shape.count > 0) return is_plate(shape) && shape.count > outline_points ? coarse_plate(shape) : shape;
    const Vector s = shape.semi_axes;
    const uint32_t across = s.x <= s.y && s.x <= s.z ? 0 : s.y <= s.z ? 1 : 2;
    const double second = wide(std::min(s[(across + 1) % 3], s[(across + 2) % 3]));
    return wide(s[across]) < flat_ellipsoid * second ? plate_of(shape, across) : solid_of(shape);
}

// Rotates z to the nearer one of a plate's normals.
Rotation plate_frame(const BodyShape& shape) {
    const Vector n = shape.faces[shape.faces[0].normal.z < 0.0f ? 1 : 0].normal;
    return normalised({-n.y, n.x, 0.0f, 1.0f + n.z});
}

void set_own_points(PairHull& out) {
    const BodyShape& shape = out.shape;
    const uint32_t count = shape.count;
    const Rotation to_own = inverse(out.frame);
    Vector points[most_shape_points];
    Vector low = rotate(to_own, shape.point(0)), high = low;
    for (uint32_t i = 0; i < count; ++i) {
        points[i] = rotate(to_own, shape.point(i));
        low = low_of(low, points[i]);
        high = high_of(high, points[i]);
    }
    const Vector middle = 0.5f * (low + high);
    out.origin = rotate(out.frame, middle);
    out.core_half = 0.5f * (high - low);
    if (out.flat) out.core_half.z = 0.0f;
    out.padded = (count + PairHull::lanes - 1) / PairHull::lanes * PairHull::lanes;
    for (uint32_t i = 0; i < out.padded; ++i) {
        const Vector p = points[i < count ? i : 0] - middle;
        out.x[i] = p.x;
        out.y[i] = p.y;
        out.z[i] = out.flat ? 0.0f : p.z;
        out.core_reach = std::max(out.core_reach, length(p));
    }
    for (uint32_t f = 0; f < most_shape_faces; ++f) {
        Vector n = rotate(to_own, shape.faces[f < shape.face_count ? f : 0].normal);
        if (out.flat) n = {0.0f, 0.0f, n.z > 0.0f ? 1.0f : -1.0f};
        out.face_x[f] = n.x, out.face_y[f] = n.y, out.face_z[f] = n.z;
        out.face_offset[f] = -std::numeric_limits<float>::infinity();
        for (uint32_t i = 0; i < count; ++i)
            out.face_offset[f] = std::max(out.face_offset[f], dot(n, {out.x[i], out.y[i], out.z[i]}));
    }
}
} // namespace

// The chord of a rotation at distance 1 is 2 |sin(angle/2)|.
PairBody pair_body(const PairHull& shape, float scale, const Pose& from, const Pose& to) {
    const Rotation turn = to.rotation * inverse(from.rotation);
    const float reach = scale * shape.shape.reach;
    PairBody body{
        &shape, scale, from, to, to.position - from.position, 2.0f * reach * length(Vector{turn.x, turn.y, turn.z})};
    const Vector axes[3] = {{1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}};
    for (size_t k = 0; k < 3; ++k) body.turned[k] = rotate(to.rotation, axes[k]) - rotate(from.rotation, axes[k]);
    return body;
}

PairHull make_pair_hull(const BodyShape& shape) {
    PairHull out{};
    out.shape = hull_for(shape);
    const BodyShape& s = out.shape;
    out.flat = is_plate(s);
    out.frame = out.flat ? plate_frame(s) : Rotation{0.0f, 0.0f, 0.0f, 1.0f};
    set_own_points(out);
    // Corners of the face towards z.
    const ShapeFace& face = s.faces[out.flat && out.face_z[1] > 0.0f ? 1 : 0];
    for (uint32_t i = 0; out.flat && i < s.count; ++i) {
        const uint32_t corner = s.corners[face.first + i];
        out.ring_x[i] = out.x[corner];
        out.ring_y[i] = out.y[corner];
    }
    out.face = make_broad_face(out);
    return out;
}

PairHull thickened(PairHull hull, float min_thickness) {
    constexpr double usual_part = 1.0 / 32.0, usual_most = 1.25e-3; // of the reach; m
    BodyShape& shape = hull.shape;
    const double reach = wide(shape.reach);
    const double wanted = min_thickness == 0.0f ? std::min(usual_part * reach, usual_most)
                                                : std::min(wide(min_thickness), most_thickened * reach);
    const auto radius = static_cast<float>(0.5 * wanted);
    if (!hull.flat || !(radius > shape.radius)) return hull;
    const float more = radius - shape.radius;
    shape.radius = radius;
    shape.reach += more;
    shape.thickness += 2.0f * more;
    return hull;
}

Box bounds(const PairHull& shape, float scale, const Pose& at) {
    const Rotation q = at.rotation * shape.frame;
    const Vector x = rotate(q, {scale, 0.0f, 0.0f}), y = rotate(q, {0.0f, scale, 0.0f}),
                 z = rotate(q, {0.0f, 0.0f, scale});
    const Vector middle = at.position + scale * rotate(at.rotation, shape.origin);
    // Rounding of rotated points and of positions.
    const float out = scale * (shape.shape.radius + 1e-6f * shape.core_reach);
    const auto extent = [&](float from_x, float from_y, float from_z, float about, float& low, float& high) {
        const auto along = [&](uint32_t i) {
            return from_x * load(shape.x + i) + from_y * load(shape.y + i) + from_z * load(shape.z + i);
        };
        Float4 least_of = along(0), greatest_of = least_of;
        for (uint32_t i = PairHull::lanes; i < shape.padded; i += PairHull::lanes) {
            const Float4 a = along(i);
            least_of = less(a, least_of);
            greatest_of = greater(a, greatest_of);
        }
        const float rounding = out + 2e-7f * (about < 0.0f ? -about : about);
        low = about + least(least_of) - rounding;
        high = about + greatest(greatest_of) + rounding;
    };
    Box box{};
    extent(x.x, y.x, z.x, middle.x, box.low.x, box.high.x);
    extent(x.y, y.y, z.y, middle.y, box.low.y, box.high.y);
    extent(x.z, y.z, z.z, middle.z, box.low.z, box.high.z);
    return box;
}
} // namespace lr
