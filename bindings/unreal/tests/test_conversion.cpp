// LangevinConversion.h against matrices and numbers calculated by hand, without code of the conversion.
// SPDX-License-Identifier: MIT
#include "LangevinConversion.h"
#include "LangevinPointWind.h"

#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <random>

using namespace LangevinConversion;

namespace {
using Matrix = std::array<double, 9>;

Matrix matrix_of(const FRotation& q) {
    return {1 - 2 * (q.Y * q.Y + q.Z * q.Z), 2 * (q.X * q.Y - q.Z * q.W),     2 * (q.X * q.Z + q.Y * q.W),
            2 * (q.X * q.Y + q.Z * q.W),     1 - 2 * (q.X * q.X + q.Z * q.Z), 2 * (q.Y * q.Z - q.X * q.W),
            2 * (q.X * q.Z - q.Y * q.W),     2 * (q.Y * q.Z + q.X * q.W),     1 - 2 * (q.X * q.X + q.Y * q.Y)};
}

FVec multiply(const Matrix& m, const FVec& v) {
    return {m[0] * v.X + m[1] * v.Y + m[2] * v.Z, m[3] * v.X + m[4] * v.Y + m[5] * v.Z,
            m[6] * v.X + m[7] * v.Y + m[8] * v.Z};
}

FVec cross(const FVec& a, const FVec& b) {
    return {a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X};
}

void check_near(const FVec& a, const FVec& b, double tolerance = 1e-12) {
    CHECK(std::abs(a.X - b.X) <= tolerance);
    CHECK(std::abs(a.Y - b.Y) <= tolerance);
    CHECK(std::abs(a.Z - b.Z) <= tolerance);
}

struct Draw {
    std::mt19937_64 engine{7};
    std::normal_distribution<double> normal;
    FVec vector() { return {normal(engine), normal(engine), normal(engine)}; }
    FRotation rotation() {
        const double x = normal(engine), y = normal(engine), z = normal(engine), w = normal(engine);
        const double n = std::sqrt(x * x + y * y + z * z + w * w);
        return {x / n, y / n, z / n, w / n};
    }
};
} // namespace

TEST_CASE("a point by hand: centimetres, y mirrored, from the origin") {
    check_near(PositionToLangevin({350, -120, 80}, {100, 200, 50}), {2.5, 3.2, 0.3});
    check_near(PositionToUnreal({2.5, 3.2, 0.3}, {100, 200, 50}), {350, -120, 80});
}

TEST_CASE("gravity points down in both, and 980 cm/s^2 are 9.8 m/s^2") {
    check_near(VectorToLangevin({0, 0, -980}), {0, 0, -9.8});
}

TEST_CASE("forces and torques have the units of newtons") {
    check_near(ForceToLangevin({100, 200, 300}), {1, -2, 3});
    check_near(TorqueToLangevin({10000, 20000, 30000}), {-1, 2, -3});
    // torque = arm x force must hold on both sides
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const FVec arm = draw.vector(), force = draw.vector();
        check_near(TorqueToLangevin(cross(arm, force)), cross(VectorToLangevin(arm), ForceToLangevin(force)));
    }
}

TEST_CASE("there and back again") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const FVec v = draw.vector(), origin = draw.vector();
        const FRotation q = draw.rotation();
        check_near(PositionToUnreal(PositionToLangevin(v, origin), origin), v);
        check_near(VectorToUnreal(VectorToLangevin(v)), v);
        check_near(MirrorDirection(MirrorDirection(v)), v);
        check_near(MirrorSpin(MirrorSpin(v)), v);
        const FRotation back = MirrorRotation(MirrorRotation(q));
        CHECK((back.X == q.X && back.Y == q.Y && back.Z == q.Z && back.W == q.W));
    }
}

TEST_CASE("rotations: turning and then mirroring is mirroring and then turning") {
    Draw draw;
    for (int i = 0; i < 200; ++i) {
        const FRotation q = draw.rotation();
        const FVec v = draw.vector();
        const FVec turned = multiply(matrix_of(q), v);
        check_near(multiply(matrix_of(MirrorRotation(q)), {v.X, -v.Y, v.Z}), {turned.X, -turned.Y, turned.Z});
        check_near(Rotate(q, v), turned);
    }
}

TEST_CASE("handedness of a quarter turn about Z") {
    // Unreal: X goes to Y. In the library y is mirrored: x goes to -y.
    const double h = std::sqrt(0.5);
    check_near(multiply(matrix_of(MirrorRotation({0, 0, h, h})), {1, 0, 0}), {0, -1, 0});
    // A spin of 2 rad/s about Unreal's Z takes X towards Y; in the library it must take x towards -y.
    const FVec spin = MirrorSpin({0, 0, 2});
    check_near(cross(spin, {1, 0, 0}), {0, -2, 0});
}

TEST_CASE("spins: velocities of turning points agree on both sides") {
    Draw draw;
    for (int i = 0; i < 200; ++i) {
        const FVec spin = draw.vector(), arm = draw.vector();
        check_near(cross(MirrorSpin(spin), VectorToLangevin(arm)), VectorToLangevin(cross(spin, arm)));
    }
}

TEST_CASE("upright shapes: their y is Unreal's Z, and x and z are X and Y") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const FRotation q = draw.rotation();
        const Matrix unreal = matrix_of(q), langevin = matrix_of(UprightToLangevin(q));
        for (const auto& [own, axis] :
             {std::pair<FVec, FVec>{{0, 1, 0}, {0, 0, 1}}, {{1, 0, 0}, {1, 0, 0}}, {{0, 0, 1}, {0, 1, 0}}}) {
            const FVec there = multiply(unreal, axis);
            check_near(multiply(langevin, own), {there.X, -there.Y, there.Z});
        }
    }
}

TEST_CASE("planes: y goes to the normal") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        FVec n = draw.vector();
        const double length = std::sqrt(n.X * n.X + n.Y * n.Y + n.Z * n.Z);
        n = {n.X / length, n.Y / length, n.Z / length};
        check_near(multiply(matrix_of(RotationFromYTo(n)), {0, 1, 0}), n);
    }
    check_near(multiply(matrix_of(RotationFromYTo({0, -1, 0})), {0, 1, 0}), {0, -1, 0});
    check_near(multiply(matrix_of(RotationFromYTo({0, 1, 0})), {0, 1, 0}), {0, 1, 0});
}

TEST_CASE("a mesh vertex lands where the body has it") {
    // The vertex of the file at (0.03, 0.01, 0.002) m is imported at (3, -1, 0.2) cm; the body's own origin is its centre of
    // mass, (0.005, -0.002, 0.001) m in the file.
    Draw draw;
    const FVec vertex_file{0.03, 0.01, 0.002}, center_file{0.005, -0.002, 0.001};
    const FVec vertex_unreal = VectorToUnreal(vertex_file), center_unreal = VectorToUnreal(center_file);
    check_near(vertex_unreal, {3, -1, 0.2});
    for (int i = 0; i < 50; ++i) {
        const FRotation q = draw.rotation();
        const FVec p = draw.vector(), origin{1000, -2000, 300};
        const double scale = 1.5;
        const float record[8] = {static_cast<float>(p.X), static_cast<float>(p.Y),  static_cast<float>(p.Z),
                                 static_cast<float>(q.X), static_cast<float>(q.Y),  static_cast<float>(q.Z),
                                 static_cast<float>(q.W), static_cast<float>(scale)};
        const FPose pose = InstancePose(record, {-center_unreal.X, -center_unreal.Y, -center_unreal.Z}, origin);
        const FVec drawn =
            multiply(matrix_of(pose.Rotation),
                     {vertex_unreal.X * pose.Scale, vertex_unreal.Y * pose.Scale, vertex_unreal.Z * pose.Scale});
        // In the library: p + R scale (vertex - centre).
        const FVec body =
            multiply(matrix_of(q), {scale * (vertex_file.X - center_file.X), scale * (vertex_file.Y - center_file.Y),
                                    scale * (vertex_file.Z - center_file.Z)});
        check_near({pose.Location.X + drawn.X, pose.Location.Y + drawn.Y, pose.Location.Z + drawn.Z},
                   {origin.X + 100 * (p.X + body.X), origin.Y - 100 * (p.Y + body.Y), origin.Z + 100 * (p.Z + body.Z)},
                   1e-3);
    }
}

TEST_CASE("a record moves on along the world's axes, whatever its own") {
    const float h = std::sqrt(0.5f);
    for (const bool about_z : {true, false}) {
        float record[8] = {1, 2, 3, about_z ? 0 : h, 0, about_z ? h : 0, h, 1};
        const float velocities[6] = {0, 2, 0, 0, 0, 3};
        AdvanceRecord(record, velocities, 0.1);
        CHECK(record[0] == doctest::Approx(1));
        CHECK(record[1] == doctest::Approx(2.2));
        CHECK(record[2] == doctest::Approx(3));
        // By 0.3 about z after a quarter about z or x.
        const float c = std::cos(0.15f), s = std::sin(0.15f);
        const float expected[4] = {about_z ? 0 : h * c, about_z ? 0 : h * s, about_z ? h * (c + s) : h * s,
                                   about_z ? h * (c - s) : h * c};
        for (int i = 0; i < 4; ++i) CHECK(record[3 + i] == doctest::Approx(expected[i]));
    }
}

TEST_CASE("point wind: outward, nothing in the middle and at the radius, the most in between") {
    const FLangevinPointWind wind{{1, 2, 3}, 10, 5};
    const auto at = [&](float x, float y, float z) {
        const float point[3] = {x, y, z};
        std::array<float, 3> velocity{};
        LangevinPointWind::Add(wind, point, velocity.data());
        return velocity;
    };
    CHECK(at(1, 2, 3) == std::array<float, 3>{0, 0, 0});
    CHECK(at(2, 2, 3)[0] == doctest::Approx(5));
    CHECK(at(1, 2, -6)[2] == doctest::Approx(-5.0 * 0.1 / 0.9));
    CHECK(at(11, 2, 3) == std::array<float, 3>{0, 0, 0});
    CHECK(at(30, 2, 3) == std::array<float, 3>{0, 0, 0});
    CHECK(at(1, -0.25f, 3)[1] < 0);
}
