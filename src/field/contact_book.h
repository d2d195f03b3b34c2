// What is kept of a body's contacts from substep to substep: what it touches, and how long it has lain still.
#pragma once

#include "contact/body_shape.h"
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
    float* stay[stay_rows] = {};           // s, m, rad: as ContactArrays::stay
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
// Or when it has gone nowhere for so long, however it trembled: this part of its reach.
inline constexpr float time_to_stay = 1.0f, stay_way = 0.02f; // s

// After a substep.
struct BodyAfter {
    uint32_t index;
    float speed;         // m/s, of its fastest point
    float still, moving; // m/s: below the one it lies still, above the other it moves
    bool moved;          // by a bit at least
    Vector way, turn;    // m, world frame; rad, body frame: of the substep
    Vector extent;       // m, along its axes
    float reach;         // m
    bool touches;
    uint32_t now[most_touches]; // as ContactBook::touching
};

// No point of a body with these extents goes farther than this by a small turn, m; or is faster by a spin, m/s.
inline float farthest(Vector extent, Vector turn) {
    const float x = std::abs(turn.x), y = std::abs(turn.y), z = std::abs(turn.z);
    return length(Vector{y * extent.z + z * extent.y, z * extent.x + x * extent.z, x * extent.y + y * extent.x});
}

// Of its fastest point, at most, m/s.
inline float fastest(Vector extent, Vector v, Vector w) {
    return length(v) + farthest(extent, w);
}

// All but what it touches. still_speed: m/s over the square root of the reach in m. v, w: body frame.
inline BodyAfter body_moved(uint32_t index, const BodyShape& shape, float scale, float still_speed, Vector v, Vector w,
                            const Pose& before, const Pose& now) {
    BodyAfter body{};
    body.index = index;
    body.reach = shape.reach * scale;
    body.extent = scale * shape.extent;
    body.still = still_speed * std::sqrt(body.reach);
    body.moving = trembling * body.still;
    body.speed = fastest(body.extent, v, w);
    body.way = now.position - before.position;
    const Rotation by = inverse(before.rotation) * now.rotation;
    body.turn = (by.w < 0.0f ? -2.0f : 2.0f) * Vector{by.x, by.y, by.z};
    const Rotation a = before.rotation, b = now.rotation;
    body.moved =
        body.speed > 0.0f || dot(body.way, body.way) > 0.0f || a.x != b.x || a.y != b.y || a.z != b.z || a.w != b.w;
    return body;
}

// Whether it is about where it was some time ago.
inline bool stays(const ContactBook& book, const BodyAfter& body, float seconds) {
    const uint32_t at = body.index;
    const float sums[6] = {body.way.x, body.way.y, body.way.z, body.turn.x, body.turn.y, body.turn.z};
    float sum[6];
    for (size_t k = 0; k < 6; ++k) sum[k] = book.stay[1 + k][at] + sums[k];
    const float far = length(Vector{sum[0], sum[1], sum[2]}) + farthest(body.extent, {sum[3], sum[4], sum[5]});
    const float lasted = book.stay[0][at] + seconds;
    // That nothing is noted is read off the time alone: without one, of a step under the least float, no way is kept either.
    if (!(far < stay_way * body.reach) || lasted == 0.0f) {
        for (float* row : book.stay) row[at] = 0.0f;
        return false;
    }
    for (size_t k = 0; k < 6; ++k) book.stay[1 + k][at] = sum[k];
    book.stay[0][at] = lasted;
    return lasted >= time_to_stay;
}

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
    const bool stayed = stays(book, body, seconds) && body.touches;
    if (last && may_rest && (stayed || book.rest_time[at] >= time_to_rest)) book.comes_to_rest(book.batch, at);
    if (!last && body.now[0] == 0) return; // it may come back within the step
    if (book.notes.noted) note_touches(book, body, meeting);
    for (size_t k = 0; k < most_touches; ++k) book.touching[k][at] = body.now[k];
}

} // namespace lr
