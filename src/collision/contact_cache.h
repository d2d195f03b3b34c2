// Contact state that bodies carry from substep to substep: the things they touch, and how long they have been still.
#pragma once

#include "base/handles.h"
#include "collision/body_shape.h"
#include "collision/collider_contact_group.h"
#include "langevin_rigid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace lr {

inline constexpr uint32_t most_touches = 4; // colliders of a body that count
inline constexpr float lee_unknown = -1.0f; // of ContactCache::lee
inline constexpr uint32_t stay_rows = 7;    // of ContactCache::stay

// A touched thing is the slot of a collider + 1, or one of these values; 0: nothing.
inline constexpr uint32_t touching_body = UINT32_MAX;      // any number of bodies
inline constexpr uint32_t touching_water = UINT32_MAX - 1; // a float that touches nothing else: world/sleep/afloat.h
static_assert(LR_MAX_COLLIDERS < touching_water);
inline bool is_collider(uint32_t touched) {
    return touched != 0 && touched < touching_water;
}

struct Meetings {
    Touch touch[most_touches]; // unused ones last
};

// Touches for events, by body slot, written by the thread that steps the body. Null arrays: events are off.
struct TouchNotes {
    const lr_body* ids = nullptr; // by dense index
    uint8_t* noted = nullptr;     // noted_* bits
    Meetings* met = nullptr;      // of the step
    bool all = false;             // slots can belong to other colliders by now: report all touches anew

    uint32_t slot(uint32_t index) const { return unpack(ids[index]).slot; }
};

enum Note : uint8_t { noted_touch = 1, noted_landing = 2, noted_waking = 4, noted_divergence = 8, noted_spawn = 16 };

// Per body of a batch, by dense index, written by the thread that steps it.
struct ContactCache {
    // Share of the time to sleep that has passed (see enter_body); null: nothing is recorded.
    float* stillness = nullptr;
    // How long the body has stayed in place, s, and since then its displacement (m, world frame) and turn (rad, body frame).
    float* stay[stay_rows] = {};
    // Share of the wind's speed lost to shelter; lee_unknown, which counts as 0: not known since the body woke. Of sleeping bodies 0, or lee_unknown
    // if the support may have left.
    float* lee = nullptr;
    uint32_t* touching[most_touches] = {}; // slots + 1 of colliders, touching_body; 0: none
    void (*falls_asleep)(void* batch, uint32_t index) = nullptr;
    void* batch = nullptr;
    TouchNotes notes;

    void forget(uint32_t index) const {
        stillness[index] = 0.0f;
        if (stay[0][index] != 0.0f)
            for (float* row : stay) row[index] = 0.0f;
        for (uint32_t* row : touching) row[index] = 0;
    }
};

// Times after which a body that touches something falls asleep, s: without a change in any bit of its pose; still, at most; trembling.
inline constexpr float time_unmoved = 0.05f, time_to_sleep = 0.5f, time_to_tremble = 2.0f;
// Speed below which a body is still, over the square root of its reach: that of a fall by 1e-5 of the reach. m/s over sqrt(m).
inline float still_speed(float gravity) {
    return std::sqrt(2e-5f * gravity);
}
// A body moves if it is faster than still_speed by this factor; between the two it trembles.
inline constexpr float trembling = 10.0f;
// A trembling body falls asleep after this time within this share of its reach (BodyAfter::place). On uneven ground trembling never ends.
inline constexpr float time_to_stay = 1.0f, stay_way = 0.02f; // s

struct BodyAfter {
    uint32_t index;
    float speed;                // m/s, of its fastest point
    float still, moving;        // m/s: still below `still`, moving above `moving`
    float place;                // m: limit of staying in place
    float rest;                 // s: after this time it falls asleep if it is still
    bool moved;                 // a bit of its pose changed
    Vector way, turn;           // m, world frame; rad, body frame: change in the substep
    Vector extent;              // m, along its axes
    float reach;                // m
    uint32_t now[most_touches]; // as ContactCache::touching
    bool touches() const { return now[0] != 0; }
};

// Bound of any point's displacement, m, by a small turn of a body with these extents; or of its speed, m/s, by a spin.
inline float farthest(Vector extent, Vector turn) {
    const float x = std::abs(turn.x), y = std::abs(turn.y), z = std::abs(turn.z);
    return length(Vector{y * extent.z + z * extent.y, z * extent.x + x * extent.z, x * extent.y + y * extent.x});
}

// Bound of the speed of the body's fastest point, m/s.
inline float fastest(Vector extent, Vector v, Vector w) {
    return length(v) + farthest(extent, w);
}

// Whether a body overlaps something by more than half its thickness and its fall in a substep, g h^2: it must get out before it rests.
inline bool lies_deep(float least_gap, const BodyShape& shape, float scale, float fall) {
    return !(least_gap > -(0.5f * shape.thickness * scale + fall));
}

// Motion that does not last for two substeps does not count, below the limit of restitution (2 g h). In heaps bodies fall through gaps that the
// sweeps leave and are stopped in the next substep; where a substep is too long for a leaf to rock, it is on the other side after each.
inline float lasting_speed(const BodyAfter& body, Vector v0, Vector w0, Vector v, Vector w, float fall) {
    const float before = fastest(body.extent, v0, w0), now = fastest(body.extent, v, w);
    if (std::max(before, now) > 2.0f * fall) return std::max(before, now);
    return std::min({before, now, fastest(body.extent, 0.5f * (v0 + v), 0.5f * (w0 + w))});
}

// All of BodyAfter but the touches. still_speed: m/s over sqrt(m). v, w: body frame.
inline BodyAfter body_moved(uint32_t index, const BodyShape& shape, float scale, float still_speed, Vector v, Vector w,
                            const Pose& before, const Pose& now) {
    BodyAfter body{};
    body.index = index;
    body.reach = shape.reach * scale;
    body.extent = scale * shape.extent;
    body.still = still_speed * std::sqrt(body.reach);
    body.moving = trembling * body.still;
    body.place = stay_way * body.reach;
    // As long as it would take to leave its place when barely still, in proportion to sqrt(reach/g). Longer keeps heaps awake.
    body.rest = std::min(time_to_sleep, body.place / body.still);
    body.speed = fastest(body.extent, v, w);
    body.way = now.position - before.position;
    body.turn = chord(inverse(before.rotation) * now.rotation);
    body.moved = body.speed > 0.0f || dot(body.way, body.way) > 0.0f || before.rotation != now.rotation;
    return body;
}

// m: bound of the displacement of any point since the body's stay began, with this substep. sum, if wanted: displacement and turn, 6 values.
inline float way_in_place(const ContactCache& book, const BodyAfter& body, float* sum = nullptr) {
    const float parts[6] = {body.way.x, body.way.y, body.way.z, body.turn.x, body.turn.y, body.turn.z};
    float own[6];
    float* const s = sum ? sum : own;
    for (size_t k = 0; k < 6; ++k) s[k] = book.stay[1 + k][body.index] + parts[k];
    return length(Vector{s[0], s[1], s[2]}) + farthest(body.extent, {s[3], s[4], s[5]});
}

// Adds the substep to the stay; true once it has lasted time_to_stay.
inline bool stays(const ContactCache& book, const BodyAfter& body, float seconds) {
    const uint32_t at = body.index;
    float sum[6];
    const float far = way_in_place(book, body, sum);
    const float lasted = book.stay[0][at] + seconds;
    // A time of 0 means no record. If the step is below the smallest float the time stays 0, so no displacement may be recorded either.
    if (!(far < body.place) || lasted == 0.0f) {
        for (float* row : book.stay) row[at] = 0.0f;
        return false;
    }
    for (size_t k = 0; k < 6; ++k) book.stay[1 + k][at] = sum[k];
    book.stay[0][at] = lasted;
    return lasted >= time_to_stay;
}

// Notes contacts that began in a substep, and whether any ended. touch_with(collider slot): a Touch.
template <class TouchWith>
void note_touches(const ContactCache& book, const BodyAfter& body, const TouchWith& touch_with) {
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
        // When all places are taken, contacts that have ended give theirs up.
        Touch(&met)[most_touches] = book.notes.met[slot].touch;
        const auto first = [&](const auto& is) { return std::find_if(std::begin(met), std::end(met), is); };
        Touch* at = first([&](const Touch& t) { return t.collider == collider || t.collider == 0; });
        if (at == std::end(met)) at = first([&](const Touch& t) { return !holds(body.now, t.collider); });
        if (at != std::end(met) && at->collider != collider) *at = touch_with(collider - 1);
    }
    if (changed) book.notes.noted[slot] |= noted_touch;
}

template <class TouchWith>
void enter_body(const ContactCache& book, const BodyAfter& body, bool may_sleep, float seconds, bool last,
                const TouchWith& touch_with) {
    const uint32_t at = body.index;
    if (!body.touches() && book.touching[0][at] == touching_water) return;
    // Motion starts the time over.
    const bool moves = !body.touches() || body.speed > body.moving;
    const float needed = body.speed > body.still ? time_to_tremble : body.moved ? body.rest : time_unmoved;
    book.stillness[at] = moves ? 0.0f : book.stillness[at] + seconds / needed;
    const bool stayed = stays(book, body, seconds) && body.touches();
    if (last && may_sleep && (stayed || book.stillness[at] >= 1.0f)) book.falls_asleep(book.batch, at);
    if (!body.touches()) book.lee[at] = 0.0f;
    if (!last && !body.touches()) return; // the contact can return within the step
    if (book.notes.noted) note_touches(book, body, touch_with);
    for (size_t k = 0; k < most_touches; ++k) book.touching[k][at] = body.now[k];
}
} // namespace lr
