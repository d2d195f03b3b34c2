// Every call of the API that can allocate, in sequence, for tests with failing memory. The caller's own memory is allocated before the first call.
#pragma once

#include "support/colliders.h"
#include "support/wind.h"

#include <functional>
#include <string>

namespace test {

class WholeScenario {
public:
    // Assets and arrays, which the scenario only reads.
    struct Kit {
        Kit();
        Asset leaf, curled, brick, loaded;
        std::vector<float> samples, other_samples, hull, heights, table;
        Triangles sheet;
        std::vector<lr_body_desc> bodies, heap;
        std::vector<lr_collider_desc> solids, spheres;
        std::vector<AnySource> winds;
    };

    WholeScenario(const Kit& kit, const lr_allocator& allocator);
    ~WholeScenario();
    WholeScenario(const WholeScenario&) = delete;
    WholeScenario& operator=(const WholeScenario&) = delete;

    size_t size() const { return calls_.size(); }
    const std::string& name(size_t call) const { return calls_[call].name; }
    bool steps(size_t call) const { return calls_[call].steps; }
    bool creates_world(size_t call) const { return calls_[call].creates; }
    // Repeats the call after an error, or makes the next one.
    lr_status run(size_t call) { return calls_[call].call(); }

    lr_world* world(uint32_t which) const { return world_[which]; }
    // Bodies, since the scenario began, that lacked a result because memory failed.
    uint32_t warnings() const { return warnings_; }

private:
    struct Call {
        std::string name;
        std::function<lr_status()> call;
        bool steps = false, creates = false;
    };
    void add(const char* name, std::function<lr_status()> call) { calls_.push_back({name, std::move(call)}); }
    void add_step(uint32_t which, int count, uint32_t substeps);
    void add_worlds();
    void add_batches(uint32_t which);
    void add_settings();
    void add_winds();
    void add_colliders(uint32_t which);
    void add_heap();
    void add_rest();
    void add_queries();
    void add_snapshots();
    void add_ends();
    static void log(void* user, int32_t level, const char* message);

    const Kit& kit_;
    lr_allocator allocator_;
    std::vector<Call> calls_;
    lr_world* world_[2] = {};
    static constexpr size_t batches = 11;
    lr_batch batch_[2][batches] = {};
    lr_wind_source wind_[2][16] = {};
    std::vector<lr_body> leaves_, bricks_;
    std::vector<lr_collider> solids_, spheres_;
    std::vector<lr_collider_motion> motions_;
    std::vector<lr_ray> rays_;
    std::vector<lr_ray_hit> hits_;
    std::vector<unsigned char> snapshot_;
    uint64_t saved_ = 0;
    uint32_t warnings_ = 0;
};

} // namespace test
