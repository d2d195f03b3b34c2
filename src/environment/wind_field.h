// The wind of a world: uniform wind and its changes, sources, the caller's callback. docs/reference/wind_and_water.md.
#pragma once

#include "environment/field_callback.h"
#include "environment/wind_source.h"
#include "kernel/integrator/step.h"

#include <cstdint>
#include <type_traits>

namespace lr {

struct UniformWind {
    float wind[3] = {0.0f, 0.0f, 0.0f};   // m/s, at the end of the next step
    float before[3] = {0.0f, 0.0f, 0.0f}; // m/s, at the end of the last step
    double drift[3] = {0.0, 0.0, 0.0};    // m, displacement of the air since the world began
};

// Times of a step. The field is prepared for slices of its substeps.
struct StepTime {
    double begin; // s, world time at the beginning of the step
    double h;     // s, one substep
    uint32_t substeps;
};

class WindField : public Callback<std::remove_pointer_t<lr_wind_fn>> {
public:
    // Substeps prepared at a time.
    static constexpr uint32_t slice = 8;

    explicit WindField(Allocator& allocator) : allocator_(&allocator) {}
    ~WindField();
    WindField(const WindField&) = delete;
    WindField& operator=(const WindField&) = delete;

    // Whether there is any wind but the uniform one.
    bool active() const { return used_ != 0 || callback(); }
    float fastest() const; // m/s: the uniform wind and the strongest source; callbacks and gusts are unknown

    // The desc must be valid; a source to update or remove must exist, and have the same kind. A failed call changes nothing.
    lr_status add(const SourceDesc& desc, double time, uint64_t seed, lr_wind_source& out);
    lr_status update(lr_wind_source source, const SourceDesc& desc, double time, uint64_t seed);
    void remove(lr_wind_source source);
    const WindSource* find(lr_wind_source source) const;

    // Calls visit(desc, hash, samples) for each source with a grid.
    template <class Visit> void visit_grids(Visit&& visit) const {
        for (const Slot& slot : slots_) {
            if (!slot.source || !slot.source->grid) continue;
            const GridSamples& grid = *slot.source->grid;
            visit(slot.source->desc, grid.hash, grid.values.data());
        }
    }

    // Prepares `count` substeps, up to `slice`, from substep `first` of a step on. over: the uniform wind during it.
    void prepare(const StepTime& time, const UniformWind& over, uint32_t first, uint32_t count, uint64_t seed);
    void prepare_now(double time, uint64_t seed);
    const FieldInstant& instant(uint32_t i) const { return instants_[i]; }

    void end_step(float dt);

    // Hash of everything that affects motion but the uniform wind; 0 without sources.
    uint64_t hash(double time) const;

    UniformWind uniform;

private:
    friend class WindSnapshot;
    static constexpr uint32_t capacity = LR_MAX_WIND_SOURCES;
    // A handle has slot + 1 in the low bits, so it is never 0, and the slot's generation above.
    static constexpr uint32_t slot_bits = 7, last_generation = (1u << (32 - slot_bits)) - 1;
    static_assert(capacity < 1u << slot_bits);
    static uint32_t slot_of(lr_wind_source source) { return (source.id & ((1u << slot_bits) - 1)) - 1; }

    struct Slot {
        WindSource* source;
        uint32_t generation; // of its source, or of the next one
    };
    lr_status make(const SourceDesc& desc, const SourcePhase& phase, uint64_t seed, GridSamples* grid,
                   WindSource*& out);
    lr_status put(Slot& slot, const SourceDesc& desc, const SourcePhase& phase, uint64_t seed, GridSamples* grid);
    // Keeps the memory for later sources.
    void release(WindSource* source);
    void keep_spares(uint32_t most);
    void release(GridSamples* grid);
    GridSamples* find_samples(const SourceDesc& desc, uint64_t hash) const;
    bool reserve(uint32_t instants) { return grow(*allocator_, prepared_, size_t{slice} * instants); }
    uint32_t total_instants() const;
    void uniform_at(const UniformWind& over, double part, double time, double (&wind)[3]) const;
    void fill(FieldInstant& to, SourceInstant* sources, double time, const Carried& carried, uint64_t seed) const;

    Allocator* allocator_;
    Slot slots_[capacity] = {};
    uint32_t used_ = 0;
    void* spare_[capacity] = {}; // memory of released sources, for updates and restores
    uint32_t spares_ = 0;
    Buffer<SourceInstant> prepared_;
    FieldInstant instants_[slice] = {};
};
} // namespace lr
