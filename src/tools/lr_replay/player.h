// Plays a recording in a new world and compares statuses, outputs and hashes.
#pragma once

#include "tools/lr_replay/callback_answers.h"
#include "tools/lr_replay/read_arguments.h"
#include "tools/lr_replay/recording_reader.h"

#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <unordered_map>
#include <vector>

namespace lr::replay {

struct Options {
    int32_t simd = LR_SIMD_AUTO;
    uint32_t workers = 0;
    uint64_t until = UINT64_MAX;   // steps of the recording
    std::ostream* print = nullptr; // receives calls as text
    std::ostream* csv = nullptr;   // receives the pose of `body` after each step
    lr_body body{};
    uint64_t most_memory = uint64_t{8} << 30; // bytes of the world
};

struct Difference {
    uint64_t call = 0, step = 0; // counted from 1; step: completed steps
    std::string what;
};

struct Outcome {
    uint64_t calls = 0, steps = 0, hashes = 0; // compared
    uint64_t unread = 0;                       // refused calls, recorded without arguments; not replayed
    uint64_t first_step = 0;                   // the world's step count when the recording began
    uint32_t library = 0;
    bool cut = false;                     // the recording ends within a record
    std::string within;                   // the call during which it ends
    uint64_t hash = 0;                    // of the world at the end
    bool body = false;                    // whether Options::body ever existed
    std::optional<Difference> difference; // where playing stopped
};

// Throws Fault.
Outcome play(const unsigned char* bytes, size_t size, const Options& options);

// The state that replayed calls use.
struct Scene {
    lr_world* world = nullptr;
    std::vector<lr_asset*> assets;
    std::vector<uint64_t> made; // ids of the bodies or colliders that the last call made
    Answers wind{recording::wind_key_rows, recording::wind_values};
    Answers surface{recording::surface_key_rows, recording::surface_values};
};
// The name of the function; null if unknown.
const char* name_of(recording::Op op);
// Decodes and executes one call. output: as in ResultRecord.
lr_status perform(recording::Op op, Arguments& arguments, Scene& scene, uint64_t& output);
} // namespace lr::replay
