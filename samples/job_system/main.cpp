// Steps a world by an engine's own job system, among the engine's other jobs. The hash after some frames equals that of a
// world without threads, and that of a world with its own threads.
// SPDX-License-Identifier: MIT
#include "job_queue.h"

#include <langevin_rigid.h>

#include <chrono>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <memory>

namespace {

void check(lr_status status, const char* what) {
    if (status == LR_OK) return;
    std::fprintf(stderr, "job_system: %s: %s\n", what, lr_status_string(status));
    std::exit(2);
}

// The whole adapter for a job system: a task of the library becomes as many jobs as it has indices.
class LangevinJobs {
public:
    explicit LangevinJobs(JobQueue& queue) : queue_(&queue) {}
    lr_job_system callbacks() { return {this, &enqueue, &finish}; }

private:
    static void* enqueue(void* user, lr_task_fn run, void* task, uint32_t count) {
        auto& self = *static_cast<LangevinJobs*>(user);
        self.run_ = run;
        self.task_ = task;
        self.queue_->submit(
            [](void* data, uint32_t index) {
                const auto& jobs = *static_cast<LangevinJobs*>(data);
                jobs.run_(jobs.task_, index, index + 1);
            },
            &self, count, self.open_);
        return &self.open_;
    }
    static void finish(void* user, void* token) {
        static_cast<LangevinJobs*>(user)->queue_->wait(*static_cast<JobQueue::Counter*>(token));
    }

    JobQueue* queue_;
    // One adapter per world: a world's rounds of tasks never overlap.
    lr_task_fn run_ = nullptr;
    void* task_ = nullptr;
    JobQueue::Counter open_{0};
};

// Stands in for the engine's other work in a frame.
void animate(void* data, uint32_t index) {
    auto& sum = static_cast<std::atomic<uint64_t>*>(data)[index % 4];
    uint64_t value = index;
    for (int i = 0; i < 20000; ++i) value = value * 6364136223846793005u + 1442695040888963407u;
    sum.fetch_add(value, std::memory_order_relaxed);
}

struct Outcome {
    uint64_t hash;
    double milliseconds; // per step
};

Outcome play(const lr_asset* leaf, uint32_t workers, JobQueue* queue) {
    lr_world_desc wd;
    check(lr_world_desc_init(&wd, sizeof wd), "world desc");
    wd.seed = 7;
    wd.worker_count = workers;
    std::unique_ptr<LangevinJobs> jobs; // must outlive the world
    if (queue) {
        jobs = std::make_unique<LangevinJobs>(*queue);
        wd.jobs = jobs->callbacks();
    }
    lr_world* world = nullptr;
    check(lr_world_create(&wd, &world), "world");

    // A large batch, and many small ones, like the trees of a street: these share tasks.
    for (uint32_t i = 0; i <= 200; ++i) {
        lr_batch_desc bd;
        check(lr_batch_desc_init(&bd, sizeof bd), "batch desc");
        bd.asset = leaf;
        bd.capacity = i == 0 ? 20000 : 40;
        lr_batch batch{};
        check(lr_batch_create(world, &bd, &batch), "batch");
        lr_emitter_desc e;
        check(lr_emitter_desc_init(&e, sizeof e), "emitter desc");
        e.shape = LR_EMIT_BOX;
        e.position[0] = static_cast<float>(i);
        e.size[0] = e.size[1] = e.size[2] = i == 0 ? 50.0f : 2.0f;
        e.spin_max = 5.0f;
        check(lr_batch_set_emitter(world, batch, &e), "emitter");
        check(lr_batch_spawn(world, batch, bd.capacity, nullptr), "bodies");
    }
    lr_turbulence_desc wind;
    check(lr_turbulence_desc_init(&wind, sizeof wind), "wind desc");
    wind.rms = 1.5f;
    wind.integral_length = 2.0f;
    check(lr_world_add_turbulence(world, &wind, nullptr), "wind");

    constexpr int frames = 30;
    std::atomic<uint64_t> sums[4] = {};
    std::chrono::duration<double, std::milli> time{0};
    for (int frame = 0; frame < frames; ++frame) {
        JobQueue::Counter animations{0};
        if (queue) queue->submit(&animate, sums, 64, animations);
        const auto begin = std::chrono::steady_clock::now();
        check(lr_world_step(world, 1.0f / 60.0f, 2), "step");
        time += std::chrono::steady_clock::now() - begin;
        if (queue) queue->wait(animations);
    }
    Outcome outcome{0, time.count() / frames};
    check(lr_world_hash(world, &outcome.hash), "hash");
    lr_world_destroy(world);
    return outcome;
}

} // namespace

int main() {
    lr_ellipsoid_desc shape;
    lr_asset* leaf = nullptr;
    check(lr_ellipsoid_desc_init(&shape, sizeof shape), "ellipsoid desc");
    shape.semi_axes[0] = 0.04;
    shape.semi_axes[1] = 0.01;
    shape.semi_axes[2] = 0.00005;
    shape.density = 800.0;
    check(lr_asset_create_ellipsoid(&shape, &leaf), "ellipsoid");

    JobQueue queue(2);
    const Outcome outcomes[] = {play(leaf, 0, nullptr), play(leaf, 2, nullptr), play(leaf, queue.threads(), &queue)};
    const char* const names[] = {"no workers", "2 workers of its own", "the engine's job system"};
    bool equal = true;
    for (int i = 0; i < 3; ++i) {
        std::printf("%-24s %016" PRIx64 "  %6.2f ms a step\n", names[i], outcomes[i].hash, outcomes[i].milliseconds);
        equal = equal && outcomes[i].hash == outcomes[0].hash;
    }
    lr_asset_release(leaf);
    if (!equal) std::fprintf(stderr, "job_system: the hashes differ\n");
    return equal ? 0 : 2;
}
