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
    c.flags = LR_CONTACT_NEVER_SLEEP;
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
inline Quat any_turn(Random& random) {
    Quat q;
    for (double& x : q) x = random.uniform(-1.0, 1.0);
    return normalised(q);
}
// n cells of `cell` along x and z about the origin, z = 0 at the middle, heights by height(x, z).
template <class Height> Triangles fine_sheet(uint32_t n, float cell, const Height& height) {
    Triangles t;
    const float half = 0.5f * cell * static_cast<float>(n);
    for (uint32_t k = 0; k <= n; ++k)
        for (uint32_t i = 0; i <= n; ++i) {
            const float x = cell * static_cast<float>(i) - half, z = cell * static_cast<float>(k) - half;
            t.vertices.insert(t.vertices.end(), {x, height(x, z), z});
        }
    for (uint32_t k = 0; k < n; ++k)
        for (uint32_t i = 0; i < n; ++i) {
            const uint32_t a = i + (n + 1) * k, b = a + n + 1;
            t.indices.insert(t.indices.end(), {a, b, a + 1, a + 1, b, b + 1});
        }
    return t;
}
// m/s, of the fastest body of a batch.
inline double fastest_of(const World& w, lr_batch batch) {
    double fastest = 0.0;
    for (const Velocity& v : velocities_of(w, batch)) fastest = std::max(fastest, length(vec(v.linear)));
    return fastest;
}

} // namespace test
