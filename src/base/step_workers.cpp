#include "base/step_workers.h"

namespace lr {
namespace {

// Some tens of microseconds: the duration of a chunk, and the cost of waking a thread. A pause is 40 to 140 cycles on x86.
constexpr uint32_t spins = 1000;

// Whether it was ready within that time.
template <class Ready> bool spin_until(const Ready& ready) {
    for (uint32_t i = 0; i < spins; ++i) {
        if (ready()) return true;
        pause_processor();
    }
    return ready();
}
} // namespace

void ChunkQueue::open(uint32_t chunks, uint32_t threads, Task task, void* context) {
    task_ = task;
    context_ = context;
    chunks_ = chunks;
    const uint32_t claims = std::min(chunks, most_claims);
    undone_.store(claims, std::memory_order_relaxed);
    const uint64_t number = (round_.load(std::memory_order_relaxed) >> (claim_bits + thread_bits)) + 1;
    round_.store((number << claim_bits | claims) << thread_bits | threads, std::memory_order_release);
}

// Each thread starts in its even share of the claims, even threads upwards from their first, odd ones downwards from their last. Two neighbours that
// finish their shares meet in between.
uint64_t ChunkQueue::take(uint32_t thread) {
    const uint64_t round = round_.load(std::memory_order_acquire), number = round >> (claim_bits + thread_bits);
    const uint32_t claims = round >> thread_bits & ((1u << claim_bits) - 1),
                   threads = round & ((1u << thread_bits) - 1);
    if (claims == 0) return round;
    const FloatMode mode;
    const ScratchLease lease(scratch_, thread);
    const uint32_t place = thread % threads;
    const bool down = place % 2 != 0;
    uint32_t at = claims * (down ? place + 1 : place) / threads, done = 0;
    for (uint32_t n = 0; n < claims; ++n) {
        if (down) at = at == 0 ? claims - 1 : at - 1;
        const uint32_t claim = at % claims;
        if (!down) at = claim + 1;
        // After a round, all its claims bear its number or a later one, so a late thread gets none.
        std::atomic<uint64_t>& stamp = claimed_[claims <= most_claims / apart ? apart * claim : claim];
        uint64_t last = stamp.load(std::memory_order_relaxed);
        if (last >= number || !stamp.compare_exchange_strong(last, number, std::memory_order_acquire)) continue;
        const auto share = [&](uint64_t of) { return static_cast<uint32_t>(of * chunks_ / claims); };
        for (uint32_t chunk = share(claim), past = share(claim + 1); chunk < past; ++chunk) task_(context_, chunk);
        ++done;
    }
    if (done != 0 && undone_.fetch_sub(done, std::memory_order_acq_rel) == done) undone_.notify_one();
    return round;
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
        for (; workers_ < workers; ++workers_)
            threads_[workers_] = std::thread([this, thread = workers_ + 1] { work(thread); });
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

void WorkerPool::work(uint32_t thread) {
    for (;;) {
        // Before take(): a round that begins later changes it.
        const uint32_t seen = round_.load(std::memory_order_acquire);
        if (stopping_.load(std::memory_order_relaxed)) return;
        const uint64_t round = queue_->take(thread);
        // Spins, because rounds of one step follow within microseconds; sleeps between frames.
        const auto called = [&] { return queue_->opened_since(round) || stopping_.load(std::memory_order_relaxed); };
        if (!spin_until(called)) round_.wait(seen);
    }
}

bool StepWorkers::start(uint32_t workers, const lr_job_system& jobs) {
    jobs_ = jobs;
    helpers_ = workers;
    return jobs.enqueue || pool_.start(workers);
}

void StepWorkers::job(void* step_workers, uint32_t begin, uint32_t end) {
    if (begin >= end) return;
    StepWorkers& self = *static_cast<StepWorkers*>(step_workers);
    self.stay(begin + 1);
    self.present_.fetch_sub(end - begin, std::memory_order_release);
}

// A job system can run tasks inside enqueue, on the caller's thread or while it waits. The task must then return, because no more work can come.
void StepWorkers::stay(uint32_t thread) {
    uint64_t round = queue_.take(thread);
    if (this_thread() == caller_) return;
    const auto leaves = [this] {
        return !gathered_.load(std::memory_order_relaxed) || calling_.load(std::memory_order_relaxed);
    };
    while (!leaves() && spin_until([&] { return queue_.opened_since(round) || leaves(); })) round = queue_.take(thread);
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
    present_.store(0, std::memory_order_relaxed); // even if a system ran an index twice
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
        const ScratchLease lease(queue_.scratch(), 0);
        for (uint32_t i = 0; i < chunks; ++i) task(context, i);
        return;
    }
    queue_.open(chunks, helpers + 1, task, context);
    if (jobs_.enqueue)
        call(helpers, mode);
    else
        pool_.wake(std::min(helpers, chunks - 1));
    queue_.take(0);
    if (!gathered) finish(mode);
    queue_.wait();
}
} // namespace lr
