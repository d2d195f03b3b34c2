#include "collision/contact_points.h"

#include "collision/contact_patch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lr {
namespace {

// Contacts closer than this share of the reach are duplicates.
constexpr float same = 1e-3f;
// Cosine between a side and the normal from which on the side counts as lying across it.
constexpr float flat = 0.98f;
// Share of the reach: corners that are this much farther than the nearest one count, over a side that lies across the normal.
constexpr float nearly = 0.02f;
// The maximum is searched in parallel lanes, because one long chain of maxima is slow.
constexpr uint32_t lanes = 4;
static_assert(most_found % lanes == 0);

float greatest_of(const float* values, uint32_t padded) {
    float most[lanes] = {};
    for (uint32_t i = 0; i < padded; i += lanes)
        for (uint32_t lane = 0; lane < lanes; ++lane) most[lane] = std::max(most[lane], values[i + lane]);
    return std::max({most[0], most[1], most[2], most[3]});
}

// Weight 1 for loaded points, which hold the body once it is pushed out or miss that by a tenth of the depth; less for others. Southwell's
// relaxation: each step moves a point with about the farthest to go, hull corners first. The mass is that of a disc, which suffices to choose points.
void weigh(const Contact* found, uint32_t count, float reach, float margin, float* weight) {
    constexpr uint32_t most_steps = 32;
    constexpr float about = 0.7f, done = 0.01f, misses = 0.1f;
    const float per_turn = 2.0f / reach;
    const uint32_t padded = (count + lanes - 1) / lanes * lanes;
    float columns[6][most_found] = {}, gap[most_found] = {}, inverse[most_found] = {}, pressed[most_found] = {};
    float change[most_found] = {}, size[most_found] = {}, depth = 0.0f;
    for (uint32_t i = 0; i < count; ++i) {
        const Vector n = found[i].normal, turn = per_turn * cross(found[i].arm, n);
        const float of[6] = {n.x, n.y, n.z, turn.x, turn.y, turn.z};
        for (uint32_t k = 0; k < 6; ++k) columns[k][i] = of[k];
        inverse[i] = 1.0f / (dot(n, n) + dot(turn, turn));
        gap[i] = found[i].gap;
        depth = std::max(depth, -gap[i]);
    }
    for (uint32_t step = 0; step < most_steps; ++step) {
        for (uint32_t i = 0; i < padded; ++i) {
            change[i] = std::max(-gap[i] * inverse[i], -pressed[i]);
            size[i] = std::abs(change[i]);
        }
        const float most = greatest_of(size, padded);
        if (!(most > done * depth)) break;
        uint32_t at = 0;
        while (at + 1 < count && !(size[at] > about * most)) ++at;
        pressed[at] += change[at];
        for (uint32_t i = 0; i < padded; ++i) {
            float along = 0.0f;
            for (uint32_t k = 0; k < 6; ++k) along += columns[k][i] * columns[k][at];
            gap[i] += change[at] * along;
        }
    }
    const float wide = 0.1f * reach + margin + 2.0f * depth;
    for (uint32_t i = 0; i < count; ++i) {
        const bool holds = pressed[i] > (gap[i] - misses * depth) * inverse[i];
        weight[i] = holds ? 1.0f : std::max(0.2f * (1.0f - gap[i] / wide), 0.05f);
    }
}

// Twice the area, along the first one's normal, that a point adds to the two or three kept ones; 0 if it is hardly outside.
float area_beyond(const Contact* kept, uint32_t count, Vector point, float apart) {
    const Vector n = kept[0].normal;
    const auto beside = [&](uint32_t from, uint32_t to, Vector p, float& least) {
        const Vector across = cross(n, kept[to].arm - kept[from].arm);
        least = apart * length(across);
        return dot(across, p - kept[from].arm);
    };
    float least = 0.0f, most = 0.0f;
    const float inside = beside(0, 1, count == 2 ? point : kept[2].arm, least);
    if (count == 2) return std::abs(inside) > least ? std::abs(inside) : 0.0f;
    for (uint32_t edge = 0; edge < 3; ++edge) {
        const float along = beside(edge, (edge + 1) % 3, point, least), area = inside < 0.0f ? along : -along;
        if (area > least) most = std::max(most, area);
    }
    return most;
}
} // namespace

void ContactPoints::add(Vector point, Vector normal, float gap) {
    if (!(dot(normal, normal) > 0.5f) || !(std::abs(gap) < std::numeric_limits<float>::max())) return;
    if (count_ == most_found) {
        Contact kept[most_contacts];
        count_ = choose(kept, true);
        std::copy_n(kept, count_, found_);
    }
    found_[count_++] = {point, normal, gap};
}

float ContactPoints::least_gap(uint32_t from) const {
    float least = std::numeric_limits<float>::infinity();
    for (uint32_t i = from; i < count_; ++i) least = std::min(least, found_[i].gap);
    return least;
}

uint32_t ContactPoints::choose(Contact* out, bool loaded_first) const {
    if (count_ == 0) return 0;
    const float reach = body.reach + body.radius, square = reach * reach;
    // Place and direction (times the reach) as one point in six dimensions, in columns for the vectoriser.
    float columns[6][most_found], apart[most_found], weight[most_found];
    uint32_t next = 0;
    for (uint32_t i = 0; i < count_; ++i) {
        const Contact& c = found_[i];
        const float of[6] = {c.arm.x, c.arm.y, c.arm.z, reach * c.normal.x, reach * c.normal.y, reach * c.normal.z};
        for (uint32_t k = 0; k < 6; ++k) columns[k][i] = of[k];
        apart[i] = std::numeric_limits<float>::infinity();
        if (c.gap < found_[next].gap) next = i;
    }
    std::fill_n(weight, count_, 1.0f);
    const bool weighs = loaded_first && count_ > most_contacts;
    if (weighs) weigh(found_, count_, reach, margin, weight);
    const uint32_t padded = (count_ + lanes - 1) / lanes * lanes;
    for (uint32_t i = count_; i < padded; ++i) {
        apart[i] = weight[i] = 0.0f;
        for (auto& column : columns) column[i] = 0.0f;
    }
    uint32_t kept = 0;
    while (true) {
        out[kept++] = found_[next];
        if (kept == most_contacts) break;
        float taken[6];
        for (uint32_t k = 0; k < 6; ++k) taken[k] = columns[k][next];
        for (uint32_t i = 0; i < padded; ++i) {
            float sum = 0.0f;
            for (uint32_t k = 0; k < 6; ++k) {
                const float d = columns[k][i] - taken[k];
                sum += d * d;
            }
            apart[i] = sum < apart[i] ? sum : apart[i];
        }
        float value[most_found] = {};
        const bool by_area = weighs && (kept == 2 || kept == 3);
        for (uint32_t i = 0; i < count_ && by_area; ++i)
            value[i] = weight[i] * area_beyond(out, kept, found_[i].arm, 0.02f * reach);
        if (!by_area || !(greatest_of(value, padded) > 0.0f))
            for (uint32_t i = 0; i < padded; ++i) value[i] = weight[i] * apart[i];
        const float far = greatest_of(value, padded);
        if (!(far > same * same * square)) break;
        next = 0;
        while (next < count_ && value[next] != far) ++next;
        if (next == count_) break;
    }
    return kept;
}

uint32_t ContactPoints::keep(Contact* out, bool loaded_first) {
    const uint32_t kept = choose(out, loaded_first);
    for (uint32_t i = 0; i < kept; ++i) out[i].arm = rotate(inverse(body.at.rotation), out[i].arm);
    return kept;
}

namespace {

void set_box_side(const PlacedCollider& box, const Across& across, Side& side) {
    uint32_t axis = 0;
    for (uint32_t i = 1; i < 3; ++i)
        if (std::abs(across.normal[i]) > std::abs(across.normal[axis])) axis = i;
    const double sign = across.normal[axis] < 0.0f ? -1.0 : 1.0;
    const uint32_t j = (axis + 1) % 3, k = (axis + 2) % 3;
    side.set_face(across, along_axis(axis, static_cast<float>(sign)), 4, [&](uint32_t corner) {
        const Double3 out = along_axis(axis, sign * box.half[axis]) +
                            along_axis(j, corner == 0 || corner == 3 ? -box.half[j] : box.half[j]) +
                            along_axis(k, corner < 2 ? -sign * box.half[k] : sign * box.half[k]);
        return to_float(box.origin + out);
    });
}

void set_hull_side(const PlacedCollider& collider, const Across& across, Side& side) {
    const HullGeometry& hull = *collider.hull;
    uint32_t best = 0;
    for (uint32_t f = 1; f < hull.face_count; ++f)
        if (dot(across.normal, hull.normal(f)) > dot(across.normal, hull.normal(best))) best = f;
    side.set_face(across, hull.normal(best), hull.corner_count(best),
                  [&](uint32_t i) { return to_float(collider.origin + to_double(hull.corner(best, i))); });
}

void set_collider_side(const PlacedCollider& collider, const Across& across, Side& side) {
    if (collider.hull) return set_hull_side(collider, across, side);
    if (collider.count == 0) return set_box_side(collider, across, side);
    const auto corner = [&](uint32_t i) { return to_float(collider.points[i]); };
    if (collider.count == 2) return side.set_edge(across, corner(0), corner(1));
    if (collider.count != 3) return;
    const Double3 plane = cross(collider.points[1] - collider.points[0], collider.points[2] - collider.points[0]);
    const double size = length(plane);
    if (size > 0.0) side.set_face(across, to_float(1.0 / size * plane), 3, corner);
}

// Distance and direction of a point from the core of a sphere or a capsule.
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

// Rims over the face of a collider. One deeper than the overlap is not over the face but beyond an edge.
void add_rims_over(ContactPoints& set, const PlacedCollider& collider, const Separation& along, float gap) {
    const Across across(to_float(along.normal));
    Side side;
    set_collider_side(collider, across, side);
    if (side.count < 3) return;
    const Vector up = across.at(-side.slope_u, -side.slope_v, 1.0f);
    const float lean = 1.0f / length(up);
    const float least = std::min(gap, 0.0f) - same * set.body.reach;
    add_rims(set, to_double(lean * up), gap, [&](Vector rim, Vector& direction) {
        const float u = dot(across.u, rim), v = dot(across.v, rim);
        const float out = lean * (dot(across.normal, rim) - side.height_at(u, v));
        direction = lean * up;
        const bool over = out >= least && side.covers(u, v);
        return over ? static_cast<double>(out) : std::numeric_limits<double>::infinity();
    });
}
} // namespace

Rims rims_of(const PlacedBody& body, Double3 normal, float fall) {
    if (body.count > 0) return {};
    Double3 axes[3];
    double along[3];
    float size[3];
    for (uint32_t k = 0; k < 3; ++k) {
        const double length_k = length(to_double(body.axes[k]));
        size[k] = static_cast<float>(length_k);
        axes[k] = 1.0 / length_k * to_double(body.axes[k]);
        along[k] = dot(normal, axes[k]);
    }
    const Rocking rocking(size, fall);
    const bool rocks[2] = {rocking.most[0] > 1.0f, rocking.most[1] > 1.0f};
    if (!rocks[0] && !rocks[1]) return {};
    const uint32_t shortest = rocking.shortest, first = (shortest + 1) % 3, second = (shortest + 2) % 3;
    const double a = along[first], b = along[second];
    const auto point = [&](double by_a, double by_b) {
        return to_float(body.support(-(along[shortest] * axes[shortest] + by_a * axes[first] + by_b * axes[second])));
    };
    const double tilt[2] = {static_cast<double>(rocking.tilt[0]), static_cast<double>(rocking.tilt[1])};
    Rims rims{};
    const auto add = [&](double by_a, double by_b) { rims.point[rims.count++] = point(by_a, by_b); };
    if (rocks[0]) add(a + tilt[0], b), add(a - tilt[0], b);
    if (rocks[1]) add(a, b + tilt[1]), add(a, b - tilt[1]);
    if (rocks[0]) add(-a, b);
    if (rocks[1]) add(a, -b);
    if (rocks[0] && rocks[1]) add(-a, -b);
    return rims;
}

void add_patch(ContactPoints& set, const PlacedCollider& collider, const Separation& along) {
    const PlacedBody& body = set.body;
    const Vector n = to_float(along.normal);
    const auto rounding = static_cast<float>(collider.radius);
    const auto gap = static_cast<float>(along.distance) - rounding;
    const Across across(n);
    Side on_body, on_collider;
    set_body_side(*body.shape, body, across, -n, set.margin - (gap - body.radius), on_body);
    set_collider_side(collider, across, on_collider);
    Patch patch;
    lay_over(on_body, on_collider, 1e-5f * body.reach, patch);
    for (uint32_t i = 0; i < patch.count; ++i) {
        const float u = patch.u[i], v = patch.v[i];
        set.add_core(across.at(u, v, on_body.height_at(u, v)), n, patch.gap[i] - rounding);
    }
    // A curved side of many small faces rocks from one to the next on the corners of one alone. More than the nearest corners tremble too.
    const Vector up = across.at(-on_collider.slope_u, -on_collider.slope_v, 1.0f);
    const float lean = 1.0f / length(up), near = gap + nearly * body.reach;
    if (on_collider.count < 3 || lean < flat || on_body.count == body.count) return;
    for (uint32_t i = 0; i < body.count; ++i) {
        const Vector p = body.point(i);
        const float u = dot(across.u, p), v = dot(across.v, p);
        const float out = lean * (dot(n, p) - on_collider.height_at(u, v)) - rounding;
        if (out < near && on_collider.covers(u, v)) set.add_core(p, lean * up, out);
    }
}

void add_manifold(ContactPoints& set, const PlacedCollider& collider, const Separation& along) {
    const PlacedBody& body = set.body;
    const uint32_t first = set.count();
    const float gap = static_cast<float>(along.distance) - static_cast<float>(collider.radius);
    if (body.count > 0) add_patch(set, collider, along);
    if (gap - body.radius >= set.margin || set.least_gap(first) <= gap - body.radius + 0.05f * set.margin) return;
    const Vector point = to_float(along.has_points ? along.on_body : body.support(-along.normal));
    set.add_core(point, to_float(along.normal), gap);
    if (collider.count == 0 || collider.count > 2) return add_rims_over(set, collider, along, gap);
    add_rims(set, along.normal, gap, [&](Vector rim, Vector& direction) {
        Double3 outwards;
        const double distance = distance_from(collider, to_double(rim), outwards);
        direction = to_float(outwards);
        return distance - collider.radius;
    });
}
} // namespace lr
