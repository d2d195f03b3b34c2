#include "collision/colliders.h"

#include "base/counter_random.h"
#include "base/handles.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace lr {
namespace {

constexpr uint64_t least_active = 1024; // least room in the grid that is rebuilt in each step

uint64_t grown(uint64_t from, uint64_t to) {
    return to <= from ? from : std::max(to, from + from / 2);
}
} // namespace

void Colliders::set_shared(uint32_t slot, SharedGeometry* shared) {
    slots_[slot].shared = shared;
    Geometry& geometry = colliders_[slot].geometry;
    geometry.hull = shared && shared->kind == ColliderKind::hull ? &shared->hull : nullptr;
    geometry.heightfield = shared && shared->kind == ColliderKind::heightfield ? &shared->heightfield : nullptr;
    geometry.mesh = shared && shared->kind == ColliderKind::mesh ? &shared->mesh : nullptr;
}

Colliders::~Colliders() {
    for (uint32_t i = 0; i < used_; ++i)
        if (slots_[i].where != Where::free) geometries_.release(slots_[i].shared);
}

bool Colliders::reserve_slots(uint32_t slots) {
    const uint64_t size = std::min<uint64_t>(grown(slots_.size(), slots), LR_MAX_COLLIDERS);
    return enlarge(*allocator_, colliders_, size, used_) && enlarge(*allocator_, motions_, size, used_) &&
           enlarge(*allocator_, active_.slots, size, active_.count) && enlarge(*allocator_, slots_, size, used_);
}

bool Colliders::reserve_unbounded(uint64_t count) {
    return enlarge(*allocator_, unbounded_.slots, grown(unbounded_.slots.size(), count), unbounded_.count);
}

// Grids that grow are empty until the next step.
bool Colliders::reserve_grids(uint64_t proxies, uint64_t movers) {
    const uint64_t active = std::max(std::min(proxies, least_active), movers);
    if (proxies > still_grid_.capacity() || active > active_grid_.capacity()) {
        near_ = NearColliders{};
        stale_ = true;
    }
    return still_grid_.reserve(*allocator_, proxies) && active_grid_.reserve(*allocator_, active);
}

uint32_t Colliders::next_slot(Cursor& cursor) const {
    if (cursor.free == none) return cursor.used++;
    const uint32_t slot = cursor.free;
    cursor.free = slots_[slot].link;
    return slot;
}

uint32_t Colliders::proxies_of(uint32_t slot) const {
    const ColliderKind kind = colliders_[slot].geometry.kind;
    if (is_ground(kind)) return 0;
    return kind == ColliderKind::mesh ? static_cast<uint32_t>(slots_[slot].shared->parts.size()) : 1;
}

lr_status Colliders::begin_create(uint32_t count) {
    staging_ = {free_first_, used_};
    staged_ = 0;
    last_shared_ = nullptr;
    if (count > LR_MAX_COLLIDERS - count_) return LR_ERROR_CAPACITY;
    // Free slots are reused first, so no more than used_ or the count are needed.
    return reserve_slots(std::max(used_, count_ + count)) ? LR_OK : LR_ERROR_OUT_OF_MEMORY;
}

lr_status Colliders::create(const lr_collider_desc& desc) {
    SharedGeometry* shared = nullptr;
    const auto kind = static_cast<ColliderKind>(desc.kind);
    if (has_data(kind)) {
        if (last_shared_ && same_arrays(desc, last_desc_)) {
            shared = last_shared_;
            ++shared->users;
        } else {
            const lr_status status = geometries_.acquire(desc, shared);
            if (status != LR_OK) return status;
            last_desc_ = desc;
            last_shared_ = shared;
        }
    }
    const uint32_t slot = next_slot(staging_);
    if (slot >= used_) slots_[slot] = {nullptr, 1, none, Where::free, false, false};
    const Pose pose{vector_of(desc.position), unit_rotation(desc.orientation)};
    const Geometry geometry{kind, {desc.size[0], desc.size[1], desc.size[2]}, nullptr, nullptr, nullptr};
    colliders_[slot] = {geometry, pose, pose, desc.friction, desc.restitution, desc.layers, false};
    set_shared(slot, shared);
    motions_[slot] = {vector_of(desc.linear_velocity), vector_of(desc.angular_velocity), {}, false};
    ++staged_;
    return LR_OK;
}

lr_status Colliders::finish_create(lr_collider* ids) {
    uint64_t proxies = proxies_, movers = mover_proxies_, unbounded = unbounded_.count;
    Cursor cursor{free_first_, used_};
    for (uint32_t i = 0; i < staged_; ++i) {
        const uint32_t slot = next_slot(cursor), n = proxies_of(slot);
        proxies += n;
        if (moving(slot)) movers += n;
        if (is_ground(colliders_[slot].geometry.kind)) ++unbounded;
    }
    if (proxies > INT32_MAX) return LR_ERROR_CAPACITY;
    if (!reserve_grids(proxies, movers) || !reserve_unbounded(unbounded)) return LR_ERROR_OUT_OF_MEMORY;
    for (uint32_t i = 0; i < staged_; ++i) {
        Cursor at{free_first_, used_};
        const uint32_t slot = next_slot(at);
        free_first_ = at.free;
        if (free_first_ == none) free_last_ = none;
        used_ = at.used;
        enlist(slot);
        slots_[slot].fresh = any_fresh_ = true;
        if (ids) ids[i] = id(slot);
    }
    count_ += staged_;
    proxies_ = proxies;
    mover_proxies_ = movers;
    staged_ = 0;
    return LR_OK;
}

void Colliders::cancel_create() {
    Cursor cursor{free_first_, used_};
    for (uint32_t i = 0; i < staged_; ++i) {
        const uint32_t slot = next_slot(cursor);
        geometries_.release(slots_[slot].shared);
        slots_[slot].shared = nullptr;
    }
    staged_ = 0;
}

// Adds it to its list, which has room.
void Colliders::enlist(uint32_t slot) {
    List& list = list_of(slot);
    slots_[slot].where = &list == &unbounded_ ? Where::unbounded : Where::active;
    slots_[slot].link = list.count;
    list.slots[list.count++] = slot;
}

void Colliders::delist(uint32_t slot) {
    const Slot& s = slots_[slot];
    if (s.where == Where::still) {
        still_proxies_ -= proxies_of(slot);
        return;
    }
    List& list = list_of(slot);
    const uint32_t last = list.slots[--list.count];
    list.slots[s.link] = last;
    slots_[last].link = s.link;
}

void Colliders::sort_lists() {
    for (List* list : {&active_, &unbounded_}) {
        uint32_t* const slots = list->slots.data();
        if (std::is_sorted(slots, slots + list->count)) continue;
        std::sort(slots, slots + list->count);
        for (uint32_t i = 0; i < list->count; ++i) slots_[slots[i]].link = i;
    }
}

lr_collider Colliders::id(uint32_t slot) const {
    return pack(ColliderHandle{slot, slots_[slot].generation});
}

bool Colliders::find(lr_collider collider, uint32_t& slot) const {
    const ColliderHandle h = unpack(collider);
    if (h.slot >= used_ || slots_[h.slot].where == Where::free || slots_[h.slot].generation != h.generation)
        return false;
    slot = h.slot;
    return true;
}

bool Colliders::can_destroy(const lr_collider* ids, uint32_t count) {
    // Marks each id; a stale or marked one is an error.
    uint32_t slot = 0, marked = 0;
    for (; marked < count; ++marked) {
        if (!find(ids[marked], slot) || slots_[slot].marked) break;
        slots_[slot].marked = true;
    }
    for (uint32_t i = 0; i < marked; ++i) slots_[unpack(ids[i]).slot].marked = false;
    return marked == count;
}

void Colliders::destroy(const lr_collider* ids, uint32_t count) {
    for (uint32_t i = 0; i < count; ++i) release(unpack(ids[i]).slot);
}

void Colliders::release(uint32_t slot) {
    Slot& s = slots_[slot];
    const uint32_t proxies = proxies_of(slot);
    if (moving(slot)) mover_proxies_ -= proxies;
    proxies_ -= proxies;
    delist(slot);
    geometries_.release(s.shared);
    // Appends the slot to the queue, so that the one unused for longest is reused first.
    s = {nullptr, s.generation == UINT32_MAX ? 1 : s.generation + 1, none, Where::free, false, false};
    if (free_first_ == none)
        free_first_ = slot;
    else
        slots_[free_last_].link = slot;
    free_last_ = slot;
    --count_;
}

void Colliders::reserve_move(uint32_t slot, const lr_collider_motion& m) {
    const ColliderMotion next{vector_of(m.linear_velocity), vector_of(m.angular_velocity), {}, m.mode == LR_MOVE_TO};
    if (next.moves() && !moving(slot)) reserved_ += proxies_of(slot);
}

bool Colliders::finish_reserve() {
    return reserve_grids(proxies_, std::min(reserved_, proxies_));
}

void Colliders::move(uint32_t slot, const lr_collider_motion& motion) {
    Collider& c = colliders_[slot];
    ColliderMotion& m = motions_[slot];
    const uint32_t proxies = proxies_of(slot);
    if (moving(slot)) mover_proxies_ -= proxies;
    const Pose pose =
        motion.mode == LR_MOVE_VELOCITY ? c.begin : Pose{vector_of(motion.position), unit_rotation(motion.orientation)};
    if (motion.mode == LR_MOVE_TO) {
        c.end = {pose.position, nearer_to(c.begin.rotation, pose.rotation)};
        m.linear = m.angular = {0.0f, 0.0f, 0.0f};
        // A collider told to stay keeps nothing awake. NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): -0 for 0 only moves it once more
        m.pending = std::memcmp(&c.begin, &c.end, sizeof c.end) != 0;
    } else {
        c.begin = c.end = pose;
        m.linear = vector_of(motion.linear_velocity);
        m.angular = vector_of(motion.angular_velocity);
        m.pending = false;
    }
    if (motion.mode != LR_MOVE_VELOCITY) m.remainder = {0.0f, 0.0f, 0.0f};
    if (moving(slot)) mover_proxies_ += proxies;
    if (slots_[slot].where == Where::still && (moving(slot) || motion.mode == LR_MOVE_PLACE)) {
        delist(slot);
        enlist(slot);
    }
    if (motion.mode == LR_MOVE_PLACE) slots_[slot].fresh = any_fresh_ = true;
}

void Colliders::set_surface(uint32_t slot, float friction, float restitution, uint32_t layers) {
    Collider& c = colliders_[slot];
    c.friction = friction;
    c.restitution = restitution;
    c.layers = layers;
}

ColliderRecord Colliders::record(uint32_t slot) const {
    const Collider& c = colliders_[slot];
    const ColliderMotion& m = motions_[slot];
    const float(&size)[3] = c.geometry.size;
    const SharedGeometry* const shared = slots_[slot].shared;
    return {static_cast<int32_t>(c.geometry.kind),
            {size[0], size[1], size[2]},
            shared ? shared->hash : 0,
            c.begin,
            m.pending ? c.end : c.begin,
            m.linear,
            m.angular,
            m.remainder,
            c.friction,
            c.restitution,
            c.layers,
            m.pending,
            slots_[slot].fresh};
}

uint64_t Colliders::hash() const {
    uint64_t sum = 0;
    for (uint32_t slot = 0; slot < used_; ++slot) {
        if (slots_[slot].where == Where::free) continue;
        const ColliderRecord r = record(slot);
        uint32_t words[sizeof r / 4];
        std::memcpy(words, &r, sizeof r);
        uint64_t one = mix64(id(slot).id + 0x9e3779b97f4a7c15ull);
        const auto word = [&](uint64_t w) { one = mix64(one ^ w) + 0x9e3779b97f4a7c15ull; };
        const auto fields = [&](size_t from, size_t to) {
            for (size_t i = from / 4; i < to / 4; ++i) word(words[i]);
        };
        fields(0, offsetof(ColliderRecord, data));
        word(r.data);
        fields(offsetof(ColliderRecord, begin), offsetof(ColliderRecord, end));
        if (r.pending != 0) fields(offsetof(ColliderRecord, end), offsetof(ColliderRecord, linear));
        fields(offsetof(ColliderRecord, linear), offsetof(ColliderRecord, pending));
        sum += one;
    }
    return count_ == 0 ? 0 : mix64(sum ^ count_) | 1;
}
} // namespace lr
