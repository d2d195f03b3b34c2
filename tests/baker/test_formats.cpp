// Scenes through assimp: transforms, units, axes, names.
#include "baker/bake.h"
#include "baker/fault_text.h"
#include "baker/json.h"
#include "baker/mesh/mass_properties.h"
#include "baker/mesh/mesh.h"
#include "baker/mesh/mesh_check.h"
#include "scene_files.h"
#include "scratch.h"
#include "sheet_shapes.h"

#include <doctest/doctest.h>

#include <Eigen/LU>

#include <cstring>
#include <random>

using namespace lr;
using namespace lr::baker;
using doctest::Approx;
using test::Scratch;

namespace {

std::size_t count(const Faults& faults, FaultId id) {
    std::size_t n = 0;
    for (const Fault& f : faults) n += f.id == id;
    return n;
}

std::string all_text(const Faults& faults) {
    std::string text;
    for (const Fault& f : faults) text += to_string(f) + "\n";
    return text;
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

MassProperties read_solid(const std::string& path, const MeshReadOptions& options, Faults& faults) {
    Mesh mesh;
    const bool good = read_mesh(path, options, mesh, faults) && check_and_repair(mesh, faults);
    INFO(all_text(faults));
    REQUIRE(good);
    // Otherwise the check would have to flip faces of a mirrored node.
    CHECK(count(faults, FaultId::mesh_inside_out) == 0);
    CHECK(count(faults, FaultId::mesh_inconsistent_winding) == 0);
    return compute_mass_properties(mesh);
}

void check_near(const Eigen::Vector3d& value, const Eigen::Vector3d& expected) {
    for (int k = 0; k < 3; ++k) CHECK(std::abs(value[k] - expected[k]) <= 1e-6 * expected.norm());
}

MeshReadOptions in_unit(double metres) {
    MeshReadOptions options;
    options.unit_scale = metres;
    return options;
}

} // namespace

TEST_CASE("formats: nested, turned, scaled and mirrored nodes") {
    const Scratch scratch;
    const Mesh body = test::tetrahedron();
    const Eigen::Affine3d transform = test::nested_transform();
    REQUIRE(transform.linear().determinant() < 0.0);
    const auto nodes = test::nested_nodes();
    struct Case {
        std::string path;
        double unit;
        std::size_t scaled; // warnings about scaling
    };
    for (const Case& c : {
             Case{scratch.write("body.glb", test::glb(body, nodes)), 1.0, 0},
             Case{scratch.write("metre.dae", test::collada(body, nodes, "<unit name=\"meter\" meter=\"1\"/>")), 1.0, 0},
             Case{scratch.write("none.dae", test::collada(body, nodes, "")), 1.0, 0},
             Case{scratch.write("inch.dae", test::collada(body, nodes,
                                                          "<unit name=\"inch\" meter=\"0.0254\"/>"
                                                          "<up_axis>Z_UP</up_axis>")),
                  0.0254, 1},
             Case{scratch.write("x.dae", test::collada(body, nodes, "<up_axis>X_UP</up_axis>")), 1.0, 0},
             Case{scratch.write("centimetre.fbx", test::fbx(body, nodes, test::fbx_unit(1.0))), 0.01, 1},
             Case{scratch.write("silent.fbx", test::fbx(body, nodes, "")), 0.01, 1},
             Case{scratch.write("metre.fbx", test::fbx(body, nodes, test::fbx_unit(100.0))), 1.0, 0},
         }) {
        CAPTURE(c.path);
        Faults faults;
        const MassProperties solid = read_solid(c.path, {}, faults);
        CHECK(count(faults, FaultId::mesh_turned_or_scaled) == c.scaled);
        // The two primitives of the glTF mesh share corners: no exporter can avoid that.
        CHECK(faults.size() == c.scaled);
        const double volume = -transform.linear().determinant() * c.unit * c.unit * c.unit;
        CHECK(solid.volume == Approx(volume).epsilon(1e-6));
        check_near(solid.centroid, c.unit * (transform * Eigen::Vector3d(0.25, 0.5, 0.75)));

        // --unit replaces the file's unit.
        Faults told;
        CHECK(read_solid(c.path, in_unit(0.001), told).volume == Approx(volume * std::pow(0.001 / c.unit, 3)));
    }
}

TEST_CASE("formats: STL, ASCII and binary") {
    const Scratch scratch;
    const Mesh body = test::tetrahedron();
    for (const std::string& path : {scratch.write("ascii.stl", test::ascii_stl({{"body", body}})),
                                    scratch.write("binary.stl", test::binary_stl(body))}) {
        CAPTURE(path);
        Faults faults;
        const MassProperties solid = read_solid(path, in_unit(0.01), faults);
        CHECK(faults.empty());
        CHECK(solid.volume == Approx(1e-6).epsilon(1e-6));
        check_near(solid.centroid, {0.0025, 0.005, 0.0075});
    }
}

TEST_CASE("formats: an open sheet bakes alike from every one of them" * doctest::test_suite("exact")) {
    const Scratch scratch;
    const Mesh leaf = test::patch(6, 4, [](double u, double v) {
        return Eigen::Vector3d(0.08 * u, 0.04 * (v - 0.5), 0.02 * u * u + 0.1 * (v - 0.5) * (v - 0.5));
    });
    const test::SceneNodes node{{"Leaf"}};
    const auto bake_sheet = [](const std::string& path) {
        BakeOptions options;
        options.mesh_path = path;
        options.unit = Unit::m;
        options.sheet = SheetOptions{2e-4, 0.1};
        AssetData asset;
        Faults faults;
        const bool good = bake(options, asset, faults);
        INFO(all_text(faults));
        REQUIRE(good);
        return asset;
    };
    const AssetData reference = bake_sheet(scratch.write("leaf.obj", test::obj_text(leaf)));
    CHECK(reference.added_mass[4] != 0.0); // a coupling: the leaf is curled
    for (const std::string& path :
         {scratch.write("leaf.glb", test::glb(leaf, node)), scratch.write("leaf.dae", test::collada(leaf, node, "")),
          scratch.write("leaf.fbx", test::fbx(leaf, node, test::fbx_unit(100.0))),
          scratch.write("leaf.stl", test::binary_stl(leaf)),
          scratch.write("ascii.stl", test::ascii_stl({{"leaf", leaf}}))}) {
        CAPTURE(path);
        const AssetData asset = bake_sheet(path);
        CHECK(asset.mass == Approx(reference.mass).epsilon(1e-5));
        CHECK(asset.provenance.vertices == reference.provenance.vertices);
        for (std::size_t i = 0; i < 36; ++i) {
            const double scale = std::sqrt(reference.added_mass[i / 6 * 7] * reference.added_mass[i % 6 * 7]);
            CHECK(std::abs(asset.added_mass[i] - reference.added_mass[i]) < 1e-3 * scale);
        }
    }
}

TEST_CASE("formats: one of several meshes by the name of its node, its mesh or a node above") {
    const Scratch scratch;
    const Mesh body = test::tetrahedron();
    Mesh right = body;
    test::apply(right, Eigen::Matrix3d::Identity(), {20, 0, 0});
    Mesh both = body;
    for (const Face& f : right.faces) both.faces.push_back({f[0] + 4, f[1] + 4, f[2] + 4});
    both.vertices.insert(both.vertices.end(), right.vertices.begin(), right.vertices.end());
    std::string obj = test::obj_text(both);
    obj.insert(obj.find("f 5 "), "o Right\ng leaves blade\n");
    obj.insert(obj.find("f 1 "), "o Left\n");
    const auto nodes = test::two_nodes();
    const std::vector<std::string> paths = {
        scratch.write("two.glb", test::glb(body, nodes)),
        scratch.write("two.dae", test::collada(body, nodes, "")),
        scratch.write("two.fbx", test::fbx(body, nodes, test::fbx_unit(100.0))),
        scratch.write("two.stl", test::ascii_stl({{"Left", body}, {"Right", right}})),
        scratch.write("two.obj", obj),
    };
    for (const std::string& path : paths) {
        CAPTURE(path);
        Faults faults;
        CHECK(read_solid(path, {}, faults).volume == Approx(2.0).epsilon(1e-6));
        CHECK(count(faults, FaultId::mesh_several_meshes) == 1);
        CHECK(contains(all_text(faults), "'Left', 'Right'"));

        MeshReadOptions options;
        options.mesh = "Right";
        faults.clear();
        const MassProperties solid = read_solid(path, options, faults);
        CHECK(solid.volume == Approx(1.0).epsilon(1e-6));
        check_near(solid.centroid, {20.25, 0.5, 0.75});
        CHECK(faults.size() == 1);
        CHECK(count(faults, FaultId::mesh_several_meshes) == 1);
        CHECK(contains(all_text(faults), "ignored: 'Left'"));

        options.mesh = "right";
        faults.clear();
        Mesh mesh;
        CHECK_FALSE(read_mesh(path, options, mesh, faults));
        REQUIRE(faults.size() == 1);
        CHECK(faults[0].id == FaultId::parameter_unknown);
        CHECK(faults[0].severity == Severity::error);
        CHECK(contains(faults[0].remedy, "'Left'"));
        CHECK(contains(faults[0].remedy, "'Right'"));
    }
    const auto volume_of = [&](const std::string& path, const char* name) {
        MeshReadOptions options;
        options.mesh = name;
        Faults faults;
        return read_solid(path, options, faults).volume;
    };
    for (std::size_t i = 0; i < 3; ++i) {
        CAPTURE(paths[i]);
        CHECK(volume_of(paths[i], "Geo") == Approx(2.0).epsilon(1e-6)); // one mesh, two nodes
    }
    CHECK(volume_of(paths[1], "Right-id") == Approx(1.0).epsilon(1e-6));
    CHECK(volume_of(paths[4], "blade") == Approx(1.0).epsilon(1e-6));
    for (const std::string& path :
         {scratch.write("n.glb", test::glb(body, test::nested_nodes())),
          scratch.write("n.fbx", test::fbx(body, test::nested_nodes(), test::fbx_unit(100.0)))}) {
        CAPTURE(path);
        CHECK(volume_of(path, "Outer") == Approx(4.0).epsilon(1e-6));
    }
}

TEST_CASE("formats: PLY has no names to select by") {
    const Scratch scratch;
    const std::string ply = scratch.write(
        "a.ply", "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                 "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
                 "0 0 0\n1 0 0\n0 2 0\n0 0 3\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
    MeshReadOptions options;
    options.mesh = "body";
    Mesh mesh;
    Faults faults;
    CHECK_FALSE(read_mesh(ply, options, mesh, faults));
    CHECK(count(faults, FaultId::parameter_unknown) == 1);
}

TEST_CASE("formats: Collada that would make assimp read out of bounds or never end is refused") {
    const std::string good = test::collada(test::tetrahedron(), {{"Body"}}, "");
    Mesh mesh;
    Faults faults;
    CHECK(read_mesh_memory(good.data(), good.size(), "dae", MeshReadOptions{}, mesh, faults));
    CHECK_FALSE(read_mesh_memory("PK", 2, "zae", MeshReadOptions{}, mesh, faults));
    CHECK(count(faults, FaultId::mesh_unreadable) == 1);
    const std::string inches = test::collada(test::tetrahedron(), {{"Body"}}, "<unit meter=\"0.0254\"/>");
    REQUIRE(read_mesh_memory(inches.data(), inches.size(), "xml", in_unit(1.0), mesh, faults));
    CHECK(compute_mass_properties(mesh).volume == Approx(1.0)); // Collada with another extension: not scaled twice
    const std::pair<const char*, const char*> damages[] = {
        {"<p>0 ", "<p>x "},
        {"id=\"pa\" count", "id=\"pa\" coumt"},
        {"count=\"12\"", "count=\"13\""},
        {"stride=\"3\"", "stride=\"4\""},
        {"stride=\"3\"", "stride=\"1\""},
        {"source=\"#pa\"", "source=\"#px\""},
        {"count=\"4\"", "count=\"5\""},
        {"</COLLADA>", "</COLLADA"},
    };
    for (const auto& [before, after] : damages) {
        CAPTURE(after);
        std::string text = good;
        REQUIRE(contains(text, before));
        text.replace(text.find(before), std::strlen(before), after);
        faults.clear();
        CHECK_FALSE(read_mesh_memory(text.data(), text.size(), "dae", MeshReadOptions{}, mesh, faults));
        REQUIRE(faults.size() == 1);
        CHECK(faults[0].id == FaultId::mesh_unreadable);
        CHECK(contains(faults[0].where, "line "));
    }
}

TEST_CASE("formats: truncated and damaged scenes are read or refused, with a number") {
    const Mesh body = test::tetrahedron();
    const auto nodes = test::nested_nodes();
    std::mt19937 random(11);
    for (const auto& [extension, text] :
         {std::pair{"dae", test::collada(body, nodes, "<unit meter=\"0.01\"/>")},
          std::pair{"fbx", test::fbx(body, nodes, test::fbx_unit(1.0))}, std::pair{"glb", test::glb(body, nodes)},
          std::pair{"stl", test::binary_stl(body)}})
        for (int i = 0; i < 100; ++i) {
            std::string damaged = text;
            if (i % 2)
                damaged.resize(random() % damaged.size());
            else
                for (int k = 0; k < 3; ++k) damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
            Mesh mesh;
            Faults faults;
            const bool good =
                read_mesh_memory(damaged.data(), damaged.size(), extension, MeshReadOptions{}, mesh, faults) &&
                check_and_repair(mesh, faults);
            CHECK(good != has_error(faults));
        }
}

TEST_CASE("--up turns by a proper rotation, and the inertia with it") {
    const Scratch scratch;
    const Mesh body = test::tetrahedron();
    const std::string path = scratch.write("body.obj", test::obj_text(body));
    Faults before;
    const MassProperties still = read_solid(path, {}, before);
    CHECK(before.empty());
    const std::pair<UpAxis, Eigen::Vector3d> axes[] = {{UpAxis::x, {1, 0, 0}},        {UpAxis::y, {0, 1, 0}},
                                                       {UpAxis::z, {0, 0, 1}},        {UpAxis::minus_x, {-1, 0, 0}},
                                                       {UpAxis::minus_y, {0, -1, 0}}, {UpAxis::minus_z, {0, 0, -1}}};
    for (const auto& [up, axis] : axes) {
        CAPTURE(up_name(up));
        const Eigen::Matrix3d r = up_rotation(up);
        CHECK(r * axis == Eigen::Vector3d(0, 0, 1));
        CHECK(r.determinant() == 1.0);
        CHECK(r * r.transpose() == Eigen::Matrix3d::Identity());
        MeshReadOptions options;
        options.up = up;
        Faults faults;
        const MassProperties turned = read_solid(path, options, faults);
        CHECK(faults.size() == (up == UpAxis::z ? 0 : 1));
        CHECK(count(faults, FaultId::mesh_turned_or_scaled) == faults.size());
        CHECK(turned.volume == Approx(still.volume).epsilon(1e-14));
        CHECK((turned.centroid - r * still.centroid).norm() < 1e-14);
        CHECK((turned.inertia - r * still.inertia * r.transpose()).norm() < 1e-14);
    }
    // y up, as in most modellers: the side towards the viewer (+z) becomes the front (-y).
    CHECK(up_rotation(UpAxis::y) * Eigen::Vector3d(1, 2, 3) == Eigen::Vector3d(1, -3, 2));
    CHECK(up_rotation(UpAxis::x) * Eigen::Vector3d(1, 2, 3) == Eigen::Vector3d(-3, 2, 1));
}

TEST_CASE("vertices within a ten-millionth of the extent are one, at any scale, further apart they are not") {
    for (const double scale : {1e-6, 1.0, 1e6})
        for (const bool apart : {false, true}) {
            CAPTURE(scale);
            CAPTURE(apart);
            Mesh body = test::icosphere(1);
            test::apply(body, test::some_rotation(), {3, -4, 5});
            // Every face has its own corners, each slightly displaced.
            Mesh soup;
            for (std::size_t i = 0; i < body.faces.size(); ++i)
                for (const uint32_t v : body.faces[i]) {
                    const double off = (apart ? 1e-6 : 2e-8) * static_cast<double>(i % 3);
                    soup.vertices.emplace_back(scale * (body.vertices[v] + off * Eigen::Vector3d(1, -1, 1)));
                }
            for (uint32_t i = 0; i < 3 * body.faces.size(); i += 3) soup.faces.push_back({i, i + 1, i + 2});
            const std::string text = test::obj_text(soup);
            Mesh mesh;
            Faults faults;
            REQUIRE(read_mesh_memory(text.data(), text.size(), "obj", 1.0, mesh, faults));
            CHECK((mesh.vertices.size() == body.vertices.size()) != apart);
            bool near = false;
            for (const Fault& f : faults) near = near || contains(f.what, "within 1e-07 of the mesh's extent");
            CHECK(near != apart);
            CHECK(check_and_repair(mesh, faults) != apart);
        }
    Mesh chain;
    for (int i = 0; i < 5; ++i) chain.vertices.emplace_back(1e-3 * i, 0, 0);
    chain.vertices.emplace_back(1, 1, 1);
    chain.faces = {{4, 3, 5}};
    CHECK(join_near_vertices(chain, 1.5e-3) == 4);
    CHECK(chain.faces[0] == Face{0, 0, 1});
    CHECK(chain.vertices[0] == Eigen::Vector3d::Zero());
    Mesh point;
    point.vertices = {{1, 1, 1}, {1, 1, 1}};
    CHECK(join_near_vertices(point, 1e-7) == 0);
}

TEST_CASE("formats: the options are in the asset and its hash, what they did in the report") {
    const Scratch scratch;
    const Mesh body = test::ellipsoid(0.4, 0.2, 0.1, 1);
    const std::string path = scratch.write("body.fbx", test::fbx(body, {{"Body"}}, test::fbx_unit(1.0)));
    const std::string out = scratch.path("out.lrb"), report = scratch.path("r.json");
    const auto bake_with = [&](std::vector<std::string> more) {
        std::vector<std::string> arguments{"mesh", path, "-o", out, "--report", report, "--grid", "8,8,8", "--quiet"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const test::Outcome outcome = test::run(LR_BAKE_PATH, arguments);
        INFO(outcome.err);
        REQUIRE(outcome.exit_code == 0);
        return test::Json::parse(scratch.read("r.json"));
    };
    const test::Json plain = bake_with({});
    CHECK(contains(plain["provenance"]["options"].text(), "--unit file"));
    REQUIRE(plain["faults"].size() == 1);
    CHECK(plain["faults"][0]["number"] == 218);
    CHECK(bake_with({"--unit", "file", "--up", "z"})["provenance"] == plain["provenance"]);

    const test::Json cm = bake_with({"--unit", "cm"});
    CHECK(cm["faults"].empty());
    CHECK(cm["volume"].number() == Approx(plain["volume"].number()));
    const test::Json turned = bake_with({"--up", "-x"});
    CHECK(contains(turned["provenance"]["options"].text(), "--up -x"));
    CHECK(turned["faults"].size() == 2);
    CHECK(turned["inertia"][8].number() == Approx(plain["inertia"][0].number()).epsilon(1e-6));
    const test::Json named = bake_with({"--mesh", "Body"});
    CHECK(contains(named["provenance"]["options"].text(), "--mesh Body"));
    for (const test::Json& other : {cm, turned, named})
        CHECK(other["provenance"]["input_hash"] != plain["provenance"]["input_hash"]);

    const test::Outcome unknown = test::run(LR_BAKE_PATH, {"mesh", path, "-o", out, "--mesh", "Leaf"});
    CHECK(unknown.exit_code == 1);
    CHECK(contains(unknown.err, "error 302"));
    CHECK(contains(unknown.err, "'Body'"));
    for (const std::vector<std::string>& bad :
         {std::vector<std::string>{"--up", "w"}, {"--up", ""}, {"--up", "+z"}, {"--mesh", ""}}) {
        std::vector<std::string> arguments{"mesh", path, "-o", out};
        arguments.insert(arguments.end(), bad.begin(), bad.end());
        CHECK(test::run(LR_BAKE_PATH, arguments).exit_code == 2);
    }
    CHECK(test::run(LR_BAKE_PATH, {"ellipsoid", "1", "1", "1", "-o", out, "--unit", "file"}).exit_code == 2);
    CHECK(test::run(LR_BAKE_PATH, {"ellipsoid", "1", "1", "1", "-o", out, "--up", "x"}).exit_code == 2);
}
