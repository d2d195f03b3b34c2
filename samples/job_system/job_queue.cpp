// SPDX-License-Identifier: MIT
#include "job_queue.h"

JobQueue::JobQueue(unsigned threads) {
    for (unsigned i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
}

JobQueue::~JobQueue() {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        stopping_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

void JobQueue::run(const Job& job) {
    job.function(job.data, job.index);
    job.counter->fetch_sub(1, std::memory_order_release); // the counter's last use: a waiting thread can destroy it now
}

void JobQueue::submit(void (*function)(void*, uint32_t), void* data, uint32_t count, Counter& counter) {
    counter.fetch_add(count, std::memory_order_relaxed);
    uint32_t queued = 0;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        for (; queued < count && waiting_ < ring_.size(); ++queued, ++waiting_)
            ring_[(first_ + waiting_) % ring_.size()] = {function, data, queued, &counter};
    }
    changed_.notify_all();
    for (; queued < count; ++queued) run({function, data, queued, &counter});
}

bool JobQueue::take(Job& job) {
    if (waiting_ == 0) return false;
    job = ring_[first_];
    first_ = (first_ + 1) % ring_.size();
    --waiting_;
    return true;
}

void JobQueue::wait(const Counter& counter) {
    while (counter.load(std::memory_order_acquire) != 0) {
        Job job{};
        bool found = false;
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            found = take(job);
        }
        if (found)
            run(job);
        else
            std::this_thread::yield();
    }
}

void JobQueue::work() {
    for (;;) {
        Job job{};
        {
            std::unique_lock<std::mutex> lock(mutex_);
            changed_.wait(lock, [this] { return waiting_ != 0 || stopping_; });
            if (!take(job)) return;
        }
        run(job);
    }
}
