// Six Gaussians a body and substep: moments, tails, and no correlation with any neighbour.
#include "kernel/lanes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <string>

using namespace test;

namespace {

#ifdef LR_TEST_QUICK
constexpr size_t count = 1 << 14;
#else
constexpr size_t count = 1 << 18;
#endif
constexpr uint64_t seed = 20;

struct Draw {
    Aligned<float> values = Aligned<float>(6 * count);
    const float* component(size_t k) const { return values.data() + k * count; }
};

Draw draw(const Lanes& target, uint64_t substep, uint64_t with_seed = seed) {
    Aligned<uint32_t> keys(count);
    std::iota(keys.begin(), keys.end(), 1u); // as a world hands them out
    Draw out;
    target.gaussians(keys.data(), substep, with_seed, out.values.data(), count);
    return out;
}

// In standard errors of a product of two independent Gaussians.
double correlation(const float* a, const float* b, size_t n) {
    double sum = 0.0;
    for (size_t i = 0; i < n; ++i) sum += static_cast<double>(a[i]) * static_cast<double>(b[i]);
    return sum / std::sqrt(static_cast<double>(n));
}

} // namespace

TEST_CASE("the first six moments are those of a Gaussian, for each component") {
    constexpr int draws = 4;
    double moments[6][7] = {};
    for (uint64_t substep = 0; substep < draws; ++substep) {
        const Draw d = draw(lanes()[0], substep);
        for (size_t k = 0; k < 6; ++k)
            for (size_t i = 0; i < count; ++i) {
                double power = 1.0;
                for (size_t m = 1; m <= 6; ++m) {
                    power *= static_cast<double>(d.component(k)[i]);
                    moments[k][m] += power;
                }
            }
    }
    const double expected[] = {1, 0, 1, 0, 3, 0, 15};
    // Variance of x^m: E x^(2m) - (E x^m)^2.
    const double variance[] = {0, 1, 2, 15, 96, 945, 10170};
    const double n = static_cast<double>(count) * draws;
    for (size_t k = 0; k < 6; ++k)
        for (size_t m = 1; m <= 6; ++m) {
            CAPTURE(k);
            CAPTURE(m);
            // 36 of them: one beyond four standard errors in 400 runs by chance, and the numbers are always the same.
            CHECK(std::abs(moments[k][m] / n - expected[m]) < 4.0 * std::sqrt(variance[m] / n));
        }
}

TEST_CASE("the distribution function is that of a Gaussian out to the tails") {
    const double levels[] = {0.1, 0.5, 1.0, 2.0, 3.0, 4.0};
    double beyond[6] = {}, largest = 0.0;
    constexpr int draws = 4;
    for (uint64_t substep = 0; substep < draws; ++substep) {
        const Draw d = draw(lanes()[0], substep, seed + 1);
        for (float g : d.values) {
            const double size = std::abs(static_cast<double>(g));
            largest = std::max(largest, size);
            for (size_t i = 0; i < 6; ++i) beyond[i] += size > levels[i];
        }
    }
    const double n = 6.0 * count * draws;
    for (size_t i = 0; i < 6; ++i) {
        const double p = std::erfc(levels[i] / std::sqrt(2.0));
        CAPTURE(levels[i]);
        CHECK(std::abs(beyond[i] - n * p) < 4.5 * std::sqrt(n * p * (1.0 - p)) + 1.0);
    }
    // 24 bits reach to 5.9; among n the largest is about sqrt(2 ln n).
    CHECK(largest > std::sqrt(2.0 * std::log(n)) - 1.2);
    CHECK(largest < 5.95);
}

TEST_CASE("no correlation between components, neighbouring bodies, consecutive substeps or seeds") {
    const Lanes target = lanes()[0];
    const Draw now = draw(target, 1000), next = draw(target, 1001), other_seed = draw(target, 1000, seed + 1),
               far = draw(target, 1000 + (1ull << 32)), high_seed = draw(target, 1000, seed + (1ull << 32));
    double worst = 0.0;
    const auto check = [&](const char* what, double c) {
        CAPTURE(std::string(what));
        CHECK(std::abs(c) < 5.0);
        worst = std::max(worst, std::abs(c));
    };
    for (size_t a = 0; a < 6; ++a) {
        for (size_t b = 0; b < 6; ++b) {
            if (b > a) check("components", correlation(now.component(a), now.component(b), count));
            check("bodies", correlation(now.component(a), now.component(b) + 1, count - 1));
            check("bodies 16 apart", correlation(now.component(a), now.component(b) + 16, count - 16));
            check("substeps", correlation(now.component(a), next.component(b), count));
            check("bodies and substeps", correlation(now.component(a), next.component(b) + 1, count - 1));
            check("seeds", correlation(now.component(a), other_seed.component(b), count));
        }
        check("high half of the substep", correlation(now.component(a), far.component(a), count));
        check("high half of the seed", correlation(now.component(a), high_seed.component(a), count));
    }
    // 210 of them: the largest of as many Gaussians is hardly ever under 1.5, if they vary at all.
    CHECK(worst > 1.5);
    // Squares too: a radius that two pairs share would show here only.
    Aligned<float> squares[6];
    for (size_t k = 0; k < 6; ++k)
        for (size_t i = 0; i < count; ++i)
            squares[k].push_back((now.component(k)[i] * now.component(k)[i] - 1.0f) / std::sqrt(2.0f));
    for (size_t a = 0; a < 6; ++a)
        for (size_t b = a + 1; b < 6; ++b) check("squares", correlation(squares[a].data(), squares[b].data(), count));
}

TEST_CASE("one body's numbers do not depend on its lane, and are the same on every target") {
    const std::vector<Lanes> targets = lanes();
    const Draw reference = draw(targets[0], 77);
    for (const Lanes& target : targets) {
        CAPTURE(std::string(target.name));
        CHECK(std::memcmp(draw(target, 77).values.data(), reference.values.data(), 6 * 4 * count) == 0);
        Aligned<uint32_t> keys(16, 1234u);
        Aligned<float> out(6 * 16);
        target.gaussians(keys.data(), 77, seed, out.data(), 16);
        for (size_t k = 0; k < 6; ++k)
            for (size_t i = 0; i < 16; ++i) CHECK(out[k * 16 + i] == reference.component(k)[1233]);
    }
}

TEST_CASE("extreme words give finite numbers") {
    for (const Lanes& target : lanes()) {
        Aligned<float> x(16, 2.9802322e-8f), out(16);
        x[1] = 1.0f; // what the largest word rounds to
        x[2] = 0x1.fffffep-1f;
        target.log(x.data(), out.data(), 16);
        CHECK(out[0] == doctest::Approx(std::log(2.9802322e-8)));
        CHECK(out[1] == 0.0f);
        CHECK(out[2] < 0.0f);
        CHECK(std::abs(static_cast<double>(out[2]) + 0x1p-24) < 1e-9 * 0x1p-24 + 0x1p-48);
    }
}
