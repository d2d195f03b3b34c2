// Tiles in space: their sizes, their bounds, and that the order of the bodies does not matter.
#include "body_contact/contact_tiles.h"

#include "support/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

using namespace lr;

namespace {

// A flat heap of two batches.
std::vector<TiledBody> heap(uint32_t count) {
    test::Random random(31);
    std::vector<TiledBody> bodies;
    for (uint32_t i = 0; i < count; ++i)
        bodies.push_back({{random.real(-3.0, 3.0), random.real(0.0, 0.2), random.real(-1.0, 1.0)},
                          random.below(2),
                          static_cast<uint32_t>(random.bits()),
                          i,
                          0});
    return bodies;
}
void shuffle(std::vector<TiledBody>& bodies, uint64_t seed) {
    test::Random random(seed);
    for (size_t i = bodies.size(); i > 1; --i) std::swap(bodies[i - 1], bodies[random.below(static_cast<uint32_t>(i))]);
}
std::vector<TiledBody> cut(std::vector<TiledBody> bodies) {
    const auto count = static_cast<uint32_t>(bodies.size());
    cut_into_tiles(bodies.data(), count, tile_levels(count));
    return bodies;
}
bool same(const TiledBody& a, const TiledBody& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}
} // namespace

TEST_CASE("tiles have 192 to 384 bodies, and fewer only where there are not so many") {
    for (uint32_t count : {1u, 191u, 383u, 384u, 385u, 1000u, 1535u, 1536u, 20011u}) {
        CAPTURE(count);
        std::vector<uint32_t> in(size_t{1} << tile_levels(count));
        for (const TiledBody& body : cut(heap(count))) ++in[body.tile];
        CHECK(*std::max_element(in.begin(), in.end()) <= 384);
        CHECK(*std::min_element(in.begin(), in.end()) >= std::min(count, 192u));
    }
    CHECK(tile_levels(0) == 0);
    CHECK(tile_levels(std::numeric_limits<uint32_t>::max()) == 10);
}

TEST_CASE("the first cut is across the heap's length, and neither half reaches into the other") {
    float low = std::numeric_limits<float>::infinity(), high = -low;
    const std::vector<TiledBody> bodies = cut(heap(4000));
    const uint32_t tiles = 1u << tile_levels(4000);
    for (const TiledBody& body : bodies) {
        if (body.tile < tiles / 2) high = std::max(high, body.x[0]);
        if (body.tile >= tiles / 2) low = std::min(low, body.x[0]);
    }
    CHECK(high <= low);
    CHECK(std::abs(low) < 0.3f);
}

TEST_CASE("tiles do not depend on the order of bodies, and bodies leave by batch, tile and noise seed") {
    std::vector<TiledBody> bodies = heap(3000);
    const std::vector<TiledBody> first = cut(bodies);
    const auto order = [](const TiledBody& b) { return std::tuple(b.member, b.tile, b.noise_seed); };
    CHECK(
        std::is_sorted(first.begin(), first.end(), [&](const auto& a, const auto& b) { return order(a) < order(b); }));
    for (uint64_t seed = 0; seed < 5; ++seed) {
        shuffle(bodies, seed);
        const std::vector<TiledBody> again = cut(bodies);
        CHECK(std::equal(first.begin(), first.end(), again.begin(), same));
    }
}

TEST_CASE("bodies in one place, at infinity or nowhere are cut by batch and noise seed") {
    for (const float where :
         {0.0f, -0.0f, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
        std::vector<TiledBody> bodies = heap(2000);
        for (size_t i = 0; i < bodies.size(); i += 2) std::fill_n(bodies[i].x, 3, where);
        const std::vector<TiledBody> first = cut(bodies);
        shuffle(bodies, 7);
        const std::vector<TiledBody> again = cut(bodies);
        CHECK(std::equal(first.begin(), first.end(), again.begin(), same));
    }
}
