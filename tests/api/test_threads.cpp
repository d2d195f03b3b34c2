// Concurrency that the header permits: separate worlds, shared assets. For ThreadSanitizer, and for bits.
#include "support/counting_memory.h"
#include "support/determinism_scenes.h"
#include "support/quick.h"
#include "support/threads.h"
#include "support/wind.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>

using namespace test;

#if LR_TEST_THREADS
namespace {

template <class Work> void side_by_side(uint32_t count, Work&& work) {
    std::vector<std::thread> threads;
    std::atomic<uint32_t> ready{0};
    for (uint32_t i = 0; i < count; ++i)
        threads.emplace_back([&, i] {
            ++ready;
            while (ready < count) std::this_thread::yield(); // all at once
            work(i);
        });
    for (std::thread& t : threads) t.join();
}

// An engine's queue: jobs of many worlds, run by its threads in no particular order.
class Engine {
public:
    explicit Engine(uint32_t threads) {
        for (uint32_t i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
    }
    ~Engine() {
        {
            const std::lock_guard lock(mutex_);
            ending_ = true;
        }
        more_.notify_all();
        for (std::thread& t : threads_) t.join();
    }
    lr_job_system callbacks() {
        return {this,
                [](void* user, lr_task_fn run, void* task, uint32_t count) {
                    return static_cast<Engine*>(user)->enqueue(run, task, count);
                },
                [](void* user, void* token) { static_cast<Engine*>(user)->finish(*static_cast<uint32_t*>(token)); }};
    }

private:
    struct Job {
        lr_task_fn run;
        void* task;
        uint32_t index;
        uint32_t* left;
    };

    void* enqueue(lr_task_fn run, void* task, uint32_t count) {
        auto* const left = new uint32_t(count);
        {
            const std::lock_guard lock(mutex_);
            for (uint32_t i = 0; i < count; ++i) {
                // At both ends, so that jobs of several worlds mix.
                if ((i + jobs_.size()) % 2 == 0)
                    jobs_.push_back({run, task, i, left});
                else
                    jobs_.push_front({run, task, i, left});
            }
        }
        more_.notify_one(); // not all: some threads starve
        return left;
    }
    void finish(uint32_t& left) {
        std::unique_lock lock(mutex_);
        while (left != 0) {
            if (jobs_.empty())
                done_.wait(lock, [&] { return left == 0 || !jobs_.empty(); });
            else
                one(lock); // perhaps of another world, as a waiting engine thread would
        }
        lock.unlock();
        delete &left;
    }
    void one(std::unique_lock<std::mutex>& lock) {
        const Job job = jobs_.front();
        jobs_.pop_front();
        lock.unlock();
        job.run(job.task, job.index, job.index + 1);
        lock.lock();
        if (--*job.left == 0) done_.notify_all();
    }
    void work() {
        std::unique_lock lock(mutex_);
        for (;;) {
            more_.wait(lock, [&] { return ending_ || !jobs_.empty(); });
            if (jobs_.empty()) return;
            one(lock);
        }
    }

    std::mutex mutex_;
    std::condition_variable more_, done_;
    std::deque<Job> jobs_;
    bool ending_ = false;
    std::vector<std::thread> threads_;
};

std::vector<PlayedScene> some_scenes() {
    std::vector<PlayedScene> some;
    for (PlayedScene& scene : played_scenes()) {
        if (scene.faulty) continue; // these depend on their length
        scene.frames = 6;
        if (scene.called_back || scene.body_contact || scene.governed || scene.afloat) some.push_back(scene);
    }
    return some;
}

} // namespace

TEST_CASE("worlds on threads of their own, with workers and callbacks, each as if it were alone") {
    const std::vector<PlayedScene> scenes = some_scenes();
    REQUIRE(scenes.size() >= 4);
    std::vector<uint64_t> expected, got(scenes.size());
    for (const PlayedScene& scene : scenes) expected.push_back(outcome(scene));
    const auto count = static_cast<uint32_t>(scenes.size());
    side_by_side(count,
                 [&](uint32_t i) { got[i] = outcome(scenes[i], {.workers = i % 3, .checks = LR_CHECK_THREADS}); });
    CHECK(got == expected);
}

TEST_CASE("worlds of several threads share one job system, which runs their tasks in any order") {
    std::vector<PlayedScene> scenes = some_scenes();
    const uint32_t touching = quick() ? 60 : 150, apart = quick() ? 600 : 1500;
    for (PlayedScene& scene : scenes)
        scene.bodies = scene.body_contact ? touching : apart; // work for more than one thread
    std::vector<uint64_t> expected, got(scenes.size());
    for (const PlayedScene& scene : scenes) expected.push_back(outcome(scene));
    for (uint32_t threads : {1u, 4u}) {
        Engine engine(threads);
        side_by_side(static_cast<uint32_t>(scenes.size()), [&](uint32_t i) {
            got[i] = outcome(scenes[i], {.workers = 5, .jobs = engine.callbacks(), .checks = LR_CHECK_THREADS});
        });
        CHECK(got == expected);
    }
}

TEST_CASE("an asset is shared, asked and released by many threads, the last of which frees it") {
    const int64_t live = static_cast<int64_t>(global_live);
    for (int round = 0; round < 10; ++round) {
        lr_asset* asset = nullptr;
        const lr_ellipsoid_desc d = ellipsoid(0.03, 0.02, 0.0005, 400.0);
        REQUIRE(lr_asset_create_ellipsoid(&d, &asset) == LR_OK);
        std::atomic<int> wrong{0};
        uint64_t hashes[8] = {};
        for (int i = 1; i < 8; ++i) REQUIRE(lr_asset_retain(asset) == LR_OK);
        side_by_side(8, [&](uint32_t i) {
            lr_world_desc wd;
            lr_world_desc_init(&wd, sizeof wd);
            lr_world* world = nullptr;
            lr_batch_desc bd;
            lr_batch_desc_init(&bd, sizeof bd);
            bd.asset = asset;
            bd.capacity = 100;
            lr_batch batch{};
            lr_body_desc body;
            lr_body_desc_init(&body, sizeof body);
            lr_asset_info info;
            lr_asset_info_init(&info, sizeof info);
            for (int k = 0; k < 20; ++k) wrong += lr_asset_retain(asset) != LR_OK;
            wrong += lr_world_create(&wd, &world) != LR_OK || lr_batch_create(world, &bd, &batch) != LR_OK;
            for (int k = 0; k < 20; ++k) lr_asset_release(asset);
            wrong += lr_asset_get_info(asset, &info) != LR_OK;
            lr_asset_release(asset); // from here on the batch holds it
            for (int k = 0; k < 60; ++k) wrong += lr_body_create(world, batch, &body, 1, nullptr) != LR_OK;
            for (int k = 0; k < 5; ++k) wrong += lr_world_step(world, 0.01f, 2) != LR_OK;
            wrong += lr_world_hash(world, &hashes[i]) != LR_OK;
            lr_world_destroy(world);
        });
        CHECK(wrong == 0);
        for (uint64_t hash : hashes) CHECK(hash == hashes[0]);
    }
    if (counts_global) CHECK(static_cast<int64_t>(global_live) == live);
}

TEST_CASE("worlds are made and ended on many threads at once") {
    std::atomic<int> wrong{0};
    side_by_side(6, [&](uint32_t i) {
        for (uint32_t k = 0; k < 12; ++k) {
            lr_world_desc d;
            lr_world_desc_init(&d, sizeof d);
            d.worker_count = (i + k) % 4;
            lr_world* world = nullptr;
            wrong += lr_world_create(&d, &world) != LR_OK;
            wrong += lr_world_step(world, 0.01f, 1) != LR_OK;
            lr_world_destroy(world);
        }
    });
    CHECK(wrong == 0);
}
#endif
