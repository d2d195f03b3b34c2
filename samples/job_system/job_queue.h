// Stands in for an engine's job system: threads that take jobs from a queue. It knows nothing of Langevin Rigid.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

class JobQueue {
public:
    // Reaches 0 when all its jobs are done.
    using Counter = std::atomic<uint32_t>;
    struct Job {
        void (*function)(void* data, uint32_t index);
        void* data;
        uint32_t index;
        Counter* counter;
    };

    explicit JobQueue(unsigned threads);
    ~JobQueue(); // runs the remaining jobs
    JobQueue(const JobQueue&) = delete;
    JobQueue& operator=(const JobQueue&) = delete;

    unsigned threads() const { return static_cast<unsigned>(threads_.size()); }

    // Queues function(data, 0 .. count - 1), each as a job. If the queue is full, the caller runs some of them.
    void submit(void (*function)(void*, uint32_t), void* data, uint32_t count, Counter& counter);
    // Runs other jobs until the counter is 0.
    void wait(const Counter& counter);

private:
    bool take(Job& job);
    void work();
    static void run(const Job& job);

    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<Job> ring_{256};
    size_t first_ = 0, waiting_ = 0;
    bool stopping_ = false;
    std::vector<std::thread> threads_;
};
