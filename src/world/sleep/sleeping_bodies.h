// The sleeping bodies of a batch: since when and where. docs/reference/bodies.md
#pragma once

#include "base/allocator.h"
#include "collision/body_narrow_phase.h"
#include "collision/sleeping_grid.h"

#include <cstdint>

namespace lr {

// Whether a body that withstood the wind `held` (m/s) also withstands `wind`: weaker, and from about the same direction.
bool withstands(Vector held, Vector wind);

// Bodies by dense index and slot; the batch knows which of them sleep.
class SleepingBodies {
public:
    // Rules check sleeping bodies in one of so many steps of their batch.
    static constexpr uint32_t rule_steps = 16;

    // phase: spreads the checks of batches over steps. births: by dense index, s on the clock.
    bool allocate(Allocator& allocator, uint32_t capacity, double reach, uint32_t phase, double* births);

    // The first body falls asleep.
    void begin();
    // A body falls asleep; its birth and box are set.
    void enter(uint32_t index, uint32_t slot, Vector position, float scale);
    void leave(uint32_t slot) {
        grid.remove(slot);
        forget_box(slot);
    }
    // Its contact box: made when it falls asleep, forgotten when it leaves.
    const Box& box(uint32_t slot) const { return boxes_[slot]; }
    bool has_box(uint32_t slot) const { return boxes_[slot].low.x == boxes_[slot].low.x; }
    void set_box(uint32_t slot, const Box& box) { boxes_[slot] = box; }
    void forget_box(uint32_t slot);
    double birth_of(float age, float age_remainder) const {
        return state_.clock - (static_cast<double>(age) - static_cast<double>(age_remainder));
    }
    // `age_rest`: the rounding carried with the age, as in the kernel.
    void age_of(uint32_t index, float& age, float& age_remainder) const;

    // So many steps of the world have passed for the batch. Returns whether rules are due.
    bool pass(double seconds, uint32_t steps);
    // Whether the rules can give a new answer for any of them.
    bool in_question(float max_age) const;
    // For the uniform wind: true if all bodies have been tried in a similar one since the last fell asleep; else the next ones have their turn.
    bool withstood(const float (&wind)[3]);
    // One of them has to be tried again. Any thread.
    void try_wind_again() { __atomic_store_n(&state_.tried, 0u, __ATOMIC_RELAXED); }
    // Whether one can have withstood a wind under the shelter of others: never false if one has. Noted by any thread.
    bool any_sheltered() const { return sheltered_ != 0; }
    void note_sheltered() { __atomic_store_n(&sheltered_, uint8_t{1}, __ATOMIC_RELAXED); }
    // Rules have checked all of them. Bodies [begin, end) sleep.
    void answered(uint32_t begin, uint32_t end, float max_age);
    void ask_again() { state_.unjudged = 1; }

    SleepingGrid grid;

    // Saved in snapshots, besides births.
    struct State {
        double clock;      // s, of the batch since the first fell asleep
        uint32_t steps;    // since rules were last checked
        uint32_t unjudged; // 1: some have not been checked by the present rules
        uint32_t tried;    // turns in which all bodies withstood `wind`, up to rule_steps
        float wind[3];     // m/s
    };
    const State& state() const { return state_; }
    static bool consistent(const State& state);
    static bool consistent(const State& state, double birth);
    // No body sleeps; boxes stay.
    void clear() { begin(), grid.clear(); }
    // After all have entered.
    void restore(const State& state) { state_ = state, sheltered_ = 1; }

private:
    uint32_t phase_ = 0;
    State state_{};
    uint8_t sheltered_ = 0;
    double earliest_ = 0.0; // s: no birth is before it
    double* births_ = nullptr;
    Buffer<Box> boxes_; // by slot; NaN for none
};
static_assert(sizeof(SleepingBodies::State) % 8 == 0);
} // namespace lr
