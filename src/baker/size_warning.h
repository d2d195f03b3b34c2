// A body of 60 m that was modelled in centimetres falls like a house, not like a leaf.
#pragma once

#include "asset/input_faults.h"

#include <optional>

namespace lr::baker {

struct BodySize {
    double length;               // m, of the body
    double side;                 // m, the longest of the file's bounding box
    std::optional<double> given; // m, BakeOptions::size
    double mass, fall_speed;     // kg, m/s
};
// Fault 304 if the size, the mass or the speed is not that of a body that flutters. It says which --size to type.
void warn_of_size(const BodySize& body, Faults& faults);
} // namespace lr::baker
