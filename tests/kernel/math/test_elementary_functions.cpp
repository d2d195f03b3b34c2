// log, sine and cosine at enough values to cover single precision, and Philox against its published vectors.
#include "kernel/math/lanes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <string>

using namespace test;

namespace {

constexpr size_t fractions = size_t{1} << 24, block = size_t{1} << 16;
static_assert(fractions / 64 % block == 0);

// Distance to a float's neighbour at x, the unit of errors.
double ulp(double x) {
    int exponent = 0;
    std::frexp(x, &exponent);
    return std::ldexp(1.0, exponent - 24);
}

void check_log(size_t every) {
    const std::vector<Lanes> targets = lanes();
    REQUIRE(targets.size() >= 2);
    Aligned<float> x(block), got(block), other(block);
    double worst = 0.0;
    bool same = true, negative = true;
    for (size_t begin = 0; begin < fractions / every; begin += block) {
        // (n + 1/2)/2^24, rounded.
        for (size_t i = 0; i < block; ++i)
            x[i] = static_cast<float>((begin + i) * every) * 5.9604645e-8f + 2.9802322e-8f;
        targets[0].log(x.data(), got.data(), block);
        for (size_t t = 1; t < targets.size(); ++t) {
            targets[t].log(x.data(), other.data(), block);
            same = same && std::memcmp(got.data(), other.data(), 4 * block) == 0;
        }
        for (size_t i = 0; i < block; ++i) {
            const double exact = std::log(static_cast<double>(x[i]));
            negative = negative && got[i] <= 0.0f;
            if (exact != 0.0)
                worst = std::max(worst, std::abs(static_cast<double>(got[i]) - exact) / ulp(exact));
            else if (got[i] != 0.0f)
                worst = 1e9;
        }
    }
    MESSAGE("worst error ", worst, " ulp");
    CHECK(worst < 1.5);
    CHECK(same);
    CHECK(negative);
}

void check_sine_and_cosine(size_t every) {
    const std::vector<Lanes> targets = lanes();
    Aligned<float> x(block), sine(block), cosine(block), s(block), c(block);
    double worst = 0.0;
    bool same = true;
    for (size_t begin = 0; begin < fractions / every; begin += block) {
        for (size_t i = 0; i < block; ++i) x[i] = static_cast<float>((begin + i) * every) * 5.9604645e-8f;
        targets[0].sin_cos(x.data(), sine.data(), cosine.data(), block);
        for (size_t t = 1; t < targets.size(); ++t) {
            targets[t].sin_cos(x.data(), s.data(), c.data(), block);
            same = same && std::memcmp(s.data(), sine.data(), 4 * block) == 0 &&
                   std::memcmp(c.data(), cosine.data(), 4 * block) == 0;
        }
        for (size_t i = 0; i < block; ++i) {
            const double angle = 2.0 * std::numbers::pi * static_cast<double>(x[i]);
            worst = std::max({worst, std::abs(static_cast<double>(sine[i]) - std::sin(angle)),
                              std::abs(static_cast<double>(cosine[i]) - std::cos(angle))});
        }
    }
    // In units of the last place below 1.
    MESSAGE("worst error ", worst * 16777216.0, " of 2^-24");
    CHECK(worst * 16777216.0 < 2.0);
    CHECK(same);
    // Values that must be exact.
    Aligned<float> quarter(lane_block);
    for (size_t i = 0; i < 4; ++i) quarter[i] = 0.25f * static_cast<float>(i);
    targets[0].sin_cos(quarter.data(), sine.data(), cosine.data(), lane_block);
    CHECK((sine[0] == 0.0f && sine[1] == 1.0f && sine[2] == 0.0f && sine[3] == -1.0f));
    CHECK((cosine[0] == 1.0f && cosine[1] == 0.0f && cosine[2] == -1.0f && cosine[3] == 0.0f));
}

} // namespace

TEST_CASE("log of uniform numbers is right to an ulp and a half, and the same on every target") {
    check_log(64);
}
TEST_CASE("log of every uniform number is right to an ulp and a half" * doctest::test_suite("long-exact")) {
    check_log(1);
}
TEST_CASE("sine and cosine of fractions of a turn, and the same on every target") {
    check_sine_and_cosine(64);
}
TEST_CASE("sine and cosine of every fraction of a turn" * doctest::test_suite("long-exact")) {
    check_sine_and_cosine(1);
}

TEST_CASE("Philox4x32-7 gives the published vectors") {
    // Random123, kat_vectors: counter, key, output.
    const struct {
        uint32_t counter[4];
        uint64_t key;
        uint32_t expected[4];
    } vectors[] = {{{0, 0, 0, 0}, 0, {0x5f6fb709u, 0x0d893f64u, 0x4f121f81u, 0x4f730a48u}},
                   {{0xffffffffu, 0xffffffffu, 0xffffffffu, 0xffffffffu},
                    0xffffffffffffffffull,
                    {0x5207ddc2u, 0x45165e59u, 0x4d8ee751u, 0x8c52f662u}},
                   {{0x243f6a88u, 0x85a308d3u, 0x13198a2eu, 0x03707344u},
                    0x299f31d0a4093822ull,
                    {0x4dfccabau, 0x190a87f0u, 0xc47362bau, 0xb6b5242au}}};
    for (const Lanes& target : lanes())
        for (const auto& v : vectors) {
            CAPTURE(std::string(target.name));
            uint32_t out[4];
            target.philox(v.counter, v.key, out);
            for (size_t i = 0; i < 4; ++i) CHECK(out[i] == v.expected[i]);
        }
}
