#include "environment/water.h"

#include "base/pose.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

namespace lr {

namespace {

constexpr double turn = 2.0 * std::numbers::pi;

bool normalise(Double3& v) {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(largest > 0.0)) return false;
    v = v / largest;
    v = v / length(v);
    return true;
}
// Unit vector along a wave's direction in the plane; false if the direction is nearly normal to the plane.
bool in_plane(const lr_wave& wave, Double3 up, Double3& out) {
    out = to_double(vector_of(wave.direction));
    if (!normalise(out)) return false;
    out = out - dot(out, up) * up;
    return dot(out, out) > 1e-6 && normalise(out);
}

// rad/s. Dispersion in deep water: omega^2 = g k.
double frequency_of(const lr_wave& wave, Double3 gravity) {
    return std::sqrt(turn * length(gravity) / wide(wave.length));
}
} // namespace

Outcome check_water(const lr_water_desc& d) {
    if (!finite(d.position, d.normal, d.current, d.density, d.viscosity, d.reach)) return LR_ERROR_NOT_FINITE;
    for (const lr_wave& w : d.waves)
        if (!finite(w.direction, w.length, w.amplitude, w.phase)) return LR_ERROR_NOT_FINITE;
    Double3 up = to_double(vector_of(d.normal));
    if (d.wave_count > LR_MAX_WAVES || !normalise(up) || !within(d.position, most_place) ||
        !within(d.current, most_wind) || !in_range(d.density, 0.99e-3, 1e6) || !in_range(d.viscosity, 0.99e-12, 1e3) ||
        !in_range(d.reach, 0.0, 1e6))
        return invalid("a value of the water is out of range");
    for (uint32_t i = 0; i < d.wave_count; ++i) {
        const lr_wave& w = d.waves[i];
        const double size = wide(w.length), amplitude = wide(w.amplitude);
        Double3 along{};
        if (!in_range(size, 0.99e-3, 1e6) || !in_range(amplitude, 0.0, size / 7.0) || !in_range(w.phase, -1e6, 1e6) ||
            !in_plane(w, up, along))
            return invalid("a value of a wave is out of range");
    }
    return {};
}

bool Water::consistent(const Record& r) {
    if (r.present > 1 || r.reserved != 0) return false;
    if (r.present != 0 && check_water(r.desc).refused()) return false;
    const Double3 strongest{most_gravity, most_gravity, most_gravity};
    for (uint32_t i = 0; i < LR_MAX_WAVES; ++i) {
        const bool wave = r.present != 0 && i < r.desc.wave_count;
        if (!in_range(r.frequency[i], 0.0, wave ? frequency_of(r.desc.waves[i], strongest) : 0.0)) return false;
    }
    const double farthest = r.present != 0 ? most_way : 0.0;
    for (const double way : r.drift)
        if (!in_range(way, -farthest, farthest)) return false;
    return true;
}

void Water::set(const lr_water_desc& desc, const float gravity[3], double time) {
    const FloatMode mode;
    const Record before = record_;
    record_ = Record{};
    record_.present = 1;
    record_.desc = desc;
    for (uint32_t k = 0; k < 3 && before.present != 0; ++k)
        record_.drift[k] = before.drift[k] + (wide(before.desc.current[k]) - wide(desc.current[k])) * time;
    std::fill(record_.desc.waves + desc.wave_count, record_.desc.waves + LR_MAX_WAVES, lr_wave{}); // part of the hash
    for (uint32_t i = 0; i < desc.wave_count; ++i)
        record_.frequency[i] = frequency_of(desc.waves[i], to_double(vector_of(gravity)));
}

SurfaceInstant Water::at(double time) const {
    SurfaceInstant out{};
    const lr_water_desc& d = record_.desc;
    Double3 up = to_double(vector_of(d.normal));
    normalise(up);
    const Double3 drift{record_.drift[0], record_.drift[1], record_.drift[2]};
    put(vector_of(d.position), out.point);
    put(vector_of(d.current), out.current);
    put(to_float(up), out.up);
    out.wave_count = d.wave_count;
    for (uint32_t i = 0; i < d.wave_count; ++i) {
        const lr_wave& from = d.waves[i];
        WaveInstant& to = out.waves[i];
        Double3 along{};
        in_plane(from, up, along);
        put(to_float(along), to.direction);
        const double size = wide(from.length), amplitude = wide(from.amplitude);
        const double frequency = record_.frequency[i];
        const double carried = dot(along, time * to_double(vector_of(d.current)) + drift) * turn / size;
        const double turns = (wide(from.phase) - frequency * time - carried) / turn;
        to.turns_per_m = static_cast<float>(1.0 / size);
        to.number = static_cast<float>(turn / size);
        to.turn = static_cast<float>(turns - std::floor(turns));
        to.amplitude = from.amplitude;
        to.speed = static_cast<float>(amplitude * frequency);
        to.rate = static_cast<float>(amplitude * frequency * frequency);
    }
    return out;
}

namespace {

float highest_of(const lr_water_desc& desc, bool called_back) {
    float sum = called_back ? desc.reach : 0.0f;
    for (uint32_t i = 0; i < desc.wave_count; ++i) sum += desc.waves[i].amplitude;
    return sum;
}

enum class Depth { dry, touches, under };

Depth depth_of(const Water::Record& water, bool called_back, const Box& box) {
    if (water.present == 0) return Depth::dry;
    const Double3 low = to_double(box.low), high = to_double(box.high), half = 0.5 * (high - low);
    Double3 up = to_double(vector_of(water.desc.normal));
    normalise(up);
    const double height = dot(0.5 * (low + high) - to_double(vector_of(water.desc.position)), up);
    const double extent = std::abs(up.x) * half.x + std::abs(up.y) * half.y + std::abs(up.z) * half.z;
    const double reach = wide(highest_of(water.desc, called_back));
    return height - extent > reach ? Depth::dry : height + extent < -reach ? Depth::under : Depth::touches;
}
} // namespace

float Water::highest() const {
    return highest_of(record_.desc, callback() != nullptr);
}

bool Water::changes(const Record& before, const Box& box) const {
    const bool called_back = callback() != nullptr;
    const Depth was = depth_of(before, called_back, box), is = depth_of(record_, called_back, box);
    if (was != is || is == Depth::touches) return true;
    const lr_water_desc &a = before.desc, &b = record_.desc;
    return is == Depth::under &&
           (a.density != b.density || a.viscosity != b.viscosity || !std::equal(a.current, a.current + 3, b.current));
}

uint64_t Water::hash() const {
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

void Water::ask(double time, lr_batch batch, uint32_t count, const SurfaceInstant& plane, SurfaceBlock& block) {
    lr_water_query query{};
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
    ask_callback(query);
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
        blame_callback();
        block.height[i] = 0.0f;
        for (size_t k = 0; k < 3; ++k) {
            block.normal[k][i] = plane.up[k];
            block.velocity[k][i] = plane.current[k];
            block.rate[k][i] = 0.0f;
        }
    }
}
} // namespace lr
