// One bake from files to files.
#pragma once

#include "baker/bake.h"

#include <cstdint>
#include <string>
#include <vector>

namespace lr::baker {

struct BakeJob {
    BakeOptions bake;
    std::string output; // the asset
    std::string report; // or empty
    std::string plots;  // a folder for plot_names, made if only its last part is missing; or empty
    std::string plot_prefix;
    // Leave the outputs alone if they are what this bake would make.
    bool if_changed = false;

    std::string input_name() const { return bake.semi_axes ? "ellipsoid" : bake.mesh_path; }
    std::vector<std::string> outputs() const;
};

struct BakeOutcome {
    enum class State { baked, unchanged, failed };
    State state = State::failed;
    AssetData asset; // empty when unchanged
    Faults faults;
    BakeTimings timings;
    std::vector<std::vector<uint8_t>> files; // the bytes of each of outputs()
    double seconds = 0.0;
};

// Everything but the writing. Throws nothing but std::bad_alloc.
BakeOutcome make_outputs(const BakeJob& job, const BakeProgress& progress, const BakeHooks& hooks);

// All files or none; the outcome has failed if not.
void write_outputs(const BakeJob& job, BakeOutcome& outcome);

} // namespace lr::baker
