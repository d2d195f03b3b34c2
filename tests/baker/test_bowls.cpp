// Bowls: how hollow they are, and their drag with the tip and with the hollow first.
#include "baker/aerodynamics/hollow.h"
#include "baker/aerodynamics/station_loads.h"
#include "made_stations.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

using namespace lr;
using namespace lr::baker;
using doctest::Approx;
using Eigen::Vector3d;
using std::numbers::pi;
namespace shapes = lr::test;
using shapes::cap, shapes::curled, shapes::made, shapes::Made, shapes::place, shapes::viscosity;

namespace {

// Of radius 1, its tip down, open upwards.
Mesh cone(double half_angle, int rings) {
    Mesh mesh = shapes::disc(rings);
    for (Vector3d& v : mesh.vertices) v.z() = v.head<2>().norm() / std::tan(half_angle * pi / 180.0);
    return mesh;
}
} // namespace

TEST_CASE("stations: bowls know their hollow, whatever their triangles and frame") {
    const auto hollow = [](const Mesh& mesh) { return hollow_of(part_of(mesh), 2.0); };
    CHECK(hollow(shapes::disc(8)).norm() == 0.0);
    CHECK(hollow(cap(0.1, 8)).norm() == 0.0);
    CHECK(hollow(curled(6.2, 16)).norm() < 0.02); // a tube has none
    double before = 0.7;
    for (const double half_angle : {30.0, 45.0, 60.0}) {
        CAPTURE(half_angle);
        const Vector3d coarse = hollow(cone(half_angle, 4)), fine = hollow(cone(half_angle, 16));
        CHECK(fine.z() < -0.1);
        CHECK(fine.head<2>().norm() < 0.01);
        CHECK((coarse - fine).norm() < 0.05 * fine.norm());
        CHECK(fine.norm() < before - 0.1);
        before = fine.norm();
        Mesh other = cone(half_angle, 16);
        const Eigen::Matrix3d turn = shapes::some_rotation();
        shapes::apply(other, turn);
        for (std::size_t i = 0; i < other.faces.size(); i += 2) std::swap(other.faces[i][1], other.faces[i][2]);
        CHECK((hollow(other) - turn * fine).norm() < 0.03 * fine.norm());
    }
}

TEST_CASE("stations: the drag of bowls, their tip and their hollow first") {
    // Hoerner, Fluid-Dynamic Drag, ch. 3: cones with an open base, and half a sphere.
    struct Row {
        const char* name;
        Mesh mesh;
        double tip_first, hollow_first;
    };
    Mesh half_sphere = shapes::disc(12);
    for (Vector3d& v : half_sphere.vertices) {
        const double r = v.head<2>().norm(), t = 0.5 * pi * r;
        v = r > 0.0 ? Vector3d(v.x() / r * std::sin(t), v.y() / r * std::sin(t), 1.0 - std::cos(t)) : Vector3d::Zero();
    }
    for (const Row& r : {Row{"cone of 60 degrees", cone(30.0, 12), 0.50, 1.35},
                         {"of 90", cone(45.0, 12), 0.72, 1.35},
                         {"of 120", cone(60.0, 12), 0.95, 1.3},
                         {"half a sphere", half_sphere, 0.40, 1.40}}) {
        CAPTURE(std::string(r.name));
        const Made m = made(r.mesh, 0.002);
        REQUIRE(m.stations.at.size() >= 4);
        const double speed = 1e4 * viscosity / m.size;
        const auto drag = [&](double direction) {
            const Motion motion{Vector3d(0.0, 0.0, direction * speed), Vector3d::Zero()};
            double sum = 0.0;
            for (StationData s : m.stations.at) {
                s.camber = 0.0; // the kernel has it in attached streams alone
                sum -= loads_of(s, motion, viscosity, m.size)[2];
            }
            return direction * sum / (0.5 * speed * speed * pi);
        };
        CHECK(drag(-1.0) == Approx(r.tip_first).epsilon(0.1).scale(1.0));
        CHECK(drag(1.0) == Approx(r.hollow_first).epsilon(0.1).scale(1.0));
        for (const StationData& s : m.stations.at) // no two walls as one
            CHECK(place(s).head<2>().norm() > 0.2);
    }
}
