// Bodies whose mass is not where their surface is: --mass-from, and BakeOptions::mass.
#include "asset/asset_file.h"
#include "baker/bake.h"
#include "baker/fault_text.h"
#include "baker/mesh/mass_properties.h"
#include "langevin_rigid_baker.hpp"
#include "scratch.h"
#include "sheet_shapes.h"

#include <doctest/doctest.h>

#include <cmath>

namespace api = langevin_rigid;
using namespace lr;
using namespace lr::baker;
using doctest::Approx;
using ::lr::test::Scratch;
namespace shapes = lr::test;

namespace {

constexpr double thickness = 1e-4, areal_density = 0.08;

struct Arrays {
    std::vector<double> positions;
    std::vector<uint32_t> indices;

    explicit Arrays(const Mesh& mesh) {
        for (const Eigen::Vector3d& v : mesh.vertices) positions.insert(positions.end(), v.begin(), v.end());
        for (const Face& f : mesh.faces) indices.insert(indices.end(), f.begin(), f.end());
    }
    MeshArrays view() const { return {positions, indices}; }
};

// A strip of 0.12 by 0.05, x from 0 on, and its layers: two over the first third, of which one lies on its back.
Mesh strip(double length) {
    return shapes::patch(6, 3, [=](double u, double v) { return Eigen::Vector3d(length * u, 0.05 * (v - 0.5), 0.0); });
}

Mesh strip_layers() {
    Mesh all = strip(0.12), flap = strip(0.04);
    for (Face& f : flap.faces) std::swap(f[1], f[2]);
    shapes::append(all, flap);
    return all;
}

BakeOptions sheet_options() {
    BakeOptions o;
    o.mesh_path = "body";
    o.sheet = SheetOptions{thickness, areal_density};
    o.cells = {16, 16, 8};
    return o;
}

bool bake_with(const Mesh& surface, const Mesh* mass, BakeOptions options, AssetData& asset, Faults& faults) {
    const Arrays body(surface);
    options.mesh_arrays = body.view();
    if (!mass) return bake(options, asset, faults);
    const Arrays weight(*mass);
    options.mass = MassOptions{{}, weight.view()};
    return bake(options, asset, faults);
}

AssetData baked(const Mesh& surface, const Mesh* mass, const BakeOptions& options) {
    AssetData asset;
    Faults faults;
    const bool good = bake_with(surface, mass, options, asset, faults);
    for (const Fault& f : faults) INFO(to_string(f));
    REQUIRE(good);
    return asset;
}

uint32_t refused(const Mesh& surface, const Mesh* mass, const BakeOptions& options) {
    AssetData asset;
    Faults faults;
    CHECK_FALSE(bake_with(surface, mass, options, asset, faults));
    REQUIRE_FALSE(faults.empty());
    CHECK(faults.back().where.starts_with("mass"));
    return static_cast<uint32_t>(faults.back().id);
}

} // namespace

TEST_CASE("mass mesh: layers at one place count each, and the fluid sees one surface") {
    const Mesh surface = strip(0.12), layers = strip_layers();
    const AssetData one = baked(surface, nullptr, sheet_options()), folded = baked(surface, &layers, sheet_options());
    CHECK(folded.mass == Approx(areal_density * 0.16 * 0.05).epsilon(1e-12));
    CHECK(folded.volume == Approx(thickness * 0.16 * 0.05).epsilon(1e-12));
    CHECK(folded.density == Approx(areal_density / thickness).epsilon(1e-12));
    CHECK(folded.length_b == Approx(thickness * 4.0 / 3.0).epsilon(1e-12)); // on the mean
    const double centre = (0.12 * 0.06 + 0.04 * 0.02) / 0.16;
    CHECK(folded.center_of_mass[0] == Approx(centre).epsilon(1e-12));
    for (const double c : folded.center_of_buoyancy) CHECK(std::abs(c) < 1e-15); // layers displace their own volume
    const auto about = [&](double length) {
        return length * (length * length / 12.0 + std::pow(0.5 * length - centre, 2)) * areal_density * 0.05;
    };
    CHECK(folded.inertia[4] == Approx(about(0.12) + about(0.04)).epsilon(1e-4));
    // Loads act at the middle of the strip.
    CHECK(one.aerodynamics.center == std::array<double, 3>{});
    CHECK(folded.aerodynamics.center[0] == Approx(0.06 - centre).epsilon(1e-9));
    CHECK((folded.aerodynamics.center[1] == 0.0 && folded.aerodynamics.center[2] == 0.0));
    CHECK(folded.aerodynamics.lift[1] == Approx(4.0 / 3.0 * one.aerodynamics.lift[1]).epsilon(1e-3)); // of its rim
    CHECK(folded.added_mass[14] == Approx(one.added_mass[14]).epsilon(1e-6));
    CHECK(folded.provenance.faces == surface.faces.size());
}

TEST_CASE("mass mesh: the same mesh, and a copy of it in other triangles, change nothing") {
    const Mesh surface = strip(0.12);
    const AssetData plain = baked(surface, nullptr, sheet_options()), same = baked(surface, &surface, sheet_options());
    CHECK(same.mass == plain.mass);
    CHECK(same.inertia == plain.inertia);
    CHECK(same.added_mass == plain.added_mass);
    CHECK(same.aerodynamics.drag == plain.aerodynamics.drag);
    CHECK(same.aerodynamics.center == plain.aerodynamics.center);
    CHECK(same.provenance.options.find("--mass-from mesh") != std::string::npos);
    CHECK(same.provenance.input_hash != plain.provenance.input_hash);
}

TEST_CASE("mass mesh: of a solid it is the solid parts") {
    // A hollow float with a weight at one end.
    const Mesh surface = shapes::box({0.3, 0.1, 0.1}, {3, 1, 1});
    Mesh weight = shapes::box({0.1, 0.1, 0.1}, {1, 1, 1});
    shapes::apply(weight, 0.5 * Eigen::Matrix3d::Identity(), {0.1, 0.0, 0.0});
    BakeOptions options;
    options.mesh_path = "body";
    options.density = 2000.0;
    options.cells = {16, 16, 8};
    const AssetData a = baked(surface, &weight, options);
    CHECK(a.mass == Approx(2000.0 * 1.25e-4).epsilon(1e-12));
    CHECK(a.volume == Approx(3e-3).epsilon(1e-12));
    CHECK(a.density == Approx(a.mass / a.volume).epsilon(1e-12));
    CHECK(a.center_of_mass[0] == Approx(0.1).epsilon(1e-12));
    CHECK(a.center_of_buoyancy[0] == Approx(-0.1).epsilon(1e-12));
    CHECK(a.inertia[4] == Approx(a.mass / 6.0 * 0.05 * 0.05).epsilon(1e-9));
    CHECK(a.aerodynamics.center == std::array<double, 3>{}); // the surface is an even one
    CHECK(a.aerodynamics.axes == std::array<double, 9>{1, 0, 0, 0, 1, 0, 0, 0, 1});
}

TEST_CASE("mass mesh: of bodies of solids and sheets, and itself of parts that cross") {
    // A box with a fin floats on it; its weight is two bars that cross, and a foil.
    Mesh body = shapes::box({0.3, 0.1, 0.1}, {3, 1, 1});
    Mesh fin = strip(0.1);
    shapes::apply(fin, Eigen::Matrix3d::Identity(), {-0.05, 0.0, 0.3});
    shapes::append(body, fin);
    Mesh weight = shapes::box({0.2, 0.02, 0.02}, {2, 1, 1});
    shapes::append(weight, shapes::box({0.02, 0.2, 0.02}, {1, 2, 1}));
    Mesh foil = strip(0.1);
    shapes::apply(foil, Eigen::Matrix3d::Identity(), {-0.05, 0.0, -0.1});
    shapes::append(weight, foil);
    BakeOptions options;
    options.mesh_path = "body";
    options.density = 2000.0;
    options.thickness = 0.001;
    options.cells = {16, 16, 8};
    const AssetData a = baked(body, &weight, options);
    const double bars = 2 * 0.2 * 0.0004 - 8e-6, sheet = 0.1 * 0.05 * 0.001;
    CHECK(a.mass == Approx(2000.0 * (bars + sheet)).epsilon(4e-3));
    CHECK(a.volume == Approx(3e-3 + sheet).epsilon(1e-6));
    CHECK(a.density == Approx(a.mass / a.volume).epsilon(1e-12));
    CHECK(a.center_of_mass[2] == Approx(-0.1 * sheet / (bars + sheet)).epsilon(1e-2));
}

TEST_CASE("mass mesh: what cannot be is a fault that names it") {
    const Mesh surface = strip(0.12);
    Mesh bad = strip_layers();
    bad.vertices[3].y() = std::nan("");
    BakeOptions strict = sheet_options();
    strict.strict = true;
    CHECK(refused(surface, &bad, strict) == 203);
    bad = strip_layers();
    bad.faces[2][1] = 99999;
    CHECK(refused(surface, &bad, sheet_options()) == 204);
    bad = {};
    CHECK(refused(surface, &bad, sheet_options()) == 202);
    const Mesh open = strip_layers(), box = shapes::box({0.3, 0.1, 0.1}, {3, 1, 1});
    BakeOptions solid;
    solid.mesh_path = "body";
    solid.strict = true;
    CHECK(refused(box, &surface, solid) == 206); // the parts of a solid must be closed
    CHECK(refused(box, &open, solid) == 212);
    BakeOptions both = sheet_options();
    both.center_of_mass = {0.06, 0.0, 0.0};
    CHECK(refused(surface, &open, both) == 301);
    BakeOptions ellipsoid;
    ellipsoid.semi_axes = {0.1, 0.1, 0.1};
    CHECK(refused(surface, &open, ellipsoid) == 301);

    // Its centre lies outside the hull: wrong unit or place.
    Mesh far = strip_layers();
    for (Eigen::Vector3d& v : far.vertices) v.x() += 1.0;
    AssetData asset;
    Faults faults;
    CHECK_FALSE(bake_with(surface, &far, sheet_options(), asset, faults));
    CHECK(static_cast<uint32_t>(faults.back().id) == 301);
}

TEST_CASE("mass mesh: lr_bake and the API make the same body, from files and from arrays") {
    const Scratch scratch;
    const std::string body = scratch.write("strip.obj", shapes::obj_text(strip(0.12), 1000.0));
    const std::string layers = scratch.write("layers.obj", shapes::obj_text(strip_layers(), 1000.0));
    const std::vector<std::string> arguments{
        "mesh",    body,          "-o",  scratch.path("out.lrb"), "--unit", "mm",
        "--sheet", "--thickness", "0.1", "--areal-density",       "0.08",   "--mass-from",
        layers,    "--if-changed"};
    const auto run = [&] { return lr::test::run(LR_BAKE_PATH, arguments); };
    REQUIRE(run().exit_code == 0);
    const std::string bytes = scratch.read("out.lrb");
    CHECK(run().out.find("unchanged") != std::string::npos);
    CHECK(scratch.read("out.lrb") == bytes);

    api::BakeOptions options;
    options.unit = api::Unit::millimetre;
    options.sheet = api::BakeSheet{0.1, 0.08};
    options.mass = api::BakeMass{layers, {}, {}};
    const api::BakeResult from_files = api::bake_file(body, options);
    REQUIRE(from_files);
    CHECK(std::string(from_files.asset.begin(), from_files.asset.end()) == bytes);

    const Arrays surface(strip(0.12)), weight(strip_layers());
    api::BakeOptions in_metres;
    in_metres.sheet = api::BakeSheet{1e-4, 0.08};
    in_metres.mass = api::BakeMass{{}, weight.positions, weight.indices};
    const auto bake_arrays = [&](const api::BakeOptions& o) {
        return api::bake_triangles(surface.positions.data(), surface.positions.size() / 3, surface.indices.data(),
                                   surface.indices.size() / 3, o);
    };
    const api::BakeResult from_arrays = bake_arrays(in_metres);
    REQUIRE(from_arrays);
    AssetData a, b;
    Faults faults;
    REQUIRE(read_asset(from_files.asset.data(), from_files.asset.size(), a, faults));
    REQUIRE(read_asset(from_arrays.asset.data(), from_arrays.asset.size(), b, faults));
    CHECK(a.mass == Approx(b.mass).epsilon(1e-9));
    CHECK(a.aerodynamics.center[0] == Approx(b.aerodynamics.center[0]).epsilon(1e-6));

    // Only bake_file opens files; arrays hold triples.
    const auto error_of = [&](const api::BakeOptions& o) {
        const api::BakeResult result = bake_arrays(o);
        CHECK(result.status == api::BakeStatus::failed);
        return result.faults.empty() ? 0U : result.faults.back().number;
    };
    CHECK(error_of(options) == 301);
    const auto error_with = [&](const api::BakeMass& mass) {
        api::BakeOptions other = in_metres;
        other.mass = mass;
        return error_of(other);
    };
    CHECK(error_with({{}, std::vector<double>(8), weight.indices}) == 204);
    CHECK(error_with({{}, weight.positions, std::vector<uint32_t>(5)}) == 204);
    CHECK(error_with({}) == 202);
    CHECK(api::bake_ellipsoid({1.0, 1.0, 1.0}, in_metres)); // which does not use it

    // The contents of a file count, not its name.
    scratch.write("layers.obj", shapes::obj_text(strip(0.12), 1000.0));
    REQUIRE(run().exit_code == 0);
    CHECK(scratch.read("out.lrb") != bytes);

    const auto exit_code = [&](std::vector<std::string> more) {
        std::vector<std::string> all{"mesh", body, "-o", scratch.path("other.lrb"), "--unit", "mm", "--quiet"};
        all.insert(all.end(), more.begin(), more.end());
        return lr::test::run(LR_BAKE_PATH, all).exit_code;
    };
    const std::vector<std::string> sheet{"--sheet", "--thickness", "0.1"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.end(), sheet.begin(), sheet.end());
        return exit_code(more);
    };
    CHECK(with({"--mass-from", ""}) == 2);
    CHECK(with({"--mass-from", layers, "--center-of-mass", "1,0,0"}) == 2);
    CHECK(with({"--mass-from", scratch.path("none.obj")}) == 1);
    CHECK(lr::test::run(LR_BAKE_PATH, {"mesh", body, body, "-d", scratch.path("d"), "--mass-from", layers}).exit_code ==
          2);
    CHECK(lr::test::run(LR_BAKE_PATH, {"mesh", body, "-o", layers, "--sheet", "--thickness", "0.1", "--unit", "mm",
                                       "--mass-from", layers, "--quiet"})
              .exit_code == 1);
    CHECK_FALSE(scratch.has("other.lrb"));
}
