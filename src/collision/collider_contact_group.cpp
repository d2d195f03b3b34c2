#include "collision/collider_contact_group.h"

#include "base/scratch.h"
#include "collision/triangle_contact.h"
#include "kernel/divergence.h"

#include <bit>
#include <limits>
#include <optional>

namespace lr {
namespace {

// The box within which a body can touch something in dt (contact.md, section 2); as in the kernel.
Box vicinity(const ContactStep& step, const BatchArrays& arrays, uint32_t i, float dt) {
    const float size = 1.5f * step.shape->reach * arrays.field[field_scale][i];
    const float speed =
        length(vector_in(arrays.field, field_vx, i)) + 0.25f * size * length(vector_in(arrays.field, field_wx, i));
    const Vector x = vector_in(arrays.field, field_x, i);
    return grown({x, x}, size + dt * (1.5f * speed + step.gain));
}
} // namespace

float height_over(const Geometry& g, Vector at) {
    const HeightfieldGeometry* const f = g.heightfield;
    if (!f) return at.y;
    return f->covers(at.x, at.z) ? at.y - height_at(*f, at.x, at.z).height : -1.0f;
}

const char* wrong_in(const lr_batch_contact& s) {
    if ((s.flags & ~uint32_t{LR_CONTACT_NEVER_SLEEP}) != 0 || s.reserved != 0)
        return "flags has an unknown bit, or reserved is not 0";
    if (const char* const wrong = wrong_material(s.friction, s.restitution)) return wrong;
    if (!in_range(s.rolling_resistance, 0.0, 10.0)) return "rolling_resistance is not 0 to 10";
    if (!in_range(s.min_thickness, -1.0, 10.0)) return "min_thickness is not -1 to 10";
    return in_range(s.ground_effect, 0.0, 1.0) ? nullptr : "ground_effect is not 0 to 1";
}

Pose pose_at(const Collider& c, float part) {
    if (!c.moves || part <= 0.0f) return c.begin;
    if (part >= 1.0f) return c.end;
    return mix(c.begin, c.end, part);
}

Vector SurfaceMotion::velocity_at(Vector point) const {
    return velocity + cross(spin, point - middle);
}

Vector SurfaceMotion::lag_at(Vector point) const {
    const Vector along = cross(spin, point - middle);
    const float half = 0.5f * h, cosine = std::sqrt(std::max(1.0f - half * half * dot(spin, spin), 0.0f));
    return h * ((cosine - 1.0f) * along - half * cross(spin, along));
}

SurfaceMotion motion_of(const Collider& c, const ContactSubstep& substep) {
    const float h = substep.h;
    const Pose to = pose_at(c, substep.end);
    if (!c.moves) return {to.position, {}, {}, h};
    const Pose from = pose_at(c, substep.begin);
    const Rotation turn = to.rotation * inverse(from.rotation);
    return {to.position, 1.0f / h * (to.position - from.position), 1.0f / h * chord(turn), h};
}

void ContactGroup::list_near(Near& near) const {
    const Colliders& colliders = *step_->colliders;
    const uint32_t layers = step_->settings->layers;
    near.count = colliders.candidates(near.box, layers, nullptr, near.candidate, near.overflowed);
    if (near.overflowed) near.count = colliders.grounds(near.box, layers, near.candidate);
    near.grounds = near.finite = 0;
    for (uint32_t k = 0; k < near.count; ++k) {
        const bool ground = is_ground(colliders.at(near.candidate[k].slot).geometry.kind);
        (ground ? near.grounds : near.finite) |= uint64_t{1} << k;
    }
}

ContactGroup::ContactGroup(const ContactStep& step, const StepInput& in, const BatchArrays& arrays, uint32_t count)
    : step_(&step), body_(&in.body), water_(in.water), arrays_(arrays), count_(count) {
    for (uint32_t i = 0; i < count_; ++i) {
        Near& near = near_[i];
        near.box = near.of_step = vicinity(step, arrays, i, step.dt);
        list_near(near);
        near.among_many = near.overflowed || near.count > among_few;
        for (uint64_t left = near.grounds; left != 0; left &= left - 1) {
            const uint32_t slot = near.candidate[std::countr_zero(left)].slot;
            uint32_t* const end = grounds_ + ground_count_;
            uint32_t* const at = std::lower_bound(grounds_, end, slot);
            if (at != end && *at == slot) continue;
            std::copy_backward(at, end, end + 1);
            *at = slot;
            ++ground_count_;
        }
    }
}

// A slot for another contact: a free one. If there is none, the shallower of the two contacts that are most alike goes: had the shallowest gone, a
// card on many tiles had contacts at its lower end only, and rocked. For a sleeping body the shallowest does go, since the deep ones keep bodies out of
// each other. Returns contact_slots if the new one goes.
uint32_t ContactGroup::place(uint32_t i, const SlotContact& c) {
    if (filled_[i] < contact_slots) {
        const uint32_t at = filled_[i]++;
        if (at == slots_.used) {
            slots_.slot[at] = ContactSlots::Slot{};
            std::fill_n(slots_.slot[at].gap, contact_lanes, no_contact);
            ++slots_.used;
        }
        return at;
    }
    const float reach = step_->shape->reach * arrays_.field[field_scale][i];
    SlotContact all[contact_slots + 1];
    for (uint32_t k = 0; k < contact_slots; ++k) all[k] = contact(i, k);
    all[contact_slots] = c;
    uint32_t out = contact_slots;
    if (c.collider == sleeping_body) {
        for (uint32_t k = 0; k < contact_slots; ++k) out = all[k].gap > all[out].gap ? k : out;
        return out;
    }
    float least = std::numeric_limits<float>::infinity();
    for (uint32_t b = 1; b <= contact_slots; ++b)
        for (uint32_t a = 0; a < b; ++a) {
            const Vector apart = all[a].arm - all[b].arm, turned = reach * (all[a].normal - all[b].normal);
            const float unlike = dot(apart, apart) + dot(turned, turned);
            if (unlike < least) least = unlike, out = all[a].gap > all[b].gap ? a : b;
        }
    return out;
}

void ContactGroup::add(uint32_t i, uint32_t collider, const Contact* contacts, uint32_t count,
                       const ContactSubstep& substep, Vector lifted) {
    if (count == 0) return;
    const Collider& c = step_->colliders->at(collider);
    const Rotation turn = pose_at(c, substep.end).rotation;
    const SurfaceMotion motion = motion_of(c, substep);
    for (const Contact* at = contacts; at != contacts + count; ++at) {
        const Vector point = to_outer(pose_of(i), at->arm), normal = rotate(turn, at->normal);
        put(i, {at->arm, normal, motion.velocity_at(point), motion.lag_at(point), at->gap - dot(normal, lifted),
                pair_friction(*step_->settings, c), pair_restitution(*step_->settings, c), collider});
    }
}

// Returns the slot, or contact_slots.
uint32_t ContactGroup::put(uint32_t i, const SlotContact& c) {
    const uint32_t at = place(i, c);
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

GroundSurface ContactGroup::surface_of(uint32_t slot, const ContactSubstep& substep) const {
    const Collider& c = step_->colliders->at(slot);
    const Pose pose = pose_at(c, substep.end);
    const SurfaceMotion motion = motion_of(c, substep);
    GroundSurface s{};
    const Axes axes = axes_of(pose.rotation);
    lr::put(pose.position, s.position);
    lr::put(axes.x, s.axes), lr::put(axes.y, s.axes + 3), lr::put(axes.z, s.axes + 6);
    lr::put(motion.velocity, s.velocity);
    lr::put(motion.spin, s.spin);
    s.friction = pair_friction(*step_->settings, c);
    s.restitution = pair_restitution(*step_->settings, c);
    s.collider = slot;
    if (c.geometry.heightfield) s.grid = c.geometry.heightfield->grid();
    return s;
}

void ContactGroup::touch_grounds(const ContactSubstep& substep) {
    const ContactBodies all = bodies(substep);
    ContactSlots::Slot found[manifold_slots];
    alignas(64) uint32_t rough[contact_lanes];
    for (uint32_t g = 0; g < ground_count_; ++g) {
        const GroundSurface s = surface_of(grounds_[g], substep);
        std::fill_n(rough, contact_lanes, 0u);
        if (!step_->target->ground(all, s, found, rough)) continue;
        for (uint32_t i = 0; i < count_; ++i) {
            // A body's own list decides: other bodies' grounds must not affect its bits.
            const Candidate* const own = near_[i].candidate;
            const bool listed = std::any_of(own, own + near_[i].count,
                                            [&](const Candidate& candidate) { return candidate.slot == grounds_[g]; });
            if (!listed) continue;
            if (rough[i] == 0) {
                for (const ContactSlots::Slot& slot : found)
                    if (slot.gap[i] < 0.5f * no_contact) put(i, contact_in(slot, i));
                continue;
            }
            const Collider& c = step_->colliders->at(grounds_[g]);
            Contact contacts[most_contacts];
            const uint32_t count = find_contacts(*step_->shape, arrays_.field[field_scale][i],
                                                 relative(pose_at(c, substep.end), pose_of(i)), c.geometry,
                                                 margin_of(i, substep.h), contacts);
            add(i, grounds_[g], contacts, count, substep);
        }
    }
}

// Even floors of meshes are met as grounds are: a call for each mesh, since it has one motion, and each body has its own triangles. Others one by one.
void ContactGroup::touch_floors(const ContactSubstep& substep) {
    const InScratch<FloorLanes> below;
    FloorLanes& lanes = *below;
    uint32_t left = 0; // bits of bodies
    for (uint32_t i = 0; i < count_; ++i) {
        const MeshFloor& floor = floor_[i];
        if (floor.count == 0) continue;
        const Collider& c = step_->colliders->at(floor.slot);
        const float scale = arrays_.field[field_scale][i];
        const Pose pose = pose_at(c, substep.end), at = relative(pose, pose_of(i));
        if (floor.even &&
            lay_below(*c.geometry.mesh, floor, at.position, step_->shape->reach * scale, pose.rotation, i, lanes)) {
            left |= 1u << i;
            continue;
        }
        ContactPoints points(*step_->shape, scale, at, margin_of(i, substep.h));
        add_floor(points, *c.geometry.mesh, floor);
        Contact contacts[most_contacts];
        add(i, floor.slot, contacts, points.keep(contacts, true), substep);
    }
    ContactSlots::Slot found[manifold_slots];
    while (left != 0) {
        const uint32_t slot = floor_[std::countr_zero(left)].slot;
        GroundSurface s = surface_of(slot, substep);
        s.floor = &lanes;
        const bool any = step_->target->ground(bodies(substep), s, found, nullptr);
        for (uint32_t i = 0; i < count_; ++i) {
            if ((left >> i & 1u) == 0 || floor_[i].slot != slot) continue;
            left ^= 1u << i;
            for (const ContactSlots::Slot& one : found)
                if (any && one.gap[i] < 0.5f * no_contact) put(i, contact_in(one, i));
        }
    }
}

namespace {

// A direction in twelve bits, to 7 degrees, and a tag of the mesh in twenty; 0: none. A body can be on opposite sides of two meshes.
constexpr uint32_t most_tags = (1u << 20) - 1;
uint32_t tag_of(uint32_t slot) {
    return slot % most_tags + 1u;
}
uint32_t packed_floor(Vector up, uint32_t slot) {
    const auto bits = [](float f) { return static_cast<uint32_t>(7.5f * f + 8.0f); };
    return bits(up.x) | bits(up.y) << 4 | bits(up.z) << 8 | tag_of(slot) << 12;
}
} // namespace

Vector floor_side(uint32_t packed, uint32_t slot) {
    const auto part = [&](uint32_t at) { return static_cast<float>(packed >> at & 15u) - 7.5f; };
    return packed >> 12 == tag_of(slot) ? 1.0f / 7.5f * Vector{part(0), part(4), part(8)} : Vector{};
}

// Most bodies near a box, a hull and the like are only within its bounding box. Where heightfields are swept all count, since they decide on the lift.
void ContactGroup::find_others(const ContactSubstep& substep) {
    for (uint32_t i = 0; i < count_; ++i) {
        Near& near = near_[i];
        const Vector from = pose_in(substep.before, i).position, to = pose_of(i).position;
        const float reach = 1.2f * step_->shape->reach * arrays_.field[field_scale][i] + margin_of(i, substep.h);
        if (near.among_many) {
            const Box path = grown({low_of(from, to), high_of(from, to)}, reach + length(to - from)); // with lifts
            near.box = {high_of(path.low, near.of_step.low), low_of(path.high, near.of_step.high)};
            list_near(near);
        }
        near.others = near.finite;
        bool swept = false;
        for (uint64_t left = near.grounds; left != 0 && near.finite != 0; left &= left - 1) {
            const Collider& c = step_->colliders->at(near.candidate[std::countr_zero(left)].slot);
            const HeightfieldGeometry* const f = c.geometry.heightfield;
            swept =
                swept ||
                (f && (c.moves || 3.0f * length(to - from) + reach > 0.5f * std::min(f->spacing[0], f->spacing[1])));
        }
        for (uint64_t left = near.finite; left != 0 && !swept; left &= left - 1) {
            const Collider& c = step_->colliders->at(near.candidate[std::countr_zero(left)].slot);
            const Vector first = to_inner(pose_at(c, substep.begin), from),
                         last = to_inner(pose_at(c, substep.end), to);
            if (distance_from(c.geometry, last) > reach + length(last - first)) near.others ^= left & -left;
        }
    }
}

void ContactGroup::find_floors(const ContactSubstep& substep) {
    constexpr uint32_t most_parts = 256; // of meshes near a body
    for (uint32_t i = 0; i < count_; ++i) {
        MeshFloor& floor = floor_[i];
        if (!near_[i].meets_others()) {
            floor.slot = 0, floor.count = 0, floor.side = 0;
            if (arrays_.floor) arrays_.floor[i] = 0;
            continue;
        }
        const float reach = step_->shape->reach * arrays_.field[field_scale][i] + margin_of(i, substep.h);
        const Vector a = pose_in(substep.before, i).position, b = pose_of(i).position;
        Candidate near[most_parts];
        uint32_t near_count = 0;
        const auto take = [&](const Candidate& candidate) {
            if (!step_->colliders->at(candidate.slot).geometry.mesh) return;
            if (near_count < most_parts) near[near_count] = candidate;
            ++near_count;
        };
        // Longer paths end on no floor, and on very long ones a search in order would be slow.
        if (length(b - a) < longest_floor * reach) each_candidate(i, grown({low_of(a, b), high_of(a, b)}, reach), take);
        const bool all = near_count <= most_parts; // if not, some parts still tell the side
        near_count = std::min(near_count, most_parts);
        const uint32_t known = arrays_.floor ? arrays_.floor[i] : 0;
        uint32_t kept = 0;
        floor.slot = 0, floor.count = 0, floor.side = 0;
        for (uint32_t k = 0; k < near_count && floor.count == 0 && floor.side == 0;) {
            const uint32_t slot = near[k].slot, first = k;
            while (k < near_count && near[k].slot == slot) ++k;
            const Collider& c = step_->colliders->at(slot);
            const Pose begin = pose_at(c, substep.begin), end = pose_at(c, substep.end);
            floor.slot = slot;
            floor.up = rotate(inverse(end.rotation), floor_side(known, slot));
            find_floor(*step_->shape, arrays_.field[field_scale][i], relative(begin, pose_in(substep.before, i)),
                       relative(end, pose_of(i)), margin_of(i, substep.h), *c.geometry.mesh, near + first, k - first,
                       floor);
            const Vector up = rotate(end.rotation, floor.up);
            // The lower edge of a broom or a wheel would push along the mean of its faces, into the ground on which the body lies.
            if (!all || (floor.count > 0 && !floor.even && dot(up, step_->weight) > 0.0f)) floor.count = 0;
            if (floor.count > 0 || floor.side != 0) kept = packed_floor(up, slot);
        }
        if (arrays_.floor) arrays_.floor[i] = kept;
    }
}

Vector ContactGroup::face_below(uint32_t i, const ContactSubstep& substep) const {
    const float reach = step_->shape->reach * arrays_.field[field_scale][i];
    const Vector center = pose_in(substep.before, i).position;
    Vector face{};
    float least = reach;
    each_candidate(i, grown({center, center}, reach), [&](const Candidate& candidate) {
        const Collider& c = step_->colliders->at(candidate.slot);
        if (!c.geometry.mesh) return;
        const Vector found =
            face_of_center(*c.geometry.mesh, candidate.part, to_inner(pose_at(c, substep.begin), center), least);
        if (dot(found, found) > 0.0f) face = rotate(pose_at(c, substep.end).rotation, found);
    });
    return face;
}

void ContactGroup::touch_others(uint32_t i, const ContactSubstep& substep) {
    if (!near_[i].meets_others()) return;
    const float margin = margin_of(i, substep.h), scale = arrays_.field[field_scale][i];
    const Pose at = pose_of(i), lifted{at.position + lift_[i], at.rotation};
    const Box around = grown({at.position, at.position}, 1.2f * step_->shape->reach * scale + margin);
    Contact contacts[most_contacts];
    std::optional<Vector> face;
    // All parts of a mesh give one manifold: hundreds of parts can be under a body.
    std::optional<ContactPoints> mesh;
    uint32_t mesh_slot = 0;
    Pose mesh_pose{}, began{};
    const auto finish_mesh = [&] {
        if (mesh) add(i, mesh_slot, contacts, mesh->keep(contacts, true), substep, lift_[i]);
        mesh.reset();
    };
    const MeshFloor& floor = floor_[i];
    each_candidate(i, around, [&](const Candidate& candidate) {
        const Collider& c = step_->colliders->at(candidate.slot);
        if (is_ground(c.geometry.kind) || (floor.count > 0 && candidate.slot == floor.slot)) return;
        if (candidate.slot != mesh_slot) finish_mesh();
        if (c.geometry.kind != ColliderKind::mesh) {
            const Pose pose = pose_at(c, substep.end);
            const Pose from = relative(pose_at(c, substep.begin), pose_in(substep.before, i));
            bool fast = false;
            const bool below = side_below(i, c, at, substep, fast) && !fast;
            const uint32_t count =
                find_contacts(*step_->shape, scale, relative(pose, below ? at : lifted), c.geometry, margin, contacts,
                              &from, below ? Vector{} : rotate(inverse(pose.rotation), up_[i]));
            return add(i, candidate.slot, contacts, count, substep, below ? Vector{} : lift_[i]);
        }
        if (!mesh) {
            mesh_slot = candidate.slot;
            mesh_pose = pose_at(c, substep.end);
            began = relative(pose_at(c, substep.begin), pose_in(substep.before, i));
            mesh.emplace(*step_->shape, scale, relative(mesh_pose, lifted), margin, &began,
                         mesh_slot == floor.slot ? floor.side : int8_t{0});
            if (mesh->side == 0) {
                if (!face) face = face_below(i, substep);
                mesh->face = rotate(inverse(mesh_pose.rotation), *face);
            }
            mesh->up = direction_of(rotate(inverse(mesh_pose.rotation), up_[i]));
        }
        add_mesh(*mesh, *c.geometry.mesh, candidate.part);
    });
    finish_mesh();
}

void ContactGroup::touch_sleeping(uint32_t i, const ContactSubstep& substep) {
    SleepingTouch touches[most_sleeping];
    const uint32_t count =
        step_->sleeping->touched_by(arrays_.noise_seed[i], arrays_.field[field_scale][i], pose_in(substep.before, i),
                                    pose_of(i), margin_of(i, substep.h), touches);
    for (uint32_t n = 0; n < count; ++n)
        for (uint32_t k = 0; k < touches[n].count; ++k) {
            const PairContact& c = touches[n].contact[k];
            const uint32_t at =
                put(i, {c.arm_a, c.normal, {}, {}, c.gap, touches[n].friction, touches[n].restitution, sleeping_body});
            if (at != contact_slots) at_rest_[at][i] = {touches[n].batch, touches[n].index};
        }
}

void ContactGroup::collect(const ContactSubstep& substep) {
    slots_.used = 0;
    std::fill(filled_, filled_ + contact_lanes, uint8_t{0});
    find_others(substep);
    if (step_->settings->ground_effect > 0.0f) ground_effect(substep);
    find_floors(substep);
    for (uint32_t i = 0; i < count_; ++i) up_[i] = lift(i, pose_of(i), substep.end, substep, lift_[i]);
    stop_before_passing_through(substep);
    touch_grounds(substep);
    const auto is_floor = [](const MeshFloor& floor) { return floor.count > 0; };
    if (std::any_of(floor_, floor_ + count_, is_floor)) touch_floors(substep);
    for (uint32_t i = 0; i < count_; ++i) touch_others(i, substep);
    for (uint32_t i = 0; i < count_ && step_->sleeping; ++i) touch_sleeping(i, substep);
}

float ContactGroup::least_gap(uint32_t i) const {
    float least = no_contact;
    for (uint32_t k = 0; k < filled_[i]; ++k) least = std::min(least, slots_.slot[k].gap[i]);
    return least;
}

void ContactGroup::take_out(uint32_t i) {
    for (uint32_t k = 0; k < filled_[i]; ++k) slots_.slot[k].gap[i] = no_contact;
    filled_[i] = 0;
}

// Contacts use the added mass of the fluid around the body, since with any other they would add energy. They use its fall there too: a thin leaf
// falls with some thousandths of gravity, and the static lock would hold it by mistake.
void ContactGroup::resolve(const ContactSubstep& substep) {
    ContactBodies bodies = this->bodies(substep);
    const InScratch<SolverMemory> memory;
    if (std::find(wet_, wet_ + count_, true) == wet_ + count_) return step_->target->resolve(bodies, slots_, *memory);
    const InScratch<ContactSlots> copy;
    ContactSlots& part = *copy;
    for (const bool wet : {false, true}) {
        bodies.body = wet ? &water_->water : body_;
        bodies.gravity = wet ? water_->fall * step_->gravity : step_->gravity;
        part = slots_;
        const auto each = [&](bool which, const auto& function) {
            for (uint32_t i = 0; i < count_; ++i)
                for (uint32_t k = 0; k < filled_[i] && wet_[i] == which; ++k) function(i, k);
        };
        each(!wet, [&](uint32_t i, uint32_t k) { part.slot[k].gap[i] = no_contact; });
        step_->target->resolve(bodies, part, *memory);
        each(wet, [&](uint32_t i, uint32_t k) { slots_.slot[k].impulse[i] = part.slot[k].impulse[i]; });
    }
}

void ContactGroup::solve(const ContactSubstep& substep, const float* submerged) {
    for (uint32_t i = 0; i < count_; ++i) wet_[i] = water_ && submerged && water_->carries(submerged[i]);
    if (slots_.used == 0) return;
    resolve(substep);
    leave_floors(substep);
    stay_in_front(substep);
}

// The lever shrinks with the thickness: with the reach, the couple would hold thin bodies leaning on an edge.
float rolling_of(const lr_batch_contact& settings, const BodyShape& shape) {
    return settings.rolling_resistance * std::sqrt(std::min(0.5f * shape.thickness / shape.reach, 1.0f));
}

ContactBodies ContactGroup::bodies(const ContactSubstep& substep) const {
    const BodyShape& s = *step_->shape;
    ShapeConstants shape{s.count, s.sample_count, s.x, s.y, s.z, s.radius, {}, {}, s.reach, rounding_of(s)};
    lr::put(s.center, shape.center);
    lr::put(s.semi_axes, shape.semi_axes);
    const float rolling = rolling_of(*step_->settings, s);
    return {body_, shape, substep.h, step_->gravity, rolling, arrays_, substep.before, contact_lanes};
}

void TouchList::take(uint32_t one, float impulse) {
    // A slot with the same id, a free one, or that of the weakest touch if this one is stronger.
    size_t at = 0;
    while (at < 4 && id[at] != one && id[at] != 0) ++at;
    if (at == 4) at = static_cast<size_t>(std::min_element(strength, strength + 4) - strength);
    if (id[at] != one && id[at] != 0 && !(impulse > strength[at])) return;
    strength[at] = std::max(id[at] == one ? strength[at] : -1.0f, impulse);
    id[at] = one;
}

void ContactGroup::touched(uint32_t i, uint32_t (&out)[4]) const {
    TouchList list;
    for (uint32_t k = 0; k < filled_[i]; ++k)
        if (slots_.slot[k].impulse[i] >= 0.0f) list.take(slots_.slot[k].collider[i] + 1, slots_.slot[k].impulse[i]);
    std::copy_n(list.id, 4, out);
}

bool ContactGroup::carried(uint32_t i, float fast) const {
    for (uint32_t k = 0; k < filled_[i]; ++k)
        if (slots_.slot[k].impulse[i] >= 0.0f && is_slow(vector_in(slots_.slot[k].surface, 0, i), fast)) return true;
    return false;
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

Touch ContactGroup::touch_with(uint32_t i, uint32_t collider, const ContactSubstep& substep) const {
    const LaneRow* const before = substep.before;
    TouchSum sum(collider, pose_of(i), pose_in(before, i).rotation, vector_in(before, field_vx, i),
                 vector_in(before, field_wx, i));
    for (uint32_t k = 0; k < filled_[i]; ++k) {
        const SlotContact c = contact(i, k);
        if (c.collider == collider) sum.take(slots_.slot[k].impulse[i], c.arm, c.normal, c.surface);
    }
    const float scale = arrays_.field[field_scale][i];
    return sum.touch((wet_[i] ? water_->water : *body_).unit_mass * scale * scale * scale);
}

NearContacts::NearContacts(const ContactStep& step, const BatchArrays& arrays, uint32_t live, uint32_t begin,
                           uint32_t end, float dt)
    : begin_(begin), end_(begin) {
    constexpr uint32_t at_a_time = field_block / 2;
    const uint32_t last = std::min(end, begin + near_range);
    const bool all_grounds = step.colliders->all_grounds(step.settings->layers);
    while (end_ < last && count_ + at_a_time <= field_block) {
        const uint32_t from = end_, to = std::min(from + at_a_time, last);
        step.target->near(step.colliders->near(), step.shape->reach, dt, step.gain, arrays, from, to,
                          near_ + (from - begin));
        // The grids' bits depend on when they were built. Results must not, so boxes decide, which depend on colliders alone.
        for (uint32_t i = from; i < std::min(to, live); ++i) {
            if (is_held(arrays.field[field_age_remainder][i])) {
                near_[i - begin] = 0; // a held body touches nothing
                continue;
            }
            if (step.sleeping) near_[i - begin] = 1; // sleeping bodies are found later
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
            if (step.sleeping || reached())
                index_[count_++] = i;
            else
                near_[i - begin] = 0;
        }
        end_ = to;
    }
}
} // namespace lr
