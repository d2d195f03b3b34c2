// Vertices on edges of faces that do not use them.
#include "baker/mesh/mass_properties.h"
#include "baker/mesh/mesh_check.h"
#include "mesh_shapes.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace lr;
using namespace lr::baker;

TEST_CASE("T-junctions are joined: on a closed body and on a sheet, from either side") {
    // One side of a box in one piece, its neighbours in several.
    Mesh fine = test::box({2, 1, 1}, {4, 3, 2});
    Mesh mesh;
    mesh.vertices = fine.vertices;
    uint32_t corner[2][2] = {};
    for (uint32_t v = 0; v < fine.vertices.size(); ++v)
        for (std::size_t i = 0; i < 2; ++i)
            for (std::size_t j = 0; j < 2; ++j)
                if ((fine.vertices[v] - Eigen::Vector3d(i == 0 ? -1 : 1, j == 0 ? -0.5 : 0.5, 0.5)).norm() < 1e-9)
                    corner[i][j] = v;
    for (const Face& f : fine.faces)
        if (!(fine.vertices[f[0]][2] > 0.49 && fine.vertices[f[1]][2] > 0.49 && fine.vertices[f[2]][2] > 0.49))
            mesh.faces.push_back(f);
    mesh.faces.push_back({corner[0][0], corner[1][0], corner[1][1]});
    mesh.faces.push_back({corner[0][0], corner[1][1], corner[0][1]});
    for (Eigen::Vector3d& v : mesh.vertices) v += 1e-7 * Eigen::Vector3d(std::sin(9 * v[0]), std::cos(7 * v[1]), 0.3);
    Faults faults;
    REQUIRE(check_and_repair(mesh, faults));
    CHECK(compute_mass_properties(mesh).volume == doctest::Approx(2.0).epsilon(1e-6));
    bool told = false;
    for (const Fault& f : faults) told = told || f.id == FaultId::mesh_merged_vertices;
    CHECK(told);

    // A row of cards of different heights
    Mesh cards;
    cards.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}, {2, 0, 0},
                      {2, 1, 0}, {1, 1, 0}, {3, 0, 0}, {3, 2, 0}, {2, 2, 0}};
    cards.faces = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 6}, {4, 7, 8}, {4, 8, 9}};
    faults.clear();
    REQUIRE(check_sheet(cards, faults));
    CHECK(cards.faces.size() == 8);
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].id == FaultId::mesh_merged_vertices);
    double area = 0.0;
    for (const Face& f : cards.faces)
        area +=
            0.5 * (cards.vertices[f[1]] - cards.vertices[f[0]]).cross(cards.vertices[f[2]] - cards.vertices[f[0]])[2];
    CHECK(area == doctest::Approx(5.0));

    // Near vertices that are not on the edge do not close it.
    cards.vertices[6][0] += 1e-4;
    cards.vertices[5][0] -= 1e-4;
    cards.faces = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 6}, {4, 7, 8}, {4, 8, 9}};
    faults.clear();
    REQUIRE(check_sheet(cards, faults));
    CHECK(cards.faces.size() == 6);
}

TEST_CASE("a face that joining cracks makes a copy of others goes") {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 0}};
    mesh.faces = {{0, 1, 2}, {0, 3, 2}, {3, 1, 2}};
    Faults faults;
    REQUIRE(check_sheet(mesh, faults));
    CHECK(mesh.faces.size() == 2);
    CHECK(faults.size() == 2);
}
