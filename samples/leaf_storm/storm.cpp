// SPDX-License-Identifier: MIT
#include "storm.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "failure.h"

namespace {

constexpr int over_the_edge = 0, through_the_ground = 1; // kill volumes

constexpr storm::Box ground_box{{-10.0f, -1.0f, -10.0f}, {10.0f, 8.0f, 10.0f}}; // the terrain, and air above it

} // namespace

WorldPointer create_world(const Options& options, const float* wind) {
    lr_world_desc desc;
    check(lr_world_desc_init(&desc, sizeof desc), "lr_world_desc_init", "header and library differ: build again");
    desc.seed = options.seed;
    desc.worker_count = options.threads > 0 ? options.threads - 1 : 0;
    desc.simd_target = options.simd;
    desc.log = [](void*, std::int32_t level, const char* message) {
        if (level <= LR_LOG_WARNING) std::fprintf(stderr, "langevin_rigid: %s\n", message);
    };
    lr_world* world = nullptr;
    const lr_status status = lr_world_create(&desc, &world);
    check(status, "cannot create the world",
          status == LR_ERROR_UNSUPPORTED ? "this processor has no such instruction set: leave --simd out"
                                         : "try fewer --threads");
    WorldPointer owner(world);
    check(lr_world_set_uniform_wind(world, wind[0], wind[1], wind[2]), "wind", "give --wind as X,Y,Z in m/s");
    return owner;
}

lr_batch create_batch(lr_world* world, const lr_asset* asset, std::uint32_t capacity, const Options& options) {
    lr_batch_desc desc;
    check(lr_batch_desc_init(&desc, sizeof desc), "lr_batch_desc_init");
    desc.asset = asset;
    desc.capacity = capacity;
    desc.noise_gain = options.noise;
    desc.variation = options.variation;
    desc.load_model = options.loads;
    desc.clock = options.clock;
    desc.integrator = options.integrator;
    lr_batch batch{};
    check(lr_batch_create(world, &desc, &batch), "cannot create a batch of " + std::to_string(capacity) + " bodies",
          "try a smaller --count");
    lr_load_gains gains; // AERODYNAMIC loads have their noise here
    check(lr_load_gains_init(&gains, sizeof gains), "lr_load_gains_init");
    gains.turbulence = options.noise;
    check(lr_batch_set_load_gains(world, batch, &gains), "gains");
    check(lr_batch_set_rate(world, batch, options.divisor), "rate");
    return batch;
}

Storm::Storm(const Options& options) : options_(options), world_(create_world(options, options.wind)) {
    const std::uint64_t kinds = options.assets.size();
    double length = 0.0;
    for (std::uint64_t k = 0; k < kinds; ++k) {
        Kind kind{options.assets[k], load_asset(options.assets[k]), {}, 0, 0};
        check(lr_asset_info_init(&kind.info, sizeof kind.info), "lr_asset_info_init");
        check(lr_asset_get_info(kind.asset.get(), &kind.info), "asset " + kind.path);
        kind.count = static_cast<std::uint32_t>(options.count / kinds + (k < options.count % kinds ? 1 : 0));
        length += kind.info.length_d * kind.count;
        kinds_.push_back(std::move(kind));
    }
    box_ = options.ground ? ground_box : storm::box_for(options.count, length / static_cast<double>(options.count));
    if (options.ground) park_ = std::make_unique<Park>(options, world_.get());
    std::uint64_t first = 0;
    for (Kind& kind : kinds_) {
        kind.batch = create_batch(world_.get(), kind.asset.get(), kind.count, options);
        if (options.ground)
            fill_from_above(kind);
        else
            fill(kind, first);
        first += kind.count;
    }
    if (options.heap) set_body_contact();
}

void Storm::set_body_contact() {
    for (std::size_t a = 0; a < kinds_.size(); ++a)
        for (std::size_t b = 0; b <= a; ++b)
            check(lr_batch_set_body_contact(world_.get(), kinds_[a].batch, kinds_[b].batch, 1),
                  "cannot set contact between leaves", "try a smaller --count");
}

void Storm::fill(Kind& kind, std::uint64_t first) {
    auto bodies = storm::births(box_, options_.seed, first, kind.count, options_.wind);
    if (options_.same_size)
        for (lr_body_desc& body : bodies) body.scale = 1.0f;
    check(lr_body_create(world_.get(), kind.batch, bodies.data(), kind.count, nullptr), "cannot create the bodies",
          "try a smaller --count");
    reentries_.emplace_back(box_);
}

void Storm::fill_from_above(Kind& kind) {
    lr_emitter_desc emitter;
    check(lr_emitter_desc_init(&emitter, sizeof emitter), "lr_emitter_desc_init");
    emitter.shape = LR_EMIT_BOX;
    const float middle[3] = {-1.0f, 3.6f, -1.8f}, half[3] = {5.5f, 0.9f, 5.0f};
    const Park::Place heap = park_->heap();
    const float over_heap[3] = {heap.x - 0.3f, heap.y + 1.5f, heap.z}, of_heap[3] = {0.25f, 0.5f, 0.25f};
    std::copy_n(options_.heap ? over_heap : middle, 3, emitter.position);
    std::copy_n(options_.heap ? of_heap : half, 3, emitter.size);
    emitter.rate = static_cast<float>(kind.count / options_.fall);
    if (!options_.same_size) emitter.scale_min = 0.7f, emitter.scale_max = 1.3f;
    check(lr_batch_set_emitter(world_.get(), kind.batch, &emitter), "emitter", "try a longer --fall");
    lr_batch_rules rules;
    check(lr_batch_rules_init(&rules, sizeof rules), "lr_batch_rules_init");
    // Bodies end beyond its edges, and below it, where none should be.
    rules.volume_count = 2;
    lr_kill_volume& edges = rules.volumes[over_the_edge];
    edges.shape = LR_VOLUME_BOX;
    edges.side = LR_KILL_OUTSIDE;
    for (int axis = 0; axis < 3; ++axis) {
        edges.center[axis] = 0.5f * (box_.low[axis] + box_.high[axis]);
        edges.size[axis] = axis == 1 ? 1000.0f : 0.5f * box_.size(axis);
    }
    lr_kill_volume& depth = rules.volumes[through_the_ground];
    depth.shape = LR_VOLUME_PLANE;
    depth.center[1] = box_.low[1];
    depth.size[1] = 1.0f;
    check(lr_batch_set_rules(world_.get(), kind.batch, &rules), "rules");
}

// Bodies that were blown away must not be replaced.
void Storm::end_births() {
    if (births_ended_ || info().time < options_.fall) return;
    for (const Kind& kind : kinds_) check(lr_batch_set_emitter(world_.get(), kind.batch, nullptr), "emitter");
    births_ended_ = true;
}

void Storm::count_ended() {
    for (const Kind& kind : kinds_) {
        lr_batch_counts events;
        check(lr_batch_counts_init(&events, sizeof events), "lr_batch_counts_init");
        check(lr_batch_get_counts(world_.get(), kind.batch, &events), "events");
        blown_away_ += events.by_volume[over_the_edge];
        fell_through_ += events.by_volume[through_the_ground];
    }
}

void Storm::step() {
    if (park_) park_->move(info().time + options_.dt);
    const auto start = std::chrono::steady_clock::now();
    const lr_status status = lr_world_step(world_.get(), static_cast<float>(options_.dt), options_.substeps);
    stepping_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    check(status, "step", "try a smaller --dt");
    if (park_) {
        count_ended();
        end_births();
    }
    for (std::size_t k = 0; k < reentries_.size(); ++k) {
        check(reentries_[k].apply(world_.get(), kinds_[k].batch), "the motion of a body diverged",
              "try more --substeps or a smaller --dt; if that does not help, report it");
    }
}

Sample Storm::sample(Histogram* descents) const {
    Sampler sampler(info().time);
    std::vector<float> velocities;
    for (const Kind& kind : kinds_) {
        lr_batch_view view;
        check(lr_batch_view_init(&view, sizeof view), "lr_batch_view_init");
        check(lr_batch_get_view(world_.get(), kind.batch, &view), "view");
        velocities.resize(std::size_t{6} * view.awake_count);
        check(lr_batch_write_velocities(world_.get(), kind.batch, velocities.data(), 0, view.awake_count, nullptr),
              "velocities");
        sampler.add(view, velocities, options_.wind, descents);
    }
    return sampler.finish();
}

std::uint64_t Storm::hash() const {
    std::uint64_t value = 0;
    check(lr_world_hash(world_.get(), &value), "hash");
    return value;
}

std::uint64_t Storm::reentries() const {
    std::uint64_t sum = 0;
    for (const storm::Reentry& reentry : reentries_) sum += reentry.count();
    return sum;
}

lr_world_info Storm::info() const {
    lr_world_info info;
    check(lr_world_info_init(&info, sizeof info), "lr_world_info_init");
    check(lr_world_get_info(world_.get(), &info), "world info");
    return info;
}
