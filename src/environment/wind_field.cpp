#include "environment/wind_field.h"

#include "base/bit_cast.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>

namespace lr {

const WindSource* WindField::find(lr_wind_source source) const {
    const uint32_t slot = slot_of(source);
    return slot < capacity && slots_[slot].generation == source.id >> slot_bits ? slots_[slot].source : nullptr;
}

lr_status WindField::make(const SourceDesc& desc, const SourcePhase& phase, uint64_t seed, GridSamples* grid,
                          WindSource*& out) {
    if (desc.kind == SourceDesc::grid && !grid) {
        grid = allocator_->make<GridSamples>();
        if (!grid || !grid->values.allocate(*allocator_, sample_count(desc) + 1)) {
            release(grid);
            return LR_ERROR_OUT_OF_MEMORY;
        }
        take_samples(desc, *grid);
    }
    if (grid) ++grid->references;
    void* const memory = spares_ != 0 ? spare_[--spares_] : allocator_->allocate(sizeof(WindSource));
    if (!memory) {
        release(grid);
        return LR_ERROR_OUT_OF_MEMORY;
    }
    WindSource* const source = new (memory) WindSource{};
    source->desc = desc;
    source->desc.samples = nullptr;
    source->phase = phase;
    source->grid = grid;
    if (desc.kind == SourceDesc::gusts) source->gusts = Gusts(desc, seed);
    out = source;
    return LR_OK;
}

void WindField::release(GridSamples* grid) {
    if (!grid || (grid->references != 0 && --grid->references != 0)) return;
    allocator_->end(grid);
}

void WindField::release(WindSource* source) {
    if (!source) return;
    release(source->grid);
    source->~WindSource();
    if (spares_ < capacity)
        spare_[spares_++] = source;
    else
        allocator_->release(source, sizeof(WindSource));
}

WindField::~WindField() {
    for (const Slot& slot : slots_) release(slot.source);
    keep_spares(0);
}

void WindField::keep_spares(uint32_t most) {
    while (spares_ > most) allocator_->release(spare_[--spares_], sizeof(WindSource));
}

GridSamples* WindField::find_samples(const SourceDesc& desc, uint64_t hash) const {
    for (const Slot& slot : slots_)
        if (slot.source && slot.source->grid && slot.source->grid->hash == hash &&
            slot.source->grid->values.size() == sample_count(desc) + 1)
            return slot.source->grid;
    return nullptr;
}

uint32_t WindField::total_instants() const {
    uint32_t total = 0;
    for (const Slot& slot : slots_)
        if (slot.source) total += slot.source->instants();
    return total;
}

lr_status WindField::put(Slot& slot, const SourceDesc& desc, const SourcePhase& phase, uint64_t seed,
                         GridSamples* grid) {
    WindSource* source = nullptr;
    const lr_status status = make(desc, phase, seed, grid, source);
    if (status != LR_OK) return status;
    if (!reserve(total_instants() - (slot.source ? slot.source->instants() : 0) + source->instants())) {
        release(source);
        return LR_ERROR_OUT_OF_MEMORY;
    }
    release(slot.source);
    slot.source = source;
    return LR_OK;
}

lr_status WindField::add(const SourceDesc& desc, double time, uint64_t seed, lr_wind_source& out) {
    Slot* const slot = std::find_if(slots_, slots_ + capacity, [](const Slot& s) { return !s.source; });
    if (slot == slots_ + capacity) return LR_ERROR_CAPACITY;
    const lr_status status = put(*slot, desc, {time, {}}, seed, nullptr);
    if (status != LR_OK) return status;
    ++used_;
    out = {static_cast<uint32_t>(slot - slots_ + 1) | slot->generation << slot_bits};
    return LR_OK;
}

lr_status WindField::update(lr_wind_source handle, const SourceDesc& desc, double time, uint64_t seed) {
    Slot& slot = slots_[slot_of(handle)];
    const SourceDesc& old = slot.source->desc;
    const bool keep = desc.kind == SourceDesc::grid && !desc.samples;
    if (keep && (!std::equal(desc.counts, desc.counts + 3, old.counts) || desc.frames != old.frames))
        return LR_ERROR_NULL_ARGUMENT;
    return put(slot, desc, slot.source->phase_for(desc, time), seed, keep ? slot.source->grid : nullptr);
}

void WindField::remove(lr_wind_source handle) {
    Slot& slot = slots_[slot_of(handle)];
    release(slot.source);
    slot.source = nullptr;
    slot.generation = (slot.generation + 1) & last_generation;
    --used_;
    keep_spares(used_);
}

float WindField::fastest() const {
    float most = 0.0f;
    for (const Slot& slot : slots_)
        if (slot.source) most = std::max(most, slot.source->fastest());
    return most + length(vector_of(uniform.wind));
}

// part: fraction of the step, 0 to 1.
void WindField::uniform_at(const UniformWind& over, double part, double time, double (&wind)[3]) const {
    for (size_t k = 0; k < 3; ++k) {
        const auto from = wide(over.before[k]), to = wide(over.wind[k]);
        wind[k] = from + part * (to - from);
    }
    for (const Slot& slot : slots_)
        if (slot.source && slot.source->desc.kind == SourceDesc::gusts)
            slot.source->gusts.add(time - slot.source->phase.since, wind);
}

// All but the uniform wind and the gusts.
void WindField::fill(FieldInstant& to, SourceInstant* sources, double time, const Carried& carried,
                     uint64_t seed) const {
    to.sources = sources;
    to.source_count = 0;
    to.reference = 0.0f;
    bool ground = false;
    for (const Slot& slot : slots_) {
        if (!slot.source) continue;
        const uint32_t instants = slot.source->instants();
        if (instants == 0) continue; // gusts are part of the uniform wind
        slot.source->at(time, seed, carried, sources + to.source_count);
        to.source_count += instants;
        to.reference += slot.source->fastest();
        ground = ground || slot.source->desc.kind == SourceDesc::ground;
    }
    // The wind profile over ground gives the uniform wind a gradient too.
    if (ground)
        for (float w : to.wind) to.reference += std::abs(w);
}

void WindField::prepare(const StepTime& t, const UniformWind& over, uint32_t first, uint32_t count, uint64_t seed) {
    const uint32_t each = total_instants();
    double begin[3], end[3];
    uniform_at(over, first / static_cast<double>(t.substeps), t.begin + first * t.h, begin);
    for (uint32_t i = 0; i < count; ++i, std::copy(end, end + 3, begin)) {
        const double after = first + i + 1.0, middle = first + i + 0.5;
        uniform_at(over, after / t.substeps, t.begin + after * t.h, end);
        FieldInstant& to = instants_[i];
        Carried carried{};
        const double part = middle / t.substeps, seconds = middle * t.h;
        for (size_t k = 0; k < 3; ++k) {
            // + 0.0f removes negative zeros, so that a source without wind changes no bit.
            to.wind[k] = static_cast<float>(0.5 * (begin[k] + end[k])) + 0.0f;
            to.change[k] = static_cast<float>(end[k] - begin[k]) + 0.0f;
            const auto before = wide(over.before[k]), last = wide(over.wind[k]);
            carried.velocity[k] = before + part * (last - before);
            carried.way[k] = over.drift[k] + seconds * 0.5 * (before + carried.velocity[k]);
        }
        fill(to, prepared_.data() + size_t{i} * each, t.begin + seconds, carried, seed);
    }
}

void WindField::prepare_now(double time, uint64_t seed) {
    double wind[3];
    uniform_at(uniform, 1.0, time, wind);
    Carried carried{};
    for (size_t k = 0; k < 3; ++k) {
        instants_[0].wind[k] = static_cast<float>(wind[k]) + 0.0f;
        instants_[0].change[k] = 0.0f;
        carried.way[k] = uniform.drift[k];
        carried.velocity[k] = wide(uniform.wind[k]);
    }
    fill(instants_[0], prepared_.data(), time, carried, seed);
}

void WindField::end_step(float dt) {
    for (size_t k = 0; k < 3; ++k) {
        uniform.drift[k] += 0.5 * wide(dt) * (wide(uniform.before[k]) + wide(uniform.wind[k]));
        uniform.before[k] = uniform.wind[k];
    }
}

uint64_t WindField::hash(double time) const {
    if (used_ == 0) return 0;
    uint64_t hash = random_bits(bit_cast<uint64_t>(time), 0);
    const auto take = [&](uint64_t word) { hash = random_bits(hash ^ word, 1); };
    for (size_t k = 0; k < 3; ++k) {
        take(bit_cast<uint32_t>(uniform.wind[k]) | uint64_t{bit_cast<uint32_t>(uniform.before[k])} << 32);
        take(bit_cast<uint64_t>(uniform.drift[k]));
    }
    for (const Slot& slot : slots_) {
        take(slot.source != nullptr);
        if (!slot.source) continue;
        uint32_t words[source_bytes / 4];
        std::memcpy(words, &slot.source->desc, source_bytes);
        for (size_t i = 1; i < source_bytes / 4; ++i) take(words[i]); // all but struct_size
        take(bit_cast<uint64_t>(slot.source->phase.since));
        const auto& shift = slot.source->phase.shift;
        if (shift[0] != 0.0 || shift[1] != 0.0 || shift[2] != 0.0)
            for (double part : shift) take(bit_cast<uint64_t>(part));
        if (slot.source->grid) take(slot.source->grid->hash);
    }
    return hash;
}
} // namespace lr
