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
constexpr uint32_t most_walks = 4;

// A face of a core that looks at the other: points in axes of their own, given in the pair's frame.
struct Side {
    bool faces = false;  // not seen edge on
    bool counter = true; // points go counter-clockwise about `normal`
    Vector normal{};     // outward
    Vector origin{};
    Vector axes[3] = {};
    const float *x = nullptr, *y = nullptr, *z = nullptr; // z: null for a plate
    uint32_t padded = 0;
    Vector center{};
    alignas(16) float own_x[room], own_y[room], own_z[room]; // of a solid's face
};

// Of the faces of a solid that hold the point, the one that looks most along the direction, both in its own frame. Count: none.
uint32_t face_at(const MeetingShape& shape, Vector point, Vector direction) {
    const float slack = 1e-3f * shape.core_reach;
    uint32_t best = shape.shape.face_count;
    float most = -1.0f;
    for (uint32_t f = 0; f < shape.shape.face_count; ++f) {
        const float along = dot(shape.normals[f], direction);
        if (along > most && dot(shape.normals[f], point) > shape.offsets[f] - slack) {
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
        side.padded = shape.coarse_padded;
        side.center = shape.center;
    } else {
        const uint32_t f = face_at(shape, point, direction);
        if (f == shape.shape.face_count) return false;
        const Vector n = shape.normals[f];
        side.normal = n.x * side.axes[0] + n.y * side.axes[1] + n.z * side.axes[2];
        side.faces = dot(n, direction) > edge_on;
        if (!side.faces) return true;
        const ShapeFace& face = shape.shape.faces[f];
        side.padded = (face.count + lanes - 1) / lanes * lanes;
        for (uint32_t i = 0; i < side.padded + lanes && i < room; ++i) {
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

struct Flat {
    float u, v;
};

// What both faces cover, seen along the normal: half-planes n . p <= off around the nearest point.
struct Region {
    uint32_t count = 0; // padded
    alignas(16) float nu[2 * room + lanes], nv[2 * room + lanes], off[2 * room + lanes], inverse[2 * room + lanes];

    // The edges of a face, in axes u and v across the normal n.
    void add_edges(const Side& side, Vector u, Vector v, Vector n, Vector around) {
        const Vector base = side.origin - around;
        const float base_u = dot(u, base), base_v = dot(v, base);
        const float ux = dot(u, side.axes[0]), uy = dot(u, side.axes[1]), uz = dot(u, side.axes[2]);
        const float vx = dot(v, side.axes[0]), vy = dot(v, side.axes[1]), vz = dot(v, side.axes[2]);
        const float sense = (dot(side.normal, n) > 0.0f) == side.counter ? 1.0f : -1.0f;
        for (uint32_t i = 0; i < side.padded; i += lanes) {
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
            store(across_u, nu + count);
            store(across_v, nv + count);
            store(across_u * pu + across_v * pv, off + count);
            count += lanes;
        }
    }
    // u <= limit / slope, in numbers as large as those of edges.
    void add_limit(float slope, float limit, float size) {
        store(Four{size * slope, 0.0f, 0.0f, 0.0f}, nu + count);
        store(all(0.0f), nv + count);
        store(Four{size * (limit > 0.0f ? limit : 0.0f), 0.0f, 0.0f, 0.0f}, off + count);
        count += lanes;
    }
    // The part of the way from `from` along d, at most 1, that is inside; at: the half-plane that ends it. Half-planes all but along
    // d do not.
    float way(Flat from, Flat d, float most, uint32_t& at) const {
        const float square = d.u * d.u + d.v * d.v;
        Greatest nearest(all(-most));
        nearest.place = nearest.place - 4; // none
        for (uint32_t i = 0; i < count; i += lanes) {
            const Four u = load(nu + i), v = load(nv + i);
            const Four out = u * d.u + v * d.v, left = load(off + i) - u * from.u - v * from.v;
            const FourInts counts = (out > 0.0f) & (out * out > 1e-8f * square * (u * u + v * v));
            const Four t = counts ? -left / out : all(-std::numeric_limits<float>::infinity());
            nearest.offer(t, static_cast<int32_t>(i));
        }
        const float t = -nearest.get(at);
        return t > 0.0f ? t : 0.0f;
    }
    bool holds(Flat p) const {
        Four least_left = all(0.0f);
        for (uint32_t i = 0; i < count; i += lanes)
            least_left = less(load(off + i) - load(nu + i) * p.u - load(nv + i) * p.v, least_left);
        return least(least_left) >= 0.0f;
    }
    // From now on ray() starts here. False: not inside.
    bool set_middle(Flat m, float least_room) {
        Four least_left = all(least_room);
        for (uint32_t i = 0; i < count; i += lanes) {
            const Four left = load(off + i) - load(nu + i) * m.u - load(nv + i) * m.v;
            least_left = less(left, least_left);
            store(1.0f / greater(left, all(least_room)), inverse + i);
        }
        return least(least_left) >= 0.0f;
    }
    // 1 over the part of d at which the region ends.
    float ray(Flat d, uint32_t& at) const {
        Greatest found((load(nu) * d.u + load(nv) * d.v) * load(inverse));
        for (uint32_t i = lanes; i < count; i += lanes)
            found.offer((load(nu + i) * d.u + load(nv + i) * d.v) * load(inverse + i), static_cast<int32_t>(i));
        return found.get(at);
    }
    // The corner farthest along d.
    bool extreme(Flat middle, Flat d, float size, Flat& p) const {
        uint32_t at = 0;
        const float inverse_way = ray(d, at);
        if (!(inverse_way > 0.0f)) return false;
        p = {middle.u + d.u / inverse_way, middle.v + d.v / inverse_way};
        const float turn = d.v * nu[at] - d.u * nv[at] >= 0.0f ? 1.0f : -1.0f;
        for (uint32_t walk = 0; walk < most_walks; ++walk) {
            const Flat along{-turn * nv[at], turn * nu[at]};
            if (walk > 0 && !(d.u * along.u + d.v * along.v > 0.0f)) break;
            const float square = along.u * along.u + along.v * along.v;
            if (!(square > 0.0f)) break;
            uint32_t next = UINT32_MAX;
            const float t = way(p, along, 4.0f * size / std::sqrt(square), next);
            if (next >= count) break;
            p = {p.u + t * along.u, p.v + t * along.v};
            at = next;
        }
        return true;
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
    Flat middle{0.0f, 0.0f};
    for (const Side* side : {&a, &b}) {
        const Vector to = side->center - around;
        const Flat d{dot(u, to), dot(v, to)};
        uint32_t at = 0;
        const float t = region.way({0.0f, 0.0f}, d, 1.0f, at) / 3.0f;
        middle = {middle.u + t * d.u, middle.v + t * d.v};
    }
    if (!(middle.u * middle.u + middle.v * middle.v > 1e-8f * size * size)) return;
    if (!region.set_middle(middle, 1e-7f * size * size)) return;
    const Flat directions[4] = {{-1.0f, 0.0f}, {0.0f, 1.0f}, {1.0f, 0.0f}, {0.0f, -1.0f}};
    for (const Flat& d : directions) {
        Flat p{};
        if (!region.extreme(middle, d, size, p)) continue;
        const float gap = spread.closest.distance + slope_u * p.u + slope_v * p.v;
        // Corners at the limit are where the region was cut.
        if (gap > spread.limit - 1e-3f * left) continue;
        const Vector across = p.u * u + p.v * v;
        spread.add(around + across + dot(rise_b, across) * n, gap);
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
    uint32_t at = 0;
    float t = region.way({0.0f, 0.0f}, {1.0f, 0.0f}, size, at);
    const float left = 0.999f * (spread.limit - spread.closest.distance);
    if (opening * t > left) t = left / opening;
    // The nearest point may lie outside of a coarse outline.
    if (!region.holds({0.999f * t, 0.0f})) return;
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
        }
    }
    spread.finish();
    return spread.count;
}

} // namespace lr
