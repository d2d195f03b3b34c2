// Finer panels on closed surfaces: curved parts stay curved, creases stay creases, the surface stays closed.
#include "baker/added_mass/curved_refinement.h"
#include "baker/added_mass/rim_refinement.h"
#include "baker/added_mass/surface_correction.h"
#include "baker/mesh/mass_properties.h"
#include "baker/mesh/mesh_check.h"
#include "mesh_shapes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace lr;
using namespace lr::baker;

namespace {

constexpr std::size_t no_limit = 100000;

void check_closed(const Mesh& mesh) {
    Mesh copy = mesh;
    Faults faults;
    CHECK(check_and_repair(copy, faults));
    CHECK(faults.empty());
}

// A profile (radius, z) from pole to pole, turned about z in n steps.
Mesh turned(const std::vector<std::pair<double, double>>& profile, int n) {
    Mesh mesh;
    std::vector<uint32_t> first;
    for (const auto& [radius, z] : profile) {
        first.push_back(static_cast<uint32_t>(mesh.vertices.size()));
        for (int i = 0; i < (radius > 0.0 ? n : 1); ++i) {
            const double angle = 2.0 * 3.14159265358979323846 * i / n;
            mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
        }
    }
    const auto at = [&](std::size_t ring, int i) {
        return first[ring] + (profile[ring].first > 0.0 ? static_cast<uint32_t>(i % n) : 0U);
    };
    for (std::size_t ring = 0; ring + 1 < profile.size(); ++ring)
        for (int i = 0; i < n; ++i) {
            if (profile[ring].first > 0.0) mesh.faces.push_back({at(ring, i), at(ring, i + 1), at(ring + 1, i)});
            if (profile[ring + 1].first > 0.0)
                mesh.faces.push_back({at(ring, i + 1), at(ring + 1, i + 1), at(ring + 1, i)});
        }
    return mesh;
}

// A prism of n sides with closed ends.
Mesh prism(int n) {
    return turned({{0.0, -0.5}, {1.0, -0.5}, {1.0, 0.5}, {0.0, 0.5}}, n);
}

// Radius 1/2, straight over the length 1, with half spheres at the ends.
Mesh capsule(int n, int rings) {
    std::vector<std::pair<double, double>> profile{{0.0, -1.0}};
    for (const double end : {-1.0, 1.0})
        for (int i = 1; i <= rings; ++i) {
            const double angle = 0.5 * 3.14159265358979323846 * (end < 0.0 ? i : rings + 1 - i) / rings;
            profile.emplace_back(0.5 * std::sin(angle), end * (0.5 + 0.5 * std::cos(angle)));
        }
    profile.emplace_back(0.0, 1.0);
    return turned(profile, n);
}

} // namespace

TEST_CASE("curved refinement of a coarse sphere comes closer to the sphere, by the fourth power of the panels") {
    double last = 0.0;
    for (const int level : {1, 2}) {
        const Mesh fine = refine_curved(test::icosphere(level), 0.1, no_limit);
        CHECK(fine.faces.size() > 1000);
        check_closed(fine);
        double worst = 0.0;
        for (const Eigen::Vector3d& v : fine.vertices) worst = std::max(worst, std::abs(v.norm() - 1.0));
        CHECK(worst < (level == 1 ? 0.004 : 0.0004));
        if (level == 2) CHECK(worst < 0.15 * last);
        last = worst;
    }
}

TEST_CASE("curved refinement leaves flat faces and straight creases as they are") {
    for (const Mesh& mesh : {test::cube(3), test::box({3, 1, 0.01}, {6, 4, 1})}) {
        const Mesh same = refine_curved(mesh, 0.1, no_limit);
        CHECK(same.faces == mesh.faces);
        CHECK(same.vertices == mesh.vertices);
    }
}

TEST_CASE("curved refinement of a prism of many sides makes it a cylinder: round rims, flat ends, straight sides") {
    const Mesh fine = refine_curved(prism(16), 0.1, no_limit);
    check_closed(fine);
    CHECK(fine.faces.size() > 4 * prism(16).faces.size());
    for (const Eigen::Vector3d& v : fine.vertices) {
        const double radius = std::hypot(v[0], v[1]);
        CHECK(std::abs(v[2]) < 0.5 + 1e-12);
        if (std::abs(v[2]) < 0.499) CHECK(radius == doctest::Approx(1.0).epsilon(1e-3));
        if (radius > 0.99) CHECK(radius == doctest::Approx(1.0).epsilon(1e-3));
    }
    CHECK(compute_mass_properties(fine).volume == doctest::Approx(3.14159265).epsilon(0.006));
    CHECK(compute_mass_properties(prism(16)).volume < 3.07);
}

TEST_CASE("long straight sides stay straight: capsule, cone") {
    const double capsule_volume = 3.14159265358979 * (0.25 + 0.5 / 3.0);
    const Mesh coarse = capsule(16, 4);
    check_closed(coarse);
    const Mesh fine = refine_curved(coarse, 0.1, no_limit);
    check_closed(fine);
    for (const Eigen::Vector3d& v : fine.vertices)
        if (std::abs(v[2]) < 0.45) CHECK(std::hypot(v[0], v[1]) == doctest::Approx(0.5).epsilon(0.03));
    CHECK(compute_mass_properties(coarse).volume < 0.965 * capsule_volume);
    CHECK(compute_mass_properties(fine).volume == doctest::Approx(capsule_volume).epsilon(0.02));
    CHECK(compute_mass_properties(restore_curved_volume(coarse).mesh).volume ==
          doctest::Approx(capsule_volume).epsilon(0.02));

    const Mesh cone = turned({{0.0, 0.0}, {1.0, 0.0}, {0.75, 0.5}, {0.5, 1.0}, {0.25, 1.5}, {0.0, 2.0}}, 24);
    const Mesh round = refine_curved(cone, 0.1, no_limit);
    check_closed(round);
    for (const Eigen::Vector3d& v : round.vertices)
        if (v[2] > 1e-9) CHECK(std::abs(std::hypot(v[0], v[1]) - (1.0 - 0.5 * v[2])) < 0.003);
    CHECK(compute_mass_properties(round).volume == doctest::Approx(3.14159265358979 * 2.0 / 3.0).epsilon(0.005));
}

TEST_CASE("curved refinement keeps within its number of panels") {
    const Mesh mesh = test::icosphere(2);
    CHECK(refine_curved(mesh, 0.01, 1279).faces.size() == 320);
    CHECK(refine_curved(mesh, 0.01, 1280).faces.size() == 1280);
}

TEST_CASE("strips at creases stay on the surface and close it") {
    for (const Mesh& mesh : {test::cube(1), test::cube(3), test::box({1, 1, 0.001}, {8, 8, 1}), prism(6)})
        for (const std::size_t strips : {2U, 4U}) {
            const Mesh fine = refine_solid(mesh, {200, strips});
            CHECK(fine.faces.size() > 200);
            check_closed(fine);
            const MassProperties before = compute_mass_properties(mesh), after = compute_mass_properties(fine);
            CHECK(after.volume == doctest::Approx(before.volume).epsilon(1e-12));
            CHECK(after.area == doctest::Approx(before.area).epsilon(1e-12));
            // as thin as the square of the number of strips, next to the crease
            double smallest = std::numeric_limits<double>::infinity();
            for (const Face& f : fine.faces)
                for (std::size_t k = 0; k < 3; ++k)
                    smallest = std::min(smallest, (fine.vertices[f[k]] - fine.vertices[f[(k + 1) % 3]]).norm());
            CHECK(smallest < 0.6 / static_cast<double>(strips * strips));
        }
    // no crease, no strip
    const Mesh sphere = test::icosphere(2);
    CHECK(refine_solid(sphere, {0, 4}).faces == sphere.faces);
    // a notch is not a crease: the flow is at rest in it
    Mesh notched = test::cube(2);
    for (Eigen::Vector3d& v : notched.vertices)
        if (v[2] > 0.4 && std::abs(v[0]) < 0.1 && std::abs(v[1]) < 0.1) v[2] = 0.0;
    check_closed(refine_solid(notched, {0, 3}));
}

TEST_CASE("refinement does not depend on how the body lies") {
    for (const Mesh& mesh :
         {test::cube(2), test::latitude_longitude({1, 1, 0.1}, 16, 12), test::leaf(8, 3, 0.01, 0.1)}) {
        Mesh turned = mesh;
        test::apply(turned, test::some_rotation());
        const auto refined = [](const Mesh& m) { return refine_solid(refine_curved(m, 0.1, 4000), {800, 3}); };
        const Mesh a = refined(mesh), b = refined(turned);
        CHECK(a.faces == b.faces);
        double worst = 0.0;
        for (std::size_t i = 0; i < std::min(a.vertices.size(), b.vertices.size()); ++i)
            worst = std::max(worst, (test::some_rotation() * a.vertices[i] - b.vertices[i]).norm());
        CHECK(worst < 1e-12);
    }
}
