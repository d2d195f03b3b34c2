// Many bakes in one call: which files they make, and their work on several threads.
#pragma once

#include "tools/lr_bake/bake_job.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace lr::baker {

struct BatchFolders {
    std::string assets, reports, plots; // all but the first may be empty
};

// One job for each input, into FOLDER/STEM.lrb, FOLDER/STEM.json and FOLDER/STEM.turbulence.svg and so on. Two inputs that would make one file: nothing, and
// `clash` says which.
std::optional<std::vector<BakeJob>> plan_batch(const std::vector<std::string>& inputs, const BakeOptions& options,
                                               const BatchFolders& folders, bool if_changed, std::string& clash);

// One path a line, from a file or for "-" from standard input; empty lines are skipped. Faults 101 and 102.
bool read_list(const std::string& path_utf8, std::vector<std::string>& inputs, Faults& faults);

struct BatchLimits {
    unsigned threads = 1;
    uint64_t memory = 0; // bytes for the solvers of all jobs together; one that needs more runs alone
};

struct BatchEvents {
    // In the calling thread, in the order of the jobs, once a job and all before it are done.
    std::function<void(const BakeJob&, const BakeOutcome&)> done;
    // In the calling thread, a few times a second: jobs finished, with parts of those at work.
    std::function<void(double finished)> progress;
};

// Writes each job's files as soon as they are made; a job that fails stops no other. The files do not depend on the
// number of threads. Returns how many failed.
std::size_t run_batch(const std::vector<BakeJob>& jobs, const BatchLimits& limits, const BatchEvents& events);

} // namespace lr::baker
