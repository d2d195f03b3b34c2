// Engines and their plug-ins change the rounding mode and flush denormals. This changes no step, and a step does not change the mode.
#include "support/determinism_scenes.h"
#include "support/wind.h"

#include <cfenv>
#include <utility>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

using namespace test;

namespace {

struct RestoreMode {
    std::fenv_t saved{};
    RestoreMode() { std::fegetenv(&saved); }
    ~RestoreMode() {
        std::fesetenv(&saved);
#if defined(__SSE2__) // MinGW's fesetenv leaves traps unmasked
        _mm_setcsr(saved_control);
#endif
    }
#if defined(__SSE2__)
    const uint32_t saved_control = _mm_getcsr();
#endif
};

constexpr float frame_dt = 1.0f / 60.0f; // a constant, not computed in the tested mode

// A scene whose steps alone run in another mode.
template <class Change> uint64_t stepped_in(Change&& change, uint32_t workers) {
    PlayedScene scene = played_scenes()[0];
    scene.bodies = 4000; // several chunks, also for the workers
    Play play(scene, {.workers = workers});
    for (int frame = 0; frame < 10; ++frame) {
        lr_status status = LR_OK;
        {
            const RestoreMode restore;
            change();
            status = lr_world_step(play.world.get(), frame_dt, 3);
        }
        REQUIRE(status == LR_OK);
    }
    return hash_of(play.world);
}

} // namespace

TEST_CASE("the caller's rounding mode changes no bit of a step, and is there afterwards") {
    for (uint32_t workers : {0u, 2u}) {
        const uint64_t expected = stepped_in([] {}, workers);
        for (int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
            CAPTURE(mode);
            CHECK(stepped_in([mode] { std::fesetround(mode); }, workers) == expected);
        }
    }
    const World world = make(world_desc());
    const Asset asset = leaf();
    add_body(world, add_batch(world, asset, 1), body_desc());
    const RestoreMode restore;
    std::fesetround(FE_DOWNWARD);
    std::feraiseexcept(FE_DIVBYZERO);
    const lr_status status = lr_world_step(world.get(), 0.01f, 2);
    const int after = std::fegetround(), raised = std::fetestexcept(FE_ALL_EXCEPT);
    std::fesetround(FE_TONEAREST);
    CHECK(status == LR_OK);
    CHECK(after == FE_DOWNWARD);
    CHECK((raised & FE_DIVBYZERO) != 0);
}

// Threads inherit the mode of their parent thread.
TEST_CASE("a world created in another mode steps in its own") {
    const auto run = [](int mode, uint32_t workers) {
        lr_world_desc d = world_desc();
        d.worker_count = workers;
        lr_world* raw = nullptr;
        {
            const RestoreMode restore;
            std::fesetround(mode);
            lr_world_create(&d, &raw);
        }
        REQUIRE(raw != nullptr);
        const World world(raw);
        const Asset asset = leaf();
        const lr_batch batch = add_batch(world, asset, 20000); // enough chunks for every worker
        const std::vector<lr_body_desc> descs(20000, body_desc());
        REQUIRE(lr_body_create(raw, batch, descs.data(), 20000, nullptr) == LR_OK);
        steps(world, 5, frame_dt, 3);
        return hash_of(world);
    };
    const uint64_t expected = run(FE_TONEAREST, 0);
    for (int mode : {FE_UPWARD, FE_DOWNWARD})
        for (uint32_t workers : {0u, 2u}) CHECK(run(mode, workers) == expected);
}

#if defined(__SSE2__)
TEST_CASE("flushed denormals and unmasked traps of the caller change no bit either") {
    const uint64_t expected = stepped_in([] {}, 0);
    CHECK(stepped_in([] { _mm_setcsr(_mm_getcsr() | 0x8040u); }, 0) == expected); // flush to zero, denormals are zero
    CHECK(stepped_in([] { _mm_setcsr(_mm_getcsr() | 0x8040u); }, 2) == expected);
    // Inexact results would trap at once.
    CHECK(stepped_in([] { _mm_setcsr(_mm_getcsr() & ~0x1f80u); }, 0) == expected);

    const World world = make(world_desc());
    const uint32_t saved = _mm_getcsr(), mode = (saved | 0x8040u) & ~0x1000u;
    _mm_setcsr(mode);
    const lr_status status = lr_world_step(world.get(), 0.01f, 2);
    const uint32_t after = _mm_getcsr();
    _mm_setcsr(saved);
    CHECK(status == LR_OK);
    CHECK(after == mode);
}
#endif

#if defined(__aarch64__)
namespace {

constexpr uint64_t flush_to_zero = 1u << 24, upward = 1u << 22;

uint64_t control_word() {
    uint64_t word = 0;
    __asm__ volatile("mrs %0, fpcr" : "=r"(word));
    return word;
}
void set_control_word(uint64_t word) {
    __asm__ volatile("msr fpcr, %0" : : "r"(word));
}

} // namespace

TEST_CASE("flushed denormals of the caller change no bit either") {
    const uint64_t expected = stepped_in([] {}, 0);
    for (uint32_t workers : {0u, 2u})
        CHECK(stepped_in([] { set_control_word(control_word() | flush_to_zero); }, workers) == expected);

    const World world = make(world_desc());
    const uint64_t saved = control_word();
    set_control_word(saved | flush_to_zero | upward);
    const lr_status status = lr_world_step(world.get(), 0.01f, 2);
    const uint64_t after = control_word();
    set_control_word(saved);
    CHECK(status == LR_OK);
    CHECK(after == (saved | flush_to_zero | upward));
}
#endif

TEST_CASE("wind is made, sampled, updated and restored alike in any rounding mode of the caller") {
    const std::vector<float> samples = grid_samples();
    const std::vector<AnySource> sources = one_of_each(samples);
    const auto run = [&](int mode) {
        const World world = make(world_desc());
        std::vector<float> velocities = {0.3f, 0.2f, 0.1f, -1.0f, 0.5f, 2.0f};
        std::vector<unsigned char> snapshot;
        uint64_t hash = 0;
        bool ok = true;
        const RestoreMode restore;
        std::fesetround(mode);
        for (int round = 0; round < 2; ++round)
            for (const AnySource& d : sources) {
                lr_wind_source source{};
                ok = ok && add_wind(world.get(), &d, &source) == LR_OK;
                ok = ok && update_wind(world.get(), source, &d) == LR_OK;
                ok = ok && lr_world_step(world.get(), frame_dt, 3) == LR_OK;
            }
        snapshot.resize(lr_world_snapshot_size(world.get()));
        ok = ok && lr_world_snapshot_save(world.get(), snapshot.data(), snapshot.size(), nullptr) == LR_OK;
        ok = ok && lr_world_snapshot_restore(world.get(), snapshot.data(), snapshot.size()) == LR_OK;
        ok = ok && lr_world_sample_wind(world.get(), velocities.data(), 2, velocities.data()) == LR_OK;
        ok = ok && lr_world_hash(world.get(), &hash) == LR_OK;
        std::fesetround(FE_TONEAREST);
        REQUIRE(ok);
        return std::pair(hash, velocities);
    };
    const auto expected = run(FE_TONEAREST);
    for (int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) CHECK(run(mode) == expected);
}
