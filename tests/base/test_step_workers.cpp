// Many runs between gather and dismiss: helpers of a job system stay; systems that cannot keep them still do all the work.
#include "base/step_workers.h"

#include <doctest/doctest.h>

#include <atomic>
#include <thread>
#include <vector>

using namespace lr;

namespace {

constexpr uint32_t helpers = 3, runs = 400;

class Jobs {
public:
    enum Kind {
        side_by_side, // a thread for each index
        blocking,     // a parallel-for that returns at its end: within enqueue
        at_once,      // on the caller's thread, within enqueue
        in_finish     // on the caller's thread, in finish
    };
    explicit Jobs(Kind kind) : kind_(kind) {}
    lr_job_system callbacks() { return {this, &enqueue, &finish}; }
    uint32_t enqueued = 0, finished = 0;

private:
    static void* enqueue(void* user, lr_task_fn run, void* task, uint32_t count) {
        Jobs& self = *static_cast<Jobs*>(user);
        ++self.enqueued;
        if (self.kind_ == at_once) {
            run(task, 0, count);
            return nullptr;
        }
        self.run_ = run, self.task_ = task, self.count_ = count;
        if (self.kind_ == side_by_side || self.kind_ == blocking)
            for (uint32_t i = 0; i < count; ++i) self.threads_.emplace_back(run, task, i, i + 1);
        if (self.kind_ == blocking) self.join();
        return user;
    }
    static void finish(void* user, void*) {
        Jobs& self = *static_cast<Jobs*>(user);
        ++self.finished;
        if (self.kind_ == in_finish) self.run_(self.task_, 0, self.count_);
        self.join();
    }
    void join() {
        for (std::thread& thread : threads_) thread.join();
        threads_.clear();
    }

    Kind kind_;
    lr_task_fn run_ = nullptr;
    void* task_ = nullptr;
    uint32_t count_ = 0;
    std::vector<std::thread> threads_;
};

// Each run adds to the result of the run before: a missed, repeated or early chunk would change the sum.
struct Sums {
    static constexpr uint32_t chunks = 37;
    std::vector<uint32_t> of = std::vector<uint32_t>(chunks, 0);
    uint32_t run = 0;
    std::atomic<uint32_t> wrong{0};
    static void add(void* context, uint32_t chunk) {
        Sums& sums = *static_cast<Sums*>(context);
        if (sums.of[chunk]++ != sums.run) ++sums.wrong;
    }
};

void play(StepWorkers& step_workers, Sums& sums, const FloatMode& mode) {
    for (sums.run = 0; sums.run < runs; ++sums.run) {
        step_workers.run(Sums::chunks, step_workers.helpers(), &Sums::add, &sums, mode);
        CHECK(sums.of == std::vector<uint32_t>(Sums::chunks, sums.run + 1));
    }
}

} // namespace

TEST_CASE("a gathered step_workers does every run whole, whatever becomes of its helpers") {
    const FloatMode mode;
    for (int kind = Jobs::side_by_side; kind <= Jobs::in_finish; ++kind) {
        CAPTURE(kind);
        Jobs jobs(static_cast<Jobs::Kind>(kind));
        StepWorkers step_workers;
        REQUIRE(step_workers.start(helpers, jobs.callbacks()));
        for (int round = 0; round < 2; ++round) {
            Sums sums;
            step_workers.gather();
            play(step_workers, sums, mode);
            step_workers.dismiss(mode);
            CHECK(sums.wrong == 0);
            CHECK(jobs.enqueued == jobs.finished);
        }
        // Helpers that have not come yet are not called again; those within enqueue are.
        if (kind == Jobs::in_finish) CHECK(jobs.enqueued == 2);
        if (kind == Jobs::at_once || kind == Jobs::blocking) CHECK(jobs.enqueued == 2 * runs);
        step_workers.stop();
    }
}

TEST_CASE("helpers that stay are not called again") {
    // During the caller's run its helper waits for more, as long as a pause lasts: chunks are far shorter.
    const FloatMode mode;
    uint32_t least = UINT32_MAX;
    for (int attempt = 0; attempt < 20 && least > runs / 4; ++attempt) { // a busy machine can delay it
        Jobs jobs(Jobs::side_by_side);
        StepWorkers step_workers;
        REQUIRE(step_workers.start(1, jobs.callbacks()));
        Sums sums;
        step_workers.gather();
        play(step_workers, sums, mode);
        step_workers.dismiss(mode);
        least = std::min(least, jobs.enqueued);
        step_workers.stop();
    }
    CHECK(least <= runs / 4);
}

TEST_CASE("threads of its own and no threads at all") {
    const FloatMode mode;
    for (uint32_t workers : {0u, 1u, 3u}) {
        StepWorkers step_workers;
        REQUIRE(step_workers.start(workers, {}));
        Sums sums;
        step_workers.gather();
        play(step_workers, sums, mode);
        step_workers.dismiss(mode);
        CHECK(sums.wrong == 0);
        step_workers.stop();
    }
}
