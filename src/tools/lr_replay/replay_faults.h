// Why a recording cannot be played: numbers are documented in docs/reference/snapshots.md.
#pragma once

#include <stdexcept>
#include <string>

namespace lr::replay {

enum class FaultId {
    not_a_recording = 1,
    newer_format = 2,
    damaged = 3,         // a frame whose checksum, size or order is wrong, with others behind it
    malformed = 4,       // a record that does not say what its kind says
    asset = 5,           // an asset that is none, or another than was recorded
    world = 6,           // the world cannot be made
    setup = 7,           // what there was when the recording began cannot be made again
    unknown_call = 8,    // of a newer library
    callback = 9,        // a callback is asked whose answers were not recorded
    other_beginning = 10 // the world that the recording begins with is not the one that was recorded
};

class Fault : public std::runtime_error {
public:
    Fault(FaultId which, const std::string& what) : std::runtime_error(what), id(which) {}
    FaultId id;
};

} // namespace lr::replay
