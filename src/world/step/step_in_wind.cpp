#include "world/step/step_in_wind.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

constexpr float fastest_answer = 1000.0f, steepest_answer = 1e6f; // m/s; m/s^2 and 1/s

// Calls the caller's own field and adds its valid results to the block.
void ask(WindField& field, double time, lr_batch batch, uint32_t count, FieldBlock& block) {
    alignas(64) float answer[15][field_block]; // velocity, rate, gradient
    for (float(&row)[field_block] : answer) std::fill(row, row + count, 0.0f);
    lr_wind_query query{};
    query.struct_size = sizeof query;
    query.count = count;
    query.batch = batch;
    query.time = time;
    for (size_t k = 0; k < 3; ++k) {
        query.position[k] = block.position[k];
        query.velocity[k] = answer[k];
        query.rate[k] = answer[3 + k];
    }
    for (size_t k = 0; k < 9; ++k) query.gradient[k] = answer[6 + k];
    field.ask_callback(query);
    for (uint32_t i = 0; i < count; ++i) {
        bool flow = true;
        for (size_t k = 0; k < 15; ++k)
            flow = flow && std::abs(answer[k][i]) <= (k < 3 ? fastest_answer : steepest_answer); // false for NaN
        if (!flow) {
            field.blame_callback();
            continue;
        }
        float largest = 0.0f;
        for (size_t k = 0; k < 3; ++k) {
            block.wind[k][i] += answer[k][i];
            block.rate[k][i] += answer[3 + k][i];
            largest = std::max(largest, std::abs(answer[k][i]));
        }
        for (size_t k = 0; k < 9; ++k) block.gradient[k][i] += answer[6 + k][i];
        block.reference[i] += largest;
    }
}
} // namespace

void step_in_field(const FieldSlice& slice, const StepInput& in, const ContactRun* contact, const BatchArrays& arrays,
                   lr_batch batch, uint32_t live, uint32_t begin, uint32_t end) {
    const auto h = static_cast<float>(slice.time.h);
    FieldBlock block;
    FluidSample sample;
    StepInput substep = in;
    substep.substeps = 1;
    BatchArrays bodies = arrays;
    bodies.fluid = &sample;
    for (uint32_t i = 0; i < slice.count; ++i) {
        substep.first_substep = in.first_substep + slice.first + i;
        substep.external.clear = slice.first + i + 1 == slice.time.substeps;
        const double time = slice.time.begin + (slice.first + i + 0.5) * slice.time.h;
        for (uint32_t at = begin; at < end; at += static_cast<uint32_t>(field_block)) {
            const uint32_t last = std::min(at + static_cast<uint32_t>(field_block), end);
            slice.target->predict(arrays, at, last, h, block);
            slice.target->evaluate(slice.field->instant(i), last - at, block);
            if (slice.field->callback() && at < live) ask(*slice.field, time, batch, std::min(last, live) - at, block);
            slice.target->combine(h, last - at, block, sample);
            const auto move = [&] {
                slice.target->step(substep, bodies, at, last);
                slice.target->settle(in.body, h, block, sample, arrays, at, last, in.faults);
            };
            const auto step = [&] {
                if (!slice.surface || !in.water) return move();
                NearBodies near(*slice.surface, in, arrays, live, at, last, slice.time.h, false);
                move();
                if (!near.any()) return;
                near.set_wind(sample.wind);
                near.run(in, batch, slice.first + i, 1);
                near.put_back(arrays);
            };
            if (!contact) {
                step();
                continue;
            }
            ContactPass pass(*contact, in, arrays, live, at, last, slice.first + i);
            step();
            pass.resolve();
        }
    }
}

void sample_field(const KernelTarget& target, WindField& field, double time, lr_batch batch, const float* positions,
                  uint32_t count, float* velocities) {
    FieldBlock block;
    constexpr auto most = static_cast<uint32_t>(field_block);
    for (uint32_t from = 0; from < count; from += std::min(most, count - from)) {
        const uint32_t here = std::min(most, count - from);
        const uint32_t padded = whole_blocks(here);
        for (size_t k = 0; k < 3; ++k)
            for (size_t i = 0; i < padded; ++i)
                block.position[k][i] = positions[3 * (from + std::min<size_t>(i, here - 1)) + k];
        target.evaluate(field.instant(0), padded, block);
        if (field.callback()) ask(field, time, batch, here, block);
        for (size_t k = 0; k < 3; ++k)
            for (size_t i = 0; i < here; ++i) velocities[3 * (from + i) + k] = block.wind[k][i];
    }
}
} // namespace lr
