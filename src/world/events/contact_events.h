// Events of a batch: collected during a step, reported at its end. docs/reference/bodies.md
#pragma once

#include "base/allocator.h"
#include "collision/colliders.h"
#include "collision/contact_cache.h"
#include "langevin_rigid.h"

#include <algorithm>
#include <cstdint>

namespace lr {

class Batch;

// Events of the last step. Beyond the capacity they are only counted.
struct EventList : StepList<lr_event> {
    uint32_t kinds = 0;
    uint64_t lost = 0, total_lost = 0;

    bool on() const { return items.size() != 0; }
    void begin_step() { count = 0, lost = 0; }
    void tell(const lr_event& event) {
        if ((kinds & 1u << (event.kind - 1)) != 0 && !add(event)) ++lost, ++total_lost;
    }
};

// By body slot, which does not change while the body lives.
class ContactEvents {
public:
    bool allocate(Allocator& allocator, uint32_t capacity);

    void begin_step(const Batch& batch, const Colliders& colliders);
    TouchNotes notes(const lr_body* ids) { return {ids, noted_.data(), met_.data(), all_}; }
    // A collider was destroyed, and its slot can get another: contacts must be compared anew.
    void recheck() { all_ = true; }

    void note(uint32_t slot, Note what) { noted_[slot] |= what; }
    // Undoes a note: the body was put back to sleep before it moved.
    void take_back(uint32_t slot, Note what) { noted_[slot] &= static_cast<uint8_t>(~what); }
    // Called before a body ends, at most once per body and step. for_fault: it diverged.
    void note_ended(const Batch& batch, uint32_t index, bool for_fault);
    // For a slot with a new body, or with none.
    void clear(uint32_t slot);
    // Takes over the contacts in the batch's arrays without reporting them.
    void resume(const Batch& batch, const Colliders& colliders);

    // For snapshots between steps. 0 if everything follows from the batch's arrays; else bits that resume() takes, with both arrays.
    uint32_t pending(const Batch& batch, const Colliders& colliders) const;
    static bool consistent(uint32_t pending) { return pending <= (pending_any | pending_all | pending_looks); }
    static constexpr uint32_t held_bytes = sizeof(lr_collider) * most_touches;
    void* noted() { return noted_.data(); }
    void* held() { return held_.data(); }
    void resume(uint32_t pending, const void* noted, const void* held);

    // At the end of a world step. stepped: the batch took part in it. ended: LR_EVENT_KILLED or LR_EVENT_RESPAWNED.
    void tell(const Batch& batch, lr_batch handle, const Colliders& colliders, bool stepped, int32_t ended,
              EventList& to);

private:
    struct Ended {
        lr_body body;
        uint64_t user;
        float position[3];
        uint8_t notes;
    };
    // A body, living or ended, in reporting order.
    struct Entry {
        uint32_t noise_seed, slot;
        uint32_t at; // dense index, or index in ended_
    };
    enum : uint32_t { pending_any = 1, pending_all = 2, pending_looks = 4 };
    static constexpr uint32_t ended_bit = 1u << 31; // above every index
    struct Held {
        lr_collider collider[most_touches]; // 0 after the last
        bool has(lr_collider one) const {
            return std::find(collider, collider + most_touches, one) != collider + most_touches;
        }
    };
    static_assert(sizeof(Held) == held_bytes);
    void begin();
    Held now_held(const Batch& batch, uint32_t index, const Colliders& colliders) const;
    Held still_held(uint32_t slot, const Colliders& colliders) const;
    void tell_body(const Batch& batch, uint32_t index, lr_batch handle, const Colliders& colliders, bool stepped,
                   EventList& to);

    Buffer<uint8_t> noted_;
    Buffer<Held> held_; // contacts at the end of the last step
    Buffer<Meetings> met_;
    StepList<Ended> ended_;
    StepList<Entry> entries_;
    bool all_ = false, looks_ = false;
};
} // namespace lr
