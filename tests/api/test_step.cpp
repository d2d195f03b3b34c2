#include "support/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

using namespace test;

namespace {

struct Log {
    std::vector<std::string> messages;
    int32_t last_level = 0;
    static void write(void* user, int32_t level, const char* message) {
        auto& self = *static_cast<Log*>(user);
        self.last_level = level;
        self.messages.emplace_back(message);
    }
};

} // namespace

TEST_CASE("each wrong time step has a status of its own, and the world goes on") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 4);
    add_body(world, batch, body_desc());
    steps(world, 1, 0.01f, 2);
    const uint64_t before = hash_of(world);
    const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    const struct {
        float dt;
        uint32_t substeps;
        lr_status status;
    } cases[] = {{0.0f, 1, LR_ERROR_TIMESTEP_ZERO},
                 {-0.0f, 1, LR_ERROR_TIMESTEP_ZERO},
                 {-0.01f, 1, LR_ERROR_TIMESTEP_NEGATIVE},
                 {-1e-45f, 1, LR_ERROR_TIMESTEP_NEGATIVE},
                 {nan, 1, LR_ERROR_TIMESTEP_NOT_FINITE},
                 {inf, 1, LR_ERROR_TIMESTEP_NOT_FINITE},
                 {-inf, 1, LR_ERROR_TIMESTEP_NOT_FINITE},
                 {1.001f, 1, LR_ERROR_TIMESTEP_TOO_LARGE},
                 {3e38f, 65536, LR_ERROR_TIMESTEP_TOO_LARGE},
                 {2.001f, 2, LR_ERROR_TIMESTEP_TOO_LARGE},
                 {0.01f, 0, LR_ERROR_SUBSTEPS},
                 {0.01f, 65537, LR_ERROR_SUBSTEPS},
                 {0.01f, 4294967295u, LR_ERROR_SUBSTEPS}};
    for (const auto& c : cases) {
        CAPTURE(c.dt);
        CAPTURE(c.substeps);
        CHECK(lr_world_step(world.get(), c.dt, c.substeps) == c.status);
        CHECK(hash_of(world) == before);
        CHECK(info_of(world).substep_count == 2);
    }
    CHECK(lr_world_step(world.get(), 1.0f, 1) == LR_OK);
    CHECK(lr_world_step(world.get(), 1e-6f, 65536) == LR_OK);
    CHECK(hash_of(world) != before);
}

TEST_CASE("the smallest time step leaves finite bodies") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 4);
    lr_body_desc d = body_desc();
    d.linear_velocity[0] = 1.0f;
    const lr_body body = add_body(world, batch, d);
    for (float dt : {1e-45f, 1e-38f, 1e-30f, 1e-20f}) {
        CHECK(lr_world_step(world.get(), dt, 1) == LR_OK);
        CHECK(lr_world_step(world.get(), dt, 7) == LR_OK);
    }
    const lr_body_state s = state_of(world, body);
    for (float v : {s.position[0], s.orientation[3], s.linear_velocity[0], s.angular_velocity[1], s.age})
        CHECK(std::abs(v) < 10.0f);
}

TEST_CASE("time and substeps are counted, and an empty world steps") {
    const World world = make(world_desc());
    steps(world, 10, 0.25f, 3);
    const lr_world_info info = info_of(world);
    CHECK(info.substep_count == 30);
    CHECK(info.time == 2.5);
    CHECK((info.batch_count == 0 && info.body_count == 0 && info.worker_count == 0));
}

TEST_CASE("age grows by dt") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 4);
    lr_body_desc d = body_desc();
    d.age = 3.0f;
    const lr_body body = add_body(world, batch, d);
    steps(world, 4, 0.125f, 4);
    CHECK(state_of(world, body).age == 3.5f);
}

TEST_CASE("the log says which function refused and why") {
    Log log;
    lr_world_desc wd = world_desc();
    wd.log = &Log::write;
    wd.log_user = &log;
    const Asset asset = leaf();
    const World world = make(wd);
    lr_world* const w = world.get();
    const lr_batch batch = add_batch(world, asset, 1);
    const lr_body body = add_body(world, batch, body_desc());
    CHECK(log.messages.empty());

    const lr_body_desc desc = body_desc();
    lr_body_state state = body_state();
    lr_batch_view view = initialised(lr_batch_view_init);
    const float nan3[3] = {std::numeric_limits<float>::quiet_NaN(), 0.0f, 0.0f};
    lr_batch_desc bd = batch_desc();
    lr_batch out{};
    unsigned char bytes[8] = {};
    const lr_body stale{body.id + 1};
    lr_aerodynamics loads = initialised(lr_aerodynamics_init);
    const struct {
        const char* function;
        lr_status status;
    } refused[] = {{"lr_world_step", lr_world_step(w, -1.0f, 1)},
                   {"lr_world_set_gravity", lr_world_set_gravity(w, nan3)},
                   {"lr_world_set_uniform_wind", lr_world_set_uniform_wind(w, 1e4f, 0.0f, 0.0f)},
                   {"lr_world_add_turbulence", lr_world_add_turbulence(w, nullptr, nullptr)},
                   {"lr_world_update_turbulence", lr_world_update_turbulence(w, {}, nullptr)},
                   {"lr_world_get_turbulence", lr_world_get_turbulence(w, {}, nullptr)},
                   {"lr_world_set_simd_target", lr_world_set_simd_target(w, 77)},
                   {"lr_world_snapshot_save", lr_world_snapshot_save(w, bytes, 8, nullptr)},
                   {"lr_world_snapshot_restore", lr_world_snapshot_restore(w, bytes, 8)},
                   {"lr_batch_create", lr_batch_create(w, &bd, &out)},
                   {"lr_batch_destroy", lr_batch_destroy(w, {})},
                   {"lr_batch_set_turbulence_table", lr_batch_set_turbulence_table(w, {}, nullptr)},
                   {"lr_batch_set_aerodynamics", lr_batch_set_aerodynamics(w, {}, nullptr)},
                   {"lr_batch_get_aerodynamics", lr_batch_get_aerodynamics(w, {}, &loads)},
                   {"lr_batch_set_load_gains", lr_batch_set_load_gains(w, {}, nullptr)},
                   {"lr_batch_get_view", lr_batch_get_view(w, {}, &view)},
                   {"lr_batch_write_transforms", lr_batch_write_transforms(w, batch, 99, bytes, 0, 1, nullptr)},
                   {"lr_batch_write_velocities", lr_batch_write_velocities(w, batch, bytes, 4, 1, nullptr)},
                   {"lr_body_create", lr_body_create(w, batch, &desc, 1, nullptr)},
                   {"lr_body_destroy", lr_body_destroy(w, &stale, 1)},
                   {"lr_body_get_state", lr_body_get_state(w, stale, &state)},
                   {"lr_body_set_state", lr_body_set_state(w, stale, &state)}};
    const size_t count = sizeof refused / sizeof refused[0];
    REQUIRE(log.messages.size() == count);
    for (size_t i = 0; i < count; ++i) {
        CAPTURE(log.messages[i]);
        CHECK(refused[i].status < 0);
        const std::string start = std::string(refused[i].function) + ": ";
        CHECK(log.messages[i].compare(0, start.size(), start) == 0);
        CHECK(log.messages[i].size() > start.size() + 5);
    }
    CHECK(log.last_level == LR_LOG_ERROR);
}

TEST_CASE("statuses have texts of their own") {
    std::set<std::string> texts;
    for (lr_status s = LR_OK; s >= LR_ERROR_REENTRANT; --s) {
        const char* const text = lr_status_string(s);
        REQUIRE(text != nullptr);
        CAPTURE(s);
        CHECK(std::string(text) != "unknown status");
        CHECK(texts.insert(text).second);
    }
    for (lr_status s : {1, LR_ERROR_REENTRANT - 1, -1000, INT32_MAX, INT32_MIN})
        CHECK(std::string(lr_status_string(s)) == "unknown status");
}

TEST_CASE("the loaded library is the header's") {
    CHECK(lr_version() == (uint32_t{LR_VERSION_MAJOR} << 22 | uint32_t{LR_VERSION_MINOR} << 12 | LR_VERSION_PATCH));
}

TEST_CASE("instruction sets are listed best first, named, and can be forced" * doctest::test_suite("native")) {
    const std::vector<int32_t> targets = simd_targets();
    REQUIRE(!targets.empty());
    CHECK(std::set<int32_t>(targets.begin(), targets.end()).size() == targets.size());
    std::set<std::string> names;
    for (int32_t target = LR_SIMD_AUTO; target <= LR_SIMD_PLAIN; ++target)
        CHECK(names.insert(lr_simd_target_name(target)).second);
    for (int32_t unknown : {-1, 7, 1000}) CHECK(std::string(lr_simd_target_name(unknown)) == "unknown");

    // Short buffers: written as far as they go; the count is complete.
    uint32_t count = 0;
    int32_t first[2] = {-7, -7};
    if (targets.size() > 1) {
        CHECK(lr_simd_targets(first, 1, &count) == LR_ERROR_BUFFER_TOO_SMALL);
        CHECK((count == targets.size() && first[0] == targets[0] && first[1] == -7));
    }
    const World world = make(world_desc());
    CHECK(info_of(world).simd_target == targets[0]);
    for (int32_t target = LR_SIMD_AUTO + 1; target <= LR_SIMD_PLAIN; ++target) {
        const bool has = std::count(targets.begin(), targets.end(), target) == 1;
        CHECK(lr_world_set_simd_target(world.get(), target) == (has ? LR_OK : LR_ERROR_UNSUPPORTED));
        if (has) CHECK(info_of(world).simd_target == target);
        lr_world_desc d = world_desc();
        d.simd_target = target;
        lr_world* forced = nullptr;
        CHECK(lr_world_create(&d, &forced) == (has ? LR_OK : LR_ERROR_UNSUPPORTED));
        lr_world_destroy(forced);
    }
    CHECK(lr_world_set_simd_target(world.get(), LR_SIMD_AUTO) == LR_OK);
    CHECK(info_of(world).simd_target == targets[0]);
    for (int32_t unknown : {-1, 7}) CHECK(lr_world_set_simd_target(world.get(), unknown) == LR_ERROR_INVALID_ARGUMENT);
}
