#include "contact/body_pair.h"

#include "contact/four.h"
#include "contact/placed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace lr {
namespace {

// Ellipsoids flatter than this, thinnest over second axis, are plates.
constexpr double flat_ellipsoid = 0.2;
constexpr uint32_t outline_points = 24;

double axis(const Vector& v, uint32_t k) {
    return static_cast<double>(k == 0 ? v.x : k == 1 ? v.y : v.z);
}

// A plate with the outline and the volume of a flat ellipsoid: as thick as that is on the mean.
BodyShape plate_of(const BodyShape& ellipsoid, uint32_t across) {
    BodyShape shape{};
    const uint32_t k = (across + 1) % 3, l = (across + 2) % 3;
    const double radius = 2.0 / 3.0 * axis(ellipsoid.semi_axes, across);
    // Multiples of 15 degrees. The outline's corners lie outside as far as its edges lie inside.
    const double root2 = std::numbers::sqrt2, root3 = std::numbers::sqrt3;
    const double sines[7] = {0.0,         root2 * (root3 - 1.0) / 4.0, 0.5, root2 / 2.0,
                             root3 / 2.0, root2 * (root3 + 1.0) / 4.0, 1.0};
    const double grow = std::sqrt(std::numbers::pi / (0.5 * outline_points * sines[1]));
    const auto sine = [&](uint32_t i) {
        const uint32_t quarter = i / 6 % 4, rest = i % 6;
        const double s = sines[quarter % 2 == 0 ? rest : 6 - rest];
        return quarter < 2 ? s : -s;
    };
    shape.count = outline_points;
    for (uint32_t i = 0; i < outline_points; ++i) {
        double p[3] = {0.0, 0.0, 0.0};
        p[k] = grow * (axis(ellipsoid.semi_axes, k) - radius) * sine(i + 6);
        p[l] = grow * (axis(ellipsoid.semi_axes, l) - radius) * sine(i);
        const Vector at = ellipsoid.center + to_float({p[0], p[1], p[2]});
        shape.x[i] = at.x;
        shape.y[i] = at.y;
        shape.z[i] = at.z;
        shape.corners[i] = static_cast<uint8_t>(i);
        shape.corners[outline_points + i] = static_cast<uint8_t>(outline_points - 1 - i);
        shape.reach = std::max(shape.reach, length(at));
    }
    shape.radius = static_cast<float>(radius);
    shape.reach = (shape.reach + shape.radius) * (1.0f + 1e-6f);
    shape.thickness = 2.0f * shape.radius;
    shape.center = ellipsoid.center;
    shape.face_count = 2;
    for (uint32_t f = 0; f < 2; ++f) {
        double n[3] = {0.0, 0.0, 0.0};
        n[across] = f == 0 ? 1.0 : -1.0;
        shape.faces[f].normal = to_float({n[0], n[1], n[2]});
        shape.faces[f].offset = dot(shape.faces[f].normal, ellipsoid.center);
        shape.faces[f].first = static_cast<uint8_t>(f * outline_points);
        shape.faces[f].count = static_cast<uint8_t>(outline_points);
    }
    return shape;
}

// Corners of an icosahedron and of a dodecahedron, on the unit sphere.
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
        add({0.0, s / phi, t * phi});
        add({s / phi, t * phi, 0.0});
        add({t * phi, 0.0, s / phi});
        add({s, t, 1.0});
        add({s, t, -1.0});
    }
    return points;
}

BodyShape hull_of(const Double3& semi, const Vector& center) {
    AssetData asset;
    asset.mass = 1.0;
    asset.inertia = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    for (const Double3& p : sphere_points()) {
        asset.hull.vertices.push_back(center.x + static_cast<float>(semi.x * p.x));
        asset.hull.vertices.push_back(center.y + static_cast<float>(semi.y * p.y));
        asset.hull.vertices.push_back(center.z + static_cast<float>(semi.z * p.z));
    }
    return make_body_shape(asset);
}

// A rounded hull with the ellipsoid's volume. The rounding is half of its least radius of curvature.
BodyShape solid_of(const BodyShape& ellipsoid) {
    const Double3 semi = to_double(ellipsoid.semi_axes);
    const double most = std::max({semi.x, semi.y, semi.z}), thinnest = std::min({semi.x, semi.y, semi.z});
    const double radius = 0.5 * thinnest * thinnest / most;
    const Double3 core{semi.x - radius, semi.y - radius, semi.z - radius};
    BodyShape shape = hull_of(core, {0.0f, 0.0f, 0.0f});
    // Volume, surface and mean width of the core; with them Steiner's formula.
    double volume = 0.0, surface = 0.0, width = 0.0;
    const auto corner = [&](const ShapeFace& face, uint32_t i) {
        const uint32_t at = shape.corners[face.first + i];
        return to_double({shape.x[at], shape.y[at], shape.z[at]});
    };
    for (uint32_t f = 0; f < shape.face_count; ++f)
        for (uint32_t i = 1; i + 1u < shape.faces[f].count; ++i) {
            const Double3 a = corner(shape.faces[f], 0), b = corner(shape.faces[f], i);
            const Double3 c = corner(shape.faces[f], i + 1);
            volume += dot(a, cross(b, c)) / 6.0;
            surface += 0.5 * length(cross(b - a, c - a));
        }
    for (const Double3& p : sphere_points()) width += length(Double3{core.x * p.x, core.y * p.y, core.z * p.z}) / 32.0;
    const double wanted = 4.0 / 3.0 * std::numbers::pi * semi.x * semi.y * semi.z;
    double low = 0.5, high = 2.0;
    for (uint32_t round = 0; round < 40; ++round) {
        const double k = 0.5 * (low + high);
        const double here = k * k * k * volume + k * k * surface * radius +
                            4.0 * std::numbers::pi * radius * radius * (k * width + radius / 3.0);
        (here < wanted ? low : high) = k;
    }
    shape = hull_of(low * core, ellipsoid.center);
    shape.radius = static_cast<float>(radius);
    shape.reach += shape.radius;
    shape.thickness += 2.0f * shape.radius;
    return shape;
}

BodyShape hull_for(const BodyShape& shape) {
    if (shape.count > 0) return shape;
    const Vector s = shape.semi_axes;
    const uint32_t across = s.x <= s.y && s.x <= s.z ? 0 : s.y <= s.z ? 1 : 2;
    const double second = std::min(axis(s, (across + 1) % 3), axis(s, (across + 2) % 3));
    return axis(s, across) < flat_ellipsoid * second ? plate_of(shape, across) : solid_of(shape);
}

// The rotation that takes z to a unit vector, then turns about that so that x comes to lie along another across it.
Rotation rotation_to(Double3 x, Double3 z) {
    const Double3 y = cross(z, x);
    // Columns x, y, z; the largest of the four components first.
    const double traces[4] = {1.0 + x.x - y.y - z.z, 1.0 - x.x + y.y - z.z, 1.0 - x.x - y.y + z.z,
                              1.0 + x.x + y.y + z.z};
    uint32_t best = 0;
    for (uint32_t i = 1; i < 4; ++i)
        if (traces[i] > traces[best]) best = i;
    const double r = std::sqrt(traces[best]), s = 0.5 / r;
    double q[4] = {};
    q[best] = 0.5 * r;
    const double yz = y.z - z.y, zx = z.x - x.z, xy = x.y - y.x;
    const double pxy = x.y + y.x, pxz = x.z + z.x, pyz = y.z + z.y;
    const double products[4][4] = {{0, pxy, pxz, yz}, {pxy, 0, pyz, zx}, {pxz, pyz, 0, xy}, {yz, zx, xy, 0}};
    for (uint32_t i = 0; i < 4; ++i)
        if (i != best) q[i] = s * products[best][i];
    return normalised(
        {static_cast<float>(q[0]), static_cast<float>(q[1]), static_cast<float>(q[2]), static_cast<float>(q[3])});
}

// The frame of a plate: along that of its edges about which a box across it has the least area.
Rotation plate_frame(const BodyShape& shape) {
    const Double3 z = to_double(shape.faces[0].normal);
    const ShapeFace& face = shape.faces[0];
    const auto corner = [&](uint32_t i) {
        const uint32_t at = shape.corners[face.first + i % face.count];
        return to_double({shape.x[at], shape.y[at], shape.z[at]});
    };
    Rotation best{0.0f, 0.0f, 0.0f, 1.0f};
    double least_area = std::numeric_limits<double>::infinity();
    for (uint32_t i = 0; i < face.count; ++i) {
        Double3 along = corner(i + 1) - corner(i);
        along = along - dot(along, z) * z;
        const double size = length(along);
        if (!(size > 0.0)) continue;
        along = 1.0 / size * along;
        const Double3 across = cross(z, along);
        double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300};
        for (uint32_t k = 0; k < face.count; ++k) {
            const double at[2] = {dot(along, corner(k)), dot(across, corner(k))};
            for (uint32_t c = 0; c < 2; ++c) {
                low[c] = std::min(low[c], at[c]);
                high[c] = std::max(high[c], at[c]);
            }
        }
        const double area = (high[0] - low[0]) * (high[1] - low[1]);
        if (area < least_area * (1.0 - 1e-6)) {
            least_area = area;
            best = rotation_to(along, z);
        }
    }
    return best;
}

// Leaves out the corners that take the least area with them (Visvalingam and Whyatt 1993).
void set_coarse_outline(MeetingShape& out) {
    uint32_t kept[most_shape_points] = {}, count = out.shape.count;
    for (uint32_t i = 0; i < count; ++i) kept[i] = i;
    while (count > MeetingShape::coarse_most) {
        uint32_t least_at = 0;
        float least_area = std::numeric_limits<float>::infinity();
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t before = kept[(i + count - 1) % count], at = kept[i], after = kept[(i + 1) % count];
            const float area = (out.x[at] - out.x[before]) * (out.y[after] - out.y[before]) -
                               (out.y[at] - out.y[before]) * (out.x[after] - out.x[before]);
            if (area < least_area) {
                least_area = area;
                least_at = i;
            }
        }
        for (uint32_t i = least_at; i + 1 < count; ++i) kept[i] = kept[i + 1];
        --count;
    }
    out.coarse_count = count;
    for (uint32_t i = 0; i < MeetingShape::coarse_room; ++i) {
        out.coarse_x[i] = out.x[kept[i < count ? i : 0]];
        out.coarse_y[i] = out.y[kept[i < count ? i : 0]];
    }
}

void set_own_points(MeetingShape& out) {
    const BodyShape& shape = out.shape;
    const uint32_t count = shape.count;
    const Rotation to_own = inverse(out.frame);
    Vector low{}, high{}, sum{};
    Vector points[most_shape_points];
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t at = out.flat ? shape.corners[shape.faces[0].first + i] : i;
        const Vector p = rotate(to_own, {shape.x[at], shape.y[at], shape.z[at]});
        points[i] = p;
        low = i == 0 ? p : low_of(low, p);
        high = i == 0 ? p : high_of(high, p);
    }
    const Vector middle = 0.5f * (low + high);
    out.origin = rotate(out.frame, middle);
    out.core_half = 0.5f * (high - low);
    if (out.flat) out.core_half.z = 0.0f;
    out.padded = (count + MeetingShape::lanes - 1) / MeetingShape::lanes * MeetingShape::lanes;
    for (uint32_t i = 0; i < MeetingShape::room; ++i) {
        const Vector p = points[i < count ? i : 0] - middle;
        out.x[i] = p.x;
        out.y[i] = p.y;
        out.z[i] = out.flat ? 0.0f : p.z;
        if (i < count) {
            sum = sum + Vector{out.x[i], out.y[i], out.z[i]};
            out.core_reach = std::max(out.core_reach, length(p));
        }
    }
    out.center = 1.0f / static_cast<float>(count) * sum;
    for (uint32_t f = 0; f < most_shape_faces; ++f) {
        const uint32_t from = f < shape.face_count ? f : 0;
        const Vector n =
            out.flat ? Vector{0.0f, 0.0f, from == 0 ? 1.0f : -1.0f} : rotate(to_own, shape.faces[from].normal);
        out.face_x[f] = n.x, out.face_y[f] = n.y, out.face_z[f] = n.z;
        out.face_offset[f] = -std::numeric_limits<float>::infinity();
        for (uint32_t i = 0; i < count; ++i)
            out.face_offset[f] = std::max(out.face_offset[f], dot(n, {out.x[i], out.y[i], out.z[i]}));
    }
    if (!out.flat) return;
    set_coarse_outline(out);
    for (uint32_t i = 0; i < MeetingShape::room; ++i) {
        out.edge_offset[i] = out.core_reach;
        if (i >= count) continue;
        const double x = static_cast<double>(out.x[i]), y = static_cast<double>(out.y[i]);
        const double along = static_cast<double>(out.x[i + 1]) - x, up = static_cast<double>(out.y[i + 1]) - y;
        const double size = std::sqrt(along * along + up * up);
        if (!(size > 0.0)) continue;
        out.edge_x[i] = static_cast<float>(up / size);
        out.edge_y[i] = static_cast<float>(-along / size);
        out.edge_offset[i] = static_cast<float>((up * x - along * y) / size);
    }
}

} // namespace

MeetingShape make_meeting_shape(const BodyShape& shape) {
    MeetingShape out{};
    out.shape = hull_for(shape);
    const BodyShape& s = out.shape;
    out.flat = s.face_count == 2 && s.faces[0].count == s.count;
    out.frame = out.flat ? plate_frame(s) : Rotation{0.0f, 0.0f, 0.0f, 1.0f};
    set_own_points(out);
    Vector low{s.x[0], s.y[0], s.z[0]}, high = low;
    for (uint32_t i = 1; i < s.count; ++i) {
        low = low_of(low, {s.x[i], s.y[i], s.z[i]});
        high = high_of(high, {s.x[i], s.y[i], s.z[i]});
    }
    out.middle = 0.5f * (low + high);
    out.half = 0.5f * (high - low) + Vector{s.radius, s.radius, s.radius};
    return out;
}

Box bounds(const MeetingShape& shape, float scale, const Pose& at) {
    const Rotation q = at.rotation * shape.frame;
    const Vector x = rotate(q, {scale, 0.0f, 0.0f}), y = rotate(q, {0.0f, scale, 0.0f}),
                 z = rotate(q, {0.0f, 0.0f, scale});
    const Vector middle = at.position + scale * rotate(at.rotation, shape.origin);
    // Roundings of turned points and of positions.
    const float out = scale * (shape.shape.radius + 1e-6f * shape.core_reach);
    const auto extent = [&](float from_x, float from_y, float from_z, float about, float& low, float& high) {
        const auto along = [&](uint32_t i) {
            return from_x * load(shape.x + i) + from_y * load(shape.y + i) + from_z * load(shape.z + i);
        };
        Four least_of = along(0), greatest_of = least_of;
        for (uint32_t i = MeetingShape::lanes; i < shape.padded; i += MeetingShape::lanes) {
            const Four a = along(i);
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
