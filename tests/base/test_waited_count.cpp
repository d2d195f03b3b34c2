#include "base/threads.h"

#include <doctest/doctest.h>

#include <thread>

using namespace lr;

namespace {

void until(const WaitedCount& count, uint32_t wanted) {
    for (uint32_t seen = count.load(std::memory_order_acquire); seen != wanted;
         seen = count.load(std::memory_order_acquire))
        count.wait(seen);
}

} // namespace

// A lost wake-up would end in the time-out.
TEST_CASE("two threads that wait for each other get through") {
    constexpr uint32_t rounds = 20'000;
    WaitedCount asked{0}, answered{0};
    std::thread other([&] {
        for (uint32_t round = 1; round <= rounds; ++round) {
            until(asked, round);
            answered.fetch_add(1, std::memory_order_release);
            answered.notify_one();
        }
    });
    for (uint32_t round = 1; round <= rounds; ++round) {
        asked.fetch_add(1, std::memory_order_release);
        asked.notify_all();
        until(answered, round);
    }
    other.join();
    CHECK(asked.load(std::memory_order_relaxed) == rounds);
    CHECK(answered.load(std::memory_order_relaxed) == rounds);
}

TEST_CASE("a count that has changed already is not waited for") {
    WaitedCount count{0};
    count.fetch_add(3, std::memory_order_release);
    count.wait(0);
    count.wait(2);
    CHECK(count.fetch_sub(3, std::memory_order_acq_rel) == 3);
}
