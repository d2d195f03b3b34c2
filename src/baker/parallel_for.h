// Work on several threads. Each index has its own result, so that no result depends on the number of threads.
#pragma once

#include <cstddef>
#include <functional>

namespace lr::baker {

// 0: as many as the machine runs at once.
unsigned thread_count(unsigned wanted);

// Calls work(index, thread) for each index below `count`, in no order; thread is below `threads`. An exception from any
// call is thrown again here once all threads have ended.
void parallel_for(std::size_t count, unsigned threads, const std::function<void(std::size_t, unsigned)>& work);

} // namespace lr::baker
