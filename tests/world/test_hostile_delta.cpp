// Deltas, and snapshots given to make deltas of, that somebody has changed and sealed again. Memory is as long as it is said to be:
// AddressSanitizer watches its ends.
#include "support/random.h"
#include "support/scene.h"
#include "support/seal.h"

#include <algorithm>
#include <memory>

using namespace test;

namespace {

using Bytes = std::vector<unsigned char>;

struct Pair {
    Bytes base, next, delta;
    Pair() {
        const Asset asset = leaf();
        const World world = make(world_desc());
        const lr_batch batch = add_batch(world, asset, 90);
        std::vector<lr_body> ids;
        for (int i = 0; i < 70; ++i) {
            lr_body_desc d = body_desc();
            d.position[0] = 0.1f * static_cast<float>(i);
            ids.push_back(add_body(world, batch, d));
        }
        REQUIRE(lr_body_set_rest(world.get(), ids.data(), 40, LR_REST_RESTING) == LR_OK);
        steps(world, 2, 0.01f);
        base = snapshot_of(world);
        REQUIRE(lr_body_destroy(world.get(), ids.data() + 3, 2) == LR_OK);
        steps(world, 1, 0.01f);
        next = snapshot_of(world);
        delta.resize(lr_snapshot_delta_bound(next.size()));
        uint64_t written = 0;
        REQUIRE(lr_snapshot_delta_encode(base.data(), base.size(), next.data(), next.size(), delta.data(), delta.size(),
                                         &written) == LR_OK);
        delta.resize(written);
    }
};

void change(Bytes& bytes, Random& random, size_t first) {
    for (uint32_t n = 1 + random.below(3); n > 0; --n) {
        const size_t at = first + random.below(static_cast<uint32_t>(bytes.size() - first));
        const unsigned char values[] = {0,  1,  32,  33,  63,  64,
                                        95, 96, 127, 128, 255, static_cast<unsigned char>(random.bits())};
        bytes[at] = values[random.below(12)];
    }
}

#ifdef LR_TEST_QUICK
constexpr int rounds = 4000;
#else
constexpr int rounds = 30000;
#endif

} // namespace

TEST_CASE("the test's seal is that of deltas") {
    const Pair pair;
    Bytes bytes = pair.delta;
    seal(bytes);
    CHECK(bytes == pair.delta);
}

TEST_CASE("a delta that was changed and sealed is refused, or gives the snapshot that it says") {
    const Pair pair;
    Random random(6);
    std::unique_ptr<unsigned char[]> made(new unsigned char[pair.next.size()]);
    int refused = 0, same = 0;
    for (int round = 0; round < rounds; ++round) {
        Bytes delta = pair.delta;
        if (round % 5 == 0)
            delta.resize(delta.size() - 8 * (1 + random.below(static_cast<uint32_t>(delta.size() / 8 - 9))));
        const uint64_t size = delta.size();
        std::memcpy(delta.data() + 16, &size, 8);
        change(delta, random, round % 3 == 0 ? 32 : 64);
        seal(delta);
        uint64_t written = 0;
        const lr_status status = lr_snapshot_delta_apply(pair.base.data(), pair.base.size(), delta.data(), delta.size(),
                                                         made.get(), pair.next.size(), &written);
        if (status == LR_OK) {
            ++same;
            if (written != pair.next.size() || !std::equal(pair.next.begin(), pair.next.end(), made.get()))
                FAIL("other bytes than were sealed");
        } else {
            ++refused;
            if (status != LR_ERROR_SNAPSHOT_FORMAT && status != LR_ERROR_SNAPSHOT_MISMATCH &&
                status != LR_ERROR_BUFFER_TOO_SMALL)
                FAIL("status ", status);
        }
    }
    CHECK(refused > rounds / 2);
    CAPTURE(same); // what a change puts where it was
}

// It says what it will be, and may say so rightly: then it is for the restore to judge.
TEST_CASE("a delta of a snapshot that was changed and sealed is refused, or exact") {
    const Pair pair;
    Random random(7);
    int refused = 0, made = 0;
    for (int round = 0; round < rounds / 10; ++round) {
        Bytes base = pair.base, next = pair.next;
        for (Bytes* bytes : {&base, &next}) {
            if (random.below(3) == 0) continue;
            const size_t words[] = {8, 12, 112, 128, 140, 428, 748, 764, 768, 772, 792, 808};
            const size_t at =
                random.below(2) ? words[random.below(12)] : 4 * random.below(static_cast<uint32_t>(bytes->size() / 4));
            const uint32_t values[] = {0,    1,           70,          71,
                                       1000, 0x7fffffffu, 0xffffffffu, static_cast<uint32_t>(random.bits())};
            std::memcpy(bytes->data() + at, &values[random.below(8)], 4);
            seal(*bytes);
        }
        const uint64_t bound = lr_snapshot_delta_bound(next.size());
        std::unique_ptr<unsigned char[]> delta(new unsigned char[bound]), back(new unsigned char[next.size()]);
        uint64_t written = 0, size = 0;
        const lr_status status =
            lr_snapshot_delta_encode(base.data(), base.size(), next.data(), next.size(), delta.get(), bound, &written);
        if (status != LR_OK) {
            ++refused;
            if (status != LR_ERROR_SNAPSHOT_FORMAT) FAIL("status ", status);
            continue;
        }
        ++made;
        if (lr_snapshot_delta_apply(base.data(), base.size(), delta.get(), written, back.get(), next.size(), &size) !=
                LR_OK ||
            size != next.size() || !std::equal(next.begin(), next.end(), back.get()))
            FAIL("not the bytes");
    }
    CHECK(refused > 20);
    CHECK(made > 100);
}
