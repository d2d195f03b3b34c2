// Plates of 70 x 40 x 0.4 mm and 0.18 g that fall onto level ground: into a heap, in layers, or onto boxes; a walker and a wind over
// the ground.
#pragma once

#include "bench/scene_parts.h"
#include "langevin_rigid_baker.hpp"
#include "support/heap_quality.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace bench {

constexpr float step_seconds = 1.0f / 60.0f;
constexpr uint32_t substeps = 2;
constexpr test::Vec plate_half = {0.035, 0.02, 0.0002}; // m
constexpr double plate_mass = 1.8e-4;                   // kg

// Null after an error.
inline lr_asset* plate_asset() {
    std::vector<double> corners;
    for (uint32_t i = 0; i < 8; ++i)
        for (uint32_t k = 0; k < 3; ++k) corners.push_back((i >> k & 1u) != 0 ? plate_half[k] : -plate_half[k]);
    const std::vector<uint32_t> triangles = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                             2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
    langevin_rigid::BakeOptions options;
    options.unit = langevin_rigid::Unit::metre;
    options.density = plate_mass / (8.0 * plate_half[0] * plate_half[1] * plate_half[2]);
    options.name = "plate";
    const langevin_rigid::BakeResult baked = langevin_rigid::bake_triangles(
        corners.data(), corners.size() / 3, triangles.data(), triangles.size() / 3, options);
    for (const langevin_rigid::BakeFault& fault : baked.faults) std::fprintf(stderr, "%s\n", to_string(fault).c_str());
    lr_asset* asset = nullptr;
    return baked && lr_asset_load_memory(baked.asset.data(), baked.asset.size(), &asset) == LR_OK ? asset : nullptr;
}

// Where plates start, any way round: cells of a lattice over the origin, wider than a plate's diagonal, so that none begins
// within another.
struct Source {
    uint32_t across[2]; // cells along x and z
    float pitch[2];     // m
    float low;          // m, of the lowest cells
    float level;        // m from one level of cells to the next
    float speed;        // m/s downwards
    float half_side() const { return 0.5f * static_cast<float>(across[0]) * pitch[0]; }
};
// A square of about this many plates; any way round.
inline Source square(double side, float low, float level) {
    constexpr float pitch = 0.082f;
    const auto across = static_cast<uint32_t>(std::max(1.0, side / static_cast<double>(pitch)));
    return {{across, across}, {pitch, pitch}, low, level, 0.0f};
}

// The plates that start, in order, at once or as many in each step.
class Starts {
public:
    Starts() = default;
    Starts(const Source& source, uint32_t capacity, double seconds = 0.0) // 0: all at once
        : source_(source), capacity_(capacity), rate_(seconds > 0.0 ? capacity / seconds : 0.0) {}
    // Of the next step.
    std::vector<lr_body_desc> next() {
        time_ += static_cast<double>(step_seconds);
        const uint32_t count = rate_ > 0.0 ? std::min(capacity_, static_cast<uint32_t>(time_ * rate_)) : capacity_;
        std::vector<lr_body_desc> descs;
        for (; started_ < count; ++started_) descs.push_back(start_of(started_));
        return descs;
    }

private:
    lr_body_desc start_of(uint32_t i) const {
        lr_body_desc d;
        lr_body_desc_init(&d, sizeof d);
        const uint32_t cells = source_.across[0] * source_.across[1], level = i / cells;
        const auto cell =
            static_cast<uint32_t>(uint64_t{i} * 7919 % cells); // a prime: neighbours start at different times
        const uint32_t at[2] = {cell % source_.across[0], cell / source_.across[0]};
        for (size_t k = 0; k < 2; ++k)
            d.position[2 * k] =
                source_.pitch[k] * (static_cast<float>(at[k]) + 0.5f - 0.5f * static_cast<float>(source_.across[k]));
        if (rate_ > 0.0) // has fallen since its time, within this step
            d.position[1] = source_.low - source_.speed * static_cast<float>(time_ - (i + 1) / rate_);
        else
            d.position[1] = source_.low + source_.level * (static_cast<float>(level) + 0.4f * hashed(i, 4));
        d.linear_velocity[1] = -source_.speed;
        for (uint32_t k = 0; k < 4; ++k) d.orientation[k] = hashed(i, k) - 0.5f; // normalised by the call
        return d;
    }

    Source source_{};
    uint32_t capacity_ = 0, started_ = 0;
    double rate_ = 0.0, time_ = 0.0; // a second; s
};

class HeapScene {
public:
    HeapScene() = default;
    HeapScene(const HeapScene&) = delete;
    HeapScene& operator=(const HeapScene&) = delete;
    ~HeapScene() { lr_world_destroy(world_); }

    // A world with a batch and wind near the ground, without colliders.
    bool make(const lr_asset* plate, uint32_t capacity, uint32_t threads) {
        lr_world_desc wd;
        lr_world_desc_init(&wd, sizeof wd);
        wd.worker_count = threads - 1;
        if (lr_world_create(&wd, &world_) != LR_OK) return false;
        lr_batch_desc bd;
        lr_batch_desc_init(&bd, sizeof bd);
        bd.asset = plate;
        bd.capacity = capacity;
        bd.load_model = LR_LOADS_AERODYNAMIC;
        lr_ground_wind_desc slow;
        lr_ground_wind_desc_init(&slow, sizeof slow);
        slow.position[1] = -0.05f;
        slow.roughness_length = 0.01f;
        if (lr_batch_create(world_, &bd, &batch_) != LR_OK || lr_world_add_ground_wind(world_, &slow, nullptr) != LR_OK)
            return false;
        lr_batch_contact contact;
        lr_batch_contact_init(&contact, sizeof contact);
        contact.friction = 0.5f;
        return lr_batch_set_contact(world_, batch_, &contact) == LR_OK;
    }
    bool add_ground() {
        const lr_collider_desc ground = collider_at(LR_COLLIDER_PLANE, 0.0f, 0.0f, 0.0f);
        return lr_collider_create(world_, &ground, 1, nullptr) == LR_OK;
    }
    bool set_body_contact() { return lr_batch_set_body_contact(world_, batch_, batch_, 1) == LR_OK; }
    // Steps and slabs of half a metre on a lattice over this square, a part of them tilted.
    bool add_boxes(float half_side) {
        constexpr int across = 6;
        for (int i = 0; i < across * across; ++i) {
            const float pitch = 2.0f * half_side / across;
            lr_collider_desc d =
                collider_at(LR_COLLIDER_BOX, pitch * (static_cast<float>(i % across) + 0.5f) - half_side, 0.15f,
                            pitch * (static_cast<float>(i / across) + 0.5f) - half_side);
            d.size[0] = 0.5f, d.size[1] = 0.2f, d.size[2] = 0.3f;
            d.orientation[0] = 0.2f * static_cast<float>(i % 3), d.orientation[1] = 0.1f * static_cast<float>(i % 5);
            if (lr_collider_create(world_, &d, 1, nullptr) != LR_OK) return false;
        }
        return true;
    }

    bool start(const Starts& starts) {
        starts_ = starts;
        return start_next();
    }
    // Before each step.
    bool start_next() {
        const std::vector<lr_body_desc> descs = starts_.next();
        return descs.empty() ||
               lr_body_create(world_, batch_, descs.data(), static_cast<uint32_t>(descs.size()), nullptr) == LR_OK;
    }

    // A capsule of 1.72 m that walks along x at 1.4 m/s, from half a metre before the square to half a metre behind it.
    bool add_walker(float half_side) {
        from_ = -half_side - 0.5f;
        lr_collider_desc d = collider_at(LR_COLLIDER_CAPSULE, from_, walker_y, 0.0f);
        d.size[0] = 0.24f, d.size[1] = 0.62f;
        return lr_collider_create(world_, &d, 1, &walker_) == LR_OK;
    }
    int walk_steps() const { return static_cast<int>(-2.0f * from_ / (1.4f * step_seconds)); }
    void move_walker(int step) {
        lr_collider_motion m;
        lr_collider_motion_init(&m, sizeof m);
        m.collider = walker_;
        m.position[0] = from_ + 1.4f * step_seconds * static_cast<float>(step + 1);
        m.position[1] = walker_y;
        lr_collider_move(world_, &m, 1);
    }
    // m/s, 10 m above the ground.
    void blow(float speed) { lr_world_set_uniform_wind(world_, speed, 0.0f, 0.0f); }

    void step() { lr_world_step(world_, step_seconds, substeps); }

    struct Seen {
        uint32_t count, awake;
        uint32_t fast; // faster than 0.3 m/s
        double speed;  // mean over all bodies, m/s
    };
    Seen look() {
        lr_batch_view v;
        lr_batch_view_init(&v, sizeof v);
        if (lr_batch_get_view(world_, batch_, &v) != LR_OK) return {};
        Seen seen{v.count, v.awake_count, 0, 0.0};
        velocities_.resize(size_t{6} * v.count);
        lr_batch_write_velocities(world_, batch_, velocities_.data(), 0, v.count, nullptr);
        for (size_t i = 0; i < v.awake_count; ++i) {
            const float* const u = velocities_.data() + 6 * i;
            const auto speed = static_cast<double>(std::hypot(u[0], u[1], u[2]));
            seen.speed += speed / v.count;
            seen.fast += speed > 0.3 ? 1 : 0;
        }
        return seen;
    }
    uint32_t awake() const {
        lr_batch_view v;
        lr_batch_view_init(&v, sizeof v);
        return lr_batch_get_view(world_, batch_, &v) == LR_OK ? v.awake_count : 0;
    }
    test::HeapState state() const { return test::heap_state(world_, batch_); }
    uint64_t hash() const {
        uint64_t h = 0;
        lr_world_hash(world_, &h);
        return h;
    }

private:
    static constexpr float walker_y = 0.87f;

    lr_world* world_ = nullptr;
    lr_batch batch_{};
    lr_collider walker_{};
    Starts starts_;
    float from_ = 0.0f;
    std::vector<float> velocities_;
};

} // namespace bench
