// Queries: ray casts, overlap tests, and the fluid's loads on a body.
#include "world/world.h"

#include "base/pose.h"
#include "collision/convex_separation.h"
#include "collision/ray_cast.h"
#include "kernel/body_copies.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lr {
namespace {

constexpr uint32_t nothing = UINT32_MAX;

constexpr uint32_t filter_block = 256;
// Share of the distance: bound of the filter's rounding in single precision.
constexpr float rounding = 2e-6f;

// Finds bodies whose spheres are near a ray; with length 0, near a sphere.
struct RayFilter {
    Vector origin, direction; // m; unit
    float radius, reach;      // m, of the ray; of a body of scale 1
    float most;               // m, along the ray
};

// For bodies [begin, end), at most filter_block; vectorised. Marks perhaps too many, never too few. Returns whether any is marked.
bool filter_bodies(const RayFilter& f, const BatchArrays& arrays, uint32_t begin, uint32_t end,
                   uint32_t (&marks)[filter_block]) {
    const float *const x = arrays.field[field_x] + begin, *const y = arrays.field[field_y] + begin,
                       *const z = arrays.field[field_z] + begin, *const scale = arrays.field[field_scale] + begin;
    const auto size_of = [](float a) { return a < 0.0f ? -a : a; };
    const Vector o = f.origin, d = f.direction;
    const float radius = f.radius * (1.0f + rounding), most = f.most;
    uint32_t any = 0;
    for (uint32_t i = 0; i < end - begin; ++i) {
        const float px = x[i] - o.x, py = y[i] - o.y, pz = z[i] - o.z;
        const float reach = radius + f.reach * scale[i] + rounding * (size_of(px) + size_of(py) + size_of(pz));
        const float along = px * d.x + py * d.y + pz * d.z;
        const float cx = py * d.z - pz * d.y, cy = pz * d.x - px * d.z, cz = px * d.y - py * d.x;
        const bool near = cx * cx + cy * cy + cz * cz <= reach * reach;
        const uint32_t mark = static_cast<uint32_t>(near) & static_cast<uint32_t>(along >= -reach) &
                              static_cast<uint32_t>(along <= most + reach);
        marks[i] = mark;
        any |= mark;
    }
    return any != 0;
}

// Calls fn(index) for bodies that pass the filter; fn may narrow it.
template <class Function> void for_passing(const Batch& batch, const RayFilter& filter, Function&& fn) {
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
    // Slightly enlarged for rounding.
    RayFilter filter{to_float(ray.origin), to_float(ray.direction), 0.0f, 1.001f * batch.asset().shape.reach, 0.0f};
    const auto shorten = [&] { filter.most = 1.000001f * static_cast<float>(std::min(most, nearest.hit.distance)); };
    shorten();
    for_passing(batch, filter, [&](uint32_t i) {
        RayHit hit{};
        const float scale = batch.arrays().field[field_scale][i];
        if (!ray_hits_body(batch.asset().shape, scale, pose_of(batch.arrays(), i), ray,
                           std::min(most, nearest.hit.distance), hit))
            return;
        const bool alike = hit.distance == nearest.hit.distance;
        if (hit.distance > nearest.hit.distance || (alike && nearest.batch != &batch)) return;
        if (alike && batch.arrays().noise_seed[i] >= batch.arrays().noise_seed[nearest.body]) return;
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
        if (!ray_hits_collider(c.geometry, colliders.shared(slot), ray_in(c.begin, ray),
                               std::min(most, nearest.hit.distance), hit) ||
            !(hit.distance < nearest.hit.distance))
            continue;
        nearest.body = nothing;
        nearest.collider = slot;
        nearest.hit = {hit.distance, rotate(to_double(c.begin.rotation), hit.normal)};
    }
}

// Tests bodies against a sphere or a box.
class OverlapTest {
public:
    explicit OverlapTest(const lr_overlap_desc& desc) {
        frame_ = {vector_of(desc.position), unit_of(to_double(rotation_of(desc.orientation)))};
        const bool sphere = desc.shape == LR_OVERLAP_SPHERE;
        geometry_.kind = sphere ? ColliderKind::sphere : ColliderKind::box;
        std::copy(desc.size, desc.size + 3, geometry_.size);
        const float(&s)[3] = desc.size;
        reach_ = sphere ? s[0] : 1.000001f * length(Vector{s[0], s[1], s[2]});
    }
    // A ray of length 0, as thick as the sphere around the shape.
    RayFilter filter(const Batch& batch) const {
        return {frame_.position, {1.0f, 0.0f, 0.0f}, reach_, 1.001f * batch.asset().shape.reach, 0.0f};
    }
    bool holds(const Batch& batch, uint32_t i) const {
        const float scale = batch.arrays().field[field_scale][i];
        const Pose at = relative(frame_, pose_of(batch.arrays(), i));
        // Cheap tests first: in a large box most bodies have their middle inside, and most others are far away.
        const Vector middle = at.position + rotate(at.rotation, scale * batch.asset().shape.center);
        if (depth(middle) <= 0.0) return true;
        if (depth(at.position) > 1.001 * wide(scale * batch.asset().shape.reach)) return false;
        const PlacedBody body(batch.asset().shape, scale, at);
        const PlacedCollider collider(geometry_, at.position);
        const double sum = wide(body.radius) + collider.radius;
        const Nearest nearest = nearest_points(body, collider, sum);
        return nearest.overlap || (nearest.lower <= sum && nearest.distance <= sum);
    }

private:
    // m: distance of a point from the shape; not positive inside.
    double depth(Vector p) const {
        if (geometry_.kind == ColliderKind::sphere) return length(to_double(p)) - wide(geometry_.size[0]);
        const auto beyond = [](float v, float half) { return std::max(wide(std::abs(v)) - wide(half), 0.0); };
        return length(
            Double3{beyond(p.x, geometry_.size[0]), beyond(p.y, geometry_.size[1]), beyond(p.z, geometry_.size[2])});
    }

    Pose frame_;
    Geometry geometry_{};
    float reach_; // m, of the sphere around the shape
};
} // namespace

lr_ray_hit cast_ray(const lr_world& world, const lr_ray& given, const Batch* only) {
    const Double3 direction = to_double(vector_of(given.direction));
    const Ray ray{to_double(vector_of(given.origin)), 1.0 / length(direction) * direction};
    const double most = wide(given.max_distance);
    FirstHit nearest;
    world.each_batch([&](const Batch& batch, uint32_t) {
        if ((given.flags & LR_RAY_BODIES) != 0 && (!only || &batch == only)) cast_at_bodies(batch, ray, most, nearest);
    });
    if (given.flags & LR_RAY_COLLIDERS) cast_at_colliders(world.colliders, given.collider_layers, ray, most, nearest);
    lr_ray_hit out{};
    if (nearest.body == nothing && nearest.collider == nothing) return out;
    if (nearest.body != nothing) {
        out.body = nearest.batch->ids()[nearest.body];
        out.user = nearest.batch->user(nearest.body);
    } else {
        out.collider = world.colliders.id(nearest.collider);
    }
    out.distance = static_cast<float>(nearest.hit.distance);
    put(to_float(ray.origin + nearest.hit.distance * ray.direction), out.position);
    put(to_float(1.0 / length(nearest.hit.normal) * nearest.hit.normal), out.normal);
    return out;
}

uint32_t find_overlaps(const lr_world& world, const lr_overlap_desc& desc, const Batch* only, lr_body* bodies,
                       uint32_t capacity) {
    const OverlapTest test(desc);
    uint32_t count = 0;
    world.each_batch([&](const Batch& batch, uint32_t) {
        if (only && &batch != only) return;
        const uint32_t first = count;
        for_passing(batch, test.filter(batch), [&](uint32_t i) {
            if (!test.holds(batch, i)) return;
            if (count < capacity) bodies[count] = batch.ids()[i];
            ++count;
        });
        if (count > capacity) return;
        std::sort(bodies + first, bodies + count, [&](lr_body a, lr_body c) {
            uint32_t at[2] = {0, 0};
            batch.find(a, at[0]);
            batch.find(c, at[1]);
            const uint32_t* const noise_seed = batch.arrays().noise_seed;
            return noise_seed[at[0]] != noise_seed[at[1]] ? noise_seed[at[0]] < noise_seed[at[1]]
                                                          : unpack(a).slot < unpack(c).slot;
        });
    });
    return count;
}

const BodyConstants& constants_at(const lr_world& world, Batch& batch, uint32_t i, float (&stream)[3]) {
    bool failed = false;
    const WaterBody* const water = world.surface.present() ? batch.water_body(world.surface.desc(), failed) : nullptr;
    if (!water) return batch.step.body;
    BodyCopies<lane_block> body;
    body.take(batch.arrays(), 1, [&](uint32_t) { return i; });
    SurfaceBlock block;
    const SurfaceInstant plane = world.surface.at(world.time);
    world.target->surface.surface(plane, *water, body.arrays(), lane_block, 0.0f, block);
    if (world.surface.callback()) world.surface.ask(world.time, world.handle(batch.slot()), 1, plane, block);
    const Vector from = vector_in(batch.arrays().field, field_x, i) - vector_of(plane.point);
    if (!(dot(vector_of(plane.up), from) < block.height[0])) return batch.step.body;
    for (size_t k = 0; k < 3; ++k) stream[k] = block.velocity[k][0];
    return water->water;
}

void find_loads(const lr_world& world, Batch& batch, uint32_t i, lr_body_loads& out) {
    if (batch.step.loads != Loads::aerodynamic) return;
    BodyCopies<lane_block> copy;
    copy.take(batch.arrays(), 1, [&](uint32_t) { return i; });
    if (batch.asleep(i)) // there the arrays hold the wind withstood
        for (size_t f = field_gust_x; f < field_count; ++f) std::fill_n(copy.field[f], copy.padded, 0.0f);
    StepInput in = batch.step;
    in.seed = world.seed;
    float fluid[3];
    const BodyConstants& body = constants_at(world, batch, i, fluid);
    if (&body == &batch.step.body) {
        put(vector_in(copy.field, field_x, 0), fluid);
        world.sample_wind(fluid, 1, fluid);
    }
    loads_on_body(in, body, copy.arrays(), fluid, out);
}
} // namespace lr
