// The format of a recording, shared by recorder and player: docs/reference/snapshots.md
#pragma once

#include "langevin_rigid_research.h"

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace lr::recording {

// Little-endian, like all supported processors.
struct FileHeader {
    char magic[8];
    uint32_t format;
    uint32_t library; // lr_version()
};
inline constexpr char magic[8] = {'L', 'R', 'R', 'E', 'C', 'O', 'R', 'D'};
inline constexpr uint32_t format_version = 3;

// Frames follow. A record is one frame or several; all but its last have frame_continues.
struct FrameHeader {
    uint32_t size; // bytes of payload
    uint16_t kind;
    uint16_t flags;
    uint64_t checksum; // of the fields above, the frame's number and the payload
};
inline constexpr uint16_t frame_continues = 1;
inline constexpr uint32_t most_frame = 65536; // bytes, with its header

enum class Kind : uint16_t {
    world = 1, // WorldRecord, first
    asset,     // AssetRecord, then the bytes of an asset file
    blob,      // a hash, then bytes that calls refer to by this hash
    hole,      // an empty batch slot, between the batches of setup records
    setup,     // a call that recreates the initial state, without result
    begun,     // the world's hash when the setup ends and the recording begins
    call,      // Op, then arguments; written before the call runs
    result,    // ResultRecord of the call before
    wind,      // answers of the wind callback during a call
    surface,   // answers of the water callback
    geometry,  // the hash of the hull, heightfield or mesh of the setup record before
};

struct WorldRecord {
    uint64_t seed;
    uint64_t step_count;
    float gravity[3]; // m/s^2
    float fluid_density, fluid_viscosity;
    int32_t simd;
    uint32_t workers;
    uint32_t flags; // LR_RECORD_*
    uint32_t hash_interval;
    uint32_t reserved;
};
struct AssetRecord {
    uint32_t id; // counted from 0
    uint32_t format;
    uint64_t content_hash;
    double extents[3]; // m
};
struct ResultRecord {
    uint16_t op;
    uint16_t hashed;
    int32_t status;
    uint64_t output; // the resulting handle or number, or a hash of several; 0 if the caller passed null
    uint64_t hash;   // of the world, if `hashed`
};
// Followed by the rows that an answer is found by, `count` words each: x of all positions, y, z, and for water a hash of
// the values that the callback was given; then `count` floats for each bit set in `given`.
struct AnswerRecord {
    uint32_t count;
    uint32_t batch;
    double time;
    uint32_t given;
    uint32_t reserved;
};
inline constexpr uint32_t wind_values = 15;    // velocity, rate, gradient
inline constexpr uint32_t surface_values = 10; // height, normal, velocity, rate
inline constexpr uint32_t wind_key_rows = 3, surface_key_rows = 4;

// A call is identified by a hash of its function's name. If two functions had the same hash, lr_replay would not compile.
using Op = uint16_t;
constexpr Op op_of(const char* function) {
    uint32_t hash = 2166136261u;
    for (; *function != '\0'; ++function) hash = (hash ^ static_cast<unsigned char>(*function)) * 16777619u;
    return static_cast<Op>((hash >> 16 ^ hash) & 0xffffu);
}

// Flag after the op: no arguments follow, because the call was refused before it read them.
inline constexpr uint16_t call_cut = 1;

// Where the bytes of an array are: it is null, they follow here, or they are in a blob.
enum class Where : uint32_t { null, here, blob };
inline constexpr uint64_t most_here = 256; // bytes

// Recorded bytes of a struct: all before its pointers, which come last. The arrays are recorded separately.
template <class T> inline constexpr uint32_t recorded_bytes = sizeof(T);
template <> inline constexpr uint32_t recorded_bytes<lr_wind_grid_desc> = offsetof(lr_wind_grid_desc, samples);
template <> inline constexpr uint32_t recorded_bytes<lr_collider_desc> = offsetof(lr_collider_desc, vertices);
template <> inline constexpr uint32_t recorded_bytes<lr_force_arrays> = offsetof(lr_force_arrays, force);

struct BatchRecord { // lr_batch_desc without pointers and padding, whose bytes differ between machines
    uint32_t asset;
    uint32_t capacity;
    int32_t load_model, clock, table_end, integrator;
    float damping_gain, noise_gain, variation;
};
struct TableRecord { // the same for lr_turbulence_table
    uint32_t count;
    float dt, u0, l, c0;
    uint32_t stationary, reserved;
};

// Each add() is a bijection of the state.
class Hash {
public:
    explicit Hash(uint64_t start) : state_(start ^ 0x9e3779b97f4a7c15ull) {}
    void add(uint64_t word) {
        state_ = (state_ ^ word) * 0xbf58476d1ce4e5b9ull;
        state_ ^= state_ >> 32;
    }
    void add(const void* bytes, uint64_t size) {
        const auto* at = static_cast<const unsigned char*>(bytes);
        uint64_t word = 0;
        for (; size >= 8; size -= 8, at += 8) {
            std::memcpy(&word, at, 8);
            add(word);
        }
        word = size;
        if (size != 0) std::memcpy(&word, at, static_cast<size_t>(size));
        add(word ^ size << 56);
    }
    uint64_t value() const { return state_ != 0 ? state_ : 1; }

private:
    uint64_t state_;
};

// Of the values that a water callback is given for body i. A body that contact turns about its centre is asked for twice
// at the same time and position, and its pose decides how much of each wave it is given.
inline uint32_t given_surface(const lr_water_query& q, uint32_t i) {
    const float given[] = {q.height[i],      q.normal[0][i],   q.normal[1][i], q.normal[2][i], q.velocity[0][i],
                           q.velocity[1][i], q.velocity[2][i], q.rate[0][i],   q.rate[1][i],   q.rate[2][i]};
    Hash hash(0);
    hash.add(given, sizeof given);
    return static_cast<uint32_t>(hash.value());
}

inline uint64_t frame_checksum(const FrameHeader& h, uint64_t number, const void* payload) {
    Hash hash(number);
    hash.add(h.size | uint64_t{h.kind} << 32 | uint64_t{h.flags} << 48);
    hash.add(payload, h.size);
    return hash.value();
}
} // namespace lr::recording
