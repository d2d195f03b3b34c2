// The uniform wind, wind sources, water, and the wind and water callbacks.
#include "api/checked_call.h"
#include "api/struct_conversion.h"
#include "environment/water.h"
#include "environment/wind_source.h"
#include "world/sleep/afloat.h"
#include "world/snapshot/snapshot_bytes.h"
#include "world/step/step_in_wind.h"

namespace lr::api {
namespace {

// kept: for an update, where null samples keep the present ones.
Outcome check(const SourceDesc& d, bool kept) {
    const Outcome outcome = check_wind_source(d);
    if (outcome.refused() || d.kind != SourceDesc::grid) return outcome;
    if (!d.samples) return kept ? LR_OK : LR_ERROR_NULL_ARGUMENT;
    for (uint64_t i = 0, count = sample_count(d); i < count; ++i) {
        if (!std::isfinite(d.samples[i])) return LR_ERROR_NOT_FINITE;
        if (!in_range(d.samples[i], -most_wind, most_wind)) return invalid("a sample is over 1000 m/s");
    }
    return {};
}

lr_status add_source(lr_world* world, const SourceOf& desc, lr_wind_source* out,
                     const char* function = __builtin_FUNCTION()) {
    if (out) *out = {};
    lr_wind_source unasked{};
    const auto add = [](lr_world& w, const SourceDesc& d, lr_wind_source& handle) -> Outcome {
        if (const Outcome outcome = check(d, false); outcome.refused()) return outcome;
        return accepted(w) ? w.wind.add(d, w.time, w.seed, handle) : LR_ERROR_OUT_OF_MEMORY;
    };
    return change(world, args(desc, Required(out ? out : &unasked)), add, function);
}

constexpr const char* other_kind = "the source is of another kind";

lr_status update_source(lr_world* world, lr_wind_source source, const SourceOf& desc,
                        const char* function = __builtin_FUNCTION()) {
    const auto update = [&](lr_world& w, const WindSource& held, const SourceDesc& d) -> Outcome {
        if (type_of(held.desc) != &desc.type) return invalid(other_kind);
        const Outcome outcome = check(d, true);
        return outcome.refused() ? outcome : w.wind.update(source, d, w.time, w.seed);
    };
    return change(world, args(source, desc), update, function);
}

lr_status get_source(const lr_world* world, lr_wind_source source, const SourceType& type, void* out,
                     const char* function = __builtin_FUNCTION()) {
    const auto get = [&](const lr_world& w, const WindSource& held) -> Outcome {
        if (const lr_status status = check_size(out, type.size, type.size); status != LR_OK) return status;
        if (type_of(held.desc) != &type) return invalid(other_kind);
        // Where it is now: a caller that changes something and updates does not move it back.
        SourceDesc now = held.desc;
        put(to_float(held.place(w.time)), now.position);
        desc_of(type, now, out);
        return {};
    };
    return query(world, args(source), get, function);
}

template <class Function, class Field>
lr_status set_callback(lr_world* world, Function callback, void* user, Field lr_world::*field,
                       const char* function = __builtin_FUNCTION()) {
    const auto set = [&](lr_world& w, uint32_t) {
        (w.*field).set_callback(callback, user);
        if (w.recorder) w.recorder->listen(w);
    };
    return change(world, args(callback ? 1u : 0u), set, function);
}
} // namespace
} // namespace lr::api

using namespace lr;
using namespace lr::api;

extern "C" {

lr_status lr_world_set_uniform_wind(lr_world* world, float x, float y, float z) {
    return change(world, args(x, y, z), [](lr_world& w, float vx, float vy, float vz) -> Outcome {
        const float velocity[3] = {vx, vy, vz};
        if (!finite(velocity)) return LR_ERROR_NOT_FINITE;
        if (const char* why = wrong_wind(velocity)) return invalid(why);
        std::copy(velocity, velocity + 3, w.wind.uniform.wind);
        return {};
    });
}

lr_status lr_world_get_uniform_wind(const lr_world* world, float* velocity) {
    const auto get = [](const lr_world& w, float& first) { std::copy_n(w.wind.uniform.wind, 3, &first); };
    return query(world, args(Required(velocity)), get);
}

// NOLINTBEGIN(bugprone-macro-parentheses): a type
#define LR_SOURCE(name, ...)                                                                                           \
    lr_status lr_world_add_##name(lr_world* world, const lr_##name##_desc* desc, lr_wind_source* out) {                \
        return add_source(world, {source_type::name, desc}, out);                                                      \
    }                                                                                                                  \
    lr_status lr_world_update_##name(lr_world* world, lr_wind_source source, const lr_##name##_desc* desc) {           \
        return update_source(world, source, {source_type::name, desc});                                                \
    }                                                                                                                  \
    lr_status lr_world_get_##name(const lr_world* world, lr_wind_source source, lr_##name##_desc* desc) {              \
        return get_source(world, source, source_type::name, desc);                                                     \
    }
LR_WIND_SOURCES(LR_SOURCE)
#undef LR_SOURCE
// NOLINTEND(bugprone-macro-parentheses)

lr_status lr_world_remove_wind(lr_world* world, lr_wind_source source) {
    return change(world, args(source), [&](lr_world& w, const WindSource&) { w.wind.remove(source); });
}

int32_t lr_wind_source_is_valid(const lr_world* world, lr_wind_source source) {
    return is_valid<const WindSource&>(world, source);
}

lr_status lr_world_set_wind_callback(lr_world* world, lr_wind_fn callback, void* user) {
    return set_callback(world, callback, user, &lr_world::wind);
}

lr_status lr_world_sample_wind(const lr_world* world, const float* positions, uint32_t count, float* velocities) {
    return query(world, args(), [&](const lr_world& w) -> Outcome {
        if (count == 0) return {};
        if (!positions || !velocities) return LR_ERROR_NULL_ARGUMENT;
        for (uint64_t i = 0; i < uint64_t{3} * count; ++i) {
            if (!std::isfinite(positions[i])) return LR_ERROR_NOT_FINITE;
            if (!in_range(positions[i], -most_place, most_place)) return invalid("position is over 1e9 m");
        }
        w.sample_wind(positions, count, velocities);
        return {};
    });
}

lr_status lr_world_set_water(lr_world* world, const lr_water_desc* desc) {
    return change(world, args(desc), [](lr_world& w, const lr_water_desc* d) -> Outcome {
        if (d)
            if (const Outcome outcome = check_water(*d); outcome.refused()) return outcome;
        if (d && !w.reserve_scratch()) return LR_ERROR_OUT_OF_MEMORY;
        const Water::Record before = w.surface.record();
        if (d)
            w.surface.set(*d, w.gravity, w.time);
        else
            w.surface.clear();
        if (same(before, w.surface.record())) return {};
        w.each_batch([&](Batch& batch, uint32_t) {
            forget_afloat(batch);
            // A waking body swaps places with one before it, already visited.
            for (uint32_t i = batch.awake(); i < batch.count(); ++i)
                if (w.surface.changes(before, batch.sleeping()->box(unpack(batch.ids()[i]).slot))) batch.wake(i);
        });
        return {};
    });
}

lr_status lr_world_get_water(const lr_world* world, lr_water_desc* desc, int32_t* present) {
    return query(world, args(desc, Required(present)), [](const lr_world& w, lr_water_desc& out, int32_t& there) {
        read_back(w.surface.present() ? &w.surface.desc() : nullptr, lr_water_desc_init, out, there);
    });
}

lr_status lr_world_set_water_callback(lr_world* world, lr_water_fn callback, void* user) {
    return set_callback(world, callback, user, &lr_world::surface);
}

} // extern "C"
