// A library built with LR_NO_OS: no threads but those of a job system, the same bits with it as without, and no files.
#include <langevin_rigid.h>

#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

namespace {

void must(bool good, const char* what) {
    if (good) return;
    std::fprintf(stderr, "no_os: %s\n", what);
    std::exit(1);
}

std::vector<std::thread> running;
uint32_t tasks = 0;

void* enqueue(void*, lr_task_fn run, void* task, uint32_t count) {
    tasks += count;
    for (uint32_t i = 0; i < count; ++i) running.emplace_back(run, task, i, i + 1);
    return nullptr;
}
void finish(void*, void*) {
    for (std::thread& thread : running) thread.join();
    running.clear();
}

uint64_t hash_after_steps(lr_asset* leaf, uint32_t workers, const lr_job_system& jobs) {
    lr_world_desc desc = LR_WORLD_DESC_INIT;
    desc.worker_count = workers;
    desc.jobs = jobs;
    lr_world* world = nullptr;
    must(lr_world_create(&desc, &world) == LR_OK, "world");
    lr_batch_desc batch_desc = LR_BATCH_DESC_INIT;
    batch_desc.asset = leaf;
    batch_desc.capacity = 20000;
    lr_batch batch{};
    must(lr_batch_create(world, &batch_desc, &batch) == LR_OK, "batch");
    std::vector<lr_body_desc> bodies(batch_desc.capacity, lr_body_desc LR_BODY_DESC_INIT);
    for (size_t i = 0; i < bodies.size(); ++i) bodies[i].position[0] = 0.2f * static_cast<float>(i);
    std::vector<lr_body> handles(bodies.size());
    must(lr_body_create(world, batch, bodies.data(), batch_desc.capacity, handles.data()) == LR_OK, "bodies");
    for (int frame = 0; frame < 10; ++frame) must(lr_world_step(world, 1.0f / 60.0f, 4) == LR_OK, "step");
    uint64_t hash = 0;
    must(lr_world_hash(world, &hash) == LR_OK, "hash");
    lr_world_destroy(world);
    return hash;
}
} // namespace

int main() {
    lr_ellipsoid_desc shape = LR_ELLIPSOID_DESC_INIT;
    shape.semi_axes[0] = 0.04;
    shape.semi_axes[1] = 0.01;
    shape.semi_axes[2] = 0.00005;
    shape.density = 800.0;
    lr_asset* leaf = nullptr;
    must(lr_asset_create_ellipsoid(&shape, &leaf) == LR_OK, "ellipsoid");
    const uint64_t alone = hash_after_steps(leaf, 0, {});
    must(alone == hash_after_steps(leaf, 3, {nullptr, &enqueue, &finish}), "other bits with a job system");
    must(tasks != 0, "the job system was not used");

    lr_world_desc desc = LR_WORLD_DESC_INIT;
    desc.worker_count = 2;
    lr_world* world = nullptr;
    must(lr_world_create(&desc, &world) == LR_ERROR_THREADS && !world, "threads of its own");
    lr_asset* asset = nullptr;
    must(lr_asset_load_file("leaf.lrb", &asset) == LR_ERROR_UNSUPPORTED && !asset, "a file was read");
    lr_asset_release(leaf);
    return 0;
}
