// Who does the work of a step: the caller alone, the world's own threads, or an engine's job system.
#pragma once

#include "kernel/float_mode.h"
#include "langevin_rigid.h"
#include "world/chunk_queue.h"
#include "world/threads.h"
#include "world/worker_pool.h"

#include <atomic>

namespace lr {

class Crew {
public:
    // Callbacks null: threads of its own. False when the system gives none.
    bool start(uint32_t workers, const lr_job_system& jobs);
    // Of a job system whose number of threads is not known: as many as the machine has, but the caller.
    static uint32_t usual_helpers();
    void stop() { pool_.stop(); }
    uint32_t helpers() const { return helpers_; } // the most besides the caller

    // Runs task(context, 0 .. chunks - 1), in the caller too, and returns when all are done. At most `helpers` are asked.
    // `mode`: of the step, that of the caller is put back while its job system runs. Allocates nothing.
    void run(uint32_t chunks, uint32_t helpers, ChunkQueue::Task task, void* context, const FloatMode& mode);

    // Between them, tasks of a job system stay from one run to the next: many runs a millisecond would be too many to enqueue.
    void gather();
    void dismiss(const FloatMode& mode);

private:
    static void job(void* crew, uint32_t begin, uint32_t end);
    void stay();
    void call(uint32_t helpers, const FloatMode& mode);
    void finish(const FloatMode& mode);

    // Here and not on a step's stack: a job that comes too late must still find it.
    ChunkQueue queue_;
    WorkerPool pool_{queue_};
    lr_job_system jobs_{};
    uint32_t helpers_ = 0;

    // Of a job system.
    ThreadId caller_{};
    void* token_ = nullptr;
    bool called_ = false;
    std::atomic<uint32_t> present_{0};  // indices that were enqueued and have not returned
    std::atomic<bool> gathered_{false}; // more runs are to come
    std::atomic<bool> calling_{false};  // the caller is within enqueue
};

} // namespace lr
