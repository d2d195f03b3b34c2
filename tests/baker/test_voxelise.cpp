#include "baker/turbulence/voxelise.h"

#include "baker/mesh_shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numeric>
#include <vector>

using namespace lr::baker;
namespace test = lr::test;

namespace {

Mesh shifted(Mesh mesh, const Eigen::Matrix3d& linear, const Eigen::Vector3d& to) {
    test::apply(mesh, linear, to);
    return mesh;
}

// Cells that no path of open faces connects to the corner of the grid.
std::vector<uint8_t> dry_cells(const ClosedFaces& closed, const std::array<uint32_t, 3>& n) {
    const size_t stride[3] = {1, n[0], static_cast<size_t>(n[0]) * n[1]};
    std::vector<uint8_t> dry(stride[2] * n[2], 1);
    std::vector<size_t> front{0};
    dry[0] = 0;
    while (!front.empty()) {
        const size_t c = front.back();
        front.pop_back();
        for (size_t a = 0; a < 3; ++a) {
            const size_t at = c / stride[a] % n[a];
            if (at > 0 && closed[a][c] == 0 && dry[c - stride[a]] != 0) {
                dry[c - stride[a]] = 0;
                front.push_back(c - stride[a]);
            }
            if (at + 1 < n[a] && closed[a][c + stride[a]] == 0 && dry[c + stride[a]] != 0) {
                dry[c + stride[a]] = 0;
                front.push_back(c + stride[a]);
            }
        }
    }
    return dry;
}

size_t sum(const std::vector<uint8_t>& flags) {
    return std::accumulate(flags.begin(), flags.end(), size_t{0});
}

Mesh square_sheet(double y, double z) {
    Mesh mesh;
    mesh.vertices = {{0, -y, -z}, {0, y, -z}, {0, y, z}, {0, -y, z}};
    mesh.faces = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

} // namespace

TEST_CASE("inside a closed surface are the cells whose centres are, whatever the attitude") {
    const std::array<uint32_t, 3> n = {24, 20, 28};
    const GridPoint lengths = {2.4, 2.0, 2.8};
    // Radii and centres at arbitrary places.
    const Eigen::Vector3d centre(1.203, 0.987, 1.411), axes(0.91, 0.52, 0.77);
    for (int turn = 0; turn < 5; ++turn) {
        const Eigen::Matrix3d r =
            Eigen::AngleAxisd(0.61 * turn, Eigen::Vector3d(0.3, 1.0, -0.4).normalized()).toRotationMatrix();
        const Mesh mesh = shifted(test::icosphere(5), r * axes.asDiagonal(), centre);
        const std::vector<uint8_t> dry = dry_cells(voxelise(mesh, n, lengths), n);
        size_t wrong = 0, inside = 0, c = 0;
        for (uint32_t k = 0; k < n[2]; ++k)
            for (uint32_t j = 0; j < n[1]; ++j)
                for (uint32_t i = 0; i < n[0]; ++i, ++c) {
                    const Eigen::Vector3d p = 0.1 * Eigen::Vector3d(i + 0.5, j + 0.5, k + 0.5) - centre;
                    const double level =
                        axes.cwiseInverse().asDiagonal() * (r.transpose() * p) == Eigen::Vector3d::Zero()
                            ? 0.0
                            : (axes.cwiseInverse().asDiagonal() * (r.transpose() * p)).norm();
                    inside += level < 1.0;
                    if (std::abs(level - 1.0) > 2e-3) wrong += (level < 1.0) != (dry[c] != 0);
                }
        CHECK(wrong == 0);
        CHECK(inside > 1000);
    }
}

TEST_CASE("no leak where grid lines pass through vertices, edges and faces: cubes on the grid itself") {
    const std::array<uint32_t, 3> n = {16, 16, 16};
    const GridPoint lengths = {16.0, 16.0, 16.0};
    for (int cuts : {1, 2, 4, 8})
        for (double offset : {0.0, 0.5, 0.25, 1e-12, 0.5 + 1e-12}) {
            const Mesh mesh =
                shifted(test::cube(cuts), 8.0 * Eigen::Matrix3d::Identity(), Eigen::Vector3d::Constant(8.0 + offset));
            const std::vector<uint8_t> dry = dry_cells(voxelise(mesh, n, lengths), n);
            // Centres strictly inside, at most also those on the surface.
            CHECK(dry[0] == 0);
            CHECK(sum(dry) >= 7 * 7 * 7);
            CHECK(sum(dry) <= 9 * 9 * 9);
            for (uint32_t k = 5; k < 11; ++k)
                for (uint32_t j = 5; j < 11; ++j)
                    for (uint32_t i = 5; i < 11; ++i) CHECK(dry[(k * 16 + j) * 16 + i] != 0);
        }
    // A diamond with its corners on centres and its faces through many of them.
    Mesh diamond;
    diamond.vertices = {{6, 0, 0}, {-6, 0, 0}, {0, 6, 0}, {0, -6, 0}, {0, 0, 6}, {0, 0, -6}};
    diamond.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    test::apply(diamond, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Constant(8.5));
    const std::vector<uint8_t> dry = dry_cells(voxelise(diamond, n, lengths), n);
    CHECK(dry[0] == 0);
    for (int k = 0; k < 16; ++k)
        for (int j = 0; j < 16; ++j)
            for (int i = 0; i < 16; ++i)
                if (std::abs(i - 8) + std::abs(j - 8) + std::abs(k - 8) < 6)
                    CHECK(dry[static_cast<size_t>((k * 16 + j) * 16 + i)] != 0);
}

TEST_CASE("a closed shell without thickness holds, at any attitude and on any grid") {
    // The surface alone decides, much finer or coarser than the cells.
    for (int levels : {0, 2, 5})
        for (uint32_t cells : {8u, 17u, 40u}) {
            const std::array<uint32_t, 3> n = {cells, cells, cells};
            const Mesh mesh = shifted(test::icosphere(levels), test::some_rotation(), Eigen::Vector3d::Constant(2.0));
            const std::vector<uint8_t> dry = dry_cells(voxelise(mesh, n, {4.0, 4.0, 4.0}), n);
            CHECK(dry[0] == 0);
            CHECK(dry[(cells / 2 * cells + cells / 2) * cells + cells / 2] != 0);
            const double volume = static_cast<double>(sum(dry)) * std::pow(4.0 / cells, 3);
            CHECK(volume > 1.5);
            CHECK(volume < 5.5);
        }
}

TEST_CASE("an open sheet is one layer of closed faces, whichever way it is wound and however thin a solid it is") {
    const std::array<uint32_t, 3> n = {16, 16, 16};
    const GridPoint lengths = {4.0, 4.0, 4.0};
    const Mesh sheet = shifted(square_sheet(1.0, 0.5), Eigen::Matrix3d::Identity(), {2.0, 2.0, 2.0});
    const ClosedFaces closed = voxelise(sheet, n, lengths);
    CHECK(sum(closed[0]) == 8 * 4);
    CHECK(sum(closed[1]) == 0);
    CHECK(sum(closed[2]) == 0);
    CHECK(sum(dry_cells(closed, n)) == 0);
    Mesh turned = sheet;
    for (Face& f : turned.faces) std::swap(f[1], f[2]);
    CHECK(voxelise(turned, n, lengths) == closed);
    for (double thickness : {1e-2, 1e-6, 1e-12}) {
        const Mesh plate =
            shifted(test::box({thickness, 2.0, 1.0}, {1, 3, 2}), Eigen::Matrix3d::Identity(), {2.0, 2.0, 2.0});
        CHECK(voxelise(plate, n, lengths)[0] == closed[0]);
    }
    // A plane across the whole grid, tilted: nothing passes.
    for (double tilt : {0.0, 0.3, 0.785398163397448, 1.2}) {
        const Eigen::Matrix3d r = Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitZ()).toRotationMatrix() *
                                  Eigen::AngleAxisd(0.5 * tilt, Eigen::Vector3d::UnitY()).toRotationMatrix();
        const Mesh wall = shifted(square_sheet(40.0, 40.0), r, {2.01, 2.02, 2.03});
        const std::vector<uint8_t> dry = dry_cells(voxelise(wall, n, lengths), n);
        const double part = static_cast<double>(sum(dry)) / 4096.0;
        CHECK(part > 0.3);
        CHECK(part < 0.7);
    }
}

TEST_CASE("a symmetric body is closed symmetrically, also where its corners lie on cell centres") {
    for (uint32_t cells : {16u, 17u}) {
        const std::array<uint32_t, 3> n = {cells, cells, cells};
        for (double size : {5.0, 6.0, 4.99}) {
            const Mesh mesh =
                shifted(test::cube(3), size * Eigen::Matrix3d::Identity(), Eigen::Vector3d::Constant(0.5 * cells));
            const double l = cells;
            const std::vector<uint8_t> dry = dry_cells(voxelise(mesh, n, {l, l, l}), n);
            for (uint32_t k = 0; k < cells; ++k)
                for (uint32_t j = 0; j < cells; ++j)
                    for (uint32_t i = 0; i < cells; ++i)
                        REQUIRE(dry[(k * cells + j) * cells + i] ==
                                dry[((cells - 1 - k) * cells + cells - 1 - j) * cells + i]);
        }
    }
}

TEST_CASE("triangles outside the grid close no faces") {
    const std::array<uint32_t, 3> n = {8, 8, 8};
    const Mesh away = shifted(test::cube(2), Eigen::Matrix3d::Identity(), {20.0, 4.0, 4.0});
    for (const std::vector<uint8_t>& faces : voxelise(away, n, {8.0, 8.0, 8.0})) CHECK(sum(faces) == 0);
}
