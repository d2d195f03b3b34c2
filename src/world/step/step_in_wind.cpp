#include "world/step/step_in_wind.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

constexpr float fastest_answer = 1000.0f, steepest_answer = 1e6f; // m/s; m/s^2 and 1/s

using Vectors = float (FieldBlock::*)[3][lane_block];

void copy_row(const FieldBlock* blocks, Vectors rows, size_t axis, uint32_t count, float* out) {
    for (uint32_t i = 0; i < count; ++i) out[i] = (blocks[i / lane_block].*rows)[axis][i % lane_block];
}

// Calls the caller's wind callback and adds its valid answers.
void ask(WindField& field, double time, lr_batch batch, uint32_t count, FieldBlock* blocks) {
    alignas(64) float position[3][field_block], answer[15][field_block]; // velocity, rate, gradient
    for (size_t k = 0; k < 3; ++k) copy_row(blocks, &FieldBlock::position, k, count, position[k]);
    for (float(&row)[field_block] : answer) std::fill(row, row + count, 0.0f);
    lr_wind_query query{};
    query.struct_size = sizeof query;
    query.count = count;
    query.batch = batch;
    query.time = time;
    for (size_t k = 0; k < 3; ++k) {
        query.position[k] = position[k];
        query.velocity[k] = answer[k];
        query.rate[k] = answer[3 + k];
    }
    for (size_t k = 0; k < 9; ++k) query.gradient[k] = answer[6 + k];
    field.ask_callback(query);
    for (uint32_t i = 0; i < count; ++i) {
        FieldBlock& block = blocks[i / lane_block];
        const size_t lane = i % lane_block;
        bool flow = true;
        for (size_t k = 0; k < 15; ++k)
            flow = flow && std::abs(answer[k][i]) <= (k < 3 ? fastest_answer : steepest_answer); // false for NaN
        if (!flow) {
            field.blame_callback();
            continue;
        }
        float largest = 0.0f;
        for (size_t k = 0; k < 3; ++k) {
            block.wind[k][lane] += answer[k][i];
            block.rate[k][lane] += answer[3 + k][i];
            largest = std::max(largest, std::abs(answer[k][i]));
        }
        for (size_t k = 0; k < 9; ++k) block.gradient[k][lane] += answer[6 + k][i];
        block.reference[lane] += largest;
    }
}

// Scales all that moves with the wind for bodies that feel a share of it.
void weaken(const float* felt, uint32_t count, FieldBlock* blocks) {
    for (uint32_t i = 0; i < count; ++i) {
        FieldBlock& block = blocks[i / lane_block];
        const size_t lane = i % lane_block;
        for (size_t k = 0; k < 3; ++k)
            for (auto* rows : {block.wind, block.change, block.rate}) rows[k][lane] *= felt[i];
        for (auto& row : block.gradient) row[lane] *= felt[i];
        block.reference[lane] *= felt[i];
    }
}
} // namespace

void step_in_field(const FieldSlice& slice, const StepInput& in, const ContactRun* contact, const BatchArrays& arrays,
                   lr_batch batch, uint32_t live, uint32_t begin, uint32_t end) {
    const auto h = static_cast<float>(slice.time.h);
    const KernelTarget& target = *slice.target;
    FieldBlock blocks[field_block / lane_block];
    const bool surface = slice.surface && in.water, asks = slice.field->callback(), weak = slice.felt != nullptr;
    const FieldInstant& instant = slice.field->instant(0);
    WindAlong along{&instant, blocks, instant.source_count == 0 && !asks && !weak, asks || surface || weak};
    BatchArrays bodies = arrays;
    bodies.wind = &along;
    StepInput part = in;
    const auto take = [&](uint32_t first, uint32_t count) {
        part.first_substep = in.first_substep + slice.first + first;
        part.substeps = count;
        part.external.clear = slice.first + first + count == slice.time.substeps;
        along.instant = &slice.field->instant(first);
    };
    if (!contact && !along.known) {
        take(0, slice.count);
        target.step(part, bodies, begin, end);
        return;
    }
    const auto step_block = [&](uint32_t at, uint32_t last, uint32_t i) {
        take(i, 1);
        if (along.known) {
            target.predict(arrays, at, last, h, blocks);
            target.evaluate(*along.instant, last - at, blocks);
            const double time = slice.time.begin + (slice.first + i + 0.5) * slice.time.h;
            if (asks && at < live) ask(*slice.field, time, batch, std::min(last, live) - at, blocks);
            if (weak) weaken(slice.felt + (at - begin), last - at, blocks);
        }
        alignas(64) float row[field_block];
        float* submerged = surface && contact ? row : nullptr;
        if (surface && slice.submerged) submerged = slice.submerged + (at - begin);
        if (submerged) std::fill_n(submerged, last - at, 0.0f);
        const auto step = [&] {
            if (!surface) return target.step(part, bodies, at, last);
            NearBodies near(*slice.surface, in, arrays, live, at, last, slice.time.h, 0.0, false);
            target.step(part, bodies, at, last);
            if (!near.any()) return;
            alignas(64) float wind[3][field_block];
            for (size_t k = 0; k < 3; ++k) copy_row(blocks, &FieldBlock::wind, k, last - at, wind[k]);
            near.set_wind(wind);
            near.run(in, batch, slice.first + i, 1);
            near.put_back(arrays, submerged);
        };
        if (!contact) return step();
        ContactPass pass(*contact, in, arrays, live, at, last, slice.first + i);
        step();
        pass.resolve(submerged);
    };
    // Runs all substeps of a block while it is in the cache.
    for (uint32_t at = begin, last; at < end; at = last) {
        last = std::min(at + static_cast<uint32_t>(field_block), end);
        for (uint32_t i = 0; i < slice.count; ++i) step_block(at, last, i);
    }
}

void sample_field(const KernelTarget& target, WindField& field, double time, lr_batch batch, const float* positions,
                  uint32_t count, float* velocities) {
    FieldBlock blocks[field_block / lane_block];
    constexpr auto most = static_cast<uint32_t>(field_block);
    for (uint32_t from = 0; from < count; from += std::min(most, count - from)) {
        const uint32_t here = std::min(most, count - from);
        const uint32_t padded = whole_blocks(here);
        for (size_t k = 0; k < 3; ++k)
            for (size_t i = 0; i < padded; ++i)
                blocks[i / lane_block].position[k][i % lane_block] =
                    positions[3 * (from + std::min<size_t>(i, here - 1)) + k];
        target.evaluate(field.instant(0), padded, blocks);
        if (field.callback()) ask(field, time, batch, here, blocks);
        for (size_t k = 0; k < 3; ++k)
            for (size_t i = 0; i < here; ++i)
                velocities[3 * (from + i) + k] = blocks[i / lane_block].wind[k][i % lane_block];
    }
}
} // namespace lr
