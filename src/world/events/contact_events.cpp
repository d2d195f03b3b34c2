#include "world/events/contact_events.h"

#include "world/batch/batch.h"
#include "world/world.h"

#include <cstring>
#include <iterator>
#include <utility>

namespace lr {
namespace {

static_assert(LR_EVENTS_ALL == (1u << LR_EVENT_DIVERGED) - 1);
static_assert(sizeof(lr_event) == 64);

uint32_t slot_of(lr_collider collider) {
    return unpack(collider).slot;
}

lr_event event_of(const Batch& batch, lr_batch handle, uint32_t index) {
    lr_event event{};
    event.batch = handle;
    event.body = batch.ids()[index];
    event.user = batch.user(index);
    put(vector_in(batch.arrays().field, field_x, index), event.position);
    return event;
}

// Whether the batch's bodies are tested against colliders.
bool can_touch(const Batch& batch, const Colliders& colliders) {
    return colliders.any() && batch.contact().layers != 0;
}
} // namespace

bool ContactEvents::allocate(Allocator& allocator, uint32_t capacity) {
    if (!noted_.allocate(allocator, capacity) || !held_.allocate(allocator, capacity) ||
        !met_.allocate(allocator, capacity) || !ended_.items.allocate(allocator, capacity) ||
        !entries_.items.allocate(allocator, uint64_t{2} * capacity))
        return false;
    for (uint32_t i = 0; i < capacity; ++i) clear(i);
    return true;
}

void ContactEvents::begin_step(const Batch& batch, const Colliders& colliders) {
    const bool looks = can_touch(batch, colliders);
    all_ = all_ || looks != looks_;
    looks_ = looks;
}

void ContactEvents::note_ended(const Batch& batch, uint32_t index, bool for_fault) {
    const lr_event event = event_of(batch, {}, index);
    const uint32_t slot = unpack(event.body).slot;
    const auto notes = static_cast<uint8_t>((noted_[slot] & noted_spawn) | (for_fault ? noted_divergence : 0));
    entries_.add({batch.arrays().noise_seed[index], slot, ended_.count | ended_bit});
    ended_.add({event.body, event.user, {event.position[0], event.position[1], event.position[2]}, notes});
}

void ContactEvents::clear(uint32_t slot) {
    noted_[slot] = 0;
    held_[slot] = {};
    met_[slot] = {};
}

void ContactEvents::begin() {
    ended_.count = entries_.count = 0;
    all_ = false;
    for (uint32_t i = 0; i < noted_.size(); ++i) clear(i);
}

void ContactEvents::resume(const Batch& batch, const Colliders& colliders) {
    begin();
    looks_ = can_touch(batch, colliders);
    for (uint32_t i = 0; i < batch.count(); ++i) held_[unpack(batch.ids()[i]).slot] = now_held(batch, i, colliders);
}

uint32_t ContactEvents::pending(const Batch& batch, const Colliders& colliders) const {
    if (!all_ && can_touch(batch, colliders) == looks_ &&
        std::none_of(noted_.data(), noted_.data() + noted_.size(), [](uint8_t n) { return n; }))
        return 0;
    uint32_t bits = pending_any;
    if (all_) bits |= pending_all;
    if (looks_) bits |= pending_looks;
    return bits;
}

void ContactEvents::resume(uint32_t pending, const void* noted, const void* held) {
    begin();
    all_ = (pending & pending_all) != 0;
    looks_ = (pending & pending_looks) != 0;
    std::memcpy(noted_.data(), noted, noted_.size());
    std::memcpy(static_cast<void*>(held_.data()), held, held_.size() * held_bytes);
}

// Colliders that a body touches at the end of a step.
ContactEvents::Held ContactEvents::now_held(const Batch& batch, uint32_t index, const Colliders& colliders) const {
    Held held{};
    if (!looks_ || !batch.columns().has(part_contact)) return held;
    uint32_t count = 0;
    for (size_t k = 0; k < most_touches; ++k) {
        const uint32_t at = batch.columns().row<uint32_t>(column_touching + k)[index];
        if (is_collider(at) && colliders.in_use(at - 1)) held.collider[count++] = colliders.id(at - 1);
    }
    return held;
}

// For a body that was not stepped: its contacts without destroyed colliders.
ContactEvents::Held ContactEvents::still_held(uint32_t slot, const Colliders& colliders) const {
    Held held{};
    uint32_t count = 0, ignored = 0;
    for (const lr_collider collider : held_[slot].collider)
        if (collider.id != 0 && colliders.find(collider, ignored)) held.collider[count++] = collider;
    return held;
}

void ContactEvents::tell_body(const Batch& batch, uint32_t index, lr_batch handle, const Colliders& colliders,
                              bool stepped, EventList& to) {
    lr_event event = event_of(batch, handle, index);
    const uint32_t slot = unpack(event.body).slot;
    const uint8_t notes = noted_[slot];
    const bool moved = stepped && (!batch.asleep(index) || (notes & noted_landing) != 0);
    const Held before = held_[slot], now = moved ? now_held(batch, index, colliders) : still_held(slot, colliders);
    const Touch(&met)[most_touches] = met_[slot].touch;

    const auto tell_of = [&](Note note, int32_t kind) {
        event.kind = kind;
        if (notes & note) to.tell(event);
    };
    tell_of(noted_spawn, LR_EVENT_SPAWNED);
    // All touched colliders by slot; of two that used one slot, the earlier comes first.
    lr_collider all[3 * most_touches];
    lr_collider* end = all;
    const auto insert = [&](lr_collider one) {
        const auto order = [](lr_collider c) { return std::pair(slot_of(c), c.id); };
        lr_collider* const at = std::find_if(all, end, [&](lr_collider c) { return order(c) >= order(one); });
        if (one.id == 0 || (at != end && *at == one)) return;
        std::copy_backward(at, end, end + 1);
        *at = one;
        ++end;
    };
    std::for_each(std::begin(before.collider), std::end(before.collider), insert);
    std::for_each(std::begin(now.collider), std::end(now.collider), insert);
    for (const Touch& touch : met)
        if (touch.collider != 0 && colliders.in_use(touch.collider - 1)) insert(colliders.id(touch.collider - 1));
    for (const lr_collider* c = all; c != end; ++c) {
        if (before.has(*c)) continue;
        lr_event e = event;
        e.kind = LR_EVENT_HIT;
        e.collider = *c;
        for (const Touch& touch : met) {
            if (touch.collider != slot_of(*c) + 1) continue;
            std::copy(touch.position, touch.position + 3, e.position);
            std::copy(touch.normal, touch.normal + 3, e.normal);
            e.speed = touch.speed;
            e.impulse = touch.impulse;
        }
        to.tell(e);
    }
    event.kind = LR_EVENT_LIFTED;
    for (const lr_collider* c = all; c != end; ++c) {
        event.collider = *c;
        if (!now.has(*c)) to.tell(event);
    }
    event.collider = {};
    tell_of(noted_landing, LR_EVENT_LANDED);
    tell_of(noted_waking, LR_EVENT_WOKE);
    tell_of(noted_divergence, LR_EVENT_DIVERGED);
    clear(slot);
    held_[slot] = now;
}

void ContactEvents::tell(const Batch& batch, lr_batch handle, const Colliders& colliders, bool stepped, int32_t ended,
                         EventList& to) {
    for (uint32_t i = 0; i < batch.count(); ++i) {
        const uint32_t slot = unpack(batch.ids()[i]).slot;
        if (noted_[slot] != 0 || (all_ && (stepped || batch.asleep(i))))
            entries_.add({batch.arrays().noise_seed[i], slot, i});
    }
    Entry* const entries = entries_.items.data();
    std::sort(entries, entries + entries_.count, [](const Entry& a, const Entry& b) {
        return a.noise_seed != b.noise_seed ? a.noise_seed < b.noise_seed
               : a.slot != b.slot           ? a.slot < b.slot
                                            : a.at > b.at;
    });
    for (uint32_t e = 0; e < entries_.count; ++e) {
        const uint32_t at = entries[e].at;
        if ((at & ended_bit) == 0) {
            tell_body(batch, at, handle, colliders, stepped, to);
            continue;
        }
        const Ended& one = ended_.items[at & ~ended_bit];
        lr_event event{};
        event.batch = handle;
        event.body = one.body;
        event.user = one.user;
        std::copy(one.position, one.position + 3, event.position);
        for (const int32_t kind : {int32_t{LR_EVENT_SPAWNED}, ended, int32_t{LR_EVENT_DIVERGED}}) {
            event.kind = kind;
            if (kind == ended || (one.notes & (kind == LR_EVENT_SPAWNED ? noted_spawn : noted_divergence)))
                to.tell(event);
        }
    }
    ended_.count = entries_.count = 0;
    if (stepped) all_ = false;
}
} // namespace lr
