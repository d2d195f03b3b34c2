// Loops over many, shared out among the threads of a step.
#pragma once

#include "world/crew.h"

#include <algorithm>
#include <cstdint>

namespace lr {

class Workers {
public:
    Workers(Crew& crew, const FloatMode& mode) : crew_(&crew), mode_(&mode) { crew.gather(); }
    ~Workers() { crew_->dismiss(*mode_); }
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    // function(begin, end) over pieces of [0, count), `grain` long, in any order and side by side.
    template <class Function> void run(uint32_t count, uint32_t grain, const Function& function) const {
        const uint32_t pieces = (count + grain - 1) / grain;
        if (pieces == 0) return;
        struct Loop {
            const Function* function;
            uint32_t count, grain;
        };
        Loop loop{&function, count, grain};
        const auto task = [](void* context, uint32_t piece) {
            const Loop& all = *static_cast<const Loop*>(context);
            const uint32_t begin = piece * all.grain;
            (*all.function)(begin, std::min(begin + all.grain, all.count));
        };
        crew_->run(pieces, crew_->helpers(), task, &loop, *mode_);
    }

private:
    Crew* crew_;
    const FloatMode* mode_;
};

} // namespace lr
