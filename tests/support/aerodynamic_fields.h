// All coefficients of the quasi-steady loads in the public struct with their limits, for tests that visit each.
#pragma once

#include "../../src/asset/asset_data.h"
#include "langevin_rigid_research.h"

#include <cstddef>

namespace test {

struct AerodynamicField {
    const char* name;
    size_t offset, size;
    double least, most, power; // limits as the API has them; power: of the length

    double* in(lr_aerodynamics& a) const {
        return reinterpret_cast<double*>(reinterpret_cast<unsigned char*>(&a) + offset);
    }
    const double* in(const lr_aerodynamics& a) const {
        return reinterpret_cast<const double*>(reinterpret_cast<const unsigned char*>(&a) + offset);
    }
};

// A limit that depends on the length allows for its fifth power: bodies are at most 1000 m large.
#define LR_FIELD(name, least, most, power)                                                                             \
    {#name,                                                                                                            \
     offsetof(lr_aerodynamics, name),                                                                                  \
     sizeof lr_aerodynamics::name / sizeof(double),                                                                    \
     (power) == 0.0 ? (least) : 1e10 * (least),                                                                        \
     (power) == 0.0 ? (most) : 1e10 * (most),                                                                          \
     power},
inline constexpr AerodynamicField aerodynamic_fields[] = {LR_AERODYNAMIC_VECTORS(LR_FIELD)
                                                              LR_AERODYNAMIC_NUMBERS(LR_FIELD)};
#undef LR_FIELD

} // namespace test
