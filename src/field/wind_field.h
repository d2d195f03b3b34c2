// All wind of a world: the uniform part and how it changes, sources, the caller's own field. docs/reference/wind_and_water.md.
#pragma once

#include "field/wind_source.h"
#include "kernel/step.h"

#include <atomic>
#include <cstdint>

namespace lr {

struct UniformWind {
    float wind[3] = {0.0f, 0.0f, 0.0f};   // m/s, what the next step ends with
    float before[3] = {0.0f, 0.0f, 0.0f}; // m/s, what the last one ended with
    double drift[3] = {0.0, 0.0, 0.0};    // m, its way since the world began
};

// One step in time, of which a slice of substeps is prepared.
struct StepTime {
    double begin; // s, world time at the beginning of the step
    double h;     // s, one substep
    uint32_t substeps;
};

class WindField {
public:
    // Substeps that are prepared at a time.
    static constexpr uint32_t slice = 8;

    explicit WindField(Allocator& allocator) : allocator_(&allocator) {}
    ~WindField();
    WindField(const WindField&) = delete;
    WindField& operator=(const WindField&) = delete;

    // Anything but the uniform wind?
    bool active() const { return used_ != 0 || callback_; }

    // The desc has been checked. All leave everything as it was when they fail.
    lr_status add(const lr_wind_source_desc& desc, double time, uint64_t seed, lr_wind_source& out);
    lr_status update(lr_wind_source source, const lr_wind_source_desc& desc, double time, uint64_t seed);
    bool remove(lr_wind_source source);
    const WindSource* find(lr_wind_source source) const;

    void set_callback(lr_wind_fn function, void* user);
    lr_wind_fn callback() const { return callback_; }
    void* callback_user() const { return callback_user_; }
    // Another that gives the same answers: what was said of them holds.
    void replace_callback(lr_wind_fn function, void* user) { callback_ = function, callback_user_ = user; }
    // visit(desc, hash, samples, count) of each source with a grid.
    template <class Visit> void visit_grids(Visit&& visit) const {
        for (const Slot& slot : slots_) {
            if (!slot.source || !slot.source->grid) continue;
            const GridSamples& grid = *slot.source->grid;
            visit(slot.source->desc, grid.hash, grid.values.data(), uint64_t{grid.values.size()});
        }
    }
    // From any worker: the callback gave something that is no velocity.
    void blame_callback() { blamed_.store(true, std::memory_order_relaxed); }
    // True once for each callback.
    bool take_blame();

    // Prepares substeps first to first + count of a step, count up to `slice`. over: the uniform wind in it.
    void prepare(const StepTime& time, const UniformWind& over, uint32_t first, uint32_t count, uint64_t seed);
    // Prepares the present moment.
    void prepare_now(double time, uint64_t seed);
    const FieldInstant& instant(uint32_t i) const { return instants_[i]; }

    // The uniform wind moves on by a step.
    void end_step(float dt);

    // Of everything that matters for motion and is not the uniform wind; 0 without sources.
    uint64_t hash(double time) const;

    UniformWind uniform;

private:
    friend class WindSnapshot;
    static constexpr uint32_t capacity = LR_MAX_WIND_SOURCES;
    // A handle is slot + 1 in the low bits, so that 0 is none, and the slot's generation above.
    static constexpr uint32_t slot_bits = 7, last_generation = (1u << (32 - slot_bits)) - 1;
    static_assert(capacity < 1u << slot_bits);

    struct Slot {
        WindSource* source;
        uint32_t generation; // of the source in it, or of the next
    };
    // Way and velocity of the uniform wind, which turbulence goes along with.
    struct Carried {
        double way[3], velocity[3];
    };
    lr_status make(const lr_wind_source_desc& desc, double time, uint64_t seed, GridSamples* grid, WindSource*& out);
    // Its memory is kept for the next that is made.
    void release(WindSource* source);
    void keep_spares(uint32_t most);
    void release(GridSamples* grid);
    GridSamples* find_samples(const lr_wind_source_desc& desc, uint64_t hash) const;
    bool reserve(uint32_t instants);
    uint32_t total_instants() const;
    void clear();
    void uniform_at(const UniformWind& over, double part, double time, double wind[3]) const;
    void fill(FieldInstant& to, SourceInstant* sources, double time, const Carried& carried, uint64_t seed) const;

    Allocator* allocator_;
    Slot slots_[capacity] = {};
    uint32_t used_ = 0;
    void* spare_[capacity] = {}; // memory for a WindSource each: updates and restores take none anew
    uint32_t spares_ = 0;
    Buffer<SourceInstant> prepared_;
    FieldInstant instants_[slice] = {};
    lr_wind_fn callback_ = nullptr;
    void* callback_user_ = nullptr;
    std::atomic<bool> blamed_{false};
    bool told_ = false;
};

} // namespace lr
