// Independent jobs on several threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

namespace lr::scorecard {

// Runs the jobs 0 to count - 1 and reports progress, 0 to 1, one call at a time; `progress` can be empty. Rethrows a job's exception.
void parallel(uint32_t threads, size_t count, const std::function<void(size_t)>& job,
              const std::function<void(double)>& progress = {});
} // namespace lr::scorecard
