// The format of a recording: what recorder and player agree on. docs/reference/snapshots.md
#pragma once

#include "langevin_rigid_research.h"

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace lr::recording {

// Little-endian throughout, as all that the library runs on.
struct FileHeader {
    char magic[8];
    uint32_t format;
    uint32_t library; // lr_version()
};
inline constexpr char magic[8] = {'L', 'R', 'R', 'E', 'C', 'O', 'R', 'D'};
inline constexpr uint32_t format_version = 1;

// Then frames. A record is one of them, or several of which all but the last say that there is more.
struct FrameHeader {
    uint32_t size; // bytes that follow
    uint16_t kind;
    uint16_t flags;
    uint64_t checksum; // of these, of the frame's number, and of what follows
};
inline constexpr uint16_t frame_continues = 1;
inline constexpr uint32_t most_frame = 65536; // with its header

enum class Kind : uint16_t {
    world = 1, // WorldRecord, first
    asset,     // AssetRecord, then the bytes of an asset file
    blob,      // its hash, then bytes that calls name by it
    hole,      // a slot without a batch, between those that setups make
    setup,     // a call that makes what there was, without result
    begun,     // the world's hash: here the recording begins
    call,      // Op, then arguments; before it is carried out
    result,    // ResultRecord, of the call before
    wind,      // answers of the wind callback within a call
    surface,   // of the surface callback
    geometry,  // the hash that the hull, heightfield or mesh of the setup before is known by
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
    uint64_t output; // a handle or number that came out, or the hash of several; 0 where nothing was asked for
    uint64_t hash;   // of the world, where `hashed`
};
// Before `count` positions (x of all, then y, z) and a float of each for every bit of `given`.
struct AnswerRecord {
    uint32_t count;
    uint32_t batch;
    double time;
    uint32_t given;
    uint32_t reserved;
};
inline constexpr uint32_t wind_values = 15;    // velocity, rate, gradient
inline constexpr uint32_t surface_values = 10; // height, normal, velocity, rate

// A call is known by a hash of its function's name. lr_replay does not compile where two functions of the header have the same.
using Op = uint16_t;
constexpr Op op_of(const char* function) {
    uint32_t hash = 2166136261u;
    for (; *function != '\0'; ++function) hash = (hash ^ static_cast<unsigned char>(*function)) * 16777619u;
    return static_cast<Op>((hash >> 16 ^ hash) & 0xffffu);
}

// Behind the op: whether arguments follow. Those of a call that could not be read are not there.
inline constexpr uint16_t call_cut = 1;

// Of an array: not given, here, or in a blob.
enum class Where : uint32_t { null, here, blob };
inline constexpr uint64_t most_here = 256; // bytes

// Bytes of structs that are recorded: all but pointers, which come last or are written by themselves.
template <class T> inline constexpr uint32_t recorded_bytes = sizeof(T);
template <> inline constexpr uint32_t recorded_bytes<lr_wind_grid_desc> = offsetof(lr_wind_grid_desc, samples);
template <> inline constexpr uint32_t recorded_bytes<lr_collider_desc> = offsetof(lr_collider_desc, vertices);
template <> inline constexpr uint32_t recorded_bytes<lr_force_arrays> = offsetof(lr_force_arrays, force);

struct BatchRecord { // lr_batch_desc without what is not the same on every machine
    uint32_t asset;
    uint32_t capacity;
    int32_t load_model, clock, table_end, integrator;
    float damping_gain, noise_gain;
};
struct TableRecord { // lr_turbulence_table likewise
    uint32_t count;
    float dt, u0, l, c0;
    uint32_t stationary, reserved;
};

// Each step is a bijection of the state.
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

inline uint64_t frame_checksum(const FrameHeader& h, uint64_t number, const void* payload) {
    Hash hash(number);
    hash.add(h.size | uint64_t{h.kind} << 32 | uint64_t{h.flags} << 48);
    hash.add(payload, h.size);
    return hash.value();
}

} // namespace lr::recording
