// The water surface: plane, waves in time, and the caller's callback. docs/reference/wind_and_water.md.
#pragma once

#include "base/pose.h"
#include "environment/field_callback.h"
#include "kernel/limits.h"
#include "kernel/water/water_loads.h"
#include "langevin_rigid.h"

#include <cstdint>
#include <type_traits>

namespace lr {

Outcome check_water(const lr_water_desc& desc);

class Water : public Callback<std::remove_pointer_t<lr_water_fn>> {
public:
    // Saved in snapshots.
    struct Record {
        uint32_t present, reserved;
        double frequency[LR_MAX_WAVES]; // rad/s
        double drift[3];                // m: currents have carried the waves by current * time + drift
        lr_water_desc desc;
    };
    static bool consistent(const Record& record);
    Record record() const { return record_; }
    void restore(const Record& record) { record_ = record.present != 0 ? record : Record{}; }

    bool present() const { return record_.present != 0; }
    const lr_water_desc& desc() const { return record_.desc; }
    // The desc must be valid. The waves stay where they are at `time` if the current changes.
    void set(const lr_water_desc& desc, const float gravity[3], double time);
    void clear() { record_ = Record{}; }

    SurfaceInstant at(double time) const;
    float highest() const; // m above the plane
    // Whether the change from `before` affects a body at rest in this box.
    bool changes(const Record& before, const Box& box) const;
    uint64_t hash() const; // 0 without water

    // Calls the callback for the first `count` bodies of a block, which holds the values of plane and waves. Any thread.
    void ask(double time, lr_batch batch, uint32_t count, const SurfaceInstant& plane, SurfaceBlock& block);

private:
    Record record_{};
};
static_assert(sizeof(Water::Record) % 8 == 0);
} // namespace lr
