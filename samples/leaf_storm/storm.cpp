// SPDX-License-Identifier: MIT
#include "storm.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "failure.h"

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
    lr_wind_desc air;
    check(lr_wind_desc_init(&air, sizeof air), "lr_wind_desc_init");
    std::copy(wind, wind + 3, air.velocity);
    check(lr_world_set_wind(world, &air), "wind", "give --wind as X,Y,Z in m/s");
    return owner;
}

lr_batch create_batch(lr_world* world, const lr_asset* asset, std::uint32_t capacity, const Options& options) {
    lr_batch_desc desc;
    check(lr_batch_desc_init(&desc, sizeof desc), "lr_batch_desc_init");
    desc.asset = asset;
    desc.capacity = capacity;
    desc.noise_gain = options.noise;
    desc.load_model = options.loads;
    desc.clock = options.clock;
    desc.integrator = options.integrator;
    lr_batch batch = 0;
    check(lr_batch_create(world, &desc, &batch), "cannot create a batch of " + std::to_string(capacity) + " bodies",
          "try a smaller --count");
    lr_load_gains gains; // AERODYNAMIC loads have their noise here
    check(lr_load_gains_init(&gains, sizeof gains), "lr_load_gains_init");
    gains.turbulence = options.noise;
    check(lr_batch_set_load_gains(world, batch, &gains), "gains");
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
    box_ = storm::box_for(options.count, length / static_cast<double>(options.count));
    std::uint64_t first = 0;
    for (Kind& kind : kinds_) {
        kind.batch = create_batch(world_.get(), kind.asset.get(), kind.count, options);
        auto bodies = storm::births(box_, options.seed, first, kind.count, options.wind);
        if (options.same_size)
            for (lr_body_desc& body : bodies) body.scale = 1.0f;
        check(lr_body_create(world_.get(), kind.batch, bodies.data(), kind.count, nullptr), "cannot create the bodies",
              "try a smaller --count");
        reentries_.emplace_back(box_);
        first += kind.count;
    }
}

void Storm::step() {
    const auto start = std::chrono::steady_clock::now();
    const lr_status status = lr_world_step(world_.get(), static_cast<float>(options_.dt), options_.substeps);
    stepping_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    check(status, "step", "try a smaller --dt");
    for (std::size_t k = 0; k < kinds_.size(); ++k) {
        check(reentries_[k].apply(world_.get(), kinds_[k].batch), "the motion of a body blew up",
              "try more --substeps or a smaller --dt; if that does not help, report it");
    }
}

Sample Storm::sample(Histogram* descents) const {
    Sampler sampler(info().time);
    for (const Kind& kind : kinds_) {
        lr_batch_view view;
        check(lr_batch_view_init(&view, sizeof view), "lr_batch_view_init");
        check(lr_batch_get_view(world_.get(), kind.batch, &view), "view");
        sampler.add(view, options_.wind, descents);
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
