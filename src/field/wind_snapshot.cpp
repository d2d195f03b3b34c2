#include "field/wind_snapshot.h"

#include "kernel/float_mode.h"
#include "kernel/limits.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

namespace lr {
namespace {

struct SavedWind {
    float before[3];
    uint32_t sources;
    double drift[3];
    uint32_t generations[LR_MAX_WIND_SOURCES];
};
struct SavedSource {
    uint32_t slot;
    uint32_t reserved;
    double since;
    uint64_t samples; // their hash
    unsigned char desc[source_bytes];
};
static_assert(sizeof(SavedWind) % 8 == 0 && sizeof(SavedSource) % 8 == 0);

} // namespace

uint64_t WindSnapshot::bytes(const WindField& field) {
    return sizeof(SavedWind) + field.used_ * sizeof(SavedSource);
}

void WindSnapshot::save(const WindField& field, unsigned char* to) {
    SavedWind wind{};
    std::copy(field.uniform.before, field.uniform.before + 3, wind.before);
    std::copy(field.uniform.drift, field.uniform.drift + 3, wind.drift);
    wind.sources = field.used_;
    for (uint32_t i = 0; i < WindField::capacity; ++i) wind.generations[i] = field.slots_[i].generation;
    std::memcpy(to, &wind, sizeof wind);
    to += sizeof wind;
    for (uint32_t i = 0; i < WindField::capacity; ++i) {
        const WindSource* const source = field.slots_[i].source;
        if (!source) continue;
        SavedSource saved{};
        saved.slot = i;
        saved.since = source->since;
        saved.samples = source->grid ? source->grid->hash : 0;
        std::memcpy(saved.desc, &source->desc, source_bytes);
        // Where addresses have 32 bits the struct is smaller. Snapshots are the same everywhere.
        const uint32_t struct_size = source_bytes + sizeof(uint64_t);
        std::memcpy(saved.desc, &struct_size, sizeof struct_size);
        std::memcpy(to, &saved, sizeof saved);
        to += sizeof saved;
    }
}

uint64_t WindSnapshot::bytes(const unsigned char* from, uint64_t size) {
    SavedWind wind;
    if (size < sizeof wind) return 0;
    std::memcpy(&wind, from, sizeof wind);
    const uint64_t used = sizeof wind + wind.sources * uint64_t{sizeof(SavedSource)};
    return wind.sources <= WindField::capacity && used <= size ? used : 0;
}

bool WindSnapshot::is_there(const lr_wind_source_desc& desc, uint32_t slot, double since, uint64_t samples,
                            uint64_t seed) const {
    const WindSource* const source = field_->slots_[slot].source;
    constexpr size_t head = sizeof desc.struct_size;
    return source && seed == world_seed_ && std::bit_cast<uint64_t>(source->since) == std::bit_cast<uint64_t>(since) &&
           samples == (source->grid ? source->grid->hash : 0) &&
           std::memcmp(reinterpret_cast<const unsigned char*>(&source->desc) + head,
                       reinterpret_cast<const unsigned char*>(&desc) + head, source_bytes - head) == 0;
}

WindSnapshot::~WindSnapshot() {
    for (WindSource* source : sources_) field_->release(source);
}

lr_status WindSnapshot::read(const unsigned char* from, uint64_t size, double time, uint64_t seed, uint64_t& used) {
    const FloatMode mode; // gusts are computed anew
    SavedWind wind;
    used = bytes(from, size);
    if (used == 0) return LR_ERROR_SNAPSHOT_FORMAT;
    std::memcpy(&wind, from, sizeof wind);
    if (wrong_wind(wind.before) || !within(wind.drift, most_way)) return LR_ERROR_SNAPSHOT_FORMAT;
    for (uint32_t generation : wind.generations)
        if (generation > WindField::last_generation) return LR_ERROR_SNAPSHOT_FORMAT;
    uint32_t instants = 0;
    for (uint32_t i = 0; i < wind.sources; ++i) {
        SavedSource saved;
        std::memcpy(&saved, from + sizeof wind + i * sizeof saved, sizeof saved);
        lr_wind_source_desc desc{};
        std::memcpy(static_cast<void*>(&desc), saved.desc, source_bytes);
        const char* why = nullptr;
        if (saved.slot >= WindField::capacity || sources_[saved.slot] || kept_[saved.slot] ||
            !in_range(saved.since, 0.0, time) || check_wind_source(desc, why) != LR_OK)
            return LR_ERROR_SNAPSHOT_FORMAT;
        if (is_there(desc, saved.slot, saved.since, saved.samples, seed)) {
            kept_[saved.slot] = true;
            instants += field_->slots_[saved.slot].source->instants();
            continue;
        }
        GridSamples* grid = nullptr;
        if (desc.kind == LR_WIND_SOURCE_GRID) {
            grid = field_->find_samples(desc, saved.samples);
            if (!grid) return LR_ERROR_SNAPSHOT_MISMATCH;
        }
        const lr_status status = field_->make(desc, saved.since, seed, grid, sources_[saved.slot]);
        if (status != LR_OK) return status;
        instants += sources_[saved.slot]->instants();
    }
    if (!field_->reserve(instants)) return LR_ERROR_OUT_OF_MEMORY;
    std::copy(wind.before, wind.before + 3, before_);
    std::copy(wind.drift, wind.drift + 3, drift_);
    std::copy(wind.generations, wind.generations + WindField::capacity, generations_);
    return LR_OK;
}

void WindSnapshot::commit() {
    for (uint32_t i = 0; i < WindField::capacity; ++i) {
        WindField::Slot& slot = field_->slots_[i];
        if (!kept_[i]) {
            if (slot.source) --field_->used_;
            if (sources_[i]) ++field_->used_;
            std::swap(slot.source, sources_[i]); // what was there goes with this object
        }
        slot.generation = generations_[i];
    }
    std::copy(before_, before_ + 3, field_->uniform.before);
    std::copy(drift_, drift_ + 3, field_->uniform.drift);
}

} // namespace lr
