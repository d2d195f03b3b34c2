// Colliders of every kind: creation, motion, materials, end.
#include "fuzz/api/model.h"

#include <set>

namespace fuzz {
namespace {

// Of hulls and meshes: a box, a flat square, not finite, too far out, a needle, random points.
constexpr uint32_t most_vertices = 260, kinds_of_vertices = 6;
const float* vertices(uint32_t kind) {
    static const auto all = [] {
        std::array<std::array<float, 3 * most_vertices>, kinds_of_vertices> v{};
        for (uint32_t i = 0; i < most_vertices; ++i)
            for (uint32_t k = 0; k < 3; ++k) {
                const float corner = (i >> k & 1u) != 0 ? 0.5f : -0.5f;
                const float random = static_cast<float>((i * 3 + k + 1) * 2654435761u >> 16) * 1e-5f;
                v[0][3 * i + k] = v[2][3 * i + k] = v[3][3 * i + k] = corner;
                v[1][3 * i + k] = k == 1 ? 0.0f : corner;
                v[4][3 * i + k] = k == 0 ? corner * 1e5f : corner * 1e-3f;
                v[5][3 * i + k] = random;
            }
        v[2][4] = std::numeric_limits<float>::quiet_NaN();
        v[3][5] = 1.001e6f;
        return v;
    }();
    return all[kind].data();
}
const uint32_t* indices(uint32_t kind) {
    static const uint32_t all[4][12] = {{0, 1, 2, 1, 3, 2, 4, 6, 5, 5, 6, 7},
                                        {0, 0, 0, 1, 1, 2, 3, 3, 3, 1, 1, 1},
                                        {0, 1, 0xffffffffu, 2, 3, 1000, 1, 2, 3, 1, 2, 3},
                                        {2, 1, 0, 2, 1, 0, 1, 2, 0, 2, 0, 1}};
    return all[kind % 4];
}
const float* heights(uint32_t kind) {
    static const auto all = [] {
        std::array<std::array<float, 64>, 4> h{};
        for (size_t i = 0; i < 64; ++i) {
            h[0][i] = static_cast<float>(i % 3) * 0.1f;
            h[2][i] = h[3][i] = static_cast<float>(i % 2) * 9e5f;
        }
        h[2][1] = std::numeric_limits<float>::infinity();
        h[3][1] = 2e6f;
        return h;
    }();
    return all[kind % 4].data();
}

void expect_pose(const float (&position)[3], const float (&orientation)[4], Expected& e) {
    e.range(position, -1e9, 1e9);
    e.length(orientation, 1e-5, 1e5);
}

void expect_shape(lr_collider_desc& d, uint32_t kind, Expected& e) {
    switch (d.kind) {
    case LR_COLLIDER_PLANE:
        return;
    case LR_COLLIDER_SPHERE:
    case LR_COLLIDER_CAPSULE:
    case LR_COLLIDER_BOX:
        for (int32_t k = 0; k < d.kind - 1; ++k) {
            e.range(d.size[k], 0.0, 1e6);
            e.add_if(d.size[k] == 0.0f, LR_ERROR_INVALID_ARGUMENT);
        }
        return;
    case LR_COLLIDER_HULL:
    case LR_COLLIDER_MESH: {
        const bool hull = d.kind == LR_COLLIDER_HULL;
        const uint32_t limit = hull ? LR_MAX_HULL_VERTICES : LR_MAX_COLLIDER_VERTICES;
        // Required arrays must exist.
        if (d.vertex_count > most_vertices && d.vertex_count <= limit) d.vertex_count = 8;
        if (d.triangle_count > 4 && d.triangle_count <= LR_MAX_COLLIDER_VERTICES) d.triangle_count = 4;
        const bool counted = d.vertex_count >= (hull ? 4u : 3u) && d.vertex_count <= limit;
        const bool meshed = hull || (d.triangle_count >= 1 && d.triangle_count <= LR_MAX_COLLIDER_VERTICES);
        e.add_if(!counted || !meshed, LR_ERROR_INVALID_ARGUMENT);
        e.add_if(!d.vertices || (!hull && !d.indices), LR_ERROR_NULL_ARGUMENT);
        if (d.vertices && kind == 2 && counted) e.add(LR_ERROR_NOT_FINITE);
        if (d.vertices && kind == 3 && counted) e.add(LR_ERROR_INVALID_ARGUMENT);
        e.add_if(hull && kind == 1 && counted && d.vertices, LR_ERROR_INVALID_ARGUMENT);
        if (!hull && meshed && d.indices)
            for (uint32_t i = 0; i < 3 * d.triangle_count; ++i)
                e.add_if(counted && d.indices[i] >= d.vertex_count, LR_ERROR_INVALID_ARGUMENT);
        // Flat hulls of few points, meshes without an area.
        e.may_if(kind != 0 || d.vertex_count < 8 || (!hull && d.indices != indices(0)), LR_ERROR_INVALID_ARGUMENT);
        return;
    }
    case LR_COLLIDER_HEIGHTFIELD: {
        const uint64_t samples = uint64_t{d.counts[0]} * d.counts[1];
        if (samples > 64 && samples <= LR_MAX_COLLIDER_VERTICES && d.counts[0] >= 2 && d.counts[1] >= 2)
            d.counts[0] = d.counts[1] = 3;
        const uint64_t now = uint64_t{d.counts[0]} * d.counts[1];
        e.add_if(d.counts[0] < 2 || d.counts[1] < 2 || now > LR_MAX_COLLIDER_VERTICES, LR_ERROR_INVALID_ARGUMENT);
        e.range(d.spacing[0], 1e-6, 1e6);
        e.range(d.spacing[1], 1e-6, 1e6);
        e.add_if(!d.heights, LR_ERROR_NULL_ARGUMENT);
        if (d.heights && now >= 4 && now <= 64)
            for (uint64_t i = 0; i < now; ++i) e.range(d.heights[i], -1e6, 1e6);
        return;
    }
    default:
        e.add(LR_ERROR_INVALID_ARGUMENT);
    }
}

lr_collider_desc read_desc(Fuzzer& f, Expected& e) {
    Input& in = f.in;
    lr_collider_desc d = initialised(LR_CALL(lr_collider_desc_init));
    d.kind = 1 + in.handle(0) % 7;
    for (float& s : d.size) s = 0.3f;
    d.position[1] = in.handle(0) / 8 % 4 == 0 ? -0.5f : -0.1f;
    const uint32_t kind = in.handle(2) < 160 ? 0 : in.handle(2) % kinds_of_vertices;
    d.vertex_count = 8, d.triangle_count = 4, d.counts[0] = d.counts[1] = 3;
    d.vertices = vertices(kind), d.indices = indices(in.handle(2) < 160 ? 0u : in.handle(2) / 8u);
    d.heights = heights(in.handle(2) < 160 ? in.handle(2) % 2u : in.handle(2) % 4u);
    in.change(d.position, d.orientation, d.linear_velocity, d.angular_velocity, d.size, d.friction, d.restitution,
              d.layers, d.flags, d.kind, d.vertex_count, d.triangle_count, d.counts, d.spacing);
    if (in.null(3)) (d.kind == LR_COLLIDER_HEIGHTFIELD ? d.heights : d.vertices) = nullptr;
    if (in.null(3) && in.variant() == 1) d.indices = nullptr;
    expect_pose(d.position, d.orientation, e);
    e.range(d.linear_velocity, -1e6, 1e6);
    e.range(d.angular_velocity, -1e6, 1e6);
    e.range(d.friction, 0.0, 10.0);
    e.range(d.restitution, 0.0, 1.0);
    e.add_if(d.flags != 0, LR_ERROR_INVALID_ARGUMENT);
    expect_shape(d, kind, e);
    return d;
}

void create(Fuzzer& f) {
    World& w = f.world();
    Input& in = f.in;
    const uint32_t count = in.handle(1) < 192 ? 1u : in.handle(1) % 4u;
    if (w.state.colliders.size() > 24) return;
    Expected e, one;
    const lr_collider_desc d = read_desc(f, one);
    if (count != 0) e = one;
    std::vector<lr_collider_desc> descs(count, d);
    // A box besides, created and destroyed with the others.
    if (count > 1) descs[0].kind = LR_COLLIDER_BOX, std::fill(descs[0].size, descs[0].size + 3, 0.2f);
    GivenArray<lr_collider_desc> given(in, descs, 1, e);
    Call call(f, w, "lr_collider_create", e);
    std::vector<lr_collider> ids(count);
    const bool known = !in.null(2);
    if (!call.ended(LR_CALL(lr_collider_create)(call.world(), given.get(), count, known ? ids.data() : nullptr)))
        return;
    if (!known) {
        w.state.loose = true; // their ids are lost
        return;
    }
    for (uint32_t i = 0; i < count; ++i) {
        if (!w.state.loose && (ids[i].id == 0 || w.collider(ids[i])))
            defect("lr_collider_create", "the handle of another");
        w.state.colliders.push_back({ids[i], descs[i]});
    }
}

std::vector<lr_collider> some(Fuzzer& f, World& w, uint32_t count, Expected& e) {
    std::vector<lr_collider> ids(count);
    for (uint32_t i = 0; i < count; ++i) {
        ids[i] = f.pick_collider(w, f.in.value(i));
        e.add_if(!w.collider(ids[i]), LR_ERROR_STALE_COLLIDER);
    }
    e.add_if(f.in.null(1) && count != 0, LR_ERROR_NULL_ARGUMENT);
    return ids;
}

void destroy(Fuzzer& f) {
    World& w = f.world();
    const uint32_t count = f.in.handle(0) % 4;
    Expected e;
    const std::vector<lr_collider> ids = some(f, w, count, e);
    e.add_if(std::set<lr_collider>(ids.begin(), ids.end()).size() != ids.size(), LR_ERROR_STALE_COLLIDER);
    Call call(f, w, "lr_collider_destroy", e);
    if (!call.ended(LR_CALL(lr_collider_destroy)(call.world(), f.in.null(1) ? nullptr : ids.data(), count))) return;
    for (lr_collider id : ids) {
        std::erase_if(w.state.colliders, [&](const Collider& c) { return c.id == id; });
        w.stale_colliders.push_back(id);
    }
}

void surface(Fuzzer& f) {
    World& w = f.world();
    lr_material s = initialised(LR_CALL(lr_material_init));
    const uint32_t count = f.in.handle(0) % 3;
    Expected e;
    const std::vector<lr_collider> ids = some(f, w, count, e);
    s.friction = f.in.real(f.in.value(4)), s.restitution = f.in.real(f.in.value(5)), s.layers = f.in.value(4);
    e.range(s.friction, 0.0, 10.0);
    e.range(s.restitution, 0.0, 1.0);
    Given<lr_material> given(f.in, s, 2, e);
    Call call(f, w, "lr_collider_set_material", e);
    call.ended(
        LR_CALL(lr_collider_set_material)(call.world(), f.in.null(1) ? nullptr : ids.data(), count, given.get()));
}

void move(Fuzzer& f) {
    World& w = f.world();
    Input& in = f.in;
    const uint32_t count = in.handle(0) % 4;
    std::vector<lr_collider_motion> motions(count, initialised(LR_CALL(lr_collider_motion_init)));
    Expected e;
    for (uint32_t i = 0; i < count; ++i) {
        lr_collider_motion& m = motions[i];
        m.mode = 1 + (in.handle(1) + static_cast<int32_t>(i)) % 3;
        m.collider = f.pick_collider(w, static_cast<uint8_t>(in.handle(2) + 16 * i));
        m.position[1] = -0.2f;
        if (i == in.variant() % count)
            in.change(m.position, m.orientation, m.linear_velocity, m.angular_velocity, m.mode, m.reserved);
        e.add_if(!w.collider(m.collider), LR_ERROR_STALE_COLLIDER);
        e.add_if(m.mode < LR_MOVE_TO || m.mode > LR_MOVE_VELOCITY || m.reserved != 0, LR_ERROR_INVALID_ARGUMENT);
        Expected pose, speed;
        expect_pose(m.position, m.orientation, pose);
        speed.range(m.linear_velocity, -1e6, 1e6);
        speed.range(m.angular_velocity, -1e6, 1e6);
        // Unused fields of a mode must at least be finite.
        for (const auto& [part, used] : {std::pair{&pose, m.mode != LR_MOVE_VELOCITY}, {&speed, m.mode != LR_MOVE_TO}})
            for (lr_status s : {LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT}) {
                e.add_if(used && part->fails() && part->allows(s), s);
                e.may_if(part->allows(s), s);
            }
    }
    GivenArray<lr_collider_motion> given(in, motions, 1, e);
    Call call(f, w, "lr_collider_move", e);
    call.ended(LR_CALL(lr_collider_move)(call.world(), given.get(), count));
}

void state(Fuzzer& f) {
    World& w = f.world();
    const lr_collider id = f.pick_collider(w, f.in.handle(0));
    Expected e;
    e.add_if(!w.collider(id), LR_ERROR_STALE_COLLIDER);
    Given<lr_collider_state> given(f.in, initialised(LR_CALL(lr_collider_state_init)), 1, e);
    Call call(f, w, "lr_collider_get_state", e);
    call.ended(LR_CALL(lr_collider_get_state)(call.world(), id, given.get()));
}

} // namespace

std::vector<Named> collider_operations() {
    return {{"collider_create", create}, {"collider_destroy", destroy}, {"collider_surface", surface},
            {"collider_move", move},     {"collider_state", state},     {"collider_create", create}};
}

} // namespace fuzz
