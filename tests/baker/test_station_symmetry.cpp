// Parts and strips follow the shape's own symmetry, neither its triangles nor its frame.
#include "baker/aerodynamics/station_loads.h"
#include "baker/aerodynamics/stations.h"
#include "made_stations.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace lr;
using namespace lr::baker;
using doctest::Approx;
using Eigen::Vector3d;
using std::numbers::pi;
namespace shapes = lr::test;
using shapes::made, shapes::Made, shapes::place, shapes::viscosity;

TEST_CASE("stations: the blades of a paper helicopter are cut alike") {
    Mesh mesh = shapes::patch(2, 8, [](double u, double v) { return Vector3d(0.02 * (u - 0.5), 0.0, -0.1 * v); });
    for (const double side : {1.0, -1.0})
        mesh = shapes::joined(std::move(mesh), shapes::patch(8, 2, [&](double u, double v) {
                                  return Vector3d(side * 0.025 * v, side * 0.085 * u, 0.03 * u);
                              }));
    const Vector3d weight(0.0, 0.0, -0.05);
    const Made m = made(mesh, 2e-4, &weight);
    REQUIRE(m.stations.at.size() >= 4);
    for (const StationData& s : m.stations.at)
        CHECK(std::any_of(m.stations.at.begin(), m.stations.at.end(), [&](const StationData& o) {
            return (Vector3d(-place(o).x(), -place(o).y(), place(o).z()) - place(s)).norm() < 0.01 * m.size &&
                   std::abs(o.plate_drag - s.plate_drag) < 0.03 * s.plate_drag;
        }));
}

TEST_CASE("stations: a part of 3 to 1 is cut alike in each frame") {
    Mesh mesh = shapes::patch(6, 18, [](double u, double v) { return Vector3d(0.03 * (u - 0.5), 0.0, -0.09 * v); });
    for (const double side : {1.0, -1.0})
        mesh = shapes::joined(std::move(mesh), shapes::patch(16, 5, [&](double u, double v) {
                                  return Vector3d(side * 0.025 * v, side * 0.085 * u, 0.02 * u);
                              }));
    for (int i = 0; i < 16; ++i) {
        Mesh turned = mesh;
        shapes::apply(turned, Eigen::AngleAxisd(0.1 * i, Vector3d(1.0, 0.5 * i, 2.0).normalized()).toRotationMatrix());
        CHECK(made(turned, 1e-4).stations.at.size() == 6);
    }
}

TEST_CASE("stations: blossoms are cut along a mirror line, so that they have no preferred sense of spin" *
          doctest::test_suite("long")) {
    const double turn = 0.2; // of the mirror line from the body's axis
    for (const int petals : {3, 4, 5, 6})
        for (const auto& [waist, cup] : {std::pair{0.5, 0.25}, {0.9, 0.25}, {0.9, 0.0}}) {
            Mesh mesh = shapes::disc(24);
            for (Vector3d& v : mesh.vertices) {
                const double radius = v.head<2>().norm(), angle = std::atan2(v.y(), v.x());
                const double r = 0.015 * radius * (1.0 - waist * std::pow(std::sin(0.5 * petals * angle), 2.0));
                v = {r * std::cos(angle + turn), r * std::sin(angle + turn), cup * r * r / 0.015};
            }
            const Made m = made(mesh, 2e-4);
            INFO(petals << " petals, waist " << waist << ", cup " << cup);
            REQUIRE(m.stations.at.size() >= 3);
            const auto image = [&](const Vector3d& p) {
                const double c = std::cos(2.0 * turn), s = std::sin(2.0 * turn);
                return Vector3d(c * p.x() + s * p.y(), s * p.x() - c * p.y(), p.z());
            };
            // Of all mirror lines of such a blossom the cuts may follow any: the images are turned by whole petals.
            const auto symmetric_about = [&](int k) {
                const double c = std::cos(2.0 * std::numbers::pi * k / petals),
                             s = std::sin(2.0 * std::numbers::pi * k / petals);
                return std::all_of(m.stations.at.begin(), m.stations.at.end(), [&](const StationData& a) {
                    const Vector3d p = image(place(a));
                    const Vector3d turned(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z());
                    return std::any_of(m.stations.at.begin(), m.stations.at.end(), [&](const StationData& b) {
                        return (turned - place(b)).norm() < 0.015 * m.size &&
                               std::abs(a.plate_drag - b.plate_drag) < 0.03 * a.plate_drag;
                    });
                });
            };
            bool symmetric = false;
            for (int k = 0; k < petals; ++k) symmetric = symmetric || symmetric_about(k);
            CHECK(symmetric);
        }
}

TEST_CASE("stations: a saddle is cut along a line in which it is its own mirror image, not along a diagonal") {
    const double turn = 0.7;
    const Mesh mesh = shapes::patch(24, 24, [&](double u, double v) {
        const double x = 0.04 * (u - 0.5), y = 0.04 * (v - 0.5), c = std::cos(turn), s = std::sin(turn);
        return Vector3d(c * x - s * y, s * x + c * y, 10.0 * (x * x - y * y));
    });
    const Made m = made(mesh, 2e-4);
    REQUIRE(m.stations.at.size() >= 2);
    // A stream along the normal turns no side to it more than another: along a diagonal the strips are the blades of a propeller.
    Vector3d moment = Vector3d::Zero();
    double largest = 0.0;
    for (const StationData& s : m.stations.at) {
        const Wrench w = loads_of(s, {{0.0, 0.0, 1.0}, Vector3d::Zero()}, viscosity, m.size);
        moment += w.tail<3>();
        largest = std::max(largest, w.head<3>().norm() * m.size);
    }
    CHECK(std::abs(moment.z()) < 1e-3 * largest);
}

TEST_CASE("stations: the halves of a folded card are cut alike, though their triangles are not") {
    const Made m = made(shapes::patch(24, 24,
                                      [](double u, double v) {
                                          const double x = 0.06 * (u - 0.5);
                                          return Vector3d(x, 0.1 * (v - 0.5), 0.4 * std::abs(x));
                                      }),
                        2e-4);
    REQUIRE(m.stations.at.size() >= 4);
    for (const StationData& s : m.stations.at)
        CHECK(std::any_of(m.stations.at.begin(), m.stations.at.end(), [&](const StationData& o) {
            return (Vector3d(-place(o).x(), place(o).y(), place(o).z()) - place(s)).norm() < 1e-3 * m.size &&
                   std::abs(o.plate_drag - s.plate_drag) < 1e-3 * s.plate_drag;
        }));
}

TEST_CASE(
    "stations: in streams along the span lift of long strips acts at their places, behind the weight farther aft") {
    for (const double width : {0.1, 0.0125}) {
        const Made m = made(shapes::patch(4, 24,
                                          [&](double u, double v) {
                                              const double y = 0.1 * (v - 0.5);
                                              return Vector3d(width * (u - 0.5), y, 4.0 * y * y);
                                          }),
                            2e-4);
        REQUIRE(m.stations.at.size() >= 2);
        for (const StationData& s : m.stations.at) {
            CHECK((s.lift_arm[1] != 0.0) == (width > 0.05));
            CHECK(s.lift_arm[0] != 0.0);
        }
    }
    // A blade as of an ash seed, whose weight parts it, and one behind its weight, as of a maple's.
    const Mesh nut = shapes::ellipsoid(0.006, 0.0015, 0.001, 3);
    Mesh blade = shapes::ellipsoid(0.018, 0.0035, 0.00008, 4);
    for (const double ahead : {0.004, 0.017}) {
        CAPTURE(ahead);
        Mesh moved = blade;
        shapes::apply(moved, Eigen::Matrix3d::Identity(), {ahead, 0.0, 0.0});
        const Vector3d weight(0.0, 0.0, 0.0);
        const Made seed = made(shapes::joined(nut, moved), 0.0, &weight);
        REQUIRE(seed.stations.at.size() >= 3);
        for (size_t i = 1; i < seed.stations.at.size(); ++i) // the nut is the first
            CHECK((seed.stations.at[i].lift_arm[1] < -0.001) == (ahead > 0.01));
    }
}

TEST_CASE("stations: both ends of a strip that is bent like a bow are cut alike, and are no walls") {
    const Made m = made(shapes::patch(4, 48,
                                      [](double u, double v) {
                                          const double y = 0.1 * (v - 0.5);
                                          return Vector3d(0.1 / 12.0 * (u - 0.5), y, 8.0 * y * y);
                                      }),
                        2e-4);
    REQUIRE(m.stations.at.size() >= 2);
    for (const StationData& s : m.stations.at)
        CHECK(std::any_of(m.stations.at.begin(), m.stations.at.end(), [&](const StationData& o) {
            return (Vector3d(place(o).x(), -place(o).y(), place(o).z()) - place(s)).norm() < 1e-3 * m.size &&
                   std::abs(o.plate_drag - s.plate_drag) < 1e-3 * s.plate_drag;
        }));
}
