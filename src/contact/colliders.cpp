#include "contact/colliders.h"

#include "contact/collider_motion.h"
#include "world/handles.h"
#include "world/mix.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace lr {
namespace {

constexpr uint64_t least_active = 1024; // room in the grid that is built anew in each step

Rotation unit(const float (&q)[4]) {
    double n = 0.0;
    for (float e : q) n += static_cast<double>(e) * static_cast<double>(e);
    n = std::sqrt(n);
    // A quaternion that is a unit one already keeps its bits.
    if (std::abs(n - 1.0) < 1e-7) return {q[0], q[1], q[2], q[3]};
    return {static_cast<float>(static_cast<double>(q[0]) / n), static_cast<float>(static_cast<double>(q[1]) / n),
            static_cast<float>(static_cast<double>(q[2]) / n), static_cast<float>(static_cast<double>(q[3]) / n)};
}
Vector vector(const float (&v)[3]) {
    return {v[0], v[1], v[2]};
}
bool zero(Vector v) {
    return v.x == 0.0f && v.y == 0.0f && v.z == 0.0f;
}
bool has_data(int32_t kind) {
    return kind == LR_COLLIDER_HULL || kind == LR_COLLIDER_HEIGHTFIELD || kind == LR_COLLIDER_MESH;
}
bool finite_kind(ColliderKind kind) {
    return kind != ColliderKind::plane && kind != ColliderKind::heightfield;
}

template <class T> bool enlarge(Allocator& allocator, Buffer<T>& buffer, uint64_t size, size_t used) {
    if (size <= buffer.size()) return true;
    Buffer<T> larger;
    if (!larger.allocate(allocator, size)) return false;
    std::copy_n(buffer.data(), used, larger.data());
    buffer.swap(larger);
    return true;
}

uint64_t grown(uint64_t from, uint64_t to) {
    return to <= from ? from : std::max(to, from + from / 2);
}

} // namespace

void set_shared(Geometry& geometry, const SharedGeometry* shared) {
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
           enlarge(*allocator_, active_, size, active_count_) && enlarge(*allocator_, slots_, size, used_);
}

bool Colliders::reserve_unbounded(uint64_t count) {
    return enlarge(*allocator_, unbounded_, grown(unbounded_.size(), count), unbounded_count_);
}

// Grids that take other memory lose what they hold until the next step.
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
    if (!finite_kind(kind)) return 0;
    return kind == ColliderKind::mesh ? static_cast<uint32_t>(slots_[slot].shared->parts.size()) : 1;
}

bool Colliders::moving(uint32_t slot) const {
    const ColliderMotion& m = motions_[slot];
    return m.pending || !zero(m.linear) || !zero(m.angular);
}

lr_status Colliders::begin_create(uint32_t count) {
    staging_ = {free_first_, used_};
    staged_ = 0;
    last_shared_ = nullptr;
    if (count > LR_MAX_COLLIDERS - count_) return LR_ERROR_CAPACITY;
    // Slots that are free, in the queue, are within the used part.
    return reserve_slots(std::max(used_, count_ + count)) ? LR_OK : LR_ERROR_OUT_OF_MEMORY;
}

lr_status Colliders::create(const lr_collider_desc& desc) {
    SharedGeometry* shared = nullptr;
    if (has_data(desc.kind)) {
        const lr_collider_desc& last = last_desc_;
        const bool same = last_shared_ && desc.kind == last.kind && desc.vertices == last.vertices &&
                          desc.indices == last.indices && desc.heights == last.heights &&
                          desc.vertex_count == last.vertex_count && desc.triangle_count == last.triangle_count &&
                          std::equal(desc.counts, desc.counts + 2, last.counts) &&
                          std::equal(desc.spacing, desc.spacing + 2, last.spacing);
        if (same) {
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
    slots_[slot].shared = shared;
    Collider& c = colliders_[slot];
    c.geometry = {
        static_cast<ColliderKind>(desc.kind), {desc.size[0], desc.size[1], desc.size[2]}, nullptr, nullptr, nullptr};
    set_shared(c.geometry, shared);
    c.begin = c.end = {vector(desc.position), unit(desc.orientation)};
    c.friction = desc.friction;
    c.restitution = desc.restitution;
    c.layers = desc.layers;
    c.moves = false;
    motions_[slot] = {vector(desc.linear_velocity), vector(desc.angular_velocity), {0.0f, 0.0f, 0.0f}, false};
    ++staged_;
    return LR_OK;
}

lr_status Colliders::finish_create(lr_collider* ids) {
    uint64_t proxies = proxies_, movers = mover_proxies_, unbounded = unbounded_count_;
    Cursor cursor{free_first_, used_};
    for (uint32_t i = 0; i < staged_; ++i) {
        const uint32_t slot = next_slot(cursor), n = proxies_of(slot);
        proxies += n;
        if (moving(slot)) movers += n;
        if (!finite_kind(colliders_[slot].geometry.kind)) ++unbounded;
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

// Into the list that it belongs to, where there is room.
void Colliders::enlist(uint32_t slot) {
    const bool finite = finite_kind(colliders_[slot].geometry.kind);
    slots_[slot].where = finite ? Where::active : Where::unbounded;
    slots_[slot].link = finite ? active_count_ : unbounded_count_;
    if (finite)
        active_[active_count_++] = slot;
    else
        unbounded_[unbounded_count_++] = slot;
}

void Colliders::delist(uint32_t slot) {
    const Slot& s = slots_[slot];
    if (s.where == Where::still) {
        still_proxies_ -= proxies_of(slot);
        return;
    }
    const bool finite = s.where == Where::active;
    Buffer<uint32_t>& list = finite ? active_ : unbounded_;
    uint32_t& size = finite ? active_count_ : unbounded_count_;
    const uint32_t last = list[--size];
    list[s.link] = last;
    slots_[last].link = s.link;
}

lr_collider Colliders::id(uint32_t slot) const {
    return pack(ColliderHandle{slot, slots_[slot].generation});
}

bool Colliders::find(lr_collider collider, uint32_t& slot) const {
    const ColliderHandle h = unpack_collider(collider);
    if (h.slot >= used_ || slots_[h.slot].where == Where::free || slots_[h.slot].generation != h.generation)
        return false;
    slot = h.slot;
    return true;
}

bool Colliders::can_destroy(const lr_collider* ids, uint32_t count) {
    // Every one is marked first, and one that is stale or marked already ends it.
    uint32_t slot = 0, marked = 0;
    for (; marked < count; ++marked) {
        if (!find(ids[marked], slot) || slots_[slot].marked) break;
        slots_[slot].marked = true;
    }
    for (uint32_t i = 0; i < marked; ++i) slots_[unpack_collider(ids[i]).slot].marked = false;
    return marked == count;
}

lr_status Colliders::destroy(const lr_collider* ids, uint32_t count) {
    if (!can_destroy(ids, count)) return LR_ERROR_STALE_COLLIDER;
    for (uint32_t i = 0; i < count; ++i) release(unpack_collider(ids[i]).slot);
    return LR_OK;
}

void Colliders::release(uint32_t slot) {
    Slot& s = slots_[slot];
    const uint32_t proxies = proxies_of(slot);
    if (moving(slot)) mover_proxies_ -= proxies;
    proxies_ -= proxies;
    delist(slot);
    geometries_.release(s.shared);
    // The longest unused slot is the next one to be used.
    s = {nullptr, s.generation == UINT32_MAX ? 1 : s.generation + 1, none, Where::free, false, false};
    if (free_first_ == none)
        free_first_ = slot;
    else
        slots_[free_last_].link = slot;
    free_last_ = slot;
    --count_;
}

void Colliders::reserve_move(uint32_t slot, const lr_collider_motion& motion) {
    const bool moves =
        motion.mode == LR_MOVE_TO || !zero(vector(motion.linear_velocity)) || !zero(vector(motion.angular_velocity));
    if (moves && !moving(slot)) reserved_ += proxies_of(slot);
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
        motion.mode == LR_MOVE_VELOCITY ? c.begin : Pose{vector(motion.position), unit(motion.orientation)};
    if (motion.mode == LR_MOVE_TO) {
        c.end = {pose.position, nearer_to(c.begin.rotation, pose.rotation)};
        m.linear = m.angular = {0.0f, 0.0f, 0.0f};
        m.pending = true;
    } else {
        c.begin = c.end = pose;
        m.linear = vector(motion.linear_velocity);
        m.angular = vector(motion.angular_velocity);
        m.pending = false;
    }
    if (motion.mode != LR_MOVE_VELOCITY) m.rest = {0.0f, 0.0f, 0.0f};
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

uint64_t Colliders::hash() const {
    uint64_t sum = 0;
    for (uint32_t slot = 0; slot < used_; ++slot) {
        if (slots_[slot].where == Where::free) continue;
        const Collider& c = colliders_[slot];
        const ColliderMotion& m = motions_[slot];
        uint64_t one = mix64(id(slot) + 0x9e3779b97f4a7c15ull);
        const auto word = [&](uint64_t w) { one = mix64(one ^ w) + 0x9e3779b97f4a7c15ull; };
        const auto number = [&](float x) { word(std::bit_cast<uint32_t>(x)); };
        const auto numbers = [&](Vector v) { number(v.x), number(v.y), number(v.z); };
        const auto pose = [&](const Pose& p) {
            numbers(p.position);
            for (float q : {p.rotation.x, p.rotation.y, p.rotation.z, p.rotation.w}) number(q);
        };
        word(static_cast<uint64_t>(c.geometry.kind));
        for (float s : c.geometry.size) number(s);
        word(slots_[slot].shared ? slots_[slot].shared->hash : 0);
        pose(c.begin);
        if (m.pending) pose(c.end);
        numbers(m.linear);
        numbers(m.angular);
        numbers(m.rest);
        number(c.friction);
        number(c.restitution);
        word(c.layers);
        sum += one;
    }
    return count_ == 0 ? 0 : mix64(sum ^ count_) | 1;
}

} // namespace lr
