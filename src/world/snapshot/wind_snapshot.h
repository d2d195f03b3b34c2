// The wind in a snapshot: written, and restored in two steps, so that nothing changes before all of it is valid.
#pragma once

#include "environment/wind_field.h"

namespace lr {

class WindSnapshot {
public:
    // Part of the snapshot's header.
    struct Head {
        float before[3];
        uint32_t sources;
        double drift[3];
        uint32_t generations[LR_MAX_WIND_SOURCES];
    };
    static_assert(sizeof(Head) % 8 == 0);
    static Head head(const WindField& field);
    // Size of the sources after the header.
    static uint64_t bytes(const Head& head) { return sizeof(Source) * uint64_t{head.sources}; }
    static void save(const WindField& field, unsigned char* to);

    // world_seed: of the field's world.
    WindSnapshot(WindField& field, uint64_t world_seed) : field_(&field), world_seed_(world_seed) {}
    ~WindSnapshot();
    WindSnapshot(const WindSnapshot&) = delete;
    WindSnapshot& operator=(const WindSnapshot&) = delete;

    // from: the sources, of at most `size` bytes. time, seed: of the saved world.
    lr_status read(const Head& head, const unsigned char* from, uint64_t size, double time, uint64_t seed);
    // Only after read(). The uniform wind itself is restored elsewhere.
    void commit();

private:
    struct Source {
        uint32_t slot;
        uint32_t reserved;
        double since;
        uint64_t samples; // their hash
        unsigned char desc[source_bytes];
    };
    static_assert(sizeof(Source) % 8 == 0);
    bool is_there(const Source& saved, uint64_t seed) const;

    WindField* field_;
    uint64_t world_seed_;
    WindSource* sources_[WindField::capacity] = {}; // new sources
    bool kept_[WindField::capacity] = {};           // the field's source is equal and stays
    Head head_{};
};
} // namespace lr
