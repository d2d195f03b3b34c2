#include "world/worker_pool.h"

#include <doctest/doctest.h>

#include <atomic>
#include <vector>

using namespace lr;

namespace {

struct Counts {
    std::vector<std::atomic<uint32_t>> runs;
    explicit Counts(uint32_t n) : runs(n) {}
    static void run(void* context, uint32_t chunk) { static_cast<Counts*>(context)->runs[chunk].fetch_add(1); }
};

} // namespace

TEST_CASE("every chunk runs once, for any number of workers, and all are done on return") {
    for (uint32_t workers : {0u, 1u, 2u, 7u, 64u}) {
        WorkerPool pool;
        REQUIRE(pool.start(workers));
        CHECK(pool.workers() == workers);
        for (uint32_t chunks : {0u, 1u, 2u, 3u, 100u, 1000u}) {
            for (int round = 0; round < 20; ++round) {
                Counts counts(chunks);
                pool.run(chunks, &Counts::run, &counts);
                uint32_t wrong = 0;
                for (const auto& c : counts.runs) wrong += c.load() != 1;
                REQUIRE(wrong == 0);
            }
        }
        pool.stop();
        pool.stop(); // harmless
        CHECK(pool.workers() == 0);
    }
}

TEST_CASE("a pool that never ran ends at once") {
    for (int round = 0; round < 50; ++round) {
        WorkerPool pool;
        REQUIRE(pool.start(4));
    }
}
