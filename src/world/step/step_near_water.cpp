#include "world/step/step_near_water.h"

#include "base/scratch.h"

#include <algorithm>
#include <array>

namespace lr {
namespace {

constexpr auto most = static_cast<uint32_t>(field_block);

// m: bound of the displacement by wind and forces, beyond that by velocity, in all substeps but the first.
double carried(const StepInput& in, const StepTime& time) {
    const float wind = std::max(length(vector_of(in.wind_begin)), length(vector_of(in.wind)));
    const float forced = in.external.any ? 50.0f : 0.0f; // m/s, as for contact
    return time.h * (time.substeps - 1.0) * wide(wind + forced);
}
} // namespace

NearBodies::NearBodies(const WaterStep& step, const StepInput& in, const BatchArrays& from, uint32_t live,
                       uint32_t begin, uint32_t end, double dt, double reach, bool forget)
    : step_(&step), begin_(begin) {
    step.target->surface.near(step.surface->at(step.time.begin), step.surface->highest() + static_cast<float>(reach),
                              *in.water, static_cast<float>(dt), length(vector_of(step.gravity)), from, begin, end,
                              near_);
    uint32_t index[field_block];
    for (uint32_t i = begin; i < std::min(end, live); ++i)
        if (near_[i - begin] != 0) index[count_++] = i;
    if (count_ == 0) return;
    copies_.take(from, count_, [&](uint32_t i) { return index[i]; });
    copies_.take_forces(in.external, forget);
}

void NearBodies::set_wind(const float (&wind)[3][field_block], const FeltFlow* felt) {
    windy_ = true;
    felt_ = felt;
    for (size_t k = 0; k < 3; ++k)
        for (uint32_t i = 0; i < copies_.padded; ++i) wind_[k][i] = wind[k][copies_.place[i] - begin_];
}

void NearBodies::sample(double time, float h, lr_batch batch, const WaterBody& body, SurfaceInstant& plane,
                        SurfaceBlock& block) {
    plane = step_->surface->at(time);
    step_->target->surface.surface(plane, body, copies_.arrays(), copies_.padded, h, block);
    if (step_->surface->callback()) step_->surface->ask(time, batch, count_, plane, block);
    for (uint32_t i = 0; i < count_ && felt_; ++i) {
        Vector flow = vector_in(block.velocity, 0, i);
        felt_[copies_.place[i] - begin_].walls.turn(
            flow, [&](const auto& turned) { put_in(block.rate, 0, i, turned(vector_in(block.rate, 0, i))); });
        put_in(block.velocity, 0, i, flow);
    }
}

void NearBodies::run(const StepInput& in, lr_batch batch, uint32_t first, uint32_t count) {
    const SurfaceTarget& kernel = step_->target->surface;
    const BatchArrays bodies = copies_.arrays();
    StepInput one = in;
    one.substeps = 1;
    copies_.lend_forces(one.external);
    SurfaceInstant plane;
    const InScratch<std::array<SurfaceBlock, 3>> blocks;
    SurfaceBlock *begin = blocks->data(), *const middle = begin + 1, *end = begin + 2;
    const auto h = static_cast<float>(step_->time.h);
    sample(step_->time.begin + first * step_->time.h, 0.0f, batch, *in.water, plane, *begin);
    for (uint32_t i = first; i < first + count; ++i) {
        one.first_substep = in.first_substep + i;
        if (!windy_) {
            const float part = (static_cast<float>(i) + 0.5f) / static_cast<float>(step_->time.substeps);
            for (size_t k = 0; k < 3; ++k)
                std::fill_n(wind_[k], copies_.padded, in.wind_begin[k] + part * (in.wind[k] - in.wind_begin[k]));
        }
        sample(step_->time.begin + (i + 0.5) * step_->time.h, 0.5f * h, batch, *in.water, plane, *middle);
        const WetSubstep wet{in.water, &plane, begin, middle, end, wind_, step_->gravity, fraction_};
        kernel.step(one, wet, bodies, copies_.padded);
        sample(step_->time.begin + (i + 1.0) * step_->time.h, 0.0f, batch, *in.water, plane, *end);
        kernel.settle(one, wet, bodies, copies_.padded);
        std::swap(begin, end);
    }
}

void NearBodies::put_back(const BatchArrays& to, float* submerged) const {
    for (uint32_t i = 0; i < count_ && submerged; ++i) submerged[copies_.place[i] - begin_] = fraction_[i];
    copies_.put_back(to);
}

void step_lanes(const KernelTarget& target, const WaterStep* surface, const StepTime& time, const StepInput& in,
                const BatchArrays& arrays, lr_batch batch, uint32_t live, uint32_t begin, uint32_t end,
                float* submerged) {
    if (!surface || !in.water) {
        target.step(in, arrays, begin, end);
        return;
    }
    if (submerged) std::fill_n(submerged, end - begin, 0.0f);
    WaterStep step = *surface;
    step.time = time;
    const double reach = carried(in, time);
    for (uint32_t at = begin; at < end; at += most) {
        const uint32_t last = std::min(at + most, end);
        const InScratch<NearBodies> near(step, in, arrays, live, at, last, step.time.h * step.time.substeps, reach,
                                         true);
        step_others(at, last, live, near->marks(),
                    [&](uint32_t from, uint32_t to) { step.target->step(in, arrays, from, to); });
        if (!near->any()) continue;
        near->run(in, batch, 0, step.time.substeps);
        near->put_back(arrays, submerged ? submerged + (at - begin) : nullptr);
    }
}
} // namespace lr
