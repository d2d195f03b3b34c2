// Meshes of needles: the same surface with fewer faces, and the added mass from it.
#include "bake_mesh.h"
#include "baker/mesh/mass_properties.h"
#include "baker/mesh/mesh_check.h"
#include "baker/mesh/simplify.h"
#include "sheet_shapes.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

using namespace lr;
using namespace lr::baker;

namespace {

// A zigzag of this many pleats on 1 m, as long and a twentieth high, its slopes in so many strips each; with a thickness, closed.
Mesh pleats(int count, int strips, double thickness) {
    const int n = 2 * count * strips;
    Mesh mesh;
    const auto height = [&](int i) {
        const int phase = i % (2 * strips);
        return 0.05 * (phase < strips ? phase : 2 * strips - phase) / strips;
    };
    const auto add = [&](int i, double up) {
        for (const double z : {0.0, 1.0}) mesh.vertices.emplace_back(static_cast<double>(i) / n, height(i) + up, z);
    };
    for (int i = 0; i <= n; ++i) add(i, 0.0);
    for (int i = n; thickness > 0.0 && i >= 0; --i) add(i, thickness);
    const auto m = static_cast<uint32_t>(mesh.vertices.size()), steps = static_cast<uint32_t>(n);
    for (uint32_t a = 0; a + 2 < m || (thickness > 0.0 && a < m); a += 2) {
        const uint32_t b = (a + 2) % m;
        mesh.faces.insert(mesh.faces.end(), {{a, b, b + 1}, {a, b + 1, a + 1}});
    }
    for (uint32_t i = 0; thickness > 0.0 && i < steps; ++i) {
        const uint32_t a = 2 * i, b = a + 2, c = m - 4 - a, d = m - 2 - a;
        mesh.faces.insert(mesh.faces.end(), {{a, c, b}, {a, d, c}, {a + 1, b + 1, c + 1}, {a + 1, c + 1, d + 1}});
    }
    return mesh;
}

double area_of(const Mesh& mesh) {
    return compute_sheet_mass_properties(mesh, 1.0).area;
}

Mesh strips(int count, double length) {
    return test::rectangle(length, 1.0, count, 1);
}
} // namespace

TEST_CASE("simplify: strips become few faces, and the surface, its rim and its folds stay where they were") {
    const Mesh flat = simplified(strips(250, 1.0), 1e-4);
    CHECK(flat.faces.size() == 2);
    CHECK(area_of(flat) == doctest::Approx(1.0));
    const Mesh folded = simplified(pleats(5, 20, 0.0), 1e-4);
    CHECK(folded.faces.size() == 20);
    CHECK(area_of(folded) == doctest::Approx(area_of(pleats(5, 1, 0.0))));
    Faults faults;
    Mesh closed = simplified(pleats(5, 20, 1e-3), 1e-5);
    CHECK(closed.faces.size() < 100);
    CHECK(check_and_repair(closed, faults));
    CHECK(compute_mass_properties(closed).volume == doctest::Approx(1e-3));
    // A curved one stays within the distance.
    const Mesh ball = test::icosphere(4), few = simplified(ball, 0.02);
    CHECK(few.faces.size() < ball.faces.size() / 2);
    CHECK(compute_mass_properties(few).volume == doctest::Approx(compute_mass_properties(ball).volume).epsilon(0.03));
}

TEST_CASE("bake: a pleated sheet of needles, open or a thin solid, is solved as that sheet" *
          doctest::test_suite("long")) {
    AssetData broad, open, solid;
    REQUIRE(test::bake_mesh(test::subdivided(pleats(25, 1, 0.0)), broad));
    REQUIRE(test::bake_mesh(pleats(25, 20, 0.0), open));
    REQUIRE(test::bake_mesh(pleats(25, 20, 5e-4), solid));
    CHECK(solid.volume == doctest::Approx(5e-4));
    for (const AssetData* asset : {&open, &solid})
        for (const std::size_t k : {0U, 7U, 21U, 35U}) {
            CHECK(std::abs(asset->added_mass[k] - broad.added_mass[k]) <
                  asset->added_mass_error[k] + broad.added_mass_error[k]);
            CHECK(asset->added_mass_error[k] < 0.35 * broad.added_mass[k]);
        }
}

TEST_CASE("bake: deep pleats too close to each other for their equations lie between those and the hull with the fluid "
          "in it" *
          doctest::test_suite("long")) {
    constexpr double length = 0.5, width = 0.3, height = 0.02;
    Mesh mesh;
    constexpr uint32_t folds = 1000;
    for (uint32_t i = 0; i <= folds; ++i)
        for (const double y : {0.0, width})
            mesh.vertices.emplace_back(length * i / folds, y, i % 2 == 0 ? 0.0 : height);
    for (uint32_t i = 0; i < 2 * folds; i += 2) {
        mesh.faces.push_back({i, i + 2, i + 3});
        mesh.faces.push_back({i, i + 3, i + 1});
    }
    AssetData asset, block;
    REQUIRE(test::bake_mesh(mesh, asset));
    Mesh box = test::box({length, width, height}, {1, 1, 1});
    REQUIRE(test::bake_mesh(box, block));
    // Moved broadside, the fluid between the pleats goes along.
    const double filled = block.added_mass[14] + length * width * height * 0.98;
    CHECK(std::abs(asset.added_mass[14] - filled) < 1.1 * asset.added_mass_error[14]);
    CHECK(asset.added_mass_error[14] < 0.3 * asset.added_mass[14]);
}

TEST_CASE("bake: a rectangle of any number of strips states an error that covers the truth and is small") {
    // 80 x 80 squares and 120 x 60 agree with these within 0.1 %.
    for (const auto& [length, exact] :
         {std::pair(1.0, std::array{0.4543, 0.02003}), {2.0, std::array{1.1884, 0.04453}}})
        for (const int count : {128, 250, 1000}) {
            CAPTURE(length);
            CAPTURE(count);
            AssetData asset;
            REQUIRE(test::bake_mesh(strips(count, length), asset));
            for (const auto& [k, value] : {std::pair(14U, exact[0]), {21U, exact[1]}}) {
                CHECK(std::abs(asset.added_mass[k] - value) < asset.added_mass_error[k] + 1e-3 * value);
                CHECK(asset.added_mass_error[k] < 0.08 * value);
            }
            for (const std::size_t k : {0U, 7U}) CHECK(asset.added_mass[k] <= asset.added_mass_error[k]);
        }
}

namespace {
// Bars of faces as long as themselves: the stated error covers the truth and is small. Under sanitizers each radius takes minutes.
void check_bars(double radius) {
    for (const int sides : {8, 24, 1000}) {
        CAPTURE(sides);
        AssetData asset;
        REQUIRE(test::bake_mesh(test::wheel({{radius, 0.0}, {radius, 1.0}}, sides), asset));
        // Of a regular polygon, by conformal mapping; the ends take less than 3 radii of the length.
        const double n = 1.0 / sides, chord = 2.0 * std::sin(std::numbers::pi * n);
        const double outer = chord * std::tgamma(n) /
                             (std::pow(2.0, 1.0 + 2.0 * n) * std::sqrt(std::numbers::pi) * std::tgamma(0.5 + n));
        const double inside = 0.5 * sides * std::sin(2.0 * std::numbers::pi * n);
        const double across = radius * radius * (2.0 * std::numbers::pi * outer * outer - inside);
        for (const auto& [k, value] : {std::pair(0U, across), {7U, across}, {21U, across / 12.0}}) {
            CHECK(std::abs(asset.added_mass[k] - value) <
                  asset.added_mass_error[k] + (k < 21U ? 3.0 : 9.0) * radius * value);
            CHECK(asset.added_mass_error[k] < 0.15 * value);
        }
    }
}
} // namespace

TEST_CASE("bake: the stated error of bars 50 times as long as thick covers the truth" * doctest::test_suite("long")) {
    check_bars(1e-2);
}
TEST_CASE("bake: the stated error of bars 500 times as long as thick covers the truth" * doctest::test_suite("long")) {
    check_bars(1e-3);
}
TEST_CASE("bake: the stated error of bars 5000 times as long as thick covers the truth" * doctest::test_suite("long")) {
    check_bars(1e-4);
}
