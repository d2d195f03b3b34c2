// SPDX-License-Identifier: MIT
#include "recorded_falls.h"

#include <cmath>

#include "failure.h"

namespace {

Pose pose_of(const lr_batch_view& view, const float* velocity, std::size_t i, double time) {
    const auto at = [i](const float* values) { return static_cast<double>(values[i]); };
    Pose pose{time, {}, {}, {}, {}};
    for (std::size_t k = 0; k < 3; ++k) {
        pose.position[k] = at(view.position[k]);
        pose.velocity[k] = static_cast<double>(velocity[k]);
        pose.spin[k] = static_cast<double>(velocity[3 + k]);
    }
    for (std::size_t k = 0; k < 4; ++k) pose.turn[k] = at(view.orientation[k]);
    return pose;
}

} // namespace

WorldPointer make_world(std::uint64_t seed) {
    lr_world_desc desc;
    check(lr_world_desc_init(&desc, sizeof desc), "lr_world_desc_init", "header and library differ: build again");
    desc.seed = seed;
    lr_world* world = nullptr;
    check(lr_world_create(&desc, &world), "cannot create the world");
    return WorldPointer(world);
}

lr_batch make_batch(lr_world* world, const lr_asset* asset, std::int32_t loads, std::size_t capacity) {
    lr_batch_desc desc;
    check(lr_batch_desc_init(&desc, sizeof desc), "lr_batch_desc_init");
    desc.asset = asset;
    desc.capacity = static_cast<std::uint32_t>(capacity);
    desc.load_model = loads;
    desc.variation = 0.0f; // the paper has one leaf
    lr_batch batch{};
    check(lr_batch_create(world, &desc, &batch), "cannot create a batch", "try fewer --falls");
    return batch;
}

std::vector<Track> record(const lr_asset* asset, const Run& run, const std::vector<Release>& releases) {
    const WorldPointer world = make_world(run.seed);
    const lr_batch batch = make_batch(world.get(), asset, run.loads, releases.size());
    std::vector<lr_body_desc> bodies(releases.size());
    for (std::size_t i = 0; i < releases.size(); ++i) {
        check(lr_body_desc_init(&bodies[i], sizeof bodies[i]), "lr_body_desc_init");
        for (std::size_t k = 0; k < 4; ++k) bodies[i].orientation[k] = static_cast<float>(releases[i].turn[k]);
        for (std::size_t k = 0; k < 3; ++k) bodies[i].linear_velocity[k] = static_cast<float>(releases[i].velocity[k]);
    }
    check(lr_body_create(world.get(), batch, bodies.data(), static_cast<std::uint32_t>(bodies.size()), nullptr),
          "cannot create bodies");

    // No body ends, so the view keeps the order of the releases.
    std::vector<Track> tracks(releases.size());
    std::vector<float> velocities(6 * releases.size());
    const auto steps = static_cast<std::size_t>(std::lround(run.seconds / run.interval));
    for (std::size_t step = 0; step <= steps; ++step) {
        if (step > 0) check(lr_world_step(world.get(), static_cast<float>(run.interval), run.substeps), "step");
        lr_batch_view view;
        check(lr_batch_view_init(&view, sizeof view), "lr_batch_view_init");
        check(lr_batch_get_view(world.get(), batch, &view), "view");
        check(lr_batch_write_velocities(world.get(), batch, velocities.data(), 0, view.count, nullptr), "velocities");
        for (std::size_t i = 0; i < tracks.size(); ++i) {
            tracks[i].push_back(pose_of(view, &velocities[6 * i], i, run.interval * static_cast<double>(step)));
        }
    }
    return tracks;
}
