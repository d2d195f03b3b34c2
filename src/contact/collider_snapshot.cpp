#include "contact/collider_snapshot.h"

#include "contact/collider_limits.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace lr {
namespace {

struct SavedList {
    uint32_t slots, count;
    uint32_t free_first, free_last;
};
struct SavedSlot {
    uint32_t generation;
    uint32_t link; // the next free slot, or `taken`
};
constexpr uint32_t taken = UINT32_MAX - 1, none = UINT32_MAX;
static_assert(LR_MAX_COLLIDERS < taken);

struct SavedCollider {
    uint64_t data; // hash of hull, heightfield or mesh; else 0
    int32_t kind;
    uint32_t pending;
    float size[3];
    float friction, restitution;
    uint32_t layers;
    Pose begin, end;
    Vector linear, angular, rest;
    uint32_t fresh;
};
static_assert(sizeof(SavedList) % 8 == 0 && sizeof(SavedSlot) % 8 == 0 && sizeof(SavedCollider) % 8 == 0);

template <class T> T at(const unsigned char* from, uint64_t index) {
    T value;
    std::memcpy(static_cast<void*>(&value), from + index * sizeof(T), sizeof(T));
    return value;
}

bool has_data(ColliderKind kind) {
    return kind == ColliderKind::hull || kind == ColliderKind::heightfield || kind == ColliderKind::mesh;
}
bool near(Vector v, Vector most) {
    return std::abs(v.x) <= most.x && std::abs(v.y) <= most.y && std::abs(v.z) <= most.z; // false for NaN
}
bool zero(Vector v) {
    return near(v, {0.0f, 0.0f, 0.0f});
}

// Steps may take colliders farther than they can be put, as far as `advanced` does.
bool consistent(const Pose& pose) {
    const Rotation& q = pose.rotation;
    const float n = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
    return near(pose.position, {farthest_place, farthest_place, farthest_place}) && n > 0.999f && n < 1.001f;
}
// What rounding has taken from a position is less than its last digit.
bool is_rest(Vector rest, Vector of) {
    const auto most = [](float x) { return 0x1p-23f * std::abs(x) + 1e-37f; };
    return near(rest, {most(of.x), most(of.y), most(of.z)});
}

bool consistent(const SavedCollider& c) {
    if (c.kind < LR_COLLIDER_PLANE || c.kind > LR_COLLIDER_MESH || c.pending > 1 || c.fresh > 1) return false;
    for (int i = sizes_of(c.kind); i < 3; ++i)
        if (c.size[i] != 0.0f) return false;
    const bool still = zero(c.linear) && zero(c.angular);
    return consistent(c.begin) && consistent(c.end) && is_rest(c.rest, c.begin.position) &&
           !wrong_sizes(c.kind, c.size) && !wrong_surface(c.friction, c.restitution) &&
           !wrong_velocity({c.linear.x, c.linear.y, c.linear.z}, {c.angular.x, c.angular.y, c.angular.z}) &&
           (c.pending == 0 || still);
}

// Free slots make one chain from the first to the last.
bool consistent(const SavedList& list, const unsigned char* slots) {
    uint32_t free = 0;
    for (uint32_t i = 0; i < list.slots; ++i) {
        const SavedSlot s = at<SavedSlot>(slots, i);
        if (s.generation == 0) return false;
        if (s.link != taken) ++free;
    }
    if (free != list.slots - list.count) return false;
    if (free == 0) return list.free_first == none && list.free_last == none;
    uint32_t slot = list.free_first;
    for (uint32_t i = 0; i < free; ++i) {
        if (slot >= list.slots) return false;
        const uint32_t next = at<SavedSlot>(slots, slot).link;
        if (next == taken || (i + 1 == free) != (next == none) || (next == none && slot != list.free_last))
            return false;
        slot = next;
    }
    return true;
}

} // namespace

uint64_t ColliderSnapshot::bytes(const Colliders& c) {
    return sizeof(SavedList) + sizeof(SavedSlot) * uint64_t{c.used_} + sizeof(SavedCollider) * uint64_t{c.count_};
}

// Calls write(record) for the list, the slots and the colliders, in their order, while it returns true.
template <class Write> bool ColliderSnapshot::visit(const Colliders& c, Write&& write) {
    if (!write(SavedList{c.used_, c.count_, c.free_first_, c.free_last_})) return false;
    for (uint32_t i = 0; i < c.used_; ++i) {
        const Colliders::Slot& s = c.slots_[i];
        if (!write(SavedSlot{s.generation, s.where == Colliders::Where::free ? s.link : taken})) return false;
    }
    for (uint32_t i = 0; i < c.used_; ++i) {
        const Colliders::Slot& s = c.slots_[i];
        if (s.where == Colliders::Where::free) continue;
        const Collider& collider = c.colliders_[i];
        const ColliderMotion& m = c.motions_[i];
        SavedCollider saved{};
        saved.data = s.shared ? s.shared->hash : 0;
        saved.kind = static_cast<int32_t>(collider.geometry.kind);
        saved.pending = m.pending ? 1 : 0;
        std::copy_n(collider.geometry.size, 3, saved.size);
        saved.friction = collider.friction;
        saved.restitution = collider.restitution;
        saved.layers = collider.layers;
        saved.begin = collider.begin;
        saved.end = m.pending ? collider.end : collider.begin;
        saved.linear = m.linear;
        saved.angular = m.angular;
        saved.rest = m.rest;
        saved.fresh = s.fresh ? 1 : 0;
        if (!write(saved)) return false;
    }
    return true;
}

void ColliderSnapshot::save(const Colliders& c, unsigned char* to) {
    visit(c, [&](const auto& record) {
        std::memcpy(to, &record, sizeof record);
        to += sizeof record;
        return true;
    });
}

// Records are of the same number of bytes up to the first that differs: the list comes first.
bool ColliderSnapshot::is_there(const unsigned char* from) const {
    return visit(*to_, [&](const auto& record) {
        // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): bit for bit, as it was written
        const bool same = std::memcmp(from, &record, sizeof record) == 0;
        from += sizeof record;
        return same;
    });
}

uint64_t ColliderSnapshot::bytes(const unsigned char* from, uint64_t size) {
    if (size < sizeof(SavedList)) return 0;
    const auto list = at<SavedList>(from, 0);
    const uint64_t used =
        sizeof list + sizeof(SavedSlot) * uint64_t{list.slots} + sizeof(SavedCollider) * uint64_t{list.count};
    return list.slots <= LR_MAX_COLLIDERS && list.count <= list.slots && used <= size ? used : 0;
}

lr_status ColliderSnapshot::read(const unsigned char* from, uint64_t size, uint64_t& used) {
    used = bytes(from, size);
    if (used == 0) return LR_ERROR_SNAPSHOT_FORMAT;
    from_ = from;
    same_ = is_there(from);
    if (same_) return LR_OK;
    const auto list = at<SavedList>(from, 0);
    const unsigned char* const slots = from + sizeof list;
    const unsigned char* const colliders = slots + sizeof(SavedSlot) * uint64_t{list.slots};
    if (!consistent(list, slots)) return LR_ERROR_SNAPSHOT_FORMAT;
    uint64_t proxies = 0, movers = 0, unbounded = 0;
    bool there = true;
    for (uint32_t i = 0; i < list.count; ++i) {
        const auto saved = at<SavedCollider>(colliders, i);
        if (!consistent(saved)) return LR_ERROR_SNAPSHOT_FORMAT;
        const auto kind = static_cast<ColliderKind>(saved.kind);
        const SharedGeometry* const shared = has_data(kind) ? to_->geometries_.find(kind, saved.data) : nullptr;
        there = there && (shared || !has_data(kind));
        if (!has_data(kind) && saved.data != 0) return LR_ERROR_SNAPSHOT_FORMAT;
        if (kind == ColliderKind::plane || kind == ColliderKind::heightfield) {
            ++unbounded;
            continue;
        }
        const uint64_t n = kind == ColliderKind::mesh && shared ? shared->parts.size() : 1;
        proxies += n;
        if (saved.pending != 0 || !zero(saved.linear) || !zero(saved.angular)) movers += n;
    }
    if (!there) return LR_ERROR_SNAPSHOT_MISMATCH;
    if (proxies > INT32_MAX) return LR_ERROR_SNAPSHOT_FORMAT;
    if (!to_->reserve_slots(list.slots) || !to_->reserve_grids(proxies, movers) || !to_->reserve_unbounded(unbounded))
        return LR_ERROR_OUT_OF_MEMORY;
    return LR_OK;
}

bool ColliderSnapshot::any() const {
    return at<SavedList>(from_, 0).count != 0;
}

void ColliderSnapshot::commit() {
    if (same_) return;
    Colliders& c = *to_;
    const auto list = at<SavedList>(from_, 0);
    const unsigned char* const slots = from_ + sizeof list;
    const unsigned char* const colliders = slots + sizeof(SavedSlot) * uint64_t{list.slots};
    // Data is taken before any is given back: the same may be both.
    for (uint32_t i = 0; i < list.count; ++i) {
        const auto saved = at<SavedCollider>(colliders, i);
        const auto kind = static_cast<ColliderKind>(saved.kind);
        if (has_data(kind)) ++c.geometries_.find(kind, saved.data)->users;
    }
    for (uint32_t i = 0; i < c.used_; ++i)
        if (c.slots_[i].where != Colliders::Where::free) c.geometries_.release(c.slots_[i].shared);
    c.used_ = list.slots;
    c.count_ = list.count;
    c.free_first_ = list.free_first;
    c.free_last_ = list.free_last;
    c.active_count_ = c.unbounded_count_ = 0;
    c.proxies_ = c.mover_proxies_ = c.still_proxies_ = c.debt_ = 0;
    c.still_grid_.clear();
    c.active_grid_.clear();
    c.near_ = NearColliders{};
    c.stale_ = true;
    c.any_fresh_ = false;
    uint32_t next = 0;
    for (uint32_t slot = 0; slot < list.slots; ++slot) {
        const auto saved_slot = at<SavedSlot>(slots, slot);
        c.slots_[slot] = {nullptr, saved_slot.generation, saved_slot.link, Colliders::Where::free, false, false};
        if (saved_slot.link != taken) continue;
        const auto saved = at<SavedCollider>(colliders, next++);
        const auto kind = static_cast<ColliderKind>(saved.kind);
        SharedGeometry* const shared = has_data(kind) ? c.geometries_.find(kind, saved.data) : nullptr;
        c.slots_[slot].shared = shared;
        Collider& collider = c.colliders_[slot];
        collider = {{kind, {saved.size[0], saved.size[1], saved.size[2]}, nullptr, nullptr, nullptr},
                    saved.begin,
                    saved.pending != 0 ? saved.end : saved.begin,
                    saved.friction,
                    saved.restitution,
                    saved.layers,
                    false};
        set_shared(collider.geometry, shared);
        c.motions_[slot] = {saved.linear, saved.angular, saved.rest, saved.pending != 0};
        const uint32_t proxies = c.proxies_of(slot);
        c.proxies_ += proxies;
        if (c.moving(slot)) c.mover_proxies_ += proxies;
        c.enlist(slot);
        c.slots_[slot].fresh = saved.fresh != 0;
        c.any_fresh_ = c.any_fresh_ || saved.fresh != 0;
    }
}

} // namespace lr
