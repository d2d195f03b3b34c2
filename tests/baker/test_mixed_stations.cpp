// Stations of bodies of solids and sheets.
#include "bake_mesh.h"
#include "sheet_shapes.h"

#include <Eigen/Geometry>
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

namespace lr::test {
namespace {

using Eigen::Vector3d;

// A toy propeller: two twisted blades of paper on top of a stick of `rings` rings.
baker::Mesh propeller(int rings) {
    baker::Mesh out = patch(12, rings, [](double u, double v) {
        const double angle = 6.283185307179586 * std::fmod(u, 1.0), r = v > 0.0 && v < 1.0 ? 0.002 : 0.0;
        return Vector3d(r * std::cos(angle), r * std::sin(angle), 0.15 * v - 0.15);
    });
    for (const double side : {1.0, -1.0})
        append(out, patch(12, 4, [=](double u, double v) {
                   const double x = 0.004 + 0.07 * u, y = 0.02 * (v - 0.5), pitch = 0.4 - 0.2 * u;
                   return Vector3d(side * x, side * y * std::cos(pitch), y * std::sin(pitch));
               }));
    return out;
}

std::vector<StationData> stations_of(const baker::Mesh& mesh) {
    baker::BakeOptions options;
    options.density = 500.0;
    options.thickness = 0.0005;
    AssetData asset;
    REQUIRE(bake_mesh(mesh, asset, options, nullptr, most_stations));
    return asset.stations;
}
} // namespace

TEST_CASE("stations: blades beside a solid stick count with both sides, however many faces the stick has") {
    const double blades = 2.0 * 0.07 * 0.02; // m^2
    for (const int rings : {4, 80}) {
        CAPTURE(rings);
        double area = 0.0, turning = 0.0;
        int sticks = 0;
        for (const StationData& s : stations_of(propeller(rings))) {
            area += s.plate_drag;
            sticks += s.plate_drag < 1e-9 ? 1 : 0; // a round stick is no plate
            const Vector3d place(s.place[0], s.place[1], s.place[2]), normal(s.axes[6], s.axes[7], s.axes[8]);
            turning += s.plate_drag * normal.z() * place.cross(normal).z();
        }
        CHECK(sticks == 1);
        CHECK(area / (1.17 * blades) > 0.95);
        CHECK(area / (1.17 * blades) < 1.15);
        CHECK(std::abs(turning) > 0.2 * 0.037 * area); // in a stream along it both blades turn it one way
    }
}
} // namespace lr::test
