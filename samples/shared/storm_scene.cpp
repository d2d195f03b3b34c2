// SPDX-License-Identifier: MIT
#include "storm_scene.h"

#include <cmath>
#include <cstddef>

namespace storm {

namespace {

// Finaliser of SplitMix64 (Steele, Lea, Flood 2014).
std::uint64_t mix(std::uint64_t z) {
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

enum Draw : std::uint32_t { place = 0, size = 3, turn = 8 };

} // namespace

Box box_for(std::uint64_t count, double length) {
    // Each body gets a cube of six lengths; the box has edges 2 : 1 : 2. In float, as the world gets it.
    const double volume = 216.0 * length * length * length * static_cast<double>(count);
    double height = 1e-3;
    while (4.0 * height * height * height < volume) height *= 1.0009765625;
    const auto h = static_cast<float>(height);
    return {{-h, 0.0f, -h}, {h, h, h}};
}

float random_unit(std::uint64_t seed, std::uint64_t index, std::uint32_t draw) {
    const std::uint64_t bits = mix(mix(mix(seed) ^ index) ^ draw);
    return static_cast<float>(bits >> 40) * 0x1p-24f;
}

void random_orientation(std::uint64_t seed, std::uint64_t index, float* quaternion) {
    // Marsaglia 1972: two points in the unit disc make a point on the 3-sphere, with a square root as the only
    // function.
    float x[2], y[2], squared[2];
    std::uint32_t draw = turn;
    for (int i = 0; i < 2; ++i) {
        do {
            x[i] = 2.0f * random_unit(seed, index, draw++) - 1.0f;
            y[i] = 2.0f * random_unit(seed, index, draw++) - 1.0f;
            squared[i] = x[i] * x[i] + y[i] * y[i];
        } while (squared[i] >= 1.0f || (i == 1 && squared[i] == 0.0f));
    }
    const float stretch = std::sqrt((1.0f - squared[0]) / squared[1]);
    quaternion[0] = x[0];
    quaternion[1] = y[0];
    quaternion[2] = x[1] * stretch;
    quaternion[3] = y[1] * stretch;
}

std::vector<lr_body_desc> births(const Box& box, std::uint64_t seed, std::uint64_t first, std::uint32_t count,
                                 const float* wind) {
    lr_body_desc initial;
    lr_body_desc_init(&initial, sizeof initial);
    std::vector<lr_body_desc> bodies(count, initial);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        lr_body_desc& body = bodies[i];
        const std::uint64_t index = first + i;
        for (int axis = 0; axis < 3; ++axis) {
            const float part = random_unit(seed, index, place + static_cast<std::uint32_t>(axis));
            body.position[axis] = box.low[axis] + part * box.size(axis);
            body.linear_velocity[axis] = wind[axis];
        }
        random_orientation(seed, index, body.orientation);
        body.scale = 0.7f + 0.6f * random_unit(seed, index, size);
    }
    return bodies;
}

lr_status Reentry::apply(lr_world* world, lr_batch batch) {
    lr_batch_view view;
    lr_status status = lr_batch_view_init(&view, sizeof view);
    if (status == LR_OK) status = lr_batch_get_view(world, batch, &view);
    if (status != LR_OK) return status;

    // The first change invalidates the view, so read all bodies first.
    outside_.clear();
    for (std::uint32_t i = 0; i < view.count; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            const float x = view.position[axis][i];
            if (!(x >= box_.low[axis] && x < box_.high[axis])) { // NaN counts as outside
                outside_.push_back(view.ids[i]);
                break;
            }
        }
    }
    lr_body_state state;
    status = lr_body_state_init(&state, sizeof state);
    for (const lr_body body : outside_) {
        if (status == LR_OK) status = lr_body_get_state(world, body, &state);
        if (status != LR_OK) return status;
        for (int axis = 0; axis < 3; ++axis) {
            float& x = state.position[axis];
            const float turns = std::floor((x - box_.low[axis]) / box_.size(axis));
            x -= turns * box_.size(axis);
            // Rounding can leave it slightly outside on the far side, which would bring it back every frame.
            if (x < box_.low[axis] || x >= box_.high[axis]) x = box_.low[axis];
        }
        status = lr_body_set_state(world, body, &state);
        if (status != LR_OK) return status;
    }
    count_ += outside_.size();
    return status;
}

} // namespace storm
