// Every call of the header with valid arguments: api/calls.inc, written by bindings/generator/runtime.py, has
//     LR_CALL(function, arguments...)
//     LR_PLAIN_CALL(function, arguments...), for numbers or a struct without pointers
// where `s` is a Stage. Numbers are int or float.
#pragma once

#include "support/arguments.h"
#include "support/colliders.h"
#include "support/scene.h"

#include <array>
#include <memory>

namespace test {

template <class T>
concept Sized = requires(T s) {
    s.struct_size;
};

#define LR_STRUCT(name, initial)                                                                                       \
    inline lr_status init(name* s, uint32_t size) {                                                                    \
        return name##_init(s, size);                                                                                   \
    }
#include "../src/api/structs.inc"
#undef LR_STRUCT

// Objects and arguments for the calls.
struct Stage {
    Asset shape = leaf();
    World place = make(world_desc());
    lr_world* world = place.get();
    lr_asset* asset = shape.get();
    lr_batch batch = add_batch(place, shape, 8);
    lr_body body = add_body(place, batch, body_desc());
    lr_collider collider = add_collider(place, collider_desc(LR_COLLIDER_PLANE));
    lr_wind_source wind_source{};
    const float samples[3] = {1.0f, 1.0f, 1.0f};
    std::vector<std::shared_ptr<void>> kept; // until the call is over

    Stage() {
        wind_source = wind_source_of(lr_world_add_gusts);
        set_constant_table(place, batch, 1.0, 1.0, 1.0); // `capacity` is 1 in the calls
    }
    // A source of the function's kind.
    template <class D> lr_wind_source wind_source_of(lr_status (*add)(lr_world*, const D*, lr_wind_source*)) {
        lr_wind_source source{};
        REQUIRE(add(world, of<D>(), &source) == LR_OK);
        return source;
    }
    // Zeroed memory.
    template <class T> T* memory() {
        kept.push_back(std::make_shared<std::array<uint64_t, 32>>());
        return static_cast<T*>(kept.back().get());
    }
    // An asset or a world that is freed with the stage.
    template <class T> T* out() {
        T* const result = memory<T>();
        const auto end = [memory = kept.back()](T* one) {
            if constexpr (std::is_same_v<T, lr_asset*>)
                lr_asset_release(*one);
            else
                lr_world_destroy(*one);
        };
        kept.emplace_back(result, end);
        return result;
    }
    // A valid struct.
    template <Sized T> T* of() {
        const auto one = std::make_shared<T>();
        REQUIRE(init(one.get(), sizeof(T)) == LR_OK);
        fill(*one);
        kept.push_back(one);
        return one.get();
    }

private:
    template <class T> void fill(T&) {}
    void fill(lr_ellipsoid_desc& d) { d = ellipsoid(0.1, 0.1, 0.1, 500.0); }
    void fill(lr_rigid_desc& d) { d = rigid_plate(); }
    void fill(lr_batch_desc& d) { d.asset = asset, d.capacity = 1; }
    void fill(lr_wind_grid_desc& d) {
        d.counts[0] = d.counts[1] = d.counts[2] = 1;
        d.samples = samples;
    }
    void fill(lr_turbulence_table& t) {
        t.count = 1;
        t.chi = t.epsilon = samples;
        t.dt = t.u0 = t.l = 1.0f;
    }
    void fill(lr_body_force& f) { f.body = body; }
    void fill(lr_collider_desc& d) { d.kind = LR_COLLIDER_PLANE; }
    void fill(lr_collider_motion& m) { m.collider = collider; }
    void fill(lr_recording_desc& d) {
        d.write = [](void*, const void*, uint64_t) -> int32_t { return 0; };
    }
};

} // namespace test
