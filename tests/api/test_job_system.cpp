// All kinds of job systems: the same bits, every task run, none used for small worlds.
#include "support/counting_memory.h"
#include "support/determinism_scenes.h"
#include "support/quick.h"

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <chrono>
#include <string>
#include <thread>

using namespace test;

namespace {

// The rounding mode of arithmetic. std::fegetround can return that of the other unit of an x86 processor.
int rounding() {
    volatile float one = 1.0f, minus_one = -1.0f, three = 3.0f;
    const bool up = one / three > 0x1.555554p-2f, down = minus_one / three < -0x1.555554p-2f;
    return up ? (down ? FE_TONEAREST : FE_UPWARD) : (down ? FE_DOWNWARD : FE_TOWARDZERO);
}

// Counts, checks the guarantees for job systems, and leaves the rest to its kind.
class JobSystem {
public:
    enum Temper {
        whole,     // one call, immediately
        reversed,  // one index after the other, from the last, immediately
        late,      // in finish, in reverse
        halves,    // two ranges, and an empty one, in finish
        threads,   // one for each index
        sleepers,  // the same, but they begin long after the caller has done everything
        strangers, // threads with another floating-point mode, which they must have afterwards
        crowd,     // twice as many threads as indices, half of them without work
        starving,  // one thread for the last index; in finish the others get threads only after that
        tempers
    };

    explicit JobSystem(Temper temper) : temper_(temper) {}
    lr_job_system callbacks() { return {this, &enqueue, &finish}; }

    uint32_t enqueued = 0, finished = 0, most = 0;
    std::atomic<bool> wrong{false};

private:
    struct Round {
        lr_task_fn run;
        void* task;
        uint32_t count;
        std::vector<std::thread> threads;
    };

    static void* enqueue(void* user, lr_task_fn run, void* task, uint32_t count) {
        auto& self = *static_cast<JobSystem*>(user);
        if (!run || !task || count == 0 || self.enqueued != self.finished) self.wrong = true;
        self.caller_ = std::this_thread::get_id();
        ++self.enqueued;
        self.most = std::max(self.most, count);
        self.round_ = {run, task, count, {}};
        if (self.temper_ == whole) run(task, 0, count);
        if (self.temper_ == reversed)
            for (uint32_t i = count; i-- > 0;) run(task, i, i + 1);
        if (self.temper_ >= threads && self.temper_ != starving)
            for (uint32_t i = 0; i < count; ++i)
                self.round_.threads.emplace_back([&self, i, temper = self.temper_] { self.work(i, temper); });
        if (self.temper_ == crowd)
            for (uint32_t i = 0; i < count; ++i)
                self.round_.threads.emplace_back([&r = self.round_, i] { r.run(r.task, i, i); });
        if (self.temper_ == starving)
            self.round_.threads.emplace_back([&self, count] { self.work(count - 1, starving); });
        return self.temper_ == whole ? nullptr : &self.round_;
    }

    void work(uint32_t index, Temper temper) {
        if (temper == sleepers) std::this_thread::sleep_for(std::chrono::milliseconds(1 + index));
        if (temper == strangers) std::fesetround(FE_UPWARD);
        round_.run(round_.task, index, index + 1);
        if (temper == strangers && rounding() != FE_UPWARD) wrong = true;
    }

    static void finish(void* user, void* token) {
        auto& self = *static_cast<JobSystem*>(user);
        if (token != (self.temper_ == whole ? nullptr : &self.round_) || self.caller_ != std::this_thread::get_id())
            self.wrong = true;
        Round& r = self.round_;
        if (self.temper_ == late)
            for (uint32_t i = r.count; i-- > 0;) r.run(r.task, i, i + 1);
        if (self.temper_ == halves) {
            r.run(r.task, r.count / 2, r.count);
            r.run(r.task, 1, 1);
            if (r.count > 1) r.run(r.task, 0, r.count / 2);
        }
        for (std::thread& thread : r.threads) thread.join();
        r.threads.clear();
        if (self.temper_ == starving)
            for (uint32_t i = 0; i + 1 < r.count; ++i) r.run(r.task, i, i + 1);
        ++self.finished;
    }

    Temper temper_;
    Round round_{};
    std::thread::id caller_;
};

struct Crowd {
    Asset asset = leaf();
    World world;
    lr_batch batch{};
    Crowd(const lr_world_desc& d, uint32_t bodies) : world(make(d)) {
        batch = add_batch(world, asset, bodies);
        std::vector<lr_body_desc> descs(bodies, body_desc());
        for (lr_body_desc& b : descs) b.angular_velocity[1] = 2.0f;
        REQUIRE(lr_body_create(world.get(), batch, descs.data(), bodies, nullptr) == LR_OK);
    }
};

} // namespace

TEST_CASE("every scene ends in the same bits with any job system" * doctest::test_suite("long-exact")) {
    std::vector<PlayedScene> scenes = played_scenes();
    int number = 0;
    [[maybe_unused]] uint32_t at = 0;
    for (PlayedScene& scene : scenes) {
        if (at++ % 4 != 1 && quick()) continue; // other tests run all of them with workers
        // Among so many bodies Runge-Kutta diverges for a few, and non-finite values have no guarantee.
        if (scene.integrator == LR_INTEGRATOR_RK4) continue;
        // Two such batches give work to several threads.
        scene.bodies = scene.body_contact ? 300 : scene.resting ? 10000 : 2500;
        if (scene.budget != 0) scene.budget = 5000;
        if (quick()) scene.frames = 12; // includes the first landings
        const bool waits = scene.budget != 0 || scene.divisors[1] > scene.substeps || scene.resting ||
                           scene.solids != Solids::none; // not every step has work
        CAPTURE(scene.name);
        const uint64_t expected = outcome(scene);
        // Two kinds for each scene, one of them with threads; over all scenes each kind occurs several times.
        const int threaded = JobSystem::threads + number % (JobSystem::tempers - JobSystem::threads);
        for (int temper : {number % JobSystem::threads, threaded}) {
            if (temper != threaded && quick()) continue; // the test of wind and rules covers all kinds
            CAPTURE(temper);
            JobSystem jobs(static_cast<JobSystem::Temper>(temper));
            CHECK(outcome(scene, {.workers = 3, .jobs = jobs.callbacks()}) == expected);
            CHECK(jobs.enqueued >= static_cast<uint32_t>(waits ? 3 : scene.frames));
            CHECK(jobs.enqueued == jobs.finished);
            CHECK((jobs.most >= 1 && jobs.most <= 3));
            CHECK_FALSE(jobs.wrong.load());
        }
        ++number;
    }
}

TEST_CASE("wind prepared in slices and rules go through a job system too" * doctest::test_suite("native")) {
    const auto play = [](JobSystem* jobs) {
        lr_world_desc d = world_desc();
        if (jobs) d.jobs = jobs->callbacks();
        d.worker_count = 2;
        const Crowd c(d, 6000);
        lr_turbulence_desc turbulence = initialised(lr_turbulence_desc_init);
        lr_wind_source source{};
        REQUIRE(lr_world_add_turbulence(c.world.get(), &turbulence, &source) == LR_OK);
        lr_batch_rules r = initialised(lr_batch_rules_init);
        r.volume_count = 1;
        r.volumes[0] = {LR_VOLUME_SPHERE, LR_KILL_OUTSIDE, {0.0f, 0.0f, 0.0f}, {0.04f, 0.0f, 0.0f}};
        REQUIRE(lr_batch_set_rules(c.world.get(), c.batch, &r) == LR_OK);
        for (int i = 0; i < 6; ++i) steps(c.world, 1, 1.0f / 60.0f, 20); // three slices each
        CHECK(info_of(c.world).body_count < 6000);
        return hash_of(c.world);
    };
    const uint64_t expected = play(nullptr);
    for (int temper = 0; temper < JobSystem::tempers; ++temper) {
        CAPTURE(temper);
        JobSystem jobs(static_cast<JobSystem::Temper>(temper));
        CHECK(play(&jobs) == expected);
        CHECK(jobs.enqueued > 6);
        CHECK_FALSE(jobs.wrong.load());
    }
}

TEST_CASE("nobody is called for a small world") {
    const auto calls = [](uint32_t bodies, uint32_t workers, uint32_t substeps) {
        JobSystem jobs(JobSystem::whole);
        lr_world_desc d = world_desc();
        d.jobs = jobs.callbacks();
        d.worker_count = workers;
        const Crowd c(d, bodies);
        CHECK(info_of(c.world).worker_count == workers);
        steps(c.world, 1, 0.01f, substeps);
        CHECK(jobs.most <= workers);
        return jobs.enqueued;
    };
    CHECK(calls(1, 8, 1) == 0);
    CHECK(calls(1000, 8, 1) == 0);
    CHECK(calls(400, 8, 3) == 0);
    CHECK(calls(2000, 8, 1) == 1); // with AERODYNAMIC loads, 60 us
    CHECK(calls(1000, 8, 64) == 1);
    CHECK(calls(20000, 8, 4) == 1);
}

TEST_CASE("without a worker_count a job system is taken to have the machine's threads, and the log says so") {
    const auto logged = [](void* user, int32_t level, const char* text) {
        if (level == LR_LOG_WARNING) *static_cast<std::string*>(user) += text;
    };
    std::string said;
    JobSystem jobs(JobSystem::threads);
    lr_world_desc d = world_desc();
    d.log = logged, d.log_user = &said;
    const Crowd alone(d, 20000);
    CHECK(info_of(alone.world).worker_count == 0);
    CHECK(said.empty());
    steps(alone.world, 1, 0.01f, 4);
    d.jobs = jobs.callbacks();
    const Crowd c(d, 20000);
    const uint32_t threads = std::thread::hardware_concurrency();
    CHECK(info_of(c.world).worker_count == std::min(std::max(threads, 2u) - 1, 64u));
    CHECK(said.find("worker_count") != std::string::npos);
    steps(c.world, 1, 0.01f, 4);
    CHECK(jobs.enqueued == 1);
    CHECK(hash_of(c.world) == hash_of(alone.world));
    said.clear();
    d.worker_count = 1;
    const Crowd told(d, 1);
    CHECK(info_of(told.world).worker_count == 1);
    CHECK(said.empty());
}

TEST_CASE("the job system's functions run in the caller's floating-point mode, which outlives what they do to it" *
          doctest::test_suite("native")) {
    struct Modes {
        int seen[2] = {-1, -1};
        lr_job_system callbacks() {
            return {this,
                    [](void* user, lr_task_fn run, void* task, uint32_t count) -> void* {
                        static_cast<Modes*>(user)->seen[0] = rounding();
                        std::fesetround(FE_TOWARDZERO);
                        run(task, 0, count);
                        return nullptr;
                    },
                    [](void* user, void*) {
                        static_cast<Modes*>(user)->seen[1] = rounding();
                        std::fesetround(FE_DOWNWARD);
                    }};
        }
    };
    Modes modes;
    lr_world_desc d = world_desc();
    const Crowd alone(d, 9000);
    steps(alone.world, 1, 0.01f, 4);
    d.jobs = modes.callbacks();
    d.worker_count = 4;
    const Crowd c(d, 9000);
    std::fesetround(FE_UPWARD);
    const lr_status status = lr_world_step(c.world.get(), 0.01f, 4);
    const int after = rounding();
    std::fesetround(FE_TONEAREST);
    CHECK(status == LR_OK);
    CHECK(after == FE_UPWARD);
    CHECK((modes.seen[0] == FE_UPWARD && modes.seen[1] == FE_UPWARD));
    CHECK(hash_of(c.world) == hash_of(alone.world));
}

TEST_CASE("half a job system is refused") {
    JobSystem jobs(JobSystem::whole);
    for (uint32_t workers : {0u, 2u})
        for (bool first : {false, true}) {
            lr_world_desc d = world_desc();
            d.worker_count = workers;
            d.jobs = jobs.callbacks();
            if (first)
                d.jobs.enqueue = nullptr;
            else
                d.jobs.finish = nullptr;
            lr_world* world = nullptr;
            CHECK(lr_world_create(&d, &world) == LR_ERROR_INVALID_ARGUMENT);
            CHECK(world == nullptr);
        }
    lr_world_desc d = world_desc();
    d.jobs = jobs.callbacks();
    d.worker_count = 65;
    lr_world* world = nullptr;
    CHECK(lr_world_create(&d, &world) == LR_ERROR_INVALID_ARGUMENT);
    d.worker_count = 64;
    d.jobs.user = nullptr; // belongs to the caller
    CHECK(lr_world_create(&d, &world) == LR_OK);
    lr_world_destroy(world);
}

TEST_CASE("a step through a job system allocates nothing") {
    JobSystem jobs(JobSystem::reversed);
    CountingAllocator memory;
    lr_world_desc d = world_desc();
    d.allocator = memory.callbacks();
    d.jobs = jobs.callbacks();
    d.worker_count = 4;
    const Crowd c(d, 9000);
    lr_emitter_desc e = initialised(lr_emitter_desc_init);
    e.rate = 1000.0f;
    REQUIRE(lr_batch_set_emitter(c.world.get(), c.batch, &e) == LR_OK);
    lr_batch_rules r = initialised(lr_batch_rules_init);
    r.max_age = 0.05f;
    REQUIRE(lr_batch_set_rules(c.world.get(), c.batch, &r) == LR_OK);
    const uint64_t own = memory.calls, global = global_allocations;
    bool ok = true;
    for (int i = 0; i < 10; ++i) ok = ok && lr_world_step(c.world.get(), 0.01f, 4) == LR_OK;
    CHECK(memory.calls == own);
    CHECK(global_allocations == global);
    CHECK(ok);
    CHECK(jobs.enqueued > 0);
}

TEST_CASE("many small batches, some of them gone or empty: as one by one, with any workers" *
          doctest::test_suite("native")) {
    const Asset asset = leaf(), other = curled_leaf();
    const auto play = [&](const lr_world_desc& d) {
        const World world = make(d);
        std::vector<lr_batch> batches;
        for (uint32_t i = 0; i < 700; ++i) {
            lr_batch_desc bd = batch_desc();
            bd.load_model = 1 + static_cast<int32_t>(i % 3);
            batches.push_back(add_batch(world, bd, i % 2 ? asset : other, 40));
            const std::vector<lr_body_desc> bodies(i % 40, body_desc());
            REQUIRE(lr_body_create(world.get(), batches.back(), bodies.data(), i % 40, nullptr) == LR_OK);
        }
        for (uint32_t i = 0; i < 700; i += 7) REQUIRE(lr_batch_destroy(world.get(), batches[i]) == LR_OK);
        steps(world, 3, 0.02f, 5);
        return hash_of(world);
    };
    lr_world_desc d = world_desc();
    const uint64_t expected = play(d);
    for (uint32_t workers : {1u, 3u}) {
        d.worker_count = workers;
        CHECK(play(d) == expected);
    }
    JobSystem jobs(JobSystem::late);
    d.jobs = jobs.callbacks();
    CHECK(play(d) == expected);
    CHECK(jobs.most == 3);
}
