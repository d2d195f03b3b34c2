#include "base/counter_random.h"

#include "kernel/math/lanes.h"

#include <doctest/doctest.h>

using namespace lr;

TEST_CASE("spawns use the noise's generator, with their own counters") {
    const test::Lanes lanes = test::lanes().front();
    constexpr uint64_t seed = 0x0123456789abcdefull;
    for (uint32_t noise_seed : {1u, 77u, 0xffffffffu})
        for (uint32_t life : {0u, 1u, 500u}) {
            CounterRandom random(seed, noise_seed, life);
            for (uint32_t block = 0; block < 3; ++block) {
                const uint32_t counter[4] = {noise_seed, life, block, 0x62697274u};
                uint32_t expected[4];
                lanes.philox(counter, seed, expected);
                for (uint32_t word : expected) CHECK(random.bits() == word);
            }
        }
}

TEST_CASE("uniform numbers lie inside, and points of the disc too") {
    CounterRandom random(1, 2, 3);
    double sum = 0.0, square = 0.0;
    constexpr int count = 100000;
    for (int i = 0; i < count; ++i) {
        const double u = random.uniform();
        if (!(u > 0.0 && u < 1.0)) FAIL("outside");
        sum += u, square += u * u;
    }
    CHECK(sum / count == doctest::Approx(0.5).epsilon(0.005));
    CHECK(square / count == doctest::Approx(1.0 / 3.0).epsilon(0.01));
    for (int i = 0; i < 1000; ++i) {
        double x, y;
        const double s = random.disc(x, y);
        if (!(s > 0.0 && s <= 1.0 && s == x * x + y * y)) FAIL("outside the disc");
    }
}
