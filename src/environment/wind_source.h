// A wind source: checks of its desc, its state between steps, and its constants for the kernel.
#pragma once

#include "base/allocator.h"
#include "base/counter_random.h"
#include "base/pose.h"
#include "kernel/limits.h"
#include "kernel/wind/sample_wind.h"
#include "langevin_rigid.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>

namespace lr {

// Any kind of wind source in one struct, for snapshots, recordings and hashes, with conversions from and to the descs of the API. Unused fields keep
// their initial values.
struct SourceDesc : SourceKinds {
    uint32_t struct_size = 144; // also where pointers have 32 bits
    int32_t kind = 0;
    float position[3] = {}, direction[3] = {1.0f, 0.0f, 0.0f}, side[3] = {0.0f, 0.0f, 1.0f}, velocity[3] = {};
    float speed = 1.0f, circulation = 1.0f, size = 1.0f, radius = 0.0f, half_length = 0.0f, range = 10.0f;
    float spread = 0.1f, period = 0.0f, reference_height = 10.0f;
    uint32_t octaves = 2, seed = 0;
    int32_t outside = LR_WIND_OUTSIDE_ZERO;
    uint32_t counts[3] = {}, frames = 1;
    float spacing[3] = {1.0f, 1.0f, 1.0f};
    uint32_t reserved = 0;
    const float* samples = nullptr; // of a caller's grid, not owned
};
// Bytes that define a source: all but the pointer, since samples are copied.
inline constexpr size_t source_bytes = offsetof(SourceDesc, samples);
static_assert(source_bytes == 136);

struct Limits {
    double low, high;
};
namespace limits {
inline constexpr Limits place{-1e9, 1e9}, wind{-1000.0, 1000.0}, speed{0.0, 1000.0};
inline constexpr Limits length{0.0, 1e6},
    some{static_cast<double>(1e-4f), 1e6}; // the lower limit is the float nearest to 1e-4, slightly less
inline constexpr Limits part{0.0, 1.0}, time{0.0, 1e6}, turn{-1e6, 1e6}, octaves{1.0, 4.0};
inline constexpr Limits outside{0.0, LR_WIND_OUTSIDE_REPEAT}, samples{1.0, LR_MAX_WIND_SAMPLES}, any{-1e18, 1e18};
} // namespace limits

// A field of a desc, and its place in SourceDesc.
struct SourceField {
    uint8_t in_source, in_desc, words;
    bool real, direction; // a float; a direction, of any length but 0
    Limits limits;
    const char* message;

    void copy(void* to, uint8_t at, const void* from, uint8_t from_at) const {
        std::memcpy(static_cast<unsigned char*>(to) + at, static_cast<const unsigned char*>(from) + from_at,
                    size_t{4} * words);
    }
    double number(const SourceDesc& source, uint32_t i) const {
        const auto* const at = reinterpret_cast<const unsigned char*>(&source) + in_source + size_t{4} * i;
        float f;
        uint32_t n;
        std::memcpy(&f, at, sizeof f);
        std::memcpy(&n, at, sizeof n);
        return real ? static_cast<double>(f) : n;
    }
};

// A desc of the API. A vortex desc begins with its core; a grid's samples at the end are not a field.
struct SourceType {
    int32_t first, last;  // of SourceDesc::Kind
    uint32_t size, bytes; // of the desc; of its part before the samples
    std::span<const SourceField> fields;

    // The kind, which for blowers follows from another field.
    int32_t adjusted(const SourceDesc& source) const {
        if (first == SourceDesc::point_blower) return first + (source.half_length > 0.0f);
        return source.kind;
    }
};

// X(field of SourceDesc, field of the kind's desc, limits)
// clang-format off
#define LR_GUSTS(X) \
    X(seed, seed, any) X(direction, direction, any) X(speed, rms, speed) X(spread, angle_rms, part) \
    X(period, integral_time, time)
#define LR_VORTEX(X) \
    X(position, position, place) X(direction, axis, any) X(velocity, velocity, wind) X(circulation, circulation, turn) \
    X(size, core_radius, some) X(radius, outer_radius, length) X(half_length, half_length, length)
#define LR_BLOWER(X) \
    X(position, position, place) X(direction, direction, any) X(side, side, any) X(velocity, velocity, wind) \
    X(speed, speed, speed) X(size, nozzle_radius, some) X(half_length, half_length, length) X(range, range, some) \
    X(spread, spread, part)
#define LR_TURBULENCE(X) \
    X(seed, seed, any) X(octaves, octaves, octaves) X(velocity, velocity, wind) X(speed, rms, speed) \
    X(size, integral_length, some) X(period, eddy_life, time)
#define LR_WIND_GRID(X) \
    X(outside, outside, outside) X(position, position, place) X(velocity, velocity, wind) X(spacing, spacing, some) \
    X(counts, counts, samples) X(frames, frames, samples) X(period, frame_time, time)
#define LR_GROUND_WIND(X) \
    X(position, position, place) X(direction, normal, any) X(velocity, velocity, wind) \
    X(size, roughness_length, some) X(reference_height, reference_height, some)
// clang-format on
// X(name in the API, fields, first kind, last kind)
#define LR_WIND_SOURCES(X)                                                                                             \
    X(gusts, LR_GUSTS, gusts, gusts)                                                                                   \
    X(vortex, LR_VORTEX, rankine, lamb_oseen)                                                                          \
    X(blower, LR_BLOWER, point_blower, line_blower)                                                                    \
    X(turbulence, LR_TURBULENCE, turbulence, turbulence)                                                               \
    X(wind_grid, LR_WIND_GRID, grid, grid)                                                                             \
    X(ground_wind, LR_GROUND_WIND, ground, ground)

template <class D> constexpr size_t bytes_before_samples() {
    if constexpr (requires(D d) { d.samples; })
        return offsetof(D, samples);
    else
        return sizeof(D);
}

// source_type::NAME
#define LR_FIELD(ours, its, range)                                                                                     \
    {offsetof(SourceDesc, ours),                                                                                       \
     offsetof(Desc, its),                                                                                              \
     sizeof(Desc::its) / 4,                                                                                            \
     std::is_same_v<std::remove_extent_t<decltype(Desc::its)>, float>,                                                 \
     offsetof(SourceDesc, ours) == offsetof(SourceDesc, direction),                                                    \
     limits::range,                                                                                                    \
     #its " is out of range"},
#define LR_SOURCE(name, fields, first, last)                                                                           \
    struct name##_fields {                                                                                             \
        using Desc = lr_##name##_desc;                                                                                 \
        static constexpr SourceField all[] = {fields(LR_FIELD)};                                                       \
    };                                                                                                                 \
    inline constexpr SourceType name{SourceDesc::first, SourceDesc::last, sizeof(lr_##name##_desc),                    \
                                     bytes_before_samples<lr_##name##_desc>(), name##_fields::all};
namespace source_type {
LR_WIND_SOURCES(LR_SOURCE)
#undef LR_SOURCE
#undef LR_FIELD
#define LR_SOURCE(name, ...) &name,
inline constexpr const SourceType* all[] = {LR_WIND_SOURCES(LR_SOURCE)};
#undef LR_SOURCE
} // namespace source_type
// Null for an unknown kind.
inline const SourceType* type_of(const SourceDesc& source) {
    for (const SourceType* type : source_type::all)
        if (source.kind >= type->first && source.kind <= type->last) return type;
    return nullptr;
}

// From a desc of the size that its type states. Kind 0: an unknown core.
inline SourceDesc source_of(const SourceType& type, const void* desc) {
    SourceDesc source;
    for (const SourceField& f : type.fields) f.copy(&source, f.in_source, desc, f.in_desc);
    source.kind = type.first;
    source.kind = type.adjusted(source);
    if (&type == &source_type::vortex) {
        const int32_t core = static_cast<const lr_vortex_desc*>(desc)->core;
        source.kind = core == LR_VORTEX_LAMB_OSEEN ? SourceDesc::lamb_oseen
                      : core == LR_VORTEX_RANKINE  ? SourceDesc::rankine
                                                   : 0;
    }
    if (&type == &source_type::wind_grid) source.samples = static_cast<const lr_wind_grid_desc*>(desc)->samples;
    return source;
}
// Sets all but struct_size, which is the caller's.
inline void desc_of(const SourceType& type, const SourceDesc& source, void* desc) {
    std::memset(static_cast<unsigned char*>(desc) + 4, 0, type.size - 4);
    for (const SourceField& f : type.fields) f.copy(desc, f.in_desc, &source, f.in_source);
    if (source.kind == SourceDesc::rankine) static_cast<lr_vortex_desc*>(desc)->core = LR_VORTEX_RANKINE;
    if (source.kind == SourceDesc::grid) static_cast<lr_wind_grid_desc*>(desc)->samples = source.samples;
}

// Random bits by counter (SplitMix64).
inline uint64_t random_bits(uint64_t seed, uint64_t counter) {
    return mix64(seed + (counter + 1) * 0x9e3779b97f4a7c15ull);
}

// Gusts: a velocity that depends on time alone, a sum of harmonics with von Karman's spectrum (docs/reference/wind_and_water.md). They begin at 0;
// each harmonic grows over its first cycle, slow ones within four integral times.
class Gusts {
public:
    static constexpr size_t modes = 48;

    Gusts() = default;
    Gusts(const SourceDesc& desc, uint64_t world_seed);
    // Adds the velocity at an age in s. There is no state between calls, so ages may come in any order.
    void add(double age, double (&velocity)[3]) const;

private:
    struct Mode {
        double frequency; // 1/s
        double growth;    // 1/s
        double phase;     // turns
        Double3 amplitude;
    };
    std::array<Mode, modes> mode_{};
};

// Samples of a grid, shared by the sources that use them.
struct GridSamples {
    uint32_t references;
    uint64_t hash; // of counts, frames and samples
    Buffer<float> values;
    float fastest; // m/s
};

// Samples are not checked.
Outcome check_wind_source(const SourceDesc& desc);
// Number of floats in a grid.
uint64_t sample_count(const SourceDesc& desc);
// Fills a grid, whose values are allocated, from the desc's samples.
void take_samples(const SourceDesc& desc, GridSamples& grid);

// Displacement and velocity of the uniform wind, which carries turbulence along.
struct Carried {
    double way[3], velocity[3];
};

// State of a source that updates keep.
struct SourcePhase {
    double since; // s, world time when it was at desc.position, or gusts and turbulence began
    // How far earlier rates took turbulence (m) or, in the first number, frames ahead of the present rate. 0 if it never changed.
    double shift[3];
};
bool wrong_phase(const SourceDesc& desc, const SourcePhase& phase, double now);

struct WindSource {
    SourceDesc desc; // without samples
    SourcePhase phase;
    GridSamples* grid; // null for other kinds
    Gusts gusts;

    uint64_t hash() const { return grid ? grid->hash : 0; } // of its samples
    uint32_t instants() const;                              // how many SourceInstants it makes
    Double3 place(double time) const;
    SourcePhase phase_for(const SourceDesc& next, double now) const; // if it becomes `next` now
    float fastest() const;                                           // m/s, bound of its velocities, or a typical speed
    void at(double time, uint64_t world_seed, const Carried& carried, SourceInstant* out) const; // instants() of them
};
} // namespace lr
