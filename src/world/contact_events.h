// The contact events of a batch: noted during a step, told at its end. docs/reference/bodies.md
#pragma once

#include "contact/colliders.h"
#include "field/touch_notes.h"
#include "langevin_rigid.h"
#include "world/allocator.h"

#include <cstdint>

namespace lr {

class Batch;

// Those of a world's last step. What has no room is counted.
struct EventList {
    Buffer<lr_contact_event> events; // none: nothing is kept
    uint32_t kinds = 0;
    uint32_t count = 0;
    uint64_t lost = 0, total_lost = 0;

    bool on() const { return events.size() != 0; }
    void begin_step() { count = 0, lost = 0; }
    void add(const lr_contact_event& event);
};

// By slots of bodies, which do not change while these live.
class ContactEvents {
public:
    // Null when out of memory.
    static ContactEvents* create(Allocator& allocator, uint32_t capacity);
    static void destroy(Allocator& allocator, ContactEvents* events);

    // Before a step of the batch. looks: its bodies are held against colliders in it.
    void begin_step(bool looks);
    TouchNotes notes(const lr_body* ids);
    // A collider has been destroyed: what a slot stood for may be another.
    void recheck() { all_ = true; }

    void note_landed(uint32_t slot) { noted_[slot] |= noted_landing; }
    void note_woke(uint32_t slot) { noted_[slot] |= noted_waking; }
    // It has been put back to rest before it moved.
    void take_back_woke(uint32_t slot) { noted_[slot] &= static_cast<uint8_t>(~noted_waking); }
    // Called for each once in a step.
    void note_killed(lr_body body, uint32_t key, const float (&position)[3], bool for_fault);
    void note_fault(uint32_t slot) { noted_[slot] |= noted_fault; } // it is held where it was
    // The slot's body is a new one, or none.
    void clear(uint32_t slot);
    // Bodies touch what the batch's arrays say, and nothing has happened.
    void resume(const Batch& batch, const Colliders& colliders);

    // At the end of a step of the world; stepped: of the batch too.
    void tell(const Batch& batch, lr_batch handle, const Colliders& colliders, bool stepped, EventList& to);

private:
    ContactEvents() = default;
    struct Killed {
        lr_body body;
        uint32_t key;
        float position[3];
    };
    // A body, or one that was killed, in the order in which they are told.
    struct Entry {
        uint32_t key, slot;
        uint32_t at; // dense index, or place among the killed
    };
    struct Held {
        lr_collider collider[most_touches]; // 0 behind the last
        bool has(lr_collider one) const {
            bool found = false;
            for (const lr_collider c : collider) found = found || c == one;
            return found;
        }
    };
    Held now_held(const Batch& batch, uint32_t index, const Colliders& colliders) const;
    Held still_held(uint32_t slot, const Colliders& colliders) const;
    void tell_body(const Batch& batch, uint32_t index, lr_batch handle, const Colliders& colliders, bool stepped,
                   EventList& to);

    Buffer<uint8_t> noted_;
    Buffer<Held> held_; // at the end of the last step
    Buffer<Meetings> met_;
    Buffer<Killed> killed_; // those that left physics from the back
    Buffer<Entry> entries_;
    uint32_t killed_count_ = 0, fault_count_ = 0;
    bool all_ = false, looks_ = false;
};

} // namespace lr
