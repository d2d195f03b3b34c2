// The wind in a snapshot: written, and read back in two steps, so that nothing changes before all of it is good.
#pragma once

#include "field/wind_field.h"

namespace lr {

class WindSnapshot {
public:
    static uint64_t bytes(const WindField& field);
    // Writes bytes(field) of them.
    static void save(const WindField& field, unsigned char* to);

    // Of bytes that begin with a saved wind: how many of them are its; 0 when they are not even that many.
    static uint64_t bytes(const unsigned char* from, uint64_t size);

    // world_seed: of the world that the field is in.
    WindSnapshot(WindField& field, uint64_t world_seed) : field_(&field), world_seed_(world_seed) {}
    ~WindSnapshot();
    WindSnapshot(const WindSnapshot&) = delete;
    WindSnapshot& operator=(const WindSnapshot&) = delete;

    // used: receives how many of the `size` bytes are the wind's. time, seed: of the saved world.
    lr_status read(const unsigned char* from, uint64_t size, double time, uint64_t seed, uint64_t& used);
    // After read() alone. The uniform wind's own velocity is not part of this.
    void commit();

private:
    bool is_there(const lr_wind_source_desc& desc, uint32_t slot, double since, uint64_t samples, uint64_t seed) const;

    WindField* field_;
    uint64_t world_seed_;
    WindSource* sources_[WindField::capacity] = {}; // made anew
    bool kept_[WindField::capacity] = {};           // the field's own is the same
    uint32_t generations_[WindField::capacity] = {};
    float before_[3] = {};
    double drift_[3] = {};
};

} // namespace lr
