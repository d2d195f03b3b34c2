#include "collision/colliders.h"
#include "support/random.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace test;
using lr::Pose;
using lr::Rotation;
using lr::Vector;
using lr::wide;

namespace {

Vector random_vector(Random& random, double most) {
    return {random.real(-most, most), random.real(-most, most), random.real(-most, most)};
}
Rotation random_rotation(Random& random) {
    Rotation q{};
    do {
        q = {random.real(-1, 1), random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
    } while (q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w < 0.01f);
    return lr::normalised(q);
}

struct Point {
    double v[3];
};

// A point of the collider at the fraction t of the step.
Point interpolated(const Pose& begin, const Pose& end, Vector p, double t) {
    const Rotation &a = begin.rotation, &b = end.rotation;
    double q[4] = {wide(a.x) + t * (wide(b.x) - wide(a.x)), wide(a.y) + t * (wide(b.y) - wide(a.y)),
                   wide(a.z) + t * (wide(b.z) - wide(a.z)), wide(a.w) + t * (wide(b.w) - wide(a.w))};
    const double n = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (double& e : q) e /= n;
    const double v[3] = {wide(p.x), wide(p.y), wide(p.z)};
    const double u[3] = {2 * (q[1] * v[2] - q[2] * v[1]), 2 * (q[2] * v[0] - q[0] * v[2]),
                         2 * (q[0] * v[1] - q[1] * v[0])};
    const double from[3] = {wide(begin.position.x), wide(begin.position.y), wide(begin.position.z)};
    const double to[3] = {wide(end.position.x), wide(end.position.y), wide(end.position.z)};
    const double turned[3] = {v[0] + q[3] * u[0] + q[1] * u[2] - q[2] * u[1],
                              v[1] + q[3] * u[1] + q[2] * u[0] - q[0] * u[2],
                              v[2] + q[3] * u[2] + q[0] * u[1] - q[1] * u[0]};
    Point out{};
    for (int k = 0; k < 3; ++k) out.v[k] = from[k] + t * (to[k] - from[k]) + turned[k];
    return out;
}

} // namespace

TEST_CASE("a swept box holds every point at every time, and a still one is tight") {
    Random random(1);
    double loosest = 0.0;
    for (int round = 0; round < 20000; ++round) {
        const double size = random.logarithmic(1e-3, 1e2), place = random.logarithmic(0.1, 1e5);
        const Vector middle = random_vector(random, size), h{random.real(0, size), random.real(0, size), 0.0f};
        const lr::LocalBounds local{{middle - h, middle + h}, random.below(2) ? 0.0f : random.real(0, size)};
        const Pose begin{random_vector(random, place), random_rotation(random)};
        // From no rotation to half a turn.
        Rotation q = random_rotation(random);
        const auto part = static_cast<float>(random.logarithmic(1e-4, 1.0));
        const Rotation& b = begin.rotation;
        q = lr::nearer_to(b, q);
        q = lr::normalised(
            {b.x + part * (q.x - b.x), b.y + part * (q.y - b.y), b.z + part * (q.z - b.z), b.w + part * (q.w - b.w)});
        const Pose end{begin.position + random_vector(random, size), q};
        const bool moves = round % 4 != 0;
        const lr::Box box = lr::swept_box(local, begin, end, moves);
        const double travel = wide(lr::most_travel(local.box, begin, end));
        for (int i = 0; i < 30; ++i) {
            const Vector p{middle.x + h.x * (random.below(2) ? 1.0f : -1.0f),
                           middle.y + h.y * (random.below(2) ? 1.0f : -1.0f), middle.z};
            const double t = moves ? random.uniform(0.0, 1.0) : 0.0;
            const Point at = interpolated(begin, end, p, t), first = interpolated(begin, end, p, 0.0);
            const double r = wide(local.round);
            double way = 0.0;
            for (int k = 0; k < 3; ++k) {
                const float low[3] = {box.low.x, box.low.y, box.low.z}, high[3] = {box.high.x, box.high.y, box.high.z};
                if (at.v[k] - r < wide(low[k]) || at.v[k] + r > wide(high[k])) FAIL("a point is outside");
                way += (at.v[k] - first.v[k]) * (at.v[k] - first.v[k]);
            }
            if (std::sqrt(way) > travel) FAIL("a point goes farther");
        }
        if (!moves) {
            // Its corners reach the sides: eight of them, four of them distinct here.
            double most = -1e300;
            for (float sx : {-1.0f, 1.0f})
                for (float sy : {-1.0f, 1.0f})
                    most = std::max(
                        most, interpolated(begin, end, {middle.x + sx * h.x, middle.y + sy * h.y, middle.z}, 0.0).v[0]);
            const double beyond = wide(box.high.x) - most - wide(local.round);
            loosest = std::max(loosest, beyond / (size * 1e-5 + std::abs(most) * 3e-7));
        }
    }
    CHECK(loosest < 1.0);
}

TEST_CASE("velocities turn and carry a collider as they say") {
    // Ten turns about a skew axis in 600 steps return it to its start, up to rounding.
    const Rotation start = lr::normalised({0.1f, -0.3f, 0.2f, 0.9f});
    Pose pose{{1.0f, 2.0f, 3.0f}, start};
    Vector rest{};
    const double speed = 2.0 * 3.14159265358979 * 10.0 / 600.0 * 60.0;
    const Vector axis{0.6f, 0.0f, 0.8f};
    for (int i = 0; i < 600; ++i)
        pose = lr::advanced(pose, {0.0f, 0.0f, 0.0f}, static_cast<float>(speed) * axis, 1.0 / 60.0, rest);
    const double back = std::abs(wide(pose.rotation.x * start.x + pose.rotation.y * start.y +
                                      pose.rotation.z * start.z + pose.rotation.w * start.w));
    CHECK(back > 1.0 - 1e-6);
    // The world's axes, not its own: a quarter turn about y maps x to -z.
    const float quarter = static_cast<float>(3.14159265358979 / 2.0);
    const Pose turned = lr::advanced({{}, {0.0f, 0.0f, 0.0f, 1.0f}}, {}, {0.0f, quarter, 0.0f}, 1.0, rest);
    const Vector x = lr::rotate(turned.rotation, {1.0f, 0.0f, 0.0f});
    CHECK(std::abs(x.x) < 1e-6f);
    CHECK(std::abs(x.z + 1.0f) < 1e-6f);
    // Any angle, including many turns per step.
    Random random(7);
    for (int i = 0; i < 2000; ++i) {
        const double angle = random.logarithmic(1e-6, 1e4);
        const Pose p =
            lr::advanced({{}, {0.0f, 0.0f, 0.0f, 1.0f}}, {}, {0.0f, 0.0f, static_cast<float>(angle)}, 1.0, rest);
        const double half = 0.5 * wide(static_cast<float>(angle)), sign = std::cos(half) < 0.0 ? -1.0 : 1.0;
        if (std::abs(wide(p.rotation.z) - sign * std::sin(half)) > 1e-7 ||
            std::abs(wide(p.rotation.w) - sign * std::cos(half)) > 1e-7)
            FAIL("wrong at an angle of ", angle);
    }
    // Far from the origin a step is less than half of the position's resolution; the collider arrives nevertheless.
    Pose slow{{1e4f, 0.0f, 0.0f}, start};
    rest = {};
    for (int i = 0; i < 60000; ++i) slow = lr::advanced(slow, {0.001f, 0.0f, 0.0f}, {}, 1.0 / 60.0, rest);
    CHECK(std::abs(wide(slow.position.x) + wide(rest.x) - 10001.0) < 1e-4);
}
