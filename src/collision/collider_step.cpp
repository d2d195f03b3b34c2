#include "collision/colliders.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

// Levels of the grid that is rebuilt in each step; the static grid has the others.
constexpr uint32_t active_levels = 3, still_levels = most_occupancy_levels - active_levels;

// Rounds up to one of four steps per octave, so that small changes of the reach rebuild no static grid, and earlier reaches do not matter.
float coarsened(float reach) {
    int power = 0;
    const float m = std::frexp(reach, &power); // 0.5 to 1
    return std::ldexp(std::ceil(m * 8.0f) / 8.0f, power);
}

bool turns(const Collider& c) {
    return c.moves && c.begin.rotation != c.end.rotation;
}

double along(Vector axis, Vector a, Vector b) { // axis . (a - b)
    return dot(to_double(axis), to_double(a) - to_double(b));
}
// How far a plane rises along its normal in this step.
double rise_of(const Collider& c, Vector up) {
    return c.moves ? along(up, c.end.position, c.begin.position) : 0.0;
}

// Along `axis`: the middle of `box` from `origin`, half the width, and the rounding of both.
struct Span {
    double middle, half, slack;
};
Span span(const Box& box, Vector axis, Vector origin) {
    const double low = along(axis, box.low, origin), high = along(axis, box.high, origin);
    const Vector e = box.high - box.low;
    const double half = 0.5 * wide(std::abs(axis.x) * e.x + std::abs(axis.y) * e.y + std::abs(axis.z) * e.z);
    const Double3 from = to_double(box.low) - to_double(origin);
    const double far = std::abs(from.x) + std::abs(from.y) + std::abs(from.z);
    return {0.5 * (low + high), half, 1e-6 * (far + half)};
}
} // namespace

Box Colliders::box_of(uint32_t slot) const {
    const Collider& c = colliders_[slot];
    constexpr float most = 1e30f;
    if (c.geometry.kind == ColliderKind::plane) return {{-most, -most, -most}, {most, most, most}};
    const SharedGeometry* const shared = slots_[slot].shared;
    if (c.geometry.kind != ColliderKind::heightfield)
        return swept_box(bounds_of(c.geometry, shared), c.begin, c.end, c.moves);
    // With the solid below its surface.
    Box box = shared->box;
    box.low.y = -most;
    return swept_box({box, 0.0f}, c.begin, c.end, c.moves);
}

void Colliders::add_proxies(uint32_t slot, ColliderBroadPhase& to) const {
    const Collider& c = colliders_[slot];
    const SharedGeometry* const shared = slots_[slot].shared;
    if (c.geometry.kind != ColliderKind::mesh) {
        to.add({swept_box(bounds_of(c.geometry, shared), c.begin, c.end, c.moves), slot, {0, 0}});
        return;
    }
    for (size_t i = 0; i < shared->parts.size(); ++i) {
        const MeshPart& part = shared->parts[i];
        to.add({swept_box({part.box, 0.0f}, c.begin, c.end, c.moves), slot, part.part});
    }
}

void Colliders::rebuild_still() {
    still_grid_.clear();
    still_proxies_ = 0;
    for (uint32_t i = active_.count; i-- > 0;) {
        const uint32_t slot = active_.slots[i];
        if (colliders_[slot].moves) continue;
        delist(slot);
        slots_[slot].where = Where::still;
    }
    for (uint32_t slot = 0; slot < used_; ++slot)
        if (slots_[slot].where == Where::still) add_proxies(slot, still_grid_);
    still_proxies_ = still_grid_.size();
    still_grid_.build(dilation_, still_levels);
    stale_ = false;
    debt_ = 0;
}

bool Colliders::move_into(const Box& box) const {
    bool any = false;
    each_listed([&](uint32_t slot) { any = any || (colliders_[slot].moves && overlap(box, box_of(slot))); });
    return any;
}

void Colliders::begin_step(double dt, float reach) {
    any_moves_ = false;
    each_listed([&](uint32_t slot) {
        Collider& c = colliders_[slot];
        ColliderMotion& m = motions_[slot];
        c.moves = m.moves();
        any_moves_ |= c.moves;
        if (c.moves && !m.pending) c.end = advanced(c.begin, m.linear, m.angular, dt, m.remainder);
    });
    const float dilation = coarsened(reach);
    // Rebuilds once the entries that a new grid would have saved add up to its cost.
    const uint64_t active = proxies_ - still_proxies_;
    const uint64_t spoiled = active - mover_proxies_ + still_grid_.size() - still_proxies_;
    debt_ += spoiled;
    if (stale_ || dilation != dilation_ || active > active_grid_.capacity() || (spoiled != 0 && debt_ >= proxies_)) {
        dilation_ = dilation;
        rebuild_still();
    }
    active_grid_.clear();
    for (const uint32_t slot : active_) add_proxies(slot, active_grid_);
    active_grid_.build(dilation_, active_levels);
    fill_near();
}

void Colliders::end_step() {
    each_listed([this](uint32_t slot) {
        Collider& c = colliders_[slot];
        if (!c.moves) return;
        c.begin = c.end;
        c.moves = false;
        ColliderMotion& m = motions_[slot];
        if (m.pending) mover_proxies_ -= proxies_of(slot);
        m.pending = false;
    });
}

void Colliders::add_near(uint32_t slot) {
    const Collider& c = colliders_[slot];
    const Axes axes = axes_of(c.begin.rotation);
    if (c.geometry.kind == ColliderKind::plane) {
        if (turns(c) || near_.plane_count == most_near_planes) {
            near_.everywhere = true;
            return;
        }
        NearPlane& plane = near_.planes[near_.plane_count++];
        const double rise = rise_of(c, axes.y);
        put(rise > 0.0 ? c.end.position : c.begin.position, plane.point);
        put(axes.y, plane.normal);
        plane.travel = static_cast<float>(std::abs(rise));
        return;
    }
    if (near_.heightfield_count == most_near_heightfields) {
        near_.everywhere = true;
        return;
    }
    NearHeightfield& near = near_.heightfields[near_.heightfield_count++];
    const HeightfieldGeometry& field = *c.geometry.heightfield;
    put(c.begin.position, near.position);
    put(axes.x, near.axes);
    put(axes.y, near.axes + 3);
    put(axes.z, near.axes + 6);
    near.travel = c.moves ? most_travel(slots_[slot].shared->box, c.begin, c.end) : 0.0f;
    for (size_t k = 0; k < 2; ++k) {
        near.inverse_coarse[k] = 1.0f / (field.spacing[k] * static_cast<float>(HeightfieldGeometry::coarse_cells));
        near.extent[k] = field.extent(static_cast<uint32_t>(k));
        near.counts[k] = field.coarse_counts[k];
    }
    near.coarse_size =
        static_cast<float>(HeightfieldGeometry::coarse_cells) * std::min(field.spacing[0], field.spacing[1]);
    near.coarse = field.coarse;
    near.highest = field.highest;
    near.grid = field.grid();
}

void Colliders::fill_near() {
    near_.level_count = near_.plane_count = near_.heightfield_count = 0;
    near_.everywhere = false;
    for (const ColliderBroadPhase* grid : {&still_grid_, &active_grid_})
        for (uint32_t l = 0; l < grid->level_count(); ++l) near_.levels[near_.level_count++] = grid->level(l);
    for (const uint32_t slot : unbounded_) add_near(slot);
}

// For a plane or a heightfield.
bool Colliders::in_reach(const Collider& c, const Box& box) const {
    const Axes axes = axes_of(c.begin.rotation);
    const Span up = span(box, axes.y, c.begin.position);
    const double lowest = up.middle - up.half - up.slack;
    if (c.geometry.kind == ColliderKind::plane) {
        return turns(c) || lowest <= std::max(rise_of(c, axes.y), 0.0);
    }
    const HeightfieldGeometry& field = *c.geometry.heightfield;
    const Box own{{0.0f, field.lowest, 0.0f}, {field.extent(0), field.highest, field.extent(1)}};
    const double travel = c.moves ? static_cast<double>(most_travel(own, c.begin, c.end)) : 0.0;
    if (lowest > static_cast<double>(own.high.y) + travel) return false;
    const auto outside = [travel](const Span& s, float high) {
        const double reach = s.half + s.slack + travel;
        return s.middle + reach < 0.0 || s.middle - reach > static_cast<double>(high);
    };
    return !outside(span(box, axes.x, c.begin.position), own.high.x) &&
           !outside(span(box, axes.z, c.begin.position), own.high.z);
}

bool Colliders::all_grounds(uint32_t layers) const {
    return std::all_of(unbounded_.begin(), unbounded_.end(),
                       [&](uint32_t slot) { return (colliders_[slot].layers & layers) != 0; });
}

bool Colliders::any_ground(const Box& box, uint32_t layers) const {
    return std::any_of(unbounded_.begin(), unbounded_.end(), [&](uint32_t slot) {
        return (colliders_[slot].layers & layers) != 0 && in_reach(colliders_[slot], box);
    });
}

bool Colliders::any_finite(const Box& box, uint32_t layers) const {
    return !each_finite(box, [&](uint32_t slot, ColliderPart) { return (colliders_[slot].layers & layers) == 0; });
}

namespace {

// Inserts into a sorted list; a full one drops its last.
struct CandidateList {
    Candidate (&at)[most_candidates];
    uint32_t count = 0;
    bool more = false;

    void take(const Candidate& one) {
        uint32_t place = count;
        for (; place > 0 && comes_before(one, at[place - 1]); --place)
            if (place < most_candidates) at[place] = at[place - 1];
        more = more || count == most_candidates;
        if (place == most_candidates) return;
        at[place] = one;
        if (count < most_candidates) ++count;
    }
};
} // namespace

uint32_t Colliders::candidates(const Box& box, uint32_t layers, const Candidate* after,
                               Candidate (&out)[most_candidates], bool& more) const {
    CandidateList list{out};
    visit(box, layers, [&](const Candidate& one) {
        if (!after || comes_before(*after, one)) list.take(one);
    });
    more = list.more;
    return list.count;
}

uint32_t Colliders::grounds(const Box& box, uint32_t layers, Candidate (&out)[most_candidates]) const {
    CandidateList list{out};
    for (const uint32_t slot : unbounded_)
        if ((colliders_[slot].layers & layers) != 0 && in_reach(colliders_[slot], box)) list.take({slot, {0, 0}});
    return list.count;
}
} // namespace lr
