// What is kept of a body's contacts from substep to substep: what it touches, and how long it has lain still.
#pragma once

#include "field/touch_notes.h"
#include "kernel/batch_arrays.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace lr {

// Per body of a batch, by dense index; each written by the thread that steps the body.
struct ContactBook {
    float* rest_time = nullptr;            // s, for which it has lain still; null: nothing is noted
    uint32_t* touching[most_touches] = {}; // slots + 1 of colliders, touching_body; 0: none
    void (*comes_to_rest)(void* batch, uint32_t index) = nullptr;
    void* batch = nullptr;
    TouchNotes notes;
};

// A body comes to rest when it has touched something and hardly moved for so long.
inline constexpr float time_to_rest = 0.5f; // s
// m/s over the square root of the reach in m, of bodies that lie still: the speed of a fall by 1e-5 of it.
inline float still_speed(float gravity) {
    return std::sqrt(2e-5f * gravity);
}
// What is faster than a body that lies still by this much moves.
inline constexpr float trembling = 10.0f;

// After a substep.
struct BodyAfter {
    uint32_t index;
    float speed;         // m/s, of its fastest point
    float still, moving; // m/s: below the one it lies still, above the other it moves
    bool moved;          // by a bit at least
    bool touches;
    uint32_t now[most_touches]; // as ContactBook::touching
};

// What a body has begun to touch in a substep, and that it no longer touches what it did. meeting(collider slot): a Touch.
template <class Meeting> void note_touches(const ContactBook& book, const BodyAfter& body, const Meeting& meeting) {
    const auto holds = [](const uint32_t(&row)[most_touches], uint32_t collider) {
        return std::any_of(std::begin(row), std::end(row), [&](uint32_t c) { return c == collider; });
    };
    const uint32_t slot = book.notes.slot(body.index);
    uint32_t was[most_touches];
    for (size_t k = 0; k < most_touches; ++k) was[k] = book.touching[k][body.index];
    bool changed = book.notes.all;
    for (const uint32_t collider : was) changed = changed || (is_collider(collider) && !holds(body.now, collider));
    for (const uint32_t collider : body.now) {
        if (!is_collider(collider) || (!book.notes.all && holds(was, collider))) continue;
        changed = true;
        for (Touch& touch : book.notes.met[slot].touch) {
            if (touch.collider == collider) break;
            if (touch.collider != 0) continue;
            touch = meeting(collider - 1);
            break;
        }
    }
    if (changed) book.notes.noted[slot] |= noted_touch;
}

template <class Meeting>
void enter_body(const ContactBook& book, const BodyAfter& body, bool may_rest, float seconds, bool last,
                const Meeting& meeting) {
    const uint32_t at = body.index;
    // What trembles by ten times as much takes four times as long, what has not moved by a bit a tenth.
    const bool moves = !body.touches || body.speed > body.moving;
    const float share = moves ? 0.0f : body.speed > body.still ? 0.25f : body.moved ? 1.0f : 10.0f;
    book.rest_time[at] = share > 0.0f ? book.rest_time[at] + share * seconds : 0.0f;
    if (last && may_rest && book.rest_time[at] >= time_to_rest) book.comes_to_rest(book.batch, at);
    if (!last && body.now[0] == 0) return; // it may come back within the step
    if (book.notes.noted) note_touches(book, body, meeting);
    for (size_t k = 0; k < most_touches; ++k) book.touching[k][at] = body.now[k];
}

} // namespace lr
