// Six Gaussians per body and substep: their distribution, and independence of all neighbours.
#include "kernel/math/lanes.h"
#include "support/quick.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <numbers>
#include <numeric>
#include <string>

using namespace test;

namespace {

const size_t count = quick() ? 1 << 14 : 1 << 18;
constexpr uint64_t seed = 20;

struct Draw {
    explicit Draw(size_t bodies = count) : n(bodies), values(6 * bodies) {}
    const float* component(size_t k) const { return values.data() + k * n; }
    size_t n;
    Aligned<float> values;
};

Aligned<uint32_t> keys_from(uint32_t first, size_t n) {
    Aligned<uint32_t> keys(n);
    std::iota(keys.begin(), keys.end(), first);
    return keys;
}

Draw draw_keys(const Aligned<uint32_t>& keys, uint64_t substep, uint64_t with_seed = seed) {
    Draw out(keys.size());
    lanes().front().gaussians(keys.data(), substep, with_seed, out.values.data(), out.n);
    return out;
}
// Noise seeds in a world's order.
Draw draw(uint64_t substep, uint64_t with_seed = seed, size_t n = count) {
    return draw_keys(keys_from(1, n), substep, with_seed);
}

// In standard errors, for independent Gaussians.
double correlation(const float* a, const float* b, size_t n) {
    double sum = 0.0;
    for (size_t i = 0; i < n; ++i) sum += static_cast<double>(a[i]) * static_cast<double>(b[i]);
    return sum / std::sqrt(static_cast<double>(n));
}

// Squares, with mean 0 and variance 1: a shared radius would correlate them.
Draw squares(const Draw& d) {
    Draw out(d.n);
    for (size_t i = 0; i < d.values.size(); ++i)
        out.values[i] = (d.values[i] * d.values[i] - 1.0f) * static_cast<float>(std::numbers::sqrt2 / 2.0);
    return out;
}

// Collects many correlations: the largest, and the mean square, which is 1 for independent numbers.
struct Correlations {
    void add(double c) {
        worst = std::max(worst, std::abs(c));
        sum += c * c;
        ++number;
    }
    void all(const Draw& a, const Draw& b, size_t shift = 0) {
        for (size_t i = 0; i < 6; ++i)
            for (size_t j = 0; j < 6; ++j) add(correlation(a.component(i), b.component(j) + shift, a.n - shift));
    }
    void check(double limit) const {
        const double mean = sum / number;
        MESSAGE(number, " correlations, largest ", worst, " standard errors, mean square ", mean);
        CHECK(worst < limit);
        CHECK(std::abs(mean - 1.0) < 5.0 * std::sqrt(2.0 / number));
    }
    double worst = 0.0, sum = 0.0, number = 0.0;
};

double normal_cdf(double x) {
    return 0.5 * std::erfc(-x / std::numbers::sqrt2);
}

// Chi-square in its own standard errors.
double chi_square(const std::vector<double>& observed, double expected) {
    double sum = 0.0;
    for (double o : observed) sum += (o - expected) * (o - expected) / expected;
    const double freedom = static_cast<double>(observed.size()) - 1.0;
    return (sum - freedom) / std::sqrt(2.0 * freedom);
}

} // namespace

TEST_CASE("the first six moments are those of a Gaussian, for each component") {
    constexpr int draws = 16;
    double moments[6][7] = {};
    for (uint64_t substep = 0; substep < draws; ++substep) {
        const Draw d = draw(substep);
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
    double worst = 0.0;
    for (size_t k = 0; k < 6; ++k)
        for (size_t m = 1; m <= 6; ++m) {
            CAPTURE(k);
            CAPTURE(m);
            const double error = (moments[k][m] / n - expected[m]) / std::sqrt(variance[m] / n);
            worst = std::max(worst, std::abs(error));
            // 36 of them: one exceeds four standard errors in 400 runs by chance, and the numbers are the same in every run.
            CHECK(std::abs(error) < 4.0);
        }
    MESSAGE("largest of 36: ", worst, " standard errors of ", n, " numbers");
}

TEST_CASE("the distribution function is that of a Gaussian, and so are the tails") {
    const double levels[] = {3.0, 3.5, 4.0, 4.5, 5.0};
    constexpr size_t bins = 1024;
    constexpr int draws = 16;
    double beyond[5] = {};
    std::vector<double> histogram[6];
    for (auto& h : histogram) h.assign(bins, 0.0);
    double largest = 0.0, widest = 0.0;
    for (uint64_t substep = 0; substep < draws; ++substep) {
        const Draw d = draw(substep, seed + 1);
        for (size_t k = 0; k < 6; ++k)
            for (size_t i = 0; i < count; ++i) {
                const double g = static_cast<double>(d.component(k)[i]), size = std::abs(g);
                largest = std::max(largest, size);
                for (size_t l = 0; l < 5; ++l) beyond[l] += size > levels[l];
                histogram[k][std::min(bins - 1, static_cast<size_t>(normal_cdf(g) * bins))] += 1.0;
            }
    }
    const double n = static_cast<double>(count) * draws;
    for (size_t l = 0; l < 5; ++l) {
        const double expected = 6.0 * n * std::erfc(levels[l] / std::numbers::sqrt2);
        CAPTURE(levels[l]);
        MESSAGE(beyond[l], " beyond ", levels[l], " sigma, expected ", expected);
        CHECK(std::abs(beyond[l] - expected) < 4.5 * std::sqrt(expected) + 1.0);
    }
    for (size_t k = 0; k < 6; ++k) {
        CAPTURE(k);
        const double chi = chi_square(histogram[k], n / bins);
        // Kolmogorov-Smirnov at the edges of the bins: exceeds 2.2 once in 10^4.
        double below = 0.0, kolmogorov = 0.0;
        for (size_t b = 0; b < bins; ++b) {
            below += histogram[k][b];
            kolmogorov = std::max(kolmogorov, std::abs(below / n - static_cast<double>(b + 1) / bins) * std::sqrt(n));
        }
        MESSAGE("chi-square ", chi, " standard errors, Kolmogorov-Smirnov ", kolmogorov);
        CHECK(std::abs(chi) < 4.5);
        CHECK(kolmogorov < 2.2);
        widest = std::max(widest, kolmogorov);
    }
    CHECK(widest > 0.3); // even the best of samples scatters
    // Among n the largest is about sqrt(2 ln n); none can be beyond 6.56.
    CHECK(largest > std::sqrt(2.0 * std::log(6.0 * n)) - 1.2);
    CHECK(largest < 6.56);
}

TEST_CASE("radii and angles of all pairs are independent") {
    constexpr size_t bins = 32;
    constexpr int draws = 8;
    // Three radii, then three angles; a table for each pair.
    std::vector<double> table[6][6];
    for (auto& row : table)
        for (auto& t : row) t.assign(bins * bins, 0.0);
    for (uint64_t substep = 0; substep < draws; ++substep) {
        const Draw d = draw(substep, seed + 2);
        for (size_t i = 0; i < count; ++i) {
            size_t bin[6];
            for (size_t pair = 0; pair < 3; ++pair) {
                const double x = static_cast<double>(d.component(2 * pair)[i]);
                const double y = static_cast<double>(d.component(2 * pair + 1)[i]);
                const double u = std::exp(-0.5 * (x * x + y * y)), turn = std::atan2(y, x) / (2.0 * std::numbers::pi);
                bin[pair] = std::min(bins - 1, static_cast<size_t>(u * bins));
                bin[3 + pair] = std::min(bins - 1, static_cast<size_t>((turn + 0.5) * bins));
            }
            for (size_t a = 0; a < 6; ++a)
                for (size_t b = a + 1; b < 6; ++b) table[a][b][bin[a] * bins + bin[b]] += 1.0;
        }
    }
    double worst = 0.0;
    for (size_t a = 0; a < 6; ++a)
        for (size_t b = a + 1; b < 6; ++b) {
            CAPTURE(a);
            CAPTURE(b);
            const double chi = chi_square(table[a][b], static_cast<double>(count) * draws / (bins * bins));
            worst = std::max(worst, std::abs(chi));
            CHECK(std::abs(chi) < 4.5);
        }
    MESSAGE("largest of 15 chi-squares: ", worst, " standard errors");
}

TEST_CASE("no correlation between components, nor of their squares") {
    Correlations c;
    for (uint64_t substep : {1000u, 1001u, 4000000000u}) {
        const Draw d = draw(substep), d2 = squares(d);
        for (size_t a = 0; a < 6; ++a)
            for (size_t b = a + 1; b < 6; ++b) {
                c.add(correlation(d.component(a), d.component(b), count));
                c.add(correlation(d2.component(a), d2.component(b), count));
                c.add(correlation(d.component(a), d2.component(b), count));
            }
    }
    c.check(5.0);
}

TEST_CASE("no correlation between bodies whose keys are near, or differ in a bit") {
    Correlations c;
    const Draw d = draw(1000), d2 = squares(d);
    for (size_t lag = 1; lag <= 16; ++lag) {
        c.all(d, d, lag);
        c.all(d2, d2, lag);
    }
    const size_t few = count / 8;
    for (uint32_t bit = 0; bit < 32; ++bit) {
        // All numbers with that bit clear, and with it set.
        Aligned<uint32_t> without = keys_from(0, few), with(few);
        for (size_t i = 0; i < few; ++i) {
            const uint32_t low = (1u << bit) - 1u;
            without[i] = (without[i] & low) | (without[i] & ~low) << 1;
            with[i] = without[i] | 1u << bit;
        }
        const Draw a = draw_keys(without, 1000), b = draw_keys(with, 1000);
        c.all(a, b);
        c.all(squares(a), squares(b));
    }
    c.check(5.5);
}

TEST_CASE("no correlation between substeps that are near, or differ in a bit") {
    Correlations c;
    const size_t few = count / 4;
    const Draw d = draw(1000, seed, few), d2 = squares(d);
    for (uint64_t lag = 1; lag <= 16; ++lag) {
        const Draw later = draw(1000 + lag, seed, few);
        c.all(d, later);
        c.all(d2, squares(later));
    }
    for (uint64_t bit = 0; bit < 64; ++bit) c.all(d, draw(1000 ^ uint64_t{1} << bit, seed, few));
    // Also the next body's: a counter that adds body and substep would correlate them.
    c.all(d, draw(1001, seed, few), 1);
    c.all(d, draw(999, seed, few), 1);
    c.check(5.5);
}

TEST_CASE("no correlation between seeds that are near, or differ in a bit") {
    Correlations c;
    const size_t few = count / 4;
    const Draw d = draw(1000, seed, few), d2 = squares(d);
    for (uint64_t next = 1; next <= 4; ++next) c.all(d2, squares(draw(1000, seed + next, few)));
    for (uint64_t bit = 0; bit < 64; ++bit) c.all(d, draw(1000, seed ^ uint64_t{1} << bit, few));
    c.check(5.5);
}

TEST_CASE("a body's sum over many substeps spreads like a random walk") {
    const size_t bodies = count / 64;
    constexpr uint64_t steps = 256;
    std::vector<double> sum(6 * bodies);
    for (uint64_t substep = 0; substep < steps; ++substep) {
        const Draw d = draw(substep, seed + 3, bodies);
        for (size_t i = 0; i < sum.size(); ++i) sum[i] += static_cast<double>(d.values[i]);
    }
    double square = 0.0;
    for (double s : sum) square += s * s / static_cast<double>(steps);
    const auto n = static_cast<double>(sum.size());
    CHECK(std::abs(square / n - 1.0) < 4.5 * std::sqrt(2.0 / n));
}

TEST_CASE("one body's numbers do not depend on its lane, and are the same on every target") {
    const std::vector<Lanes> targets = lanes();
    const Draw reference = draw(77);
    const Aligned<uint32_t> keys = keys_from(1, count);
    for (const Lanes& target : targets) {
        CAPTURE(std::string(target.name));
        Draw all;
        target.gaussians(keys.data(), 77, seed, all.values.data(), count);
        CHECK(std::memcmp(all.values.data(), reference.values.data(), 6 * 4 * count) == 0);
        Aligned<float> three(3 * count);
        target.three_gaussians(keys.data(), 77, seed, three.data(), count);
        CHECK(std::memcmp(three.data(), reference.values.data(), 3 * 4 * count) == 0);
        Aligned<uint32_t> same(lane_block, 1234u);
        Aligned<float> out(6 * lane_block);
        target.gaussians(same.data(), 77, seed, out.data(), lane_block);
        for (size_t k = 0; k < 6; ++k)
            for (size_t i = 0; i < lane_block; ++i) CHECK(out[k * lane_block + i] == reference.component(k)[1233]);
    }
}

TEST_CASE("the numbers are those that are held, on every target and compiler") {
    constexpr size_t bodies = 1 << 14;
    const Aligned<uint32_t> keys = keys_from(1, bodies);
    for (const Lanes& target : lanes()) {
        CAPTURE(std::string(target.name));
        Aligned<float> out(6 * bodies);
        target.gaussians(keys.data(), 0x123456789abcdefull, 0xfedcba9876543210ull, out.data(), bodies);
        uint64_t hash = 0xcbf29ce484222325ull; // FNV-1a, of words
        for (float g : out) hash = (hash ^ std::bit_cast<uint32_t>(g)) * 0x100000001b3ull;
        CHECK(hash == 854492528362666490ull);
    }
}

TEST_CASE("the noise's words are the generator's, at (key, substep, 0)") {
    constexpr uint64_t substep = 0x123456789abcdefull, key_of_world = 0xfedcba9876543210ull;
    const Aligned<uint32_t> keys = keys_from(0xfffffff8u, lane_block);
    for (const Lanes& target : lanes()) {
        CAPTURE(std::string(target.name));
        Aligned<uint32_t> words(4 * lane_block);
        target.words(keys.data(), substep, key_of_world, words.data(), lane_block);
        for (size_t i = 0; i < lane_block; ++i) {
            const uint32_t counter[] = {keys[i], static_cast<uint32_t>(substep), static_cast<uint32_t>(substep >> 32),
                                        0};
            uint32_t expected[4];
            target.philox(counter, key_of_world, expected);
            for (size_t k = 0; k < 4; ++k) CHECK(words[k * lane_block + i] == expected[k]);
        }
    }
}

TEST_CASE("log of extreme numbers") {
    for (const Lanes& target : lanes()) {
        Aligned<float> x(lane_block, 2.9802322e-8f), out(lane_block);
        x[1] = 1.0f;
        x[2] = 0x1.fffffep-1f;
        target.log(x.data(), out.data(), lane_block);
        CHECK(out[0] == doctest::Approx(std::log(2.9802322e-8)));
        CHECK(out[1] == 0.0f);
        CHECK(out[2] < 0.0f);
        CHECK(std::abs(static_cast<double>(out[2]) + 0x1p-24) < 1e-9 * 0x1p-24 + 0x1p-48);
    }
}
