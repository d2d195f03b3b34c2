// The coefficients of a fit reach a disc as a bake with them would give it.
#include "tools/lr_fit/coefficients.h"

#include "baker/aerodynamics/mesh_geometry.h"
#include "tools/lr_scorecard/disc_fall.h"
#include "tools/lr_scorecard/measured_bodies.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace lr;
using namespace lr::fit;

namespace {

constexpr double radius = 0.03, thickness = 1e-4;

// As the baker measures it.
shape::AerodynamicGeometry disc_geometry(const lr_aerodynamics& baked) {
    const scorecard::Triangles disc = scorecard::disc_mesh(radius, 16);
    baker::Mesh mesh;
    for (size_t i = 0; i < disc.positions.size(); i += 3) mesh.vertices.emplace_back(&disc.positions[i]);
    for (size_t i = 0; i < disc.indices.size(); i += 3)
        mesh.faces.push_back({disc.indices[i], disc.indices[i + 1], disc.indices[i + 2]});
    std::array<double, 9> axes{};
    std::copy(baked.axes, baked.axes + 9, axes.begin());
    shape::AerodynamicGeometry g = baker::sheet_geometry(mesh, thickness, axes, Eigen::Vector3d::Zero());
    g.volume = thickness * g.area[2];
    return g;
}

void check_same(const lr_aerodynamics& a, const AerodynamicData& b, double tolerance) {
    const auto same = [&](const char* field, const double* values, const double* expected, size_t count, double unit) {
        for (size_t i = 0; i < count; ++i) {
            CAPTURE(field);
            CAPTURE(i);
            CHECK(std::abs(values[i] - expected[i]) <= tolerance * std::abs(expected[i]) + 1e-9 * unit);
        }
    };
#define LR_SAME_VECTOR(name, least, most, power) same(#name, a.name, b.name.data(), 3, std::pow(2.0 * radius, power));
#define LR_SAME_NUMBER(name, least, most, power) same(#name, &a.name, &b.name, 1, std::pow(2.0 * radius, power));
    LR_AERODYNAMIC_VECTORS(LR_SAME_VECTOR)
    LR_AERODYNAMIC_NUMBERS(LR_SAME_NUMBER)
#undef LR_SAME_VECTOR
#undef LR_SAME_NUMBER
}
} // namespace

TEST_CASE("lr_fit: coefficients reach every field of a disc as a bake with them would") {
    const scorecard::Asset disc = scorecard::bake_disc(radius, thickness, scorecard::paper_density, scorecard::Fluid{});
    lr_aerodynamics baked = scorecard::initialised(lr_aerodynamics_init);
    REQUIRE(lr_asset_get_aerodynamics(disc.get(), &baked) == LR_OK);
    const shape::AerodynamicGeometry geometry = disc_geometry(baked);
    check_same(baked, shape::default_aerodynamics(geometry), 1e-6);
    for (const Coefficient& c : fitted_coefficients())
        for (const double part : {0.0, 0.3, 1.0}) {
            PlateCoefficients changed;
            CHECK((changed.*c.member >= c.least && changed.*c.member <= c.most));
            changed.*c.member = c.least + part * (c.most - c.least);
            CAPTURE(c.name);
            // 1 %: the thickness, 1/600 of the diameter, makes the disc a little slender for its drag of spin.
            check_same(rebaked(baked, changed), shape::default_aerodynamics(geometry, changed), 0.01);
        }
}

TEST_CASE("lr_fit: prints what it rounds") {
    PlateCoefficients c;
    c.lift = 2.0123456;
    CHECK(rounded(c).lift == 2.012);
    CHECK(members(c).find("    double lift = 2.012;\n") != std::string::npos);
}
