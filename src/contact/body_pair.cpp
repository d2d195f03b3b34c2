#include "contact/body_pair.h"

#include "contact/placed_pair.h"
#include "kernel/closest-inl.h"

#include <algorithm>
#include <limits>

namespace lr {
namespace {

// Of the sum of margin and roundings, and of the smaller core: how exactly distances of cores are found.
constexpr float part_of_gap = 0.01f, part_of_size = 1e-3f;
// Of the smaller core: how far apart cores that overlap are drawn to find what they would touch with.
constexpr float drawn_apart = 0.02f;
constexpr uint32_t most_refinements = 3;
// Of a core: how far from edges a point over a face is surely nearest to the face.
constexpr float off_edges = 2e-3f;

// With a moved by `shift`. enough: cores farther apart are `beyond`. tolerance: of the distance. start: a guess of the normal.
Closest closest_points(const PlacedPair& pair, Vector shift, float enough, float tolerance, Vector start) {
    using Lane = HWY_NAMESPACE::OnePair<float, Vector, false, 24>;
    const auto support = [&](Vector d) {
        float along = 0.0f;
        const Vector on_a = pair.point_a(farthest_of_a(pair, -d, along)) + shift;
        return HWY_NAMESPACE::Corner<Lane>{on_a - pair.point_b(support_of_b(pair, d)), on_a};
    };
    const auto found = HWY_NAMESPACE::closest<Lane>(support, start, enough, touching_cores * pair.size, tolerance);
    Closest out{};
    out.state = found.beyond ? Closest::State::beyond : found.overlap ? Closest::State::overlap : Closest::State::apart;
    out.distance = found.distance;
    out.normal = 1.0f / found.distance * found.v;
    out.on_a = found.on_a;
    out.on_b = found.on_a - found.v;
    return out;
}

Four rows_of(Vector v, float behind) {
    return Four{v.x, v.y, v.z, behind};
}
Four size_of(Four a) {
    return greater(a, -a);
}
Four next(Four a) {
    return __builtin_shufflevector(a, a, 1, 2, 0, 3);
}
Four after_next(Four a) {
    return __builtin_shufflevector(a, a, 2, 0, 1, 3);
}

// Whether the boxes about the cores are farther apart than `enough`, by any of the fifteen axes (Gottschalk et al. 1996).
// Anything that is not finite is. direction: from b to a, along the axis of either box by which they are farthest apart or overlap
// least.
bool boxes_apart(const RelativePair& pair, float enough, Vector& direction) {
    const Vector half_a = pair.a->core_half, half_b = pair.ratio * pair.b->core_half, t = pair.offset;
    constexpr float never = 1e30f; // the last lane is no axis
    const Four a = rows_of(half_a, never), b = rows_of(half_b, never);
    // b's axes, and what all of them have along each of a's.
    const Four u = rows_of(pair.axes[0], 0.0f), v = rows_of(pair.axes[1], 0.0f), w = rows_of(pair.axes[2], 0.0f);
    const Four x{u[0], v[0], w[0], 0.0f}, y{u[1], v[1], w[1], 0.0f}, z{u[2], v[2], w[2], 0.0f};
    const Four size_x = size_of(x), size_y = size_of(y), size_z = size_of(z);
    const Four along_a = rows_of(t, 0.0f), along_b = x * t.x + y * t.y + z * t.z;
    const Four apart_a = size_of(along_a) - (a + half_b.x * size_of(u) + half_b.y * size_of(v) + half_b.z * size_of(w));
    const Four apart_b = size_of(along_b) - (b + half_a.x * size_x + half_a.y * size_y + half_a.z * size_z);
    const Four most = all(enough);
    const FourInts near = (apart_a <= most) & (apart_b <= most);
    // Cross products are no longer than 1: `enough` is too much for them, never too little.
    const auto across = [&](Four j, Four k, float tj, float tk, float aj, float ak, Four size_j, Four size_k,
                            Four size_i) {
        return size_of(tk * j - tj * k) -
               (aj * size_k + ak * size_j + next(b) * after_next(size_i) + after_next(b) * next(size_i));
    };
    const FourInts edges = (across(y, z, t.y, t.z, half_a.y, half_a.z, size_y, size_z, size_x) <= most) &
                           (across(z, x, t.z, t.x, half_a.z, half_a.x, size_z, size_x, size_y) <= most) &
                           (across(x, y, t.x, t.y, half_a.x, half_a.y, size_x, size_y, size_z) <= most);
    if (any(~(near & edges))) return true;
    Greatest best(apart_a);
    best.offer(apart_b, 4);
    uint32_t at = 0;
    best.get(at);
    const Vector own[8] = {{1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}, {},
                           pair.axes[0],       pair.axes[1],       pair.axes[2],       {}};
    direction = (at < 4 ? along_a[at] : along_b[at - 4]) > 0.0f ? -own[at] : own[at];
    return false;
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

// Whether a core holds a point of its own frame, and is no less deep there than this.
bool holds(const MeetingShape& shape, Vector p, float depth) {
    Four most = all(-std::numeric_limits<float>::infinity());
    for (uint32_t f = 0; f < shape.shape.face_count; f += MeetingShape::lanes)
        most = greater(load(shape.face_x + f) * p.x + load(shape.face_y + f) * p.y + load(shape.face_z + f) * p.z -
                           load(shape.face_offset + f),
                       most);
    return greatest(most) <= -depth;
}

// Along a face's normal the deepest point of the other core is the nearest where it lies over the inside of that face. Over its
// edges other directions may be as good.
enum class FaceOf : uint8_t { a, b, none };
bool closest_over_face(const PlacedPair& pair, FaceOf face, Vector n, float separation, float apart, Closest& out) {
    const Vector shift = (apart - separation) * n;
    float along = 0.0f;
    out.state = Closest::State::apart;
    out.normal = n;
    out.distance = apart;
    if (face == FaceOf::a) {
        out.on_b = pair.point_b(farthest_of_b(pair, n, along));
        const Vector on_face = out.on_b + separation * n;
        out.on_a = on_face + shift;
        const float inward = off_edges * pair.a->core_reach;
        return holds(*pair.a, on_face + inward * n, 0.5f * inward);
    }
    const Vector deepest = pair.point_a(farthest_of_a(pair, -n, along));
    out.on_a = deepest + shift;
    out.on_b = deepest - separation * n;
    const float inward = off_edges * pair.b->core_reach;
    return holds(*pair.b, 1.0f / pair.ratio * pair.to_b(out.on_b - pair.offset) - inward * pair.to_b(n), 0.5f * inward);
}

// Draws a out of b along n, of which the cores' separation is known, and improves the direction with what is nearest then.
void draw_out(const PlacedPair& pair, Vector n, float separation, float apart, FaceOf face, Drawn& best) {
    for (uint32_t round = 0; round < most_refinements; ++round) {
        const Vector shift = (apart - separation) * n;
        Closest closest{};
        if (face == FaceOf::none || round > 0 || !closest_over_face(pair, face, n, separation, apart, closest))
            closest = closest_points(pair, shift, std::numeric_limits<float>::infinity(), 1e-3f * apart, n);
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

// The face of a core of which the other lies farthest out, or least deep.
struct BestFace {
    Vector normal; // from b to a
    float separation;
};
BestFace best_face_of_a(const PlacedPair& pair) {
    const MeetingShape &a = *pair.a, &b = *pair.b;
    Greatest best(all(-std::numeric_limits<float>::infinity()));
    for (uint32_t f = 0; f < a.shape.face_count; f += MeetingShape::lanes) {
        const Four nx = load(a.face_x + f), ny = load(a.face_y + f), nz = load(a.face_z + f);
        Four deepest = nx * pair.x[0] + ny * pair.y[0] + nz * pair.z[0];
        for (uint32_t i = 1; i < b.shape.count; ++i)
            deepest = less(nx * pair.x[i] + ny * pair.y[i] + nz * pair.z[i], deepest);
        best.offer(deepest - load(a.face_offset + f), static_cast<int32_t>(f));
    }
    uint32_t at = 0;
    const float separation = best.get(at);
    return {-a.face_normal(at), separation};
}
BestFace best_face_of_b(const PlacedPair& pair) {
    const MeetingShape &a = *pair.a, &b = *pair.b;
    const Vector u = pair.axes[0], v = pair.axes[1], w = pair.axes[2], t = pair.offset;
    Greatest best(all(-std::numeric_limits<float>::infinity()));
    for (uint32_t f = 0; f < b.shape.face_count; f += MeetingShape::lanes) {
        const Four bx = load(b.face_x + f), by = load(b.face_y + f), bz = load(b.face_z + f);
        const Four nx = bx * u.x + by * v.x + bz * w.x, ny = bx * u.y + by * v.y + bz * w.y,
                   nz = bx * u.z + by * v.z + bz * w.z;
        Four deepest = nx * a.x[0] + ny * a.y[0] + nz * a.z[0];
        for (uint32_t i = 1; i < a.shape.count; ++i) deepest = less(nx * a.x[i] + ny * a.y[i] + nz * a.z[i], deepest);
        best.offer(deepest - pair.ratio * load(b.face_offset + f) - (nx * t.x + ny * t.y + nz * t.z),
                   static_cast<int32_t>(f));
    }
    uint32_t at = 0;
    const float separation = best.get(at);
    return {pair.turned(b.face_normal(at)), separation};
}

// Cores that overlap: from the best face of each, and along the line of the middles.
Drawn resolve_overlap(const PlacedPair& pair) {
    const float apart = drawn_apart * std::min(pair.a->core_reach, pair.ratio * pair.b->core_reach);
    const BestFace of_a = best_face_of_a(pair), of_b = best_face_of_b(pair);
    Drawn best;
    if (of_a.separation >= of_b.separation) {
        draw_out(pair, of_a.normal, of_a.separation, apart, FaceOf::a, best);
        if (of_b.separation > 1.5f * best.separation)
            draw_out(pair, of_b.normal, of_b.separation, apart, FaceOf::b, best);
    } else {
        draw_out(pair, of_b.normal, of_b.separation, apart, FaceOf::b, best);
        if (of_a.separation > 1.5f * best.separation)
            draw_out(pair, of_a.normal, of_a.separation, apart, FaceOf::a, best);
    }
    const float square = dot(pair.offset, pair.offset);
    if (square > 0.0f) {
        const Vector n = -1.0f / std::sqrt(square) * pair.offset;
        float out = 0.0f, along = 0.0f;
        farthest_of_a(pair, -n, out);
        farthest_of_b(pair, n, along);
        if (-out - along > 1.5f * best.separation) draw_out(pair, n, -out - along, apart, FaceOf::none, best);
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

// The first is the one that comes before.
bool relate_ordered(const MeetingShape& a, float scale_a, const Pose& at_a, const MeetingShape& b, float scale_b,
                    const Pose& at_b, float margin, NearPair& near) {
    RelativePair& pair = near.pair;
    const Rotation own_a = at_a.rotation * a.frame, own_b = at_b.rotation * b.frame;
    const Vector between = (at_b.position - at_a.position) +
                           (scale_b * rotate(at_b.rotation, b.origin) - scale_a * rotate(at_a.rotation, a.origin));
    const float unit = 1.0f / scale_a;
    near.own_a = own_a;
    near.scale_a = scale_a;
    near.scale_b = scale_b;
    near.radius_b = scale_b * unit * b.shape.radius;
    near.enough = unit * margin + a.shape.radius + near.radius_b;
    pair.a = &a;
    pair.b = &b;
    pair.ratio = scale_b * unit;
    pair.offset = unit * rotate(inverse(own_a), between);
    const Rotation q = inverse(own_a) * own_b;
    const float x2 = 2.0f * q.x, y2 = 2.0f * q.y, z2 = 2.0f * q.z;
    const float xx = x2 * q.x, yy = y2 * q.y, zz = z2 * q.z, xy = x2 * q.y, xz = x2 * q.z, yz = y2 * q.z;
    const float wx = x2 * q.w, wy = y2 * q.w, wz = z2 * q.w;
    pair.axes[0] = {1.0f - (yy + zz), xy + wz, xz - wy};
    pair.axes[1] = {xy - wz, 1.0f - (xx + zz), yz + wx};
    pair.axes[2] = {xz + wy, yz - wx, 1.0f - (xx + yy)};
    const float reach_b = pair.ratio * b.core_reach, smaller = a.core_reach < reach_b ? a.core_reach : reach_b;
    pair.size = a.core_reach > reach_b ? a.core_reach : reach_b;
    const float by_gap = part_of_gap * near.enough, by_size = part_of_size * smaller;
    near.tolerance = by_gap < by_size ? by_gap : by_size;
    return !boxes_apart(pair, near.enough + 1e-6f * pair.size, near.start);
}

} // namespace

bool relate(const MeetingShape& a, float scale_a, const Pose& at_a, const MeetingShape& b, float scale_b,
            const Pose& at_b, float margin, NearPair& out) {
    out.swapped = !comes_before(a, scale_a, at_a, b, scale_b, at_b);
    return out.swapped ? relate_ordered(b, scale_b, at_b, a, scale_a, at_a, margin, out)
                       : relate_ordered(a, scale_a, at_a, b, scale_b, at_b, margin, out);
}

uint32_t contacts_of(const NearPair& near, const PlacedPair& pair, Closest closest,
                     PairContact (&out)[most_pair_contacts]) {
    const MeetingShape &a = *pair.a, &b = *pair.b;
    Vector shift{0.0f, 0.0f, 0.0f};
    if (closest.state == Closest::State::beyond) return 0;
    if (closest.state == Closest::State::overlap) {
        const Drawn drawn = resolve_overlap(pair);
        closest = drawn.closest;
        shift = drawn.shift;
    }
    PairPoint points[most_pair_contacts];
    const uint32_t count = spread_points(pair, closest, shift, near.enough, points);
    const Vector n = closest.normal;
    Vector normal = rotate(near.own_a, n);
    normal = 1.0f / length(normal) * normal;
    for (uint32_t i = 0; i < count; ++i) {
        PairContact& c = out[i];
        c.normal = near.swapped ? -normal : normal;
        c.gap = near.scale_a * (points[i].gap - a.shape.radius - near.radius_b);
        c.arm_a = near.scale_a * (a.origin + rotate(a.frame, points[i].on_a - a.shape.radius * n));
        const Vector on_b = points[i].on_b + near.radius_b * n - pair.offset;
        c.arm_b = near.scale_b * b.origin + rotate(b.frame, near.scale_a * pair.to_b(on_b));
        if (near.swapped) std::swap(c.arm_a, c.arm_b);
    }
    return count;
}

uint32_t search_contacts(const NearPair& near, PairContact (&out)[most_pair_contacts]) {
    const MeetingShape &a = *near.pair.a, &b = *near.pair.b;
    PlacedPair pair;
    static_cast<RelativePair&>(pair) = near.pair;
    pair.place_points();
    OverPlate over_a, over_b;
    if (a.flat) over_a = over(pair.x, pair.y, pair.z, b.padded, {0.0f, 0.0f, 1.0f}, {0.0f, 0.0f, 0.0f}, -1.0f);
    if (b.flat) over_b = over(a.x, a.y, a.z, a.padded, pair.axes[2], pair.offset, 1.0f);
    const bool plate_is_a = over_a.height >= over_b.height;
    const OverPlate& over_plate = plate_is_a ? over_a : over_b;
    if (over_plate.height > near.enough) return 0;
    const float reach_b = pair.ratio * b.core_reach, smaller = a.core_reach < reach_b ? a.core_reach : reach_b;
    Closest closest{};
    if (!(over_plate.height > 1e-4f * smaller && closest_over_plate(pair, over_plate, plate_is_a, closest))) {
        const Vector start = over_plate.height > 0.0f ? over_plate.normal : near.start;
        closest = closest_points(pair, {0.0f, 0.0f, 0.0f}, near.enough, near.tolerance, start);
    }
    return contacts_of(near, pair, closest, out);
}

uint32_t find_pair_contacts(const MeetingShape& a, float scale_a, const Pose& at_a, const MeetingShape& b,
                            float scale_b, const Pose& at_b, float margin, PairContact (&out)[most_pair_contacts]) {
    NearPair near;
    return relate(a, scale_a, at_a, b, scale_b, at_b, margin, near) ? search_contacts(near, out) : 0;
}

} // namespace lr
