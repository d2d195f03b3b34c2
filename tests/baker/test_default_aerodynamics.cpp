// Rules from shape measures to coefficients: values for known bodies; and for all bodies finite, continuous, and with the right
// dimension.
#include "asset/closed_forms/aerodynamic_coefficients.h"

#include "asset/asset_file.h"
#include "asset/closed_forms/ellipsoid_formulas.h"
#include "baker/aerodynamics/surface_measures.h"
#include "support/asset_bytes.h"
#include "support/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

using namespace lr;
using namespace lr::shape;
using std::numbers::pi;
using test::Random;

namespace {

AerodynamicGeometry box_geometry(const std::array<double, 3>& side) {
    SurfaceMeasures measures({1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}, std::max({side[0], side[1], side[2]}));
    for (size_t k = 0; k < 3; ++k)
        for (double sign : {-0.5, 0.5}) {
            const size_t i = (k + 1) % 3, j = (k + 2) % 3;
            const auto corner = [&](double u, double v) {
                SurfaceMeasures::Point p{};
                p[k] = sign * side[k], p[i] = u * side[i], p[j] = v * side[j];
                return p;
            };
            measures.add(corner(-0.5, -0.5), corner(0.5, -0.5), corner(0.5, 0.5), 1.0);
            measures.add(corner(-0.5, -0.5), corner(0.5, 0.5), corner(-0.5, 0.5), 1.0);
        }
    AerodynamicGeometry g = measures.geometry();
    g.volume = side[0] * side[1] * side[2];
    g.edges = {1.0, 1.0, 1.0};
    return g;
}

// The drag coefficient along an axis, relative to its silhouette, as the loads combine it.
double drag_coefficient(const AerodynamicData& a, size_t k, double area, double d, double reynolds) {
    const double viscosity = 1.0, speed = reynolds * viscosity / d;
    const double plate = a.broadside[k] == 1.0 ? a.plate_drag : 0.0;
    const double force = 0.5 * (plate + a.drag[k] + a.drag_blunt[k] * reynolds / (reynolds + 8710.0)) * speed * speed +
                         a.drag_layer[k] * std::sqrt(viscosity * speed) * speed + a.drag_stokes[k] * viscosity * speed;
    return force / (0.5 * area * speed * speed);
}

// Clift & Gauvin 1970.
double sphere_drag_curve(double re) {
    return 24.0 / re * (1.0 + 0.15 * std::pow(re, 0.687)) + 0.42 / (1.0 + 42500.0 * std::pow(re, -1.16));
}

struct Field {
    const char* name;
    double* (*in)(AerodynamicData&);
    size_t size;
    double power; // of the length
    bool positive;

    double of(AerodynamicData a, size_t k) const { return in(a)[k]; }
};
std::vector<Field> all_fields() {
#define LR_VECTOR(name, least, most, power)                                                                            \
    {#name, [](AerodynamicData& a) { return a.name.data(); }, 3, power, (least) >= 0.0},
#define LR_NUMBER(name, least, most, power)                                                                            \
    {#name, [](AerodynamicData& a) { return &a.name; }, 1, power, (least) >= 0.0},
    std::vector<Field> all = {LR_AERODYNAMIC_VECTORS(LR_VECTOR) LR_AERODYNAMIC_NUMBERS(LR_NUMBER)};
#undef LR_VECTOR
#undef LR_NUMBER
    for (Field& f : all) // their limits do not depend on the body
        if (std::string(f.name) == "length" || std::string(f.name) == "wake_length") f.power = 1.0;
    return all;
}
const std::vector<Field> fields = all_fields();

// The largest difference over the fields, each in its power of the largest extent. The stall angle and the length of the wake matter in products with
// the flatness only, and jump where a body has none.
double distance(const AerodynamicData& a, const AerodynamicData& b) {
    double most = 0.0;
    for (const Field& f : fields) {
        if (std::string(f.name) == "plate_stall" || std::string(f.name) == "wake_length") continue;
        for (size_t k = 0; k < f.size; ++k)
            most = std::max(most, std::abs(f.of(a, k) - f.of(b, k)) / std::pow(a.length, f.power));
    }
    return most;
}

std::array<double, 3> random_size(Random& random, double flattest) {
    return {random.logarithmic(flattest, 1.0), random.logarithmic(flattest, 1.0), random.logarithmic(flattest, 1.0)};
}

} // namespace

TEST_CASE("a sphere follows the standard drag curve within 8 %, from creep to the drag crisis") {
    const double a = 0.01;
    const AerodynamicData c = default_aerodynamics(ellipsoid_geometry({a, a, a}));
    for (double re = 0.1; re <= 2e5; re *= 1.2)
        for (size_t k = 0; k < 3; ++k) {
            CAPTURE(re);
            CHECK(drag_coefficient(c, k, pi * a * a, 2.0 * a, re) ==
                  doctest::Approx(sphere_drag_curve(re)).epsilon(0.08));
        }
    for (size_t k = 0; k < 3; ++k) {
        CHECK(c.lift[k] == 0.0);
        // A Magnus force with C_L 0.8 times the rim's speed over the stream's.
        CHECK(c.spin_lift[k] == doctest::Approx(0.5 * 0.8 * pi * a * a * a));
    }
}

// Couple C_M rho w^2 a^5/2, Re = w a^2/nu: creeping flow, then 6.45/Re^(1/2) + 32.1/Re (Sawatzki 1970). In a stream, Froessling's layer.
TEST_CASE("friction slows a sphere that spins, at rest and in a stream") {
    const double a = 0.02, nu = 1.5e-5;
    const AerodynamicData c = default_aerodynamics(ellipsoid_geometry({a, a, a}));
    const auto couple = [&](double w, double s) {
        return w * (c.spin_drag[0] * w + c.spin_drag_stream[0] * s +
                    c.spin_drag_layer[0] * std::sqrt(nu * (s + w * a)) + c.spin_drag_stokes[0] * nu);
    };
    for (double re = 0.1; re <= 2e4; re *= 1.3) {
        CAPTURE(re);
        const double w = re * nu / (a * a);
        const double measured = std::max(16.0 * pi / re, 6.45 / std::sqrt(re) + 32.1 / re);
        CHECK(couple(w, 0.0) == doctest::Approx(measured * 0.5 * w * w * std::pow(a, 5)).epsilon(0.36));
    }
    // The layer's friction and that of creeping flow.
    const double s = 3.0, layer = 2.0 * a / (0.552 * std::sqrt(s * 2.0 * a / nu)), w = 0.1;
    CHECK(couple(w, s) ==
          doctest::Approx(w * nu * 8.0 * pi * (std::pow(a, 4) / (3.0 * layer) + a * a * a)).epsilon(0.01));
}

TEST_CASE("blunt and flat bodies have their measured drag in a steady stream") {
    PlateCoefficients steady;
    steady.drag = 1.17;
    // Hoerner, Fluid-Dynamic Drag, ch. 3: disc 1.17, cube 1.05, long cylinder across 1.2, long strip 1.98.
    const auto coefficient = [&](const AerodynamicGeometry& g, size_t k) {
        const double d = std::max({g.extent[0], g.extent[1], g.extent[2]});
        return drag_coefficient(default_aerodynamics(g, steady), k, g.area[k], d, 3e4);
    };
    CHECK(coefficient(ellipsoid_geometry({0.05, 0.05, 1e-5}), 2) == doctest::Approx(1.17).epsilon(0.1));
    CHECK(coefficient(box_geometry({0.05, 0.05, 0.05}), 0) == doctest::Approx(1.05).epsilon(0.15));
    CHECK(coefficient(ellipsoid_geometry({1.0, 0.001, 0.001}), 1) == doctest::Approx(1.2).epsilon(0.15));
    CHECK(coefficient(box_geometry({1.0, 0.003, 1e-5}), 2) == doctest::Approx(1.98).epsilon(0.1));
    // No edge, hence no separation that depends on the layer; Blasius friction on both sides edge on.
    const AerodynamicData plate = default_aerodynamics(box_geometry({0.1, 0.1, 1e-6}), steady);
    CHECK(plate.drag_blunt[2] == 0.0);
    CHECK(plate.drag_layer[0] == doctest::Approx(0.664 * 2.0 * 0.01 / std::sqrt(0.1)).epsilon(0.01));
}

TEST_CASE("a plate is lifted away from its thin direction, and by spin about its length") {
    const double length = 0.2, chord = 0.02, thin = 1e-5;
    const AerodynamicGeometry g = box_geometry({length, chord, thin});
    const AerodynamicData c = default_aerodynamics(g);
    const PlateCoefficients plate;
    // Helmbold's slope of a wing, over that of a disc. A stream along the chord (axis 1) has the length as its span.
    const auto slope = [](double aspect) { return aspect / (2.0 + std::sqrt(aspect * aspect + 4.0)); };
    const double disc_aspect = 4.0 / pi, area = length * chord;
    CHECK(c.plate_lift[1] == doctest::Approx(plate.lift * area * slope(10.0) / slope(disc_aspect)).epsilon(2e-3));
    CHECK(c.plate_lift[0] == doctest::Approx(plate.lift * area * slope(0.1) / slope(disc_aspect)).epsilon(2e-3));
    CHECK((c.plate_lift[2] == 0.0 && c.plate_vortex[2] == 0.0));
    for (size_t k = 0; k < 3; ++k) CHECK(std::abs(c.lift[k]) < 1e-3 * c.plate_lift[1]);
    // A disc has the numbers of the fit; a long strip stalls earlier along its chord.
    const AerodynamicData disc = default_aerodynamics(ellipsoid_geometry({0.05, 0.05, 1e-6}));
    const double round = pi * 0.0025;
    for (size_t k = 0; k < 2; ++k) {
        CHECK(disc.plate_lift[k] == doctest::Approx(plate.lift * round).epsilon(1e-3));
        CHECK(disc.plate_vortex[k] == doctest::Approx(plate.vortex * round).epsilon(1e-3));
        CHECK(disc.plate_stall[k] == doctest::Approx(plate.stall).epsilon(1e-3));
    }
    CHECK(disc.plate_drag == doctest::Approx(plate.drag * round).epsilon(1e-3));
    CHECK(disc.wake_length == doctest::Approx(0.1).epsilon(1e-3));
    CHECK(disc.shedding_moment == doctest::Approx(plate.moment * round * 0.1).epsilon(1e-3));
    CHECK(c.plate_stall[1] < 0.1 * plate.stall + 0.09);
    CHECK(c.wake_length == doctest::Approx(4.0 / pi * chord).epsilon(1e-3));
    // A bar half as thick as wide is half a sheet; the other half has a bar's lift.
    const double deep = 0.5 * chord, width = (2.0 * chord + deep) / 3.0;
    const AerodynamicData bar = default_aerodynamics(box_geometry({length, chord, deep}));
    CHECK(bar.lift[0] ==
          doctest::Approx(0.5 * 1.2 * length * (chord - deep) * length / (length + 1.68 * width)).epsilon(1e-2));
    CHECK(bar.lift[1] < 0.0); // k = 1: i = 2 thin, j = 0
    CHECK(bar.plate_lift[1] == doctest::Approx(0.5 * c.plate_lift[1]).epsilon(1e-2));
    CHECK(c.spin_lift[0] ==
          doctest::Approx(0.5 * plate.rotation * length * chord * chord * 10.0 / (10.0 + plate.rotation_span))
              .epsilon(1e-2));
    CHECK(c.spin_lift[0] / (0.5 * length * chord * chord) > c.spin_lift[1] / (0.5 * chord * length * length));
    CHECK(c.length == doctest::Approx(plate.correlation * length));
    CHECK(c.broadside[2] == 1.0);
}

// A long spheroid that falls tumbled for ever, by a circulation that only edges make.
TEST_CASE("rods and round bodies make no circulation by turning end over end, and the stream damps it") {
    for (const double slender : {0.5, 0.1, 0.01}) {
        const AerodynamicGeometry g = ellipsoid_geometry({1.0, slender, slender});
        const AerodynamicData c = default_aerodynamics(g);
        CHECK(c.spin_lift[1] <= 0.5 * g.volume);
        CHECK(c.spin_drag_stream[1] == doctest::Approx(1.1 * g.stroke2[1]));
        CHECK(c.spin_drag_stream[0] == 0.0);
    }
}

// The rest vanishes for bodies that are not flat: a cube, a sphere and a rod have steady loads only.
TEST_CASE("only plates have what free flight adds") {
    PlateCoefficients other;
    other.drag = 5.0, other.lift = 7.0, other.vortex = 6.0, other.stall = 0.9;
    other.separated_shedding = 0.3;
    other.moment = 0.5, other.rate_moment = -0.5;
    const AerodynamicGeometry blunt[] = {ellipsoid_geometry({1.0, 1.0, 1.0}), box_geometry({1.0, 1.0, 1.0}),
                                         ellipsoid_geometry({1.0, 0.01, 0.01})};
    for (const AerodynamicGeometry& g : blunt)
        CHECK(distance(default_aerodynamics(g), default_aerodynamics(g, other)) == 0.0);
    const AerodynamicGeometry plate = box_geometry({1.0, 1.0, 1e-3});
    CHECK(distance(default_aerodynamics(plate), default_aerodynamics(plate, other)) > 0.1);
}

TEST_CASE("coefficients of random shapes are finite, scale with their dimension and turn with the axes") {
    Random random(51);
    for (int round = 0; round < 200; ++round) {
        const std::array<double, 3> size = random_size(random, 1e-4);
        const double s = random.logarithmic(1e-4, 1e3);
        const auto make = [&](const std::array<double, 3>& a) {
            return default_aerodynamics(round % 2 == 0 ? box_geometry(a) : ellipsoid_geometry(a));
        };
        const AerodynamicData c = make(size), large = make({s * size[0], s * size[1], s * size[2]}),
                              turned = make({size[2], size[0], size[1]});
        REQUIRE(wrong_in(c) == nullptr);
        for (const Field& f : fields)
            for (size_t k = 0; k < f.size; ++k) {
                CAPTURE(f.name);
                const double value = f.of(c, k);
                REQUIRE(std::isfinite(value));
                if (f.positive) REQUIRE(value >= 0.0);
                const double unit = std::pow(c.length, f.power);
                CHECK(std::abs(f.of(large, k) / std::pow(s, f.power) - value) <= 1e-6 * std::abs(value) + 1e-12 * unit);
                CHECK(std::abs(f.of(turned, (k + 1) % f.size) - value) <= 1e-6 * std::abs(value) + 1e-12 * unit);
            }
    }
}

TEST_CASE("coefficients change little when the shape does") {
    Random random(52);
    for (int round = 0; round < 200; ++round) {
        std::array<double, 3> from = random_size(random, 1e-3), to = random_size(random, 1e-3);
        if (round % 4 == 0) from = {1.0, 1.0, 1.0}; // through the sphere and the cube
        if (round % 4 == 1) from[1] = from[0];      // through bodies of revolution
        if (round % 4 == 2) from[2] = 1e-6;         // from plates
        const bool box = round % 2 == 0;
        const auto at = [&](double t) {
            std::array<double, 3> a{};
            for (size_t i = 0; i < 3; ++i) a[i] = from[i] * std::pow(to[i] / from[i], t);
            return default_aerodynamics(box ? box_geometry(a) : ellipsoid_geometry(a));
        };
        // A jump would stay as large for any step.
        for (double t : {-1e-7, 0.0, 0.3}) {
            const AerodynamicData here = at(t);
            CHECK(distance(here, at(t + 1e-7)) < 1e-4);
            CHECK(distance(here, at(t + 1e-9)) < 1e-6);
        }
    }
}

TEST_CASE("a box of vanishing thickness tends to the plate without any") {
    const AerodynamicData flat = default_aerodynamics(box_geometry({0.1, 0.06, 0.0}));
    for (const Field& f : fields)
        for (size_t k = 0; k < f.size; ++k) REQUIRE(std::isfinite(f.of(flat, k)));
    for (double thin : {1e-4, 1e-6, 1e-8})
        CHECK(distance(flat, default_aerodynamics(box_geometry({0.1, 0.06, 0.1 * thin}))) < 30.0 * thin);
}
