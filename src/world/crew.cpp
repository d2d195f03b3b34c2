#include "world/crew.h"

#include <algorithm>

namespace lr {

bool Crew::start(uint32_t workers, const lr_job_system& jobs) {
    jobs_ = jobs;
    helpers_ = workers;
    return jobs.enqueue || pool_.start(workers);
}

void Crew::job(void* crew, uint32_t begin, uint32_t end) {
    // One index is as good as another: each takes what is left.
    if (begin < end) static_cast<Crew*>(crew)->queue_.take();
}

void Crew::run(uint32_t chunks, uint32_t helpers, ChunkQueue::Task task, void* context, const FloatMode& mode) {
    helpers = chunks == 0 ? 0 : std::min({helpers, helpers_, chunks - 1});
    if (helpers == 0) {
        for (uint32_t i = 0; i < chunks; ++i) task(context, i);
        return;
    }
    queue_.open(chunks, task, context);
    if (!jobs_.enqueue) {
        pool_.wake(helpers);
        queue_.take();
    } else {
        void* token = nullptr;
        {
            const CallersMode outside(mode);
            token = jobs_.enqueue(jobs_.user, &Crew::job, this, helpers);
        }
        queue_.take();
        const CallersMode outside(mode);
        jobs_.finish(jobs_.user, token);
    }
    queue_.wait();
}

} // namespace lr
