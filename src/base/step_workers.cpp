#include "base/step_workers.h"

#include <algorithm>

#if defined(__SSE2__) || defined(_M_X64)
#include <emmintrin.h>
#endif

namespace lr {
namespace {

void pause_processor() {
#if defined(__SSE2__) || defined(_M_X64)
    _mm_pause();
#elif defined(__aarch64__)
    __asm__ volatile("yield");
#endif
}

// Some tens of microseconds: the length of a chunk, and what waking a thread costs. A pause is 40 to 140 cycles on x86.
constexpr uint32_t spins = 1000;

// False if it is not ready within that time.
template <class Ready> bool spin_until(const Ready& ready) {
    for (uint32_t i = 0; i < spins; ++i) {
        if (ready()) return true;
        pause_processor();
    }
    return ready();
}
} // namespace

void ChunkQueue::open(uint32_t chunks, Task task, void* context) {
    task_ = task;
    context_ = context;
    chunks_ = chunks;
    undone_.store(chunks, std::memory_order_relaxed);
    left_.store(chunks, std::memory_order_release);
}

void ChunkQueue::take() {
    uint32_t left = left_.load(std::memory_order_acquire);
    if (left == 0) return;
    const FloatMode mode;
    uint32_t done = 0;
    while (left != 0) {
        // Only a thread that holds a chunk may read the round, which lasts until that chunk is done.
        if (!left_.compare_exchange_weak(left, left - 1, std::memory_order_acquire)) continue;
        task_(context_, chunks_ - left);
        ++done;
        left = left_.load(std::memory_order_acquire);
    }
    if (done != 0 && undone_.fetch_sub(done, std::memory_order_acq_rel) == done) undone_.notify_one();
}

void ChunkQueue::wait() {
    const auto done = [this] { return undone_.load(std::memory_order_acquire) == 0; };
    if (spin_until(done)) return;
    for (uint32_t left = undone_.load(std::memory_order_acquire); left != 0;
         left = undone_.load(std::memory_order_acquire))
        undone_.wait(left);
}

#if LR_HAS_THREADS
bool WorkerPool::start(uint32_t workers) {
    try {
        for (; workers_ < workers; ++workers_) threads_[workers_] = std::thread([this] { work(); });
    } catch (...) { // std::system_error, or std::bad_alloc from the thread's own state
        stop();
        return false;
    }
    return true;
}

void WorkerPool::stop() {
    if (workers_ == 0) return;
    stopping_.store(true, std::memory_order_relaxed);
    round_.fetch_add(1, std::memory_order_release);
    round_.notify_all();
    for (uint32_t i = 0; i < workers_; ++i) threads_[i].join();
    workers_ = 0;
}
#else
bool WorkerPool::start(uint32_t workers) {
    return workers == 0;
}

void WorkerPool::stop() {}
#endif

void WorkerPool::wake(uint32_t helpers) {
    round_.fetch_add(1, std::memory_order_release);
    if (helpers >= workers_)
        round_.notify_all();
    else
        for (; helpers != 0; --helpers) round_.notify_one();
}

void WorkerPool::work() {
    uint32_t seen = 0;
    for (;;) {
        // Rounds of one step follow each other within microseconds; rounds of different frames do not.
        const auto called = [&] { return round_.load(std::memory_order_acquire) != seen; };
        if (!spin_until(called)) round_.wait(seen);
        seen = round_.load(std::memory_order_acquire);
        if (stopping_.load(std::memory_order_relaxed)) return;
        queue_->take();
    }
}

bool StepWorkers::start(uint32_t workers, const lr_job_system& jobs) {
    jobs_ = jobs;
    helpers_ = workers;
    return jobs.enqueue || pool_.start(workers);
}

uint32_t StepWorkers::usual_helpers() {
    return std::clamp<uint32_t>(hardware_threads(), 2, WorkerPool::max_workers + 1) - 1;
}

void StepWorkers::job(void* step_workers, uint32_t begin, uint32_t end) {
    if (begin >= end) return;
    // All indices are equal: each takes chunks that are left.
    StepWorkers& self = *static_cast<StepWorkers*>(step_workers);
    self.stay();
    self.present_.fetch_sub(end - begin, std::memory_order_release);
}

// A job system can run its tasks inside enqueue, on the caller's thread or while it waits: then no more work can come.
void StepWorkers::stay() {
    queue_.take();
    if (this_thread() == caller_) return;
    const auto leaves = [this] {
        return !gathered_.load(std::memory_order_relaxed) || calling_.load(std::memory_order_relaxed);
    };
    while (!leaves() && spin_until([&] { return queue_.any() || leaves(); })) queue_.take();
}

void StepWorkers::call(uint32_t helpers, const FloatMode& mode) {
    if (present_.load(std::memory_order_acquire) != 0) return;
    finish(mode);
    caller_ = this_thread();
    present_.store(helpers, std::memory_order_relaxed);
    calling_.store(true, std::memory_order_relaxed);
    {
        const CallersMode outside(mode);
        token_ = jobs_.enqueue(jobs_.user, &StepWorkers::job, this, helpers);
    }
    calling_.store(false, std::memory_order_relaxed);
    called_ = true;
}

void StepWorkers::finish(const FloatMode& mode) {
    if (!called_) return;
    const CallersMode outside(mode);
    jobs_.finish(jobs_.user, token_);
    called_ = false;
    present_.store(0, std::memory_order_relaxed); // also if a system ran an index twice
}

void StepWorkers::dismiss(const FloatMode& mode) {
    gathered_.store(false, std::memory_order_relaxed);
    finish(mode);
}

void StepWorkers::run(uint32_t chunks, uint32_t helpers, ChunkQueue::Task task, void* context, const FloatMode& mode) {
    const bool gathered = gathered_.load(std::memory_order_relaxed);
    helpers = std::min(helpers, helpers_);
    if (chunks <= 1 || !gathered) helpers = chunks == 0 ? 0 : std::min(helpers, chunks - 1);
    if (helpers == 0) {
        for (uint32_t i = 0; i < chunks; ++i) task(context, i);
        return;
    }
    queue_.open(chunks, task, context);
    if (jobs_.enqueue)
        call(helpers, mode);
    else
        pool_.wake(std::min(helpers, chunks - 1));
    queue_.take();
    if (!gathered) finish(mode);
    queue_.wait();
}
} // namespace lr
