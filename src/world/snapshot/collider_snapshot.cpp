#include "world/snapshot/snapshot_format.h"

#include "collision/colliders.h"
#include "world/snapshot/snapshot_bytes.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace lr {
namespace {

static_assert(sizeof(ColliderRecord) == 136, "no padding: records are compared bit for bit");

bool near(Vector v, Vector most) {
    return std::abs(v.x) <= most.x && std::abs(v.y) <= most.y && std::abs(v.z) <= most.z; // false for NaN
}

// Steps can carry colliders beyond the limit for calls, up to that of advanced().
bool consistent(const Pose& pose) {
    const float n = dot(pose.rotation, pose.rotation);
    return near(pose.position, {farthest_place, farthest_place, farthest_place}) && n > 0.999f && n < 1.001f;
}
// The rounding error carried with a position is below its last digit.
bool is_remainder(Vector remainder, Vector of) {
    const auto most = [](float x) { return 0x1p-23f * std::abs(x) + 1e-37f; };
    return near(remainder, {most(of.x), most(of.y), most(of.z)});
}

bool consistent(const ColliderRecord& c) {
    if (c.kind < LR_COLLIDER_PLANE || c.kind > LR_COLLIDER_MESH || c.pending > 1 || c.fresh > 1) return false;
    if (!has_data(static_cast<ColliderKind>(c.kind)) && c.data != 0) return false;
    for (int i = sizes_of(c.kind); i < 3; ++i)
        if (c.size[i] != 0.0f) return false;
    return consistent(c.begin) && consistent(c.end) && is_remainder(c.remainder, c.begin.position) &&
           !wrong_sizes(c.kind, c.size) && !wrong_material(c.friction, c.restitution) &&
           !wrong_velocity({c.linear.x, c.linear.y, c.linear.z}, {c.angular.x, c.angular.y, c.angular.z}) &&
           (c.pending == 0 || !ColliderMotion{c.linear, c.angular, {}, false}.moves());
}
} // namespace

ColliderRecord ColliderSnapshot::record(uint32_t i) const {
    return value_at<ColliderRecord>(slots_ + sizeof(Slot) * uint64_t{head_.slots}, i);
}
// Null if the collider has no shared geometry, or the world lacks it.
SharedGeometry* ColliderSnapshot::shared(const ColliderRecord& r) const {
    return r.data != 0 ? to_->geometries_.find(static_cast<ColliderKind>(r.kind), r.data) : nullptr;
}

// Calls write(record) for slots and colliders in order, as long as it returns true.
template <class Write> bool ColliderSnapshot::visit(const Colliders& c, Write&& write) {
    static_assert(sizeof(Slot) % 8 == 0 && LR_MAX_COLLIDERS < taken);
    for (uint32_t i = 0; i < c.used_; ++i)
        if (!write(Slot{c.slots_[i].generation, c.in_use(i) ? taken : c.slots_[i].link})) return false;
    for (uint32_t i = 0; i < c.used_; ++i)
        if (c.in_use(i) && !write(c.record(i))) return false;
    return true;
}

void ColliderSnapshot::save(const Colliders& c, unsigned char* to) {
    visit(c, [&](const auto& record) {
        std::memcpy(to, &record, sizeof record);
        to += sizeof record;
        return true;
    });
}

bool ColliderSnapshot::is_there() const {
    const unsigned char* from = slots_;
    return same(head_, head(*to_)) && visit(*to_, [&](const auto& record) {
               // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): bit for bit, as it was written
               const bool same = std::memcmp(from, &record, sizeof record) == 0;
               from += sizeof record;
               return same;
           });
}

bool ColliderSnapshot::free_slots_make_a_chain() const {
    uint32_t free = 0;
    for (uint32_t i = 0; i < head_.slots; ++i) {
        if (slot(i).generation == 0) return false;
        if (slot(i).link != taken) ++free;
    }
    const uint32_t end = free == 0 ? head_.free_first : slot(std::min(head_.free_last, head_.slots - 1)).link;
    return free == head_.slots - head_.count && (free != 0 || head_.free_last == none) && end == none &&
           make_chain(head_.free_first, head_.free_last, free, head_.slots, [&](uint32_t i) { return slot(i).link; });
}

lr_status ColliderSnapshot::read(const Head& head, const unsigned char* from, uint64_t size) {
    head_ = head;
    slots_ = from;
    if (head.slots > LR_MAX_COLLIDERS || head.count > head.slots || bytes(head) > size) return LR_ERROR_SNAPSHOT_FORMAT;
    same_ = is_there();
    if (same_) return LR_OK;
    if (!free_slots_make_a_chain()) return LR_ERROR_SNAPSHOT_FORMAT;
    uint64_t proxies = 0, movers = 0, unbounded = 0;
    bool there = true;
    for (uint32_t i = 0; i < head_.count; ++i) {
        const ColliderRecord r = record(i);
        if (!consistent(r)) return LR_ERROR_SNAPSHOT_FORMAT;
        const auto kind = static_cast<ColliderKind>(r.kind);
        const SharedGeometry* const data = shared(r);
        there = there && (data || !has_data(kind));
        if (is_ground(kind)) {
            ++unbounded;
            continue;
        }
        const uint64_t n = kind == ColliderKind::mesh && data ? data->parts.size() : 1;
        proxies += n;
        if (ColliderMotion{r.linear, r.angular, r.remainder, r.pending != 0}.moves()) movers += n;
    }
    if (!there) return LR_ERROR_SNAPSHOT_MISMATCH;
    if (proxies > INT32_MAX) return LR_ERROR_SNAPSHOT_FORMAT;
    if (!to_->reserve_slots(head_.slots) || !to_->reserve_grids(proxies, movers) || !to_->reserve_unbounded(unbounded))
        return LR_ERROR_OUT_OF_MEMORY;
    return LR_OK;
}

void ColliderSnapshot::commit() {
    if (same_) return;
    Colliders& c = *to_;
    // Acquires before it releases: both states may share data.
    for (uint32_t i = 0; i < head_.count; ++i)
        if (SharedGeometry* const data = shared(record(i))) ++data->users;
    for (uint32_t i = 0; i < c.used_; ++i)
        if (c.in_use(i)) c.geometries_.release(c.slots_[i].shared);
    c.used_ = head_.slots;
    c.count_ = head_.count;
    c.free_first_ = head_.free_first;
    c.free_last_ = head_.free_last;
    c.active_.count = c.unbounded_.count = 0;
    c.proxies_ = c.mover_proxies_ = c.still_proxies_ = c.debt_ = 0;
    c.still_grid_.clear();
    c.active_grid_.clear();
    c.near_ = NearColliders{};
    c.stale_ = true;
    c.any_fresh_ = false;
    uint32_t next = 0;
    for (uint32_t i = 0; i < head_.slots; ++i) {
        const Slot saved = slot(i);
        c.slots_[i] = {nullptr, saved.generation, saved.link, Colliders::Where::free, false, false};
        if (saved.link != taken) continue;
        const ColliderRecord r = record(next++);
        const Geometry geometry{
            static_cast<ColliderKind>(r.kind), {r.size[0], r.size[1], r.size[2]}, nullptr, nullptr, nullptr};
        c.colliders_[i] = {geometry, r.begin, r.pending != 0 ? r.end : r.begin, r.friction, r.restitution,
                           r.layers, false};
        c.set_shared(i, shared(r));
        c.motions_[i] = {r.linear, r.angular, r.remainder, r.pending != 0};
        const uint32_t proxies = c.proxies_of(i);
        c.proxies_ += proxies;
        if (c.moving(i)) c.mover_proxies_ += proxies;
        c.enlist(i);
        c.slots_[i].fresh = r.fresh != 0;
        c.any_fresh_ = c.any_fresh_ || r.fresh != 0;
    }
}
} // namespace lr
