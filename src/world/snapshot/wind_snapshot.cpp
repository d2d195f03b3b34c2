#include "world/snapshot/snapshot_format.h"

#include "base/float_mode.h"
#include "kernel/limits.h"
#include "world/snapshot/snapshot_bytes.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace lr {

WindSnapshot::Head WindSnapshot::head(const WindField& field) {
    Head head{};
    std::copy(field.uniform.before, field.uniform.before + 3, head.before);
    std::copy(field.uniform.drift, field.uniform.drift + 3, head.drift);
    head.sources = field.used_;
    for (uint32_t i = 0; i < WindField::capacity; ++i) head.generations[i] = field.slots_[i].generation;
    return head;
}

void WindSnapshot::save(const WindField& field, unsigned char* to) {
    for (uint32_t i = 0; i < WindField::capacity; ++i) {
        const WindSource* const source = field.slots_[i].source;
        if (!source) continue;
        Source saved{i, 0, source->phase, source->hash(), {}};
        std::memcpy(saved.desc, &source->desc, source_bytes);
        std::memcpy(to, &saved, sizeof saved);
        to += sizeof saved;
    }
}

bool WindSnapshot::is_there(const Source& saved, uint64_t seed) const {
    const WindSource* const source = field_->slots_[saved.slot].source;
    return source && seed == world_seed_ && same(source->phase, saved.phase) && source->hash() == saved.samples &&
           std::memcmp(&source->desc, saved.desc, source_bytes) == 0;
}

WindSnapshot::~WindSnapshot() {
    for (WindSource* source : sources_) field_->release(source);
}

lr_status WindSnapshot::read(const Head& head, const unsigned char* from, uint64_t size, double time, uint64_t seed) {
    const FloatMode mode; // gusts are recomputed here
    head_ = head;
    if (head.sources > WindField::capacity || bytes(head) > size || wrong_wind(head.before) ||
        !within(head.drift, most_way))
        return LR_ERROR_SNAPSHOT_FORMAT;
    for (uint32_t generation : head.generations)
        if (generation > WindField::last_generation) return LR_ERROR_SNAPSHOT_FORMAT;
    uint32_t instants = 0;
    for (uint32_t i = 0; i < head.sources; ++i) {
        const auto saved = value_at<Source>(from, i);
        SourceDesc desc{};
        std::memcpy(static_cast<void*>(&desc), saved.desc, source_bytes);
        if (saved.slot >= WindField::capacity || sources_[saved.slot] || kept_[saved.slot] ||
            check_wind_source(desc).refused() || wrong_phase(desc, saved.phase, time))
            return LR_ERROR_SNAPSHOT_FORMAT;
        if (is_there(saved, seed)) {
            kept_[saved.slot] = true;
            instants += field_->slots_[saved.slot].source->instants();
            continue;
        }
        GridSamples* grid = nullptr;
        if (desc.kind == SourceDesc::grid) {
            grid = field_->find_samples(desc, saved.samples);
            if (!grid) return LR_ERROR_SNAPSHOT_MISMATCH;
        }
        const lr_status status = field_->make(desc, saved.phase, seed, grid, sources_[saved.slot]);
        if (status != LR_OK) return status;
        instants += sources_[saved.slot]->instants();
    }
    if (!field_->reserve(instants)) return LR_ERROR_OUT_OF_MEMORY;
    return LR_OK;
}

void WindSnapshot::commit() {
    for (uint32_t i = 0; i < WindField::capacity; ++i) {
        WindField::Slot& slot = field_->slots_[i];
        if (!kept_[i]) {
            if (slot.source) --field_->used_;
            if (sources_[i]) ++field_->used_;
            std::swap(slot.source, sources_[i]); // the old source is released with this object
        }
        slot.generation = head_.generations[i];
    }
    std::copy(head_.before, head_.before + 3, field_->uniform.before);
    std::copy(head_.drift, head_.drift + 3, field_->uniform.drift);
}
} // namespace lr
