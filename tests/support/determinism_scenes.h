// Scenes with everything that a world can do, written once, for tests of determinism and for the held hashes.
#pragma once

#include "support/determinism_colliders.h"
#include "support/wind.h"

#include <cstdint>
#include <vector>

namespace test {

struct PlayedScene {
    const char* name;
    int32_t loads = LR_LOADS_LANGEVIN;
    int32_t clock = LR_CLOCK_SPEED;
    int32_t table_end = LR_TABLE_CLAMP;
    int32_t integrator = LR_INTEGRATOR_DEFAULT;
    bool full = false;
    bool windy = false;
    bool born_and_dying = false;
    bool forced = false;              // forces on bodies and on batches
    bool afloat = false;              // a sea, its surface amid the bodies
    bool governed = false;            // rules that destroy in one batch and respawn in the other, and emitters
    std::vector<Source> sources = {}; // of wind
    bool called_back = false;         // wind from a callback, and of a sea its surface
    uint32_t divisors[2] = {1, 1};    // of the batches' rates
    bool resting = false;             // bodies come to rest and wake
    Solids solids = Solids::none;     // to land on: bodies begin near them, the second batch's are bricks
    bool meeting = false;             // all bodies meet each other, close together over what they land on
    uint64_t budget = 0;              // body-substeps a step
    bool faulty = false;              // some bodies are carried out of physics: held in one batch, ended in the other
    float dt = 1.0f / 60.0f;          // s
    uint32_t substeps = 3;            // neither a power of two nor an even division: every rounding is there
    int frames = 30;                  // steps of dt
    uint32_t bodies = 150;            // in each of two batches: one diagonal, one with its weight off centre
};

std::vector<PlayedScene> played_scenes();

// What must not change the outcome.
struct Circumstances {
    int32_t simd = LR_SIMD_AUTO;
    uint32_t workers = 0;
    bool permuted = false;         // bodies lie in another order
    bool through_snapshot = false; // half-way into a new world
    lr_job_system jobs{};
    const lr_recording_desc* recording = nullptr;
    int record_at = -1;  // the frame before which that begins; -1: before anything is made
    uint32_t checks = 0; // LR_CHECK_*: what is said of misuse fails the play
};

class Play {
public:
    Play(const PlayedScene& scene, const Circumstances& how);
    uint64_t run();

    World world;
    lr_batch batches[2] = {};

private:
    void build();
    void add_source(Source kind);
    // u = (z sin t, x, 0) without the sine.
    static void shear(void*, const lr_wind_query* q);
    static void swell(void*, const lr_water_query* q);
    bool all_finite() const;
    void check_faults() const;
    // The same body for the same noise seed, wherever and whenever it is made.
    lr_body_desc body(uint32_t noise_seed) const;
    void populate(size_t b);
    // Not made anew with the world after a snapshot: that must bring them back.
    void push_batch(size_t b);
    void govern(size_t b);
    // What pushes a body depends on its noise seed and place, not on its index.
    void push();
    // By noise seed: beyond all measure.
    void carry_off(uint32_t frame);
    // Bodies with certain noise seeds die, new ones are spawned: by noise seed, not by place.
    void turn_over();
    // By noise seed; for a while one batch rests as a whole.
    void lie_and_wake(uint32_t frame);

    PlayedScene scene_;
    Circumstances how_;
    PlayedColliders colliders_;
    Asset assets_[2];
    uint32_t next_key_[2] = {};
};

uint64_t outcome(const PlayedScene& scene, const Circumstances& how = {});

} // namespace test
