// Sleeping bodies of a batch: since when and where they sleep. docs/reference/bodies.md
#pragma once

#include "base/allocator.h"
#include "collision/body_narrow_phase.h"
#include "collision/sleeping_grid.h"

#include <cstdint>

namespace lr {

// Whether a body that withstood the wind `held` (m/s) withstands `wind` too: about the same direction, and not over 1.1 times as strong.
bool withstands(Vector held, Vector wind);

// By dense index or slot; the batch knows which bodies sleep.
class SleepingBodies {
public:
    // Rules check sleeping bodies once in this many steps.
    static constexpr uint32_t rule_steps = 16;

    // phase: spreads the batches' checks over steps. births: s on `clock`, by dense index.
    bool allocate(Allocator& allocator, uint32_t capacity, double reach, uint32_t phase, double* births);

    // Called before the first body falls asleep.
    void begin();
    // A body falls asleep; its birth and box must be set.
    void enter(uint32_t index, uint32_t slot, Vector position, float scale);
    void leave(uint32_t slot) {
        grid.remove(slot);
        forget_box(slot);
    }
    // The contact box is set when the body falls asleep and forgotten when it leaves.
    const Box& box(uint32_t slot) const { return boxes_[slot]; }
    bool has_box(uint32_t slot) const { return boxes_[slot].low.x == boxes_[slot].low.x; }
    void set_box(uint32_t slot, const Box& box) { boxes_[slot] = box; }
    void forget_box(uint32_t slot);
    double birth_of(float age, float age_remainder) const { return state_.clock - (wide(age) - wide(age_remainder)); }
    // age_remainder: rounding error of the age, carried as in the kernel.
    void age_of(uint32_t index, float& age, float& age_remainder) const;

    // Advances the clock. steps: of the world. Returns whether rules are due.
    bool pass(double seconds, uint32_t steps);
    // Whether the rules' answer can have changed for any sleeping body.
    bool in_question(float max_age) const;
    // For uniform wind. True if all bodies have withstood a similar one since the last fell asleep; else the next turn is due.
    bool withstood(const float (&wind)[3]);
    // A body has to take a trial again. Any thread.
    void try_wind_again() { __atomic_store_n(&state_.tried, 0u, __ATOMIC_RELAXED); }
    // Whether some body may have withstood a wind only in shelter; never false if one has. Any thread may set it.
    bool any_sheltered() const { return sheltered_ != 0; }
    void note_sheltered() { __atomic_store_n(&sheltered_, uint8_t{1}, __ATOMIC_RELAXED); }
    // Rules have checked all sleeping bodies, which are [begin, end).
    void answered(uint32_t begin, uint32_t end, float max_age);
    void ask_again() { state_.unjudged = 1; }

    SleepingGrid grid;

    // Saved in snapshots, with births.
    struct State {
        double clock;      // s of the batch's time since the first fell asleep
        uint32_t steps;    // since rules were last checked
        uint32_t unjudged; // 1: the present rules have not checked some
        uint32_t tried;    // turns in which all withstood `wind`, up to rule_steps
        float wind[3];     // m/s
    };
    const State& state() const { return state_; }
    static bool consistent(const State& state);
    static bool consistent(const State& state, double birth);
    // No body sleeps any more; boxes stay.
    void clear() { begin(), grid.clear(); }
    // Called after all bodies have entered.
    void restore(const State& state) { state_ = state, sheltered_ = 1; }

private:
    uint32_t phase_ = 0;
    State state_{};
    uint8_t sheltered_ = 0;
    double earliest_ = 0.0; // s: lower bound of births
    double* births_ = nullptr;
    Buffer<Box> boxes_; // by slot; NaN for none
};
static_assert(sizeof(SleepingBodies::State) % 8 == 0);
} // namespace lr
