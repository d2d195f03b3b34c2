// The expected state of the library's worlds after the calls so far.
#pragma once

#include "fuzz/api/memory.h"
#include "support/handles.h"

#include <algorithm>
#include <functional>
#include <variant>

namespace fuzz {

struct Batch {
    lr_batch id{};
    lr_batch_desc desc{};
    std::vector<lr_body> bodies;
    bool emitter = false, rules = false, respawns = false;
};
struct Collider {
    lr_collider id{};
    lr_collider_desc desc{};
};
using AnyWind = std::variant<lr_gusts_desc, lr_vortex_desc, lr_blower_desc, lr_turbulence_desc, lr_wind_grid_desc,
                             lr_ground_wind_desc>;
struct Wind {
    lr_wind_source id{};
    AnyWind desc{};
};

// The creation history of a world's batches: worlds with equal histories accept each other's snapshots.
struct Past {
    lr_batch_desc created{}; // without an asset: a batch was destroyed
    lr_batch destroyed{};
    bool operator==(const Past& o) const {
        return created.asset == o.created.asset && created.capacity == o.created.capacity && destroyed == o.destroyed &&
               created.load_model == o.created.load_model && created.integrator == o.created.integrator &&
               created.clock == o.created.clock && created.table_end == o.created.table_end &&
               created.damping_gain == o.created.damping_gain && created.noise_gain == o.created.noise_gain;
    }
};

// The part of the model that a snapshot restores.
struct State {
    std::vector<Batch> batches;
    std::vector<Collider> colliders;
    std::vector<Wind> winds;
    uint64_t substeps = 0;
    double time = 0.0;
    bool wild = false;  // arguments beyond physics were given: results need not be plausible
    bool loose = false; // a damaged snapshot was accepted: the state is unknown
};

// Behaviour of a recording's `write`: it refuses after `left` calls; 0: never.
struct Writer {
    uint32_t left = 0;
    bool refused = false;
    uint64_t sum = 0;
};

struct World {
    lr_world* at = nullptr;
    std::unique_ptr<Memory> memory = std::make_unique<Memory>();
    lr_world_desc desc{};
    State state;
    std::vector<Past> past;
    std::vector<lr_body> stale_bodies;
    std::vector<lr_collider> stale_colliders;
    std::vector<lr_batch> stale_batches;
    std::vector<lr_wind_source> stale_winds;
    uint32_t wind_callback = 0, surface_callback = 0; // 0: none
    uint32_t event_capacity = 0;
    std::unique_ptr<Writer> writer = std::make_unique<Writer>();
    bool recording = false; // unless the writer has refused

    const Batch* find(lr_batch id) const {
        for (const Batch& b : state.batches)
            if (b.id == id) return &b;
        return nullptr;
    }
    Batch* find(lr_batch id) { return const_cast<Batch*>(static_cast<const World*>(this)->find(id)); }
    Batch* owner(lr_body id) {
        for (Batch& b : state.batches)
            if (std::find(b.bodies.begin(), b.bodies.end(), id) != b.bodies.end()) return &b;
        return nullptr;
    }
    Collider* collider(lr_collider id) {
        for (Collider& c : state.colliders)
            if (c.id == id) return &c;
        return nullptr;
    }
};

struct Saved {
    std::vector<unsigned char> bytes;
    State state;
    std::vector<Past> past;
    uint64_t hash = 0;
};

class Fuzzer {
public:
    explicit Fuzzer(Input input) : in(input) {}
    ~Fuzzer();
    Fuzzer(const Fuzzer&) = delete;
    Fuzzer& operator=(const Fuzzer&) = delete;

    World& world() { return worlds[in.selector() % 8 == 7 ? 2 : in.selector() % 8 >= 5 ? 1 : 0]; }
    // A handle: mostly an existing one, else a stale or invented one.
    template <class Id, class List> Id pick(const List& live, const std::vector<Id>& stale, uint8_t byte) const {
        if (byte < 208 && !live.empty()) return id_of(live[byte % live.size()]);
        if (byte < 232 && !stale.empty()) return stale[byte % stale.size()];
        using Number = decltype(Id::id);
        const Number one = 1, some = live.empty() ? one : id_of(live[0]).id;
        const Number made_up[] = {
            0, 1, ~Number{0}, some ^ one << 14, some + 1, 0x7fff, some ^ one << (sizeof(Id) * 8 - 1), one << 26};
        return {made_up[byte % 8]};
    }
    lr_batch pick_batch(World& w, uint8_t byte) const { return pick(w.state.batches, w.stale_batches, byte); }
    lr_body pick_body(World& w, uint8_t byte) const;
    lr_collider pick_collider(World& w, uint8_t byte) const { return pick(w.state.colliders, w.stale_colliders, byte); }
    lr_wind_source pick_wind(World& w, uint8_t byte) const { return pick(w.state.winds, w.stale_winds, byte); }
    lr_asset* pick_asset() { return assets[in.selector() / 8u % assets.size()]; }

    Input in;
    World worlds[3];
    std::vector<lr_asset*> assets; // the model holds a reference to each
    std::vector<Saved> saved;
    uint32_t substeps_left = 48;
    uint32_t assets_left = 2; // still to create: an ellipsoid's surface takes longer than a step

private:
    static lr_batch id_of(const Batch& b) { return b.id; }
    static lr_collider id_of(const Collider& c) { return c.id; }
    static lr_wind_source id_of(const Wind& w) { return w.id; }
    static lr_body id_of(lr_body b) { return b; }
};

// Around each call on a world: its expected results, and that a refused call changes nothing.
class Call {
public:
    Call(Fuzzer& fuzzer, World& world, const char* function, Expected& expected);
    // True when the call succeeded.
    bool ended(lr_status status);
    // The world argument, or null if the record says so.
    lr_world* world() const { return null_ ? nullptr : world_.at; }

private:
    Fuzzer& fuzzer_;
    World& world_;
    const char* function_;
    Expected& expected_;
    bool null_, compared_ = false;
    uint64_t hash_ = 0;
    lr_world_info info_{};
};

uint64_t hash_of(const World& w);
lr_world_info info_of(const World& w);
lr_batch_view view_of(const World& w, lr_batch batch);
// Compares the observable state of a world with its model.
void check_world(World& w);
void remember(std::vector<lr_body>& stale, lr_body id);

// Which of these a record's first byte selects.
using Operation = void (*)(Fuzzer&);
struct Named {
    const char* name;
    Operation run;
};
std::vector<Named> asset_operations();
std::vector<Named> world_operations();
std::vector<Named> wind_operations();
std::vector<Named> batch_operations();
std::vector<Named> load_operations();
std::vector<Named> body_operations();
std::vector<Named> force_operations();
std::vector<Named> collider_operations();
std::vector<Named> query_operations();
std::vector<Named> lifecycle_operations();
std::vector<Named> step_operations();
std::vector<Named> snapshot_operations();
std::vector<Named> recording_operations();

// One of the plain getters and setters of the header.
void call_plain(Fuzzer& f);
// Whether it had all the memory that it requested.
bool step_world(Fuzzer& f, World& w, float dt, uint32_t substeps);
// A first world with a batch and bodies, so that a few bytes suffice.
void begin_scene(Fuzzer& f);
const std::vector<lr_asset*>& common_assets();
const std::vector<unsigned char>& asset_bytes();
void set_callbacks(World& w, lr_world* at);

// The calls of each kind of wind source, by the type of its desc.
#define LR_SOURCE(name)                                                                                                \
    inline lr_status add_wind(lr_world* w, const lr_##name##_desc* d, lr_wind_source* out) {                           \
        return LR_CALL(lr_world_add_##name)(w, d, out);                                                                \
    }                                                                                                                  \
    inline lr_status update_wind(lr_world* w, lr_wind_source source, const lr_##name##_desc* d) {                      \
        return LR_CALL(lr_world_update_##name)(w, source, d);                                                          \
    }                                                                                                                  \
    inline lr_status get_wind(const lr_world* w, lr_wind_source source, lr_##name##_desc* d) {                         \
        return LR_CALL(lr_world_get_##name)(w, source, d);                                                             \
    }
LR_SOURCE(gusts)
LR_SOURCE(vortex)
LR_SOURCE(blower)
LR_SOURCE(turbulence)
LR_SOURCE(wind_grid)
LR_SOURCE(ground_wind)
#undef LR_SOURCE

lr_job_system hostile_jobs(uint32_t kind);

} // namespace fuzz
