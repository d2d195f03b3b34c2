// Many bakes in one call: plans their output files and runs them on several threads.
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
    std::string assets, reports, plots, previews; // all but the first can be empty
};

// One job for each input, into FOLDER/STEM.lrb, FOLDER/STEM.json, FOLDER/STEM.turbulence.svg and so on. Nothing if two inputs have the same output;
// `clash` then names them.
std::optional<std::vector<BakeJob>> plan_batch(const std::vector<std::string>& inputs, const BakeOptions& options,
                                               const BatchFolders& folders, bool if_changed, std::string& clash);

// One job for each region of each job's image, by size: OUT_1.lrb, OUT_2.lrb, with reports, plots and names numbered likewise. The job of an
// unreadable image stays as it is, and fails later.
std::vector<BakeJob> plan_islands(const std::vector<BakeJob>& jobs);

// One path per line, from a file, or from standard input for "-"; skips empty lines. Faults 101 and 102.
bool read_list(const std::string& path_utf8, std::vector<std::string>& inputs, Faults& faults);

struct BatchLimits {
    unsigned threads = 1;
    uint64_t memory = 0; // bytes for the solvers of all jobs; a job that needs more runs alone
};

struct BatchEvents {
    // On the calling thread, in the order of the jobs, once a job and all before it are done.
    std::function<void(const BakeJob&, const BakeOutcome&)> done;
    // On the calling thread, a few times a second: the number of finished jobs, plus the fractions of running ones.
    std::function<void(double finished)> progress;
};

// Writes each job's files as soon as they are made. A failed job does not stop the others. The files do not depend on
// the number of threads. Returns the number of failed jobs.
std::size_t run_batch(const std::vector<BakeJob>& jobs, const BatchLimits& limits, const BatchEvents& events);
} // namespace lr::baker
