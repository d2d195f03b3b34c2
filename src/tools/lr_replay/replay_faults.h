// Reasons why a recording cannot be played. docs/reference/snapshots.md documents the numbers.
#pragma once

#include <stdexcept>
#include <string>

namespace lr::replay {

enum class FaultId {
    not_a_recording = 1,
    newer_format = 2,
    damaged = 3,         // a frame's checksum, size or order is wrong
    malformed = 4,       // the contents of a record contradict its kind
    asset = 5,           // an asset is unreadable, or differs from the recorded one
    world = 6,           // the world cannot be created
    setup = 7,           // the initial state cannot be restored
    unknown_call = 8,    // a call, or a field of a struct, of a newer library
    callback = 9,        // results of a needed callback were not recorded
    other_beginning = 10 // the hash of the initial state differs from the recorded one
};

class Fault : public std::runtime_error {
public:
    Fault(FaultId which, const std::string& what) : std::runtime_error(what), id(which) {}
    FaultId id;
};
} // namespace lr::replay
