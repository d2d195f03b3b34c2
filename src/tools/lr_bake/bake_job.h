// One bake: reads a mesh or image file, writes the asset, report and plots.
#pragma once

#include "baker/bake.h"

#include <cstdint>
#include <string>
#include <vector>

namespace lr::baker {

struct BakeJob {
    BakeOptions bake;
    std::string output;  // the asset
    std::string report;  // or empty
    std::string preview; // PNG, or empty; always drawn anew
    std::string plots;   // folder for plot_names, created if its parent exists; or empty
    std::string plot_prefix;
    // Keep outputs that are up to date.
    bool if_changed = false;
    bool drop = false; // for BakeOutcome::fall; a preview needs it too

    std::string input_name() const { return bake.semi_axes ? "ellipsoid" : bake.mesh_path; }
    std::vector<std::string> outputs() const;
};

struct BakeOutcome {
    enum class State { baked, unchanged, failed };
    State state = State::failed;
    AssetData asset; // empty when unchanged
    Faults faults;
    BakeTimings timings;
    std::vector<std::vector<uint8_t>> files; // contents of outputs()
    std::string fall; // sentence of how_it_falls; empty if not asked for, or if the runtime refuses the asset
    double seconds = 0.0;
};

// Bakes without writing. Throws only std::bad_alloc.
BakeOutcome make_outputs(const BakeJob& job, const BakeProgress& progress, const BakeHooks& hooks);

// Writes all files or none; on failure the outcome's state is failed.
void write_outputs(const BakeJob& job, BakeOutcome& outcome);
} // namespace lr::baker
