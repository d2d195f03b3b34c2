#include "world/contact_events.h"

#include "world/batch.h"
#include "world/world.h"

#include <algorithm>
#include <new>

using lr::Batch;

namespace lr {
namespace {

static_assert(LR_EVENTS_ALL == (1u << LR_BODY_FAULTED) - 1);
static_assert(sizeof(lr_contact_event) == 64);
static_assert(most_touches == most_touched);

uint32_t slot_of(lr_collider collider) {
    return unpack_collider(collider).slot;
}

// By slots; of one that two colliders have had in turn, the former comes first.
struct Sorted {
    lr_collider collider[2 * most_touches];
    uint32_t count = 0;
    void insert(lr_collider one) {
        const auto after = [one](lr_collider c) {
            return slot_of(c) != slot_of(one) ? slot_of(c) > slot_of(one) : c > one;
        };
        uint32_t at = count++;
        for (; at > 0 && after(collider[at - 1]); --at) collider[at] = collider[at - 1];
        collider[at] = one;
    }
};

} // namespace

void EventList::add(const lr_contact_event& event) {
    if ((kinds & 1u << (event.kind - 1)) == 0) return;
    if (count < events.size()) {
        events[count++] = event;
        return;
    }
    ++lost;
    ++total_lost;
}

ContactEvents* ContactEvents::create(Allocator& allocator, uint32_t capacity) {
    void* const memory = allocator.allocate(sizeof(ContactEvents));
    if (!memory) return nullptr;
    auto* const made = new (memory) ContactEvents();
    if (made->noted_.allocate(allocator, capacity) && made->held_.allocate(allocator, capacity) &&
        made->met_.allocate(allocator, capacity) && made->killed_.allocate(allocator, capacity) &&
        made->entries_.allocate(allocator, size_t{2} * capacity)) {
        for (uint32_t i = 0; i < capacity; ++i) made->clear(i);
        return made;
    }
    destroy(allocator, made);
    return nullptr;
}

void ContactEvents::destroy(Allocator& allocator, ContactEvents* events) {
    if (!events) return;
    events->~ContactEvents();
    allocator.release(events, sizeof(ContactEvents));
}

void ContactEvents::begin_step(bool looks) {
    all_ = all_ || looks != looks_;
    looks_ = looks;
}

TouchNotes ContactEvents::notes(const lr_body* ids) {
    return {ids, noted_.data(), met_.data(), all_};
}

void ContactEvents::note_killed(lr_body body, uint32_t key, const float (&position)[3], bool for_fault) {
    killed_[for_fault ? killed_.size() - ++fault_count_ : killed_count_++] = {
        body, key, {position[0], position[1], position[2]}};
}

void ContactEvents::clear(uint32_t slot) {
    noted_[slot] = 0;
    held_[slot] = {};
    met_[slot] = {};
}

void ContactEvents::resume(const Batch& batch, const Colliders& colliders) {
    killed_count_ = fault_count_ = 0;
    all_ = false;
    for (uint32_t i = 0; i < noted_.size(); ++i) clear(i);
    const ContactArrays contact = batch.contact_arrays();
    looks_ = colliders.any() && batch.contact.layers != 0;
    if (!contact.rest_time || !looks_) return;
    for (uint32_t i = 0; i < batch.count(); ++i) held_[unpack(batch.ids()[i]).slot] = now_held(batch, i, colliders);
}

// What a body touches at the end of a step.
ContactEvents::Held ContactEvents::now_held(const Batch& batch, uint32_t index, const Colliders& colliders) const {
    const ContactArrays contact = batch.contact_arrays();
    Held held{};
    if (!looks_ || !contact.rest_time) return held;
    uint32_t count = 0;
    for (const uint32_t* touching : contact.touching) {
        const uint32_t at = touching[index];
        if (is_collider(at) && colliders.in_use(at - 1)) held.collider[count++] = colliders.id(at - 1);
    }
    return held;
}

// Of a body that has not been stepped: without what has been destroyed.
ContactEvents::Held ContactEvents::still_held(uint32_t slot, const Colliders& colliders) const {
    Held held{};
    uint32_t count = 0, ignored = 0;
    for (const lr_collider collider : held_[slot].collider)
        if (collider != 0 && colliders.find(collider, ignored)) held.collider[count++] = collider;
    return held;
}

void ContactEvents::tell_body(const Batch& batch, uint32_t index, lr_batch handle, const Colliders& colliders,
                              bool stepped, EventList& to) {
    const lr_body body = batch.ids()[index];
    const uint32_t slot = unpack(body).slot;
    const uint8_t notes = noted_[slot];
    const bool moved = stepped && (!batch.rests(index) || (notes & noted_landing) != 0);
    const Held before = held_[slot], now = moved ? now_held(batch, index, colliders) : still_held(slot, colliders);
    const Touch(&met)[most_touches] = met_[slot].touch;

    lr_contact_event event{};
    event.batch = handle;
    event.body = body;
    const BatchArrays& arrays = batch.arrays();
    for (size_t k = 0; k < 3; ++k) event.position[k] = arrays.field[field_x + k][index];
    Sorted begun, ended;
    for (const lr_collider collider : now.collider)
        if (collider != 0 && !before.has(collider)) begun.insert(collider);
    for (const lr_collider collider : before.collider)
        if (collider != 0 && !now.has(collider)) ended.insert(collider);
    for (const Touch& touch : met) {
        if (touch.collider == 0 || !colliders.in_use(touch.collider - 1)) continue;
        const lr_collider collider = colliders.id(touch.collider - 1);
        if (before.has(collider) || now.has(collider)) continue;
        begun.insert(collider);
        ended.insert(collider);
    }
    for (uint32_t k = 0; k < begun.count; ++k) {
        lr_contact_event e = event;
        e.kind = LR_CONTACT_BEGIN;
        e.collider = begun.collider[k];
        for (const Touch& touch : met) {
            if (touch.collider != slot_of(e.collider) + 1) continue;
            std::copy(touch.position, touch.position + 3, e.position);
            std::copy(touch.normal, touch.normal + 3, e.normal);
            e.speed = touch.speed;
            e.impulse = touch.impulse;
        }
        to.add(e);
    }
    event.kind = LR_CONTACT_END;
    for (uint32_t k = 0; k < ended.count; ++k) {
        event.collider = ended.collider[k];
        to.add(event);
    }
    event.collider = 0;
    event.kind = LR_BODY_LANDED;
    if (notes & noted_landing) to.add(event);
    event.kind = LR_BODY_WOKE;
    if (notes & noted_waking) to.add(event);
    event.kind = LR_BODY_FAULTED;
    if (notes & noted_fault) to.add(event);
    clear(slot);
    held_[slot] = now;
}

void ContactEvents::tell(const Batch& batch, lr_batch handle, const Colliders& colliders, bool stepped, EventList& to) {
    constexpr uint32_t killed_bit = 1u << 31; // above every dense index
    uint32_t count = 0;
    for (uint32_t i = 0; i < batch.count(); ++i) {
        const uint32_t slot = unpack(batch.ids()[i]).slot;
        if (noted_[slot] != 0 || (all_ && (stepped || batch.rests(i))))
            entries_[count++] = {batch.arrays().key[i], slot, i};
    }
    const auto enter_killed = [&](size_t from, uint32_t number) {
        for (size_t k = from; k < from + number; ++k)
            entries_[count++] = {killed_[k].key, unpack(killed_[k].body).slot, static_cast<uint32_t>(k) | killed_bit};
    };
    const size_t for_faults = killed_.size() - fault_count_;
    enter_killed(0, killed_count_);
    enter_killed(for_faults, fault_count_);
    std::sort(entries_.data(), entries_.data() + count, [](const Entry& a, const Entry& b) {
        return a.key != b.key ? a.key < b.key : a.slot != b.slot ? a.slot < b.slot : a.at > b.at;
    });
    for (uint32_t e = 0; e < count; ++e) {
        const uint32_t at = entries_[e].at;
        if ((at & killed_bit) == 0) {
            tell_body(batch, at, handle, colliders, stepped, to);
            continue;
        }
        const Killed& killed = killed_[at & ~killed_bit];
        lr_contact_event event{};
        event.kind = LR_BODY_KILLED;
        event.batch = handle;
        event.body = killed.body;
        std::copy(killed.position, killed.position + 3, event.position);
        to.add(event);
        event.kind = LR_BODY_FAULTED;
        if ((at & ~killed_bit) >= for_faults) to.add(event);
    }
    killed_count_ = fault_count_ = 0;
    if (stepped) all_ = false;
}

} // namespace lr

lr_status lr_world::set_contact_events(uint32_t capacity, uint32_t kinds) {
    lr::Buffer<lr_contact_event> room;
    if (!room.allocate(allocator, capacity)) return LR_ERROR_OUT_OF_MEMORY;
    bool enough = true;
    for (uint32_t i = 0; i < batch_slots && capacity != 0 && enough; ++i)
        if (batches[i].batch) enough = batches[i].batch->reserve_events();
    for (uint32_t i = 0; i < batch_slots; ++i) {
        Batch* const batch = batches[i].batch;
        if (!batch) continue;
        if (capacity == 0 || (!enough && !contact_events.on()))
            batch->drop_events();
        else if (enough && !contact_events.on())
            batch->events()->resume(*batch, colliders);
    }
    if (!enough) return LR_ERROR_OUT_OF_MEMORY;
    contact_events.events.swap(room);
    contact_events.kinds = kinds;
    contact_events.begin_step();
    contact_events.total_lost = 0;
    return LR_OK;
}

void lr_world::recheck_contacts() {
    for (uint32_t i = 0; i < batch_slots; ++i)
        if (batches[i].batch && batches[i].batch->events()) batches[i].batch->events()->recheck();
}

void lr_world::resume_contact_events() {
    contact_events.begin_step();
    for (uint32_t i = 0; i < batch_slots; ++i)
        if (batches[i].batch && batches[i].batch->events())
            batches[i].batch->events()->resume(*batches[i].batch, colliders);
}
