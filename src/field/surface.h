// The surface between two fluids: its description, its waves in time, and the caller's own. docs/reference/wind_and_water.md.
#pragma once

#include "kernel/surface.h"
#include "langevin_rigid.h"

#include <atomic>
#include <cstdint>

namespace lr {

// LR_OK, or why not.
lr_status check_surface(const lr_surface_desc& desc, const char*& why);

class Surface {
public:
    // As it is in a snapshot.
    struct Record {
        uint32_t present, reserved;
        double frequency[LR_MAX_WAVES]; // rad/s
        lr_surface_desc desc;
    };
    static bool consistent(const Record& record);
    Record record() const { return record_; }
    void restore(const Record& record) { record_ = record.present != 0 ? record : Record{}; }

    bool present() const { return record_.present != 0; }
    const lr_surface_desc& desc() const { return record_.desc; }
    // The desc has been checked.
    void set(const lr_surface_desc& desc, const float gravity[3]);
    void clear() { record_ = Record{}; }

    SurfaceInstant at(double time) const;
    float highest() const; // m above the plane
    uint64_t hash() const; // 0 without a surface

    void set_callback(lr_surface_fn function, void* user);
    bool has_callback() const { return callback_ != nullptr; }
    lr_surface_fn callback() const { return callback_; }
    void* callback_user() const { return callback_user_; }
    // Another that gives the same answers: what was said of them holds.
    void replace_callback(lr_surface_fn function, void* user) { callback_ = function, callback_user_ = user; }
    // Asks the callback about the first `count` bodies of a block that holds what the plane and the waves give. From
    // any worker.
    void ask(double time, lr_batch batch, uint32_t count, const SurfaceInstant& plane, SurfaceBlock& block);
    // True once for each callback that gave what is no surface.
    bool take_blame();

private:
    Record record_{};
    lr_surface_fn callback_ = nullptr;
    void* callback_user_ = nullptr;
    std::atomic<bool> blamed_{false};
    bool told_ = false;
};
static_assert(sizeof(Surface::Record) % 8 == 0);

} // namespace lr
