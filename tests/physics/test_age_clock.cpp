#include "support/scene.h"

using namespace test;

namespace {

double age_after(int32_t integrator, double start, double h, int steps_of_most) {
    const Asset asset = leaf();
    const World world = weightless();
    lr_batch_desc bd = batch_desc();
    bd.load_model = LR_LOADS_NONE;
    bd.integrator = integrator;
    const lr_batch batch = add_batch(world, bd, asset, 1);
    lr_body_desc d = body_desc();
    d.age = narrow(start);
    const lr_body id = add_body(world, batch, d);
    steps(world, steps_of_most, narrow(h * LR_MAX_SUBSTEPS), LR_MAX_SUBSTEPS);
    return wide(state_of(world, id).age);
}

} // namespace

TEST_CASE("an age lasts: 24 hours of 4 ms, and of steps that are nothing beside the age" *
          doctest::test_suite("long-exact")) {
    // 330 steps of 65536 substeps: 24.03 h. A plain sum of floats stops at 65536 s.
    const double day = 330.0 * LR_MAX_SUBSTEPS * wide(narrow(0.004));
    CHECK(age_after(LR_INTEGRATOR_DEFAULT, 0.0, 0.004, 330) == doctest::Approx(day).epsilon(1e-6));
    for (int32_t integrator : {LR_INTEGRATOR_RK4, LR_INTEGRATOR_DEFAULT}) {
        CHECK(age_after(integrator, 0.0, 0.001, 20) == doctest::Approx(20 * 65.536).epsilon(1e-6));
        // Half a ulp of a million seconds is 31 substeps.
        CHECK(age_after(integrator, 1e6, 0.001, 20) - 1e6 == doctest::Approx(20 * 65.536).epsilon(1e-4));
        CHECK(age_after(integrator, 0.0, 1e-4, 20) == doctest::Approx(20 * 6.5536).epsilon(1e-3));
    }
}

TEST_CASE("the rounding remainder of an age goes into snapshots and the hash, not into a new age") {
    const Asset asset = leaf();
    const World world = weightless();
    const lr_batch batch = add_batch(world, asset, 2);
    lr_body_desc d = body_desc();
    d.age = 5e4f;
    const lr_body id = add_body(world, batch, d);
    const uint64_t fresh = hash_of(world);
    steps(world, 1, 0.001f);
    const std::vector<unsigned char> snapshot = snapshot_of(world);
    CHECK(state_of(world, id).age == 5e4f); // half a ulp is 2 ms
    CHECK(hash_of(world) != fresh);
    steps(world, 9, 0.001f);
    CHECK(wide(state_of(world, id).age) == doctest::Approx(50000.01).epsilon(1e-7));
    const uint64_t expected = hash_of(world);
    const World other = weightless();
    add_batch(other, asset, 2);
    REQUIRE(lr_world_snapshot_restore(other.get(), snapshot.data(), snapshot.size()) == LR_OK);
    steps(other, 9, 0.001f);
    CHECK(hash_of(other) == expected);

    // A set age has its exact value: 1.9 ms later it is unchanged, 2.1 ms later it has changed.
    lr_body_state s = state_of(world, id);
    s.age = 5e4f;
    REQUIRE(lr_body_set_state(world.get(), id, &s) == LR_OK);
    steps(world, 1, 0.0019f);
    CHECK(state_of(world, id).age == 5e4f);
    steps(world, 1, 0.0002f);
    CHECK(state_of(world, id).age > 5e4f);
}
