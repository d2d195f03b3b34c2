// Pairs in the lanes of a vector: a pair's contacts depend neither on the other pairs nor on the instruction set.
#include "collision/pair_contacts.h"

#include "kernel/integrator/step.h"
#include "langevin_rigid.h"
#include "random_pairs.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

using namespace lr;

namespace {

struct Found {
    uint32_t calls = 0, count = 0;
    WayContact contacts[most_pair_contacts] = {};
    bool operator==(const Found& other) const {
        return calls == other.calls && count == other.count &&
               std::memcmp(contacts, other.contacts, count * sizeof *contacts) == 0;
    }
    float least(float otherwise) const {
        float end = otherwise;
        for (uint32_t k = 0; k < count; ++k) end = std::min(end, contacts[k].end);
        return end;
    }
};

struct Pair {
    PairBody a, b;
    float margin;
};

std::vector<PairHull> some_shapes(test::Random& random) {
    std::vector<PairHull> pool;
    for (const float size : {0.04f, 0.1f}) {
        pool.push_back(make_pair_hull(test::leaf(size, 0.01f * size)));
        pool.push_back(
            make_pair_hull(make_body_shape(test::asset_of(test::box_corners(0.5f * size, 0.3f * size, 0.2f * size)))));
        pool.push_back(make_pair_hull(make_body_shape(test::asset_of(test::cloud(random, 8, 0.5f * size)))));
        pool.push_back(make_pair_hull(make_body_shape(test::asset_of(test::cloud(random, 40, 0.5f * size)))));
        pool.push_back(make_pair_hull(test::ellipsoid(0.5f * size, 0.4f * size, 0.3f * size)));
    }
    return pool;
}

// Of bodies at rest; some pairs continue together, or towards each other.
std::vector<Pair> some_pairs(test::Random& random, const std::vector<PairHull>& shapes, uint32_t count, bool move) {
    std::vector<Pair> pairs;
    for (uint32_t i = 0; i < count; ++i) {
        const PairHull &a = shapes[random.below(static_cast<uint32_t>(shapes.size()))],
                       &b = shapes[random.below(static_cast<uint32_t>(shapes.size()))];
        const float scale = random.real(0.3, 3.0), smaller = std::min(a.shape.reach, scale * b.shape.reach);
        const Pose at_a{{random.real(-3.0, 3.0), 0.0f, 1.0f}, test::any_rotation(random)};
        const Pose at_b{at_a.position + random.real(0.0, 1.3) * (a.shape.reach + scale * b.shape.reach) *
                                            test::any_direction(random),
                        test::any_rotation(random)};
        const auto moved = [&](const Pose& from) {
            if (!move) return from;
            return Pose{from.position + random.real(0.0, 0.5) * smaller * test::any_direction(random),
                        normalised({random.real(-0.2, 0.2), random.real(-0.2, 0.2), 0.0f, 1.0f}) * from.rotation};
        };
        pairs.push_back(
            {pair_body(a, 1.0f, at_a, moved(at_a)), pair_body(b, scale, at_b, moved(at_b)), 0.03f * smaller});
    }
    return pairs;
}

std::vector<Found> search(PairSearch* target, const std::vector<Pair>& pairs, const std::vector<uint32_t>& order,
                          uint32_t together) {
    std::vector<Found> all(pairs.size());
    PairBatch batch(target);
    const auto found = [&](uint32_t id, const WayContact* contacts, uint32_t count, const Manifold&) {
        ++all[id].calls;
        all[id].count = count;
        std::copy_n(contacts, count, all[id].contacts);
    };
    for (uint32_t i = 0; i < order.size(); ++i) {
        const Pair& pair = pairs[order[i]];
        batch.find(pair.a, pair.b, pair.margin, 0.0f, order[i], found);
        if ((i + 1) % together == 0) batch.finish(found);
    }
    batch.finish(found);
    return all;
}

} // namespace

TEST_CASE("contacts of a pair do not depend on the other lanes or the instruction set") {
    test::Random random(91);
    const std::vector<PairHull> shapes = some_shapes(random);
    const std::vector<Pair> pairs = some_pairs(random, shapes, test::rounds(6000), true);
    std::vector<uint32_t> order(pairs.size());
    for (uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    const std::vector<Found> alone = search(find_target(LR_SIMD_AUTO)->search_pairs, pairs, order, 1);
    uint32_t touching = 0;
    for (const Found& one : alone) touching += one.count > 0 ? 1u : 0u;
    CHECK(touching > pairs.size() / 5);
    CHECK(touching < pairs.size() * 4 / 5);
    for (const int32_t simd : {LR_SIMD_SSE4, LR_SIMD_AVX2, LR_SIMD_AVX512, LR_SIMD_NEON, LR_SIMD_PLAIN}) {
        if (!find_target(simd)) continue;
        CAPTURE(simd);
        for (const uint32_t together : {5u, 1000u}) {
            for (uint32_t i = static_cast<uint32_t>(order.size()) - 1; i > 0; --i)
                std::swap(order[i], order[random.below(i + 1)]);
            const std::vector<Found> found = search(find_target(simd)->search_pairs, pairs, order, together);
            uint32_t differ = 0;
            for (size_t i = 0; i < pairs.size(); ++i) differ += found[i] == alone[i] && found[i].calls == 1 ? 0u : 1u;
            CHECK(differ == 0);
        }
    }
}

TEST_CASE("non-finite bodies touch nothing and disturb no others") {
    test::Random random(93);
    const std::vector<PairHull> shapes = some_shapes(random);
    std::vector<Pair> pairs = some_pairs(random, shapes, 64, true);
    std::vector<uint32_t> order(pairs.size());
    for (uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    PairSearch* const target = find_target(LR_SIMD_AUTO)->search_pairs;
    const std::vector<Found> before = search(target, pairs, order, 64);
    for (uint32_t i = 0; i < pairs.size(); i += 3) {
        pairs[i].a.from.position.x = std::numeric_limits<float>::quiet_NaN();
        pairs[i].b.from.rotation.w = i % 2 == 0 ? pairs[i].b.from.rotation.w : std::numeric_limits<float>::infinity();
    }
    const std::vector<Found> after = search(target, pairs, order, 64);
    for (uint32_t i = 0; i < pairs.size(); ++i) {
        CAPTURE(i);
        if (i % 3 == 0)
            CHECK(after[i].count == 0);
        else
            CHECK(after[i] == before[i]);
    }
}

TEST_CASE("boxes of bodies that can touch are near, most others are not, on every instruction set") {
    test::Random random(97);
    const std::vector<PairHull> shapes = some_shapes(random);
    for (const bool move : {false, true}) {
        const std::vector<Pair> pairs = some_pairs(random, shapes, test::rounds(6000), move);
        std::vector<uint32_t> order(pairs.size());
        for (uint32_t i = 0; i < order.size(); ++i) order[i] = i;
        const std::vector<Found> contacts = search(find_target(LR_SIMD_AUTO)->search_pairs, pairs, order, 64);
        std::vector<PlacedBox> boxes;
        uint32_t apart = 0, dropped = 0;
        for (const uint32_t at : order) {
            const Pair& pair = pairs[at];
            NearPair near;
            const bool boxes_meet = relate(pair.a, pair.b, near_enough(pair.a, pair.b, pair.margin), near);
            // The pair, and neighbours in other lanes.
            boxes = {placed_box(pair.a, pair.margin), placed_box(pair.b, pair.margin)};
            const uint32_t lane = random.below(40);
            for (uint32_t i = 0; i < 40; ++i) {
                const Pair& other = pairs[random.below(static_cast<uint32_t>(pairs.size()))];
                boxes.push_back(placed_box(other.b, pair.margin));
            }
            std::vector<uint32_t> first;
            for (const int32_t simd : {LR_SIMD_SSE4, LR_SIMD_AVX2, LR_SIMD_AVX512, LR_SIMD_NEON, LR_SIMD_PLAIN}) {
                if (!find_target(simd)) continue;
                std::vector<uint32_t> others;
                for (uint32_t i = 0; i < 40; ++i) others.push_back(i == lane ? 1 : 2 + i);
                others.resize(find_target(simd)->near_boxes(boxes.data(), 0, others.data(),
                                                            static_cast<uint32_t>(others.size())));
                if (first.empty()) first = others;
                CHECK(others == first);
                CHECK(std::is_sorted(others.begin(), others.end(), [&](uint32_t a, uint32_t b) {
                    const auto place = [&](uint32_t box) { return box == 1 ? 2 + lane : box; };
                    return place(a) < place(b);
                }));
            }
            const bool kept = std::find(first.begin(), first.end(), 1u) != first.end();
            if (contacts[at].count != 0) CHECK(kept);
            apart += boxes_meet ? 0u : 1u;
            dropped += kept ? 0u : 1u;
        }
        CHECK(apart > pairs.size() / 50);
        CHECK(dropped > apart * 9 / 10); // boxes hold the rounding too, and margins their slack
    }
}
