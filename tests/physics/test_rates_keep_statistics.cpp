// Batches at lower rates, by divisors and by a budget, fall like the same bodies at the world's own rate.
#include "support/quick.h"
#include "support/scene.h"

#include <cmath>

using namespace test;

namespace {

const uint32_t bodies = quick() ? 1000 : 4000;
constexpr float frame = 1.0f / 60.0f;
constexpr uint32_t substeps = 8;
constexpr int settle = 120, frames = 240;

struct Means {
    double descent, across, spin; // m/s, m/s, rad/s
};

// Bodies of several kinds, from rest at random angles.
struct Fall {
    std::vector<Asset> assets;
    World world = make(world_desc());
    std::vector<lr_batch> batches;

    explicit Fall(uint32_t divisor) {
        const double sizes[][4] = {{0.04, 0.01, 0.0002, 350.0},       // a leaf
                                   {0.05, 0.035, 0.000075, 700.0},    // paper, 10 x 7 cm
                                   {0.0225, 0.0225, 0.000075, 700.0}, // a disc
                                   {0.006, 0.003, 0.00006, 700.0}};   // confetti
        for (const auto& s : sizes) {
            assets.push_back(make(ellipsoid(s[0], s[1], s[2], s[3])));
            batches.push_back(add_batch(world, assets.back(), bodies));
            lr_emitter_desc e = initialised(lr_emitter_desc_init);
            REQUIRE(lr_batch_set_emitter(world.get(), batches.back(), &e) == LR_OK);
            REQUIRE(lr_batch_spawn(world.get(), batches.back(), bodies, nullptr) == LR_OK);
            REQUIRE(lr_batch_set_rate(world.get(), batches.back(), divisor) == LR_OK);
        }
    }

    uint64_t taken() const {
        uint64_t sum = 0;
        for (lr_batch b : batches) {
            lr_batch_pace p = initialised(lr_batch_pace_init);
            REQUIRE(lr_batch_get_pace(world.get(), b, &p) == LR_OK);
            CHECK(p.lost == 0.0);
            sum += p.body_substeps;
        }
        return sum;
    }

    std::vector<Means> run() const {
        steps(world, settle, frame, substeps);
        std::vector<Means> sums(batches.size());
        for (int i = 0; i < frames; ++i) {
            steps(world, 1, frame, substeps);
            for (size_t b = 0; b < batches.size(); ++b) add(velocities_of(world, batches[b]), sums[b]);
        }
        for (Means& m : sums)
            for (double* v : {&m.descent, &m.across, &m.spin}) *v /= static_cast<double>(frames) * bodies;
        return sums;
    }

private:
    static void add(const std::vector<Velocity>& velocities, Means& sum) {
        for (const Velocity& v : velocities) {
            sum.descent -= wide(v.linear[1]);
            sum.across += std::hypot(wide(v.linear[0]), wide(v.linear[2]));
            sum.spin += std::hypot(wide(v.angular[0]), wide(v.angular[1]), wide(v.angular[2]));
        }
    }
};

void compare(const std::vector<Means>& got, const std::vector<Means>& expected, double within) {
    for (size_t b = 0; b < got.size(); ++b) {
        CAPTURE(b);
        CHECK(got[b].descent == doctest::Approx(expected[b].descent).epsilon(within));
        CHECK(got[b].across == doctest::Approx(expected[b].across).epsilon(within));
        // Flutter and tumbling differ most in their spin: a few bodies more of one of them count.
        CHECK(got[b].spin == doctest::Approx(expected[b].spin).epsilon(within + 0.02));
    }
}

} // namespace

TEST_CASE("falls keep their statistics at any divisor and in a budget" * doctest::test_suite("long-exact")) {
    const Fall own(1);
    const std::vector<Means> expected = own.run();
    const uint64_t all = own.taken();
    SUBCASE("a divisor of 2") {
        const Fall half(2);
        compare(half.run(), expected, 0.03);
        CHECK(half.taken() * 2 == all);
    }
    SUBCASE("as much as the bodies' sizes allow") {
        const Fall least(1024);
        compare(least.run(), expected, 0.05);
        CHECK(static_cast<double>(least.taken()) < 0.22 * static_cast<double>(all));
    }
    SUBCASE("a budget for a fourth") {
        const Fall limited(1);
        REQUIRE(lr_world_set_budget(limited.world.get(), uint64_t{bodies} * 4 * substeps / 4) == LR_OK);
        compare(limited.run(), expected, 0.05);
        CHECK(static_cast<double>(limited.taken()) < 0.251 * static_cast<double>(all));
    }
}
