// Millions of bodies in one world, a thousand worlds, and more threads than processors.
#include "load/load.h"
#include "load/storm.h"

#include <cstdio>
#include <vector>

namespace load {
namespace {

template <class T> T initialised(lr_status (*init)(T*, uint32_t)) {
    T desc;
    must(init(&desc, sizeof desc), "init");
    return desc;
}

lr_asset* leaf() {
    lr_ellipsoid_desc d = initialised(lr_ellipsoid_desc_init);
    d.semi_axes[0] = 0.04, d.semi_axes[1] = 0.01, d.semi_axes[2] = 0.00005;
    d.density = 800.0;
    lr_asset* asset = nullptr;
    must(lr_asset_create_ellipsoid(&d, &asset), "asset");
    return asset;
}

lr_batch add_leaves(lr_world* world, lr_asset* asset, uint32_t count) {
    lr_batch_desc bd = initialised(lr_batch_desc_init);
    bd.asset = asset;
    bd.capacity = count;
    lr_batch batch{};
    must(lr_batch_create(world, &bd, &batch), "batch");
    constexpr uint32_t at_once = 4096;
    std::vector<lr_body_desc> bodies(at_once, initialised(lr_body_desc_init));
    for (uint32_t first = 0; first < count; first += at_once) {
        const uint32_t here = count - first < at_once ? count - first : at_once;
        for (uint32_t i = 0; i < here; ++i)
            for (uint32_t k = 0; k < 3; ++k)
                bodies[i].position[k] = static_cast<float>((first + i) >> (8 * k) & 0xffu) * 0.2f;
        must(lr_body_create(world, batch, bodies.data(), here, nullptr), "bodies");
    }
    return batch;
}

lr_world_info info_of(const lr_world* world) {
    lr_world_info i = initialised(lr_world_info_init);
    must(lr_world_get_info(world, &i), "info");
    return i;
}
uint64_t hash_of(const lr_world* world) {
    uint64_t hash = 0;
    must(lr_world_hash(world, &hash), "hash");
    return hash;
}

} // namespace

int many_bodies(uint32_t count) {
    const uint64_t needed = uint64_t{count} * 120, free = memory_free();
    if (free != 0 && free < needed) {
        std::printf("SKIPPED: %u bodies take %llu MB and this machine has %llu MB to give\n", count,
                    static_cast<unsigned long long>(needed >> 20), static_cast<unsigned long long>(free >> 20));
        return 0;
    }
    const uint64_t before = resident_bytes();
    lr_asset* const asset = leaf();
    const lr_world_desc wd = initialised(lr_world_desc_init);
    lr_world* world = nullptr;
    must(lr_world_create(&wd, &world), "world");
    const lr_batch batch = add_leaves(world, asset, count);
    constexpr int steps = 4;
    const double since = seconds_now();
    for (int i = 0; i < steps; ++i) must(lr_world_step(world, frame, 2), "step");
    const double nanoseconds = (seconds_now() - since) * 1e9 / (2.0 * steps) / count;
    const lr_world_info i = info_of(world);
    int bad = 0;
    bad += verdict(i.body_count == count, "bodies", "%llu", static_cast<unsigned long long>(i.body_count));
    const double bytes = static_cast<double>(i.memory_bytes) / count;
    bad += verdict(bytes < 124.0 + 50000.0 / count, "memory of the world", "%.2f bytes a body", bytes);
    const uint64_t here = resident_bytes();
    const double resident = static_cast<double>(here > before ? here - before : 0) / count;
    bad += verdict(resident < 1.05 * bytes + 4e6 / count, "memory of the process", "%.2f bytes a body", resident);
    std::printf("      %.1f ns a body and substep, without workers\n", nanoseconds);
    // The last body has moved like the first: down, by a small distance.
    lr_batch_view v = initialised(lr_batch_view_init);
    must(lr_batch_get_view(world, batch, &v), "view");
    double lowest = 0.0;
    for (uint32_t b = 0; b < v.count; ++b) {
        const double fallen = static_cast<double>(v.position[1][b]) - static_cast<double>(b >> 8 & 0xffu) * 0.2;
        if (!(fallen > lowest)) lowest = fallen;
    }
    bad += verdict(lowest < -1e-3 && lowest > -0.2, "deepest fall", "%.4f m", lowest);
    lr_world_destroy(world);
    lr_asset_release(asset);
    const uint64_t after = resident_bytes();
    bad += verdict(after <= before + (8u << 20), "memory given back", "%llu bytes more than before",
                   static_cast<unsigned long long>(after > before ? after - before : 0));
    return bad;
}

int many_worlds(uint32_t count) {
    lr_asset* const asset = leaf();
    const lr_world_desc wd = initialised(lr_world_desc_init);
    int bad = 0;
    uint64_t first_round = 0;
    for (int round = 0; round < 3; ++round) {
        const uint64_t before = resident_bytes();
        const double since = seconds_now();
        std::vector<lr_world*> worlds(count, nullptr);
        for (uint32_t w = 0; w < count; ++w) {
            must(lr_world_create(&wd, &worlds[w]), "world");
            add_leaves(worlds[w], asset, 100);
        }
        const uint64_t bytes = info_of(worlds[0]).memory_bytes;
        const uint64_t high = resident_bytes();
        for (int s = 0; s < 10; ++s)
            for (lr_world* world : worlds) must(lr_world_step(world, frame, 2), "step");
        uint32_t different = 0;
        for (lr_world* world : worlds) different += hash_of(world) != hash_of(worlds[0]);
        for (lr_world* world : worlds) lr_world_destroy(world);
        const uint64_t after = resident_bytes();
        if (round == 0) first_round = after;
        std::printf("      %u worlds of 100 bodies, 10 steps each: %.2f s, %llu bytes each, resident %llu + %llu KB, "
                    "afterwards %llu KB\n",
                    count, seconds_now() - since, static_cast<unsigned long long>(bytes),
                    static_cast<unsigned long long>(before >> 10),
                    static_cast<unsigned long long>((high > before ? high - before : 0) >> 10),
                    static_cast<unsigned long long>(after >> 10));
        bad += verdict(different == 0, "worlds that differ", "%u", different);
        if (round != 0)
            bad += verdict(after <= first_round + (2u << 20), "memory after another round", "%lld KB more",
                           (static_cast<long long>(after) - static_cast<long long>(first_round)) / 1024);
    }
    lr_asset_release(asset);
    return bad;
}

int many_threads(uint32_t workers, uint32_t steps) {
    uint64_t hash[2] = {};
    double seconds[2] = {};
    for (int with = 0; with < 2; ++with) {
        Storm storm(7, with ? workers : 0);
        // Enough bodies to give all threads work.
        lr_asset* const asset = leaf();
        add_leaves(storm.world(), asset, 20000);
        lr_asset_release(asset);
        const double since = seconds_now();
        for (uint32_t i = 0; i < steps; ++i) storm.step();
        seconds[with] = seconds_now() - since;
        hash[with] = hash_of(storm.world());
    }
    std::printf("      %u steps: %.2f s alone, %.2f s with %u workers\n", steps, seconds[0], seconds[1], workers);
    return verdict(hash[0] == hash[1], "hashes without and with workers", "%016llx, %016llx",
                   static_cast<unsigned long long>(hash[0]), static_cast<unsigned long long>(hash[1]));
}

} // namespace load
