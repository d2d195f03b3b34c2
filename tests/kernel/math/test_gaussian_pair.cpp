// The distribution of a pair of Gaussians for uniform bits: sums over the bits themselves, no sampling.
#include "kernel/math/lanes.h"
#include "support/quick.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <string>

using namespace test;

namespace {

constexpr size_t block = size_t{1} << 16;
const uint32_t finest = quick() ? 1u << 13 : 1u << 7;
constexpr double quarter = std::numbers::pi / 2.0, unit = quarter / 2147483648.0; // radians of an angle's last place

// begin, begin + stride, ... below end: f(words, their squared radii, their number).
template <class F> void for_radii(const Lanes& target, uint64_t begin, uint64_t end, uint64_t stride, const F& f) {
    Aligned<uint32_t> words(block);
    Aligned<float> out(block);
    while (begin < end) {
        const size_t n = std::min<uint64_t>(block, (end - begin + stride - 1) / stride);
        for (size_t i = 0; i < block; ++i) words[i] = static_cast<uint32_t>(begin + std::min(i, n - 1) * stride);
        target.squared_radius(words.data(), out.data(), block);
        f(words.data(), out.data(), n);
        begin += n * stride;
    }
}

// Angles evenly over their whole range, at one radius: f(angles, pairs).
template <class F> void for_angles(const Lanes& target, uint32_t word, uint32_t stride, const F& f) {
    Aligned<uint32_t> words(block, word), angles(block);
    Aligned<float> first(block), second(block);
    for (uint64_t begin = 0; begin < uint64_t{1} << 32; begin += uint64_t{stride} * block) {
        for (size_t i = 0; i < block; ++i) angles[i] = static_cast<uint32_t>(begin + i * stride);
        target.pair(words.data(), angles.data(), first.data(), second.data(), block);
        f(angles.data(), first.data(), second.data());
    }
}

double angle_of(uint32_t bits) {
    return unit * static_cast<double>(static_cast<int32_t>(bits));
}

void check_squared_radius(uint32_t stride_of_most) {
    const Lanes target = lanes().front();
    double worst = 0.0;
    bool negative = false, rises = false;
    const auto check = [&](uint64_t begin, uint64_t end, uint64_t stride) {
        float before = 50.0f;
        for_radii(target, begin, end, stride, [&](const uint32_t* words, const float* out, size_t n) {
            for (size_t i = 0; i < n; ++i) {
                const auto x = static_cast<float>((words[i] & 0x7fffffffu) | 1u);
                const double exact = -2.0 * std::log(static_cast<double>(x) / 2147483648.0);
                negative = negative || !(out[i] >= 0.0f);
                rises = rises || (x < 0x1p31f && out[i] > before * (1.0f + 4e-7f));
                if (exact > 0.0)
                    worst = std::max(worst, std::abs(static_cast<double>(out[i]) / exact - 1.0));
                else if (!(out[i] < 1e-6f))
                    worst = 1.0;
                before = out[i];
            }
        });
    };
    // All words of the tails, floats below 2^31 (all of them at a stride of 2^7), and around 2^31, to which words round.
    check(0, 1u << 16, 1);
    check(0, uint64_t{1} << 31, stride_of_most);
    check((uint64_t{1} << 31) - (1u << 12), uint64_t{1} << 31, 1);
    check((uint64_t{1} << 32) - (1u << 12), uint64_t{1} << 32, 1); // the highest bit is a sign
    MESSAGE("worst relative error ", worst);
    CHECK(worst < 1.4e-6);
    CHECK_FALSE(negative);
    CHECK_FALSE(rises);
}

void check_radius_and_angle(uint32_t stride) {
    const Lanes target = lanes().front();
    Aligned<uint32_t> one(lane_block, 0x12345678u);
    Aligned<float> squared(lane_block);
    target.squared_radius(one.data(), squared.data(), lane_block);
    double radius_error = 0.0, angle_error = 0.0;
    for (uint32_t sign : {0u, 0x80000000u})
        for_angles(target, one[0] | sign, stride, [&](const uint32_t* angles, const float* first, const float* second) {
            for (size_t i = 0; i < block; ++i) {
                const double x = static_cast<double>(first[i]), y = static_cast<double>(second[i]);
                radius_error =
                    std::max(radius_error, std::abs((x * x + y * y) / static_cast<double>(squared[0]) - 1.0));
                const double angle = sign == 0 ? std::atan2(y, x) : std::atan2(-y, -x);
                angle_error = std::max(angle_error, std::abs(angle - angle_of(angles[i])));
            }
        });
    MESSAGE("squared radius ", radius_error, ", angle ", angle_error);
    CHECK(radius_error < 5e-7);
    CHECK(angle_error < 6e-6);
}

} // namespace

TEST_CASE("a pair's squared radius is twice the negative logarithm, never negative, and falls") {
    check_squared_radius(1u << 13);
}
TEST_CASE("a pair's squared radius at every float" * doctest::test_suite("long-exact")) {
    check_squared_radius(1u << 7);
}
TEST_CASE("a pair has its radius at every angle, and its angle to 6e-6") {
    check_radius_and_angle(1u << 15);
}
TEST_CASE("a pair has its radius and angle at 2^23 angles" * doctest::test_suite("long-exact")) {
    check_radius_and_angle(1u << 9);
}

TEST_CASE("angles are equally dense all around, to 5e-5") {
    const Lanes target = lanes().front();
    constexpr uint32_t stride = 1u << 23; // steps of 6e-3; their rounding is at most 2e-5 of a step
    Aligned<uint32_t> words(512, 0x40000000u), angles(512);
    Aligned<float> first(512), second(512);
    for (uint32_t i = 0; i < 512; ++i) angles[i] = (i + 256) % 512 * stride; // from -2^31 up
    target.pair(words.data(), angles.data(), first.data(), second.data(), 512);
    double worst = 0.0;
    const auto at = [&](size_t i) { return std::atan2(static_cast<double>(second[i]), static_cast<double>(first[i])); };
    for (size_t i = 1; i < 512; ++i) worst = std::max(worst, std::abs((at(i) - at(i - 1)) / (unit * stride) - 1.0));
    MESSAGE("worst difference of density ", worst);
    CHECK(worst < 5e-5);
}

TEST_CASE("moments to the sixth, summed over the bits") {
    const Lanes target = lanes().front();
    // Words in strata around their middles: each word below `few`, above it the middle of every stride.
    constexpr uint64_t few = 1u << 18;
    double weight = 0.0, radius[4] = {};
    const auto add = [&](uint64_t begin, uint64_t end, uint64_t stride) {
        for_radii(target, begin, end, stride, [&](const uint32_t*, const float* out, size_t n) {
            for (size_t i = 0; i < n; ++i) {
                double power = static_cast<double>(stride);
                for (double& moment : radius) moment += power, power *= static_cast<double>(out[i]);
            }
            weight += static_cast<double>(n * stride);
        });
    };
    add(0, few, 1);
    add(few + finest / 2, uint64_t{1} << 31, finest);
    CHECK(weight == 2147483648.0);
    double direction[4] = {}, odd = 0.0, count = 0.0;
    const double unit_radius = 1.0 / static_cast<double>([&] {
                                   Aligned<uint32_t> one(lane_block, 0x40000000u);
                                   Aligned<float> squared(lane_block);
                                   target.squared_radius(one.data(), squared.data(), lane_block);
                                   return squared[0];
                               }());
    for_angles(target, 0x40000000u, finest, [&](const uint32_t*, const float* first, const float* second) {
        for (size_t i = 0; i < block; ++i) {
            const double x = static_cast<double>(first[i]), y = static_cast<double>(second[i]);
            const double square = x * x * unit_radius;
            direction[0] += 1.0, direction[1] += square, direction[2] += square * square;
            direction[3] += square * square * square, odd += x * y * unit_radius;
        }
        count += static_cast<double>(block);
    });
    const double gaussian[] = {1.0, 1.0, 3.0, 15.0};
    const double of_angle[] = {1.0, 1.0 / 2.0, 3.0 / 8.0, 5.0 / 16.0}, of_radius[] = {1.0, 2.0, 8.0, 48.0};
    for (size_t m = 1; m <= 3; ++m) {
        CAPTURE(m);
        const double r = radius[m] / weight, c = direction[m] / count;
        MESSAGE("of radius ", r / of_radius[m] - 1.0, ", of direction ", c / of_angle[m] - 1.0);
        CHECK(std::abs(r / of_radius[m] - 1.0) < 2e-6);
        CHECK(std::abs(c / of_angle[m] - 1.0) < 4e-6);
        CHECK(std::abs(r * c / gaussian[m] - 1.0) < 5e-6);
    }
    CHECK(std::abs(odd / count) < 1e-6);
}

TEST_CASE("tails, summed over all words that reach them") {
    // 2^30 radii: seventeen of them make up the probability beyond 6 sigma, and none is beyond 6.56.
    const Lanes target = lanes().front();
    const struct {
        double level, tolerance;
    } levels[] = {{3.0, 1e-5}, {4.0, 1e-5}, {5.0, 1e-4}, {5.5, 2e-3}, {6.0, 2e-2}};
    for (const auto& l : levels) {
        const auto words = static_cast<uint64_t>(2147483648.0 * std::exp(-0.5 * l.level * l.level)) + 64;
        double sum = 0.0;
        for_radii(target, 1, words, 2, [&](const uint32_t*, const float* out, size_t n) {
            for (size_t i = 0; i < n; ++i) {
                const double cosine = l.level / std::sqrt(static_cast<double>(out[i]));
                if (cosine < 1.0) sum += std::acos(cosine) / quarter;
            }
        });
        const double got = sum / 1073741824.0, expected = std::erfc(l.level / std::sqrt(2.0));
        CAPTURE(l.level);
        MESSAGE(l.level, " sigma: ", got / expected);
        CHECK(std::abs(got / expected - 1.0) < l.tolerance);
    }
    Aligned<uint32_t> smallest(lane_block, 0u);
    Aligned<float> out(lane_block);
    target.squared_radius(smallest.data(), out.data(), lane_block);
    CHECK(std::sqrt(static_cast<double>(out[0])) == doctest::Approx(6.5557).epsilon(1e-4));
}

TEST_CASE("pairs are the same on every target, extreme bits included") {
    const std::vector<Lanes> targets = lanes();
    const uint32_t extremes[] = {0u,          1u,          2u,          3u,          0x3fffffffu, 0x40000000u,
                                 0x7fffff80u, 0x7fffffbfu, 0x7fffffc0u, 0x7fffffffu, 0x80000000u, 0x80000001u,
                                 0xbfffffffu, 0xc0000000u, 0xfffffffeu, 0xffffffffu};
    constexpr size_t count = 1 << 16;
    Aligned<uint32_t> words(count), angles(count);
    for (uint32_t i = 0; i < count; ++i) {
        words[i] = i < 256 ? extremes[i / 16] : i * 0x9e3779b9u;
        angles[i] = i < 256 ? extremes[i % 16] : i * 0x85ebca6bu;
    }
    Aligned<float> first(count), second(count), other_first(count), other_second(count);
    targets[0].pair(words.data(), angles.data(), first.data(), second.data(), count);
    for (size_t i = 0; i < count; ++i)
        if (!(std::abs(first[i]) < 6.56f && std::abs(second[i]) < 6.56f)) FAIL("not a Gaussian: ", i);
    for (const Lanes& target : targets) {
        CAPTURE(std::string(target.name));
        target.pair(words.data(), angles.data(), other_first.data(), other_second.data(), count);
        CHECK(std::memcmp(first.data(), other_first.data(), 4 * count) == 0);
        CHECK(std::memcmp(second.data(), other_second.data(), 4 * count) == 0);
    }
}

TEST_CASE("angles are their own bits: no sum of bits of signs, radii and angles is always the same") {
    // Each of the 126 bits is a sum over GF(2) of the 128 bits of the words; their rank must be 126.
    constexpr size_t bits = 128;
    const Lanes target = lanes().front();
    Aligned<uint32_t> words(4 * bits), angles(3 * bits);
    for (size_t bit = 0; bit < bits; ++bit) words[bit / 32 * bits + bit] = 1u << bit % 32;
    target.angles(words.data(), angles.data(), bits);
    struct Row {
        uint64_t part[2];
    };
    std::vector<Row> rows; // for each input bit, the changed ones among the 126 outputs
    for (size_t bit = 0; bit < bits; ++bit) {
        Row row{};
        size_t at = 0;
        for (size_t pair = 0; pair < 3; ++pair) {
            const uint64_t outputs = words[pair * bits + bit] >> 10 | uint64_t{angles[pair * bits + bit] >> 12} << 22;
            for (size_t k = 0; k < 42; ++k, ++at) row.part[at / 64] |= (outputs >> k & 1) << at % 64;
        }
        rows.push_back(row);
    }
    size_t rank = 0;
    for (size_t column = 0; column < 126; ++column) {
        const auto set = [&](const Row& r) { return (r.part[column / 64] >> column % 64 & 1) != 0; };
        const auto pivot = std::find_if(rows.begin() + static_cast<ptrdiff_t>(rank), rows.end(), set);
        if (pivot == rows.end()) continue;
        std::swap(rows[rank], *pivot);
        for (size_t i = 0; i < rows.size(); ++i)
            if (i != rank && set(rows[i])) rows[i].part[0] ^= rows[rank].part[0], rows[i].part[1] ^= rows[rank].part[1];
        ++rank;
    }
    CHECK(rank == 126);
}
