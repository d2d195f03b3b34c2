#include "kernel/compiled_once.h"

#include "collision/body_narrow_phase.h"

#include "collision/contact_patch.h"
#include "collision/pair_contacts.h"
#include "kernel/contact/gjk-inl.h"

#include <algorithm>
#include <array>
#include <limits>

namespace lr {
namespace {

// Tolerance of the distance between cores, as shares of margin plus roundings and of the smaller core.
constexpr float part_of_gap = 0.01f, part_of_size = 1e-3f;
// Overlapping cores are drawn apart by this share of the smaller core, so that GJK finds nearest points.
constexpr float drawn_apart = 0.02f;
constexpr uint32_t most_refinements = 3;
// Contacts closer than this share of the smaller core are duplicates.
constexpr float same = plate_same_place;

// Whether the cores' boxes are at most `enough` apart along all face normals of both; edge against edge is left to GJK. False for NaN. direction: from
// b to a, along the box axis of largest separation or least overlap.
bool boxes_near(const RelativePair& pair, float enough, Vector& direction) {
    const Vector half[2] = {pair.a->core_half, pair.ratio * pair.b->core_half};
    const Vector axes[2][3] = {{{1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}},
                               {pair.axes[0], pair.axes[1], pair.axes[2]}};
    float most = -std::numeric_limits<float>::infinity();
    for (uint32_t k = 0; k < 3; ++k)
        for (const uint32_t of : {0u, 1u}) {
            const Vector n = axes[of][k], other = half[1 - of];
            const auto size = [&](uint32_t i) { return std::abs(dot(axes[1 - of][i], n)); };
            const float along = dot(n, pair.offset);
            const float apart =
                std::abs(along) - (half[of][k] + other.x * size(0) + other.y * size(1) + other.z * size(2));
            if (!(apart <= enough)) return false;
            if (apart > most) most = apart, direction = along > 0.0f ? -n : n;
        }
    return true;
}

struct Drawn {
    Closest closest{};
    Vector shift{};
    float separation = -std::numeric_limits<float>::infinity(); // between the cores along the normal, without the shift
};

// The core's point farthest along a direction.
uint32_t farthest(const float* x, const float* y, const float* z, uint32_t padded, Vector d) {
    Greatest found(load(x) * d.x + load(y) * d.y + load(z) * d.z);
    for (uint32_t i = PairHull::lanes; i < padded; i += PairHull::lanes)
        found.offer(load(x + i) * d.x + load(y + i) * d.y + load(z + i) * d.z, static_cast<int32_t>(i));
    uint32_t at = 0;
    found.get(at);
    return at;
}
Vector farthest_of_a(const PlacedPair& pair, Vector d) {
    const PairHull& a = *pair.a;
    return a.point(farthest(a.x, a.y, a.z, a.padded, d));
}
Vector farthest_of_b(const PlacedPair& pair, Vector d) {
    return pair.point_b(farthest(pair.x, pair.y, pair.z, pair.b->padded, d));
}

// Nearest points with a moved by `shift`. tolerance: of the distance. start: first guess of the normal.
HWY_ATTR Closest closest_points(const PlacedPair& pair, Vector shift, float tolerance, Vector start) {
    using Lane = HWY_NAMESPACE::OnePair<float, Vector, false, 24>;
    const auto support = [&](Vector d) {
        const Vector on_a = farthest_of_a(pair, -d) + shift;
        return HWY_NAMESPACE::Corner<Lane>{on_a - farthest_of_b(pair, d), on_a};
    };
    const auto found = HWY_NAMESPACE::closest<Lane>(support, start, std::numeric_limits<float>::infinity(),
                                                    touching_cores * pair.size, tolerance);
    return {found.overlap ? Closest::State::overlap : Closest::State::apart, 1.0f / found.distance * found.v,
            found.distance, found.on_a, found.on_a - found.v};
}

// Draws a out of b along n, where the cores' separation is known. The nearest points then give a better direction.
void draw_out(const PlacedPair& pair, Vector n, float separation, float apart, Drawn& best) {
    for (uint32_t round = 0; round < most_refinements; ++round) {
        const Vector shift = (apart - separation) * n;
        Closest closest = closest_points(pair, shift, 1e-3f * apart, n);
        if (closest.state == Closest::State::overlap) {
            // By rounding: the cores are apart along n. The smaller core's point is used, since the larger one's can be far from the other core.
            const bool by_a = pair.a->core_reach < pair.ratio * pair.b->core_reach;
            closest.state = Closest::State::apart;
            closest.normal = n;
            closest.distance = apart;
            closest.on_a = by_a ? farthest_of_a(pair, -n) + shift : farthest_of_b(pair, n) + apart * n;
            closest.on_b = closest.on_a - apart * n;
        }
        const float here = closest.distance - dot(shift, closest.normal);
        if (here > best.separation) best = {closest, shift, here};
        // Further gain would be rounding.
        if (!(here > separation + 0.01f * apart)) return;
        n = closest.normal;
        separation = here;
    }
}

// The face of a core with the largest distance or least depth of points, in the core's own frame.
struct BestFace {
    Vector outward;
    float separation;
};
BestFace best_face(const PairHull& core, const float* x, const float* y, const float* z, uint32_t count) {
    Greatest best(all(-std::numeric_limits<float>::infinity()));
    for (uint32_t f = 0; f < core.shape.face_count; f += PairHull::lanes) {
        const Float4 nx = load(core.face_x + f), ny = load(core.face_y + f), nz = load(core.face_z + f);
        Float4 deepest = nx * x[0] + ny * y[0] + nz * z[0];
        for (uint32_t i = 1; i < count; ++i) deepest = less(nx * x[i] + ny * y[i] + nz * z[i], deepest);
        best.offer(deepest - load(core.face_offset + f), static_cast<int32_t>(f));
    }
    uint32_t at = 0;
    const float separation = best.get(at);
    return {core.face_normal(at), separation};
}

// For overlapping cores the search starts from the best face of each and from the line of the centres.
Drawn resolve_overlap(const PlacedPair& pair) {
    const PairHull &a = *pair.a, &b = *pair.b;
    const float apart = drawn_apart * std::min(a.core_reach, pair.ratio * b.core_reach);
    float x[most_shape_points], y[most_shape_points], z[most_shape_points]; // a's points in b's frame
    for (uint32_t i = 0; i < a.shape.count; ++i) {
        const Vector p = 1.0f / pair.ratio * pair.to_b(a.point(i) - pair.offset);
        x[i] = p.x, y[i] = p.y, z[i] = p.z;
    }
    BestFace first = best_face(a, pair.x, pair.y, pair.z, b.shape.count);
    first.outward = -first.outward;
    BestFace second = best_face(b, x, y, z, a.shape.count);
    second = {pair.turned(second.outward), pair.ratio * second.separation};
    if (!(first.separation >= second.separation)) std::swap(first, second);
    Drawn best;
    draw_out(pair, first.outward, first.separation, apart, best);
    if (second.separation > 1.5f * best.separation) draw_out(pair, second.outward, second.separation, apart, best);
    const float square = dot(pair.offset, pair.offset);
    if (square > 0.0f) {
        const Vector n = -1.0f / std::sqrt(square) * pair.offset;
        const float separation = dot(n, farthest_of_a(pair, -n) - farthest_of_b(pair, n));
        if (separation > 1.5f * best.separation) draw_out(pair, n, separation, apart, best);
    }
    return best;
}

uint32_t face_of(const PairHull& core, Vector towards) {
    return farthest(core.face_x, core.face_y, core.face_z, core.shape.face_count, towards);
}
// Adapt the cores of the pair to set_body_side().
struct CoreA {
    const PlacedPair& pair;
    Vector shift;
    uint32_t face_towards(Vector d) const { return face_of(*pair.a, d); }
    Vector face_normal(uint32_t f) const { return pair.a->face_normal(f); }
    Vector point(uint32_t i) const { return pair.a->point(i) + shift; }
};
struct CoreB {
    const PlacedPair& pair;
    uint32_t face_towards(Vector d) const { return face_of(*pair.b, pair.to_b(d)); }
    Vector face_normal(uint32_t f) const { return pair.turned(pair.b->face_normal(f)); }
    Vector point(uint32_t i) const { return pair.point_b(i); }
};

// Of the places with gaps below `limit`, picks the outermost of the deepest, the one farthest from it, and the farthest on both sides of the line
// between. Places closer than `apart` are duplicates. The first of nearly equal places counts: if rounding changed places or their order, stacks
// would creep.
uint32_t spread(const Patch& patch, float limit, float slack, float apart, uint32_t (&out)[most_pair_contacts]) {
    constexpr uint32_t none = UINT32_MAX;
    // The place with the greatest measure above `least`; measures within a hundredth count as equal.
    const auto best = [&](float least, float within, const auto& measure) {
        uint32_t at = none;
        for (uint32_t i = 0; i < patch.count; ++i) {
            const float value = measure(patch.u[i], patch.v[i]);
            if (patch.gap[i] < within && value > least) least = (1.0f + 0.01f) * value, at = i;
        }
        return at;
    };
    float u = 0.0f, v = 0.0f; // the middle of the patch, then the first place
    for (uint32_t i = 0; i < patch.count; ++i) {
        u += patch.u[i] / static_cast<float>(patch.count);
        v += patch.v[i] / static_cast<float>(patch.count);
    }
    const auto squared = [&](float at_u, float at_v) { return (at_u - u) * (at_u - u) + (at_v - v) * (at_v - v); };
    const float deepest = *std::min_element(patch.gap, patch.gap + patch.count);
    out[0] = best(-1.0f, std::min(limit, deepest + slack), squared);
    if (out[0] == none) return 0;
    u = patch.u[out[0]], v = patch.v[out[0]];
    out[1] = best(apart * apart, limit, squared);
    if (out[1] == none) return 1;
    uint32_t count = 2;
    const float du = patch.u[out[1]] - u, dv = patch.v[out[1]] - v, least = apart * std::sqrt(du * du + dv * dv);
    for (const float side : {1.0f, -1.0f}) {
        out[count] =
            best(least, limit, [&](float at_u, float at_v) { return side * (du * (at_v - v) - dv * (at_u - u)); });
        if (out[count] != none) ++count;
    }
    return count;
}

// Puts a pair in one order, so that it gives the same bits either way round.
bool comes_before(const PairBody& a, const PairBody& b) {
    const auto numbers = [](const PairBody& body) {
        const Vector p = body.from.position;
        const Rotation q = body.from.rotation;
        const BodyShape& s = body.shape->shape;
        return std::array{p.x, p.y, p.z, q.x, q.y, q.z, q.w, body.scale, s.reach, s.radius};
    };
    const auto of_a = numbers(a), of_b = numbers(b);
    for (size_t i = 0; i < of_a.size(); ++i)
        if (of_a[i] != of_b[i]) return of_a[i] < of_b[i];
    return true;
}

// The bodies must be in the order of comes_before().
bool relate_ordered(const PairBody& one, const PairBody& other, float margin, NearPair& near) {
    const PairHull &a = *one.shape, &b = *other.shape;
    const Pose &at_a = one.from, &at_b = other.from;
    const float scale_a = one.scale, scale_b = other.scale;
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
    return boxes_near(pair, near.enough + 1e-6f * pair.size, near.start);
}
} // namespace

bool relate(const PairBody& a, const PairBody& b, float margin, NearPair& out) {
    out.swapped = !comes_before(a, b);
    return out.swapped ? relate_ordered(b, a, margin, out) : relate_ordered(a, b, margin, out);
}

uint32_t contacts_of(const NearPair& near, Closest closest, PairContact (&out)[most_pair_contacts]) {
    if (closest.state == Closest::State::beyond) return 0;
    const PlacedPair pair(near.pair);
    const PairHull &a = *pair.a, &b = *pair.b;
    Vector shift{0.0f, 0.0f, 0.0f};
    if (closest.state == Closest::State::overlap) {
        const Drawn drawn = resolve_overlap(pair);
        closest = drawn.closest;
        shift = drawn.shift;
    }
    const Vector n = closest.normal;
    const float lifted = dot(shift, n), limit = near.enough + lifted, left = limit - closest.distance;
    const float smaller = std::min(a.core_reach, pair.ratio * b.core_reach);
    const Across across(n);
    Side on_a, on_b;
    set_body_side(a.shape, CoreA{pair, shift}, across, -n, left, on_a);
    set_body_side(b.shape, CoreB{pair}, across, n, left, on_b);
    Patch patch;
    lay_over(on_a, on_b, 1e-5f * smaller, patch);
    // Adds the nearest points, unless some place is about as deep.
    const float slack = std::max(std::min(0.02f * left, 2e-3f * smaller), 0.0f);
    const uint32_t of_sides = patch.count;
    const float* const deepest = std::min_element(patch.gap, patch.gap + of_sides);
    if (of_sides == 0 || !(*deepest <= closest.distance + slack)) {
        patch.gap[of_sides] = closest.distance;
        patch.add(dot(across.u, closest.on_b), dot(across.v, closest.on_b));
    }
    uint32_t places[most_pair_contacts];
    const uint32_t count = spread(patch, limit, slack, same * smaller, places);
    const ContactFrame frame(near, n, shift);
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t k = places[i];
        const Vector on_core =
            k < of_sides ? across.at(patch.u[k], patch.v[k], on_b.height_at(patch.u[k], patch.v[k])) : closest.on_b;
        out[i] = frame.contact(on_core, patch.gap[k]);
    }
    return count;
}

ContactFrame::ContactFrame(const NearPair& near, Vector normal, Vector shift)
    : near_(near), normal_(normal), world_normal_(rotate(near.own_a, normal)), shift_(shift) {
    world_normal_ = 1.0f / length(world_normal_) * world_normal_;
}

PairContact ContactFrame::contact(Vector on_core_b, float gap) const {
    const RelativePair& pair = near_.pair;
    const PairHull &a = *pair.a, &b = *pair.b;
    PairContact c;
    c.normal = near_.swapped ? -world_normal_ : world_normal_;
    c.gap = near_.scale_a * (gap - dot(shift_, normal_) - a.shape.radius - near_.radius_b);
    const Vector on_core_a = on_core_b + gap * normal_ - shift_;
    c.arm_a = near_.scale_a * (a.origin + rotate(a.frame, on_core_a - a.shape.radius * normal_));
    const Vector from_b = on_core_b + near_.radius_b * normal_ - pair.offset;
    const Vector in_b{dot(pair.axes[0], from_b), dot(pair.axes[1], from_b), dot(pair.axes[2], from_b)};
    c.arm_b = near_.scale_b * b.origin + rotate(b.frame, near_.scale_a * in_b);
    if (near_.swapped) std::swap(c.arm_a, c.arm_b);
    return c;
}
} // namespace lr
