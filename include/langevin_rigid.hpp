/*
 * Langevin Rigid for C++17: World and Asset destroy what they own, descs choose overloads, failures throw.
 *
 * SPDX-License-Identifier: MIT
 *
 * Inline functions over langevin_rigid.h, which explains units, frames, limits, threads, and the statuses of each call.
 * Handles, descs and views are the structs of C, descs begin as their macros: lr_gusts_desc gusts = LR_GUSTS_DESC_INIT.
 * Functions without a wrapper here, also those of langevin_rigid_research.h, take world.get() and asset.get().
 *
 * Errors       A failed call throws Error. Without exceptions (a compiler's switch, or LR_NO_EXCEPTIONS) it returns its
 *              lr_status, an invalid handle or an empty object, and lr_last_error() has the reason. To do something else,
 *              define LR_FAIL(status) before the header. All files of a program must choose alike.
 */
#ifndef LANGEVIN_RIGID_HPP
#define LANGEVIN_RIGID_HPP

#include "langevin_rigid.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>
#if __cplusplus >= 202002L || (defined(_MSVC_LANG) && _MSVC_LANG >= 202002L)
#include <span>
#define LR_HAS_SPAN 1
#endif

#if !defined(LR_NO_EXCEPTIONS) && !defined(__cpp_exceptions) && !defined(_CPPUNWIND)
#define LR_NO_EXCEPTIONS
#endif
#if !defined(LR_FAIL) && defined(LR_NO_EXCEPTIONS)
#define LR_FAIL(status) static_cast<void>(status)
#elif !defined(LR_FAIL)
#define LR_FAIL(status) throw ::langevin_rigid::Error(status)
#endif

namespace langevin_rigid {

using Float3 = std::array<float, 3>;

// what(): the function that failed and why.
class Error : public std::runtime_error {
public:
    explicit Error(lr_status status) : std::runtime_error(lr_last_error()), status_(status) {}
    lr_status status() const noexcept { return status_; }

private:
    lr_status status_;
};

// For calls of the C API: throws unless the status is LR_OK.
inline lr_status check(lr_status status) {
    if (status != LR_OK) LR_FAIL(status);
    return status;
}

// One reference to an asset. Batches hold their own, so it may be gone before them.
class Asset {
public:
    Asset() = default;
    explicit Asset(lr_asset* owned) noexcept : asset_(owned) {}

    static Asset load(const char* path_utf8) {
        lr_asset* out = nullptr;
        check(lr_asset_load_file(path_utf8, &out));
        return Asset(out);
    }
    static Asset load(const void* bytes, std::uint64_t size) {
        lr_asset* out = nullptr;
        check(lr_asset_load_memory(bytes, size, &out));
        return Asset(out);
    }
    static Asset ellipsoid(const lr_ellipsoid_desc& desc) {
        lr_asset* out = nullptr;
        check(lr_asset_create_ellipsoid(&desc, &out));
        return Asset(out);
    }

    lr_asset* get() const noexcept { return asset_.get(); }
    explicit operator bool() const noexcept { return asset_ != nullptr; }
    lr_asset_info info() const {
        lr_asset_info out = LR_ASSET_INFO_INIT;
        check(lr_asset_get_info(get(), &out));
        return out;
    }

private:
    struct Release {
        void operator()(lr_asset* asset) const noexcept { lr_asset_release(asset); }
    };
    std::unique_ptr<lr_asset, Release> asset_;
};

// The events of a step, for a range-based for. Valid until the next call that changes the world.
struct Events : lr_event_list {
    const lr_event* begin() const noexcept { return events; }
    const lr_event* end() const noexcept { return events + count; }
    std::uint32_t size() const noexcept { return count; }
    bool empty() const noexcept { return count == 0; }
};

// A world and all that is in it. After a move, calls on the old object fail.
class World {
public:
    explicit World(const lr_world_desc& desc = LR_WORLD_DESC_INIT) {
        lr_world* out = nullptr;
        check(lr_world_create(&desc, &out));
        world_.reset(out);
    }
    explicit World(lr_world* owned) noexcept : world_(owned) {}

    lr_world* get() const noexcept { return world_.get(); }
    explicit operator bool() const noexcept { return world_ != nullptr; }

    lr_status step(float dt, std::uint32_t substeps) { return check(lr_world_step(get(), dt, substeps)); }
    lr_world_info info() const {
        lr_world_info out = LR_WORLD_INFO_INIT;
        check(lr_world_get_info(get(), &out));
        return out;
    }
    std::uint64_t hash() const {
        std::uint64_t out = 0;
        check(lr_world_hash(get(), &out));
        return out;
    }

    lr_batch add(const lr_batch_desc& desc) {
        lr_batch out = {0};
        check(lr_batch_create(get(), &desc, &out));
        return out;
    }
    lr_batch add_batch(const Asset& asset, std::uint32_t capacity) {
        lr_batch_desc desc = LR_BATCH_DESC_INIT;
        desc.asset = asset.get(), desc.capacity = capacity;
        return add(desc);
    }
    lr_status set_emitter(lr_batch batch, const lr_emitter_desc& desc) {
        return check(lr_batch_set_emitter(get(), batch, &desc));
    }
    lr_status set_rules(lr_batch batch, const lr_batch_rules& rules) {
        return check(lr_batch_set_rules(get(), batch, &rules));
    }
    lr_status set_contact(lr_batch batch, const lr_batch_contact& contact) {
        return check(lr_batch_set_contact(get(), batch, &contact));
    }
    lr_batch_view view(lr_batch batch) const {
        lr_batch_view out = LR_BATCH_VIEW_INIT;
        check(lr_batch_get_view(get(), batch, &out));
        return out;
    }
    // Returns how many were written.
    std::uint32_t write_transforms(lr_batch batch, lr_transform_format format, void* dst, std::uint32_t count,
                                   std::uint64_t stride = 0) const {
        std::uint32_t written = 0;
        check(lr_batch_write_transforms(get(), batch, format, dst, stride, count, &written));
        return written;
    }

    lr_body add(lr_batch batch, const lr_body_desc& desc) {
        lr_body out = {0};
        check(lr_body_create(get(), batch, &desc, 1, &out));
        return out;
    }
    std::vector<lr_body> add(lr_batch batch, const lr_body_desc* descs, std::uint32_t count) {
        return many(count, [&](lr_body* ids) { return lr_body_create(get(), batch, descs, count, ids); });
    }
    std::vector<lr_body> spawn(lr_batch batch, std::uint32_t count) {
        return many(count, [&](lr_body* ids) { return lr_batch_spawn(get(), batch, count, ids); });
    }
    std::vector<lr_body> spawn_box(lr_batch batch, const Float3& low, const Float3& high, std::uint32_t count) {
        return many(
            count, [&](lr_body* ids) { return lr_batch_spawn_box(get(), batch, low.data(), high.data(), count, ids); });
    }
    lr_body_state state(lr_body body) const {
        lr_body_state out = LR_BODY_STATE_INIT;
        check(lr_body_get_state(get(), body, &out));
        return out;
    }
    lr_status set_state(lr_body body, const lr_body_state& state) {
        return check(lr_body_set_state(get(), body, &state));
    }

    lr_wind_source add(const lr_gusts_desc& desc) { return add_source(lr_world_add_gusts, desc); }
    lr_wind_source add(const lr_vortex_desc& desc) { return add_source(lr_world_add_vortex, desc); }
    lr_wind_source add(const lr_blower_desc& desc) { return add_source(lr_world_add_blower, desc); }
    lr_wind_source add(const lr_turbulence_desc& desc) { return add_source(lr_world_add_turbulence, desc); }
    lr_wind_source add(const lr_wind_grid_desc& desc) { return add_source(lr_world_add_wind_grid, desc); }
    lr_wind_source add(const lr_ground_wind_desc& desc) { return add_source(lr_world_add_ground_wind, desc); }
    lr_status set_uniform_wind(float x, float y, float z) { return check(lr_world_set_uniform_wind(get(), x, y, z)); }
    lr_status set_water(const lr_water_desc& desc) { return check(lr_world_set_water(get(), &desc)); }

    lr_collider add(const lr_collider_desc& desc) {
        lr_collider out = {0};
        check(lr_collider_create(get(), &desc, 1, &out));
        return out;
    }

    lr_status remove(lr_batch batch) { return check(lr_batch_destroy(get(), batch)); }
    lr_status remove(lr_body body) { return check(lr_body_destroy(get(), &body, 1)); }
    lr_status remove(lr_collider collider) { return check(lr_collider_destroy(get(), &collider, 1)); }
    lr_status remove(lr_wind_source source) { return check(lr_world_remove_wind(get(), source)); }

    lr_status set_events(std::uint32_t capacity, lr_event_kinds kinds = LR_EVENTS_ALL) {
        return check(lr_world_set_events(get(), capacity, kinds));
    }
    Events events() const {
        Events out = {LR_EVENT_LIST_INIT};
        check(lr_world_get_events(get(), &out));
        return out;
    }

    // The first hit, if there is one.
    std::optional<lr_ray_hit> ray_cast(const lr_ray& ray) const {
        lr_ray_hit hit{};
        check(lr_world_ray_cast(get(), &ray, 1, &hit));
        return hit.body.id != 0 || hit.collider.id != 0 ? std::optional<lr_ray_hit>(hit) : std::nullopt;
    }

    // Reuses the memory of `out`, for rollback.
    lr_status save(std::vector<unsigned char>& out) const {
        out.resize(lr_world_snapshot_size(get()));
        return check(lr_world_snapshot_save(get(), out.data(), out.size(), nullptr));
    }
    std::vector<unsigned char> save() const {
        std::vector<unsigned char> out;
        save(out);
        return out;
    }
    lr_status restore(const std::vector<unsigned char>& snapshot) {
        return check(lr_world_snapshot_restore(get(), snapshot.data(), snapshot.size()));
    }

#ifdef LR_HAS_SPAN
    std::vector<lr_body> add(lr_batch batch, std::span<const lr_body_desc> descs) {
        return add(batch, descs.data(), static_cast<std::uint32_t>(descs.size()));
    }
    lr_status restore(std::span<const unsigned char> snapshot) {
        return check(lr_world_snapshot_restore(get(), snapshot.data(), snapshot.size()));
    }
#endif

private:
    // Empty after an error.
    template <class Create> static std::vector<lr_body> many(std::uint32_t count, const Create& create) {
        std::vector<lr_body> ids(count);
        if (check(create(ids.data())) != LR_OK) ids.clear();
        return ids;
    }
    template <class Desc>
    lr_wind_source add_source(lr_status (*create)(lr_world*, const Desc*, lr_wind_source*), const Desc& desc) {
        lr_wind_source out = {0};
        check(create(get(), &desc, &out));
        return out;
    }

    struct Destroy {
        void operator()(lr_world* world) const noexcept { lr_world_destroy(world); }
    };
    std::unique_ptr<lr_world, Destroy> world_;
};

} // namespace langevin_rigid

#endif
