// Extreme body contact: all bodies at one point, all sizes at once, no memory, non-finite numbers.
#include "support/body_contact.h"
#include "support/counting_memory.h"
#include "support/quick.h"

#include <string>

using namespace test;

namespace {

bool finite(const World& w, lr_batch batch) {
    const lr_batch_view v = view_of(w, batch);
    const std::vector<Velocity> u = velocities_of(w, batch);
    bool good = true;
    for (uint32_t i = 0; i < v.count; ++i)
        for (size_t k = 0; k < 3; ++k)
            good = good && std::isfinite(v.position[k][i]) && std::isfinite(u[i].linear[k]) &&
                   std::isfinite(u[i].angular[k]) && std::isfinite(v.orientation[k][i]);
    return good;
}
// Mean distance from the centre.
double spread(const World& w, lr_batch batch) {
    const lr_batch_view v = view_of(w, batch);
    Vec middle{};
    for (uint32_t i = 0; i < v.count; ++i)
        for (size_t k = 0; k < 3; ++k) middle[k] += wide(v.position[k][i]) / v.count;
    double sum = 0.0;
    for (uint32_t i = 0; i < v.count; ++i) {
        const Vec x{wide(v.position[0][i]), wide(v.position[1][i]), wide(v.position[2][i])};
        sum += length(x - middle) / v.count;
    }
    return sum;
}

struct Log {
    std::vector<std::string> lines;
    static void write(void* user, int32_t, const char* message) {
        static_cast<Log*>(user)->lines.emplace_back(message);
    }
};

} // namespace

TEST_CASE("bodies all at one point come apart" * doctest::test_suite("native")) {
    for (int kind : {0, 1})
        for (uint32_t count : {2u, 30u, 60u}) {
            CAPTURE(kind);
            CAPTURE(count);
            const World world = weightless();
            const Asset asset = kind == 0 ? make(rigid_box(0.04, 0.03, 0.05, 300.0)) : leaf();
            const lr_batch batch = add_batch(world, unloaded(), asset, count);
            set_contact(world, batch, contact_desc(0.5f, 0.0f));
            set_pair(world, batch, batch);
            for (uint32_t i = 0; i < count; ++i) add_body(world, batch, at_rest_at({1.0, 2.0, 3.0}));
            std::string text;
            for (int n = 0; n < 40; ++n) {
                steps(world, 1, 1.0f / 60.0f, 2);
                if (n == 0 || n == 9 || n == 39) text += " " + std::to_string(spread(world, batch));
            }
            MESSAGE(kind << " " << count << ": spread" << text << " fastest " << fastest_of(world, batch));
            CHECK(finite(world, batch));
            CHECK(view_of(world, batch).count == count);
            CHECK(spread(world, batch) > (kind == 0 ? 0.005 : 2e-5));
        }
}

TEST_CASE("bodies of all sizes meet" * doctest::test_suite("native")) {
    Random random(2);
    const World world = make(world_desc());
    const Asset asset = make(rigid_box(1.0, 0.7, 0.5, 300.0));
    const lr_batch batch = add_batch(world, unloaded(), asset, 100);
    set_contact(world, batch, contact_desc(0.5f, 0.1f));
    set_pair(world, batch, batch);
    add_collider(world, collider_desc(LR_COLLIDER_PLANE));
    for (int i = 0; i < 100; ++i) {
        lr_body_desc d = strewn(random, 5.0);
        d.position[1] += 3.0f;
        d.scale = narrow(random.logarithmic(0.001, 1000.0));
        add_body(world, batch, d);
    }
    steps(world, 30, 1.0f / 60.0f, 2);
    CHECK(finite(world, batch));
    CHECK(view_of(world, batch).count == 100);
}

// Ten small bodies fall on a box of a thousand times their size.
TEST_CASE("small bodies land on large ones" * doctest::test_suite("native")) {
    for (double scale : {0.01, 1.0, 100.0}) {
        if (scale > 1.0 && quick()) continue; // ten times as many steps
        const World world = make(world_desc());
        const Asset asset = make(rigid_box(0.1, 0.1, 0.1, 300.0));
        const lr_batch large = add_batch(world, unloaded(), asset, 1), small = add_batch(world, unloaded(), asset, 16);
        for (lr_batch b : {large, small}) set_contact(world, b, contact_desc(0.5f, 0.0f));
        set_pair(world, large, small);
        add_collider(world, collider_desc(LR_COLLIDER_PLANE));
        lr_body_desc d = at_rest_at({0.0, 0.5 * scale, 0.0});
        d.scale = narrow(10.0 * scale);
        add_body(world, large, d);
        for (int i = 0; i < 10; ++i) {
            d = at_rest_at({(0.08 * i - 0.36) * scale, (1.0 + 0.01) * scale, 0.01 * i * scale});
            d.scale = narrow(0.1 * scale);
            add_body(world, small, d);
        }
        const int frames = static_cast<int>(60.0 * std::sqrt(std::max(scale, 1.0)));
        steps(world, frames, 1.0f / 60.0f, scale < 1.0 ? 8 : 4);
        const lr_batch_view v = view_of(world, small);
        for (uint32_t i = 0; i < v.count; ++i) {
            CAPTURE(scale);
            CHECK(wide(v.position[1][i]) / scale == doctest::Approx(1.005).epsilon(0.001));
        }
    }
}

TEST_CASE("bodies whose values are not finite, or far away, harm no others") {
    const World world = make(world_desc()), without = make(world_desc());
    const Asset asset = make(rigid_box(0.1, 0.1, 0.1, 300.0));
    std::vector<double> height;
    for (const World* w : {&world, &without}) {
        const lr_batch batch = add_batch(*w, unloaded(), asset, 32);
        set_contact(*w, batch, contact_desc(0.5f, 0.0f));
        set_pair(*w, batch, batch);
        add_collider(*w, collider_desc(LR_COLLIDER_PLANE));
        const lr_body lower = add_body(*w, batch, at_rest_at({0.0, 0.05, 0.0}));
        const lr_body upper = add_body(*w, batch, at_rest_at({0.01, 0.2, 0.0}));
        if (w == &world) {
            for (float x : {1e5f, 1e6f, -1e6f}) {
                lr_body_desc d = body_desc();
                d.position[0] = x;
                d.position[1] = 1.0f;
                add_body(*w, batch, d);
            }
            lr_body_desc d = at_rest_at({5.0, 1.0, 0.0});
            const lr_body wild = add_body(*w, batch, d);
            lr_body_force f = initialised(lr_body_force_init);
            f.body = wild;
            f.mode = LR_FORCE_MODE_VELOCITY;
            f.force[0] = 1e6f;
            REQUIRE(lr_body_add_force(w->get(), &f, 1) == LR_OK);
        }
        steps(*w, 60, 1.0f / 60.0f, 2);
        height.push_back(wide(state_of(*w, upper).position[1]));
        CHECK(state_of(*w, lower).position[1] == doctest::Approx(0.05).epsilon(0.01));
    }
    CHECK(height[0] == doctest::Approx(0.15).epsilon(0.01));
    CHECK(height[0] == height[1]);
}

TEST_CASE("a step without memory lets bodies through each other, says so, and loses nothing" *
          doctest::test_suite("native")) {
    const Asset asset = make(rigid_box(0.1, 0.1, 0.1, 300.0));
    CountingAllocator memory;
    uint64_t refused = 0;
    for (uint64_t k = 0; k < 200; ++k) {
        Log log;
        lr_world_desc wd = world_desc();
        wd.allocator = memory.callbacks();
        wd.log = Log::write;
        wd.log_user = &log;
        const World world = make(wd);
        const lr_batch batch = add_batch(world, unloaded(), asset, 64);
        set_contact(world, batch, contact_desc(0.5f, 0.0f));
        set_pair(world, batch, batch);
        add_collider(world, collider_desc(LR_COLLIDER_PLANE));
        std::vector<lr_body> ids(40);
        for (size_t i = 0; i < 40; ++i) {
            const size_t tower = i / 2;
            ids[i] =
                add_body(world, batch, at_rest_at({0.3 * static_cast<double>(tower), i % 2 == 0 ? 0.05 : 0.149, 0.0}));
        }
        const uint64_t before = memory.calls;
        memory.fail_at = memory.calls + k;
        memory.fail_after = true;
        const lr_status status = lr_world_step(world.get(), 1.0f / 60.0f, 2);
        const bool failed = memory.calls > before + k;
        memory.fail_at = CountingAllocator::never;
        memory.fail_after = false;
        CAPTURE(k);
        CHECK(finite(world, batch));
        CHECK(view_of(world, batch).count == 40);
        CHECK(status == (failed ? LR_ERROR_OUT_OF_MEMORY : LR_OK));
        CHECK(info_of(world).substep_count == 2);
        CHECK(log.lines.size() == (failed ? 1u : 0u));
        refused += failed;
        // The ground still holds them.
        for (lr_body b : ids) CHECK(state_of(world, b).position[1] > 0.045f);
        // The next steps have memory again, and separate them.
        steps(world, 10, 1.0f / 60.0f, 2);
        CHECK(log.lines.size() == (failed ? 1u : 0u));
        CHECK(wide(state_of(world, ids[1]).position[1] - state_of(world, ids[0]).position[1]) > 0.098);
        if (!failed) break;
    }
    MESSAGE(refused << " refusals");
    CHECK(refused > 10);
    CHECK(memory.live() == 0);
    CHECK(!memory.mismatch);
}
