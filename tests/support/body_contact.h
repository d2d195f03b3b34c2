// Body contact, for tests.
#pragma once

#include "support/contact.h"

#include <algorithm>
#include <cmath>

namespace test {

inline void set_pair(const World& w, lr_batch a, lr_batch b, bool on = true) {
    REQUIRE(lr_batch_set_body_contact(w.get(), a, b, on ? 1 : 0) == LR_OK);
}
// Almost no fluid, so that all momentum is the bodies'.
inline lr_rigid_desc vacuum_box(double x, double y, double z, double density) {
    lr_rigid_desc d = rigid_box(x, y, z, density);
    d.fluid_density = 1e-3;
    for (double& a : d.added_mass) a = 0.0;
    return d;
}
inline bool rests(const World& w, lr_body body) {
    return state_of(w, body).sleep_state == LR_SLEEP_ASLEEP;
}
inline lr_body_desc at_rest_at(const Vec& position) {
    lr_body_desc d = body_desc();
    put(d.position, position);
    return d;
}

// Mass and inertia of a diagonal asset without a fluid.
struct Moving {
    double mass;
    Vec inertia; // about body axes, at scale 1 and for `mass` at the body's scale
    Vec position, velocity, spin;
    Quat turn;

    Moving(const lr_asset_info& info, const lr_body_state& s)
        : mass(info.mass * std::pow(wide(s.scale), 3.0)), position(vec(s.position)), velocity(vec(s.linear_velocity)),
          spin(vec(s.angular_velocity)), turn(quat(s.orientation)) {
        for (size_t k = 0; k < 3; ++k) inertia[k] = info.inertia[4 * k] * std::pow(wide(s.scale), 5.0);
    }
    Vec momentum() const { return mass * velocity; }
    Vec own_spin() const {
        const Vec w = to_body(turn, spin);
        return to_world(turn, {inertia[0] * w[0], inertia[1] * w[1], inertia[2] * w[2]});
    }
    Vec angular_momentum(const Vec& about) const { return own_spin() + cross(position - about, momentum()); }
    double energy() const { return 0.5 * mass * dot(velocity, velocity) + 0.5 * dot(spin, own_spin()); }
};

} // namespace test
