// lr_bake for users: exit codes, streams, files.
#include "asset/asset_file.h"
#include "baker/json.h"
#include "baker/mesh_shapes.h"
#include "baker/scratch.h"
#include "base/fnv1a.h"

#include <doctest/doctest.h>

#include <cstring>

using namespace lr;
using test::Outcome;
using test::Scratch;

namespace {

Outcome lr_bake(const std::vector<std::string>& arguments, const test::RunOptions& options = {}) {
    return test::run(LR_BAKE_PATH, arguments, options);
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

// A numbered fault, with the file first, on standard error only.
void check_fault(const Outcome& outcome, const std::string& file, int number) {
    INFO(outcome.err);
    CHECK(outcome.exit_code == 1);
    CHECK(outcome.out.empty());
    CHECK(contains(outcome.err, file + ": error " + std::to_string(number)));
}

std::string small_mesh() {
    return test::obj_text(test::ellipsoid(0.03, 0.027, 0.024, 2));
}

// The offset of a root table's field in a FlatBuffer.
std::size_t field_at(const std::string& bytes, std::size_t id) {
    uint32_t root = 0;
    int32_t to_vtable = 0;
    uint16_t offset = 0;
    std::memcpy(&root, bytes.data(), 4);
    std::memcpy(&to_vtable, bytes.data() + root, 4);
    std::memcpy(&offset, bytes.data() + static_cast<std::ptrdiff_t>(root) - to_vtable + 4 + 2 * id, 2);
    REQUIRE(offset != 0);
    return root + offset;
}

std::string with_version(std::string bytes, uint32_t version) {
    std::memcpy(bytes.data() + field_at(bytes, 0), &version, 4);
    const std::size_t at = field_at(bytes, 1);
    std::memset(bytes.data() + at, 0, 8);
    Fnv1a hash;
    hash.add(bytes.data(), bytes.size());
    const uint64_t sum = hash.value();
    std::memcpy(bytes.data() + at, &sum, 8);
    return bytes;
}

} // namespace

TEST_CASE("lr_bake: from mesh to asset, report and back") {
    const Scratch scratch;
    const std::string mesh = scratch.write("caf\xc3\xa9.obj", small_mesh());
    const std::string asset = scratch.path("out.lrb"), report = scratch.path("r.json");
    const Outcome baked = lr_bake({"mesh", mesh, "-o", asset, "--report", report});
    CHECK(baked.exit_code == 0);
    CHECK(contains(baked.out, "caf\xc3\xa9"));
    CHECK(contains(baked.out, "mass"));
    CHECK(contains(baked.err, "added mass: "));
    CHECK_FALSE(contains(baked.err, "\x1b"));

    CHECK(lr_bake({"check", asset}).exit_code == 0);
    const Outcome info = lr_bake({"info", asset, "--json"});
    CHECK(info.exit_code == 0);
    CHECK(info.err.empty());
    CHECK(lr_bake({"info", asset, "--json"}).out == info.out);
    const test::Json said = test::Json::parse(info.out);
    const test::Json reported = test::Json::parse(scratch.read("r.json"));
    CHECK(reported["faults"].is_array());
    CHECK(reported["timings"].contains("added mass"));
    CHECK(said == reported.without("faults").without("timings").without("station_errors"));
    for (const char* key :
         {"name", "mass", "volume", "density", "center_of_mass", "inertia", "added_mass", "center_of_buoyancy", "fluid",
          "lengths", "u0", "reynolds", "c0", "turbulence", "provenance"})
        CHECK_MESSAGE(said.contains(key), key);
    CHECK(said["provenance"]["source"] == "caf\xc3\xa9.obj");
    CHECK_FALSE(contains(info.out, scratch.path(""))); // no folders
    CHECK(lr_bake({"info", asset}).exit_code == 0);
    CHECK(scratch.names() == std::vector<std::string>{"caf\xc3\xa9.obj", "out.lrb", "r.json"});

    const std::string again = scratch.path("again.lrb");
    CHECK(lr_bake({"mesh", mesh, "-o", again, "--quiet"}).exit_code == 0);
    CHECK(scratch.read("again.lrb") == scratch.read("out.lrb"));
}

TEST_CASE("lr_bake: the options of the command line arrive") {
    const Scratch scratch;
    const std::string asset = scratch.path("e.lrb");
    const Outcome baked =
        lr_bake({"ellipsoid",        "40",       "20",      "10",    "-o",     asset,     "--unit",      "mm",
                 "--density",        "1100",     "--fluid", "water", "--grid", "16,12,8", "--intensity", "0.5",
                 "--center-of-mass", "1,-2,0.5", "--name",  "drop",  "--quiet"});
    CHECK(baked.exit_code == 0);
    CHECK(baked.out.empty());
    CHECK(baked.err.empty());
    const test::Json j = test::Json::parse(lr_bake({"info", asset, "--json"}).out);
    CHECK(j["name"] == "drop");
    CHECK(j["lengths"]["d"] == 0.08);
    CHECK(j["density"] == 1100.0);
    CHECK(j["fluid"]["density"] == 998.0);
    CHECK(j["fluid"]["viscosity"] == 1e-6);
    CHECK(j["turbulence"]["cells"] == std::vector<double>{16, 12, 8});
    CHECK(j["turbulence"]["intensity"] == 0.5);
    CHECK(j["center_of_mass"] == std::vector<double>{0.001, -0.002, 0.0005});
    CHECK(j["center_of_buoyancy"] == std::vector<double>{-0.001, 0.002, -0.0005});

    // Air is the default, and several options mean it: the same bytes.
    const auto bytes = [&](std::vector<std::string> fluid) {
        std::vector<std::string> arguments{"ellipsoid", "0.04", "0.02", "0.01", "-o", asset, "--quiet"};
        arguments.insert(arguments.end(), fluid.begin(), fluid.end());
        CHECK(lr_bake(arguments).exit_code == 0);
        return scratch.read("e.lrb");
    };
    const std::string air = bytes({});
    CHECK(bytes({"--fluid", "air"}) == air);
    CHECK(bytes({"--fluid", "1.2,1.5e-5"}) == air);
    CHECK(bytes({"--fluid=1.20,0.000015", "--density=8e2"}) == air);
    CHECK(bytes({"--fluid", "1.3,1.5e-5"}) != air);
}

TEST_CASE("lr_bake: the last line says how the body falls, in the fluid of the bake") {
    const Scratch scratch;
    const auto last_line = [&](std::vector<std::string> more) {
        std::vector<std::string> arguments{"ellipsoid", "4", "2", "0.02", "--unit", "cm", "-o", scratch.path("e.lrb")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const std::string out = lr_bake(arguments).out;
        REQUIRE(out.ends_with("\n"));
        return out.substr(out.rfind('\n', out.size() - 2) + 1);
    };
    CHECK(last_line({"--density", "400"}).starts_with("  in air          falls at about "));
    CHECK(last_line({"--density", "1500", "--fluid", "water"}).starts_with("  in water        sinks at about "));
    CHECK(last_line({"--density", "400", "--fluid", "water"}).starts_with("  in water        rises at about "));
    CHECK(last_line({"--density", "998", "--fluid", "water"}) == "  in water        floats\n");
    CHECK(last_line({"--density", "300", "--fluid", "60,1e-5"}).starts_with("  in its fluid    falls at "));
}

TEST_CASE("lr_bake: an open mesh is refused with --strict and baked as a sheet") {
    const Scratch scratch;
    const std::string mesh = scratch.write("card.obj", "v 0 0 0\nv 8 0 0\nv 8 4 0\nv 0 4 0\nf 1 2 3 4\n");
    const std::string out = scratch.path("card.lrb"), report = scratch.path("card.json");
    const Outcome solid = lr_bake({"mesh", mesh, "-o", out, "--strict"});
    check_fault(solid, mesh, 206);
    CHECK(contains(solid.err, "--sheet"));
    CHECK(lr_bake({"mesh", mesh, "-o", out, "--report", report, "--unit", "cm", "--sheet", "--thickness", "0.01",
                   "--areal-density", "0.07", "--quiet"})
              .exit_code == 0);
    CHECK(lr_bake({"check", out}).exit_code == 0);
    const test::Json said = test::Json::parse(scratch.read("card.json"));
    CHECK(said["mass"].number() == doctest::Approx(0.07 * 0.0032));
    CHECK(said["volume"].number() == doctest::Approx(1e-4 * 0.0032));
    CHECK(said["density"].number() == doctest::Approx(700));
    CHECK(said["lengths"]["b"].number() == doctest::Approx(1e-4));
    CHECK(said["center_of_mass"][0].number() == doctest::Approx(0.04));
    CHECK(said["added_mass"][14].number() ==
          doctest::Approx(1.2 * .7569 * 3.14159265 / 4 * 0.08 * 0.04 * 0.04).epsilon(0.004));
    CHECK(said["inertia"][8].number() == doctest::Approx(0.000224 / 12 * (0.0064 + 0.0016)));
    CHECK(said["provenance"]["options"] ==
          "mesh --unit cm --sheet --thickness 0.01 --areal-density 0.07 --fluid 1.2,1.5e-05 --grid 32,32,16 "
          "--intensity 1");
    CHECK(said["faults"].empty());
}

TEST_CASE("lr_bake: help and version are no errors, wrong usage is 2") {
    CHECK(lr_bake({"--help"}).exit_code == 0);
    CHECK(lr_bake({"mesh", "--help"}).exit_code == 0);
    const Outcome version = lr_bake({"--version"});
    CHECK(version.exit_code == 0);
    CHECK(contains(version.out, "lr_bake "));

    const Scratch scratch;
    const std::string mesh = scratch.write("body.obj", small_mesh()), out = scratch.path("out.lrb");
    const auto usage = [&](const std::vector<std::string>& arguments) {
        const Outcome outcome = lr_bake(arguments);
        CAPTURE(outcome.err);
        CHECK(outcome.exit_code == 2);
        CHECK_FALSE(outcome.err.empty());
        CHECK_FALSE(scratch.has("out.lrb"));
    };
    usage({});
    usage({"bogus"});
    usage({"mesh"});
    usage({"mesh", mesh});
    usage({"mesh", "-o", out});
    usage({"mesh", mesh, mesh, "-o", out});
    usage({"mesh", mesh, "-o", ""});
    usage({"mesh", mesh, "-o", out, "--report", ""});
    usage({"ellipsoid", "1", "2", "-o", out});
    usage({"ellipsoid", "1", "2", "3", "4", "-o", out});
    usage({"ellipsoid", "1", "2", "3x", "-o", out});
    usage({"info"});
    usage({"check"});
    usage({"check", out, "--json"});
    for (const std::vector<std::string>& bad : std::vector<std::vector<std::string>>{
             {"--unit", "ft"},
             {"--unit", "M"},
             {"--unit", ""},
             {"--density"},
             {"--density", "8e2x"},
             {"--density", "8e2 "},
             {"--density", " 800"},
             {"--density", "0x10"},
             {"--density", ""},
             {"--density", "1,2"},
             {"--density", "1e999"},
             {"--density", "1", "--density", "2"},
             {"--fluid", "oil"},
             {"--fluid", "1.2"},
             {"--fluid", "1.2,"},
             {"--fluid", ",1e-5"},
             {"--fluid", "1.2,1e-5,1"},
             {"--fluid", "1.2;1e-5"},
             {"--fluid", "1.2,1e-5m"},
             {"--fluid", "Air"},
             {"--grid", "32"},
             {"--grid", "32,32"},
             {"--grid", "32,32,16,1"},
             {"--grid", "32,32,1.5"},
             {"--grid", "-4,32,16"},
             {"--grid", "a,b,c"},
             {"--grid", "99999999999,4,4"},
             {"--center-of-mass", "1"},
             {"--sheet", "--thickness", "thin"},
             {"--thickness", "1e-4 ft"},
             {"--size", "7in"},
             {"--areal-density", "0.07"},
             {"--sheet", "--thickness", "1e-4", "--areal-density", "0.07", "--density", "700"},
             {"--unknown"},
             {"--report"}}) {
        std::vector<std::string> arguments{"mesh", mesh, "-o", out};
        arguments.insert(arguments.end(), bad.begin(), bad.end());
        usage(arguments);
    }
}

TEST_CASE("lr_bake: bad input is a numbered fault and leaves the old asset alone") {
    const Scratch scratch;
    const std::string mesh = scratch.write("body.obj", small_mesh()), out = scratch.path("out.lrb");
    REQUIRE(lr_bake({"mesh", mesh, "-o", out, "--quiet"}).exit_code == 0);
    const std::string before = scratch.read("out.lrb");

    const auto refused = [&](const std::string& input, int number, std::vector<std::string> more = {"--quiet"}) {
        std::vector<std::string> arguments{"mesh", input, "-o", out};
        arguments.insert(arguments.end(), more.begin(), more.end());
        check_fault(lr_bake(arguments), input, number);
        REQUIRE(scratch.read("out.lrb") == before);
    };
    refused(scratch.path("none.obj"), 101);
    refused(scratch.path(""), 102);
    refused(scratch.write("empty.obj", ""), 202);
    refused(scratch.write("garbage.obj", std::string("\x00\x01\xff\xfe{}", 6)), 202);
    refused(scratch.write("garbage.stl", "\x01 garbage"), 201);
    refused(scratch.write("nothing.stl", "solid nothing"), 202);
    refused(scratch.write("nan.obj", "v nan 0 0\n" + small_mesh()), 203, {"--strict"});
    const std::string text = small_mesh();
    refused(scratch.write("open.obj", text.substr(0, text.rfind("f "))), 206, {"--strict"});
    refused(scratch.write("asset.lrb", before), 201); // not a mesh
    refused(out, 301);                                // its own output
    for (const char* bad : {"0", "-800", "nan", "inf", "-inf", "1e9"}) refused(mesh, 301, {"--density", bad});
    for (const char* bad : {"0,1e-5", "1.2,0", "-1.2,1e-5", "nan,nan"}) refused(mesh, 301, {"--fluid", bad});
    for (const char* bad : {"3,32,16", "0,0,0", "32,32,4000000000", "512,512,512"}) refused(mesh, 301, {"--grid", bad});
    refused(mesh, 301, {"--intensity", "0"});
    refused(mesh, 301, {"--center-of-mass", "1,0,0"});
    check_fault(lr_bake({"ellipsoid", "1", "0", "1", "-o", out}), "ellipsoid", 301);
    check_fault(lr_bake({"ellipsoid", "1", "1", "1e5", "-o", out}), "ellipsoid", 301);
    check_fault(lr_bake({"ellipsoid", "1", "1", "nan", "-o", out}), "ellipsoid", 301);
    CHECK(scratch.read("out.lrb") == before);
    for (const std::string& name : scratch.names()) CHECK_FALSE(contains(name, ".part"));
}

TEST_CASE("lr_bake: repairs are warnings, which --quiet silences and the report keeps") {
    const Scratch scratch;
    test::Mesh inside_out = test::ellipsoid(0.03, 0.027, 0.024, 2);
    for (auto& f : inside_out.faces) std::swap(f[1], f[2]);
    const std::string mesh = scratch.write("body.obj", test::obj_text(inside_out)), out = scratch.path("out.lrb");
    const Outcome loud = lr_bake({"mesh", mesh, "-o", out, "--report", scratch.path("r.json")});
    CHECK(loud.exit_code == 0);
    CHECK(contains(loud.err, mesh + ": warning 209 at "));
    const test::Json report = test::Json::parse(scratch.read("r.json"));
    REQUIRE(report["faults"].size() == 1);
    CHECK(report["faults"][0]["number"] == 209);
    CHECK(report["faults"][0]["severity"] == "warning");
    const Outcome quiet = lr_bake({"mesh", mesh, "-o", out, "--quiet"});
    CHECK(quiet.exit_code == 0);
    CHECK(quiet.err.empty());
}

TEST_CASE("lr_bake: outputs that cannot be written are fault 103, and nothing is left behind") {
    const Scratch scratch;
    const std::string mesh = scratch.write("body.obj", small_mesh()), out = scratch.path("out.lrb");
    std::filesystem::create_directory(scratch.path("folder"));
    const std::vector<std::string> before = scratch.names();
    for (const std::string& bad :
         {scratch.path("folder"), scratch.path("none/out.lrb"), mesh + "/out.lrb", scratch.path("out.lrb/"),
          std::string("/dev/full"), scratch.path(std::string(300, 'x'))}) {
        CAPTURE(bad);
        check_fault(lr_bake({"mesh", mesh, "-o", bad, "--quiet"}), bad, 103);
        check_fault(lr_bake({"mesh", mesh, "-o", out, "--report", bad, "--quiet"}), bad, 103);
        CHECK(scratch.names() == before);
    }
    if (geteuid() != 0) { // root can write anywhere
        std::filesystem::permissions(scratch.path("folder"),
                                     std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
        check_fault(lr_bake({"mesh", mesh, "-o", scratch.path("folder/out.lrb"), "--quiet"}),
                    scratch.path("folder/out.lrb"), 103);
    }
    test::RunOptions limited;
    limited.file_size_limit = 1000;
    check_fault(lr_bake({"mesh", mesh, "-o", out, "--quiet"}, limited), out, 103);
    CHECK(scratch.names() == before);
    CHECK(lr_bake({"mesh", mesh, "-o", "/dev/null", "--report", "/dev/null", "--quiet"}).exit_code == 0);

    check_fault(lr_bake({"mesh", mesh, "-o", mesh}), mesh, 301);
    check_fault(lr_bake({"mesh", mesh, "-o", out, "--report", mesh}), mesh, 301);
    check_fault(lr_bake({"mesh", mesh, "-o", out, "--report", scratch.path("./out.lrb")}), mesh, 301);
    CHECK(scratch.read("body.obj") == small_mesh());
    CHECK(scratch.names() == before);
}

TEST_CASE("lr_bake: stopped at any moment, it leaves a whole asset or none") {
    const Scratch scratch;
    const std::string mesh = scratch.write("body.obj", small_mesh()), out = scratch.path("out.lrb");
    for (int delay = 0; delay < 60000; delay += 1500) {
        test::RunOptions options;
        options.kill_after_microseconds = delay;
        const Outcome outcome = lr_bake({"mesh", mesh, "-o", out, "--quiet"}, options);
        CHECK((outcome.exit_code == 0 || outcome.exit_code == 128 + SIGTERM));
        for (const std::string& name : scratch.names()) CHECK((name == "body.obj" || name == "out.lrb"));
        if (!scratch.has("out.lrb")) continue;
        const std::string bytes = scratch.read("out.lrb");
        AssetData asset;
        Faults faults;
        CHECK(read_asset(bytes.data(), bytes.size(), asset, faults));
        std::filesystem::remove(out);
    }
}

TEST_CASE("lr_bake check: damaged, foreign and newer files") {
    const Scratch scratch;
    const std::string asset = scratch.path("good.lrb");
    REQUIRE(lr_bake({"ellipsoid", "0.04", "0.02", "0.01", "-o", asset, "--quiet"}).exit_code == 0);
    const std::string good = scratch.read("good.lrb");
    const auto check = [&](const std::string& name, const std::string& bytes) {
        const Outcome outcome = lr_bake({"check", scratch.write(name, bytes)});
        CAPTURE(outcome.err);
        CHECK(outcome.exit_code == 1);
        const std::size_t at = outcome.err.find(": error 4");
        REQUIRE(at != std::string::npos);
        return std::stoi(outcome.err.substr(at + 8, 3));
    };
    const std::size_t rarely = test::sanitized ? 10 : 1;
    for (std::size_t size = 0; size < good.size(); size += size < 20 ? 1 : 211 * rarely) {
        CAPTURE(size);
        const int number = check("short.lrb", good.substr(0, size));
        CHECK((size < 16 ? number == 401 : number == 404 || number == 405));
    }
    check("long.lrb", good + "x");
    check("long.lrb", good + std::string(8, '\0'));
    for (std::size_t i = 0; i < good.size(); i += 47 * rarely) {
        CAPTURE(i);
        std::string flipped = good;
        flipped[i] = static_cast<char>(flipped[i] ^ (1 << (i % 8)));
        check("flipped.lrb", flipped);
    }
    CHECK(check("foreign.lrb", small_mesh()) == 402);
    CHECK(check("zeros.lrb", std::string(4096, '\0')) == 402);
    CHECK(check("newer.lrb", with_version(good, asset_format_version + 1)) == 403);
    CHECK(check("newer.lrb", with_version(good, 0xffffffffu)) == 403);
    CHECK(check("version0.lrb", with_version(good, 0)) == 406);
    CHECK(with_version(good, asset_format_version) == good);
    check_fault(lr_bake({"check", scratch.path("none.lrb")}), scratch.path("none.lrb"), 101);
    check_fault(lr_bake({"check", scratch.path("")}), scratch.path(""), 102);
    check_fault(lr_bake({"check", "/dev/zero"}), "/dev/zero", 102);
    check_fault(lr_bake({"info", scratch.path("foreign.lrb")}), scratch.path("foreign.lrb"), 402);
    check_fault(lr_bake({"info", scratch.path("foreign.lrb"), "--json"}), scratch.path("foreign.lrb"), 402);
}

// Every byte, in process: a program for each would take minutes.
TEST_CASE("asset file: no byte can change unseen") {
    const Scratch scratch;
    REQUIRE(lr_bake({"ellipsoid", "0.04", "0.02", "0.01", "-o", scratch.path("good.lrb"), "--quiet"}).exit_code == 0);
    std::string bytes = scratch.read("good.lrb");
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const char before = bytes[i];
        bytes[i] = static_cast<char>(before ^ (1 << (i % 8)));
        AssetData asset;
        Faults faults;
        const bool read = read_asset(bytes.data(), bytes.size(), asset, faults);
        CHECK_MESSAGE(!read, "byte ", i);
        bytes[i] = before;
    }
}

TEST_CASE("lr_bake info: a full disk behind standard output is an error, and names cannot drive the terminal") {
    const Scratch scratch;
    const std::string asset = scratch.path("e.lrb");
    REQUIRE(lr_bake({"ellipsoid", "0.04", "0.02", "0.01", "-o", asset, "--name", "a\x1b[2Jb", "--quiet"}).exit_code ==
            0);
    test::RunOptions full;
    full.standard_output = "/dev/full";
    const Outcome outcome = lr_bake({"info", asset, "--json"}, full);
    CHECK(outcome.exit_code == 1);
    CHECK(contains(outcome.err, "error 103"));
    const Outcome info = lr_bake({"info", asset});
    CHECK_FALSE(contains(info.out, "\x1b"));
    CHECK(contains(info.out, "a?[2Jb"));
    const std::string strange = scratch.write("\x1b[2J.obj", "");
    CHECK_FALSE(contains(lr_bake({"mesh", strange, "-o", asset}).err, "\x1b"));
}
