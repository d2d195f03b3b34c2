// The public C++ API of the baker, as importers use it.
#include "asset/asset_file.h"
#include "baker/json.h"
#include "langevin_rigid_baker.hpp"
#include "mesh_shapes.h"
#include "scene_files.h"
#include "scratch.h"

#include <doctest/doctest.h>

#include <limits>
#include <stdexcept>
#include <thread>

namespace api = langevin_rigid;
using namespace lr;
using test::Scratch;

namespace {

struct Arrays {
    std::vector<double> positions;
    std::vector<uint32_t> indices;

    explicit Arrays(const baker::Mesh& mesh) {
        for (const Eigen::Vector3d& v : mesh.vertices) positions.insert(positions.end(), v.begin(), v.end());
        for (const baker::Face& f : mesh.faces) indices.insert(indices.end(), f.begin(), f.end());
    }
    api::BakeResult bake(const api::BakeOptions& options, const api::BakeProgress& progress = {}) const {
        return api::bake_triangles(positions.data(), positions.size() / 3, indices.data(), indices.size() / 3, options,
                                   progress);
    }
};

AssetData read(const api::BakeResult& result) {
    INFO((result.faults.empty() ? std::string() : to_string(result.faults.back())));
    REQUIRE(result.status == api::BakeStatus::done);
    AssetData asset;
    Faults faults;
    REQUIRE(read_asset(result.asset.data(), result.asset.size(), asset, faults));
    return asset;
}

uint32_t first_error(const api::BakeResult& result) {
    CHECK(result.status == api::BakeStatus::failed);
    CHECK(result.asset.empty());
    CHECK(result.report.empty());
    for (const api::BakeFault& f : result.faults)
        if (f.is_error) {
            CHECK_FALSE(f.what.empty());
            CHECK_FALSE(f.remedy.empty());
            return f.number;
        }
    return 0;
}

} // namespace

TEST_CASE("baker API: a file gives the bytes that lr_bake writes") {
    const Scratch scratch;
    const std::string mesh = scratch.write("body.obj", test::obj_text(test::ellipsoid(0.03, 0.027, 0.024, 2), 1000.0));
    REQUIRE(test::run(LR_BAKE_PATH, {"mesh",
                                     mesh,
                                     "-o",
                                     scratch.path("out.lrb"),
                                     "--unit",
                                     "mm",
                                     "--density",
                                     "350",
                                     "--up",
                                     "-y",
                                     "--fluid",
                                     "water",
                                     "--grid",
                                     "16,16,8",
                                     "--intensity",
                                     "0.25",
                                     "--center-of-mass",
                                     "1,0,2",
                                     "--stations",
                                     "3",
                                     "--name",
                                     "leaf",
                                     "--quiet"})
                .exit_code == 0);
    api::BakeOptions options;
    options.unit = api::Unit::millimetre;
    options.up = api::UpAxis::minus_y;
    options.density = 350.0;
    options.fluid_density = 998.0;
    options.fluid_viscosity = 1e-6;
    options.grid = {16, 16, 8};
    options.intensity = 0.25;
    options.center_of_mass = {1.0, 0.0, 2.0};
    options.stations = 3;
    options.name = "leaf";
    const api::BakeResult result = api::bake_file(mesh, options);
    REQUIRE(result);
    const std::string bytes = scratch.read("out.lrb");
    CHECK(std::string(result.asset.begin(), result.asset.end()) == bytes);
    CHECK(test::Json::parse(result.report)["name"] == "leaf");

    const std::string text = scratch.read("body.obj");
    const api::BakeResult memory = api::bake_memory(text.data(), text.size(), "any/where/body.obj", options);
    CHECK(memory.asset == result.asset);
}

TEST_CASE("baker API: arrays of either precision, with seams, are the file") {
    const Scratch scratch;
    baker::Mesh mesh = test::box({0.5, 0.25, 0.125}, {3, 2, 2}); // exact in single precision
    const Arrays whole(mesh);
    const AssetData from_doubles = read(whole.bake({}));
    CHECK(from_doubles.name == "mesh");
    CHECK(from_doubles.mass == doctest::Approx(800.0 * 0.5 * 0.25 * 0.125));
    const std::vector<float> single(whole.positions.begin(), whole.positions.end());
    const AssetData from_floats =
        read(api::bake_triangles(single.data(), single.size() / 3, whole.indices.data(), whole.indices.size() / 3, {}));
    CHECK(from_floats.mass == doctest::Approx(from_doubles.mass).epsilon(1e-6));
    CHECK(from_floats.added_mass[0] == doctest::Approx(from_doubles.added_mass[0]).epsilon(1e-6));
    if (test::sanitized) return; // other cases cover files and seams

    const AssetData from_file = read(api::bake_file(scratch.write("box.obj", test::obj_text(mesh)), {}));
    CHECK(content_hash(from_file) == content_hash(from_doubles));

    // Each triangle has its own corners, as renderers do.
    baker::Mesh split;
    for (const baker::Face& f : mesh.faces) {
        const auto n = static_cast<uint32_t>(split.vertices.size());
        for (const uint32_t v : f) split.vertices.push_back(mesh.vertices[v]);
        split.faces.push_back({n, n + 1, n + 2});
    }
    const api::BakeResult seams = Arrays(split).bake({});
    CHECK(seams.faults.empty());
    CHECK(read(seams).added_mass[0] == doctest::Approx(from_doubles.added_mass[0]));
}

TEST_CASE("baker API: ellipsoids and sheets") {
    api::BakeOptions options;
    options.unit = api::Unit::centimetre;
    const AssetData ball = read(api::bake_ellipsoid({1.0, 1.0, 1.0}, options));
    CHECK(ball.added_mass[0] == doctest::Approx(0.5 * ball.volume));
    CHECK(ball.name == "ellipsoid");

    baker::Mesh square;
    square.vertices = {{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.1, 0}, {0, 0.1, 0}};
    square.faces = {{0, 1, 2}, {0, 2, 3}};
    api::BakeOptions sheet;
    sheet.strict = true;
    CHECK(first_error(Arrays(square).bake(sheet)) == 206);
    sheet.strict = false;
    CHECK(read(Arrays(square).bake(sheet)).volume == doctest::Approx(0.003 * 0.1 * 0.01)); // of 0.3 % of its length
    sheet.sheet = api::BakeSheet{0.0001, 0.08};
    const AssetData paper = read(Arrays(square).bake(sheet));
    CHECK(paper.mass == doctest::Approx(0.08 * 0.01));
    // physics.md: A = .579 pi/4 a b^2 with semi-axes, of sides 0.1.
    CHECK(paper.added_mass[14] == doctest::Approx(0.579 * 3.14159265 / 4.0 * 1e-3).epsilon(0.01));
    CHECK_FALSE(paper.turbulence.wake);
    sheet.wake = true;
    sheet.grid = {16, 16, 8};
    CHECK(read(Arrays(square).bake(sheet)).turbulence.wake);
}

TEST_CASE("baker API: hostile input is numbered faults") {
    const Arrays good(test::ellipsoid(0.03, 0.027, 0.024, 2));
    const api::BakeOptions options;
    CHECK(first_error(api::bake_file("/nowhere/at/all.obj", options)) == 101);
    CHECK(first_error(api::bake_file("", options)) == 101);
    CHECK(first_error(api::bake_file("/", options)) == 102);
    CHECK(first_error(api::bake_memory(nullptr, 100, "a.obj", options)) == 202);
    CHECK(first_error(api::bake_memory("", 0, "a.obj", options)) == 202);
    CHECK(first_error(api::bake_memory("v 0 0 0", 7, "", options)) == 201);
    CHECK(first_error(api::bake_memory("\xff\xfe", 2, "\xff\xfe.stl", options)) == 201);
    const float* no_floats = nullptr;
    CHECK(first_error(api::bake_triangles(no_floats, 0, nullptr, 0, options)) == 202);
    CHECK(first_error(api::bake_triangles(no_floats, 3, good.indices.data(), 1, options)) == 204);
    CHECK(first_error(api::bake_triangles(good.positions.data(), 3, nullptr, 1, options)) == 204);
    CHECK(first_error(api::bake_triangles(good.positions.data(), SIZE_MAX, good.indices.data(), 1, options)) == 204);
    CHECK(first_error(api::bake_triangles(good.positions.data(), 3, good.indices.data(), SIZE_MAX, options)) == 204);

    Arrays bad = good;
    bad.indices[7] = static_cast<uint32_t>(bad.positions.size() / 3);
    CHECK(first_error(bad.bake(options)) == 204);
    bad.indices[7] = UINT32_MAX;
    CHECK(first_error(bad.bake(options)) == 204);
    bad = good;
    bad.positions[4] = std::numeric_limits<double>::quiet_NaN();
    api::BakeOptions strict;
    strict.strict = true;
    CHECK(first_error(bad.bake(strict)) == 203);
    bad = good;
    bad.indices.resize(bad.indices.size() - 3);
    CHECK(first_error(bad.bake(strict)) == 206);

    api::BakeOptions wrong;
    wrong.density = -1.0;
    CHECK(first_error(good.bake(wrong)) == 301);
    wrong = {};
    wrong.grid = {0, UINT32_MAX, 7};
    CHECK(first_error(good.bake(wrong)) == 301);
    wrong = {};
    wrong.unit = static_cast<api::Unit>(77); // not an enumerator
    wrong.up = static_cast<api::UpAxis>(-5);
    CHECK(good.bake(wrong));
    wrong = {};
    wrong.mesh = "nobody";
    CHECK(first_error(good.bake(wrong)) == 302);
    wrong = {};
    wrong.name = std::string(5000, 'x');
    CHECK(first_error(good.bake(wrong)) == 301);
    wrong = {};
    wrong.sheet = api::BakeSheet{};
    CHECK(first_error(good.bake(wrong)) == 301);
    CHECK(first_error(api::bake_ellipsoid({1.0, 0.0, std::nan("")}, options)) == 301);
}

TEST_CASE("baker API: progress never falls, ends at 1, and can cancel at every call") {
    const Arrays mesh(test::ellipsoid(0.03, 0.027, 0.024, 2));
    double last = 0.0;
    int calls = 0;
    const std::thread::id here = std::this_thread::get_id();
    const api::BakeResult whole = mesh.bake({}, [&](const char* phase, double fraction) {
        CHECK(phase[0] != '\0');
        CHECK(fraction >= last);
        CHECK(std::this_thread::get_id() == here);
        last = fraction;
        ++calls;
        return true;
    });
    CHECK(whole);
    CHECK(last == 1.0);
    REQUIRE(calls > 10);
    for (int stop = 1; stop <= calls; stop += test::sanitized ? 5 : 1) {
        int n = 0;
        const api::BakeResult part = mesh.bake({}, [&](const char*, double) {
            if (++n == stop && stop % 2 == 0) throw std::runtime_error("from the host");
            return n < stop;
        });
        CHECK(n == stop); // not called again
        CHECK(part.status == api::BakeStatus::cancelled);
        CHECK(part.asset.empty());
    }
}

TEST_CASE("baker API: several bakes at once, each as if alone" * doctest::test_suite("exact")) {
    constexpr std::size_t n = 6;
    const std::string scene = test::glb(test::tetrahedron(), test::two_nodes());
    std::vector<api::BakeResult> alone(n), together(n);
    const auto bake = [&](std::size_t i) {
        api::BakeOptions options;
        options.density = 500.0 + 100.0 * static_cast<double>(i);
        if (i % 2 == 1) return api::bake_memory(scene.data(), scene.size(), "scene.glb", options);
        return Arrays(test::ellipsoid(0.03, 0.02, 0.01, 2)).bake(options);
    };
    for (std::size_t i = 0; i < n; ++i) alone[i] = bake(i);
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < n; ++i) threads.emplace_back([&, i] { together[i] = bake(i); });
    for (std::thread& t : threads) t.join();
    for (std::size_t i = 0; i < n; ++i) {
        CHECK(together[i]);
        CHECK(together[i].asset == alone[i].asset);
    }
}
