#include "contact/contact_group.h"

#include "contact/mesh_contacts.h"
#include "kernel/faults.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace lr {
namespace {

// Where a body may be within so long; as in the kernel.
Box vicinity(const ContactStep& step, const BatchArrays& arrays, uint32_t i, float dt) {
    const float size = 1.5f * step.shape->reach * arrays.field[field_scale][i];
    const float speed =
        length(vector_in(arrays.field, field_vx, i)) + 0.25f * size * length(vector_in(arrays.field, field_wx, i));
    const Vector x = vector_in(arrays.field, field_x, i);
    return grown({x, x}, size + dt * (1.5f * speed + step.gain));
}
bool is_ground(const Collider& c) {
    return c.geometry.kind == ColliderKind::plane || c.geometry.kind == ColliderKind::heightfield;
}

} // namespace

const char* wrong_in(const ContactSettings& s) {
    if (!(s.friction >= 0.0f && s.friction <= 10.0f)) return "friction is not 0 to 10";
    if (!(s.restitution >= 0.0f && s.restitution <= 1.0f)) return "restitution is not 0 to 1";
    if (!(s.rolling >= 0.0f && s.rolling <= 10.0f)) return "rolling_resistance is not 0 to 10";
    return s.ground_effect >= 0.0f && s.ground_effect <= 1.0f ? nullptr : "ground_effect is not 0 to 1";
}

Pose pose_at(const Collider& c, float part) {
    if (!c.moves || part <= 0.0f) return c.begin;
    if (part >= 1.0f) return c.end;
    return {mix(c.begin.position, c.end.position, part), mix(c.begin.rotation, c.end.rotation, part)};
}

Vector SurfaceMotion::velocity_at(Vector point) const {
    return velocity + cross(spin, point - middle);
}

Vector SurfaceMotion::lag_at(Vector point) const {
    const Vector along = cross(spin, point - middle);
    const float half = 0.5f * h, cosine = std::sqrt(std::max(1.0f - half * half * dot(spin, spin), 0.0f));
    return h * ((cosine - 1.0f) * along - half * cross(spin, along));
}

SurfaceMotion motion_of(const Collider& c, float begin, float end, float h) {
    const Pose to = pose_at(c, end);
    if (!c.moves) return {to.position, {}, {}, h};
    const Pose from = pose_at(c, begin);
    const Rotation turn = to.rotation * inverse(from.rotation);
    const float rate = (turn.w < 0.0f ? -2.0f : 2.0f) / h;
    return {to.position, 1.0f / h * (to.position - from.position), {rate * turn.x, rate * turn.y, rate * turn.z}, h};
}

ContactGroup::ContactGroup(const ContactStep& step, const BodyConstants& body, const BatchArrays& arrays,
                           uint32_t count)
    : step_(&step), body_(&body), arrays_(arrays), count_(count) {
    std::fill(touches_, touches_ + contact_lanes, false);
    for (uint32_t i = 0; i < count; ++i) {
        Near& near = near_[i];
        const Box box = vicinity(step, arrays, i, step.dt);
        const uint32_t layers = step.settings->layers;
        near.count = step.colliders->candidates(box, layers, nullptr, near.candidate, near.crowded);
        if (near.crowded) near.count = step.colliders->grounds(box, layers, near.candidate);
        for (uint32_t k = 0; k < near.count; ++k) {
            const uint32_t slot = near.candidate[k].slot;
            if (!is_ground(step.colliders->at(slot))) continue;
            uint32_t* const end = grounds_ + ground_count_;
            uint32_t* const at = std::lower_bound(grounds_, end, slot);
            if (at != end && *at == slot) continue;
            std::copy_backward(at, end, end + 1);
            *at = slot;
            ++ground_count_;
        }
    }
}

// The slot for one more contact of a body: a free one, or that of its shallowest if this one is deeper; else none.
uint32_t ContactGroup::place(uint32_t i, float gap) {
    if (filled_[i] < contact_slots) {
        const uint32_t at = filled_[i]++;
        if (at == slots_.used) {
            slots_.slot[at] = ContactSlots::Slot{};
            std::fill_n(slots_.slot[at].gap, contact_lanes, no_contact);
            ++slots_.used;
        }
        return at;
    }
    uint32_t shallowest = 0;
    for (uint32_t k = 1; k < contact_slots; ++k)
        if (slots_.slot[k].gap[i] > slots_.slot[shallowest].gap[i]) shallowest = k;
    return gap < slots_.slot[shallowest].gap[i] ? shallowest : contact_slots;
}

void ContactGroup::add(uint32_t i, uint32_t collider, const Contact& contact, const Pose& pose,
                       const SurfaceMotion& motion) {
    const Collider& c = step_->colliders->at(collider);
    const Vector point = to_outer(pose_of(i), contact.arm);
    put(i, {contact.arm, rotate(pose.rotation, contact.normal), motion.velocity_at(point), motion.lag_at(point),
            contact.gap, pair_friction(*step_->settings, c), pair_restitution(*step_->settings, c), collider});
}

// Returns the slot that it has got, or contact_slots.
uint32_t ContactGroup::put(uint32_t i, const SlotContact& c) {
    const uint32_t at = place(i, c.gap);
    if (at == contact_slots) return at;
    ContactSlots::Slot& s = slots_.slot[at];
    put_in(s.arm, 0, i, c.arm);
    put_in(s.normal, 0, i, c.normal);
    put_in(s.surface, 0, i, c.surface);
    put_in(s.lag, 0, i, c.lag);
    s.gap[i] = c.gap;
    s.friction[i] = c.friction;
    s.restitution[i] = c.restitution;
    s.collider[i] = c.collider;
    return at;
}

float ContactGroup::margin_of(uint32_t i, float h) const {
    return contact_margin(step_->shape->reach * arrays_.field[field_scale][i], pose_of(i).position, step_->gravity, h);
}

void ContactGroup::touch_grounds(const ContactBodies& bodies, float begin, float end, float h) {
    ContactSlots::Slot found[manifold_slots];
    alignas(64) uint32_t rough[contact_lanes];
    for (uint32_t g = 0; g < ground_count_; ++g) {
        const Collider& c = step_->colliders->at(grounds_[g]);
        const Pose pose = pose_at(c, end);
        const SurfaceMotion motion = motion_of(c, begin, end, h);
        GroundSurface s{};
        const Vector axes[3] = {rotate(pose.rotation, {1, 0, 0}), rotate(pose.rotation, {0, 1, 0}),
                                rotate(pose.rotation, {0, 0, 1})};
        lr::put(pose.position, s.position);
        for (size_t k = 0; k < 3; ++k) lr::put(axes[k], s.axes + 3 * k);
        lr::put(motion.velocity, s.velocity);
        lr::put(motion.spin, s.spin);
        s.friction = pair_friction(*step_->settings, c);
        s.restitution = pair_restitution(*step_->settings, c);
        s.collider = grounds_[g];
        if (const HeightfieldGeometry* const f = c.geometry.heightfield) {
            s.heights = f->heights;
            s.secant = f->secant;
            for (size_t k = 0; k < 2; ++k) {
                s.counts[k] = f->counts[k];
                s.inverse_spacing[k] = 1.0f / f->spacing[k];
            }
        }
        std::fill_n(rough, contact_lanes, 0u);
        if (!step_->target->ground(bodies, s, found, rough)) continue;
        for (uint32_t i = 0; i < count_; ++i) {
            // The lists of its own: others' grounds must not matter for a body.
            const Candidate* const own = near_[i].candidate;
            const bool listed = std::any_of(own, own + near_[i].count,
                                            [&](const Candidate& candidate) { return candidate.slot == grounds_[g]; });
            if (!listed) continue;
            if (rough[i] == 0) {
                for (const ContactSlots::Slot& slot : found)
                    if (slot.gap[i] < 0.5f * no_contact) put(i, contact_in(slot, i));
                continue;
            }
            Contact contacts[most_contacts];
            const uint32_t count =
                find_contacts(*step_->shape, arrays_.field[field_scale][i], relative(pose, pose_of(i)), c.geometry,
                              {0, 0}, margin_of(i, h), contacts);
            for (uint32_t k = 0; k < count; ++k) add(i, grounds_[g], contacts[k], pose, motion);
        }
    }
}

void ContactGroup::touch_others(uint32_t i, float begin, float end, float h) {
    const float margin = margin_of(i, h), scale = arrays_.field[field_scale][i];
    const Pose at = pose_of(i);
    const Box around = grown({at.position, at.position}, 1.2f * step_->shape->reach * scale + margin);
    Contact contacts[most_contacts];
    const auto add_all = [&](uint32_t slot, const Pose& pose, uint32_t count) {
        if (count == 0) return;
        const SurfaceMotion motion = motion_of(step_->colliders->at(slot), begin, end, h);
        for (uint32_t n = 0; n < count; ++n) add(i, slot, contacts[n], pose, motion);
    };
    // Of all parts of a mesh together those that hold it best: there may be hundreds of them under a body.
    std::optional<MeshContacts> mesh;
    uint32_t mesh_slot = 0;
    Pose mesh_pose{};
    const auto finish_mesh = [&] {
        if (mesh) add_all(mesh_slot, mesh_pose, mesh->keep(contacts));
        mesh.reset();
    };
    each_candidate(i, around, [&](const Candidate& candidate) {
        const Collider& c = step_->colliders->at(candidate.slot);
        if (is_ground(c)) return;
        if (candidate.slot != mesh_slot) finish_mesh();
        if (c.geometry.kind != ColliderKind::mesh) {
            const Pose pose = pose_at(c, end);
            add_all(
                candidate.slot, pose,
                find_contacts(*step_->shape, scale, relative(pose, at), c.geometry, candidate.part, margin, contacts));
            return;
        }
        if (!mesh) {
            mesh_slot = candidate.slot;
            mesh_pose = pose_at(c, end);
            mesh.emplace(*step_->shape, scale, relative(mesh_pose, at), *c.geometry.mesh, margin);
        }
        mesh->add(candidate.part);
    });
    finish_mesh();
}

void ContactGroup::touch_resting(uint32_t i, const LaneRow (&before)[pose_fields], float h) {
    const float margin = margin_of(i, h);
    RestingTouch touches[most_resting];
    const uint32_t count = step_->resting->touched_by(arrays_.key[i], arrays_.field[field_scale][i], pose_in(before, i),
                                                      pose_of(i), margin, touches);
    for (uint32_t n = 0; n < count; ++n)
        for (uint32_t k = 0; k < touches[n].count; ++k) {
            const PairContact& c = touches[n].contact[k];
            const uint32_t at =
                put(i, {c.arm_a, c.normal, {}, {}, c.gap, touches[n].friction, touches[n].restitution, a_body});
            if (at != contact_slots) at_rest_[at][i] = {touches[n].batch, touches[n].index};
        }
}

void ContactGroup::collect(const LaneRow (&before)[pose_fields], float begin, float end, float h) {
    if (step_->settings->ground_effect > 0.0f) press_air(before, begin, end);
    slots_.used = 0;
    std::fill(filled_, filled_ + contact_lanes, uint8_t{0});
    clip(before, begin, end, h);
    std::fill(touches_, touches_ + contact_lanes, false);
    touch_grounds(bodies(before, h), begin, end, h);
    for (uint32_t i = 0; i < count_; ++i) touch_others(i, begin, end, h);
    for (uint32_t i = 0; i < count_ && step_->resting; ++i) touch_resting(i, before, h);
}

void ContactGroup::take_out(uint32_t i) {
    for (uint32_t k = 0; k < filled_[i]; ++k) slots_.slot[k].gap[i] = no_contact;
    filled_[i] = 0;
}

void ContactGroup::solve(const LaneRow (&before)[pose_fields], float h) {
    if (slots_.used == 0) return;
    step_->target->resolve(bodies(before, h), slots_);
    for (uint32_t i = 0; i < count_; ++i)
        for (uint32_t k = 0; k < filled_[i]; ++k) touches_[i] = touches_[i] || slots_.slot[k].impulse[i] >= 0.0f;
}

void ContactGroup::resolve(const LaneRow (&before)[pose_fields], float begin, float end, float h) {
    collect(before, begin, end, h);
    solve(before, h);
}

// What is thin does not roll: with the reach as its lever the couple would hold it leaning on its edge.
float rolling_of(const ContactSettings& settings, const BodyShape& shape) {
    return settings.rolling * std::sqrt(std::min(0.5f * shape.thickness / shape.reach, 1.0f));
}

ContactBodies ContactGroup::bodies(const LaneRow (&before)[pose_fields], float h) const {
    const BodyShape& s = *step_->shape;
    return {body_,
            {s.count,
             s.sample_count,
             s.x,
             s.y,
             s.z,
             s.radius,
             {s.center.x, s.center.y, s.center.z},
             {s.semi_axes.x, s.semi_axes.y, s.semi_axes.z},
             s.reach},
            h,
            step_->gravity,
            rolling_of(*step_->settings, *step_->shape),
            arrays_,
            before,
            contact_lanes};
}

void TouchList::take(uint32_t one, float impulse) {
    // A place for it: its own, or the weakest that is weaker.
    size_t at = 0;
    while (at < 4 && id[at] != one && id[at] != 0) ++at;
    if (at == 4) at = static_cast<size_t>(std::min_element(strength, strength + 4) - strength);
    if (id[at] != one && id[at] != 0 && !(impulse > strength[at])) return;
    strength[at] = std::max(id[at] == one ? strength[at] : -1.0f, impulse);
    id[at] = one;
}

void ContactGroup::touched(uint32_t i, uint32_t (&out)[4]) const {
    TouchList list;
    for (uint32_t k = 0; k < filled_[i] && touches_[i]; ++k)
        if (slots_.slot[k].impulse[i] >= 0.0f) list.take(slots_.slot[k].collider[i] + 1, slots_.slot[k].impulse[i]);
    std::copy_n(list.id, 4, out);
}

void TouchSum::take(float impulse, Vector arm, Vector normal, Vector surface) {
    if (!(impulse >= 0.0f)) return;
    touch_.impulse += impulse;
    if (!(impulse > strongest_)) return;
    strongest_ = impulse;
    put(to_outer(now_, arm), touch_.position);
    put(normal, touch_.normal);
    touch_.speed = std::max(dot(normal, surface - rotate(then_, v_ + cross(w_, arm))), 0.0f);
}

Touch TouchSum::touch(float unit_mass) const {
    Touch all = touch_;
    all.impulse *= unit_mass;
    return all;
}

Touch ContactGroup::meeting(uint32_t i, uint32_t collider, const LaneRow (&before)[pose_fields]) const {
    TouchSum sum(collider, pose_of(i), pose_in(before, i).rotation, vector_in(before, field_vx, i),
                 vector_in(before, field_wx, i));
    for (uint32_t k = 0; k < filled_[i]; ++k) {
        const SlotContact c = contact(i, k);
        if (c.collider == collider) sum.take(slots_.slot[k].impulse[i], c.arm, c.normal, c.surface);
    }
    const float scale = arrays_.field[field_scale][i];
    return sum.touch(body_->unit_mass * scale * scale * scale);
}

NearContacts::NearContacts(const ContactStep& step, const BatchArrays& arrays, uint32_t live, uint32_t begin,
                           uint32_t end, float dt)
    : begin_(begin), end_(begin), live_(live) {
    constexpr uint32_t at_a_time = field_block / 2;
    const uint32_t last = std::min(end, begin + near_range);
    const bool all_grounds = step.colliders->all_grounds(step.settings->layers);
    while (end_ < last && count_ + at_a_time <= field_block) {
        const uint32_t from = end_, to = std::min(from + at_a_time, last);
        step.target->near(step.colliders->near(), step.shape->reach, dt, step.gain, arrays, from, to,
                          near_ + (from - begin));
        // What the grids hold depends on when they were built, and must not matter: a body that nothing reaches goes the way
        // of the others, to the bit.
        for (uint32_t i = from; i < std::min(to, live); ++i) {
            if (is_held(arrays.field[field_age_rest][i])) {
                near_[i - begin] = 0; // it touches nothing
                continue;
            }
            if (step.resting) near_[i - begin] = 1; // what they rest on is not looked for twice
            const uint32_t mark = near_[i - begin];
            if (mark == 0) continue;
            const auto reached = [&] {
                const Box box = vicinity(step, arrays, i, dt);
                const bool over_ground = (mark & near_ground) != 0;
                const bool finite = length(box.high - box.low) < 1e10f && dot(box.low, box.low) < 1e20f; // not NaN
                return finite &&
                       ((over_ground && all_grounds) || step.colliders->any_finite(box, step.settings->layers) ||
                        (over_ground && step.colliders->any_ground(box, step.settings->layers)));
            };
            if (step.resting || reached())
                index_[count_++] = i;
            else
                near_[i - begin] = 0;
        }
        end_ = to;
    }
}

bool NearContacts::others(uint32_t begin) const {
    for (uint32_t i = begin; i < std::min(begin + static_cast<uint32_t>(lane_block), live_); ++i)
        if (near_[i - begin_] == 0) return true;
    return false;
}

} // namespace lr
