// Parts of a body with streams of their own: partition, camber, and how well they stand for many strips.
#include "asset/asset_file.h"
#include "baker/added_mass/added_mass.h"
#include "baker/aerodynamics/camber.h"
#include "baker/aerodynamics/local_thickness.h"
#include "baker/aerodynamics/outline_parts.h"
#include "baker/aerodynamics/station_loads.h"
#include "baker/aerodynamics/stations.h"
#include "baker/asset_report.h"
#include "baker/bake.h"
#include "baker/json.h"
#include "made_stations.h"
#include "support/reference_aerodynamics.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

using namespace lr;
using namespace lr::baker;
using doctest::Approx;
using Eigen::Vector3d;
using std::numbers::pi;
namespace shapes = lr::test;
using shapes::cap, shapes::curled, shapes::made, shapes::Made, shapes::place, shapes::row, shapes::viscosity;

namespace {

Mesh asset(const std::string& name) {
    Mesh mesh;
    Faults faults;
    REQUIRE(read_mesh(LR_ASSET_SOURCES "/" + name, 1.0, mesh, faults));
    return mesh;
}

// A wing with a rounded tip, its span along x; root at 0.
Mesh wing(int nu, int nv) {
    return shapes::patch(nu, nv, [](double u, double v) {
        const double chord = 0.012 * (0.5 + u * (2.2 - 2.2 * u));
        return Vector3d(0.045 * u, chord * (0.3 - v), 0.0);
    });
}

Mesh ring(double hole, int n) {
    Mesh mesh = shapes::patch(6 * n, n, [=](double u, double v) {
        const double r = hole + (1.0 - hole) * v, t = 2.0 * pi * u;
        return Vector3d(r * std::cos(t), r * std::sin(t), 0.0);
    });
    join_near_vertices(mesh, 1e-9);
    return mesh;
}

Mesh star(int arms, double length, double width) {
    Mesh out;
    const double inner = 0.5 * width / std::tan(pi / arms);
    for (int i = 0; i < arms; ++i) {
        const double t = 2.0 * pi * i / arms;
        const Vector3d d(std::cos(t), std::sin(t), 0.0), n(-0.5 * width * d.y(), 0.5 * width * d.x(), 0.0);
        const auto at = static_cast<uint32_t>(out.vertices.size());
        out.vertices.insert(out.vertices.end(), {Vector3d(0, 0, 0), Vector3d(inner * d - n), Vector3d(inner * d + n),
                                                 Vector3d(length * d - n), Vector3d(length * d + n)});
        out.faces.insert(out.faces.end(), {{at, at + 1, at + 2}, {at + 1, at + 3, at + 4}, {at + 1, at + 4, at + 2}});
    }
    join_near_vertices(out, 1e-9);
    return out;
}

// A flat wing of 6 to 1 with its centre of mass near one end.
Mesh bar() {
    return shapes::rectangle(6.0, 1.0, 6, 2);
}
const Vector3d bar_weight(-2.5, 0.0, 0.0);

std::vector<Wrench> sums(const std::vector<StationData>& stations, double size) {
    std::vector<Wrench> out;
    for (const Motion& m : test_motions(1e4 * viscosity / size, size)) {
        Wrench sum = Wrench::Zero();
        for (const StationData& s : stations) sum += loads_of(s, m, viscosity, size);
        out.push_back(sum);
    }
    return out;
}

double area_of(const std::vector<Part>& parts) {
    double area = 0.0;
    for (const Part& p : parts) area += moments_of(p).area;
    return area;
}
} // namespace

TEST_CASE("stations: flat compact sheets and thick bodies have none") {
    Mesh ellipse = shapes::disc(12);
    for (Vector3d& v : ellipse.vertices) v.y() *= 0.4;
    for (const Mesh& sheet : {shapes::disc(8), shapes::rectangle(1, 1, 4, 4), shapes::rectangle(5, 1, 10, 2), ellipse})
        CHECK(made(sheet, 0.005).stations.at.empty());
    for (const char* name : {"confetti.obj", "paper.obj", "ellipsoid_leaf.obj", "ellipsoid_rubber.obj"})
        CHECK(made(asset(name), 0.0).stations.at.empty());
    for (const Mesh& solid : {shapes::icosphere(2), shapes::ellipsoid(10, 10, 1, 3), shapes::ellipsoid(1, 1, 20, 3)}) {
        const Stations s = made(solid, 0.0).stations;
        CHECK(s.at.empty());
        CHECK(s.fit == StationFit::one);
    }
}

TEST_CASE("stations: a wing whose weight is at one end has a few strips, which stand for many") {
    const Made whole = made(bar(), 0.01, &bar_weight);
    REQUIRE(whole.stations.at.size() >= 2);
    CHECK(whole.stations.at.size() <= 4);
    CHECK(whole.stations.error <= 0.08);
    CHECK(whole.stations.error_one > 0.15);
    // Forty strips of eight pieces, made without the partition.
    std::vector<StationData> strips;
    const int n = 40, rows = 8;
    for (int i = 0; i < n * rows; ++i) {
        const Vector3d middle(6.0 * (i / rows + 0.5) / n - 3.0, (i % rows + 0.5) / rows - 0.5, 0.0);
        const Mesh strip = shapes::rectangle(6.0 / n, 1.0 / rows, 1, 1);
        shape::AerodynamicGeometry g = sheet_geometry(strip, 1e-6, {0, 1, 0, -1, 0, 0, 0, 0, 1}, Vector3d::Zero());
        StationData s = shape::default_station(g, {6.0, 1.0, 6.0});
        const Vector3d at = middle - bar_weight;
        s.place = {at.x(), at.y(), at.z()};
        s.spin_lift[1] = s.spin_drag[1] = s.spin_drag_stream[1] = 0.0; // it is in the velocities of the pieces
        // Creeping flow is a property of the whole; of no weight at this Reynolds number.
        s.drag_stokes = {};
        strips.push_back(s);
    }
    const double size = whole.size;
    std::vector<StationData> chosen = whole.stations.at;
    for (StationData& s : chosen) s.drag_stokes = s.spin_drag_stokes = {};
    const double error = difference(sums(chosen, size), sums(strips, size));
    CHECK(error < whole.stations.error + 0.02);
    CHECK(error > 1e-4);
    // Area: the drag broadside is that of the area and the wing's aspect.
    double drag = 0.0, one = 0.0;
    for (const StationData& s : chosen) drag += s.plate_drag;
    for (const StationData& s : strips) one += s.plate_drag;
    CHECK(drag == Approx(one).epsilon(1e-4));
    // Axes: chord across the span, right-handed.
    for (const StationData& s : chosen) {
        CHECK(std::abs(row(s, 1).x()) == Approx(1.0));
        CHECK(row(s, 2).cross(row(s, 0)).dot(row(s, 1)) == Approx(1.0));
        CHECK(s.camber == Approx(0.0));
    }
}

TEST_CASE("stations: the wing behind a weight is cut along its chord too, whatever its triangles") {
    const Vector3d balanced(-0.6, 0.0, 0.0);
    for (const int n : {1, 4}) {
        const Mesh wing = shapes::rectangle(6.0, 1.0, 6 * n, 2 * n);
        const auto in_row = [](double side) { return [=](const StationData& s) { return side * s.place[1] > 0.1; }; };
        const std::vector<StationData> seed = made(wing, 0.01, &bar_weight).stations.at;
        for (const double side : {1.0, -1.0}) {
            CHECK(std::count_if(seed.begin(), seed.end(), in_row(side)) == 2);
            const std::vector<StationData> strip = made(wing, 0.01, &balanced).stations.at;
            CHECK(strip.size() >= 2);
            CHECK(std::none_of(strip.begin(), strip.end(), in_row(side)));
        }
    }
}

TEST_CASE("stations: slices are Gauss's rule for the area") {
    const Part strip = part_of(shapes::rectangle(2.0, 1.0, 3, 1));
    const std::vector<Slice> three = Slicer(strip, Vector3d::UnitX()).sliced(3);
    REQUIRE(three.size() == 3);
    CHECK(three[0].node == Approx(-std::sqrt(0.6)).epsilon(2e-3));
    CHECK(std::abs(three[1].node) < 1e-3);
    CHECK(moments_of(three[0].part).area == Approx(5.0 / 9.0).epsilon(0.03));
    // A triangle's area along its height: polynomials up to degree 2 n - 1 = 3.
    Mesh triangle;
    triangle.vertices = {{0, -1, 0}, {0, 1, 0}, {1, 0, 0}};
    triangle.faces = {{0, 1, 2}};
    const std::vector<Slice> two = Slicer(part_of(triangle), Vector3d::UnitX()).sliced(2);
    REQUIRE(two.size() == 2);
    double sums[4] = {};
    for (const Slice& s : two) {
        const double area = moments_of(s.part).area;
        for (int k = 0; k < 4; ++k) sums[k] += area * std::pow(s.node, k);
    }
    for (int k = 0; k < 4; ++k) CHECK(sums[k] == Approx(2.0 / ((k + 1) * (k + 2))).epsilon(0.03));
}

TEST_CASE("stations: parts keep all of the area") {
    const Part dart = part_of(asset("paper_plane_surface.obj"));
    const double area = moments_of(dart).area;
    const std::vector<Part> groups = split_by_normal(dart, 4);
    REQUIRE(groups.size() == 2); // wings, keel
    CHECK(area_of(groups) == Approx(area).epsilon(1e-9));
    const Vector3d keel = common_normal(moments_of(groups[1]), Vector3d::UnitY());
    CHECK(keel.y() == Approx(1.0).epsilon(0.01));
    for (const int arms : {4, 6}) {
        const Part flat = part_of(star(arms, 3.0, 0.6));
        const std::vector<Part> parts = split_by_outline(flat, Vector3d::UnitZ(), 8);
        CHECK(parts.size() == static_cast<std::size_t>(arms));
        CHECK(area_of(parts) == Approx(moments_of(flat).area).epsilon(1e-9));
        for (const Part& p : parts) CHECK(moments_of(p).area == Approx(moments_of(flat).area / arms).epsilon(0.01));
    }
    for (const Slice& s : Slicer(dart, Vector3d(1, 2, 0.5).normalized()).sliced(5)) CHECK(!s.part.empty());
    CHECK(moments_of(refined(dart, 0.003)).area == Approx(area).epsilon(1e-9));
}

TEST_CASE("stations: bent, pierced and crossed sheets have some, and the error is less than with one") {
    struct Row {
        const char* name;
        Mesh mesh;
        double error;
    };
    const Row rows[] = {{"shallow cap", cap(0.05, 12), 0.085},
                        {"cap", cap(0.1, 12), 0.105},
                        {"leaf curled a little", curled(0.6, 8), 0.075},
                        {"leaf curled", curled(1.5, 8), 0.12},
                        {"ring", ring(0.5, 6), 0.075},
                        {"thin ring", ring(0.8, 6), 0.15},
                        {"cross", star(4, 2.5, 1.0), 0.03},
                        {"snow crystal", star(6, 3.0, 0.5), 0.17}};
    for (const Row& r : rows) {
        CAPTURE(std::string(r.name));
        const Made m = made(r.mesh, 0.005);
        CHECK(m.stations.at.size() >= 2);
        CHECK(m.stations.at.size() <= most_stations);
        CHECK(m.stations.fit == StationFit::fits);
        CHECK(m.stations.error < r.error);
        CHECK(m.stations.error_one > 0.3);
    }
    CHECK(made(ring(0.2, 8), 0.005).stations.at.empty()); // a small hole changes little
    // Arms alike are cut alike.
    const std::vector<StationData> cross = made(star(4, 2.5, 1.0), 0.005).stations.at;
    for (const StationData& s : cross) {
        const Vector3d turned(-place(s).y(), place(s).x(), 0.0);
        CHECK(std::any_of(cross.begin(), cross.end(), [&](const StationData& o) {
            return (place(o) - turned).norm() < 0.05 && std::abs(o.plate_drag - s.plate_drag) < 0.03 * s.plate_drag;
        }));
    }
}

TEST_CASE("stations: a dart has wings and a keel, the same as a sheet and as a solid") {
    const Made sheet = made(asset("paper_plane_surface.obj"), 1e-4), solid = made(asset("paper_plane.obj"), 0.0);
    for (const Made* m : {&sheet, &solid}) {
        REQUIRE(m->stations.at.size() > 3);
        CHECK(m->stations.error < 0.115);
        std::size_t keel = 0;
        for (const StationData& s : m->stations.at) {
            if (std::abs(row(s, 2).y()) > 0.9) {
                ++keel;
                continue;
            }
            CHECK(row(s, 2).z() > 0.9);
            CHECK(row(s, 0).x() > 0.99); // its weight is ahead
            // The other wing's.
            const auto mirrored = [&](const StationData& o) {
                const Vector3d p = place(o), q = place(s);
                return (Vector3d(p.x(), -p.y(), p.z()) - q).norm() < 0.01 * m->size &&
                       std::abs(o.plate_drag - s.plate_drag) < 0.03 * s.plate_drag;
            };
            CHECK(std::any_of(m->stations.at.begin(), m->stations.at.end(), mirrored));
        }
        CHECK(keel >= 1);
    }
}

TEST_CASE("stations: the rim of a plate of even thickness is neither a wall nor a lump, in any frame") {
    const std::array<double, 5> across{0, 0, 1, 1, 0}, up{0, 1, 1, 0, 0};
    for (const double thickness : {0.7, 1.5, 3.0}) {
        Mesh washer = shapes::patch(48, 4, [&](double u, double v) {
            const auto corner = static_cast<std::size_t>(std::lround(4.0 * v));
            const double r = 10.0 - 4.75 * across[corner], t = 2.0 * pi * u;
            return Vector3d(r * std::cos(t), r * std::sin(t), thickness * up[corner]);
        });
        join_near_vertices(washer, 1e-9);
        for (const Eigen::Matrix3d& turn : {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), shapes::some_rotation()}) {
            Mesh turned = washer;
            shapes::apply(turned, turn);
            const Made m = made(turned, 0.0);
            CHECK(m.stations.at.size() == 6);
            CHECK(m.stations.error < 0.1);
            for (const StationData& s : m.stations.at) CHECK(std::abs(row(s, 2).dot(turn * Vector3d::UnitZ())) > 0.99);
        }
    }
}

TEST_CASE("stations: neither triangles nor the frame matter") {
    const Vector3d weight(0.008, -0.002, 0.0);
    const Made coarse = made(wing(8, 1), 2e-4, &weight), fine = made(wing(48, 9), 2e-4, &weight);
    const Eigen::Matrix3d turn = shapes::some_rotation();
    Mesh turned_mesh = wing(48, 9);
    shapes::apply(turned_mesh, turn);
    const Vector3d turned_weight = turn * weight;
    const Made turned = made(turned_mesh, 2e-4, &turned_weight);
    REQUIRE(fine.stations.at.size() >= 2);
    REQUIRE(coarse.stations.at.size() == fine.stations.at.size());
    REQUIRE(turned.stations.at.size() == fine.stations.at.size());
    for (const StationData& s : fine.stations.at) {
        const auto near = [&](const Made& other, const Eigen::Matrix3d& by, double close) {
            return std::any_of(other.stations.at.begin(), other.stations.at.end(), [&](const StationData& o) {
                return (place(o) - by * place(s)).norm() < close * fine.size &&
                       std::abs(row(o, 0).dot(by * row(s, 0))) > 0.999 &&
                       std::abs(o.plate_lift[0] - s.plate_lift[0]) < 3.0 * close * s.plate_lift[0];
            });
        };
        CHECK(near(coarse, Eigen::Matrix3d::Identity(), 0.02));
        CHECK(near(turned, turn, 0.005));
    }
}

TEST_CASE("stations: the nut of a winged seed is a part of its own") {
    const auto solid = [](const Mesh& mesh) { return part_of(mesh, mesh.faces.size()); };
    // Nut and wing: ellipsoids, one in another.
    const Mesh nut = shapes::ellipsoid(0.004, 0.003, 0.002, 3);
    Mesh blade = shapes::ellipsoid(0.022, 0.006, 0.0001, 4);
    shapes::apply(blade, Eigen::Matrix3d::Identity(), {0.0262, 0.0, 0.0});
    const Part whole = solid(shapes::joined(nut, blade));
    const auto [lump, rest] = split_lump(whole, 0.052);
    REQUIRE(!lump.empty());
    const PartMoments m = moments_of(lump);
    CHECK(m.area == Approx(moments_of(solid(nut)).area).epsilon(0.1));
    CHECK(m.centroid.norm() < 0.0005);
    CHECK(m.area + moments_of(rest).area == Approx(moments_of(whole).area).epsilon(1e-9));
    // A wing alone, and a leaf of even thickness, have none.
    CHECK(split_lump(solid(blade), 0.044).first.empty());
    CHECK(split_lump(solid(asset("leaf.obj")), 0.07).first.empty());
    const Vector3d weight(0.003, 0.0, 0.0);
    const Made seed = made(shapes::joined(nut, blade), 0.0, &weight);
    REQUIRE(seed.stations.at.size() >= 3);
    CHECK(seed.stations.error < 0.08);
    CHECK(place(seed.stations.at[0]).x() == Approx(-0.003).epsilon(0.1));
}

TEST_CASE("stations: camber of a flap and of an arc are those of thin aerofoils") {
    // Hinged at nine tenths of the chord, six degrees up: (Glauert 1927) zero lift at delta (pi - h + sin h)/pi, cos h = 1 - 2 0.9.
    const double up = std::tan(6.0 * pi / 180.0), hinge = std::acos(-0.8);
    const auto section = [](int n, const std::function<double(double)>& height) {
        return part_of(shapes::patch(n, 2, [&](double u, double v) { return Vector3d(-u, 2.0 * v - 1.0, height(u)); }));
    };
    const auto of = [](const Part& part, const Vector3d& chord) {
        return camber_of(part, Vector3d(-0.5, 0.0, 0.0), chord, Vector3d::UnitZ());
    };
    const Part flap = section(10, [&](double x) { return std::max(0.0, x - 0.9) * up; });
    const double zero_lift = up * (pi - hinge + std::sin(hinge)) / pi;
    CHECK(of(flap, Vector3d::UnitX()) == Approx(-zero_lift).epsilon(0.01));
    // With the other edge ahead it does little.
    CHECK(std::abs(of(flap, -Vector3d::UnitX())) < 0.3 * zero_lift);
    const double h = 0.04;
    CHECK(of(section(64, [=](double x) { return 4.0 * h * x * (1.0 - x); }), Vector3d::UnitX()) ==
          Approx(2.0 * h).epsilon(0.01));
    // A tilted flat plate has incidence only.
    CHECK(of(section(3, [](double x) { return -0.1 * x; }), Vector3d::UnitX()) == Approx(0.1).epsilon(0.01));
}

TEST_CASE("stations: the couple of a flap is in the added mass") {
    // About mid-chord a thin aerofoil's couple at no incidence is pi/2 A_0 + pi/4 A_2 (times rho/2 U^2 c^2), and Munk's is that of the coupling
    // A_13 = A_33 1/pi int slope (1 - cos 2t) dt: the same number.
    const double up = std::tan(6.0 * pi / 180.0), hinge = std::acos(-0.8), span = 8.0;
    const Mesh mesh = shapes::patch(shapes::sanitized ? 16 : 40, shapes::sanitized ? 8 : 24, [=](double u, double v) {
        const double x = u < 0.75 ? 1.2 * u : 0.9 + 0.4 * (u - 0.75);
        return Vector3d(-x, span * (v - 0.5), std::max(0.0, x - 0.9) * up);
    });
    AddedMass added;
    Faults faults;
    REQUIRE(compute_sheet_added_mass(mesh, Vector3d::Zero(), Refinement{}, added, faults, {}));
    const double expected = up / pi * (pi - hinge + 0.5 * std::sin(2.0 * hinge));
    CHECK(added.value(0, 2) / added.value(2, 2) == Approx(expected).epsilon(0.03));
}

TEST_CASE("stations: one station bears what the whole body does") {
    const Made m = made(shapes::rectangle(1.0, 0.6, 4, 4), 0.01);
    ::test::ReferenceLoads reference;
#define LR_SAME(name, ...) std::copy(m.loads.name.begin(), m.loads.name.end(), reference.at.name);
    LR_AERODYNAMIC_VECTORS(LR_SAME)
    LR_SAME(axes)
#undef LR_SAME
    reference.at.plate_drag = m.loads.plate_drag;
    reference.at.wake_length = m.loads.wake_length;
    reference.density = 1.0;
    reference.viscosity = viscosity;
    reference.length = m.size;
    const Vector3d arm(0.1, 0.2, -0.05);
    reference.arm = {arm.x(), arm.y(), arm.z()};
    Vector3d lift;
    const StationData station = as_station(m.loads, arm, lift);
    for (const Motion& motion : test_motions(0.3, m.size)) {
        const Vector3d &v = motion.velocity, &w = motion.spin;
        reference.lag =
            reference.along_axes({v.x() + w.cross(arm).x(), v.y() + w.cross(arm).y(), v.z() + w.cross(arm).z()});
        const auto expected = reference({v.x(), v.y(), v.z()}, {w.x(), w.y(), w.z()});
        const Wrench got = loads_of(station, motion, viscosity, m.size, &lift);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto at = static_cast<Eigen::Index>(k);
            CHECK(got[at] == Approx(expected.force[k]).epsilon(1e-6).scale(0.01));
            CHECK(got[at + 3] == Approx(expected.torque[k]).epsilon(1e-6).scale(0.01));
        }
    }
}

TEST_CASE("stations: added mass is that of the body, broadside") {
    Made m = made(asset("paper_plane_surface.obj"), 1e-4);
    std::array<double, 36> added{};
    added[14] = 3e-5;
    share_added_mass(m.loads, added, m.stations.at);
    double sum = 0.0;
    for (const StationData& s : m.stations.at) {
        CHECK(s.separated_shedding > 0.0);
        sum += s.separated_shedding / 0.8 * row(s, 2).z() * row(s, 2).z();
    }
    CHECK(sum == Approx(3e-5).epsilon(1e-3));
}

TEST_CASE("stations: added mass where all stand edgewise stays of the body's size") {
    Made m = made(asset("paper_plane_surface.obj"), 1e-4);
    for (StationData& s : m.stations.at) {
        // Their normal along the body's widest axis but one: the share that moves broadside is nothing.
        const std::array<double, 9> axes = s.axes;
        for (std::size_t k = 0; k < 3; ++k) {
            s.axes[k] = axes[6 + k];
            s.axes[6 + k] = axes[k];
        }
    }
    std::array<double, 36> added{};
    added[14] = 3e-5;
    share_added_mass(m.loads, added, m.stations.at);
    double sum = 0.0;
    for (const StationData& s : m.stations.at) {
        CHECK(s.separated_shedding >= 0.0);
        for (const double arm : s.lift_arm) CHECK(std::isfinite(arm));
        sum += s.separated_shedding / 0.8;
    }
    CHECK(sum > 0.0);
    CHECK(sum <= 3e-5 / 0.05 * 1.001);
}

TEST_CASE("stations: what no sum of parts describes is said") {
    const Made tube = made(curled(6.2, 16), 0.005);
    CHECK(tube.stations.at.empty());
    CHECK(tube.stations.fit == StationFit::hidden);
    CHECK(made(cap(0.3, 12), 0.005).stations.fit != StationFit::hidden);
    // Nearly a hemisphere.
    CHECK(made(cap(0.45, 12), 0.005).stations.fit == StationFit::coarse);
}

TEST_CASE("stations: a bake has them in its asset and its report") {
    const Mesh mesh = ring(0.6, 4);
    std::vector<double> positions;
    std::vector<uint32_t> indices;
    for (const Vector3d& v : mesh.vertices) positions.insert(positions.end(), {0.02 * v.x(), 0.02 * v.y(), 0.0});
    for (const Face& f : mesh.faces) indices.insert(indices.end(), f.begin(), f.end());
    BakeOptions options;
    options.mesh_arrays = MeshArrays{positions, indices};
    options.mesh_path = "ring";
    options.unit = Unit::m;
    options.sheet = SheetOptions{1e-4, std::nullopt};
    options.cells = {8, 8, 8};
    AssetData made_asset;
    Faults faults;
    StationErrors errors;
    BakeHooks hooks;
    hooks.station_errors = &errors;
    REQUIRE(bake(options, made_asset, faults, nullptr, {}, hooks));
    REQUIRE(made_asset.stations.size() >= 4);
    double added = 0.0;
    for (const StationData& s : made_asset.stations) added += s.separated_shedding / 0.8;
    CHECK(added == Approx(made_asset.added_mass[14]).epsilon(1e-6));
    CHECK(errors.with_stations > 0.0);
    CHECK(errors.with_stations < errors.without);
    const auto j = lr::test::Json::parse(report_json(made_asset, faults, {}, errors));
    CHECK(j["stations"].size() == made_asset.stations.size());
    CHECK(j["station_errors"]["with_stations"].number() == Approx(errors.with_stations));
    const std::vector<uint8_t> bytes = write_asset(made_asset);
    AssetData read;
    REQUIRE(read_asset(bytes.data(), bytes.size(), read, faults));
    CHECK(read.stations.size() == made_asset.stations.size());
    CHECK(made_asset.provenance.options.find("--stations") == std::string::npos);

    // Fewer when they are asked for.
    for (const uint32_t most : {1u, 2u, 3u, 4u, 7u}) {
        CAPTURE(most);
        options.stations = most;
        AssetData limited;
        Faults found;
        REQUIRE(bake(options, limited, found, nullptr, {}, hooks));
        CHECK(limited.stations.size() <= (most == 1 ? 0 : most));
        CHECK(limited.provenance.options.find(" --stations " + std::to_string(most)) != std::string::npos);
        CHECK(limited.provenance.input_hash != made_asset.provenance.input_hash);
    }
    for (const uint32_t wrong : {0u, 9u}) {
        options.stations = wrong;
        AssetData none;
        Faults found;
        CHECK_FALSE(bake(options, none, found, nullptr, {}, hooks));
        REQUIRE(found.size() == 1);
        CHECK(found[0].id == FaultId::parameter_out_of_range);
        CHECK(found[0].where == "stations");
    }
}

TEST_CASE("stations: never more than are asked for, whatever the parts") {
    for (const char* name : {"paper_plane_surface.obj", "petal.obj"})
        for (std::size_t most = 2; most <= most_stations; ++most) {
            const Made m = made(asset(name), name[1] == 'a' ? 1e-4 : 0.0, nullptr, most);
            CAPTURE(std::string(name));
            CAPTURE(most);
            CHECK(m.stations.at.size() <= most);
            CHECK((!m.stations.at.empty() || m.stations.fit == StationFit::coarse));
        }
    for (std::size_t most = 2; most <= 6; ++most) {
        const Made m = made(star(6, 3.0, 0.5), 0.005, nullptr, most);
        CHECK(m.stations.at.size() <= most);
    }
}
