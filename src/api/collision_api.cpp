// Colliders, contact of batches with them and with each other, and contact events.
#include "api/checked_call.h"
#include "api/struct_conversion.h"
#include "collision/colliders.h"

namespace lr::api {
namespace {

const char* wrong_pose(const float (&position)[3], const float (&orientation)[4]) {
    if (!within(position, most_place)) return "position is over 1e9 m";
    return normalisable(orientation) ? nullptr : "orientation cannot be normalised";
}

Outcome check_lengths(const float* values, uint64_t count) {
    for (uint64_t i = 0; i < count; ++i) {
        if (!std::isfinite(values[i])) return LR_ERROR_NOT_FINITE;
        if (!in_range(values[i], -most_size, most_size)) return invalid("a vertex or height is over 1e6 m");
    }
    return {};
}

Outcome check_vertices(const lr_collider_desc& d, uint32_t least, uint32_t most) {
    if (d.vertex_count < least || d.vertex_count > most) return invalid("vertex_count is out of range");
    if (!d.vertices) return LR_ERROR_NULL_ARGUMENT;
    return check_lengths(d.vertices, uint64_t{3} * d.vertex_count);
}

Outcome check_mesh(const lr_collider_desc& d) {
    if (d.triangle_count < 1 || d.triangle_count > LR_MAX_COLLIDER_VERTICES)
        return invalid("triangle_count is out of range");
    if (!d.indices) return LR_ERROR_NULL_ARGUMENT;
    if (const Outcome outcome = check_vertices(d, 3, LR_MAX_COLLIDER_VERTICES); outcome.refused()) return outcome;
    for (uint64_t i = 0; i < uint64_t{3} * d.triangle_count; ++i)
        if (d.indices[i] >= d.vertex_count) return invalid("an index is not less than vertex_count");
    return {};
}

Outcome check_heightfield(const lr_collider_desc& d) {
    const uint64_t samples = uint64_t{d.counts[0]} * d.counts[1];
    if (d.counts[0] < 2 || d.counts[1] < 2 || samples > LR_MAX_COLLIDER_VERTICES)
        return invalid("counts are out of range");
    for (float s : d.spacing) {
        if (!std::isfinite(s)) return LR_ERROR_NOT_FINITE;
        if (!in_range(s, static_cast<double>(1e-6f), 1e6)) return invalid("spacing is not 1e-6 to 1e6 m");
    }
    if (!d.heights) return LR_ERROR_NULL_ARGUMENT;
    return check_lengths(d.heights, samples);
}

Outcome check_sizes(const lr_collider_desc& d) {
    for (int i = 0; i < sizes_of(d.kind); ++i)
        if (!std::isfinite(d.size[i])) return LR_ERROR_NOT_FINITE;
    return invalid(wrong_sizes(d.kind, d.size));
}

Outcome check_shape(const lr_collider_desc& d) {
    switch (d.kind) {
    case LR_COLLIDER_PLANE:
        return {};
    case LR_COLLIDER_SPHERE:
    case LR_COLLIDER_CAPSULE:
    case LR_COLLIDER_BOX:
        return check_sizes(d);
    case LR_COLLIDER_HULL:
        return check_vertices(d, 4, LR_MAX_HULL_VERTICES);
    case LR_COLLIDER_HEIGHTFIELD:
        return check_heightfield(d);
    case LR_COLLIDER_MESH:
        return check_mesh(d);
    default:
        return invalid("unknown kind of collider");
    }
}

Outcome check_desc(const lr_collider_desc& d, const lr_collider_desc& before) {
    if (!finite(d.position, d.orientation, d.linear_velocity, d.angular_velocity, d.friction, d.restitution))
        return LR_ERROR_NOT_FINITE;
    if (d.flags != 0) return invalid("flags are not 0");
    for (const char* why :
         {wrong_pose(d.position, d.orientation), wrong_velocity(d.linear_velocity, d.angular_velocity),
          wrong_material(d.friction, d.restitution)})
        if (why) return invalid(why);
    // Consecutive descs often share arrays, which are checked once.
    return d.kind >= LR_COLLIDER_HULL && same_arrays(d, before) ? Outcome{} : check_shape(d);
}

Outcome check_motion(const lr_collider_motion& m) {
    if (m.mode < LR_MOVE_TO || m.mode > LR_MOVE_VELOCITY) return invalid("unknown mode of motion");
    if (!finite(m.position, m.orientation, m.linear_velocity, m.angular_velocity)) return LR_ERROR_NOT_FINITE;
    if (m.mode != LR_MOVE_VELOCITY)
        if (const char* why = wrong_pose(m.position, m.orientation)) return invalid(why);
    return m.mode == LR_MOVE_TO ? Outcome{} : invalid(wrong_velocity(m.linear_velocity, m.angular_velocity));
}
} // namespace
} // namespace lr::api

using namespace lr;
using namespace lr::api;

extern "C" {

lr_status lr_collider_create(lr_world* world, const lr_collider_desc* descs, uint32_t count, lr_collider* out_ids) {
    const auto create = [](lr_world& w, const Structs<lr_collider_desc>& all, Out<lr_collider> ids) -> Outcome {
        if (all.count == 0) return {};
        lr_collider_desc before{};
        const Outcome outcome = all.check([&](const lr_collider_desc& d) {
            Outcome one = check_desc(d, before);
            before = d;
            return one;
        });
        if (outcome.refused()) return outcome;
        if (!accepted(w) || !w.reserve_contact()) return LR_ERROR_OUT_OF_MEMORY;
        lr_status status = w.colliders.begin_create(all.count);
        all.visit([&](lr_collider_desc d) {
            // Zeroes sizes that the kind does not use: they are unchecked, and must not make equal colliders differ.
            std::fill(d.size + sizes_of(d.kind), d.size + 3, 0.0f);
            if (status == LR_OK) status = w.colliders.create(d);
        });
        if (status == LR_OK) status = w.colliders.finish_create(ids.first);
        if (status == LR_OK) return {};
        w.colliders.cancel_create();
        return {status, status == LR_ERROR_INVALID_ARGUMENT ? "a hull is flat, or a mesh has no area" : nullptr};
    };
    return change(world, args(Structs{descs, count}, Out{out_ids, count}), create);
}

lr_status lr_collider_destroy(lr_world* world, const lr_collider* colliders, uint32_t count) {
    return change(world, args(Handles{colliders, count}), [](lr_world& w, const Handles<lr_collider>& all) -> Outcome {
        if (all.count == 0) return {};
        if (!w.colliders.can_destroy(all.first, all.count)) return LR_ERROR_STALE_COLLIDER;
        // Sleeping bodies on them would hang in the air.
        uint32_t slot = 0;
        const bool sleeping = w.any_asleep();
        for (uint32_t i = 0; i < all.count && sleeping; ++i)
            if (w.colliders.find(all.first[i], slot)) w.wake_at(slot);
        w.colliders.destroy(all.first, all.count);
        w.each_batch([](Batch& batch, uint32_t) {
            if (batch.events()) batch.events()->recheck();
        });
        return {};
    });
}

int32_t lr_collider_is_valid(const lr_world* world, lr_collider collider) {
    return is_valid<ColliderSlot>(world, collider);
}

lr_status lr_collider_move(lr_world* world, const lr_collider_motion* motions, uint32_t count) {
    const auto move = [](lr_world& w, const Structs<lr_collider_motion>& all) -> Outcome {
        if (all.count == 0) return {};
        uint32_t slot = 0;
        w.colliders.begin_reserve();
        const Outcome outcome = all.check([&](const lr_collider_motion& m) -> Outcome {
            if (!w.colliders.find(m.collider, slot)) return LR_ERROR_STALE_COLLIDER;
            Outcome one = check_motion(m);
            if (!one.refused()) w.colliders.reserve_move(slot, m);
            return one;
        });
        if (outcome.refused()) return outcome;
        const bool sleeping = w.any_asleep();
        if (!accepted(w) || !w.colliders.finish_reserve()) return LR_ERROR_OUT_OF_MEMORY;
        all.visit([&](const lr_collider_motion& m) {
            w.colliders.find(m.collider, slot);
            if (sleeping && m.mode == LR_MOVE_PLACE) w.wake_at(slot);
            w.colliders.move(slot, m);
        });
        return {};
    };
    return change(world, args(Structs{motions, count}), move);
}

lr_status lr_collider_get_state(const lr_world* world, lr_collider collider, lr_collider_state* state) {
    return query(world, args(collider, state), [](const lr_world& w, ColliderSlot at, lr_collider_state& out) {
        const Collider& c = w.colliders.at(at.slot);
        const ColliderMotion& m = w.colliders.motion(at.slot);
        out.kind = static_cast<int32_t>(c.geometry.kind);
        put(c.begin.position, out.position);
        put(c.begin.rotation, out.orientation);
        put(m.linear, out.linear_velocity);
        put(m.angular, out.angular_velocity);
        out.friction = c.friction;
        out.restitution = c.restitution;
        out.layers = c.layers;
    });
}

lr_status lr_collider_set_material(lr_world* world, const lr_collider* colliders, uint32_t count,
                                   const lr_material* material) {
    const auto set = [](lr_world& w, const lr_material& s, const Handles<lr_collider>& all) -> Outcome {
        if (!finite(s.friction, s.restitution)) return LR_ERROR_NOT_FINITE;
        if (const char* why = wrong_material(s.friction, s.restitution)) return invalid(why);
        uint32_t slot = 0;
        for (uint32_t i = 0; i < all.count; ++i)
            if (!w.colliders.find(all.first[i], slot)) return LR_ERROR_STALE_COLLIDER;
        const bool sleeping = w.any_asleep();
        for (uint32_t i = 0; i < all.count; ++i) {
            w.colliders.find(all.first[i], slot);
            const Collider& c = w.colliders.at(slot);
            // Sleeping bodies may now slide, or fall through it.
            if (sleeping && (c.friction != s.friction || c.restitution != s.restitution || c.layers != s.layers))
                w.wake_at(slot);
            w.colliders.set_surface(slot, s.friction, s.restitution, s.layers);
        }
        return {};
    };
    return change(world, args(material, Handles{colliders, count}), set);
}

lr_status lr_batch_set_contact(lr_world* world, lr_batch batch, const lr_batch_contact* contact) {
    return change(world, args(batch, contact), [](lr_world& w, Batch& b, const lr_batch_contact* given) -> Outcome {
        const lr_batch_contact& c = given ? *given : initial_contact;
        if (!finite(c.friction, c.restitution, c.rolling_resistance, c.ground_effect, c.min_thickness))
            return LR_ERROR_NOT_FINITE;
        if (const char* why = wrong_in(c)) return invalid(why);
        b.wake_all();
        if (c.min_thickness != b.contact().min_thickness) w.pair_cache.forget(b.slot()); // gaps of the previous shape
        b.set_contact(c);
        return {};
    });
}

lr_status lr_batch_get_contact(const lr_world* world, lr_batch batch, lr_batch_contact* contact) {
    const auto get = [](const lr_world&, const Batch& b, lr_batch_contact& out) { out = b.contact(); };
    return query(world, args(batch, contact), get);
}

lr_status lr_batch_set_body_contact(lr_world* world, lr_batch a, lr_batch b, int32_t enabled) {
    return change(world, args(a, b, enabled), [](lr_world& w, lr_batch one, lr_batch other, int32_t on) -> Outcome {
        if (!w.find(one) || !w.find(other)) return LR_ERROR_STALE_BATCH;
        if (on != 0 && on != 1) return invalid("enabled is neither 0 nor 1");
        return w.set_pair(unpack(one).index, unpack(other).index, on != 0) ? LR_OK : LR_ERROR_OUT_OF_MEMORY;
    });
}

lr_status lr_batch_get_body_contact(const lr_world* world, lr_batch a, lr_batch b, int32_t* enabled) {
    const auto get = [](const lr_world& w, lr_batch one, lr_batch other, int32_t& on) -> Outcome {
        if (!w.find(one) || !w.find(other)) return LR_ERROR_STALE_BATCH;
        on = w.pairs.has(unpack(one).index, unpack(other).index) ? 1 : 0;
        return {};
    };
    return query(world, args(a, b, Required(enabled)), get);
}

lr_status lr_world_set_events(lr_world* world, uint32_t capacity, uint32_t kinds) {
    return change(world, args(capacity, kinds), [](lr_world& w, uint32_t most, uint32_t wanted) -> Outcome {
        if ((wanted & ~uint32_t{LR_EVENTS_ALL}) != 0) return invalid("unknown kinds of events");
        if (most != 0 && wanted == 0) return invalid("capacity is not 0, but kinds is");
        Buffer<lr_event> room;
        const bool on = w.events.on();
        bool enough = room.allocate(w.allocator, most);
        w.each_batch([&](Batch& batch, uint32_t) { enough = enough && (most == 0 || batch.reserve_events()); });
        w.each_batch([&](Batch& batch, uint32_t) {
            if (most == 0 || (!enough && !on))
                batch.drop_events();
            else if (enough && !on)
                batch.events()->resume(batch, w.colliders);
        });
        if (!enough) return LR_ERROR_OUT_OF_MEMORY;
        w.events.items.swap(room);
        w.events.kinds = wanted;
        w.events.begin_step();
        w.events.total_lost = 0;
        return {};
    });
}

lr_status lr_world_get_events(const lr_world* world, lr_event_list* list) {
    return query(world, args(list), [](const lr_world& w, lr_event_list& out) {
        const EventList& from = w.events;
        out.count = from.count;
        out.events = from.items.data();
        out.lost = from.lost;
        out.total_lost = from.total_lost;
        out.capacity = static_cast<uint32_t>(from.items.size());
        out.kinds = from.kinds;
    });
}

} // extern "C"
