#include "contact/body_pair.h"

#include "contact/placed_pair.h"

#include <algorithm>
#include <limits>

namespace lr {
namespace {

// Of the sum of margin and roundings, and of the smaller core: how exactly distances of cores are found.
constexpr float part_of_gap = 0.01f, part_of_size = 1e-3f;
// Of the smaller core: how far apart cores that overlap are drawn to find what they would touch with.
constexpr float drawn_apart = 0.02f;
constexpr uint32_t most_refinements = 3;

// Whether the boxes about the cores are farther apart than `enough`, by any of the fifteen axes (Gottschalk et al. 1996).
// Anything that is not finite is.
bool boxes_apart(const PlacedPair& pair, float enough) {
    const float a[3] = {pair.a->core_half.x, pair.a->core_half.y, pair.a->core_half.z};
    const float b[3] = {pair.ratio * pair.b->core_half.x, pair.ratio * pair.b->core_half.y,
                        pair.ratio * pair.b->core_half.z};
    const float t[3] = {pair.offset.x, pair.offset.y, pair.offset.z};
    float r[3][3], abs_r[3][3], along_b[3];
    for (uint32_t k = 0; k < 3; ++k) {
        r[0][k] = pair.axes[k].x;
        r[1][k] = pair.axes[k].y;
        r[2][k] = pair.axes[k].z;
        for (uint32_t i = 0; i < 3; ++i) abs_r[i][k] = std::abs(r[i][k]);
        along_b[k] = std::abs(dot(pair.axes[k], pair.offset));
    }
    bool near = true;
    for (uint32_t i = 0; i < 3; ++i) {
        near &= std::abs(t[i]) <= a[i] + b[0] * abs_r[i][0] + b[1] * abs_r[i][1] + b[2] * abs_r[i][2] + enough;
        near &= along_b[i] <= b[i] + a[0] * abs_r[0][i] + a[1] * abs_r[1][i] + a[2] * abs_r[2][i] + enough;
    }
    if (!near) return true;
    // Cross products are no longer than 1: `enough` is too much for them, never too little.
    for (uint32_t i = 0; i < 3; ++i) {
        const uint32_t j = (i + 1) % 3, k = (i + 2) % 3;
        for (uint32_t l = 0; l < 3; ++l) {
            const uint32_t m = (l + 1) % 3, n = (l + 2) % 3;
            const float across = std::abs(t[k] * r[j][l] - t[j] * r[k][l]);
            near &=
                across <= a[j] * abs_r[k][l] + a[k] * abs_r[j][l] + b[m] * abs_r[i][n] + b[n] * abs_r[i][m] + enough;
        }
    }
    return !near;
}

// Whether a plate's core covers a point of its plane.
bool covers(const MeetingShape& plate, float x, float y) {
    Four most = load(plate.edge_x) * x + load(plate.edge_y) * y - load(plate.edge_offset);
    for (uint32_t i = MeetingShape::lanes; i < plate.padded; i += MeetingShape::lanes)
        most = greater(most, load(plate.edge_x + i) * x + load(plate.edge_y + i) * y - load(plate.edge_offset + i));
    return greatest(most) <= 0.0f;
}

// The least height of one core over the plane of the other, where it lies on one side of it: no distance is less.
struct OverPlate {
    float height = -std::numeric_limits<float>::infinity();
    Vector normal{}; // from b to a
};
OverPlate over(const float* x, const float* y, const float* z, uint32_t padded, Vector plane, Vector origin,
               float sign) {
    const auto height = [&](uint32_t i) {
        return (load(x + i) - origin.x) * plane.x + (load(y + i) - origin.y) * plane.y +
               (load(z + i) - origin.z) * plane.z;
    };
    Four low = height(0), high = low;
    for (uint32_t i = MeetingShape::lanes; i < padded; i += MeetingShape::lanes) {
        const Four h = height(i);
        low = less(h, low);
        high = greater(h, high);
    }
    const float above = least(low), below = -greatest(high);
    // sign: 1 where the plane is b's, then the normal points to where a is.
    return above > below ? OverPlate{above, sign * plane} : OverPlate{below, -sign * plane};
}

// The nearest points where one of them is a point over the inside of a plate.
bool closest_over_plate(const PlacedPair& pair, const OverPlate& over, bool plate_is_a, Closest& out) {
    out.state = Closest::State::apart;
    out.normal = over.normal;
    float along = 0.0f;
    if (plate_is_a) {
        out.on_b = pair.point_b(farthest_of_b(pair, over.normal, along));
        out.distance = std::abs(out.on_b.z);
        out.on_a = {out.on_b.x, out.on_b.y, 0.0f};
        return covers(*pair.a, out.on_b.x, out.on_b.y);
    }
    out.on_a = pair.point_a(farthest_of_a(pair, -over.normal, along));
    const Vector at = pair.to_b(out.on_a - pair.offset);
    out.distance = std::abs(at.z);
    out.on_b = out.on_a - out.distance * out.normal;
    return covers(*pair.b, at.x / pair.ratio, at.y / pair.ratio);
}

struct Drawn {
    Closest closest{};
    Vector shift{};
    float separation = -std::numeric_limits<float>::infinity(); // of the cores along the normal, without the shift
};

// Draws a out of b along n, of which the cores' separation is known, and improves the direction with what is nearest then.
void draw_out(const PlacedPair& pair, Vector n, float separation, float apart, Drawn& best) {
    for (uint32_t round = 0; round < most_refinements; ++round) {
        const Vector shift = (apart - separation) * n;
        Closest closest = closest_points(pair, shift, std::numeric_limits<float>::infinity(), 1e-3f * apart, n);
        if (closest.state != Closest::State::apart) {
            // Along n they are apart all the same.
            float along = 0.0f;
            closest.state = Closest::State::apart;
            closest.normal = n;
            closest.distance = apart;
            // Of the larger core the farthest point may lie far from the other.
            if (pair.a->core_reach < pair.ratio * pair.b->core_reach) {
                closest.on_a = pair.point_a(farthest_of_a(pair, -n, along)) + shift;
                closest.on_b = closest.on_a - apart * n;
            } else {
                closest.on_b = pair.point_b(farthest_of_b(pair, n, along));
                closest.on_a = closest.on_b + apart * n;
            }
        }
        const float here = closest.distance - dot(shift, closest.normal);
        const float before = best.separation;
        if (here > before) best = {closest, shift, here};
        // The rest is rounding.
        if (!(here > separation + 0.01f * apart)) return;
        n = closest.normal;
        separation = here;
    }
}

// Cores that overlap: from the best face of each, and along the line of the middles.
Drawn resolve_overlap(const PlacedPair& pair) {
    const float apart = drawn_apart * std::min(pair.a->core_reach, pair.ratio * pair.b->core_reach);
    struct {
        Vector normal{};
        float separation = -std::numeric_limits<float>::infinity();
    } of_a, of_b;
    float along = 0.0f;
    for (uint32_t f = 0; f < pair.a->shape.face_count; ++f) {
        const Vector n = -pair.a->normals[f];
        const float plane = pair.a->offsets[f];
        if (-dot(n, pair.offset) - plane <= of_a.separation) continue;
        farthest_of_b(pair, n, along);
        if (-along - plane > of_a.separation) of_a = {n, -along - plane};
    }
    for (uint32_t f = 0; f < pair.b->shape.face_count; ++f) {
        const Vector n = pair.turned(pair.b->normals[f]);
        const float plane = pair.ratio * pair.b->offsets[f] + dot(n, pair.offset);
        if (-plane <= of_b.separation) continue;
        farthest_of_a(pair, -n, along);
        if (-along - plane > of_b.separation) of_b = {n, -along - plane};
    }
    Drawn best;
    if (of_a.separation >= of_b.separation) {
        draw_out(pair, of_a.normal, of_a.separation, apart, best);
        if (of_b.separation > 1.5f * best.separation) draw_out(pair, of_b.normal, of_b.separation, apart, best);
    } else {
        draw_out(pair, of_b.normal, of_b.separation, apart, best);
        if (of_a.separation > 1.5f * best.separation) draw_out(pair, of_a.normal, of_a.separation, apart, best);
    }
    const float square = dot(pair.offset, pair.offset);
    if (square > 0.0f) {
        const Vector n = -1.0f / std::sqrt(square) * pair.offset;
        float out = 0.0f;
        farthest_of_a(pair, -n, out);
        farthest_of_b(pair, n, along);
        if (-out - along > 1.5f * best.separation) draw_out(pair, n, -out - along, apart, best);
    }
    return best;
}

// Whether a comes before b: the same pair is computed in the same order, however it is given.
bool comes_before(const MeetingShape& a, float scale_a, const Pose& at_a, const MeetingShape& b, float scale_b,
                  const Pose& at_b) {
    const float of_a[] = {at_a.position.x, at_a.position.y, at_a.position.z, at_a.rotation.x, at_a.rotation.y,
                          at_a.rotation.z, at_a.rotation.w, scale_a,         a.shape.reach,   a.shape.radius};
    const float of_b[] = {at_b.position.x, at_b.position.y, at_b.position.z, at_b.rotation.x, at_b.rotation.y,
                          at_b.rotation.z, at_b.rotation.w, scale_b,         b.shape.reach,   b.shape.radius};
    for (uint32_t i = 0; i < 10; ++i)
        if (of_a[i] != of_b[i]) return of_a[i] < of_b[i];
    return true;
}

uint32_t find_ordered(const MeetingShape& a, float scale_a, const Pose& at_a, const MeetingShape& b, float scale_b,
                      const Pose& at_b, float margin, PairContact (&out)[most_pair_contacts]) {
    PlacedPair pair;
    const Rotation own_a = at_a.rotation * a.frame, own_b = at_b.rotation * b.frame;
    const Vector between = (at_b.position - at_a.position) +
                           (scale_b * rotate(at_b.rotation, b.origin) - scale_a * rotate(at_a.rotation, a.origin));
    const float unit = 1.0f / scale_a, radius_b = scale_b * unit * b.shape.radius;
    pair.a = &a;
    pair.b = &b;
    pair.ratio = scale_b * unit;
    pair.offset = unit * rotate(inverse(own_a), between);
    const float enough = unit * margin + a.shape.radius + radius_b;
    const Rotation q = inverse(own_a) * own_b;
    const float x2 = 2.0f * q.x, y2 = 2.0f * q.y, z2 = 2.0f * q.z;
    const float xx = x2 * q.x, yy = y2 * q.y, zz = z2 * q.z, xy = x2 * q.y, xz = x2 * q.z, yz = y2 * q.z;
    const float wx = x2 * q.w, wy = y2 * q.w, wz = z2 * q.w;
    pair.axes[0] = {1.0f - (yy + zz), xy + wz, xz - wy};
    pair.axes[1] = {xy - wz, 1.0f - (xx + zz), yz + wx};
    pair.axes[2] = {xz + wy, yz - wx, 1.0f - (xx + yy)};
    const float reach_b = pair.ratio * b.core_reach;
    pair.size = a.core_reach > reach_b ? a.core_reach : reach_b;
    if (boxes_apart(pair, enough + 1e-6f * pair.size)) return 0;
    pair.place_points();

    OverPlate over_a, over_b;
    if (a.flat) over_a = over(pair.x, pair.y, pair.z, b.padded, {0.0f, 0.0f, 1.0f}, {0.0f, 0.0f, 0.0f}, -1.0f);
    if (b.flat) over_b = over(a.x, a.y, a.z, a.padded, pair.axes[2], pair.offset, 1.0f);
    const bool plate_is_a = over_a.height >= over_b.height;
    const OverPlate& over_plate = plate_is_a ? over_a : over_b;
    if (over_plate.height > enough) return 0;
    const float smaller = a.core_reach < reach_b ? a.core_reach : reach_b;
    Closest closest{};
    Vector shift{0.0f, 0.0f, 0.0f};
    if (!(over_plate.height > 1e-4f * smaller && closest_over_plate(pair, over_plate, plate_is_a, closest))) {
        Vector start = over_plate.normal;
        if (!(over_plate.height > 0.0f)) {
            const float square = dot(pair.offset, pair.offset);
            start = square > 0.0f ? -1.0f / std::sqrt(square) * pair.offset : Vector{0.0f, 0.0f, 1.0f};
        }
        const float tolerance =
            part_of_gap * enough < part_of_size * smaller ? part_of_gap * enough : part_of_size * smaller;
        closest = closest_points(pair, shift, enough, tolerance, start);
        if (closest.state == Closest::State::beyond) return 0;
        if (closest.state == Closest::State::overlap) {
            const Drawn drawn = resolve_overlap(pair);
            closest = drawn.closest;
            shift = drawn.shift;
        }
    }
    PairPoint points[most_pair_contacts];
    const uint32_t count = spread_points(pair, closest, shift, enough, points);
    const Vector n = closest.normal;
    Vector normal = rotate(own_a, n);
    normal = 1.0f / length(normal) * normal;
    for (uint32_t i = 0; i < count; ++i) {
        PairContact& c = out[i];
        c.normal = normal;
        c.gap = scale_a * (points[i].gap - a.shape.radius - radius_b);
        c.arm_a = scale_a * (a.origin + rotate(a.frame, points[i].on_a - a.shape.radius * n));
        const Vector on_b = points[i].on_b + radius_b * n - pair.offset;
        c.arm_b = scale_b * b.origin + rotate(b.frame, scale_a * pair.to_b(on_b));
    }
    return count;
}

} // namespace

uint32_t find_pair_contacts(const MeetingShape& a, float scale_a, const Pose& at_a, const MeetingShape& b,
                            float scale_b, const Pose& at_b, float margin, PairContact (&out)[most_pair_contacts]) {
    if (comes_before(a, scale_a, at_a, b, scale_b, at_b))
        return find_ordered(a, scale_a, at_a, b, scale_b, at_b, margin, out);
    const uint32_t count = find_ordered(b, scale_b, at_b, a, scale_a, at_a, margin, out);
    for (uint32_t i = 0; i < count; ++i) {
        std::swap(out[i].arm_a, out[i].arm_b);
        out[i].normal = -out[i].normal;
    }
    return count;
}

} // namespace lr
