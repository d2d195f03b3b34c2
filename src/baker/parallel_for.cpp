#include "baker/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace lr::baker {

unsigned thread_count(unsigned wanted) {
    constexpr unsigned most = 64;
    return std::clamp(wanted > 0 ? wanted : std::thread::hardware_concurrency(), 1U, most);
}

void parallel_for(std::size_t count, unsigned threads, const std::function<void(std::size_t, unsigned)>& work) {
    std::atomic<std::size_t> next{0};
    std::mutex mutex;
    std::exception_ptr failure;
    const auto run = [&](unsigned thread) {
        try {
            for (std::size_t i = next++; i < count; i = next++) work(i, thread);
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!failure) failure = std::current_exception();
            next = count;
        }
    };
    std::vector<std::thread> others;
    const auto helpers = static_cast<unsigned>(std::min<std::size_t>(threads, count));
    others.reserve(helpers);
    for (unsigned thread = 1; thread < helpers; ++thread) {
        try {
            others.emplace_back(run, thread);
        } catch (const std::exception&) {
            break; // no more threads are allowed; the running ones do all the work
        }
    }
    run(0);
    for (std::thread& thread : others) thread.join();
    if (failure) std::rethrow_exception(failure);
}
} // namespace lr::baker
