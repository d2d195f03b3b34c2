// The cache of touching pairs: who is found, which pairs go, and what a snapshot may put into it.
#include "body_contact/kept_manifold.h"
#include "body_contact/pair_cache.h"

#include "collision/found_pair.h"
#include "collision/random_pairs.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <vector>

using namespace lr;

namespace {

CachedPair pair_of(uint64_t a, uint64_t b, float within = 1.0f) {
    CachedPair p{};
    p.a = a;
    p.b = b;
    p.turn = PackedRotation::of({0.0f, 0.0f, 0.0f, 1.0f});
    p.normal = PackedVector::of({0.0f, 1.0f, 0.0f}, 1.0f);
    p.within = within;
    p.count = 1;
    return p;
}
void put(Allocator& allocator, PairCache& cache, const std::vector<CachedPair>& pairs, uint32_t slot_from = 0) {
    REQUIRE(cache.begin(allocator, static_cast<uint32_t>(pairs.size()), [&](uint32_t s) { return s >= slot_from; }));
    std::copy(pairs.begin(), pairs.end(), cache.next());
    cache.commit(static_cast<uint32_t>(pairs.size()));
}
const unsigned char* bytes_of(const std::vector<CachedPair>& pairs) {
    return reinterpret_cast<const unsigned char*>(pairs.data());
}

} // namespace

TEST_CASE("cached pairs are found by both keys, in any order of entry, and hash alike") {
    Allocator allocator;
    test::Random random(3);
    std::vector<CachedPair> pairs;
    for (uint32_t i = 0; i < 3000; ++i)
        pairs.push_back(pair_of(pair_key(i % 3, 2 * i), pair_key(3 + i % 5, 7 * i + 1), static_cast<float>(i)));
    PairCache first, second;
    CHECK(first.find(1, 2) == nullptr);
    CHECK(first.hash() == 0);
    put(allocator, first, pairs);
    for (uint32_t i = 2999; i > 0; --i) std::swap(pairs[i], pairs[random.below(i + 1)]);
    put(allocator, second, pairs);
    CHECK(first.hash() == second.hash());
    for (const CachedPair& p : pairs) {
        const CachedPair* const found = first.find(p.a, p.b);
        REQUIRE(found);
        CHECK(found->within == p.within);
        CHECK(first.find(p.a, p.b + 1) == nullptr);
    }
    pairs[7].normal = PackedVector::of({1.0f, 0.0f, 0.0f}, 1.0f);
    put(allocator, second, pairs);
    CHECK(first.hash() != second.hash());
}

TEST_CASE("pairs with equal keys are not found: bodies can share a noise seed") {
    Allocator allocator;
    PairCache cache;
    put(allocator, cache, {pair_of(1, 5, 1.0f), pair_of(2, 5, 2.0f), pair_of(1, 5, 3.0f), pair_of(1, 5, 4.0f)});
    CHECK(cache.find(1, 5) == nullptr);
    REQUIRE(cache.find(2, 5));
    CHECK(cache.find(2, 5)->within == 2.0f);
}

TEST_CASE("a step replaces the pairs of its batches only, and a batch that ends takes its pairs along") {
    Allocator allocator;
    PairCache cache;
    const CachedPair low = pair_of(pair_key(0, 1), pair_key(1, 1)), across = pair_of(pair_key(1, 1), pair_key(4, 1)),
                     high = pair_of(pair_key(4, 1), pair_key(5, 1)), newer = pair_of(pair_key(4, 2), pair_key(5, 2));
    put(allocator, cache, {low, across, high});
    put(allocator, cache, {newer}, 4);
    CHECK(cache.count() == 3);
    CHECK(cache.find(low.a, low.b));
    CHECK(cache.find(across.a, across.b));
    CHECK(!cache.find(high.a, high.b));
    CHECK(cache.find(newer.a, newer.b));
    cache.forget(1);
    CHECK(cache.count() == 1);
    CHECK(!cache.find(across.a, across.b));
    CHECK(cache.find(newer.a, newer.b));
    cache.clear();
    CHECK(!cache.find(newer.a, newer.b));
}

TEST_CASE("pairs out of bounds are not consistent") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto consistent = [&](const CachedPair& p) {
        const std::vector<CachedPair> pairs{pair_of(1, 2), p};
        return PairCache::consistent(bytes_of(pairs), 2, 8);
    };
    const CachedPair good = pair_of(pair_key(3, 9), pair_key(7, 9));
    CHECK(consistent(good));
    const auto with = [&](auto&& change) {
        CachedPair p = good;
        change(p);
        return consistent(p);
    };
    CHECK(!with([](CachedPair& p) { p.b = pair_key(8, 9); }));
    CHECK(!with([](CachedPair& p) { std::swap(p.a, p.b); }));
    CHECK(!with([](CachedPair& p) { p.b = p.a; }));
    CHECK(!with([](CachedPair& p) { p.count = 5; }));
    CHECK(!with([](CachedPair& p) { p.sides = 4; }));
    CHECK(!with([](CachedPair& p) { p.turn.bits = 0; }));
    CHECK(!with([](CachedPair& p) { p.normal.part[1] = 0; }));
    CHECK(!with([&](CachedPair& p) { p.within = nan; }));
    CHECK(!with([](CachedPair& p) { p.within = -1.0f; }));
    CHECK(!with([&](CachedPair& p) { p.offset.z = nan; }));
    CHECK(!with([](CachedPair& p) { p.gap[3] = 1e20f; }));
    CHECK(!with([&](CachedPair& p) { p.pressed[0] = nan; }));
    CHECK(!with([&](CachedPair& p) { p.drag.y = nan; }));
    CHECK(!with([&](CachedPair& p) { p.spin = 1e20f; }));
}

TEST_CASE("packed rotations and arms are off by less than a millionth of a turn and 30 millionths of a reach") {
    test::Random random(8);
    float turn = 0.0f, arm = 0.0f;
    for (int i = 0; i < 10000; ++i) {
        const Rotation q = test::any_rotation(random), p = PackedRotation::of(q).unpacked();
        turn = std::max(turn, length(chord(inverse(p) * q)));
        const Vector v{random.real(-1.4, 1.4), random.real(-1.4, 1.4), random.real(-1.4, 1.4)};
        for (uint32_t k = 0; k < 3; ++k) arm = std::max(arm, std::abs(v[k] - PackedVector::of(v, 1.5f).times(1.5f)[k]));
    }
    CHECK(turn < 6e-6f);
    CHECK(arm < 3e-5f);
    for (const Rotation q :
         {Rotation{1.0f, 0.0f, 0.0f, 0.0f}, Rotation{0.0f, 0.0f, -1.0f, 0.0f}, Rotation{0.5f, -0.5f, 0.5f, -0.5f}})
        CHECK(std::abs(dot(PackedRotation::of(q).unpacked(), q)) > 0.999999f);
}

TEST_CASE("a kept manifold moves with its bodies: gaps are those of a new search, until they have moved too far") {
    const PairHull card = make_pair_hull(make_body_shape(test::asset_of(test::box_corners(0.035f, 2e-4f, 0.02f))));
    test::Random random(5);
    uint32_t kept = 0, let_go = 0;
    double worst = 0.0;
    for (int i = 0; i < 2000; ++i) {
        const Pose at_a{{1.0f, 2.0f, 3.0f}, test::any_rotation(random)};
        const Pose over{{random.real(-0.01, 0.01), random.real(3e-4, 6e-4), random.real(-0.01, 0.01)},
                        {0.0f, random.real(-0.5, 0.5), 0.0f, 1.0f}};
        const auto placed = [&](const Pose& relative) {
            const Rotation turn = normalised(relative.rotation);
            const Pose at{at_a.position + rotate(at_a.rotation, relative.position), normalised(at_a.rotation * turn)};
            return PairBody{&card, 1.0f, at, at, {}, 0.0f};
        };
        const PairBody a{&card, 1.0f, at_a, at_a, {}, 0.0f}, b = placed(over);
        const float within = 1e-3f + kept_way(a, b);
        Manifold found{}, now{};
        test::find_manifold(a, b, within, found);
        if (found.count == 0) continue;
        const CachedPair cached = cached_pair(1, 2, a, b, found, within, nullptr);
        Manifold same;
        REQUIRE(kept_manifold(cached, a, b, 1e-3f, same));
        for (uint32_t k = 0; k < found.count; ++k) CHECK(std::abs(same.contact[k].gap - found.contact[k].gap) < 1e-7f);
        const float way = random.real(0.0, 3e-4);
        Pose later = over;
        later.position.y += way;
        later.position.x += random.real(-3e-4, 3e-4);
        const PairBody moved = placed(later);
        if (!kept_manifold(cached, a, moved, 1e-3f, same)) {
            ++let_go;
            CHECK(way > 0.99f * kept_way(a, b) - 1e-6f);
            continue;
        }
        ++kept;
        test::find_manifold(a, moved, within, now);
        const auto least = [](const Manifold& m) {
            float gap = 1.0f;
            for (uint32_t k = 0; k < m.count; ++k) gap = std::min(gap, m.contact[k].gap);
            return gap;
        };
        worst = std::max(worst, std::abs(wide(least(same)) - wide(least(now))));
    }
    MESSAGE(kept << " kept, " << let_go << " searched again; gaps differ by " << worst << " m");
    CHECK(kept > 500);
    CHECK(let_go > 200);
    CHECK(worst < 2e-6);
}
