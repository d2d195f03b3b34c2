#include "support/heap_quality.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace test {

namespace {

constexpr double counted_depth = 1e-4, smallest_depth = 1e-5; // m
constexpr double parallel = 1e-9; // sine between two edges whose cross product gives no axis

struct Box {
    std::array<Vec, 3> axes; // world frame
    Vec centre, reach;       // reach: half extents of its axis-aligned box
};

Box box_of(const Vec& half, const Pose& pose) {
    const Matrix3 r = rotation(normalised(pose.turn));
    Box box;
    box.centre = pose.position;
    for (size_t k = 0; k < 3; ++k) {
        box.axes[k] = {r[0][k], r[1][k], r[2][k]};
        box.reach[k] = std::abs(r[k][0]) * half[0] + std::abs(r[k][1]) * half[1] + std::abs(r[k][2]) * half[2];
    }
    return box;
}

double radius(const Vec& half, const Box& box, const Vec& axis) {
    return half[0] * std::abs(dot(box.axes[0], axis)) + half[1] * std::abs(dot(box.axes[1], axis)) +
           half[2] * std::abs(dot(box.axes[2], axis));
}

double depth_of(const Vec& half, const Box& a, const Box& b) {
    const Vec between = b.centre - a.centre;
    double least = 2.0 * length(half);
    const auto try_axis = [&](const Vec& axis) {
        least = std::min(least, radius(half, a, axis) + radius(half, b, axis) - std::abs(dot(between, axis)));
    };
    for (const Vec& axis : a.axes) try_axis(axis);
    for (const Vec& axis : b.axes) try_axis(axis);
    for (const Vec& u : a.axes)
        for (const Vec& v : b.axes) {
            const Vec across = cross(u, v);
            const double sine = length(across);
            if (sine > parallel) try_axis(1.0 / sine * across);
        }
    return least;
}

double quantile(std::vector<double>& values, double part) {
    if (values.empty()) return 0.0;
    const size_t at = std::min(values.size() - 1, static_cast<size_t>(part * static_cast<double>(values.size())));
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
    return values[at];
}

// Calls found(i, j, depth) for each pair that overlaps.
template <class F> void each_overlap(const Vec& half, const std::vector<Pose>& poses, F&& found) {
    std::vector<Box> boxes;
    boxes.reserve(poses.size());
    for (const Pose& pose : poses) boxes.push_back(box_of(half, pose));
    const auto low = [&](size_t i) { return boxes[i].centre[0] - boxes[i].reach[0]; };
    std::vector<size_t> order(poses.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::sort(order.begin(), order.end(), [&](size_t i, size_t j) { return low(i) < low(j); });
    for (size_t m = 0; m < order.size(); ++m) {
        const size_t i = order[m];
        const Box& a = boxes[i];
        const double end = a.centre[0] + a.reach[0];
        for (size_t n = m + 1; n < order.size() && low(order[n]) < end; ++n) {
            const Box& b = boxes[order[n]];
            if (std::abs(a.centre[1] - b.centre[1]) >= a.reach[1] + b.reach[1] ||
                std::abs(a.centre[2] - b.centre[2]) >= a.reach[2] + b.reach[2])
                continue;
            const double depth = depth_of(half, a, b);
            if (depth > 0.0) found(i, order[n], depth);
        }
    }
}

} // namespace

double overlap_depth(const Vec& half, const Pose& a, const Pose& b) {
    return depth_of(half, box_of(half, a), box_of(half, b));
}

HeapQuality heap_quality(const Vec& half, const std::vector<Pose>& poses) {
    HeapQuality q;
    if (poses.empty()) return q;
    const auto bodies = static_cast<double>(poses.size());
    const double thickness = 2.0 * std::min({half[0], half[1], half[2]});
    std::vector<double> depths;
    std::vector<bool> deep(poses.size());
    each_overlap(half, poses, [&](size_t i, size_t j, double depth) {
        if (depth > smallest_depth) depths.push_back(depth);
        if (depth > counted_depth) q.overlaps += 1.0 / bodies;
        if (depth > thickness) deep[i] = deep[j] = true;
    });
    q.depth_median = quantile(depths, 0.5);
    q.depth_99 = quantile(depths, 0.99);
    q.share_deep = static_cast<double>(std::count(deep.begin(), deep.end(), true)) / bodies;
    std::vector<double> heights;
    heights.reserve(poses.size());
    for (const Pose& pose : poses) heights.push_back(pose.position[1]);
    q.height_mean = std::accumulate(heights.begin(), heights.end(), 0.0) / bodies;
    q.height_95 = quantile(heights, 0.95);
    return q;
}

double largest_movement(const Vec& half, const std::vector<Pose>& before, const std::vector<Pose>& after) {
    double most = 0.0;
    for (size_t i = 0; i < std::min(before.size(), after.size()); ++i)
        for (uint32_t corner = 0; corner < 8; ++corner) {
            Vec at = half;
            for (uint32_t k = 0; k < 3; ++k)
                if ((corner >> k & 1u) != 0) at[k] = -at[k];
            const Vec a = before[i].position + to_world(normalised(before[i].turn), at),
                      b = after[i].position + to_world(normalised(after[i].turn), at);
            most = std::max(most, length(b - a));
        }
    return most;
}

HeapState heap_state(const lr_world* world, lr_batch batch) {
    HeapState state;
    lr_batch_view v;
    if (lr_batch_view_init(&v, sizeof v) != LR_OK || lr_batch_get_view(world, batch, &v) != LR_OK) return state;
    std::vector<float> velocities(size_t{6} * v.count);
    if (lr_batch_write_velocities(world, batch, velocities.data(), 0, v.count, nullptr) != LR_OK) return state;
    state.awake = v.awake_count;
    double squares = 0.0;
    for (size_t i = 0; i < v.awake_count; ++i) {
        const Vec u = vec(velocities.data() + 6 * i);
        squares += dot(u, u);
    }
    if (v.awake_count > 0) state.awake_speed = std::sqrt(squares / v.awake_count);
    std::vector<size_t> order(v.count);
    std::iota(order.begin(), order.end(), size_t{0});
    std::sort(order.begin(), order.end(), [&](size_t i, size_t j) { return v.ids[i].id < v.ids[j].id; });
    state.poses.reserve(v.count);
    for (const size_t i : order) {
        const float at[3] = {v.position[0][i], v.position[1][i], v.position[2][i]};
        const float turn[4] = {v.orientation[0][i], v.orientation[1][i], v.orientation[2][i], v.orientation[3][i]};
        state.poses.push_back({vec(at), quat(turn)});
    }
    return state;
}

} // namespace test
