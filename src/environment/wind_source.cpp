#include "environment/wind_source.h"

#include "base/bit_cast.h"
#include "base/portable_math.h"

#include <algorithm>
#include <cmath>

namespace lr {

namespace {

// Octaves of turbulence have energies 1, e, e^2, e^3, e = 2^(-2/3) (Kolmogorov's spectrum). Eddies of half the size live 2^(-2/3) as long.
constexpr double octave_amplitude = 0.79370052598409973738; // 2^(-1/3)
constexpr double octave_energy = 0.62996052494743658238;    // 2^(-2/3)
// Eddies on the lattice have components in [-1, 1]. Measured: rms of a component, mean longitudinal integral length in cells.
constexpr double eddy_rms = 0.0725003, eddy_length = 0.3218;
// Speed of turbulence over its root mean square, hardly ever exceeded.
constexpr double turbulence_peak = 4.0;
// Largest azimuthal speed of a Lamb-Oseen vortex, over circulation/(2 pi core).
constexpr double lamb_oseen_peak = 0.6382;
// s. IEC 61400-1 below 60 m: an integral length of 8.1 x 0.7 z = 5.67 z. At z = 2 m in a wind of 3 m/s: 3.8 s.
constexpr double gust_period = 4.0;
constexpr double slow_beats = 64.0; // as in kernel/wind/sample_wind.cpp
// Rotates each octave's lattice against the one before, the first against the world: 1.1 rad about (2, 3, 6)/7. No plane shows a common pattern.
constexpr double lattice_turn[9] = {0.49820051967655058,  -0.69698542553354191, 0.51575920620782070,
                                    0.83079862028626160,  0.55395601749026718,  -0.053910882173887482,
                                    -0.24813281670198104, 0.45535046643264703,  0.85503570568433681};

float narrow(double x) {
    return static_cast<float>(x);
}
bool normalise(const float (&v)[3], Double3& out) {
    const Double3 given = to_double(vector_of(v));
    const double norm = length(given);
    if (!(norm > 1e-12) || !(norm < 1e18)) return false;
    out = given / norm;
    return true;
}
// The slot of a line blower, made normal to its direction.
bool slot_of(const SourceDesc& d, Double3& out) {
    Double3 a{}, s{};
    if (!normalise(d.direction, a) || !normalise(d.side, s)) return false;
    const double along = dot(a, s);
    float across[3];
    put(to_float(s - along * a), across);
    return std::abs(along) < 0.999 && normalise(across, out);
}

// s, at least a nanosecond: its inverse must be finite in single precision.
double duration(const SourceDesc& d) {
    if (d.period > 0.0f) return std::max(wide(d.period), 1e-9);
    if (d.kind == SourceDesc::gusts) return gust_period;
    if (d.kind == SourceDesc::turbulence) return wide(d.size) / std::max(wide(d.speed), 1e-3);
    return 1.0;
}

// Null if valid, else the reason. Each field by itself must be within its limits.
const char* wrong_in(const SourceDesc& d) {
    Double3 slot{};
    switch (d.kind) {
    case SourceDesc::rankine:
    case SourceDesc::lamb_oseen:
        return std::abs(d.circulation) > 6000.0f * d.size ? "the vortex is faster than 1000 m/s" : nullptr;
    case SourceDesc::line_blower:
    case SourceDesc::point_blower:
        if (d.half_length > 0.0f && !slot_of(d, slot)) return "side is parallel to direction";
        return d.range < d.size ? "range is below nozzle_radius" : nullptr;
    case SourceDesc::grid: {
        uint64_t total = 1;
        for (uint64_t n : {d.counts[0], d.counts[1], d.counts[2], d.frames})
            if ((total *= n) > LR_MAX_WIND_SAMPLES) return "too many samples";
        return nullptr;
    }
    case SourceDesc::ground:
        return d.reference_height < d.size ? "reference_height is below roughness_length" : nullptr;
    default:
        return nullptr;
    }
}

// Frequencies times the integral time. 2 % of the spectrum's energy are below, 3 % above; the sum is scaled to the full variance.
constexpr double lowest = 0.005, highest = 20.0;
// Integral times after which all harmonics have full amplitude; slow ones would take up to 1/lowest.
constexpr double youth = 4.0;

// Sine and cosine of a phase in turns, the same with every C library; absolute error below 1e-14.
void sin_cos_turns(double turns, double& sine, double& cosine) {
    const double quadrant = std::floor(4.0 * turns + 0.5);
    const double x = (4.0 * turns - quadrant) * 1.57079632679489661923, z = x * x; // |x| <= pi/4
    double s = 0.0, c = 0.0;
    for (int k = 8; k >= 1; --k) {
        s = (s + 1.0) * -z / (2.0 * k * (2.0 * k + 1.0));
        c = (c + 1.0) * -z / (2.0 * k * (2.0 * k - 1.0));
    }
    s = x * (1.0 + s);
    c = 1.0 + c;
    switch (static_cast<int>(quadrant - 4.0 * std::floor(0.25 * quadrant))) {
    case 0:
        sine = s, cosine = c;
        return;
    case 1:
        sine = c, cosine = -s;
        return;
    case 2:
        sine = -s, cosine = -c;
        return;
    default:
        sine = -c, cosine = s;
    }
}
} // namespace

Outcome check_wind_source(const SourceDesc& source) {
    const SourceType* const type = type_of(source);
    if (!type) return invalid("core is unknown");
    SourceDesc same;
    same.kind = source.kind;
    bool numbers = true;
    const char* wrong = nullptr;
    for (const SourceField& f : type->fields) {
        f.copy(&same, f.in_source, &source, f.in_source);
        bool in_limits = true;
        for (uint32_t i = 0; i < f.words; ++i) {
            const double v = f.number(source, i);
            numbers = numbers && std::isfinite(v);
            in_limits = in_limits && in_range(v, f.limits.low, f.limits.high);
        }
        Double3 unit{};
        if (f.direction) in_limits = normalise(source.direction, unit);
        if (!in_limits && !wrong) wrong = f.message;
    }
    if (!numbers) return LR_ERROR_NOT_FINITE;
    if (!wrong) wrong = wrong_in(source);
    // Fails only for snapshots that were modified.
    if (!wrong && (std::memcmp(&same, &source, source_bytes) != 0 || type->adjusted(source) != source.kind))
        wrong = "the source has fields of another kind";
    return invalid(wrong);
}

uint64_t sample_count(const SourceDesc& d) {
    return uint64_t{3} * d.counts[0] * d.counts[1] * d.counts[2] * d.frames;
}

// In one pass: the hash is a chain in which each sample waits for the one before, and the rest is done meanwhile.
void take_samples(const SourceDesc& d, GridSamples& grid) {
    uint64_t hash = random_bits(d.counts[0] + (uint64_t{d.counts[1]} << 32), d.counts[2] + (uint64_t{d.frames} << 32));
    const uint64_t count = sample_count(d);
    float fastest = 0.0f;
    float* const to = grid.values.data();
    for (size_t i = 0; i < count; ++i) {
        to[i] = d.samples[i];
        fastest = std::max(fastest, std::abs(d.samples[i]));
        hash = random_bits(hash ^ bit_cast<uint32_t>(d.samples[i]), 0);
    }
    to[static_cast<size_t>(count)] = 0.0f; // the kernel loads samples as four floats
    grid.fastest = fastest;
    grid.hash = hash;
}

uint32_t WindSource::instants() const {
    if (desc.kind == SourceDesc::gusts) return 0;
    return desc.kind == SourceDesc::turbulence ? desc.octaves : 1;
}

float WindSource::fastest() const {
    constexpr float two_pi = 6.2831853f;
    switch (desc.kind) {
    case SourceDesc::rankine:
        return std::abs(desc.circulation) / (two_pi * desc.size);
    case SourceDesc::lamb_oseen:
        return narrow(lamb_oseen_peak) * std::abs(desc.circulation) / (two_pi * desc.size);
    case SourceDesc::point_blower:
    case SourceDesc::line_blower:
        return desc.speed;
    case SourceDesc::turbulence:
        return narrow(turbulence_peak) * desc.speed;
    case SourceDesc::grid:
        return grid->fastest;
    default:
        return 0.0f;
    }
}

bool wrong_phase(const SourceDesc& d, const SourcePhase& phase, double now) {
    const double least = d.kind == SourceDesc::turbulence ? -most_way : 0.0;
    const double most = d.kind == SourceDesc::grid ? d.frames : -least;
    return !in_range(phase.since, -most_time, now) || !in_range(phase.shift[0], least, most) ||
           !in_range(phase.shift[1], least, -least) || !in_range(phase.shift[2], least, -least);
}

// Random winds go on, at the same phase in units of their own time, and frames do: they may be set anew in each frame.
SourcePhase WindSource::phase_for(const SourceDesc& next, double now) const {
    SourcePhase to = phase;
    const double was = duration(desc), is = duration(next);
    if (desc.kind != SourceDesc::gusts && desc.kind != SourceDesc::turbulence)
        to.since = now;
    else if (is != was)
        to.since = now - std::min(is / was * (now - phase.since), most_time);
    if (desc.kind == SourceDesc::turbulence)
        for (size_t k = 0; k < 3; ++k)
            to.shift[k] =
                std::clamp(to.shift[k] + now * (wide(desc.velocity[k]) - wide(next.velocity[k])), -most_way, most_way);
    if (desc.kind == SourceDesc::grid) {
        // Another number of frames is another loop, and begins at world time 0.
        to.shift[0] = next.frames == desc.frames ? std::fmod(to.shift[0] + (now / was - now / is), next.frames) : 0.0;
        if (to.shift[0] < 0.0) to.shift[0] += next.frames;
    }
    return to;
}

namespace {

// One instant for each octave.
void turbulence_at(const SourceDesc& desc, const SourcePhase& phase, double time, uint64_t world_seed,
                   const Carried& carried, SourceInstant* out) {
    double energy = 0.0, length = 0.0, part = 1.0, cell = 1.0;
    for (uint32_t o = 0; o < desc.octaves; ++o, part *= octave_energy, cell *= 0.5)
        energy += part, length += part * cell;
    cell = wide(desc.size) / (eddy_length * length / energy);
    double strength = wide(desc.speed) / (eddy_rms * std::sqrt(energy));
    double life = duration(desc);
    double axes[9] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
    for (uint32_t o = 0; o < desc.octaves; ++o, cell *= 0.5, strength *= octave_amplitude, life *= octave_energy) {
        double turned[9] = {};
        for (size_t i = 0; i < 9; ++i)
            for (size_t k = 0; k < 3; ++k) turned[i] += lattice_turn[i / 3 * 3 + k] * axes[3 * k + i % 3];
        std::copy(turned, turned + 9, axes);
        SourceInstant s{};
        s.kind = SourceInstant::turbulence;
        s.strength = narrow(strength);
        s.seed = static_cast<uint32_t>(random_bits(world_seed ^ 0x7475726275ull, desc.seed + (uint64_t{o} << 32)));
        s.inverse_spacing[0] = narrow(1.0 / cell);
        double way[3];
        for (size_t k = 0; k < 3; ++k) {
            way[k] = carried.way[k] + time * wide(desc.velocity[k]) + phase.shift[k];
            s.motion[k] = narrow(carried.velocity[k] + wide(desc.velocity[k]));
        }
        for (size_t i = 0; i < 3; ++i) {
            double moved = 0.0;
            for (size_t k = 0; k < 3; ++k) {
                // Perlin's simplex grid: cubes stretched along the diagonal.
                const double diagonal = axes[k] + axes[3 + k] + axes[6 + k];
                const double coordinate = (axes[3 * i + k] + diagonal / 3.0) / cell;
                moved += coordinate * way[k];
                s.lattice[3 * i + k] = narrow(coordinate);
                s.basis[3 * k + i] = narrow(axes[3 * i + k] - diagonal / 6.0);
            }
            // Offset in (0, 1), so that no lattice point lies at the world's origin.
            moved += (static_cast<double>(random_bits(s.seed, i) >> 11) + 0.5) / 9007199254740992.0;
            const double whole = std::floor(moved);
            s.offset[i] = narrow(moved - whole);
            // Cell numbers wrap modulo 2^32, as in the hash.
            const auto cells = static_cast<int64_t>(std::fmod(whole, 4294967296.0));
            s.cell[i] = static_cast<int32_t>(static_cast<uint32_t>(cells));
        }
        const double beats = (time - phase.since) / (slow_beats * life);
        s.turn = narrow(beats - std::floor(beats));
        s.turn_rate = narrow(1.0 / (slow_beats * life));
        out[o] = s;
    }
}
} // namespace

Double3 WindSource::place(double time) const {
    return to_double(vector_of(desc.position)) + (time - phase.since) * to_double(vector_of(desc.velocity));
}

void WindSource::at(double time, uint64_t world_seed, const Carried& carried, SourceInstant* out) const {
    SourceInstant s{};
    s.kind = static_cast<SourceInstant::Kind>(desc.kind);
    const Double3 position = place(time);
    Double3 direction{}, side{};
    normalise(desc.direction, direction);
    if (desc.kind == SourceDesc::line_blower) slot_of(desc, side);
    put(to_float(position), s.position);
    put(to_float(position), s.center);
    put(vector_of(desc.velocity), s.motion);
    put(to_float(direction), s.axis);
    put(to_float(side), s.side);
    s.core = desc.size;
    s.half_length = desc.half_length;
    // Limits are at least a micrometre: their inverse squares must be finite.
    const auto limit = [](float length) {
        const float held = std::max(length, 1e-6f);
        return length > 0.0f ? 1.0f / (held * held) : 0.0f;
    };
    const auto square = [](float v) { return wide(v) * wide(v); };
    const double size = wide(desc.size);
    // Above 1, so that rounding of the test cuts nothing off.
    constexpr double margin = 1.001;
    switch (desc.kind) {
    case SourceDesc::rankine:
    case SourceDesc::lamb_oseen:
        s.strength = narrow(wide(desc.circulation) * 0.15915494309189533577);
        s.inverse_radius_sq = limit(desc.radius);
        s.inverse_length_sq = limit(desc.half_length);
        if (desc.radius > 0.0f && desc.half_length > 0.0f)
            s.reach = narrow(margin * std::sqrt(square(desc.radius) + square(desc.half_length)));
        break;
    case SourceDesc::point_blower:
    case SourceDesc::line_blower: {
        s.strength = desc.speed;
        s.spread = desc.spread;
        s.range = desc.range;
        const double half = 0.5 * wide(desc.range);
        put(to_float(position + half * direction), s.center);
        const double across = 4.0 * (size + 2.0 * half * wide(desc.spread)) + size;
        const double slot = desc.kind == SourceDesc::line_blower ? wide(desc.half_length) : 0.0;
        s.reach = narrow(margin * std::sqrt((half + size) * (half + size) + (across + slot) * (across + slot)));
        break;
    }
    case SourceDesc::grid: {
        double span = 0.0;
        for (uint32_t i = 0; i < 3; ++i) {
            s.inverse_spacing[i] = 1.0f / desc.spacing[i];
            s.count[i] = static_cast<int32_t>(desc.counts[i]);
            const double side_length = wide(desc.spacing[i]) * (desc.counts[i] - 1.0);
            s.center[i] = narrow(position[i] + 0.5 * side_length);
            span += 0.25 * side_length * side_length;
        }
        s.outside = desc.outside;
        if (desc.outside == LR_WIND_OUTSIDE_ZERO) s.reach = narrow(margin * std::sqrt(span) + 1e-3);
        const double frame = time / duration(desc) + phase.shift[0];
        const double whole = std::floor(frame);
        const auto first = static_cast<uint64_t>(std::fmod(whole, static_cast<double>(desc.frames)));
        const uint64_t stride = sample_count(desc) / desc.frames;
        s.frame[0] = grid->values.data() + first * stride;
        s.frame[1] = grid->values.data() + (first + 1) % desc.frames * stride;
        s.part = narrow(frame - whole);
        s.part_rate = narrow(1.0 / duration(desc));
        break;
    }
    case SourceDesc::ground:
        s.inverse_roughness = 1.0f / desc.size;
        s.inverse_log = narrow(1.0 / shape::portable_log(1.0 + wide(desc.reference_height) / size));
        break;
    default:
        return turbulence_at(desc, phase, time, world_seed, carried, out);
    }
    *out = s;
}

Gusts::Gusts(const SourceDesc& desc, uint64_t world_seed) {
    const Double3 given = to_double(vector_of(desc.direction)), d = given / length(given);
    const double rms = wide(desc.speed), spread = wide(desc.spread), period = duration(desc);
    CounterRandom random(world_seed, desc.seed, 0, Draws::gusts);
    const double ratio = shape::portable_pow(highest / lowest, 1.0 / static_cast<double>(modes));
    double angle[modes], energy[modes], total = 0.0, angles = 0.0;
    double edge = lowest;
    for (size_t i = 0; i < modes; ++i, edge *= ratio) {
        const double f = edge * random.between(1.0, ratio);
        // Longitudinal von Karman spectrum over 4 rms^2 period.
        energy[i] = shape::portable_pow(1.0 + 70.8 * f * f, -5.0 / 6.0) * edge * (ratio - 1.0);
        mode_[i].frequency = f / period;
        mode_[i].growth = std::max(f, 1.0 / youth) / period;
        mode_[i].phase = random.uniform();
        double sine, cosine;
        sin_cos_turns(random.uniform(), sine, cosine);
        angle[i] = std::sqrt(-2.0 * shape::portable_log(random.uniform())) * cosine; // Box and Muller
        total += energy[i];
        angles += energy[i] * angle[i] * angle[i];
    }
    const RightAngles sides = right_angles_to(d);
    constexpr double turn = 0.15915494309189533577; // 1/(2 pi)
    for (size_t i = 0; i < modes; ++i) {
        const double amplitude = rms * std::sqrt(2.0 * energy[i] / total);
        double along, across, first, second;
        // With this scale the energy-weighted mean square angle is that of the spread.
        sin_cos_turns(spread * angle[i] / std::sqrt(angles / total) * turn, across, along);
        sin_cos_turns(random.uniform(), first, second);
        const Double3 aside = first * sides.first + second * sides.second;
        mode_[i].amplitude = amplitude * (along * d + across * aside);
    }
}

void Gusts::add(double age, double (&velocity)[3]) const {
    if (!(age > 0.0)) return; // before the gusts began, as for a batch that catches up
    for (const Mode& m : mode_) {
        const double part = std::min(m.growth * age, 1.0), grown = part * part * (3.0 - 2.0 * part);
        double sine, cosine;
        sin_cos_turns(m.frequency * age + m.phase, sine, cosine);
        for (uint32_t k = 0; k < 3; ++k) velocity[k] += grown * cosine * m.amplitude[k];
    }
}
} // namespace lr
