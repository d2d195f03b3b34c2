// Threads of a step: the caller alone, the world's own threads, or an engine's job system. Results do not depend on the thread that runs a chunk.
#pragma once

#include "base/float_mode.h"
#include "base/scratch.h"
#include "base/threads.h"
#include "langevin_rigid.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>

namespace lr {

// Chunks of work: any number of threads take them, one thread waits for all. Each thread starts at the same chunks in each round, because a cache
// line written by another core is ten to a hundred times slower than its own.
class ChunkQueue {
public:
    using Task = void (*)(void* context, uint32_t chunk);

    ScratchPool& scratch() { return scratch_; }

    // Starts a round of task(context, 0 .. chunks - 1) on `threads` threads, after the previous round is done.
    void open(uint32_t chunks, uint32_t threads, Task task, void* context);
    // Runs chunks until none are left; returns the round. Any thread, any time: a late thread finds none and reads nothing else.
    uint64_t take(uint32_t thread);
    bool opened_since(uint64_t round) const { return round_.load(std::memory_order_acquire) != round; }
    // Waits until all chunks are done, also those taken by others.
    void wait();

private:
    static constexpr uint32_t most_claims = 512, claim_bits = 10, thread_bits = 7;

    // Numbers of the round, of claims and of threads. A thread without a claim must read nothing else.
    alignas(64) std::atomic<uint64_t> round_{0};
    uint32_t chunks_ = 0;
    Task task_ = nullptr;
    void* context_ = nullptr;
    alignas(64) WaitedCount undone_{0}; // claims that are not done
    // For each claim, the round in which it was last taken. A few claims get cache lines of their own.
    static constexpr uint32_t apart = 8;
    alignas(64) std::array<std::atomic<uint64_t>, most_claims> claimed_{};
    ScratchPool scratch_;
};

// The world's own threads.
class WorkerPool {
public:
    static constexpr uint32_t max_workers = 64;
    static_assert(ScratchPool::most == max_workers + 1); // the caller too

    explicit WorkerPool(ChunkQueue& queue) : queue_(&queue) {}
    ~WorkerPool() { stop(); }
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    // False if the system gives no threads; none are then running.
    bool start(uint32_t workers);
    void stop();
    uint32_t workers() const { return workers_; }

    // Wakes up to `helpers` workers to take from the open queue. Returns at once.
    void wake(uint32_t helpers);

private:
    void work(uint32_t thread);

    ChunkQueue* queue_;
#if LR_HAS_THREADS
    std::array<std::thread, max_workers> threads_;
#endif
    uint32_t workers_ = 0;
    std::atomic<bool> stopping_{false};
    WaitedCount round_{0}; // grows by one for each call of wake()
};

// The world's threads, or a job system.
class StepWorkers {
public:
    // Null callbacks: own threads. False if the system gives none.
    bool start(uint32_t workers, const lr_job_system& jobs);
    // Gives tasks scratch. False when out of memory.
    bool reserve_scratch(Allocator& allocator) { return queue_.scratch().reserve(allocator, helpers_ + 1); }
    void stop() {
        pool_.stop();
        queue_.scratch().reset();
    }
    uint32_t helpers() const { return helpers_; } // maximum besides the caller

    // Runs task(context, 0 .. chunks - 1), on the caller too, with at most `helpers`, and returns when all are done. `mode`: of the step; the
    // caller's mode is restored while its job system runs. Allocates nothing.
    void run(uint32_t chunks, uint32_t helpers, ChunkQueue::Task task, void* context, const FloatMode& mode);
    template <class Function> void run(uint32_t chunks, uint32_t helpers, Function function, const FloatMode& mode) {
        const auto task = [](void* self, uint32_t chunk) { (*static_cast<Function*>(self))(chunk); };
        run(chunks, helpers, task, &function, mode);
    }

    // Between gather() and dismiss(), tasks of a job system stay from run to run, because there are too many runs to enqueue each.
    void gather() { gathered_.store(true, std::memory_order_relaxed); }
    void dismiss(const FloatMode& mode);

private:
    static void job(void* step_workers, uint32_t begin, uint32_t end);
    void stay(uint32_t thread);
    void call(uint32_t helpers, const FloatMode& mode);
    void finish(const FloatMode& mode);

    // A member, not on a step's stack, because a late job must still find it.
    ChunkQueue queue_;
    WorkerPool pool_{queue_};
    lr_job_system jobs_{};
    uint32_t helpers_ = 0;

    // For a job system.
    ThreadId caller_{};
    void* token_ = nullptr;
    bool called_ = false;
    std::atomic<uint32_t> present_{0};  // indices that were enqueued and have not returned
    std::atomic<bool> gathered_{false}; // more runs will follow
    std::atomic<bool> calling_{false};  // the caller is within enqueue
};

// Parallel loops on the threads of a step.
class Workers {
public:
    Workers(StepWorkers& step_workers, const FloatMode& mode) : step_workers_(&step_workers), mode_(&mode) {
        step_workers.gather();
    }
    ~Workers() { step_workers_->dismiss(*mode_); }
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    // Calls function(begin, end) for pieces of [0, count) of length `grain`, in any order and concurrently.
    template <class Function> void run(uint32_t count, uint32_t grain, const Function& function) const {
        const auto piece = [&](uint32_t at) { function(at * grain, std::min((at + 1) * grain, count)); };
        step_workers_->run((count + grain - 1) / grain, step_workers_->helpers(), piece, *mode_);
    }

private:
    StepWorkers* step_workers_;
    const FloatMode* mode_;
};
} // namespace lr
