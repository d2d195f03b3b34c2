// Work on several threads. Each index has its own result, so results do not depend on the number of threads.
#pragma once

#include <cstddef>
#include <functional>

namespace lr::baker {

// The wanted number or (0) one per processor, at most 64.
unsigned thread_count(unsigned wanted);

// Calls work(index, thread) for each index below `count`, in any order; thread is below `threads`. Rethrows an exception
// of a call after all threads have ended.
void parallel_for(std::size_t count, unsigned threads, const std::function<void(std::size_t, unsigned)>& work);
} // namespace lr::baker
