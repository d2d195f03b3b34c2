#include "field/wind_source.h"

#include "field/harmonic.h"
#include "kernel/limits.h"
#include "shape/portable_math.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace lr {

static_assert(outside_zero == LR_WIND_OUTSIDE_ZERO && outside_clamp == LR_WIND_OUTSIDE_CLAMP &&
              outside_repeat == LR_WIND_OUTSIDE_REPEAT);
namespace {

// A sum of octaves with energies 1, e, e^2, e^3 of the first: Kolmogorov's spectrum, e = 2^(-2/3). Eddies of half the
// size live 2^(-2/3) as long.
constexpr double octave_amplitude = 0.79370052598409973738; // 2^(-1/3)
constexpr double octave_energy = 0.62996052494743658238;    // 2^(-2/3)
// Of the lattice of eddies with random vectors of components in [-1, 1], by quadrature of its correlation: root mean
// square of each component, and longitudinal integral length over the cell, mean of all directions.
constexpr double eddy_rms = 0.3491933, eddy_length = 0.4976;
// A point of the turbulence is hardly ever faster than this many root mean squares.
constexpr double turbulence_peak = 4.0;
// Largest azimuthal speed of a Lamb-Oseen vortex, times 2 pi core / circulation.
constexpr double lamb_oseen_peak = 0.6382;
// s. An integral length of 5.67 z (IEC 61400-1: 8.1 times 0.7 z, below 60 m) at z = 2 m, in a wind of 3 m/s: 3.8 s.
constexpr double gust_period = 4.0;
constexpr double slow_beats = 64.0; // kernel/turbulence_field-inl.h
// Each octave's lattice is turned against the one before, and the first against the world, by 1.1 rad about (2, 3, 6)/7:
// neither a level plane nor another octave meets it in a pattern.
constexpr double lattice_turn[9] = {0.49820051967655058,  -0.69698542553354191, 0.51575920620782070,
                                    0.83079862028626160,  0.55395601749026718,  -0.053910882173887482,
                                    -0.24813281670198104, 0.45535046643264703,  0.85503570568433681};

double narrow_to_unit(double x) {
    return x - std::floor(x);
}
float to_float(double x) {
    return static_cast<float>(x);
}
bool normalise(const float v[3], double out[3]) {
    double norm = 0.0;
    for (size_t i = 0; i < 3; ++i) out[i] = static_cast<double>(v[i]), norm += out[i] * out[i];
    norm = std::sqrt(norm);
    if (!(norm > 1e-12) || !(norm < 1e18)) return false;
    for (size_t i = 0; i < 3; ++i) out[i] /= norm;
    return true;
}
// The slot of a line blower, straightened to be across the direction.
bool slot_of(const lr_wind_source_desc& d, double out[3]) {
    double a[3], s[3];
    if (!normalise(d.direction, a) || !normalise(d.side, s)) return false;
    const double along = a[0] * s[0] + a[1] * s[1] + a[2] * s[2];
    float across[3];
    for (size_t i = 0; i < 3; ++i) across[i] = to_float(s[i] - along * a[i]);
    return std::abs(along) < 0.999 && normalise(across, out);
}

double duration(const lr_wind_source_desc& d) {
    if (d.period > 0.0f) return static_cast<double>(d.period);
    if (d.kind == LR_WIND_SOURCE_GUSTS) return gust_period;
    if (d.kind == LR_WIND_SOURCE_TURBULENCE)
        return static_cast<double>(d.size) / std::max(static_cast<double>(d.speed), 1e-3);
    return 1.0;
}
bool vortical(int32_t kind) {
    return kind == LR_WIND_SOURCE_RANKINE || kind == LR_WIND_SOURCE_LAMB_OSEEN;
}
bool blowing(int32_t kind) {
    return kind == LR_WIND_SOURCE_POINT_BLOWER || kind == LR_WIND_SOURCE_LINE_BLOWER;
}

const char* wrong_in(const lr_wind_source_desc& d) {
    if (d.kind < LR_WIND_SOURCE_GUSTS || d.kind > LR_WIND_SOURCE_GROUND) return "unknown kind of wind source";
    if (d.reserved != 0) return "reserved is not 0";
    constexpr double long_way = 1e6;                            // m
    constexpr double least_length = static_cast<double>(1e-4f); // what a caller can give, which is less than 1e-4
    if (!within(d.position, most_place)) return "position is over 1e9 m";
    if (!within(d.velocity, most_wind)) return "velocity is over 1000 m/s";
    if (!in_range(d.speed, 0.0, most_wind)) return "speed is negative or over 1000 m/s";
    if (!in_range(d.size, least_length, long_way)) return "size is not 1e-4 to 1e6 m";
    if (!in_range(d.period, 0.0, 1e6)) return "period is negative or over 1e6 s";
    if (!in_range(d.spread, 0.0, 1.0)) return "spread is not 0 to 1";
    double unit[3];
    const bool directed = d.kind != LR_WIND_SOURCE_TURBULENCE && d.kind != LR_WIND_SOURCE_GRID;
    if (directed && !normalise(d.direction, unit)) return "direction has no length";
    if (d.kind == LR_WIND_SOURCE_LINE_BLOWER && !slot_of(d, unit)) return "side is not across the direction";
    if (vortical(d.kind)) {
        if (!in_range(d.circulation, -1e6, 1e6)) return "circulation is over 1e6 m^2/s";
        if (std::abs(d.circulation) > 6000.0f * d.size) return "the vortex is faster than 1000 m/s";
        if (!in_range(d.radius, 0.0, long_way)) return "radius is negative or over 1e6 m";
    }
    if (!in_range(d.half_length, 0.0, long_way)) return "half_length is negative or over 1e6 m";
    if (blowing(d.kind) && !in_range(d.range, static_cast<double>(d.size), long_way))
        return "range is below size or over 1e6 m";
    if (d.kind == LR_WIND_SOURCE_TURBULENCE && (d.octaves < 1 || d.octaves > 4)) return "octaves are not 1 to 4";
    if (d.kind == LR_WIND_SOURCE_GROUND && !in_range(d.reference_height, static_cast<double>(d.size), long_way))
        return "reference_height is below size or over 1e6 m";
    if (d.kind == LR_WIND_SOURCE_GRID) {
        if (!std::all_of(d.spacing, d.spacing + 3, [](float v) { return in_range(v, least_length, long_way); }))
            return "spacing is not 1e-4 to 1e6 m";
        if (d.outside < LR_WIND_OUTSIDE_ZERO || d.outside > LR_WIND_OUTSIDE_REPEAT) return "outside is unknown";
        uint64_t total = 1;
        for (uint64_t n : {d.counts[0], d.counts[1], d.counts[2], d.frames}) {
            if (n == 0 || n > LR_MAX_WIND_SAMPLES) return "a grid needs samples";
            total *= n;
            if (total > LR_MAX_WIND_SAMPLES) return "too many samples";
        }
    }
    return nullptr;
}

} // namespace

lr_status check_wind_source(const lr_wind_source_desc& d, const char*& why) {
    float words[source_bytes / 4];
    std::memcpy(words, &d, source_bytes);
    const auto all_finite = [&](size_t from, size_t to) {
        return std::all_of(words + from / 4, words + to / 4, [](float v) { return std::isfinite(v); });
    };
    if (!all_finite(offsetof(lr_wind_source_desc, position), offsetof(lr_wind_source_desc, octaves)) ||
        !all_finite(offsetof(lr_wind_source_desc, spacing), offsetof(lr_wind_source_desc, reserved)))
        return LR_ERROR_NOT_FINITE;
    why = wrong_in(d);
    return why ? LR_ERROR_INVALID_ARGUMENT : LR_OK;
}

uint64_t sample_count(const lr_wind_source_desc& d) {
    return uint64_t{3} * d.counts[0] * d.counts[1] * d.counts[2] * d.frames;
}

uint64_t hash_samples(const lr_wind_source_desc& d, const float* samples) {
    uint64_t hash = random_bits(d.counts[0] + (uint64_t{d.counts[1]} << 32), d.counts[2] + (uint64_t{d.frames} << 32));
    const uint64_t count = sample_count(d);
    for (uint64_t i = 0; i < count; ++i) hash = random_bits(hash ^ std::bit_cast<uint32_t>(samples[i]), 0);
    return hash;
}

Gusts gusts_of(const lr_wind_source_desc& d, uint64_t world_seed) {
    GustSettings s{};
    s.rms = static_cast<double>(d.speed);
    normalise(d.direction, s.direction);
    s.spread = static_cast<double>(d.spread);
    s.period = duration(d);
    return {s, CounterRandom(world_seed, d.seed, 0, Draws::gusts)};
}

uint32_t WindSource::instants() const {
    if (desc.kind == LR_WIND_SOURCE_GUSTS) return 0;
    return desc.kind == LR_WIND_SOURCE_TURBULENCE ? desc.octaves : 1;
}

float WindSource::fastest() const {
    constexpr float two_pi = 6.2831853f;
    switch (desc.kind) {
    case LR_WIND_SOURCE_RANKINE:
        return std::abs(desc.circulation) / (two_pi * desc.size);
    case LR_WIND_SOURCE_LAMB_OSEEN:
        return to_float(lamb_oseen_peak) * std::abs(desc.circulation) / (two_pi * desc.size);
    case LR_WIND_SOURCE_POINT_BLOWER:
    case LR_WIND_SOURCE_LINE_BLOWER:
        return desc.speed;
    case LR_WIND_SOURCE_TURBULENCE:
        return to_float(turbulence_peak) * desc.speed;
    case LR_WIND_SOURCE_GRID:
        return grid->fastest;
    default:
        return 0.0f;
    }
}

namespace {

// One instant for each octave.
void turbulence_at(const lr_wind_source_desc& desc, double time, double age, uint64_t world_seed, const double drift[3],
                   const double drift_velocity[3], SourceInstant* out) {
    double energy = 0.0, length = 0.0, part = 1.0, cell = 1.0;
    for (uint32_t o = 0; o < desc.octaves; ++o, part *= octave_energy, cell *= 0.5)
        energy += part, length += part * cell;
    cell = static_cast<double>(desc.size) / (eddy_length * length / energy);
    double strength = static_cast<double>(desc.speed) / (eddy_rms * std::sqrt(energy));
    double life = duration(desc);
    double axes[9] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
    for (uint32_t o = 0; o < desc.octaves; ++o, cell *= 0.5, strength *= octave_amplitude, life *= octave_energy) {
        double turned[9] = {};
        for (size_t i = 0; i < 9; ++i)
            for (size_t k = 0; k < 3; ++k) turned[i] += lattice_turn[i / 3 * 3 + k] * axes[3 * k + i % 3];
        std::copy(turned, turned + 9, axes);
        SourceInstant s{};
        s.kind = SourceKind::turbulence;
        s.strength = to_float(strength);
        s.seed = static_cast<uint32_t>(random_bits(world_seed ^ 0x7475726275ull, desc.seed + (uint64_t{o} << 32)));
        s.inverse_spacing[0] = to_float(1.0 / cell);
        double way[3];
        for (size_t k = 0; k < 3; ++k) {
            way[k] = drift[k] + age * static_cast<double>(desc.velocity[k]);
            s.motion[k] = to_float(drift_velocity[k] + static_cast<double>(desc.velocity[k]));
        }
        for (size_t i = 0; i < 3; ++i) {
            double moved = 0.0;
            for (size_t k = 0; k < 3; ++k) moved += axes[3 * i + k] * way[k] / cell;
            moved += random_unit(s.seed, i); // no lattice point at the world's origin
            const double whole = std::floor(moved);
            s.offset[i] = to_float(moved - whole);
            // Cells are counted modulo 2^32: the hash does not mind.
            const auto cells = static_cast<int64_t>(std::fmod(whole, 4294967296.0));
            s.cell[i] = static_cast<int32_t>(static_cast<uint32_t>(cells));
        }
        for (size_t i = 0; i < 9; ++i) s.lattice[i] = to_float(axes[i]);
        s.turn = to_float(narrow_to_unit(time / (slow_beats * life)));
        s.turn_rate = to_float(1.0 / (slow_beats * life));
        out[o] = s;
    }
}

} // namespace

void WindSource::at(double time, uint64_t world_seed, const double drift[3], const double drift_velocity[3],
                    SourceInstant* out) const {
    SourceInstant s{};
    const double age = time - since;
    double position[3], direction[3] = {}, side[3] = {};
    for (size_t i = 0; i < 3; ++i) {
        position[i] = static_cast<double>(desc.position[i]) + age * static_cast<double>(desc.velocity[i]);
        s.position[i] = s.center[i] = to_float(position[i]);
        s.motion[i] = desc.velocity[i];
    }
    normalise(desc.direction, direction);
    if (desc.kind == LR_WIND_SOURCE_LINE_BLOWER) slot_of(desc, side);
    for (size_t i = 0; i < 3; ++i) s.axis[i] = to_float(direction[i]), s.side[i] = to_float(side[i]);
    s.core = desc.size;
    s.half_length = desc.half_length;
    const auto limit = [](float length) { return length > 0.0f ? 1.0f / (length * length) : 0.0f; };
    const auto square = [](float v) { return static_cast<double>(v) * static_cast<double>(v); };
    const double size = static_cast<double>(desc.size);
    // A little more than the exact reach: rounding of the test must not cut off anything.
    constexpr double margin = 1.001;
    switch (desc.kind) {
    case LR_WIND_SOURCE_RANKINE:
    case LR_WIND_SOURCE_LAMB_OSEEN:
        s.kind = desc.kind == LR_WIND_SOURCE_RANKINE ? SourceKind::rankine : SourceKind::lamb_oseen;
        s.strength = to_float(static_cast<double>(desc.circulation) * 0.15915494309189533577);
        s.inverse_radius_sq = limit(desc.radius);
        s.inverse_length_sq = limit(desc.half_length);
        if (desc.radius > 0.0f && desc.half_length > 0.0f)
            s.reach = to_float(margin * std::sqrt(square(desc.radius) + square(desc.half_length)));
        break;
    case LR_WIND_SOURCE_POINT_BLOWER:
    case LR_WIND_SOURCE_LINE_BLOWER: {
        s.kind = desc.kind == LR_WIND_SOURCE_POINT_BLOWER ? SourceKind::point_blower : SourceKind::line_blower;
        s.strength = desc.speed;
        s.spread = desc.spread;
        s.range = desc.range;
        const double half = 0.5 * static_cast<double>(desc.range);
        for (size_t i = 0; i < 3; ++i) s.center[i] = to_float(position[i] + half * direction[i]);
        const double across = 4.0 * (size + 2.0 * half * static_cast<double>(desc.spread)) + size;
        const double slot = desc.kind == LR_WIND_SOURCE_LINE_BLOWER ? static_cast<double>(desc.half_length) : 0.0;
        s.reach = to_float(margin * std::sqrt((half + size) * (half + size) + (across + slot) * (across + slot)));
        break;
    }
    case LR_WIND_SOURCE_GRID: {
        s.kind = SourceKind::grid;
        double span = 0.0;
        for (size_t i = 0; i < 3; ++i) {
            s.inverse_spacing[i] = 1.0f / desc.spacing[i];
            s.count[i] = static_cast<int32_t>(desc.counts[i]);
            const double side_length = static_cast<double>(desc.spacing[i]) * (desc.counts[i] - 1.0);
            s.center[i] = to_float(position[i] + 0.5 * side_length);
            span += 0.25 * side_length * side_length;
        }
        s.outside = desc.outside;
        if (desc.outside == LR_WIND_OUTSIDE_ZERO) s.reach = to_float(margin * std::sqrt(span) + 1e-3);
        const double frame = time / duration(desc);
        const double whole = std::floor(frame), loop = static_cast<double>(desc.frames);
        const auto first = static_cast<uint64_t>(whole - loop * std::floor(whole / loop)) % desc.frames;
        const uint64_t stride = sample_count(desc) / desc.frames;
        s.frame[0] = grid->values.data() + first * stride;
        s.frame[1] = grid->values.data() + (first + 1) % desc.frames * stride;
        s.part = to_float(frame - whole);
        s.part_rate = to_float(1.0 / duration(desc));
        break;
    }
    case LR_WIND_SOURCE_GROUND:
        s.kind = SourceKind::ground;
        s.inverse_roughness = 1.0f / desc.size;
        s.inverse_log = to_float(1.0 / shape::portable_log(1.0 + static_cast<double>(desc.reference_height) / size));
        break;
    default:
        turbulence_at(desc, time, age, world_seed, drift, drift_velocity, out);
        return;
    }
    *out = s;
}

} // namespace lr
