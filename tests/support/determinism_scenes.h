// Scenes with all features of a world, for tests of determinism and for the stored hashes.
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
    bool stations = false; // the bodies of the second batch have stations
    bool windy = false;
    bool born_and_dying = false;
    bool forced = false;              // on bodies and on batches
    bool afloat = false;              // a sea with its surface between the bodies
    bool governed = false;            // rules that destroy in one batch and respawn in the other, and emitters
    std::vector<Source> sources = {}; // of wind
    bool called_back = false;         // wind from a callback, and over a sea its surface too
    uint32_t divisors[2] = {1, 1};    // of the batches' rates
    bool resting = false;             // bodies fall asleep and wake
    Solids solids = Solids::none;     // to land on; bodies begin near them, those of the second batch are bricks
    bool body_contact = false;        // contact between all bodies, which start close together above the colliders
    uint64_t budget = 0;              // body-substeps per step
    bool faulty = false;              // some bodies diverge: held in one batch, ended in the other
    float dt = 1.0f / 60.0f;          // s
    uint32_t substeps = 3;            // no power of two and no even division, so that everything rounds
    int frames = 30;                  // steps of dt
    uint32_t bodies = 150;            // in each of two batches: one diagonal, one with its weight off centre
};

std::vector<PlayedScene> played_scenes();

// Variations that must not change the result.
struct Circumstances {
    int32_t simd = LR_SIMD_AUTO;
    uint32_t workers = 0;
    bool permuted = false;         // another order of bodies
    bool through_snapshot = false; // half-way, into a new world
    lr_job_system jobs{};
    const lr_recording_desc* recording = nullptr;
    int record_at = -1;  // first recorded frame; -1: from the start
    uint32_t checks = 0; // LR_CHECK_*: a reported misuse fails the test
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
    // The same body for the same noise seed, in any place and at any time.
    lr_body_desc body(uint32_t noise_seed) const;
    void populate(size_t b);
    // Not repeated after a snapshot, which must restore its effect.
    void push_batch(size_t b);
    void govern(size_t b);
    // Forces depend on a body's noise seed and place, not on its index.
    void push();
    // Extreme values, by noise seed.
    void carry_off(uint32_t frame);
    // Ends bodies and creates new ones, by noise seed and not by index.
    void turn_over();
    // Sleep, by noise seed; for a while a whole batch sleeps.
    void lie_and_wake(uint32_t frame);

    PlayedScene scene_;
    Circumstances how_;
    PlayedColliders colliders_;
    Asset assets_[2];
    uint32_t next_key_[2] = {};
};

uint64_t outcome(const PlayedScene& scene, const Circumstances& how = {});

} // namespace test
