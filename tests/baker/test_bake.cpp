#include "baker/bake.h"
#include "baker/fault_text.h"
#include "baker/json.h"

#include "asset/asset_file.h"
#include "asset/closed_forms/ellipsoid_asset.h"
#include "asset/closed_forms/turbulence_closure.h"
#include "baker/asset_report.h"
#include "baker/file_io.h"
#include "baker/printable_text.h"
#include "base/fnv1a.h"
#include "mesh_shapes.h"
#include "scratch.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <map>
#include <numbers>

using namespace lr;
using namespace lr::baker;
using doctest::Approx;

namespace {

BakeOptions ellipsoid_options(double a, double b, double c) {
    BakeOptions o;
    o.semi_axes = {a, b, c};
    return o;
}

BakeOptions mesh_options(const std::string& path) {
    BakeOptions o;
    o.mesh_path = path;
    return o;
}

AssetData must_bake(const BakeOptions& options) {
    AssetData asset;
    Faults faults;
    const bool good = bake(options, asset, faults);
    for (const Fault& f : faults) INFO(to_string(f));
    REQUIRE(good);
    REQUIRE(check_asset(asset, faults));
    return asset;
}

// The only error's number, or 0 after success.
FaultId fault_of(const BakeOptions& options) {
    AssetData asset;
    Faults faults;
    const bool good = bake(options, asset, faults);
    CHECK(good != has_error(faults));
    for (const Fault& f : faults) {
        if (f.severity != Severity::error) continue;
        CHECK(!f.where.empty());
        CHECK(!f.what.empty());
        CHECK(!f.remedy.empty());
        return f.id;
    }
    return FaultId{};
}

// Compares the mesh's matrix with the closed form: near it where that is not zero, small elsewhere.
void check_added_mass(const AssetData& mesh, const AssetData& exact, double tolerance) {
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) {
            CAPTURE(i);
            CAPTURE(j);
            const double value = mesh.added_mass[i * 6 + j], expected = exact.added_mass[i * 6 + j];
            const double scale = std::sqrt(exact.added_mass[i * 7] * exact.added_mass[j * 7]);
            CHECK(mesh.added_mass[j * 6 + i] == value);
            if (std::abs(expected) > 1e-9 * scale)
                CHECK(value == Approx(expected).epsilon(tolerance));
            else
                CHECK(std::abs(value) < 0.01 * scale);
        }
}

} // namespace

TEST_CASE("bake: an ellipsoid in the report is the closed form, in SI units") {
    BakeOptions o = ellipsoid_options(4.0, 2.0, 1.0);
    o.unit = Unit::cm;
    o.density = 700.0;
    o.fluid_density = 998.0;
    o.fluid_viscosity = 1e-6;
    const AssetData asset = must_bake(o);
    const test::Json j = test::Json::parse(report_json(asset));

    const double a = 0.04, b = 0.02, c = 0.01;
    const double volume = 4.0 / 3.0 * std::numbers::pi * a * b * c, mass = 700.0 * volume;
    CHECK(j["name"] == "ellipsoid");
    CHECK(j["volume"].number() == Approx(volume).epsilon(1e-12));
    CHECK(j["mass"].number() == Approx(mass).epsilon(1e-12));
    CHECK(j["density"] == 700.0);
    REQUIRE(j["inertia"].size() == 9);
    CHECK(j["inertia"][0].number() == Approx(mass / 5 * (b * b + c * c)).epsilon(1e-12));
    CHECK(j["inertia"][4].number() == Approx(mass / 5 * (a * a + c * c)).epsilon(1e-12));
    CHECK(j["inertia"][8].number() == Approx(mass / 5 * (a * a + b * b)).epsilon(1e-12));
    REQUIRE(j["added_mass"].size() == 36);
    REQUIRE(j["added_mass_error"].size() == 36);
    const double lamb[] = {0.12657, 0.39817, 1.51806};
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(j["added_mass"][i * 7].number() == Approx(998.0 * volume * lamb[i]).epsilon(1e-5));
    CHECK(j["diagonal"] == true);
    CHECK(j["center_of_mass"] == std::vector<double>{0, 0, 0});
    CHECK(j["center_of_buoyancy"] == std::vector<double>{0, 0, 0});
    CHECK(j["fluid"]["density"] == 998.0);
    CHECK(j["fluid"]["viscosity"] == 1e-6);
    CHECK(j["lengths"]["d"].number() == Approx(0.08));
    CHECK(j["lengths"]["b"].number() == Approx(0.02));

    const double u0 = j["u0"].number(), l = j["lengths"]["l"].number();
    CHECK(u0 == Approx(std::sqrt(std::abs(700.0 / 998.0 - 1.0) * 9.80665 * 0.02)));
    CHECK(j["reynolds"].number() == Approx(u0 * 0.08 / 1e-6));
    // Uniform stream: the closed-form decay at each sample.
    const test::Json table = j["turbulence"];
    const double dt = table["dt"].number();
    REQUIRE(table["chi"].size() == table["epsilon"].size());
    REQUIRE(table["chi"].size() > 16);
    const shape::TurbulenceState start = shape::inflow_state(u0, 1.0, l);
    for (std::size_t n = 0; n < table["chi"].size(); n += 7) {
        const shape::TurbulenceState s = shape::decay(start, static_cast<double>(n) * dt);
        CHECK(table["chi"][n].number() == Approx(shape::turbulent_frequency(s)).epsilon(1e-3));
        CHECK(table["epsilon"][n].number() == Approx(s.epsilon).epsilon(1e-3));
    }
    CHECK(table["stationary"] == 0);
    CHECK(j["c0"].number() == Approx(shape::kolmogorov_c0(shape::taylor_reynolds(start, 1e-6))));
    CHECK(j["provenance"]["tool"] == "lr_bake");
    CHECK(j["provenance"]["tool_version"] == baker_version());
    CHECK(j["provenance"]["source"] == "ellipsoid");
    CHECK(j["provenance"]["input_hash"].text().size() == 16);
    CHECK(j["provenance"]["options"] ==
          "ellipsoid 4 2 1 --unit cm --density 700 --fluid 998,1e-06 --grid 32,32,16 --intensity 1");
}

TEST_CASE("bake: a mesh of 1280 triangles is within 1.5 % of the ellipsoid it samples") {
    const test::Scratch scratch;
    const AssetData exact = must_bake(ellipsoid_options(0.04, 0.02, 0.01));
    const test::Mesh mesh = test::ellipsoid(0.04, 0.02, 0.01, 3);
    REQUIRE(mesh.faces.size() == 1280);

    SUBCASE("as authored") {
        const AssetData baked = must_bake(mesh_options(scratch.write("body.obj", test::obj_text(mesh))));
        check_added_mass(baked, exact, 0.015);
        CHECK(baked.volume == Approx(exact.volume).epsilon(0.015));
        CHECK(baked.length_l == Approx(exact.length_l).epsilon(0.015));
        CHECK(baked.u0 == Approx(exact.u0).epsilon(0.015));
        for (std::size_t i = 0; i < 9; i += 4) CHECK(baked.inertia[i] == Approx(exact.inertia[i]).epsilon(0.03));
        CHECK(largest_coupling(baked) < 1e-6);
        CHECK(baked.provenance.faces == 1280);
        CHECK(baked.provenance.vertices == 642);
        CHECK(baked.provenance.source == "body.obj");
        CHECK(baked.name == "body");
        CHECK(baked.hull.triangles.size() == 3 * 1280);
    }
    SUBCASE("away from the origin and in another unit") {
        test::Mesh moved = mesh;
        test::apply(moved, Eigen::Matrix3d::Identity(), {0.3, -0.2, 0.1});
        BakeOptions o = mesh_options(scratch.write("moved.obj", test::obj_text(moved, 1000.0)));
        o.unit = Unit::mm;
        const AssetData baked = must_bake(o);
        check_added_mass(baked, exact, 0.015);
        CHECK(baked.center_of_mass[0] == Approx(0.3));
        CHECK(baked.center_of_mass[1] == Approx(-0.2));
        CHECK(baked.center_of_mass[2] == Approx(0.1));
        for (const double x : baked.center_of_buoyancy) CHECK(std::abs(x) < 1e-12);
    }
    SUBCASE("ballasted: about the given centre") {
        BakeOptions o = mesh_options(scratch.write("body.obj", test::obj_text(mesh, 100.0)));
        o.unit = Unit::cm;
        o.center_of_mass = {1.0, 0.5, -0.2};
        BakeOptions closed = ellipsoid_options(4.0, 2.0, 1.0);
        closed.unit = Unit::cm;
        closed.center_of_mass = o.center_of_mass;
        const AssetData baked = must_bake(o), reference = must_bake(closed);
        check_added_mass(baked, reference, 0.015);
        for (std::size_t i = 0; i < 3; ++i) {
            CHECK(baked.center_of_mass[i] == Approx((*o.center_of_mass)[i] / 100.0));
            CHECK(baked.center_of_buoyancy[i] == Approx(-(*o.center_of_mass)[i] / 100.0));
        }
        CHECK(baked.inertia[0] == Approx(exact.inertia[0]).epsilon(0.03));
        CHECK(largest_coupling(baked) > 0.01);
    }
}

TEST_CASE("bake: couplings that are real stay") {
    const test::Scratch scratch;
    test::Mesh mesh = test::leaf(16, 4, 0.02, 0.3);
    test::apply(mesh, 0.03 * Eigen::Matrix3d::Identity());
    const AssetData curled = must_bake(mesh_options(scratch.write("leaf.obj", test::obj_text(mesh))));
    CHECK(largest_coupling(curled) > 0.01);
}

TEST_CASE("bake: triangles without the mirror planes of their body do not cost the fast path") {
    const test::Scratch scratch;
    test::Mesh mesh = test::box({0.012, 0.006, 0.0002}, {12, 7, 1});
    const AssetData flat = must_bake(mesh_options(scratch.write("confetti.obj", test::obj_text(mesh))));
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j)
            if (i != j) {
                CHECK(flat.added_mass[i * 6 + j] == 0.0);
                CHECK(flat.added_mass_error[i * 6 + j] > 0.0);
            }
}

TEST_CASE("bake: a flat body of any outline, however it lies, takes the path of sheets") {
    const test::Scratch scratch;
    test::Mesh mesh = test::box({0.03, 0.02, 0.0003}, {12, 7, 1});
    // Sheared in its plane, and turned.
    Eigen::Matrix3d shear = Eigen::Matrix3d::Identity();
    shear(0, 1) = 0.5;
    test::apply(mesh, Eigen::AngleAxisd(0.7, Eigen::Vector3d(0.6, 0.0, 0.8)).toRotationMatrix() * shear);
    const AssetData flat = must_bake(mesh_options(scratch.write("flat.obj", test::obj_text(mesh))));
    CHECK(!is_diagonal(flat));
    CHECK(is_symmetric(flat, flat.aerodynamics));
    CHECK(mirror_coupling(flat, flat.aerodynamics) < 1e-9);
    // Not if it is bent: the mirror plane across the fold is another one.
    test::Mesh bent = test::leaf(16, 4, 0.02, 0.3);
    test::apply(bent, 0.03 * Eigen::Matrix3d::Identity());
    const AssetData curled = must_bake(mesh_options(scratch.write("bent.obj", test::obj_text(bent))));
    CHECK(mirror_coupling(curled, curled.aerodynamics) > 1e-3);
}

TEST_CASE("bake: a body of its fluid's density, and one lighter than it") {
    for (const double density : {998.0, 997.999999, 20.0, 0.001}) {
        CAPTURE(density);
        BakeOptions o = ellipsoid_options(0.04, 0.02, 0.01);
        o.density = density;
        o.fluid_density = 998.0;
        o.fluid_viscosity = 1e-6;
        AssetData asset;
        Faults faults;
        REQUIRE(bake(o, asset, faults));
        CHECK(asset.u0 >= 1e-6);
        if (density == o.fluid_density) {
            REQUIRE(faults.size() == 1);
            CHECK(faults[0].id == FaultId::parameter_not_denser);
            CHECK(faults[0].severity == Severity::warning);
        }
        CHECK(asset.mass == Approx(density * asset.volume));
        const test::Json j = test::Json::parse(report_json(asset));
        for (const test::Json& table : {j["turbulence"]["chi"], j["turbulence"]["epsilon"]})
            for (std::size_t i = 0; i < table.size(); ++i)
                CHECK(table[i].is_number()); // JSON writes null for non-finite numbers
    }
}

TEST_CASE("bake: the same input gives the same bytes, wherever it lies") {
    const test::Scratch here, there;
    test::Mesh mesh = test::ellipsoid(0.03, 0.027, 0.024, 2);
    const std::string text = test::obj_text(mesh);
    const BakeOptions first = mesh_options(here.write("body.obj", text)),
                      second = mesh_options(there.write("body.obj", text));
    const AssetData asset = must_bake(first);
    const std::vector<uint8_t> bytes = write_asset(asset);
    CHECK(bytes == write_asset(must_bake(first)));
    CHECK(bytes == write_asset(must_bake(second)));

    Fnv1a hash;
    hash.add(text.data(), text.size());
    const std::string options = canonical_options(first);
    hash.add(options.data(), options.size());
    CHECK(asset.provenance.input_hash == hash.value());
    CHECK(asset.provenance.options == options);

    BakeOptions denser = first;
    denser.density = 801.0;
    CHECK(must_bake(denser).provenance.input_hash != asset.provenance.input_hash);
}

TEST_CASE("bake: what is written is what is read, to the last digit of the report") {
    const test::Scratch scratch;
    BakeOptions o = mesh_options(scratch.write("body.obj", test::obj_text(test::ellipsoid(0.03, 0.027, 0.024, 2))));
    o.name = "caf\xc3\xa9 \xff"; // invalid UTF-8 at its end
    const AssetData asset = must_bake(o);
    CHECK(asset.name == "caf\xc3\xa9 \xef\xbf\xbd");
    const std::vector<uint8_t> bytes = write_asset(asset);
    AssetData read;
    Faults faults;
    REQUIRE(read_asset(bytes.data(), bytes.size(), read, faults));
    CHECK(report_json(read) == report_json(asset));
    const auto with_extras = test::Json::parse(report_json(asset, faults, {{"reading", 0.5}}));
    CHECK(with_extras["timings"]["reading"] == 0.5);
    CHECK(with_extras["faults"].is_array());
}

TEST_CASE("bake: parameters out of range are fault 301") {
    const BakeOptions good = ellipsoid_options(0.04, 0.02, 0.01);
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    for (const double bad : {0.0, -1.0, nan, inf, -inf, 1e300}) {
        CAPTURE(bad);
        for (double BakeOptions::*field : {&BakeOptions::density, &BakeOptions::fluid_density,
                                           &BakeOptions::fluid_viscosity, &BakeOptions::intensity}) {
            BakeOptions o = good;
            o.*field = bad;
            CHECK(fault_of(o) == FaultId::parameter_out_of_range);
        }
        for (std::size_t i = 0; i < 3; ++i) {
            BakeOptions o = good;
            (*o.semi_axes)[i] = bad;
            CHECK(fault_of(o) == FaultId::parameter_out_of_range);
        }
    }
    for (const std::array<uint32_t, 3>& bad :
         {std::array<uint32_t, 3>{3, 32, 16}, {0, 0, 0}, {32, 32, 513}, {512, 512, 512}}) {
        BakeOptions o = good;
        o.cells = bad;
        CHECK(fault_of(o) == FaultId::parameter_out_of_range);
    }
    for (const double bad : {0.05, nan, inf}) {
        BakeOptions o = good;
        o.center_of_mass = {bad, 0.0, 0.0};
        CHECK(fault_of(o) == FaultId::parameter_out_of_range);
    }
    BakeOptions o = good;
    o.name = std::string(5000, 'x');
    CHECK(fault_of(o) == FaultId::parameter_out_of_range);
}

TEST_CASE("bake: sheets that are none") {
    const test::Scratch scratch;
    BakeOptions o =
        mesh_options(scratch.write("card.obj", "v 0 0 0\nv 0.08 0 0\nv 0.08 0.04 0\nv 0 0.04 0\nf 1 2 3 4\n"));
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    for (const double bad : {0.0, -1e-4, 0.03, 1e-12, nan, inf}) {
        CAPTURE(bad);
        o.sheet = SheetOptions{bad, {}};
        CHECK(fault_of(o) == FaultId::parameter_out_of_range);
    }
    for (const double bad : {0.0, -0.07, 1e9, nan, inf}) {
        CAPTURE(bad);
        o.sheet = SheetOptions{1e-4, bad};
        CHECK(fault_of(o) == FaultId::parameter_out_of_range);
    }
    o.sheet = SheetOptions{1e-4, {}};
    const AssetData by_density = must_bake(o);
    CHECK(by_density.mass == Approx(800 * 1e-4 * 0.0032));
    o.sheet = SheetOptions{1e-4, 0.08};
    const AssetData by_area = must_bake(o);
    CHECK(by_area.mass == Approx(by_density.mass));
    for (std::size_t i = 0; i < 36; ++i) {
        CHECK(by_area.added_mass[i] == by_density.added_mass[i]);
        if (by_area.added_mass[i] == 0.0) CHECK_FALSE(std::signbit(by_area.added_mass[i]));
    }
}

TEST_CASE("bake: meshes that are no bodies") {
    const test::Scratch scratch;
    const auto fault = [&](const std::string& name, const std::string& text) {
        return fault_of(mesh_options(scratch.write(name, text)));
    };
    const std::string good = test::obj_text(test::ellipsoid(0.03, 0.027, 0.024, 2));
    CHECK(fault("good.obj", good) == FaultId{});
    CHECK(fault_of(mesh_options(scratch.path("none.obj"))) == FaultId::file_not_found);
    CHECK(fault_of(mesh_options(scratch.path(""))) == FaultId::file_read);
    CHECK(fault_of(mesh_options("/dev/zero")) == FaultId::file_read);
    CHECK(fault("empty.obj", "") == FaultId::mesh_empty);
    CHECK(fault("garbage.stl", std::string("\x01\x02\x00\xff garbage", 12)) == FaultId::mesh_unreadable);
    BakeOptions open = mesh_options(scratch.write("open.obj", good.substr(0, good.rfind("f "))));
    open.strict = true;
    CHECK(fault_of(open) == FaultId::mesh_open_edge);
    open.strict = false;
    CHECK(fault_of(open) == FaultId{}); // a small hole is closed
    BakeOptions nan = mesh_options(scratch.write("nan.obj", good + "v nan 0 0\nf 1 2 -1\n"));
    CHECK(fault_of(nan) == FaultId{}); // the face is left out
    nan.strict = true;
    CHECK(fault_of(nan) == FaultId::mesh_not_finite);
    CHECK(fault("index.obj", good + "f 1 2 99999\n") == FaultId::mesh_bad_index);

    BakeOptions tiny = mesh_options(scratch.path("good.obj"));
    const std::string in_nanometres = test::obj_text(test::ellipsoid(0.03, 0.027, 0.024, 2), 1e-6);
    tiny.mesh_path = scratch.write("tiny.obj", in_nanometres);
    CHECK(fault_of(tiny) == FaultId::parameter_out_of_range);

    BakeOptions outside = mesh_options(scratch.path("good.obj"));
    outside.center_of_mass = {0.0, 0.0, 0.05};
    CHECK(fault_of(outside) == FaultId::parameter_out_of_range);
}

TEST_CASE("bake: every phase begins and ends once, and never goes back") {
    const test::Scratch scratch;
    const std::string path = scratch.write("body.obj", test::obj_text(test::ellipsoid(0.03, 0.02, 0.01, 2)));
    std::vector<std::pair<std::string, std::vector<double>>> phases;
    AssetData asset;
    Faults faults;
    BakeTimings timings;
    REQUIRE(bake(mesh_options(path), asset, faults, &timings, [&](const char* phase, double fraction) {
        if (phases.empty() || phases.back().first != phase) phases.push_back({phase, {}});
        phases.back().second.push_back(fraction);
    }));
    REQUIRE(phases.size() == timings.size());
    for (std::size_t i = 0; i < phases.size(); ++i) {
        const std::string& name = phases[i].first;
        const std::vector<double>& fractions = phases[i].second;
        CAPTURE(name);
        CHECK(name == timings[i].first);
        CHECK(fractions.front() == 0.0);
        CHECK(fractions.back() == 1.0);
        CHECK(std::count(fractions.begin(), fractions.end(), 1.0) == 1);
        CHECK(std::is_sorted(fractions.begin(), fractions.end()));
    }
}

TEST_CASE("file_io: all files are replaced, or none") {
    const test::Scratch scratch;
    const std::vector<uint8_t> bytes(100000, 7);
    const std::string content(bytes.begin(), bytes.end());
    Faults faults;
    scratch.write("a", "old a");
    REQUIRE(write_files({{scratch.path("a"), bytes}, {scratch.path("b"), bytes}}, faults));
    CHECK(scratch.read("a") == content);
    CHECK(scratch.read("b") == content);
    CHECK(scratch.names() == std::vector<std::string>{"a", "b"});

    scratch.write("a", "old a");
    for (const std::string& bad : {scratch.path("no_folder/c"), scratch.path(""), scratch.path("a/c"),
                                   std::string("/dev/full"), scratch.path(std::string(300, 'x')), std::string()}) {
        CAPTURE(bad);
        faults.clear();
        CHECK_FALSE(write_files({{scratch.path("a"), bytes}, {bad, bytes}}, faults));
        REQUIRE(faults.size() == 1);
        CHECK(faults[0].id == FaultId::file_write);
        CHECK(scratch.read("a") == "old a");
        CHECK(scratch.names() == std::vector<std::string>{"a", "b"});
    }
}

TEST_CASE("file_io: links are followed and permissions kept") {
    const test::Scratch scratch;
    const std::vector<uint8_t> bytes{1, 2, 3};
    Faults faults;
    const std::string real = scratch.write("real", "old");
    std::filesystem::permissions(real, std::filesystem::perms{0640});
    std::filesystem::create_symlink(real, scratch.path("link"));
    REQUIRE(write_files({{scratch.path("link"), bytes}}, faults));
    CHECK(std::filesystem::is_symlink(scratch.path("link")));
    CHECK(scratch.read("real") == "\x01\x02\x03");
    CHECK(std::filesystem::status(real).permissions() == std::filesystem::perms{0640});
}

TEST_CASE("file_io: reading says why not") {
    const test::Scratch scratch;
    std::vector<uint8_t> bytes;
    const auto fault = [&](const std::string& path, std::size_t limit) {
        Faults faults;
        if (read_file(path, limit, bytes, faults)) return FaultId{};
        REQUIRE(faults.size() == 1);
        return faults[0].id;
    };
    const std::string ten = scratch.write("ten", "0123456789");
    CHECK(fault(ten, 10) == FaultId{});
    CHECK(bytes.size() == 10);
    CHECK(fault(ten, 9) == FaultId::file_too_large);
    CHECK(fault(scratch.path("none"), 10) == FaultId::file_not_found);
    CHECK(fault(ten + "/none", 10) == FaultId::file_not_found);
    CHECK(fault(scratch.path(""), 10) == FaultId::file_read);
    CHECK(fault("/dev/zero", 10) == FaultId::file_read);
    CHECK(fault("", 10) == FaultId::file_not_found);
    const std::string large(1'000'000, 'x');
    CHECK(fault(scratch.write("large", large), 2'000'000) == FaultId{});
    CHECK(std::string(bytes.begin(), bytes.end()) == large);

    CHECK(is_same_file(ten, scratch.path("./ten")));
    CHECK(is_same_file(scratch.path("new"), scratch.path("./new")));
    CHECK_FALSE(is_same_file(ten, scratch.path("large")));
    CHECK_FALSE(is_same_file("/dev/null", "/dev/null"));
}

TEST_CASE("text: UTF-8, control characters and numbers") {
    CHECK(valid_utf8("caf\xc3\xa9 \xf0\x9f\x8d\x83") == "caf\xc3\xa9 \xf0\x9f\x8d\x83");
    const std::string bad = "\xef\xbf\xbd";
    for (const char* text : {"\xff", "\xc3", "\x80"}) CHECK(valid_utf8(text) == bad);
    CHECK(valid_utf8("\xc0\xaf") == bad + bad);                     // overlong
    CHECK(valid_utf8("\xed\xa0\x80") == bad + bad + bad);           // surrogate
    CHECK(valid_utf8("\xf4\x90\x80\x80") == bad + bad + bad + bad); // above U+10FFFF
    CHECK(printable("a\x1b[31mb\n\x7f\xc2\x9b") == "a?[31mb???");
    CHECK(shortest(0.1) == "0.1");
    CHECK(shortest(1.5e-5) == "1.5e-05");
    CHECK(shortest(32) == "32");
}
