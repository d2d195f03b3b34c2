// Invalid recordings: changed bytes, with and without a correct checksum. Each is refused by number or replayed, and nothing else.
#include "support/colliders.h"
#include "support/quick.h"
#include "support/random.h"
#include "support/wind.h"
#include "tools/lr_replay/recording.h"

using namespace test;
using lr::recording::FrameHeader;

namespace {

std::vector<unsigned char> varied() {
    const Asset flat = leaf(), plate = make(rigid_plate());
    const World world = make(world_desc());
    Recording recording;
    const lr_batch before = add_batch(world, flat, 6);
    add_body(world, before, body_desc());
    const std::vector<float> points = tetrahedron(0.3f);
    add_collider(world, hull_collider(points));
    recording.start(world);
    const lr_batch batch = add_batch(world, langevin(), plate, 6);
    const lr_body body = add_body(world, batch, body_desc());
    set_constant_table(world, batch, 2.0, 0.5, 6.5);
    const Triangles sheet = bumpy_sheet(2, 3);
    lr_collider_desc solids[2] = {mesh_collider(sheet), hull_collider(points)};
    REQUIRE(lr_collider_create(world.get(), solids, 2, nullptr) == LR_OK);
    const std::vector<float> samples(3 * 8 * 4, 0.5f);
    lr_wind_grid_desc grid = initialised(lr_wind_grid_desc_init);
    grid.counts[0] = grid.counts[1] = grid.counts[2] = 2;
    grid.frames = 4;
    grid.samples = samples.data();
    add_source(world, grid);
    REQUIRE(lr_world_set_wind_callback(
                world.get(),
                [](void*, const lr_wind_query* q) {
                    for (uint32_t i = 0; i < q->count; ++i) q->velocity[0][i] = 1.0f;
                },
                nullptr) == LR_OK);
    lr_emitter_desc emitter = initialised(lr_emitter_desc_init);
    REQUIRE(lr_batch_set_emitter(world.get(), batch, &emitter) == LR_OK);
    REQUIRE(lr_batch_spawn(world.get(), batch, 2, nullptr) == LR_OK);
    const float push[3] = {1e-3f, 0.0f, 0.0f};
    lr_force_arrays arrays = initialised(lr_force_arrays_init);
    arrays.count = 3;
    arrays.force[0] = arrays.force[1] = arrays.force[2] = push;
    REQUIRE(lr_batch_add_forces(world.get(), batch, &arrays) == LR_OK);
    steps(world, 2, 0.01f, 2);
    REQUIRE(lr_body_set_sleep(world.get(), &body, 1, LR_SLEEP_ASLEEP) == LR_OK);
    const std::vector<unsigned char> snapshot = snapshot_of(world);
    REQUIRE(lr_world_snapshot_restore(world.get(), snapshot.data(), snapshot.size()) == LR_OK);
    steps(world, 1, 0.01f, 1);
    return recording.bytes;
}

struct Frame {
    size_t at;
    FrameHeader header;
};
std::vector<Frame> frames_of(const std::vector<unsigned char>& bytes) {
    std::vector<Frame> all;
    for (size_t at = sizeof(lr::recording::FileHeader); at + sizeof(FrameHeader) <= bytes.size();) {
        Frame f{at, {}};
        std::memcpy(&f.header, bytes.data() + at, sizeof f.header);
        all.push_back(f);
        at += sizeof f.header + f.header.size;
    }
    return all;
}
void seal(std::vector<unsigned char>& bytes, const Frame& f, uint64_t number) {
    FrameHeader h;
    std::memcpy(&h, bytes.data() + f.at, sizeof h);
    h.checksum = lr::recording::frame_checksum(h, number, bytes.data() + f.at + sizeof h);
    std::memcpy(bytes.data() + f.at, &h, sizeof h);
}

} // namespace

TEST_CASE("a byte that has changed is found by its frame") {
    const std::vector<unsigned char> good = varied();
    REQUIRE(wrong_in(lr::replay::play(good.data(), good.size(), {})) == "");
    for (size_t at = 0; at < good.size(); at += at < 400 ? 1 : 37) {
        std::vector<unsigned char> bytes = good;
        bytes[at] ^= 0x40;
        CAPTURE(at);
        const bool version = at >= 12 && at < 16; // of the library that recorded
        const int fault = fault_of(bytes);
        // A frame longer than the file counts as a partly written frame.
        if (!version && fault == 0) {
            const lr::replay::Outcome played = lr::replay::play(bytes.data(), bytes.size(), {});
            CHECK(played.cut);
        }
    }
    std::vector<unsigned char> other = good;
    ++other[8]; // the format
    CHECK(fault_of(other) == static_cast<int>(lr::replay::FaultId::newer_format));
    CHECK(fault_of({}) == static_cast<int>(lr::replay::FaultId::not_a_recording));
}

TEST_CASE("changed records with right checksums are refused by number, or played, and nothing else happens") {
    const std::vector<unsigned char> good = varied();
    const std::vector<Frame> frames = frames_of(good);
    Random random(11);
    int refused = 0, played = 0;
    const int rounds = quick() ? 300 : 800;
    for (int round = 0; round < rounds; ++round) {
        std::vector<unsigned char> bytes = good;
        const auto pick = [&](size_t n) {
            return static_cast<size_t>(random.real(0.0, 0.999) * static_cast<float>(n));
        };
        const size_t which = pick(frames.size());
        const Frame& f = frames[which];
        // Words at a time, so that counts, sizes and kinds get hostile values; sometimes in the header.
        unsigned char* const payload = bytes.data() + f.at + sizeof(FrameHeader);
        const uint32_t hostile[] = {0u,          1u,          2u,          7u,     0x7fffffffu, 0x80000000u,
                                    0xffffffffu, 0x7f800000u, 0x7fc00000u, 65536u, 4096u};
        for (size_t k = 0, n = 1 + pick(3); k < n; ++k) {
            // A record begins with its counts and sizes.
            const size_t limit = std::min<size_t>(f.header.size, pick(3) == 0 ? f.header.size : 64);
            if (limit < 4) continue;
            const size_t at = pick(limit / 2 - 1) * 2;
            const uint32_t word = hostile[pick(std::size(hostile))];
            std::memcpy(payload + at, &word, pick(2) == 0 ? 4 : 2);
        }
        if (pick(12) == 0) {
            const auto kind = static_cast<uint16_t>(pick(14));
            std::memcpy(bytes.data() + f.at + offsetof(FrameHeader, kind), &kind, sizeof kind);
        }
        seal(bytes, f, which);
        // On the heap, of exactly its length: AddressSanitizer detects reads past the end.
        const std::vector<unsigned char> exact(bytes.begin(), bytes.end());
        ++(fault_of(exact, 3) != 0 ? refused : played);
    }
    CHECK(refused > rounds / 10);
    CHECK(played > rounds / 100);
}

TEST_CASE("records that are left out, doubled or exchanged are found by their numbers") {
    const std::vector<unsigned char> good = varied();
    const std::vector<Frame> frames = frames_of(good);
    for (size_t i = 0; i + 1 < frames.size(); ++i) {
        const auto from = good.begin() + static_cast<std::ptrdiff_t>(frames[i].at);
        const auto to = good.begin() + static_cast<std::ptrdiff_t>(frames[i + 1].at);
        std::vector<unsigned char> without(good.begin(), from);
        without.insert(without.end(), to, good.end());
        CHECK(fault_of(without) == static_cast<int>(lr::replay::FaultId::damaged));
        std::vector<unsigned char> doubled(good.begin(), to);
        doubled.insert(doubled.end(), from, good.end());
        CHECK(fault_of(doubled) == static_cast<int>(lr::replay::FaultId::damaged));
    }
}
