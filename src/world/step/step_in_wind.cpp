#include "world/step/step_in_wind.h"

#include "base/scratch.h"

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

// Changes all that moves with the wind for bodies that feel a share of it, or are near walls.
void make_felt(const FeltFlow* felt, uint32_t count, FieldBlock* blocks) {
    for (uint32_t i = 0; i < count; ++i) {
        FieldBlock& block = blocks[i / lane_block];
        const size_t lane = i % lane_block;
        for (size_t k = 0; k < 3; ++k)
            for (auto* rows : {block.wind, block.change, block.rate}) rows[k][lane] *= felt[i].share;
        for (auto& row : block.gradient) row[lane] *= felt[i].share;
        block.reference[lane] *= felt[i].share;
        Vector wind = vector_in(block.wind, 0, lane);
        felt[i].walls.turn(wind, [&](const auto& turned) {
            for (auto* rows : {block.change, block.rate}) put_in(rows, 0, lane, turned(vector_in(rows, 0, lane)));
            for (size_t j = 0; j < 3; ++j) {
                auto& m = block.gradient;
                const Vector column = turned(Vector{m[j][lane], m[3 + j][lane], m[6 + j][lane]});
                m[j][lane] = column.x, m[3 + j][lane] = column.y, m[6 + j][lane] = column.z;
            }
        });
        put_in(block.wind, 0, lane, wind);
    }
}
} // namespace

void step_in_field(const FieldSlice& slice, const StepInput& in, const ContactRun* contact, const BatchArrays& arrays,
                   lr_batch batch, uint32_t live, uint32_t begin, uint32_t end) {
    const auto h = static_cast<float>(slice.time.h);
    const KernelTarget& target = *slice.target;
    FieldBlock blocks[field_block / lane_block];
    const bool surface = slice.surface && in.water, asks = slice.field && slice.field->callback();
    const bool own = slice.felt != nullptr;
    WindAlong along{slice.instants, blocks, slice.instants->source_count == 0 && !asks && !own, asks || surface || own};
    BatchArrays bodies = arrays;
    bodies.wind = &along;
    StepInput part = in;
    const auto take = [&](uint32_t first, uint32_t count) {
        part.first_substep = in.first_substep + slice.first + first;
        part.substeps = count;
        part.external.clear = slice.first + first + count == slice.time.substeps;
        along.instant = slice.instants + first;
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
            if (own && at < live) make_felt(slice.felt + (at - begin), std::min(last, live) - at, blocks);
        }
        alignas(64) float row[field_block];
        float* submerged = surface && contact ? row : nullptr;
        if (surface && slice.submerged) submerged = slice.submerged + (at - begin);
        if (submerged) std::fill_n(submerged, last - at, 0.0f);
        const auto step = [&] {
            if (!surface) return target.step(part, bodies, at, last);
            const InScratch<NearBodies> near(*slice.surface, in, arrays, live, at, last, slice.time.h, 0.0, false);
            target.step(part, bodies, at, last);
            if (!near->any()) return;
            alignas(64) float wind[3][field_block];
            for (size_t k = 0; k < 3; ++k) copy_row(blocks, &FieldBlock::wind, k, last - at, wind[k]);
            near->set_wind(wind, own ? slice.felt + (at - begin) : nullptr);
            near->run(in, batch, slice.first + i, 1);
            near->put_back(arrays, submerged);
        };
        if (!contact) return step();
        const InScratch<ContactPass> pass(*contact, in, arrays, live, at, last, slice.first + i);
        const NearContacts& near = pass->near();
        const auto index = [&](uint32_t k) { return near.index(k); };
        const InScratch<StepApart> apart(in, arrays, near.count(), index, [&](uint32_t body, FeltFlow& felt) {
            if (own) felt.share = slice.felt[body - begin].share;
            felt.walls = pass->walls(body);
            return felt.walls.count != 0;
        });
        step();
        if (apart->any()) {
            FieldSlice now = slice;
            now.instants += i, now.first += i, now.count = 1;
            apart->step(now, in, vector_of(in.gravity), arrays, batch, submerged, at);
        }
        pass->resolve(submerged);
    };
    // Runs all substeps of a block while it is in the cache.
    for (uint32_t at = begin, last; at < end; at = last) {
        last = std::min(at + static_cast<uint32_t>(field_block), end);
        for (uint32_t i = 0; i < slice.count; ++i) step_block(at, last, i);
    }
}

void StepApart::take(const StepInput& in, const BatchArrays& arrays) {
    copies_.take(arrays, count_, [this](uint32_t i) { return index_[i]; });
    copies_.take_forces(in.external, false);
}

void StepApart::step(FieldSlice slice, StepInput in, Vector gravity, const BatchArrays& to, lr_batch batch,
                     float* submerged, uint32_t first) {
    copies_.lend_forces(in.external);
    // In a uniform wind that changes, gravity is that of the fluid's frame. The copies are stepped in the world's.
    if (in.wind_changes) put(gravity, in.gravity);
    in.wind_changes = false;
    BatchArrays arrays = copies_.arrays();
    for (size_t f = 0; f < field_count; ++f)
        if (!to.field[f]) arrays.field[f] = nullptr;
    float wet[field_block];
    slice.felt = felt_;
    slice.submerged = wet;
    step_in_field(slice, in, nullptr, arrays, batch, count_, 0, copies_.padded);
    copies_.put_back(to);
    for (uint32_t i = 0; i < count_ && submerged && slice.surface && in.water; ++i)
        submerged[index_[i] - first] = wet[i];
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
