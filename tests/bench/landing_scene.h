// A batch of leaves, and a ground of 50 m x 50 m with a hundred colliders of all kinds on it. Uses only + - x /, so that hashes
// are the same everywhere.
#pragma once

#include "bench/leaf_asset.h"
#include "bench/scene_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace bench {

constexpr float step_seconds = 1.0f / 60.0f;
constexpr uint32_t substeps = 2;
constexpr uint32_t samples = 101; // per side
constexpr float cell = 0.5f, side = cell * (samples - 1);

class Scene {
public:
    Scene() = default;
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;
    ~Scene() {
        lr_world_destroy(world_);
        lr_asset_release(asset_);
    }

    // file: an asset; null: the ellipsoid of the other benchmarks.
    bool make(const char* file, uint32_t capacity, uint32_t workers) {
        lr_asset* asset = nullptr;
        if (file) {
            if (lr_asset_load_file(file, &asset) != LR_OK) return false;
        } else {
            asset = leaf_asset();
        }
        return make(asset, capacity, workers);
    }
    // Keeps the asset.
    bool make(lr_asset* asset, uint32_t capacity, uint32_t workers) {
        asset_ = asset;
        lr_world_desc wd;
        lr_world_desc_init(&wd, sizeof wd);
        wd.worker_count = workers;
        if (!asset_ || lr_world_create(&wd, &world_) != LR_OK) return false;
        lr_batch_desc bd;
        lr_batch_desc_init(&bd, sizeof bd);
        bd.asset = asset_;
        bd.capacity = capacity;
        bd.load_model = LR_LOADS_AERODYNAMIC;
        return lr_batch_create(world_, &bd, &batch_) == LR_OK;
    }

    bool emit(uint32_t count, float low, float high, float half = 0.48f * side) {
        lr_emitter_desc e;
        lr_emitter_desc_init(&e, sizeof e);
        e.shape = LR_EMIT_BOX;
        e.position[1] = 0.5f * (low + high);
        e.size[0] = e.size[2] = half;
        e.size[1] = 0.5f * (high - low);
        ids_.resize(count);
        return lr_batch_set_emitter(world_, batch_, &e) == LR_OK &&
               lr_batch_spawn(world_, batch_, count, ids_.data()) == LR_OK;
    }
    // A plane with twenty houses, and a wall downwind of all, in a wind of 8 m/s.
    bool add_houses() {
        std::vector<lr_collider_desc> all{collider_at(LR_COLLIDER_PLANE, 0.0f, 0.0f, 0.0f)};
        for (int k = 0; k < 20; ++k) {
            const float x = 10.0f * static_cast<float>(k % 4) - 10.0f, z = 10.0f * static_cast<float>(k / 4) - 20.0f;
            lr_collider_desc house = collider_at(LR_COLLIDER_BOX, x, 3.0f, z + (k % 2 == 0 ? 2.0f : -2.0f));
            house.size[0] = 3.0f, house.size[1] = 3.0f, house.size[2] = 2.5f;
            all.push_back(house);
        }
        lr_collider_desc wall = collider_at(LR_COLLIDER_BOX, 0.55f * side, 2.0f, 0.0f);
        wall.size[0] = 0.2f, wall.size[1] = 2.0f, wall.size[2] = 0.6f * side;
        all.push_back(wall);
        return lr_collider_create(world_, all.data(), static_cast<uint32_t>(all.size()), nullptr) == LR_OK &&
               lr_world_set_uniform_wind(world_, 8.0f, 0.0f, 0.0f) == LR_OK;
    }
    bool lay_down() {
        return lr_body_set_sleep(world_, ids_.data(), static_cast<uint32_t>(ids_.size()), LR_SLEEP_ASLEEP) == LR_OK;
    }
    // Hills of 0.6 m below y = 0, a plane below them, and on them spheres, capsules, boxes, hulls and meshes of about a metre; every
    // tenth turns if colliders move. of_triangles: the hills are a mesh, not a heightfield.
    bool add_ground(bool of_triangles = false, bool turning = true, uint32_t solids = 98) {
        std::vector<float> heights(samples * samples);
        for (uint32_t k = 0; k < samples; ++k)
            for (uint32_t i = 0; i < samples; ++i)
                heights[i + samples * k] = -0.5f * smooth(i, k, 16) - 0.1f * smooth(i, k, 4);
        lr_collider_desc field = collider_at(LR_COLLIDER_HEIGHTFIELD, -0.5f * side, 0.0f, -0.5f * side);
        field.counts[0] = field.counts[1] = samples;
        field.spacing[0] = field.spacing[1] = cell;
        field.heights = heights.data();
        std::vector<float> vertices;
        std::vector<uint32_t> triangles;
        for (uint32_t at = 0; at < samples * samples; ++at) {
            const uint32_t i = at % samples, k = at / samples, along = at + samples;
            vertices.insert(vertices.end(), {cell * static_cast<float>(i), heights[at], cell * static_cast<float>(k)});
            if (i + 1 < samples && k + 1 < samples)
                triangles.insert(triangles.end(), {at, along, along + 1, at, along + 1, at + 1});
        }
        if (of_triangles) {
            field.kind = LR_COLLIDER_MESH;
            field.vertices = vertices.data();
            field.vertex_count = samples * samples;
            field.indices = triangles.data();
            field.triangle_count = static_cast<uint32_t>(triangles.size() / 3);
        }
        lr_collider_desc below = collider_at(LR_COLLIDER_PLANE, 0.0f, -2.0f, 0.0f);
        if (lr_collider_create(world_, &field, 1, nullptr) != LR_OK ||
            lr_collider_create(world_, &below, 1, nullptr) != LR_OK)
            return false;
        const float wedge[] = {-0.6f, -0.3f, -0.4f, 0.6f, -0.3f, -0.4f, -0.6f, -0.3f, 0.4f,
                               0.6f,  -0.3f, 0.4f,  0.0f, 0.5f,  -0.3f, 0.1f,  0.4f,  0.4f};
        // A table of two slopes.
        const float roof[] = {-0.7f, 0.0f, -0.7f, 0.0f, 0.4f, -0.7f, 0.7f, 0.0f, -0.7f,
                              -0.7f, 0.0f, 0.7f,  0.0f, 0.4f, 0.7f,  0.7f, 0.0f, 0.7f};
        const uint32_t corners[] = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
        constexpr int32_t kinds[] = {LR_COLLIDER_SPHERE, LR_COLLIDER_CAPSULE, LR_COLLIDER_BOX, LR_COLLIDER_HULL,
                                     LR_COLLIDER_MESH};
        for (uint32_t n = 0; n < solids; ++n) {
            lr_collider_desc d =
                collider_at(kinds[n % 5], side * (hashed(n, 1) - 0.5f), 0.2f, side * (hashed(n, 2) - 0.5f));
            for (size_t k = 0; k < 4; ++k) d.orientation[k] = hashed(n, 3 + static_cast<uint32_t>(k)) - 0.5f;
            for (float& size : d.size) size = 0.2f + 0.4f * hashed(n, 7);
            if (turning && n % 10 == 3) d.angular_velocity[1] = 1.0f;
            d.vertices = d.kind == LR_COLLIDER_HULL ? wedge : roof;
            d.vertex_count = 6;
            d.indices = corners;
            d.triangle_count = 4;
            if (lr_collider_create(world_, &d, 1, nullptr) != LR_OK) return false;
        }
        return true;
    }

    // A saddle of triangles, 4 m wide. width: m, of a cell of two.
    // uneven: with slopes of up to a half.
    bool add_sheet(float width, bool uneven = false) {
        const auto across = static_cast<uint32_t>(4.0f / width + 0.5f) + 1;
        std::vector<float> vertices;
        std::vector<uint32_t> triangles;
        for (uint32_t at = 0; at < across * across; ++at) {
            const uint32_t i = at % across, k = at / across, along = at + across;
            const float x = width * static_cast<float>(i) - 2.0f, z = width * static_cast<float>(k) - 2.0f;
            const float bump = uneven ? 0.06f * std::sin(9.0f * x) * std::cos(7.0f * z) : 0.0f;
            vertices.insert(vertices.end(), {x, 0.05f * (x * x - z * z) + bump, z});
            if (i + 1 < across && k + 1 < across)
                triangles.insert(triangles.end(), {at, along, along + 1, at, along + 1, at + 1});
        }
        lr_collider_desc sheet = collider_at(LR_COLLIDER_MESH, 0.0f, 0.0f, 0.0f);
        sheet.vertices = vertices.data();
        sheet.vertex_count = across * across;
        sheet.indices = triangles.data();
        sheet.triangle_count = static_cast<uint32_t>(triangles.size() / 3);
        return lr_collider_create(world_, &sheet, 1, nullptr) == LR_OK;
    }
    bool add_walker() {
        lr_collider_desc d = collider_at(LR_COLLIDER_CAPSULE, walker_x(0), walker_y, 0.0f);
        d.size[0] = 0.35f, d.size[1] = 0.5f;
        return lr_collider_create(world_, &d, 1, &walker_) == LR_OK;
    }
    void move_walker(int step) {
        lr_collider_motion m;
        lr_collider_motion_init(&m, sizeof m);
        m.collider = walker_;
        m.position[0] = walker_x(step + 1);
        m.position[1] = walker_y;
        lr_collider_move(world_, &m, 1);
    }

    lr_world* world() const { return world_; }
    lr_batch batch() const { return batch_; }
    void step() { lr_world_step(world_, step_seconds, substeps); }
    uint64_t hash() const {
        uint64_t h = 0;
        lr_world_hash(world_, &h);
        return h;
    }
    uint32_t awake() const {
        lr_batch_view v;
        lr_batch_view_init(&v, sizeof v);
        return lr_batch_get_view(world_, batch_, &v) == LR_OK ? v.awake_count : 0;
    }
    void save() {
        snapshot_.resize(lr_world_snapshot_size(world_));
        lr_world_snapshot_save(world_, snapshot_.data(), snapshot_.size(), nullptr);
    }
    void restore() { lr_world_snapshot_restore(world_, snapshot_.data(), snapshot_.size()); }

private:
    static constexpr float walker_y = 0.4f;
    static float walker_x(int step) { return -0.3f * side + 1.4f * step_seconds * static_cast<float>(step); }

    // Interpolates values on a lattice of this many samples.
    static float smooth(uint32_t i, uint32_t k, uint32_t width) {
        const auto part = [width](uint32_t at) {
            const float t = static_cast<float>(at % width) / static_cast<float>(width);
            return t * t * (3.0f - 2.0f * t);
        };
        const uint32_t a = i / width, b = k / width;
        const float u = part(i), w = part(k);
        const auto at = [&](uint32_t x, uint32_t z) { return hashed(x + 977 * width, z); };
        return (1.0f - w) * ((1.0f - u) * at(a, b) + u * at(a + 1, b)) +
               w * ((1.0f - u) * at(a, b + 1) + u * at(a + 1, b + 1));
    }

    lr_asset* asset_ = nullptr;
    lr_world* world_ = nullptr;
    lr_batch batch_{};
    lr_collider walker_{};
    std::vector<lr_body> ids_;
    std::vector<unsigned char> snapshot_;
};

} // namespace bench
