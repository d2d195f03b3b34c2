// A step of the batches whose bodies meet each other: all through one substep, then what touches is solved together, then the
// next. docs/maintainers/contact.md
#pragma once

#include "kernel/float_mode.h"
#include "world/crowd.h"
#include "world/workers.h"

#include <atomic>
#include <cstdint>

struct lr_world;

namespace lr {

class CrowdStep {
public:
    // items: batches that go through the same substeps, at the same times.
    CrowdStep(lr_world& world, const StepItem* items, uint32_t count, const SurfaceStep* surface,
              const FloatMode& mode);
    // False when out of memory, and then nothing has been done.
    bool prepare();
    void run();
    bool starved() const { return starved_; } // for want of memory bodies went through each other

private:
    static constexpr uint32_t none = UINT32_MAX;

    CrowdMember& member_of(uint32_t body) const;
    float* before(uint32_t body, size_t field) const;
    Pose began(uint32_t body) const;
    template <class Function> void each_cut(const Function& function) const;

    void move_alone(uint32_t substep);
    void move_cut(const CrowdMember& member, uint32_t begin, uint32_t end, uint32_t substep) const;

    // world/crowd_pairs.cpp
    bool find_pairs();
    float margin_of(const CrowdMember& member, uint32_t index) const;
    bool finds(const MeetingBox& one, const MeetingBox& other, bool mutual) const;
    void set_box(const CrowdMember& member, uint32_t index);
    void keep_first(uint32_t* seen, uint32_t body) const;
    void meet(uint32_t begin, uint32_t end);
    void enter_contacts(uint32_t at, const WayContact* found);
    bool number_touching();

    // world/crowd_hold.cpp
    // Those that touch no other that moves; the others, where there is no memory to solve them together.
    enum class Held { apart, touching };
    void hold(uint32_t substep, Held which);
    void hold_group(const CrowdMember& member, uint32_t first, uint32_t substep, Held which);
    void take_out(ContactGroup& group, uint32_t lane, uint32_t place);
    bool solve();
    void fill_body(uint32_t place);
    uint32_t list_units();
    void put_back(uint32_t place, uint32_t substep);
    void wake(const BodyAfter& body, const ContactGroup::AtRest& at_rest) const;
    Touch meeting(uint32_t place, uint32_t collider) const;
    float pressed(uint32_t place, uint32_t k) const;
    bool last(uint32_t substep) const { return substep + 1 == time_.substeps; }

    lr_world* world_;
    Crowd* crowd_;
    const StepItem* items_;
    Workers workers_;
    uint32_t member_count_, body_count_ = 0, place_count_ = 0;
    StepTime time_{};
    SurfaceStep surface_{};
    bool wet_, starved_ = false;
    std::atomic<uint32_t> held_used_{0};
};

} // namespace lr
