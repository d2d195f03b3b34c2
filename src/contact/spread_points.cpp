#include "contact/placed_pair.h"

#include <algorithm>
#include <limits>

namespace lr {
namespace {

constexpr uint32_t lanes = MeetingShape::lanes, room = MeetingShape::room;
// Cosine between a face and the normal below which the face is seen edge on, and its edge counts instead.
constexpr float edge_on = 0.2f;
// Of the smaller core: contacts nearer together say the same.
constexpr float same = 0.02f;
// Tangent of the angle between faces from which the contacts are spread along the slope and not along the plate.
constexpr float slope_counts = 0.02f;
constexpr uint32_t most_walks = 2;

// A face of a core that looks at the other: points in axes of their own, given in the pair's frame.
struct Side {
    bool faces = false;  // not seen edge on
    bool counter = true; // points go counter-clockwise about `normal`
    Vector normal{};     // outward
    Vector origin{};
    Vector axes[3] = {};
    const float *x = nullptr, *y = nullptr, *z = nullptr; // z: null for a plate
    uint32_t count = 0;
    Vector center{};
    alignas(16) float own_x[room], own_y[room], own_z[room]; // of a solid's face
};

// Of the faces of a solid that hold the point, the one that looks most along the direction, both in its own frame. Count: none.
uint32_t face_at(const MeetingShape& shape, Vector point, Vector direction) {
    const float slack = 1e-3f * shape.core_reach;
    uint32_t best = shape.shape.face_count;
    float most = -1.0f;
    for (uint32_t f = 0; f < shape.shape.face_count; ++f) {
        const float along = dot(shape.face_normal(f), direction);
        if (along > most && dot(shape.face_normal(f), point) > shape.face_offset[f] - slack) {
            most = along;
            best = f;
        }
    }
    return best;
}

// point, direction: in the shape's own frame, with the origin and the axes of `side`.
bool set_side(const MeetingShape& shape, float scale, Vector point, Vector direction, Side& side) {
    if (shape.flat) {
        side.counter = direction.z > 0.0f;
        side.normal = side.counter ? side.axes[2] : -side.axes[2];
        side.faces = std::abs(direction.z) > edge_on;
        side.x = shape.coarse_x;
        side.y = shape.coarse_y;
        side.count = shape.coarse_count;
        side.center = shape.center;
    } else {
        const uint32_t f = face_at(shape, point, direction);
        if (f == shape.shape.face_count) return false;
        const Vector n = shape.face_normal(f);
        side.normal = n.x * side.axes[0] + n.y * side.axes[1] + n.z * side.axes[2];
        side.faces = dot(n, direction) > edge_on;
        if (!side.faces) return true;
        const ShapeFace& face = shape.shape.faces[f];
        side.count = face.count;
        for (uint32_t i = 0; i < face.count + lanes + 1u && i < room; ++i) {
            const uint32_t at = shape.shape.corners[face.first + (i < face.count ? i : 0)];
            side.own_x[i] = shape.x[at];
            side.own_y[i] = shape.y[at];
            side.own_z[i] = shape.z[at];
            if (i < face.count) side.center = side.center + Vector{shape.x[at], shape.y[at], shape.z[at]};
        }
        side.center = 1.0f / static_cast<float>(face.count) * side.center;
        side.x = side.own_x;
        side.y = side.own_y;
        side.z = side.own_z;
    }
    for (Vector& axis : side.axes) axis = scale * axis;
    side.center =
        side.origin + side.center.x * side.axes[0] + side.center.y * side.axes[1] + side.center.z * side.axes[2];
    return true;
}

// Four places or directions in the plane across the normal, a lane each.
struct Flats {
    Four u, v;
};

// What both faces cover, seen along the normal: half-planes n . p <= off around the nearest point. Asked from four places at once.
struct Region {
    uint32_t count = 0;
    static constexpr uint32_t most = 2 * room + 2 * lanes;
    alignas(16) float nu[most], nv[most], off[most], inverse[most], along[most];

    // The edges of a face, in axes u and v across the normal n.
    void add_edges(const Side& side, Vector u, Vector v, Vector n, Vector around) {
        const Vector base = side.origin - around;
        const float base_u = dot(u, base), base_v = dot(v, base);
        const float ux = dot(u, side.axes[0]), uy = dot(u, side.axes[1]), uz = dot(u, side.axes[2]);
        const float vx = dot(v, side.axes[0]), vy = dot(v, side.axes[1]), vz = dot(v, side.axes[2]);
        const float sense = (dot(side.normal, n) > 0.0f) == side.counter ? 1.0f : -1.0f;
        for (uint32_t i = 0; i < side.count; i += lanes) {
            const Four x = load(side.x + i), y = load(side.y + i);
            const Four ex = load(side.x + i + 1) - x, ey = load(side.y + i + 1) - y;
            Four pu = base_u + x * ux + y * uy, pv = base_v + x * vx + y * vy;
            Four eu = ex * ux + ey * uy, ev = ex * vx + ey * vy;
            if (side.z) {
                const Four z = load(side.z + i), ez = load(side.z + i + 1) - z;
                pu = pu + z * uz;
                pv = pv + z * vz;
                eu = eu + ez * uz;
                ev = ev + ez * vz;
            }
            const Four across_u = sense * ev, across_v = -sense * eu;
            store(across_u, nu + count + i);
            store(across_v, nv + count + i);
            store(across_u * pu + across_v * pv, off + count + i);
        }
        count += side.count;
    }
    // u <= limit / slope, in numbers as large as those of edges.
    void add_limit(float slope, float limit, float size) {
        nu[count] = size * slope;
        nv[count] = 0.0f;
        off[count] = size * (limit > 0.0f ? limit : 0.0f);
        ++count;
    }
    // When all are there: half-planes that a way has to leave more steeply than this to end at them.
    void close() {
        for (const auto& numbers : {nu, nv, off}) store(all(0.0f), numbers + count);
        for (uint32_t i = 0; i < count; i += lanes) {
            const Four u = load(nu + i), v = load(nv + i);
            store(1e-4f * (greater(u, -u) + greater(v, -v)), along + i);
        }
    }
    // The part of each way d from `from`, at most `longest`, that is inside; at: what ends it, or -1.
    Four ways(const Flats& from, const Flats& d, Four longest, FourInts& at) const {
        const Four size = greater(d.u, -d.u) + greater(d.v, -d.v);
        Four best = longest;
        at = FourInts{-1, -1, -1, -1};
        for (uint32_t k = 0; k < count; ++k) {
            const Four out = nu[k] * d.u + nv[k] * d.v, left = off[k] - nu[k] * from.u - nv[k] * from.v;
            const FourInts ends = (out > along[k] * size) & (left < best * out);
            const auto place = static_cast<int32_t>(k);
            best = ends ? left / out : best;
            at = ends ? FourInts{place, place, place, place} : at;
        }
        return best > all(0.0f) ? best : all(0.0f);
    }
    bool holds(float u, float v) const {
        Four least_left = all(0.0f);
        for (uint32_t i = 0; i < count; i += lanes)
            least_left = less(load(off + i) - load(nu + i) * u - load(nv + i) * v, least_left);
        return least(least_left) >= 0.0f;
    }
    // The corners farthest along d and its quarter turns, from a place inside. least_room: of the middle to edges, as half-planes are.
    Flats extremes(float middle_u, float middle_v, float du, float dv, float least_room) {
        for (uint32_t i = 0; i < count; i += lanes) {
            const Four left = load(off + i) - load(nu + i) * middle_u - load(nv + i) * middle_v;
            store(1.0f / greater(left, all(least_room)), inverse + i);
        }
        const Flats d{{du, -dv, -du, dv}, {dv, du, -dv, -du}};
        // The ends of rays.
        Four nearest = all(0.0f);
        FourInts at{0, 0, 0, 0};
        for (uint32_t k = 0; k < count; ++k) {
            const Four value = (nu[k] * d.u + nv[k] * d.v) * inverse[k];
            const auto place = static_cast<int32_t>(k);
            const FourInts better = value > nearest;
            nearest = better ? value : nearest;
            at = better ? FourInts{place, place, place, place} : at;
        }
        const Four way = 1.0f / nearest;
        Flats p{middle_u + way * d.u, middle_v + way * d.v};
        // From there along the edges while that leads farther, always the same way round.
        Four turn = all(0.0f);
        for (uint32_t walk = 0; walk < most_walks; ++walk) {
            float u[lanes], v[lanes];
            for (uint32_t lane = 0; lane < lanes; ++lane) {
                const int32_t k = at[lane] < 0 ? 0 : at[lane];
                u[lane] = nu[k];
                v[lane] = nv[k];
            }
            const Flats n{load(u), load(v)};
            const Four gain = d.v * n.u - d.u * n.v;
            // Of edges across d all go the same way round, so that each leads to a corner of its own.
            if (walk == 0) turn = gain >= -0.02f * (greater(n.u, -n.u) + greater(n.v, -n.v)) ? all(1.0f) : all(-1.0f);
            const Flats edge{-turn * n.v, turn * n.u};
            FourInts next;
            Four t = ways(p, edge, all(1e30f), next);
            FourInts on = (next >= 0) & (at >= 0);
            if (walk > 0) on &= turn * gain > all(0.0f);
            t = on ? t : all(0.0f);
            at = on ? next : FourInts{-1, -1, -1, -1};
            p = {p.u + t * edge.u, p.v + t * edge.v};
        }
        return p;
    }
};

// The ends of what of a core lies no higher than `band` above its lowest point along `down`: an edge, or the part of a rim. base: what
// is added to its points.
void edge_ends(const float* x, const float* y, const float* z, uint32_t padded, Vector down, Vector along, float lowest,
               float band, uint32_t (&ends)[2]) {
    const Four none = all(-std::numeric_limits<float>::infinity());
    Greatest first(none), last(none);
    for (uint32_t i = 0; i < padded; i += lanes) {
        const Four px = load(x + i), py = load(y + i), pz = load(z + i);
        const FourInts low = px * down.x + py * down.y + pz * down.z >= all(lowest - band);
        const Four t = px * along.x + py * along.y + pz * along.z;
        first.offer(low ? -t : none, static_cast<int32_t>(i));
        last.offer(low ? t : none, static_cast<int32_t>(i));
    }
    first.get(ends[0]);
    last.get(ends[1]);
}

struct Spread {
    const PlacedPair& pair;
    const Closest& closest;
    float lifted;  // of the shift along the normal
    float limit;   // of gaps with the shift
    float smaller; // of the cores' reaches
    Vector shift;
    PairPoint (&out)[most_pair_contacts];
    uint32_t count = 0;

    // b's point of the core and the gap above it.
    void add(Vector on_b, float gap) {
        if (!(gap < limit)) return;
        for (uint32_t i = 0; i < count; ++i) {
            const Vector d = out[i].on_b - on_b;
            if (dot(d, d) < same * same * smaller * smaller) return;
        }
        if (count < most_pair_contacts) out[count++] = {on_b + gap * closest.normal - shift, on_b, gap - lifted};
    }
    // The nearest points first, unless what is there is as deep.
    void finish() {
        uint32_t deepest = 0, shallowest = 0;
        for (uint32_t i = 1; i < count; ++i) {
            if (out[i].gap < out[deepest].gap) deepest = i;
            if (out[i].gap > out[shallowest].gap) shallowest = i;
        }
        const float slack = std::min(0.02f * (limit - closest.distance), 2e-3f * smaller);
        const PairPoint nearest{closest.on_b + closest.distance * closest.normal - shift, closest.on_b,
                                closest.distance - lifted};
        if (count == 0 || out[deepest].gap > nearest.gap + std::max(slack, 0.0f)) {
            const uint32_t at = count < most_pair_contacts ? count++ : shallowest;
            out[at] = nearest;
            deepest = at;
        }
        std::swap(out[0], out[deepest]);
    }
};

void spread_over_faces(Spread& spread, const Side& a, const Side& b) {
    const Vector n = spread.closest.normal, around = spread.closest.on_b;
    const Vector rise_b = n - 1.0f / dot(b.normal, n) * b.normal;
    const Vector rise_a = n - 1.0f / dot(a.normal, n) * a.normal;
    const Vector slope_of_gap = rise_a - rise_b;
    float slope = length(slope_of_gap);
    Vector u = slope_of_gap;
    if (!(slope > slope_counts)) {
        u = std::abs(n.x) < 0.9f ? Vector{1.0f, 0.0f, 0.0f} : Vector{0.0f, 1.0f, 0.0f};
        u = u - dot(u, n) * n;
    }
    u = 1.0f / length(u) * u;
    const Vector v = cross(n, u);
    const float slope_u = dot(slope_of_gap, u), slope_v = dot(slope_of_gap, v);
    Region region;
    region.add_edges(a, u, v, n, around);
    region.add_edges(b, u, v, n, around);
    const float size = spread.smaller, left = spread.limit - spread.closest.distance;
    if (slope > slope_counts) region.add_limit(slope, left, size);
    region.close();
    // From the nearest point to the middle of each face, as far as the other goes: between these ends is the inside.
    const Vector to_a = a.center - around, to_b = b.center - around;
    const Flats to{{dot(u, to_a), dot(u, to_b), 0.0f, 0.0f}, {dot(v, to_a), dot(v, to_b), 0.0f, 0.0f}};
    FourInts at;
    const Four part = region.ways({all(0.0f), all(0.0f)}, to, all(1.0f), at) / 3.0f;
    const float middle_u = part[0] * to.u[0] + part[1] * to.u[1], middle_v = part[0] * to.v[0] + part[1] * to.v[1];
    if (!(middle_u * middle_u + middle_v * middle_v > 1e-8f * size * size) || !region.holds(middle_u, middle_v)) return;
    float du = -1.0f, dv = 0.0f;
    for (uint32_t round = 0; round < 2; ++round) {
        const Flats corners = region.extremes(middle_u, middle_v, du, dv, 1e-7f * size * size);
        for (uint32_t i = 0; i < lanes; ++i) {
            const float pu = corners.u[i], pv = corners.v[i];
            const float gap = spread.closest.distance + slope_u * pu + slope_v * pv;
            // Corners at the limit are where the region was cut.
            if (!(gap < spread.limit - 1e-3f * left)) continue;
            const Vector across = pu * u + pv * v;
            spread.add(around + across + dot(rise_b, across) * n, gap);
        }
        if (spread.count < 2 || spread.count == most_pair_contacts || slope > slope_counts) return;
        // Where some are the same it is long and narrow: along its ends, and across.
        float most = 0.0f;
        for (uint32_t i = 1; i < spread.count; ++i)
            for (uint32_t j = 0; j < i; ++j) {
                const Vector between = spread.out[i].on_b - spread.out[j].on_b;
                const float square = dot(between, between);
                if (!(square > most)) continue;
                most = square;
                du = dot(between, u);
                dv = dot(between, v);
            }
        const float inverse_length = 1.0f / std::sqrt(du * du + dv * dv);
        du *= inverse_length;
        dv *= inverse_length;
    }
}

// From the nearest point to an end of an edge, as far as the other's face goes.
void spread_along_edge(Spread& spread, const Side& face, bool edge_is_a, Vector end) {
    const Vector n = spread.closest.normal;
    const Vector from = edge_is_a ? spread.closest.on_a : spread.closest.on_b;
    const Vector way = end - from;
    const Vector rise = n - 1.0f / dot(face.normal, n) * face.normal;
    Vector u = way - dot(way, n) * n;
    const float size = length(u);
    if (!(size > same * spread.smaller)) return;
    u = 1.0f / size * u;
    const Vector v = cross(n, u);
    Region region;
    region.add_edges(face, u, v, n, spread.closest.on_b);
    const float edge_rise = dot(way, n) / size, face_rise = dot(rise, u);
    const float opening = edge_is_a ? edge_rise - face_rise : face_rise - edge_rise;
    region.close();
    FourInts at;
    float t = region.ways({all(0.0f), all(0.0f)}, {all(1.0f), all(0.0f)}, all(size), at)[0];
    const float left = 0.999f * (spread.limit - spread.closest.distance);
    if (opening * t > left) t = left / opening;
    // The nearest point may lie outside of a coarse outline.
    if (!region.holds(0.999f * t, 0.0f)) return;
    const float on_b_rise = edge_is_a ? face_rise : edge_rise;
    spread.add(spread.closest.on_b + t * u + (t * on_b_rise) * n, spread.closest.distance + t * opening);
}

} // namespace

uint32_t spread_points(const PlacedPair& pair, const Closest& closest, Vector shift, float enough,
                       PairPoint (&out)[most_pair_contacts]) {
    const float lifted = dot(shift, closest.normal);
    const float reach_b = pair.ratio * pair.b->core_reach;
    Spread spread{pair, closest, lifted, enough + lifted, std::min(pair.a->core_reach, reach_b), shift, out};
    const Vector n = closest.normal;
    Side a, b;
    a.origin = shift;
    a.axes[0] = {1.0f, 0.0f, 0.0f};
    a.axes[1] = {0.0f, 1.0f, 0.0f};
    a.axes[2] = {0.0f, 0.0f, 1.0f};
    b.origin = pair.offset;
    for (uint32_t k = 0; k < 3; ++k) b.axes[k] = pair.axes[k];
    const bool has_a = set_side(*pair.a, 1.0f, closest.on_a - shift, -n, a);
    const bool has_b =
        set_side(*pair.b, pair.ratio, 1.0f / pair.ratio * pair.to_b(closest.on_b - pair.offset), pair.to_b(n), b);
    if (has_a && has_b && (a.faces || b.faces)) {
        if (a.faces && b.faces) {
            spread_over_faces(spread, a, b);
        } else {
            // The other is seen edge on.
            const bool edge_is_a = !a.faces;
            const Side& edge = edge_is_a ? a : b;
            const Vector along = cross(n, edge.normal), from = edge_is_a ? closest.on_a - shift : closest.on_b;
            const Vector down = edge_is_a ? -n : n;
            const float band = spread.limit - closest.distance;
            uint32_t ends[2];
            if (edge_is_a)
                edge_ends(pair.a->x, pair.a->y, pair.a->z, pair.a->padded, down, along, dot(down, from), band, ends);
            else
                edge_ends(pair.x, pair.y, pair.z, pair.b->padded, down, along, dot(down, from), band, ends);
            for (const uint32_t end : ends)
                spread_along_edge(spread, edge_is_a ? b : a, edge_is_a,
                                  edge_is_a ? pair.point_a(end) + shift : pair.point_b(end));
            // The nearest point may itself be an end.
            if (spread.count == 1) spread.add(closest.on_b, closest.distance);
        }
    }
    spread.finish();
    return spread.count;
}

} // namespace lr
