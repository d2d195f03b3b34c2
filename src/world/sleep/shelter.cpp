#include "world/sleep/shelter.h"

#include "collision/ray_cast.h"
#include "world/world.h"

namespace lr {
namespace {

// Marks points that colliders cover, where a body covers the other side alone. A collider by itself gives no shelter.
void hide_by_colliders(const lr_world& world, uint32_t layers, const PairHull& hull, float scale, const Pose& at,
                       const Box& near, Hidden& hidden) {
    const FaceLines lines(hull, scale, at);
    const double half = wide(scale * (hull.face.half + covering_gap * hull.shape.reach));
    const auto hits = [&](const Candidate& candidate, const Collider& collider, const Ray& ray) {
        RayHit hit{};
        if (collider.geometry.kind == ColliderKind::mesh)
            return ray_hits_part(*collider.geometry.mesh, candidate.part, ray, half, hit);
        return ray_hits_collider(collider.geometry, world.colliders.shared(candidate.slot), ray, half, hit);
    };
    world.colliders.visit(near, layers, [&](const Candidate& candidate) {
        const Collider& collider = world.colliders.at(candidate.slot);
        for (uint32_t k = 0; k < face_points; ++k) {
            const uint32_t bit = 1u << k;
            if (((hidden.above ^ hidden.below) & bit) == 0) continue;
            const bool above = (hidden.above & bit) == 0; // towards the open side
            const Double3 direction = to_double(lines[k].direction);
            const Ray ray{to_double(lines[k].point), above ? direction : -direction};
            if (hits(candidate, collider, ray_in(collider.begin, ray))) (above ? hidden.above : hidden.below) |= bit;
        }
    });
}
} // namespace

float open_to_wind(const lr_world& world, uint32_t slot, uint32_t index, const Pose& at, Hidden hidden) {
    const Batch& own = *world.batches[slot].batch;
    const PairHull& hull = own.pair_hull();
    const float scale = own.arrays().field[field_scale][index];
    const Box near = grown(bounds(hull, scale, at), covering_gap * scale * hull.shape.reach);
    world.pairs.visit_partners(slot, [&](uint32_t other) {
        const Batch& batch = *world.batches[other].batch;
        const BatchArrays& arrays = batch.arrays();
        batch.visit_sleeping(near, [&](uint32_t i) {
            if (other == slot && i == index) return;
            hide(hull, scale, at, batch.pair_hull(), arrays.field[field_scale][i], pose_of(arrays, i), hidden);
        });
    });
    if ((hidden.above | hidden.below) == 0) return 1.0f;
    if (world.colliders.any() && hidden.above != hidden.below && own.contact().layers != 0)
        hide_by_colliders(world, own.contact().layers, hull, scale, at, near, hidden);
    return open_share(hull.face, hidden);
}

void uncover(lr_world& world, Batch& woken, uint32_t index, const Box& box) {
    const uint32_t slot = unpack(woken.ids()[index]).batch;
    const float reach = woken.pair_hull().shape.reach * woken.arrays().field[field_scale][index];
    const Box near = grown(box, covering_gap * reach);
    if (world.pairs.has_contact(slot) && woken.columns().has(part_contact)) woken.set_lee(index, lee_unknown);
    world.pairs.visit_partners(slot, [&](uint32_t other) {
        Batch& batch = *world.batches[other].batch;
        if (!batch.sleeping() || !batch.sleeping()->any_sheltered()) return;
        batch.visit_sleeping(near, [&](uint32_t i) { batch.forget_shelter(i); });
    });
}
} // namespace lr
