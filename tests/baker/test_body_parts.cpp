// Meshes as artists make them: parts told apart and repaired, and bodies of solids and sheets against closed forms.
#include "bake_mesh.h"
#include "baker/added_mass/mixed_added_mass.h"
#include "baker/bake_added_mass.h"
#include "baker/mass_mesh.h"
#include "baker/mesh/body_parts.h"
#include "baker/mesh/solid_region.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace lr;
using namespace lr::baker;

namespace {

using Vector = Eigen::Vector3d;

// A box of n squares along each edge, outward.
Mesh box(const Vector& low, const Vector& high, int n = 1) {
    Mesh mesh;
    const auto square = [&](int axis, double side) {
        const auto first = static_cast<uint32_t>(mesh.vertices.size());
        const int a = (axis + 1) % 3, b = (axis + 2) % 3;
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i) {
                Vector v;
                v[axis] = side > 0.0 ? high[axis] : low[axis];
                v[a] = low[a] + (high[a] - low[a]) * i / n;
                v[b] = low[b] + (high[b] - low[b]) * j / n;
                mesh.vertices.push_back(v);
            }
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                const auto p = first + static_cast<uint32_t>(j * (n + 1) + i), q = p + static_cast<uint32_t>(n) + 1;
                mesh.faces.push_back({p, p + 1, q + 1});
                mesh.faces.push_back({p, q + 1, q});
                if (side < 0.0)
                    for (std::size_t k = 1; k <= 2; ++k)
                        std::swap(mesh.faces[mesh.faces.size() - k][1], mesh.faces[mesh.faces.size() - k][2]);
            }
    };
    for (const int axis : {0, 1, 2})
        for (const double side : {-1.0, 1.0}) square(axis, side);
    join_identical_vertices(mesh);
    return mesh;
}

void add(Mesh& to, const Mesh& from) {
    const auto first = static_cast<uint32_t>(to.vertices.size());
    to.vertices.insert(to.vertices.end(), from.vertices.begin(), from.vertices.end());
    for (const Face& f : from.faces) to.faces.push_back({f[0] + first, f[1] + first, f[2] + first});
}

// In the plane x = 0, from (y0, z0) to (y1, z1).
Mesh fin(double y0, double z0, double y1, double z1, int n = 1) {
    Mesh mesh;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) mesh.vertices.emplace_back(0.0, y0 + (y1 - y0) * i / n, z0 + (z1 - z0) * j / n);
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const auto p = static_cast<uint32_t>(j * (n + 1) + i), q = p + static_cast<uint32_t>(n) + 1;
            mesh.faces.push_back({p, p + 1, q + 1});
            mesh.faces.push_back({p, q + 1, q});
        }
    return mesh;
}

BodyParts parts_of(Mesh mesh, Faults& faults, OpenParts open = OpenParts::sheets) {
    BodyParts parts;
    REQUIRE(find_parts(mesh, parts, faults, open));
    return parts;
}

double volume_of(const BodyParts& parts) {
    return compute_mass_properties({parts.mesh.vertices, parts.solids(), {}}).volume;
}

bool baked(const Mesh& mesh, AssetData& out, bool strict = false, Faults* told = nullptr) {
    BakeOptions options;
    options.strict = strict;
    return test::bake_mesh(mesh, out, options, told);
}

void turn_inside_out(Mesh& mesh) {
    for (Face& f : mesh.faces) std::swap(f[1], f[2]);
}
} // namespace

TEST_CASE("parts: mixed winding, a face without area and second copies leave a solid of the same volume") {
    Mesh mesh = box({0, 0, 0}, {1, 2, 3}, 3);
    for (std::size_t i = 0; i < mesh.faces.size(); i += 3) std::swap(mesh.faces[i][1], mesh.faces[i][2]);
    mesh.faces.push_back(mesh.faces[5]);
    mesh.faces.push_back({0, 1, 2}); // on one line
    Faults faults;
    const BodyParts parts = parts_of(mesh, faults);
    CHECK(parts.clean);
    CHECK_FALSE(parts.has_sheets());
    CHECK(volume_of(parts) == doctest::Approx(6.0));
    const auto has = [&](FaultId id) {
        return std::any_of(faults.begin(), faults.end(), [&](const Fault& f) { return f.id == id; });
    };
    CHECK(has(FaultId::mesh_degenerate_face));
    CHECK(has(FaultId::mesh_duplicate_face));
    CHECK(has(FaultId::mesh_inconsistent_winding));
}

TEST_CASE("parts: a small hole is closed, a missing side is not") {
    Faults faults;
    Mesh small = box({0, 0, 0}, {1, 1, 1}, 10);
    small.faces.erase(small.faces.begin() + 40, small.faces.begin() + 42);
    const BodyParts closed = parts_of(small, faults);
    CHECK_FALSE(closed.has_sheets());
    CHECK(volume_of(closed) == doctest::Approx(1.0));
    Mesh crate = box({0, 0, 0}, {1, 1, 1}, 1);
    crate.faces.resize(10);
    const BodyParts open = parts_of(crate, faults);
    CHECK(open.solid_faces == 0);
    CHECK(open.mesh.faces.size() == 10);
    Mesh rock = box({0, 0, 0}, {1, 1, 1}, 2); // one of 24 squares, 4 %: no vessel has such a mouth
    rock.faces.resize(46);
    CHECK(volume_of(parts_of(rock, faults)) == doctest::Approx(1.0));
    Mesh tall = box({0, 0, 0}, {1, 1, 3}, 1); // a carton without its lid, 8 %
    tall.faces.resize(10);
    CHECK(parts_of(tall, faults).solid_faces == 0);
    Mesh leaf = fin(2, 2, 3, 3, 4); // bent
    for (Vector& v : leaf.vertices) v.x() += 0.5 * (v.y() - 2.0) * (v.y() - 2.0);
    add(tall, leaf);
    faults.clear();
    const BodyParts trunk = parts_of(tall, faults, OpenParts::filled);
    CHECK(std::none_of(faults.begin(), faults.end(),
                       [](const Fault& f) { return f.id == FaultId::mesh_inconsistent_winding; }));
    CHECK(volume_of(trunk) == doctest::Approx(3.0));
    CHECK(trunk.sheets().size() == leaf.faces.size());
}

TEST_CASE("parts: a fin that hangs on a box, a wall between boxes") {
    Faults faults;
    Mesh mesh = box({-1, -1, -1}, {1, 1, 1}, 2);
    add(mesh, fin(1, -1, 3, 1, 2)); // along the line of vertices x = 0 on the side y = 1
    join_identical_vertices(mesh);
    const BodyParts finned = parts_of(mesh, faults);
    CHECK(finned.solid_faces == 48);
    CHECK(finned.sheets().size() == 8);
    Mesh two = box({0, 0, 0}, {1, 1, 1});
    add(two, box({1, 0, 0}, {2, 1, 1}));
    join_identical_vertices(two);
    faults.clear();
    const BodyParts joined = parts_of(two, faults);
    CHECK(volume_of(joined) == doctest::Approx(2.0));
    CHECK(joined.clean);
    CHECK_FALSE(joined.has_sheets());
    CHECK(std::none_of(faults.begin(), faults.end(), [](const Fault& f) { return f.id == FaultId::mesh_open_edge; }));
}

TEST_CASE("region: solids that cross count once, in volume, centroid and inertia") {
    Mesh mesh = box({0, 0, 0}, {2, 1, 1});
    add(mesh, box({1, 0.2, 0.2}, {3, 0.8, 0.8}));
    const SolidRegion region(mesh, mesh.faces);
    const RegionMoments m = region.moments(compute_mass_properties(mesh));
    const double volume = 2.0 + 0.36;
    CHECK(m.volume == doctest::Approx(volume).epsilon(0.005));
    CHECK(m.first.x() == doctest::Approx(2.0 * 1.0 + 0.36 * 2.5).epsilon(0.005));
    CHECK(m.second(0, 0) == doctest::Approx(8.0 / 3.0 + 0.36 * (27.0 - 8.0) / 3.0).epsilon(0.005));
    CHECK(region.contains({2.5, 0.5, 0.5}));
    CHECK(region.contains({1.5, 0.5, 0.5}));
    CHECK_FALSE(region.contains({2.5, 0.1, 0.5}));
}

TEST_CASE("region: a ball of slanting needles, found by bins, is the sum of its tetrahedra") {
    // Spikes on an octahedron, wound outward: from the middle each face is seen once, so that a point is inside if it is in one of the tetrahedra.
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {0.1, -0.1}) mesh.vertices.push_back(side * Vector::Unit(axis));
    for (const Face& f : {Face{0, 2, 4}, Face{2, 1, 4}, Face{1, 3, 4}, Face{3, 0, 4}, Face{2, 0, 5}, Face{1, 2, 5},
                          Face{3, 1, 5}, Face{0, 3, 5}}) {
        const auto tip = static_cast<uint32_t>(mesh.vertices.size());
        mesh.vertices.emplace_back(10.0 * (mesh.vertices[f[0]] + mesh.vertices[f[1]] + 0.7 * mesh.vertices[f[2]]));
        for (std::size_t k = 0; k < 3; ++k) mesh.faces.push_back({f[k], f[(k + 1) % 3], tip});
    }
    const SolidRegion region(mesh, mesh.faces);
    std::size_t inside = 0;
    for (int i = 0; i < 20000; ++i) {
        const double r = 2.0 * i / 20000.0, a = 2.399963 * i, z = std::sin(0.7548777 * i);
        const Vector point = r * Vector(std::cos(a) * std::sqrt(1.0 - z * z), std::sin(a) * std::sqrt(1.0 - z * z), z);
        bool expected = false;
        for (const Face& f : mesh.faces) {
            Eigen::Matrix3d corners;
            for (int k = 0; k < 3; ++k) corners.col(k) = mesh.vertices[f[static_cast<std::size_t>(k)]];
            const Vector share = corners.inverse() * point;
            expected = expected || (share.minCoeff() >= 0.0 && share.sum() <= 1.0);
        }
        inside += expected;
        CHECK(region.contains(point) == expected);
    }
    CHECK(inside > 50);
}

TEST_CASE("region: the fluid in a cube and in a rod that turn") {
    // A fluid in a square prism that turns about its axis has a^4/6 less the torsion constant, 0.1406 a^4, per length.
    const auto trapped = [](const Mesh& mesh) {
        return trapped_fluid_inertia(SolidRegion(mesh, mesh.faces), Vector::Zero(),
                                     compute_mass_properties(mesh).inertia);
    };
    const Mesh rod = box({-0.5, -0.5, -5}, {0.5, 0.5, 5}, 2);
    const Eigen::Matrix3d inertia = trapped(rod);
    CHECK(inertia(0, 0) == doctest::Approx(10.0 * (100.0 / 12.0)).epsilon(0.05)); // about a cross axis: nearly frozen
    CHECK(inertia(2, 2) < 0.05 * inertia(0, 0));
    const Mesh prism = box({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, 2);
    const Eigen::Matrix3d cube = trapped(prism);
    CHECK(cube(2, 2) == doctest::Approx(1.0 / 6.0 - 0.1406).epsilon(0.03)); // each layer as in the prism
}

TEST_CASE("mixed added mass: three cubes in an L, solved as a shell, are the solid") {
    Mesh mesh = box({0, 0, 0}, {1, 1, 1}, 5);
    add(mesh, box({1, 0, 0}, {2, 1, 1}, 5));
    add(mesh, box({0, 1, 0}, {1, 2, 1}, 5));
    join_identical_vertices(mesh);
    Faults faults;
    const BodyParts parts = parts_of(mesh, faults);
    REQUIRE(parts.clean);
    const Vector centre(5.0 / 6, 5.0 / 6, 0.5);
    AddedMass shell, solid;
    REQUIRE(compute_mixed_added_mass(parts, centre, shell, faults));
    REQUIRE(compute_added_mass(parts.mesh, centre, solid, faults));
    for (Eigen::Index k = 0; k < 6; ++k)
        CHECK(shell.value(k, k) == doctest::Approx(solid.value(k, k)).epsilon(k < 3 ? 0.02 : 0.15));
}

TEST_CASE("mixed added mass: a book, whose parts touch without common vertices, is nearly its hull") {
    Mesh mesh = box({0.002, 0.003, 0.002}, {0.147, 0.217, 0.022}), block = box({0, 0, 0}, {0.15, 0.22, 0.024});
    add(mesh, box({0, 0, 0}, {0.15, 0.22, 0.002}));
    add(mesh, box({0, 0, 0.022}, {0.15, 0.22, 0.024}));
    Faults faults;
    const Vector centre(0.075, 0.11, 0.012);
    AddedMass book, whole;
    REQUIRE(compute_mixed_added_mass(parts_of(mesh, faults), centre, book, faults));
    REQUIRE(compute_added_mass(block, centre, whole, faults));
    for (Eigen::Index k = 0; k < 6; ++k) {
        CHECK(book.value(k, k) == doctest::Approx(whole.value(k, k)).epsilon(0.01));
        CHECK(book.error(k, k) > 0.03 * whole.value(k, k)); // it has notches, 5 % of the volume
    }
}

TEST_CASE("mixed added mass: a vane with a quill through it moves no less fluid than the vane alone") {
    constexpr int n = 24; // rows of 1/12 m: two lie within the quill
    const Mesh vane = fin(-1, 0, 1, 10, n);
    Mesh feather = vane;
    add(feather, box({-0.09, -0.09, -2}, {0.09, 0.09, 10.5}, 8));
    Faults faults;
    BodyParts parts = parts_of(feather, faults);
    const std::vector<Face> outside = outer_skin(parts).sheets();
    CHECK(outside.size() == 2 * n * (n - 2));
    parts.covered = covered_sheets(parts, outside);
    CHECK(parts.covered.size() == 2 * n * 2);
    parts.mesh.faces.resize(parts.solid_faces);
    parts.mesh.faces.insert(parts.mesh.faces.end(), outside.begin(), outside.end());
    AddedMass whole, of_vane;
    const Vector centre(0, 0, 5);
    REQUIRE(compute_mixed_added_mass(parts, centre, whole, faults));
    REQUIRE(compute_sheet_added_mass(vane, centre, {}, of_vane, faults));
    const double displaced = 0.18 * 0.18 * 12.5;
    CHECK(whole.value(0, 0) + displaced > 0.999 * of_vane.value(0, 0));
    CHECK(whole.value(0, 0) < 1.03 * of_vane.value(0, 0));
}

TEST_CASE("mixed added mass: where no surface can be solved the convex hull is, with an error of half" *
          doctest::test_suite("long")) {
    // Three needles along the axes: as sheets they have no area, and on a coarser surface nothing is left of them.
    BodyParts parts;
    for (int axis = 0; axis < 3; ++axis) {
        const auto first = static_cast<uint32_t>(parts.mesh.vertices.size());
        const Vector along = Vector::Unit(axis), across = 1e-200 * Vector::Unit((axis + 1) % 3);
        for (const Vector& v : {Vector(-along), along, Vector(along + across)}) parts.mesh.vertices.push_back(v);
        parts.mesh.faces.push_back({first, first + 1, first + 2});
    }
    AddedMass m, hull;
    Faults faults;
    REQUIRE(compute_mixed_added_mass(parts, Vector::Zero(), m, faults));
    REQUIRE(!faults.empty());
    CHECK(faults.back().severity == Severity::warning);
    CHECK(faults.back().what.find("convex hull") != std::string::npos);
    Mesh octahedron;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {1.0, -1.0}) octahedron.vertices.push_back(side * Vector::Unit(axis));
    octahedron.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    REQUIRE(compute_added_mass(octahedron, Vector::Zero(), hull, faults));
    for (int k = 0; k < 6; ++k) {
        CHECK(m.value(k, k) == doctest::Approx(hull.value(k, k)).epsilon(1e-3));
        CHECK(m.error(k, k) > 0.5 * m.value(k, k));
    }
    // An error as large is told, not only stored.
    AddedMassOptions hasty;
    hasty.patient = false;
    faults.clear();
    REQUIRE(solve_added_mass({parts.mesh, parts, false, true}, hasty, m, faults, {}));
    const std::string share = std::to_string(static_cast<int>(std::ceil(100.0 * m.largest_share())));
    CHECK(faults.back().what.find(m.largest_share() < 1.0 ? "by " + share + " %" : "rough guess") != std::string::npos);
}

TEST_CASE("bake: a box with an open fin has the mass and inertia of both, and added mass near that of a solid fin") {
    Mesh mesh = box({-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}, 4), thick = mesh;
    add(mesh, fin(0.11, -0.1, 0.31, 0.1, 4));
    add(thick, box({-0.002, 0.11, -0.1}, {0.002, 0.31, 0.1}, 4));
    AssetData sheet, solid, refused;
    CHECK_FALSE(baked(mesh, refused, true));
    REQUIRE(baked(mesh, sheet));
    REQUIRE(baked(thick, solid));
    const double t = default_thickness * 0.2, fin_volume = 0.04 * t;
    CHECK(sheet.volume == doctest::Approx(0.008 + fin_volume).epsilon(1e-6));
    CHECK(sheet.center_of_mass[1] == doctest::Approx(fin_volume * 0.21 / sheet.volume).epsilon(1e-6));
    const double own = 0.008 * 0.04 / 6.0 + fin_volume * (0.04 / 6.0), arm = 0.21;
    CHECK(sheet.inertia[0] ==
          doctest::Approx(800.0 * (own + fin_volume * 0.008 / sheet.volume * arm * arm)).epsilon(1e-4));
    for (std::size_t k = 0; k < 3; ++k)
        CHECK(sheet.added_mass[7 * k] == doctest::Approx(solid.added_mass[7 * k]).epsilon(0.06));
}

TEST_CASE("bake: boxes that cross bake as their union") {
    Mesh cross = box({-0.3, -0.1, -0.1}, {0.3, 0.1, 0.1}, 6);
    add(cross, box({-0.11, -0.3, -0.11}, {0.11, 0.3, 0.11}, 6));
    AssetData asset, refused;
    CHECK_FALSE(baked(cross, refused, true));
    REQUIRE(baked(cross, asset));
    const double common = 0.22 * 0.2 * 0.2, volume = 0.6 * 0.04 + 0.6 * 0.22 * 0.22 - common;
    CHECK(asset.volume == doctest::Approx(volume).epsilon(0.005));
}

TEST_CASE("bake: volume within a solid that crosses itself counts once") {
    constexpr double width = 0.04, height = 0.02, a = 0.2, b = 0.1;
    const Eigen::Vector2d path[] = {{-a, -b}, {a, b}, {a, -b}, {-a, b}}; // a bar bent into an eight
    Mesh eight;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto normal = [&](std::size_t from, std::size_t to) {
            const Eigen::Vector2d along = (path[to % 4] - path[from % 4]).normalized();
            return Eigen::Vector2d(-along.y(), along.x());
        };
        const Eigen::Vector2d before = normal(i + 3, i + 4), after = normal(i, i + 1);
        const Eigen::Vector2d mitre = 0.5 * width * (before + after) / (1.0 + before.dot(after));
        for (const double side : {1.0, -1.0})
            for (const double z : {0.0, height})
                eight.vertices.emplace_back(path[i].x() + side * mitre.x(), path[i].y() + side * mitre.y(), z);
    }
    for (uint32_t i = 0; i < 4; ++i)
        for (const auto& [p, q] : {std::pair{0U, 1U}, {1U, 3U}, {3U, 2U}, {2U, 0U}}) {
            const uint32_t from = 4 * i, to = 4 * ((i + 1) % 4);
            eight.faces.push_back({from + p, to + p, to + q});
            eight.faces.push_back({from + p, to + q, from + q});
        }
    AssetData asset;
    REQUIRE(baked(eight, asset));
    const Eigen::Vector2d up = (path[1] - path[0]).normalized(), down = (path[3] - path[2]).normalized();
    const double common = height * width * width / std::abs(up.x() * down.y() - up.y() * down.x());
    const double volume = std::abs(compute_mass_properties(eight).volume) - common;
    CHECK(asset.volume == doctest::Approx(volume).epsilon(0.002));
    CHECK(asset.mass == doctest::Approx(800.0 * volume).epsilon(0.002));
    CHECK(std::abs(asset.center_of_mass[0]) < 1e-4 * a);
    // As the mass of another body too.
    MassProperties weighed;
    Faults faults;
    REQUIRE(weigh(eight, {}, weighed, faults));
    CHECK(weighed.volume == asset.volume);
}

TEST_CASE("bake: a cavity displaces fluid and holds no mass, a solid in a solid counts once") {
    const double outer = 0.2 * 0.2 * 0.2, inner = 0.1 * 0.1 * 0.1, ball = 0.02 * 0.02 * 0.02;
    const Mesh shell = box({0, 0, 0}, {0.2, 0.2, 0.2}, 3), inside = box({0.02, 0.05, 0.05}, {0.12, 0.15, 0.15}, 2);
    Mesh hollow = inside;
    turn_inside_out(hollow);
    add(hollow, shell);
    AssetData asset;
    Faults faults;
    CHECK_FALSE(baked(hollow, asset, true));
    REQUIRE(baked(hollow, asset, false, &faults));
    CHECK(std::any_of(faults.begin(), faults.end(),
                      [](const Fault& f) { return f.what == "1 enclosed cavity displaces fluid and holds no mass."; }));
    CHECK(asset.volume == doctest::Approx(outer).epsilon(1e-9));
    CHECK(asset.mass == doctest::Approx(800.0 * (outer - inner)).epsilon(1e-9));
    const double centre = (outer * 0.1 - inner * 0.07) / (outer - inner);
    CHECK(asset.center_of_mass[0] == doctest::Approx(centre).epsilon(1e-9));
    CHECK(asset.center_of_buoyancy[0] == doctest::Approx(0.1 - centre).epsilon(1e-9));
    AssetData whole;
    REQUIRE(baked(shell, whole));
    CHECK(asset.added_mass[0] == doctest::Approx(whole.added_mass[0]).epsilon(1e-6));

    Mesh rattle = hollow;
    add(rattle, box({0.06, 0.08, 0.08}, {0.08, 0.1, 0.1}));
    REQUIRE(baked(rattle, asset));
    CHECK(asset.mass == doctest::Approx(800.0 * (outer - inner + ball)).epsilon(1e-6));

    turn_inside_out(hollow); // the file as a whole
    REQUIRE(baked(hollow, asset));
    CHECK(asset.mass == doctest::Approx(800.0 * (outer - inner)).epsilon(1e-9));

    Mesh full = shell;
    add(full, inside);
    REQUIRE(baked(full, asset));
    CHECK(asset.mass == doctest::Approx(800.0 * outer).epsilon(1e-9));
    for (std::size_t i = 0; i < 36; i += 7) // solved as the one solid that is seen
        CHECK(asset.added_mass[i] == doctest::Approx(whole.added_mass[i]).epsilon(1e-4));
}

TEST_CASE("bake: layers in one plane that are cut along other diagonals") {
    Mesh mesh = fin(0, 0, 0.2, 0.1, 4), other = fin(0, 0, 0.2, 0.1, 4);
    AssetData single, layered;
    REQUIRE(baked(mesh, single));
    for (std::size_t i = 0; i < other.faces.size(); i += 2) {
        const Face a = other.faces[i], b = other.faces[i + 1];
        other.faces[i] = {a[0], a[1], b[2]};
        other.faces[i + 1] = {a[1], b[1], b[2]};
    }
    add(mesh, other);
    REQUIRE(baked(mesh, layered));
    const double error = layered.added_mass_error[0] + 0.1 * single.added_mass[0];
    CHECK(std::abs(layered.added_mass[0] - single.added_mass[0]) < error);
}

TEST_CASE("bake: a body of thousands of metres is taken as one of millimetres, with a word") {
    const Mesh mesh = box({0, 0, 0}, {1800, 400, 400}, 2);
    AssetData asset, refused;
    Faults faults;
    CHECK_FALSE(baked(mesh, refused, true));
    REQUIRE(baked(mesh, asset, false, &faults));
    CHECK(asset.volume == doctest::Approx(1.8 * 0.4 * 0.4));
    CHECK(std::any_of(faults.begin(), faults.end(), [](const Fault& f) {
        return f.id == FaultId::mesh_turned_or_scaled && f.remedy.find("--size") != std::string::npos;
    }));
    REQUIRE(baked(box({0, 0, 0}, {450, 450, 950}, 2), asset)); // 1143 m across, along its diagonal
    CHECK(asset.volume == doctest::Approx(0.45 * 0.45 * 0.95));
}
