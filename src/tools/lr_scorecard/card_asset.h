// The falling card as a body of the library: a strip of an infinitely long card.
#pragma once

#include "tools/lr_scorecard/falling_card.h"
#include "tools/lr_scorecard/runtime_handles.h"

namespace lr::scorecard {

struct CardBody {
    Asset asset;
    double gravity; // m/s^2, which gives the model's units below
    double length;  // m, the semi-chord
    double speed;   // m/s
};

// Chord along body x, normal along y, span along z.
CardBody make_card(const CardModel& model);
} // namespace lr::scorecard
