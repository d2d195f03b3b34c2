// Warns of a wrong unit: a leaf of 60 m, modelled in centimetres, falls like a house.
#pragma once

#include "asset/input_faults.h"

#include <optional>

namespace lr::baker {

struct BodySize {
    double length;               // m, of the body
    const char* option;          // that gives a length whatever the unit; null: none
    double side;                 // m, as that option means it
    std::optional<double> given; // m, BakeOptions::size
    double mass, fall_speed;     // kg, m/s
};
// Fault 304 if size, mass or speed are not those of a body that flutters, with the option to give.
void warn_of_size(const BodySize& body, Faults& faults);
} // namespace lr::baker
