// The library, only through its C API and shared object.
#include "lr_bench/leaf.h"
#include "lr_bench/rows.h"
#include "lr_bench/subject.h"

#include "full_mass_matrix.h"
#include "langevin_rigid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

namespace lr_bench {
namespace {

class Ours final : public Subject {
public:
    ~Ours() override {
        lr_world_destroy(world_);
        lr_asset_release(asset_);
    }

    const char* make(const Row& row) {
        dt_ = substep_seconds * static_cast<float>(row.substeps);
        substeps_ = row.substeps;
        const uint32_t stations = row.stations();
        asset_ =
            stations != 0 ? leaf_asset_of_stations(stations) : leaf_asset(row.path == "full" || row.path == "sheet");
        if (!asset_) return "asset";
        lr_world_desc wd;
        lr_world_desc_init(&wd, sizeof wd);
        wd.worker_count = row.workers;
        wd.simd_target = target_value(row.target);
        // Without loads nothing would slow bodies down.
        if (row.model == "none") wd.gravity[1] = 0.0f;
        if (lr_world_create(&wd, &world_) != LR_OK) return "this processor cannot run it";

        lr_batch_desc bd;
        lr_batch_desc_init(&bd, sizeof bd);
        bd.asset = asset_;
        bd.capacity = row.bodies;
        if (row.path == "alike") bd.variation = 0.0f;
        if (!find_model(row.model, bd.load_model, bd.clock)) return "unknown model";
        if (!find_integrator(row.integrator, bd.integrator)) return "unknown integrator";
        // Turbulence that decays in a second would leave nothing to time.
        bd.table_end = LR_TABLE_LOOP;
        if (lr_batch_create(world_, &bd, &batch_) != LR_OK) return "batch";
        if (row.path == "full" && !take_full_path(world_, batch_)) return "full path";

        const uint64_t empty = lr_world_snapshot_size(world_);
        if (!release_bodies(row.bodies, row.path == "user")) return "bodies";
        lr_world_info info;
        lr_world_info_init(&info, sizeof info);
        lr_world_get_info(world_, &info);
        facts_.memory_bytes = static_cast<double>(info.memory_bytes) / row.bodies;
        facts_.state_bytes = static_cast<double>(lr_world_snapshot_size(world_) - empty) / row.bodies;
        for (int i = 0; i < 4; ++i)
            if (!step()) return "step";
        facts_.hashed = lr_world_hash(world_, &facts_.hash) == LR_OK;
        return nullptr;
    }

    // Writes instances for a renderer: `format` is LR_TRANSFORM_*.
    bool write(int32_t format, void* to, uint32_t capacity) const {
        return lr_batch_write_transforms(world_, batch_, format, to, 0, capacity, nullptr) == LR_OK;
    }

    bool step() override { return lr_world_step(world_, dt_, substeps_) == LR_OK; }
    Facts facts() const override { return facts_; }

    uint64_t lost() const override {
        lr_batch_view view;
        lr_batch_view_init(&view, sizeof view);
        if (lr_batch_get_view(world_, batch_, &view) != LR_OK) return ~uint64_t{0};
        std::vector<float> u(size_t{6} * view.count);
        if (lr_batch_write_velocities(world_, batch_, u.data(), 0, view.count, nullptr) != LR_OK) return ~uint64_t{0};
        uint64_t count = 0;
        for (size_t i = 0; i < view.count; ++i) count += !std::isfinite(view.position[0][i] + u[6 * i] + u[6 * i + 3]);
        return count;
    }

private:
    // In a box of 100 m, turned at random, with some speed and spin.
    bool release_bodies(uint32_t count, bool user) {
        std::vector<lr_body_desc> descs(std::min(count, 4096u));
        for (uint32_t first = 0; first < count; first += 4096) {
            const uint32_t some = std::min(count - first, 4096u);
            for (uint32_t i = 0; i < some; ++i) {
                lr_body_desc& d = descs[i];
                lr_body_desc_init(&d, sizeof d);
                const uint64_t at = 13 * (uint64_t{first} + i);
                d.user = user ? at + 1 : 0;
                const auto within = [at](uint32_t k, float limit) { return limit * (2.0f * uniform(at + k) - 1.0f); };
                for (uint32_t k = 0; k < 3; ++k) {
                    d.position[k] = within(k, 50.0f);
                    d.linear_velocity[k] = within(k + 3, 0.5f);
                    d.angular_velocity[k] = within(k + 6, 5.0f);
                }
                for (uint32_t k = 0; k < 4; ++k) d.orientation[k] = within(k + 9, 1.0f) + (k == 3 ? 0.01f : 0.0f);
            }
            if (lr_body_create(world_, batch_, descs.data(), some, nullptr) != LR_OK) return false;
        }
        return true;
    }

    lr_asset* asset_ = nullptr;
    lr_world* world_ = nullptr;
    lr_batch batch_{};
    float dt_ = 0.0f;
    uint32_t substeps_ = 1;
    Facts facts_;
};

struct Layout {
    const char* name;
    int32_t format;
    size_t bytes;
};
constexpr Layout layouts[] = {{"3x4", LR_TRANSFORM_3X4_ROW_MAJOR, 48}, {"4x4", LR_TRANSFORM_4X4_ROW_MAJOR, 64}};

// Transforms of all bodies, or a memcpy of the same size; the row's path is the layout.
class Transforms final : public Subject {
public:
    const char* make(const Row& row) {
        for (const Layout& l : layouts)
            if (row.path == l.name) layout_ = l;
        if (!layout_.bytes) return "unknown layout";
        bodies_ = row.bodies;
        to_.resize(layout_.bytes * bodies_);
        if (row.subject == "memcpy") return from_.resize(to_.size(), std::byte{1}), nullptr;
        Row world = row;
        world.path = "diagonal";
        return ours_.make(world);
    }
    bool step() override {
        if (from_.empty()) return ours_.write(layout_.format, to_.data(), bodies_);
        std::memcpy(to_.data(), from_.data(), to_.size());
        asm volatile("" : : "r"(to_.data()) : "memory"); // keeps the compiler from removing it
        return true;
    }

private:
    Ours ours_;
    Layout layout_{};
    uint32_t bodies_ = 0;
    std::vector<std::byte> to_, from_;
};

template <class T> std::unique_ptr<Subject> make(const Row& row, std::string& why_not) {
    auto made = std::make_unique<T>();
    if (const char* const why = made->make(row)) {
        why_not = why;
        return nullptr;
    }
    return made;
}

} // namespace

std::unique_ptr<Subject> make_ours(const Row& row, std::string& why_not) {
    return row.ours() ? make<Ours>(row, why_not) : make<Transforms>(row, why_not);
}

} // namespace lr_bench
