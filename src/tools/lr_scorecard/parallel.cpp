#include "tools/lr_scorecard/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace lr::scorecard {

void parallel(uint32_t threads, size_t count, const std::function<void(size_t)>& job,
              const std::function<void(double)>& progress) {
    std::atomic<size_t> next{0}, done{0};
    std::mutex mutex; // protects `progress` and `failure`
    std::exception_ptr failure;
    const auto work = [&] {
        for (size_t i = next++; i < count; i = next++) {
            try {
                job(i);
            } catch (...) {
                const std::lock_guard lock(mutex);
                if (!failure) failure = std::current_exception();
                next = count;
                return;
            }
            const std::lock_guard lock(mutex);
            ++done;
            if (progress) progress(static_cast<double>(done) / static_cast<double>(count));
        }
    };
    {
        std::vector<std::jthread> others;
        for (uint32_t i = 1; i < std::min<size_t>(threads, count); ++i) others.emplace_back(work);
        work();
    }
    if (failure) std::rethrow_exception(failure);
}
} // namespace lr::scorecard
