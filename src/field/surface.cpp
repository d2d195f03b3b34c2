#include "field/surface.h"

#include "kernel/float_mode.h"
#include "kernel/limits.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

namespace lr {

static_assert(most_waves == LR_MAX_WAVES);
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
void widen(const float from[3], double to[3]) {
    for (size_t i = 0; i < 3; ++i) to[i] = static_cast<double>(from[i]);
}
bool normalise(double v[3]) {
    const double largest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
    if (!(largest > 0.0)) return false;
    for (size_t i = 0; i < 3; ++i) v[i] /= largest;
    const double length = std::sqrt(dot(v, v));
    for (size_t i = 0; i < 3; ++i) v[i] /= length;
    return true;
}
// Of a wave's direction, the unit vector in the plane; false when there is hardly any.
bool in_plane(const lr_wave& wave, const double up[3], double out[3]) {
    widen(wave.direction, out);
    if (!normalise(out)) return false;
    const double along = dot(out, up);
    for (size_t i = 0; i < 3; ++i) out[i] -= along * up[i];
    return dot(out, out) > 1e-6 && normalise(out);
}

// rad/s, of deep water: omega^2 = g k.
double frequency_of(const lr_wave& wave, const double gravity[3]) {
    return std::sqrt(turn * std::sqrt(dot(gravity, gravity)) / static_cast<double>(wave.length));
}

} // namespace

lr_status check_surface(const lr_surface_desc& d, const char*& why) {
    const auto finite = [](const auto&... values) { return (std::isfinite(values) && ...); };
    const auto finite3 = [&](const float(&v)[3]) { return finite(v[0], v[1], v[2]); };
    if (!finite3(d.position) || !finite3(d.normal) || !finite3(d.current) || !finite(d.density, d.viscosity, d.reach))
        return LR_ERROR_NOT_FINITE;
    for (const lr_wave& w : d.waves)
        if (!finite3(w.direction) || !finite(w.length, w.amplitude, w.phase)) return LR_ERROR_NOT_FINITE;
    why = "a surface's value is out of its range";
    double up[3];
    widen(d.normal, up);
    if (d.wave_count > LR_MAX_WAVES || !normalise(up) || !within(d.position, most_place) ||
        !within(d.current, most_wind) || !in_range(d.density, 0.99e-3, 1e6) || !in_range(d.viscosity, 0.99e-12, 1e3) ||
        !in_range(d.reach, 0.0, 1e6))
        return LR_ERROR_INVALID_ARGUMENT;
    why = "a wave's value is out of its range";
    for (uint32_t i = 0; i < d.wave_count; ++i) {
        const lr_wave& w = d.waves[i];
        const auto length = static_cast<double>(w.length), amplitude = static_cast<double>(w.amplitude);
        double along[3];
        if (!in_range(length, 0.99e-3, 1e6) || !in_range(amplitude, 0.0, length / 7.0) ||
            !in_range(w.phase, -1e6, 1e6) || !in_plane(w, up, along))
            return LR_ERROR_INVALID_ARGUMENT;
    }
    return LR_OK;
}

bool Surface::consistent(const Record& r) {
    if (r.present > 1 || r.reserved != 0) return false;
    const char* why = nullptr;
    if (r.present != 0 && check_surface(r.desc, why) != LR_OK) return false;
    const double strongest[3] = {most_gravity, most_gravity, most_gravity};
    for (uint32_t i = 0; i < LR_MAX_WAVES; ++i) {
        const bool wave = r.present != 0 && i < r.desc.wave_count;
        if (!in_range(r.frequency[i], 0.0, wave ? frequency_of(r.desc.waves[i], strongest) : 0.0)) return false;
    }
    return true;
}

void Surface::set(const lr_surface_desc& desc, const float gravity[3]) {
    const FloatMode mode;
    record_ = Record{};
    record_.present = 1;
    record_.desc = desc;
    double g[3];
    widen(gravity, g);
    for (uint32_t i = 0; i < desc.wave_count; ++i) record_.frequency[i] = frequency_of(desc.waves[i], g);
}

SurfaceInstant Surface::at(double time) const {
    SurfaceInstant out{};
    const lr_surface_desc& d = record_.desc;
    double up[3];
    widen(d.normal, up);
    normalise(up);
    for (size_t k = 0; k < 3; ++k) {
        out.point[k] = d.position[k];
        out.current[k] = d.current[k];
        out.up[k] = static_cast<float>(up[k]);
    }
    out.wave_count = d.wave_count;
    for (uint32_t i = 0; i < d.wave_count; ++i) {
        const lr_wave& from = d.waves[i];
        WaveInstant& to = out.waves[i];
        double along[3];
        in_plane(from, up, along);
        for (size_t k = 0; k < 3; ++k) to.direction[k] = static_cast<float>(along[k]);
        const auto length = static_cast<double>(from.length), amplitude = static_cast<double>(from.amplitude);
        const double frequency = record_.frequency[i];
        const double turns = (static_cast<double>(from.phase) - frequency * time) / turn;
        to.turns_per_m = static_cast<float>(1.0 / length);
        to.number = static_cast<float>(turn / length);
        to.turn = static_cast<float>(turns - std::floor(turns));
        to.amplitude = from.amplitude;
        to.speed = static_cast<float>(amplitude * frequency);
        to.rate = static_cast<float>(amplitude * frequency * frequency);
    }
    return out;
}

float Surface::highest() const {
    float sum = callback_ ? record_.desc.reach : 0.0f;
    for (uint32_t i = 0; i < record_.desc.wave_count; ++i) sum += record_.desc.waves[i].amplitude;
    return sum;
}

uint64_t Surface::hash() const {
    if (!present()) return 0;
    uint64_t sum = 0x9e3779b97f4a7c15ull;
    unsigned char bytes[sizeof record_];
    std::memcpy(bytes, &record_, sizeof bytes);
    for (size_t i = 0; i < sizeof bytes; i += 8) {
        uint64_t word;
        std::memcpy(&word, bytes + i, 8);
        sum = (sum ^ word) * 0xbf58476d1ce4e5b9ull;
        sum ^= sum >> 29;
    }
    return sum | 1u;
}

void Surface::set_callback(lr_surface_fn function, void* user) {
    callback_ = function;
    callback_user_ = user;
    told_ = false;
    blamed_.store(false, std::memory_order_relaxed);
}

bool Surface::take_blame() {
    if (told_ || !blamed_.exchange(false, std::memory_order_relaxed)) return false;
    told_ = true;
    return true;
}

void Surface::ask(double time, lr_batch batch, uint32_t count, const SurfaceInstant& plane, SurfaceBlock& block) {
    lr_surface_query query{};
    query.struct_size = sizeof query;
    query.count = count;
    query.batch = batch;
    query.time = time;
    query.height = block.height;
    for (size_t k = 0; k < 3; ++k) {
        query.position[k] = block.position[k];
        query.normal[k] = block.normal[k];
        query.velocity[k] = block.velocity[k];
        query.rate[k] = block.rate[k];
    }
    {
        const FloatMode mode; // the callback's own does not outlive it
        callback_(callback_user_, &query);
    }
    const float reach = highest();
    for (uint32_t i = 0; i < count; ++i) {
        bool sound = std::abs(block.height[i]) <= reach; // false for NaN
        float square = 0.0f, along = 0.0f;
        for (size_t k = 0; k < 3; ++k) {
            sound = sound && std::abs(block.velocity[k][i]) <= 1000.0f && std::abs(block.rate[k][i]) <= 1e6f &&
                    std::abs(block.normal[k][i]) <= 2.0f;
            square += block.normal[k][i] * block.normal[k][i];
            along += block.normal[k][i] * plane.up[k];
        }
        const float length = std::sqrt(square);
        if (sound && length >= 0.5f && length <= 2.0f && along >= 0.17f * length) {
            for (float(&row)[field_block] : block.normal) row[i] /= length;
            continue;
        }
        blamed_.store(true, std::memory_order_relaxed);
        block.height[i] = 0.0f;
        for (size_t k = 0; k < 3; ++k) {
            block.normal[k][i] = plane.up[k];
            block.velocity[k][i] = plane.current[k];
            block.rate[k][i] = 0.0f;
        }
    }
}

} // namespace lr
