// Bodies on colliders, for tests of physics.
#pragma once

#include "support/colliders.h"
#include "support/vector.h"

namespace test {

inline lr_batch_desc unloaded() {
    lr_batch_desc d = batch_desc();
    d.load_model = LR_LOADS_NONE;
    return d;
}
inline lr_batch_contact contact_desc(float friction, float restitution, float rolling = 0.0f) {
    lr_batch_contact c = initialised(lr_batch_contact_init);
    c.friction = friction, c.restitution = restitution, c.rolling_resistance = rolling;
    c.flags = LR_CONTACT_NEVER_REST;
    return c;
}
inline void set_contact(const World& w, lr_batch batch, const lr_batch_contact& c) {
    REQUIRE(lr_batch_set_contact(w.get(), batch, &c) == LR_OK);
}
inline lr_collider_desc surface(lr_collider_desc d, float friction, float restitution = 0.0f) {
    d.friction = friction, d.restitution = restitution;
    return d;
}
template <size_t N> void put(float (&to)[N], const std::array<double, N>& from) {
    for (size_t k = 0; k < N; ++k) to[k] = narrow(from[k]);
}
// World velocity of the body at an index of a view.
inline Vec velocity_of(const lr_batch_view& v, uint32_t i) {
    const Quat q{wide(v.orientation[0][i]), wide(v.orientation[1][i]), wide(v.orientation[2][i]),
                 wide(v.orientation[3][i])};
    return to_world(q, {wide(v.velocity[0][i]), wide(v.velocity[1][i]), wide(v.velocity[2][i])});
}

} // namespace test
