// Turns manifolds into the contacts of a substep, and stores the substep's impulses with the pairs for the next one.
#include "body_contact/body_contact_step.h"
#include "body_contact/kept_manifold.h"
#include "world/world.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

// The share of friction that warm-starts the next substep. With all of it, friction that only strains bodies against each other would
// never fade, and a stack of five boxes creeps.
constexpr float lasting_friction = 0.8f;
} // namespace

bool BodyContactStep::in_order(const BodyContactBuffers::Pair& pair) const {
    return buffers_->moved[pair.a].key < buffers_->moved[pair.b].key;
}

void BodyContactStep::enter_manifold(uint32_t at, const Manifold& manifold, float within) {
    BodyContactBuffers& c = *buffers_;
    const BodyContactBuffers::Pair& pair = c.pairs[at];
    const BodyContactBuffers::Moved &one = c.moved[pair.a], &other = c.moved[pair.b];
    c.found[at].count = 0;
    if (manifold.count == 0 || one.key == other.key) return;
    c.found[at] = in_order(pair) ? cached_pair(one.key, other.key, one.body, other.body, manifold, within, c.cached[at])
                                 : cached_pair(other.key, one.key, other.body, one.body, other_way_round(manifold),
                                               within, c.cached[at]);
}

void BodyContactStep::enter_contacts(uint32_t at, const WayContact* found) {
    BodyContactBuffers& c = *buffers_;
    const BodyContactBuffers::Pair& pair = c.pairs[at];
    const lr_batch_contact& of_a = c.members[c.moved[pair.a].member].item.batch->contact();
    const lr_batch_contact& of_b = c.members[c.moved[pair.b].member].item.batch->contact();
    const float friction = pair_friction(of_a, of_b), restitution = pair_restitution(of_a, of_b);
    BodyContactBuffers::PairContacts& to = c.pair_contacts[at];
    CachedPair& manifold = c.found[at];
    if (pair.count == 0 && manifold.count == 0) return;
    const auto h = static_cast<float>(time_.h);
    for (uint32_t k = 0; k < pair.count; ++k) {
        const PairContact& contact = found[k].begin;
        const bool cached = found[k].from < manifold.count;
        to.contact[k] = {contact.arm_a, contact.arm_b, contact.gap,
                         cached ? h * h * manifold.pressed[found[k].from] : 0.0f, found[k].from};
    }
    if (pair.count != 0) to.frame = {found[0].begin.normal, {}, {}, friction, restitution, false, friction_before(at)};
    // Contacts that do not count in this substep leave no impulse for the next.
    std::fill_n(manifold.pressed, most_pair_contacts, 0.0f);
    if (pair.count == 0) manifold.drag = {}, manifold.spin = 0.0f;
}

PathFriction BodyContactStep::friction_before(uint32_t at) const {
    const BodyContactBuffers& c = *buffers_;
    const BodyContactBuffers::Pair& pair = c.pairs[at];
    const CachedPair& cached = c.found[at];
    if (cached.count == 0) return {};
    const bool ordered = in_order(pair);
    const auto h = static_cast<float>(time_.h);
    const Vector drag = rotate(c.moved[ordered ? pair.a : pair.b].body.from.rotation, cached.drag);
    const float scale = lasting_friction * h * h;
    return {(ordered ? scale : -scale) * drag, scale * cached.spin};
}

void BodyContactStep::keep_impulses() {
    BodyContactBuffers& c = *buffers_;
    const auto h = static_cast<float>(time_.h);
    const float square = h * h;
    constexpr float most = 1e12f; // m/s^2: such an impulse says nothing about the next substep
    if (!(square > 1e-30f)) return;
    const float slow = 2.0f * c.members[0].run.step.gravity * h; // as for restitution
    workers_.run(place_count_, 256, [&](uint32_t begin, uint32_t end) {
        const uint32_t past = end < place_count_ ? c.first_unit[end] : unit_count_;
        for (uint32_t u = c.first_unit[begin]; u < past; ++u) {
            const BodyContactPair& unit = c.units[u];
            if (unit.b == BodyContactPair::nobody) continue;
            const BodyContactBuffers::Pair& pair = c.pairs[unit.source];
            CachedPair& to = c.found[unit.source];
            const bool ordered = in_order(pair);
            if (to.count == 0) continue;
            const Rotation back = inverse(c.moved[ordered ? pair.a : pair.b].body.from.rotation);
            const SolverBody* const bodies = c.solver.bodies();
            const float over = std::min(bodies[unit.a].share, bodies[unit.b].share) / square;
            const PathFriction friction = c.solver.path_friction(unit);
            const Vector drag = (ordered ? over : -over) * rotate(back, friction.drag);
            const float spin = over * friction.spin;
            const bool fine = dot(drag, drag) < most * most && std::abs(spin) < most;
            to.drag = fine ? drag : Vector{};
            to.spin = fine ? spin : 0.0f;
            for (uint32_t k = 0; k < unit.count; ++k) {
                if (unit.contact[k].from >= to.count) continue;
                const float pressed = over * c.solver.path_pressed(unit, k, slow);
                if (pressed < most) to.pressed[unit.contact[k].from] = pressed;
            }
        }
    });
}

bool BodyContactStep::begin_pairs(uint32_t most) {
    PairCache& cache = world_->pair_cache;
    const auto stepped = [&](uint32_t slot) {
        const BodyContactBatch* const members = buffers_->members.data();
        return std::any_of(members, members + member_count_, [&](const BodyContactBatch& m) { return m.slot == slot; });
    };
    if (!cache.begin(world_->allocator, most, stepped)) return false;
    buffers_->found = cache.next();
    return true;
}
} // namespace lr
