#include "world/queries.h"

#include "contact/distance.h"
#include "contact/ray.h"
#include "contact/sphere_filter.h"
#include "world/world.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lr {
namespace {

constexpr uint32_t nothing = UINT32_MAX;

double wide(float x) {
    return static_cast<double>(x);
}

Pose pose_of(const Batch& batch, uint32_t index) {
    const auto value = [&](size_t f) { return batch.arrays().field[f][index]; };
    return {{value(field_x), value(field_y), value(field_z)},
            {value(field_qx), value(field_qy), value(field_qz), value(field_qw)}};
}

// Calls fn(index) for bodies of the batch that pass the filter, which fn may narrow.
template <class Filter, class Function> void for_passing(const Batch& batch, const Filter& filter, Function&& fn) {
    uint32_t marks[filter_block];
    for (uint32_t at = 0; at < batch.count(); at += filter_block) {
        const uint32_t end = std::min(at + filter_block, batch.count());
        if (!filter_bodies(filter, batch.arrays(), at, std::min(at + filter_block, batch.padded_count()), marks))
            continue;
        for (uint32_t i = at; i < end; ++i)
            if (marks[i - at] != 0) fn(i);
    }
}

struct FirstHit {
    const Batch* batch = nullptr;
    uint32_t body = nothing, collider = nothing; // dense index; slot
    RayHit hit{std::numeric_limits<double>::infinity(), {}};
};

void cast_at_bodies(const Batch& batch, const Ray& ray, double most, FirstHit& nearest) {
    RayFilter filter{};
    for (size_t k = 0; k < 3; ++k) {
        const double from[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
        const double along[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
        filter.origin[k] = static_cast<float>(from[k]);
        filter.direction[k] = static_cast<float>(along[k]);
    }
    // A little more, for rounding.
    filter.reach = 1.001f * batch.shape.reach;
    const auto shorten = [&] { filter.most = 1.000001f * static_cast<float>(std::min(most, nearest.hit.distance)); };
    shorten();
    for_passing(batch, filter, [&](uint32_t i) {
        RayHit hit{};
        const float scale = batch.arrays().field[field_scale][i];
        if (!ray_meets_body(batch.shape, scale, pose_of(batch, i), ray, std::min(most, nearest.hit.distance), hit))
            return;
        const bool alike = hit.distance == nearest.hit.distance;
        if (hit.distance > nearest.hit.distance || (alike && nearest.batch != &batch)) return;
        if (alike && batch.arrays().key[i] >= batch.arrays().key[nearest.body]) return;
        nearest.batch = &batch;
        nearest.body = i;
        nearest.hit = hit;
        shorten();
    });
}

void cast_at_colliders(const Colliders& colliders, uint32_t layers, const Ray& ray, double most, FirstHit& nearest) {
    for (uint32_t slot = 0; slot < colliders.slots(); ++slot) {
        if (!colliders.in_use(slot) || (colliders.at(slot).layers & layers) == 0) continue;
        const Collider& c = colliders.at(slot);
        RayHit hit{};
        if (!ray_meets_collider(c.geometry, colliders.shared(slot), ray_in(c.begin, ray),
                                std::min(most, nearest.hit.distance), hit) ||
            !(hit.distance < nearest.hit.distance))
            continue;
        nearest.body = nothing;
        nearest.collider = slot;
        nearest.hit = {hit.distance, turned(c.begin.rotation, hit.normal)};
    }
}

void put(Double3 from, float (&to)[3]) {
    const Vector v = to_float(from);
    to[0] = v.x, to[1] = v.y, to[2] = v.z;
}

// A sphere or box, and a body that may overlap it.
class OverlapTest {
public:
    explicit OverlapTest(const lr_overlap_desc& desc) {
        double q[4], n = 0.0;
        for (const float e : desc.orientation) n += wide(e) * wide(e);
        for (size_t k = 0; k < 4; ++k) q[k] = wide(desc.orientation[k]) / std::sqrt(n);
        frame_ = {
            {desc.position[0], desc.position[1], desc.position[2]},
            {static_cast<float>(q[0]), static_cast<float>(q[1]), static_cast<float>(q[2]), static_cast<float>(q[3])}};
        const bool sphere = desc.shape == LR_OVERLAP_SPHERE;
        geometry_.kind = sphere ? ColliderKind::sphere : ColliderKind::box;
        std::copy(desc.size, desc.size + 3, geometry_.size);
        const float(&s)[3] = desc.size;
        reach_ = sphere ? s[0] : 1.000001f * length(Vector{s[0], s[1], s[2]});
    }
    SphereFilter filter(const Batch& batch) const {
        const Vector& p = frame_.position;
        return {{p.x, p.y, p.z}, reach_, 1.001f * batch.shape.reach};
    }
    bool holds(const Batch& batch, uint32_t i) const {
        const float scale = batch.arrays().field[field_scale][i];
        const Pose at = relative(frame_, pose_of(batch, i));
        // Most of what is in a large box has its middle there, and most of what is not is far.
        const Vector middle = at.position + rotate(at.rotation, scale * batch.shape.center);
        if (depth(middle) <= 0.0) return true;
        if (depth(at.position) > 1.001 * wide(scale * batch.shape.reach)) return false;
        const PlacedBody body(batch.shape, scale, at);
        const PlacedCollider collider(geometry_, at.position);
        const double sum = wide(body.radius) + collider.radius;
        const Nearest nearest = nearest_points(body, collider, sum);
        return nearest.overlap || (nearest.lower <= sum && nearest.distance <= sum);
    }

private:
    // m: how far a point is outside, or not over 0.
    double depth(Vector p) const {
        if (geometry_.kind == ColliderKind::sphere) return length(to_double(p)) - wide(geometry_.size[0]);
        const auto beyond = [](float v, float half) { return std::max(wide(std::abs(v)) - wide(half), 0.0); };
        return length(
            Double3{beyond(p.x, geometry_.size[0]), beyond(p.y, geometry_.size[1]), beyond(p.z, geometry_.size[2])});
    }

    Pose frame_;
    Geometry geometry_{};
    float reach_; // m, of a sphere around it
};

} // namespace

lr_ray_hit cast_ray(const lr_world& world, const lr_ray& given, const Batch* only) {
    const Double3 direction = to_double({given.direction[0], given.direction[1], given.direction[2]});
    const Ray ray{to_double({given.origin[0], given.origin[1], given.origin[2]}), 1.0 / length(direction) * direction};
    const double most = wide(given.max_distance);
    FirstHit nearest;
    for (uint32_t b = 0; b < world.batch_slots && (given.flags & LR_RAY_BODIES) != 0; ++b) {
        const Batch* const batch = world.batches[b].batch;
        if (batch && (!only || batch == only)) cast_at_bodies(*batch, ray, most, nearest);
    }
    if (given.flags & LR_RAY_COLLIDERS) cast_at_colliders(world.colliders, given.collider_layers, ray, most, nearest);
    lr_ray_hit out{};
    if (nearest.body == nothing && nearest.collider == nothing) return out;
    if (nearest.body != nothing)
        out.body = nearest.batch->ids()[nearest.body];
    else
        out.collider = world.colliders.id(nearest.collider);
    out.distance = static_cast<float>(nearest.hit.distance);
    put(ray.origin + nearest.hit.distance * ray.direction, out.position);
    put(1.0 / length(nearest.hit.normal) * nearest.hit.normal, out.normal);
    return out;
}

uint32_t find_overlaps(const lr_world& world, const lr_overlap_desc& desc, const Batch* only, lr_body* bodies,
                       uint32_t capacity) {
    const OverlapTest test(desc);
    uint32_t count = 0;
    for (uint32_t b = 0; b < world.batch_slots; ++b) {
        const Batch* const batch = world.batches[b].batch;
        if (!batch || (only && batch != only)) continue;
        const uint32_t first = count;
        for_passing(*batch, test.filter(*batch), [&](uint32_t i) {
            if (!test.holds(*batch, i)) return;
            if (count < capacity) bodies[count] = batch->ids()[i];
            ++count;
        });
        if (count > capacity || count == first) continue;
        std::sort(bodies + first, bodies + count, [&](lr_body a, lr_body c) {
            uint32_t at[2] = {0, 0};
            batch->find(a, at[0]);
            batch->find(c, at[1]);
            const uint32_t* const key = batch->arrays().key;
            return key[at[0]] != key[at[1]] ? key[at[0]] < key[at[1]] : unpack(a).slot < unpack(c).slot;
        });
    }
    return count;
}

} // namespace lr
