#include "base/step_workers.h"

#include <doctest/doctest.h>

#include <atomic>
#include <vector>

using namespace lr;

namespace {

struct Counts {
    std::vector<std::atomic<uint32_t>> runs;
    explicit Counts(uint32_t n) : runs(n) {}
    static void run(void* context, uint32_t chunk) { static_cast<Counts*>(context)->runs[chunk].fetch_add(1); }
    uint32_t wrong() const {
        uint32_t n = 0;
        for (const auto& c : runs) n += c.load() != 1;
        return n;
    }
};

} // namespace

TEST_CASE("every chunk runs once, for any number of workers and helpers, and all are done on return") {
    for (uint32_t workers : {0u, 1u, 2u, 7u, 64u}) {
        ChunkQueue queue;
        WorkerPool pool(queue);
        REQUIRE(pool.start(workers));
        CHECK(pool.workers() == workers);
        for (uint32_t chunks : {0u, 1u, 2u, 3u, 100u, 1000u}) {
            for (uint32_t round = 0; round < 20; ++round) {
                Counts counts(chunks);
                queue.open(chunks, workers + 1, &Counts::run, &counts);
                pool.wake(round % 5 == 4 ? workers : round % 5);
                queue.take(0);
                queue.wait();
                REQUIRE(counts.wrong() == 0);
            }
        }
        pool.stop();
        pool.stop(); // harmless
        CHECK(pool.workers() == 0);
    }
}

// A round's context is destroyed before the next round: ThreadSanitizer and AddressSanitizer check this.
TEST_CASE("rounds in quick succession do not mix") {
    ChunkQueue queue;
    WorkerPool pool(queue);
    REQUIRE(pool.start(3));
    for (uint32_t round = 0; round < 3000; ++round) {
        Counts counts(1 + round % 7);
        queue.open(1 + round % 7, 4, &Counts::run, &counts);
        pool.wake(3);
        queue.take(0);
        queue.wait();
        REQUIRE(counts.wrong() == 0);
    }
}

TEST_CASE("workers alone do all of it") {
    ChunkQueue queue;
    WorkerPool pool(queue);
    REQUIRE(pool.start(2));
    for (uint32_t round = 0; round < 50; ++round) {
        Counts counts(40);
        queue.open(40, 3, &Counts::run, &counts);
        pool.wake(1 + round % 2);
        queue.wait();
        REQUIRE(counts.wrong() == 0);
    }
}

TEST_CASE("a thread that comes too late, or for nothing, finds nothing to do") {
    ChunkQueue queue;
    queue.take(0);
    queue.wait();
    Counts counts(5);
    queue.open(5, 1, &Counts::run, &counts);
    queue.take(0);
    queue.take(0);
    queue.wait();
    CHECK(counts.wrong() == 0);
}

TEST_CASE("a pool that never ran ends at once") {
    for (int round = 0; round < 50; ++round) {
        ChunkQueue queue;
        WorkerPool pool(queue);
        REQUIRE(pool.start(4));
    }
}
