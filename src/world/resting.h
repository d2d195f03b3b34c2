// The bodies of a batch that are at rest: since when and where. And what contact notes of each body until it is. docs/reference/bodies.md
#pragma once

#include "contact/body_pair.h"
#include "contact/rest_grid.h"
#include "field/touch_notes.h"
#include "world/allocator.h"

#include <cstdint>

namespace lr {

inline constexpr uint32_t most_touched = most_touches;

// By dense index, kept with the bodies as these move about. Null before Batch::reserve_contact().
struct ContactArrays {
    float* rest_time; // s, that a body has been slow; 0 when it wakes
    // For how long it has gone nowhere, s, and its way and turn since then, m and rad: world and body frame.
    float* stay[stay_rows];
    // Slots of the colliders that it touches, + 1; touching_body for bodies, once; 0 behind the last.
    uint32_t* touching[most_touched];
};

// A wind (m/s) that a body has withstood says the same of every weaker one from about the same direction.
bool withstands(Vector held, Vector wind);

// Knows bodies by dense index and slot; which of them rest, the batch knows.
class Resting {
public:
    // Rules look at bodies at rest in one of so many steps of their batch.
    static constexpr uint32_t rule_steps = 16;

    // Null when out of memory. phase: batches of different ones take different steps.
    static Resting* create(Allocator& allocator, uint32_t capacity, double reach, uint32_t phase);
    static void destroy(Allocator& allocator, Resting* resting);
    bool reserve_contact(Allocator& allocator, uint32_t lanes);

    // The first body comes to rest.
    void begin();
    // A body comes to rest that was born then, on the clock. It has a box.
    void enter(uint32_t index, uint32_t slot, Vector position, float scale, double birth);
    // What others can touch of it: made when it comes to rest, and forgotten when it leaves.
    const Box& box(uint32_t slot) const { return boxes_[slot]; }
    bool has_box(uint32_t slot) const { return boxes_[slot].low.x == boxes_[slot].low.x; }
    void set_box(uint32_t slot, const Box& box) { boxes_[slot] = box; }
    void forget_box(uint32_t slot);
    double birth_of(float age, float age_rest) const {
        return clock_ - (static_cast<double>(age) - static_cast<double>(age_rest));
    }
    double birth(uint32_t index) const { return birth_[index]; }
    const double* births() const { return birth_.data(); } // by dense index, of bodies at rest
    void leave(uint32_t slot) {
        grid.remove(slot);
        forget_box(slot);
    }
    // `age_rest` is what rounding has added to the age, as in the kernel.
    void age_of(uint32_t index, float& age, float& age_rest) const;
    void swap(uint32_t a, uint32_t b);
    void move(uint32_t from, uint32_t to);
    // There is no body at this index.
    void clear(uint32_t index);
    // Of the first `count` bodies.
    void forget_touched_bodies(uint32_t count);
    // A body's life begins anew.
    void forget(uint32_t index);
    // It wakes.
    void forget_rest(uint32_t index);

    // So many steps of the world have passed for the batch. Returns whether it is time for the rules.
    bool pass(double seconds, uint32_t steps);
    // Whether the rules may have a new answer for one of them.
    bool in_question(float max_age) const;
    // The uniform wind over all of them. True when each has had its turn in one like it since the last came to rest; else it is
    // the turn of the next.
    bool withstood(const float (&wind)[3]);
    // They have answered. Bodies of [begin, end) rest.
    void answered(uint32_t begin, uint32_t end, float max_age);
    void ask_again() { unjudged_ = true; }

    // From any thread; of bodies that move, for those of its own cuts (world/step_chunks.h).
    void note(uint32_t index);
    // Bodies noted in a cut, and forgets that there are any.
    bool cut_noted(uint32_t cut) const { return cut_noted_[cut] != 0; }
    bool take_cut(uint32_t cut);
    bool take_note(uint32_t index);

    // Whether contact has noted anything of the first `count` bodies.
    bool any_contact(uint32_t count) const;

    ContactArrays contact{};
    RestGrid grid;

    // What a snapshot holds, beside births.
    struct Record {
        double clock;
        uint32_t awake; // bodies
        uint32_t steps;
        uint32_t unjudged;
        uint32_t tried; // turns in which all bodies withstood `wind`, up to rule_steps
        float wind[3];  // m/s
        uint32_t reserved;
    };
    Record record(uint32_t awake) const {
        return {clock_, awake, steps_, unjudged_ ? 1u : 0u, tried_, {withstood_[0], withstood_[1], withstood_[2]}, 0};
    }
    static bool consistent(const Record& record, uint32_t count);
    static bool consistent(const Record& record, double birth);
    // Nobody rests, and contact has noted nothing, of which there were `lanes` before. Boxes stay.
    void restore(const Record& record, uint32_t lanes);
    void restore_turns(const Record& record); // after all have entered

private:
    Resting() = default;

    uint32_t phase_ = 0;
    uint32_t steps_ = 0;    // since the rules' last turn
    bool unjudged_ = false; // one of them has not been judged by the present rules
    uint32_t tried_ = 0;
    float withstood_[3] = {};
    double clock_ = 0.0;    // s, of the batch since the first came to rest
    double earliest_ = 0.0; // s: no birth is before it
    Buffer<double> birth_;  // s, by dense index, of bodies at rest
    Buffer<Box> boxes_;     // by slot; NaN for none
    Buffer<float> rest_time_, stay_;
    Buffer<uint32_t> touching_;
    Buffer<uint8_t> noted_, cut_noted_;
};
static_assert(sizeof(Resting::Record) % 8 == 0);

} // namespace lr
