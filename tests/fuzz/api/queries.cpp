// Rays and overlaps.
#include "fuzz/api/model.h"

namespace fuzz {
namespace {

void rays(Fuzzer& f) {
    World& w = f.world();
    Input& in = f.in;
    const uint32_t count = in.handle(0) % 4;
    std::vector<lr_ray> all(count, initialised(LR_CALL(lr_ray_init)));
    Expected e;
    for (uint32_t i = 0; i < count; ++i) {
        lr_ray& r = all[i];
        r.origin[1] = 1.0f, r.origin[0] = 0.01f * static_cast<float>(i);
        r.batch = in.handle(1) < 128 ? lr_batch{} : f.pick_batch(w, in.handle(2));
        if (i == in.variant() % count)
            in.change(r.origin, r.direction, r.max_distance, r.flags, r.collider_layers, r.reserved);
        e.range(r.origin, -1e9, 1e9);
        e.range(r.max_distance, 0.0, 1e9);
        e.length(r.direction, 1.001e-6, 0.999e6);
        e.add_if(r.flags == 0 || r.flags > 3 || r.reserved != 0, LR_ERROR_INVALID_ARGUMENT);
        e.add_if(r.batch.id != 0 && !w.find(r.batch), LR_ERROR_STALE_BATCH);
    }
    GivenArray<lr_ray> given(in, all, 1, e);
    e.add_if(in.null(2) && count != 0, LR_ERROR_NULL_ARGUMENT);
    Call call(f, w, "lr_world_ray_cast", e);
    std::vector<lr_ray_hit> hits(count);
    const bool wild = w.state.wild;
    const bool ok =
        call.ended(LR_CALL(lr_world_ray_cast)(call.world(), given.get(), count, in.null(2) ? nullptr : hits.data()));
    w.state.wild = wild;
    for (uint32_t i = 0; ok && i < count && !w.state.loose; ++i) {
        const lr_ray_hit& h = hits[i];
        if (h.body.id != 0 && (h.collider.id != 0 || !w.owner(h.body))) defect("lr_world_ray_cast", "body");
        if (h.body.id == 0 && h.user != 0) defect("lr_world_ray_cast", "user of no body");
        if (h.collider.id != 0 && !w.collider(h.collider)) defect("lr_world_ray_cast", "collider");
        if ((h.body.id != 0 && !(all[i].flags & LR_RAY_BODIES)) ||
            (h.collider.id != 0 && !(all[i].flags & LR_RAY_COLLIDERS)))
            defect("lr_world_ray_cast", "not what it may hit");
        if (!(h.distance >= 0.0f && h.distance <= all[i].max_distance)) defect("lr_world_ray_cast", "distance");
        if (h.body.id == 0 && h.collider.id == 0 && h.distance != 0.0f) defect("lr_world_ray_cast", "a hit of nothing");
    }
}

void overlap(Fuzzer& f) {
    World& w = f.world();
    Input& in = f.in;
    lr_overlap_desc d = initialised(LR_CALL(lr_overlap_desc_init));
    d.shape = 1 + in.handle(0) % 2;
    d.batch = in.handle(1) < 128 ? lr_batch{} : f.pick_batch(w, in.handle(1));
    in.change(d.position, d.orientation, d.size, d.shape, d.reserved);
    Expected e;
    e.range(d.position, -1e9, 1e9);
    e.length(d.orientation, 1e-5, 1e5);
    for (size_t k = 0; k < 3; ++k) {
        e.finite(d.size[k]);
        if (k == 0 || d.shape == LR_OVERLAP_BOX) {
            e.range(d.size[k], 0.0, 1e6);
            e.add_if(d.size[k] == 0.0f, LR_ERROR_INVALID_ARGUMENT);
        }
    }
    e.add_if(d.shape < 1 || d.shape > 2 || d.reserved != 0, LR_ERROR_INVALID_ARGUMENT);
    e.add_if(d.batch.id != 0 && !w.find(d.batch), LR_ERROR_STALE_BATCH);
    Given<lr_overlap_desc> given(in, d, 1, e);
    const uint32_t capacity = in.handle(2) % 16;
    e.add_if((in.null(2) && capacity != 0) || in.null(3), LR_ERROR_NULL_ARGUMENT);
    e.may(LR_ERROR_BUFFER_TOO_SMALL);
    Call call(f, w, "lr_world_overlap", e);
    uint32_t count = 77;
    std::vector<lr_body> ids(capacity);
    const bool wild = w.state.wild;
    const lr_status status = LR_CALL(lr_world_overlap)(call.world(), given.get(), in.null(2) ? nullptr : ids.data(),
                                                       capacity, in.null(3) ? nullptr : &count);
    const bool ok = call.ended(status);
    w.state.wild = wild;
    if (w.state.loose) return;
    if (status == LR_ERROR_BUFFER_TOO_SMALL && count <= capacity) defect("lr_world_overlap", "there is room", count);
    if (!ok) return;
    if (count > capacity) defect("lr_world_overlap", "count", count);
    for (uint32_t i = 0; i < count; ++i)
        if (!w.owner(ids[i])) defect("lr_world_overlap", "a stale body");
}

} // namespace

std::vector<Named> query_operations() {
    return {{"rays", rays}, {"overlap", overlap}};
}

} // namespace fuzz
