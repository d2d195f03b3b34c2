#include "world/crew.h"

#include "world/spin.h"

#include <algorithm>

namespace lr {

bool Crew::start(uint32_t workers, const lr_job_system& jobs) {
    jobs_ = jobs;
    helpers_ = workers;
    return jobs.enqueue || pool_.start(workers);
}

uint32_t Crew::usual_helpers() {
    return std::clamp<uint32_t>(hardware_threads(), 2, WorkerPool::max_workers + 1) - 1;
}

void Crew::job(void* crew, uint32_t begin, uint32_t end) {
    if (begin >= end) return;
    // One index is as good as another: each takes what is left.
    Crew& self = *static_cast<Crew*>(crew);
    self.stay();
    self.present_.fetch_sub(end - begin, std::memory_order_release);
}

// A job system may run its tasks within enqueue, on the caller's thread or while that waits: then nothing more can come.
void Crew::stay() {
    queue_.take();
    if (this_thread() == caller_) return;
    const auto leaves = [this] {
        return !gathered_.load(std::memory_order_relaxed) || calling_.load(std::memory_order_relaxed);
    };
    while (!leaves() && spin_until([&] { return queue_.any() || leaves(); })) queue_.take();
}

void Crew::call(uint32_t helpers, const FloatMode& mode) {
    if (present_.load(std::memory_order_acquire) != 0) return;
    finish(mode);
    caller_ = this_thread();
    present_.store(helpers, std::memory_order_relaxed);
    calling_.store(true, std::memory_order_relaxed);
    {
        const CallersMode outside(mode);
        token_ = jobs_.enqueue(jobs_.user, &Crew::job, this, helpers);
    }
    calling_.store(false, std::memory_order_relaxed);
    called_ = true;
}

void Crew::finish(const FloatMode& mode) {
    if (!called_) return;
    const CallersMode outside(mode);
    jobs_.finish(jobs_.user, token_);
    called_ = false;
    present_.store(0, std::memory_order_relaxed); // also of a system that ran an index twice
}

void Crew::gather() {
    gathered_.store(true, std::memory_order_relaxed);
}

void Crew::dismiss(const FloatMode& mode) {
    gathered_.store(false, std::memory_order_relaxed);
    finish(mode);
}

void Crew::run(uint32_t chunks, uint32_t helpers, ChunkQueue::Task task, void* context, const FloatMode& mode) {
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
