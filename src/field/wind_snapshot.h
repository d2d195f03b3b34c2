// The wind in a snapshot: written, and read back in two steps, so that nothing changes before all of it is good.
#pragma once

#include "field/wind_field.h"

namespace lr {

class WindSnapshot {
public:
    static uint64_t bytes(const WindField& field);
    // Writes bytes(field) of them.
    static void save(const WindField& field, unsigned char* to);

    explicit WindSnapshot(WindField& field) : field_(&field) {}
    ~WindSnapshot();
    WindSnapshot(const WindSnapshot&) = delete;
    WindSnapshot& operator=(const WindSnapshot&) = delete;

    // used: receives how many of the `size` bytes are the wind's. seed: of the saved world.
    lr_status read(const unsigned char* from, uint64_t size, uint64_t seed, uint64_t& used);
    // After read() alone. The uniform wind's own velocity is not part of this.
    void commit();

private:
    WindField* field_;
    WindSource* sources_[WindField::capacity] = {};
    uint32_t generations_[WindField::capacity] = {};
    float before_[3] = {};
    double drift_[3] = {};
};

} // namespace lr
