// Many meshes in one call, and conditions for baking again.
#include "asset/asset_file.h"
#include "baker/file_io.h"
#include "baker/json.h"
#include "baker/mesh_shapes.h"
#include "baker/png_files.h"
#include "baker/scene_files.h"
#include "baker/scratch.h"
#include "langevin_rigid_baker.hpp"
#include "tools/lr_bake/bake_many.h"
#include "tools/lr_bake/memory_budget.h"

#include <doctest/doctest.h>

#include <atomic>
#include <thread>

using namespace lr;
using namespace lr::baker;
using test::Outcome;
using test::Scratch;

namespace {

Outcome lr_bake(const std::vector<std::string>& arguments, const test::RunOptions& options = {}) {
    return test::run(LR_BAKE_PATH, arguments, options);
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::string body(double a, int levels = 2) {
    return test::obj_text(test::ellipsoid(a, 0.9 * a, 0.8 * a, levels));
}

std::string numbered(const char* before, int i, const char* after) {
    std::string name = before;
    name += std::to_string(i);
    name += after;
    return name;
}

// A cube whose positions are in a separate file.
void write_gltf(const Scratch& scratch, float side) {
    const Mesh cube = test::cube(1);
    std::string bytes;
    const auto append = [&](const auto value) {
        char raw[sizeof value];
        std::memcpy(raw, &value, sizeof value);
        bytes.append(raw, sizeof value);
    };
    for (const Eigen::Vector3d& v : cube.vertices)
        for (const double x : v) append(static_cast<float>(x) * side);
    for (const Face& f : cube.faces)
        for (const uint32_t i : f) append(i);
    scratch.write("cube.bin", bytes);
    scratch.write("cube.gltf", R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"buffers":[{"uri":"cube.bin","byteLength":240}],
"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":144}],"accessors":[
{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3","min":[-1,-1,-1],"max":[1,1,1]},
{"bufferView":1,"componentType":5125,"count":36,"type":"SCALAR"}]})");
}

} // namespace

TEST_CASE("batch: each input has its asset, its report and its line, a bad one stops no other") {
    const Scratch scratch;
    std::vector<std::string> meshes;
    for (int i = 0; i < 5; ++i) meshes.push_back(scratch.write(numbered("body", i, ".obj"), body(0.03 + 0.001 * i)));
    meshes.insert(meshes.begin() + 2, scratch.write("bad.obj", "v 0 0 0\nf 1 2 3\n"));
    meshes.insert(meshes.begin() + 4, scratch.path("none.obj"));
    const std::string out = scratch.path("out"), reports = scratch.path("reports");
    std::vector<std::string> arguments{"mesh", "-d", out, "--report", reports, "--density", "700", "--jobs", "3"};
    arguments.insert(arguments.end(), meshes.begin(), meshes.end());
    const Outcome outcome = lr_bake(arguments);
    CAPTURE(outcome.out);
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 1);
    // In the order of the command line, whatever finishes first.
    std::size_t at = 0;
    for (const std::string& mesh : meshes) {
        const bool good = contains(mesh, "body");
        const std::size_t found = outcome.out.find(mesh + (good ? ": baked, " : ": failed, error "), at);
        REQUIRE(found != std::string::npos);
        at = found;
    }
    CHECK(contains(outcome.out, "5 baked, 0 unchanged, 2 failed"));
    CHECK(contains(outcome.err, scratch.path("bad.obj") + ": error 204"));
    CHECK(contains(outcome.err, scratch.path("none.obj") + ": error 101"));
    CHECK(contains(outcome.err, "2 of 7 failed"));
    CHECK_FALSE(contains(outcome.err, "\x1b"));
    for (int i = 0; i < 5; ++i) {
        const std::string stem = numbered("body", i, "");
        // The bytes of a separate bake.
        REQUIRE(
            lr_bake({"mesh", scratch.path(stem + ".obj"), "-o", scratch.path("one.lrb"), "--density", "700", "--quiet"})
                .exit_code == 0);
        CHECK(scratch.read("out/" + stem + ".lrb") == scratch.read("one.lrb"));
        CHECK(test::Json::parse(scratch.read("reports/" + stem + ".json"))["name"] == stem);
    }
    for (const char* missing : {"out/bad.lrb", "out/none.lrb", "reports/bad.json"}) CHECK_FALSE(scratch.has(missing));

    arguments.push_back("--quiet");
    const Outcome quiet = lr_bake(arguments);
    CHECK(quiet.exit_code == 1);
    CHECK(quiet.out.empty());
    CHECK(contains(quiet.err, "error 204"));
}

TEST_CASE("batch: inputs from a list, into a folder named with or without its option") {
    const Scratch scratch;
    scratch.write("a [1].obj", body(0.03));
    scratch.write("-b.obj", body(0.04));
    const std::string list = scratch.write("list", scratch.path("a [1].obj") + "\r\n\n" + scratch.path("-b.obj"));
    CHECK(lr_bake({"mesh", "--list", list, "-d", scratch.path("out"), "--quiet"}).exit_code == 0);
    CHECK(scratch.has("out/a [1].lrb"));
    CHECK(scratch.has("out/-b.lrb"));
    const Outcome one = lr_bake({"mesh", scratch.path("a [1].obj"), "-o", scratch.path("out/")});
    CHECK(one.exit_code == 0);
    CHECK(contains(one.out, "unchanged"));
    const Outcome two = lr_bake({"mesh", scratch.path("a [1].obj"), scratch.path("-b.obj"), "-o", scratch.path("out")});
    CHECK(contains(two.out, "0 baked, 2 unchanged, 0 failed"));
    const Outcome none = lr_bake({"mesh", "--list", scratch.path("none"), "-d", scratch.path("out")});
    CHECK(none.exit_code == 1);
    CHECK(contains(none.err, "error 101"));
    const Outcome empty = lr_bake({"mesh", "--list", scratch.write("empty", "\n"), "-d", scratch.path("out")});
    CHECK(empty.exit_code == 0);
    CHECK(contains(empty.out, "0 baked"));
}

TEST_CASE("batch: wrong usage is 2 and does nothing") {
    const Scratch scratch;
    std::filesystem::create_directory(scratch.path("other"));
    const std::string a = scratch.write("a.obj", body(0.03)), same = scratch.write("other/a.ply", "ply\n"),
                      b = scratch.write("b.obj", body(0.04)), out = scratch.path("out");
    const auto usage = [&](const std::vector<std::string>& arguments) {
        const Outcome outcome = lr_bake(arguments);
        CAPTURE(outcome.err);
        CHECK(outcome.exit_code == 2);
        CHECK_FALSE(outcome.err.empty());
        CHECK_FALSE(scratch.has("out"));
    };
    usage({"mesh", a, same, "-d", out}); // both a.lrb
    usage({"mesh", a, a, "-d", out});
    usage({"mesh", a, b, "-o", out}); // no folder
    usage({"mesh", a, b, "-o", scratch.path("out.lrb")});
    usage({"mesh", a, b, "-d", out, "-o", out});
    usage({"mesh", a, b, "-d", ""});
    usage({"mesh", a, "", "-d", out});
    usage({"mesh", "-d", out});
    usage({"mesh", "--list", "", "-d", out});
    usage({"mesh", a, b, "-d", out, "--name", "both"});
    usage({"mesh", a, "-d", out, "--report", ""});
    usage({"mesh", a, "-d", out, "--force", "--if-changed"});
    for (const char* jobs : {"0", "-1", "x", "", "1.5", "1025", "99999999999"})
        usage({"mesh", a, "-d", out, "--jobs", jobs});
    usage({"mesh", a, "-o", out, "--jobs", "2"});
    usage({"mesh", a, "-o", out, "--force"});
    usage({"ellipsoid", "1", "2", "3", "-d", out});
}

TEST_CASE("batch: folders that cannot be are fault 103") {
    const Scratch scratch;
    const std::string a = scratch.write("a.obj", body(0.03));
    for (const std::string& bad : {a, scratch.path("none/out"), std::string("/dev/null/x")}) {
        const Outcome outcome = lr_bake({"mesh", a, "-d", bad});
        CHECK(outcome.exit_code == 1);
        CHECK(contains(outcome.err, bad + ": error 103"));
        CHECK(lr_bake({"mesh", a, "-d", scratch.path("out"), "--report", bad}).exit_code == 1);
    }
    CHECK_FALSE(scratch.has("out/a.lrb"));
}

TEST_CASE("batch: only what changed is baked again") {
    const Scratch scratch;
    const std::string mesh = scratch.write("a.obj", body(0.03)), out = scratch.path("out"), reports = scratch.path("r");
    const auto run = [&](std::vector<std::string> more) {
        std::vector<std::string> arguments{"mesh", mesh, "-d", out};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = lr_bake(arguments);
        INFO(outcome.err);
        REQUIRE(outcome.exit_code == 0);
        const std::string line = outcome.out.substr(0, outcome.out.find('\n'));
        return line.substr(mesh.size() + 2, line.rfind(',') - mesh.size() - 2);
    };
    CHECK(run({}) == "baked");
    CHECK(run({}) == "unchanged");
    CHECK(run({"--if-changed"}) == "unchanged");
    CHECK(run({"--force"}) == "baked");
    CHECK(run({"--density", "800.0"}) == "unchanged"); // the same density in another form
    CHECK(run({"--density", "801"}) == "baked");
    CHECK(run({"--density", "801"}) == "unchanged");
    CHECK(run({}) == "baked");

    // A missing report, an existing one, one of an older asset.
    CHECK(run({"--report", reports}) == "baked");
    CHECK(run({"--report", reports}) == "unchanged");
    CHECK(run({"--density", "801"}) == "baked");
    CHECK(run({"--density", "801", "--report", reports}) == "baked");
    CHECK(test::Json::parse(scratch.read("r/a.json"))["density"] == 801.0);
    CHECK(run({"--density", "801", "--report", reports}) == "unchanged");
    scratch.write("r/a.json", "{}");
    CHECK(run({"--density", "801", "--report", reports}) == "baked");

    CHECK(run({}) == "baked");
    const std::string good = scratch.read("out/a.lrb");
    std::string damaged = good;
    damaged[damaged.size() / 2] ^= 1;
    for (const std::string& bad : {damaged, good.substr(0, good.size() - 8), std::string()}) {
        scratch.write("out/a.lrb", bad);
        CHECK(run({}) == "baked");
        CHECK(scratch.read("out/a.lrb") == good);
    }
    scratch.write("a.obj", body(0.031));
    CHECK(run({}) == "baked");
    CHECK(scratch.read("out/a.lrb") != good);
    CHECK(run({}) == "unchanged");
    // Made by another baker version.
    AssetData asset;
    Faults faults;
    const std::string bytes = scratch.read("out/a.lrb");
    REQUIRE(read_asset(bytes.data(), bytes.size(), asset, faults));
    asset.provenance.tool_version = "0.0.1";
    const std::vector<uint8_t> older = write_asset(asset);
    scratch.write("out/a.lrb", std::string(older.begin(), older.end()));
    CHECK(run({}) == "baked");
    // An asset of the same bytes under another name counts as different.
    std::filesystem::copy_file(mesh, scratch.path("b.obj"));
    std::filesystem::copy_file(scratch.path("out/a.lrb"), scratch.path("out/b.lrb"));
    CHECK(contains(lr_bake({"mesh", scratch.path("b.obj"), "-d", out}).out, "1 baked"));
}

TEST_CASE("batch: cards, too, by the tool and in process") {
    const Scratch scratch;
    const auto ellipse = [](double a, double b) {
        return test::png_file(test::draw(64, 64, [=](double x, double y) {
            return std::pow((x - 32.0) / a, 2) + std::pow((y - 32.0) / b, 2) < 1.0;
        }));
    };
    scratch.write("a.png", ellipse(28.0, 14.0));
    scratch.write("b.png", ellipse(20.0, 10.0));
    const std::vector<std::string> arguments{"card",
                                             scratch.path("a.png"),
                                             scratch.path("b.png"),
                                             "-d",
                                             scratch.path("out"),
                                             "--width",
                                             "8",
                                             "--unit",
                                             "cm",
                                             "--thickness",
                                             "0.02",
                                             "--triangles",
                                             "300"};
    CHECK(contains(lr_bake(arguments).out, "2 baked, 0 unchanged, 0 failed"));
    CHECK(contains(lr_bake(arguments).out, "0 baked, 2 unchanged, 0 failed"));
    scratch.write("b.png", ellipse(21.0, 10.0));
    CHECK(contains(lr_bake(arguments).out, "1 baked, 1 unchanged, 0 failed"));

    langevin_rigid::BakeOptions options;
    options.unit = langevin_rigid::Unit::centimetre;
    options.sheet = langevin_rigid::BakeSheet{0.02, {}};
    options.card.emplace();
    options.card->width = 8.0;
    options.card->triangles = 300;
    const std::string image = scratch.read("a.png"), asset = scratch.read("out/a.lrb");
    for (const langevin_rigid::BakeResult& result :
         {langevin_rigid::bake_memory(image.data(), image.size(), "a.png", options),
          langevin_rigid::bake_file(scratch.path("a.png"), options)}) {
        REQUIRE(result);
        CHECK(std::string(result.asset.begin(), result.asset.end()) == asset);
    }
}

TEST_CASE("batch: a single bake is skipped only if asked") {
    const Scratch scratch;
    const std::string out = scratch.path("e.lrb");
    const std::vector<std::string> plain{"ellipsoid", "0.04", "0.02", "0.01", "-o", out};
    std::vector<std::string> asked = plain;
    asked.push_back("--if-changed");
    CHECK(contains(lr_bake(asked).out, "written"));
    CHECK(contains(lr_bake(plain).out, "written"));
    CHECK(lr_bake(asked).out == out + ": unchanged\n");
    asked[1] = "0.05";
    CHECK(contains(lr_bake(asked).out, "written"));
}

TEST_CASE("input hash: without baking, the same as in the asset, whatever the input" * doctest::test_suite("exact")) {
    const Scratch scratch;
    write_gltf(scratch, 0.02F);
    scratch.write("a.obj", body(0.03));
    scratch.write("a.glb", test::glb(test::tetrahedron(), test::two_nodes()));
    const auto check = [&](const BakeOptions& o) {
        AssetData asset;
        Faults faults;
        REQUIRE(bake(o, asset, faults));
        const std::optional<uint64_t> hash = find_input_hash(o);
        REQUIRE(hash.has_value());
        CHECK(*hash == asset.provenance.input_hash);
        CHECK(asset.name == asset_name(o));
        CHECK(asset.provenance.source == source_name(o));
        return *hash;
    };
    BakeOptions o;
    o.mesh_path = scratch.path("a.obj");
    const uint64_t from_file = check(o);
    const std::string bytes = scratch.read("a.obj");
    BakeOptions memory;
    memory.mesh_path = "a.obj";
    memory.mesh_bytes = {reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()};
    CHECK(check(memory) == from_file);
    o.mesh_path = scratch.path("a.glb");
    o.mesh = "Right";
    check(o);
    o.mesh.reset();
    o.mesh_path = scratch.path("cube.gltf");
    const uint64_t small = check(o);
    // The separate file matters: it alone has the cube's size.
    write_gltf(scratch, 0.03F);
    CHECK(check(o) != small);
    write_gltf(scratch, 0.02F);
    CHECK(check(o) == small);
    std::filesystem::remove(scratch.path("cube.bin"));
    CHECK_FALSE(find_input_hash(o).has_value());
    BakeOptions closed;
    closed.semi_axes = {0.03, 0.02, 0.01};
    check(closed);
    const Mesh mesh = test::ellipsoid(0.03, 0.027, 0.024, 2);
    BakeOptions arrays;
    arrays.mesh_path = "leaf";
    std::vector<double> positions;
    std::vector<uint32_t> indices;
    for (const Eigen::Vector3d& v : mesh.vertices) positions.insert(positions.end(), v.begin(), v.end());
    for (const Face& f : mesh.faces) indices.insert(indices.end(), f.begin(), f.end());
    arrays.mesh_arrays = {positions, indices};
    const uint64_t before = check(arrays);
    positions[0] *= 1.01;
    CHECK(check(arrays) != before);
}

TEST_CASE("input files: what a mesh refers to must be a file") {
    const Scratch scratch;
    write_gltf(scratch, 0.02F);
    BakeOptions good;
    good.mesh_path = scratch.path("cube.gltf");
    CHECK(find_input_hash(good).has_value());
    std::filesystem::remove(scratch.path("cube.bin"));
    std::filesystem::create_symlink("/dev/zero", scratch.path("cube.bin"));
    BakeOptions o;
    o.mesh_path = scratch.path("cube.gltf");
    AssetData asset;
    Faults faults;
    CHECK_FALSE(bake(o, asset, faults));
    REQUIRE_FALSE(faults.empty());
    CHECK(faults.back().id == FaultId::file_outside); // links are followed

    // Bytes in memory refer to no file, not even by an absolute path.
    write_gltf(scratch, 0.02F);
    std::string text = scratch.read("cube.gltf");
    text.replace(text.find("cube.bin"), 8, scratch.path("cube.bin"));
    o.mesh_bytes = {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
    faults.clear();
    CHECK_FALSE(bake(o, asset, faults));
    REQUIRE_FALSE(faults.empty());
    CHECK(faults.back().id == FaultId::mesh_unreadable);
}

TEST_CASE("batch: stopped at any moment, it leaves whole assets and nothing else") {
    const Scratch scratch;
    std::vector<std::string> arguments{"mesh",    "-d",     scratch.path("out"), "--report", scratch.path("out"),
                                       "--quiet", "--force"};
    for (int i = 0; i < 8; ++i) arguments.push_back(scratch.write(numbered("m", i, ".obj"), body(0.03 + 0.001 * i)));
    int stopped = 0;
    for (int delay = 0; delay < 300000; delay += 9000) {
        test::RunOptions options;
        options.kill_after_microseconds = delay;
        stopped += lr_bake(arguments, options).exit_code == 128 + SIGTERM;
        if (!scratch.has("out")) continue;
        for (const auto& entry : std::filesystem::directory_iterator(scratch.path("out"))) {
            const std::string name = entry.path().filename().string();
            CAPTURE(name);
            REQUIRE((name.ends_with(".lrb") || name.ends_with(".json")));
            const std::string bytes = scratch.read("out/" + name);
            AssetData asset;
            Faults faults;
            if (name.ends_with(".lrb"))
                CHECK(read_asset(bytes.data(), bytes.size(), asset, faults));
            else
                CHECK(test::Json::is_json(bytes));
        }
        std::filesystem::remove_all(scratch.path("out"));
    }
    CHECK(stopped > 0);
}

TEST_CASE("batch: events come in order and in the calling thread, whatever the threads and the memory") {
    const Scratch scratch;
    std::vector<std::string> inputs;
    for (int i = 0; i < 6; ++i) // the first is the slowest
        inputs.push_back(scratch.write(numbered("m", i, ".obj"), body(0.03, i == 0 ? 3 : 1)));
    std::filesystem::create_directory(scratch.path("out"));
    std::string clash;
    const auto jobs = plan_batch(inputs, {}, {scratch.path("out"), "", "", ""}, false, clash);
    REQUIRE(jobs.has_value());
    std::vector<std::string> first;
    for (const BatchLimits& limits : {BatchLimits{1, 0}, BatchLimits{4, 0}, BatchLimits{4, uint64_t{1} << 40},
                                      BatchLimits{64, uint64_t{1} << 20}}) {
        std::vector<std::string> order;
        const std::thread::id here = std::this_thread::get_id();
        BatchEvents events;
        events.done = [&](const BakeJob& job, const BakeOutcome& outcome) {
            CHECK(std::this_thread::get_id() == here);
            CHECK(outcome.state == BakeOutcome::State::baked);
            order.push_back(job.bake.mesh_path);
        };
        events.progress = [&](double finished) {
            CHECK(finished >= 0.0);
            CHECK(finished <= 6.0);
        };
        CHECK(run_batch(*jobs, limits, events) == 0);
        CHECK(order == inputs);
        std::vector<std::string> files;
        for (int i = 0; i < 6; ++i) files.push_back(scratch.read(numbered("out/m", i, ".lrb")));
        if (first.empty()) first = files;
        CHECK(files == first);
    }
}

TEST_CASE("memory budget: never exceeded, except by one that is alone") {
    constexpr uint64_t total = 100;
    MemoryBudget budget(total);
    std::atomic<uint64_t> used{0};
    std::atomic<int> inside{0}, bad{0};
    std::vector<std::thread> threads;
    for (uint64_t n = 0; n < 8; ++n)
        threads.emplace_back([&, n] {
            for (uint64_t i = 0; i < 200; ++i) {
                const uint64_t bytes = (n * 37 + i * 13) % 150;
                budget.acquire(bytes);
                const uint64_t now = used += bytes;
                const int others = inside++;
                if (now > total && others > 0) ++bad;
                --inside;
                used -= bytes;
                budget.release(bytes);
            }
        });
    for (std::thread& t : threads) t.join();
    CHECK(bad == 0);
    CHECK(available_memory() > 0);
}
