#include "baker/fault_text.h"
#include "baker/mesh/mass_properties.h"
#include "baker/mesh/mesh.h"
#include "baker/mesh/mesh_check.h"
#include "baker/mesh/obj_reader.h"
#include "mesh_shapes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <set>
#include <sstream>

using namespace lr;
using namespace lr::baker;

namespace {

std::size_t count(const Faults& faults, FaultId id, Severity severity) {
    std::size_t n = 0;
    for (const Fault& f : faults) n += f.id == id && f.severity == severity;
    return n;
}

std::size_t errors(const Faults& faults, FaultId id) {
    return count(faults, id, Severity::error);
}
std::size_t warnings(const Faults& faults, FaultId id) {
    return count(faults, id, Severity::warning);
}

double volume(const Mesh& mesh) {
    double six = 0.0;
    for (const Face& f : mesh.faces) six += mesh.vertices[f[0]].dot(mesh.vertices[f[1]].cross(mesh.vertices[f[2]]));
    return six / 6.0;
}

std::string to_obj(const Mesh& mesh) {
    std::ostringstream text;
    text.precision(17);
    for (const Eigen::Vector3d& v : mesh.vertices) text << "v " << v[0] << ' ' << v[1] << ' ' << v[2] << '\n';
    for (const Face& f : mesh.faces) text << "f " << f[0] + 1 << ' ' << f[1] + 1 << ' ' << f[2] + 1 << '\n';
    return text.str();
}

std::string to_stl(const Mesh& mesh) {
    std::ostringstream text;
    text.precision(9);
    text << "solid body\n";
    for (const Face& f : mesh.faces) {
        text << "facet normal 0 0 0\nouter loop\n";
        for (const uint32_t i : f)
            text << "vertex " << mesh.vertices[i][0] << ' ' << mesh.vertices[i][1] << ' ' << mesh.vertices[i][2]
                 << '\n';
        text << "endloop\nendfacet\n";
    }
    text << "endsolid body\n";
    return text.str();
}

std::string to_ply(const Mesh& mesh) {
    std::ostringstream text;
    text.precision(9);
    text << "ply\nformat ascii 1.0\nelement vertex " << mesh.vertices.size()
         << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << mesh.faces.size()
         << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Eigen::Vector3d& v : mesh.vertices) text << v[0] << ' ' << v[1] << ' ' << v[2] << '\n';
    for (const Face& f : mesh.faces) text << "3 " << f[0] << ' ' << f[1] << ' ' << f[2] << '\n';
    return text.str();
}

std::string base64(const std::string& bytes) {
    const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63U];
    }
    return text;
}

// With a node that mirrors x, doubles y and shifts z.
std::string to_gltf(const Mesh& mesh) {
    std::string bytes;
    const auto append = [&](const auto value) {
        char raw[sizeof value];
        std::memcpy(raw, &value, sizeof value);
        bytes.append(raw, sizeof value);
    };
    for (const Eigen::Vector3d& v : mesh.vertices)
        for (int k = 0; k < 3; ++k) append(static_cast<float>(v[k]));
    const std::size_t positions = bytes.size();
    for (const Face& f : mesh.faces)
        for (const uint32_t i : f) append(i);
    std::ostringstream text;
    text << R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,)"
         << R"("matrix":[-1,0,0,0, 0,2,0,0, 0,0,1,0, 0,0,5,1]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},)"
         << R"("indices":1}]}],"buffers":[{"byteLength":)" << bytes.size()
         << R"(,"uri":"data:application/octet-stream;base64,)" << base64(bytes) << R"("}],"bufferViews":[)"
         << R"({"buffer":0,"byteOffset":0,"byteLength":)" << positions << R"(},{"buffer":0,"byteOffset":)" << positions
         << R"(,"byteLength":)" << bytes.size() - positions
         << R"(}],"accessors":[{"bufferView":0,"componentType":5126,)"
         << R"("count":)" << mesh.vertices.size()
         << R"(,"type":"VEC3","min":[-10,-10,-10],"max":[10,10,10]},{"bufferView":1,"componentType":5125,"count":)"
         << 3 * mesh.faces.size() << R"(,"type":"SCALAR"}]})";
    return text.str();
}

bool read_text(const std::string& text, const char* extension, Mesh& mesh, Faults& faults, double unit = 1.0) {
    return read_mesh_memory(text.data(), text.size(), extension, unit, mesh, faults);
}

// A folder that is removed at the end.
class Scratch {
public:
    Scratch()
        : folder_(std::filesystem::temp_directory_path() / ("lr_test_mesh_" + std::to_string(std::random_device()()))) {
        std::filesystem::create_directories(folder_);
    }
    ~Scratch() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    std::string write(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
        return path(name);
    }

private:
    std::filesystem::path folder_;
};

} // namespace

TEST_CASE("every format gives the same closed solid, in metres") {
    const Mesh source = test::ellipsoid(4, 2, 1, 2);
    const Scratch scratch;
    struct Case {
        const char* name;
        std::string text;
        double scale; // of the volume, by the node transform
    };
    for (const Case& c : {Case{"body.obj", to_obj(source), 1.0}, Case{"body.stl", to_stl(source), 1.0},
                          Case{"body.ply", to_ply(source), 1.0}, Case{"body.gltf", to_gltf(source), 2.0}}) {
        CAPTURE(c.name);
        Mesh mesh;
        Faults faults;
        REQUIRE(read_mesh(scratch.write(c.name, c.text), 0.01, mesh, faults));
        CHECK(faults.empty());
        CHECK(mesh.name == "body");
        CHECK(mesh.vertices.size() == source.vertices.size());
        REQUIRE(check_and_repair(mesh, faults));
        CHECK(faults.empty());
        CHECK(volume(mesh) == doctest::Approx(1e-6 * c.scale * volume(source)).epsilon(1e-5));
        if (c.scale != 1.0) {
            double mean = 0.0;
            for (const Eigen::Vector3d& v : mesh.vertices) mean += v.z() / static_cast<double>(mesh.vertices.size());
            CHECK(mean == doctest::Approx(0.05).epsilon(1e-5));
        }
    }
}

TEST_CASE("OBJ: double precision, negative indices, polygons, continued lines, comments") {
    const std::string text =
        "# box with quads\r\no box\nv 0 0 0\nv +1 0 0 0.5 0.5 0.5\nv 1 1 0\nv 0 1 0\n"
        "v 0 0 1\nv 1 0 1\nv 1 1 1.00000000000001\nv 0 1 1\nvn 0 0 1\n"
        "f 4//1 3//1 2//1 1//1\nf 5 6 7 8\nf 1 2 \\\n 6 5\nf -7 -6 -2 -3\nf 3 4 8 7 # side\nf 4/1 1/2 5/3 8/4\n";
    Mesh mesh;
    Faults faults;
    REQUIRE(read_text(text, "OBJ", mesh, faults));
    CHECK(mesh.faces.size() == 12);
    CHECK(mesh.vertices[6].z() == 1.00000000000001);
    REQUIRE(check_and_repair(mesh, faults));
    CHECK(faults.empty());
    CHECK(volume(mesh) == doctest::Approx(1.0));
}

TEST_CASE("concave polygons are cut without folding over") {
    // An L, extruded: area 3.
    std::ostringstream text;
    const double xy[6][2] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    for (int z = 0; z < 2; ++z)
        for (const auto& p : xy) text << "v " << p[0] << ' ' << p[1] << ' ' << z << '\n';
    text << "f 6 5 4 3 2 1\nf 7 8 9 10 11 12\n";
    for (int i = 0; i < 6; ++i) {
        const int j = (i + 1) % 6;
        text << "f " << i + 1 << ' ' << j + 1 << ' ' << j + 7 << ' ' << i + 7 << '\n';
    }
    Mesh mesh;
    Faults faults;
    REQUIRE(read_text(text.str(), "obj", mesh, faults));
    REQUIRE(check_and_repair(mesh, faults));
    double area = 0.0;
    for (const Face& f : mesh.faces)
        area +=
            0.5 * (mesh.vertices[f[1]] - mesh.vertices[f[0]]).cross(mesh.vertices[f[2]] - mesh.vertices[f[0]]).norm();
    CHECK(volume(mesh) == doctest::Approx(3.0));
    CHECK(area == doctest::Approx(14.0)); // a fold would show as more
}

TEST_CASE("PLY: binary of both byte orders, extra properties") {
    const Mesh source = test::icosphere(1);
    for (const bool big : {false, true}) {
        std::string bytes = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                            "_endian 1.0\ncomment x\nelement vertex 42\nproperty double x\nproperty float y\n"
                            "property double z\nproperty uchar red\nelement face 80\nproperty short tag\n"
                            "property list uchar uint vertex_index\nend_header\n";
        const auto append = [&](const auto value) {
            char raw[sizeof value];
            std::memcpy(raw, &value, sizeof value);
            if (big) std::reverse(raw, raw + sizeof value);
            bytes.append(raw, sizeof value);
        };
        for (const Eigen::Vector3d& v : source.vertices) {
            append(v.x());
            append(static_cast<float>(v.y()));
            append(v.z());
            append(uint8_t{7});
        }
        for (const Face& f : source.faces) {
            append(int16_t{-1});
            append(uint8_t{3});
            for (const uint32_t i : f) append(i);
        }
        Mesh mesh;
        Faults faults;
        REQUIRE(read_text(bytes, "ply", mesh, faults));
        CHECK(mesh.faces == source.faces);
        CHECK(mesh.vertices[7].x() == source.vertices[7].x());
        CHECK(mesh.vertices[7].y() == doctest::Approx(source.vertices[7].y()).epsilon(1e-6));
        bytes.resize(bytes.size() - 1);
        CHECK_FALSE(read_text(bytes, "ply", mesh, faults));
        CHECK(faults.back().where == "face 79");
    }
}

TEST_CASE("every unreadable file has its fault number") {
    const Scratch scratch;
    const std::string good = to_obj(test::icosphere(0));
    struct Case {
        const char* label;
        std::string path;
        FaultId id;
    };
    const std::vector<Case> cases = {
        {"missing", scratch.path("none.obj"), FaultId::file_not_found},
        {"folder", scratch.path("."), FaultId::file_read},
        {"empty", scratch.write("empty.obj", ""), FaultId::mesh_empty},
        {"empty stl", scratch.write("empty.stl", ""), FaultId::mesh_empty},
        {"comment only", scratch.write("comment.obj", "# nothing\n"), FaultId::mesh_empty},
        {"no faces", scratch.write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), FaultId::mesh_empty},
        {"nan", scratch.write("nan.obj", "v 0 0 nan\n" + good), FaultId::mesh_not_finite},
        {"inf", scratch.write("inf.obj", "v 0 -inf 0\n" + good), FaultId::mesh_not_finite},
        {"overflow", scratch.write("large.obj", "v 0 1e999 0\n" + good), FaultId::mesh_not_finite},
        {"index", scratch.write("index.obj", good + "f 1 2 99\n"), FaultId::mesh_bad_index},
        {"index 0", scratch.write("zero.obj", good + "f 0 1 2\n"), FaultId::mesh_bad_index},
        {"negative", scratch.write("negative.obj", good + "f -1 -2 -99\n"), FaultId::mesh_bad_index},
        {"word", scratch.write("word.obj", "v 0 zero 0\n"), FaultId::mesh_unreadable},
        {"garbage stl", scratch.write("garbage.stl", "\x01\x02garbage"), FaultId::mesh_unreadable},
        {"garbage ply", scratch.write("garbage.ply", "not a ply file at all"), FaultId::mesh_unreadable},
        {"garbage glb", scratch.write("garbage.glb", std::string(300, '\xff')), FaultId::mesh_unreadable},
        {"unknown", scratch.write("mesh.xyzzy", "hello"), FaultId::mesh_unreadable},
    };
    for (const Case& c : cases) {
        CAPTURE(c.label);
        Mesh mesh;
        Faults faults;
        CHECK_FALSE(read_mesh(c.path, 1.0, mesh, faults));
        REQUIRE(faults.size() == 1);
        CHECK(faults[0].id == c.id);
        CHECK(faults[0].severity == Severity::error);
        CHECK_FALSE(faults[0].where.empty());
        CHECK_FALSE(faults[0].remedy.empty());
    }
    for (const double unit : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
        Mesh mesh;
        Faults faults;
        CHECK_FALSE(read_text(good, "obj", mesh, faults, unit));
        CHECK(errors(faults, FaultId::parameter_out_of_range) == 1);
    }
    Mesh mesh;
    Faults faults;
    CHECK_FALSE(read_text("v 0 0 0\nv 0 0 nan\nf 1 2 2\n", "obj", mesh, faults));
    CHECK(faults[0].where == "vertex 1");
    faults.clear();
    CHECK(read_text(good + "f 1 2\n", "obj", mesh, faults)); // a line
    CHECK(warnings(faults, FaultId::mesh_empty) == 1);
}

TEST_CASE("NaN and bad indices in formats read by assimp") {
    const Mesh sphere = test::icosphere(1);
    Mesh broken = sphere;
    broken.faces[3][1] = 100000;
    Mesh mesh;
    Faults faults;
    CHECK_FALSE(read_text(to_ply(broken), "ply", mesh, faults));
    CHECK(errors(faults, FaultId::mesh_bad_index) == 1);
    std::string ply = to_ply(sphere);
    ply.replace(ply.find("end_header\n") + 11, 1, "nan #");
    faults.clear();
    CHECK_FALSE(read_text(ply, "ply", mesh, faults));
    CHECK(has_error(faults));
    faults.clear();
    // assimp drops the face silently; the check finds the hole
    CHECK_FALSE((read_text(to_gltf(broken), "gltf", mesh, faults) && check_and_repair(mesh, faults)));
    CHECK(has_error(faults));
    std::string stl = to_stl(sphere);
    stl.replace(stl.find("vertex ") + 7, 1, "nan 0 0 #");
    faults.clear();
    const bool read = read_text(stl, "stl", mesh, faults);
    CHECK_FALSE((read && check_and_repair(mesh, faults)));
    CHECK(has_error(faults));
}

TEST_CASE("truncated and damaged files never crash the reader") {
    const Mesh sphere = test::icosphere(1);
    std::mt19937 random(7);
    const std::vector<std::pair<const char*, std::string>> sources = {
        {"obj", to_obj(sphere)}, {"stl", to_stl(sphere)}, {"ply", to_ply(sphere)}, {"gltf", to_gltf(sphere)}};
    std::size_t refused = 0;
    for (const auto& [extension, text] : sources)
        for (int i = 0; i < 60; ++i) {
            std::string damaged = text;
            if (i % 2)
                damaged.resize(random() % damaged.size());
            else
                for (int k = 0; k < 5; ++k) damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
            Mesh mesh;
            Faults faults;
            const bool good = read_text(damaged, extension, mesh, faults) && check_and_repair(mesh, faults);
            CHECK(good != has_error(faults));
            refused += !good;
        }
    CHECK(refused > 100);
}

TEST_CASE("changes on reading are reported") {
    std::string text = to_obj(test::icosphere(0));
    text += "v 7 7 7\nv 7 7 7\nl 1 2\no second\nv 10 0 0\nv 11 0 0\nv 10 1 0\nv 10 0 1\nf 15 17 16\nf 15 16 18\nf 16 "
            "17 18\nf 17 15 18\n";
    Mesh mesh;
    Faults faults;
    REQUIRE(read_text(text, "obj", mesh, faults));
    CHECK(warnings(faults, FaultId::mesh_several_meshes) == 1);
    CHECK(warnings(faults, FaultId::mesh_merged_vertices) == 1);
    CHECK(warnings(faults, FaultId::mesh_empty) == 1);
    REQUIRE(check_and_repair(mesh, faults));
    CHECK(warnings(faults, FaultId::mesh_isolated_vertex) == 1);
    CHECK(warnings(faults, FaultId::mesh_several_components) == 1);
    CHECK(mesh.vertices.size() == 16);
}

TEST_CASE("joining is by exact position, keeps the order and takes -0 for 0") {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {-0.0, 0, 0}, {1, 0, 1e-300}, {1, 0, 0}};
    mesh.faces = {{0, 1, 2}, {2, 3, 4}};
    CHECK(join_identical_vertices(mesh) == 2);
    CHECK(mesh.vertices.size() == 3);
    CHECK(mesh.faces[0] == Face{0, 1, 0});
    CHECK(mesh.faces[1] == Face{0, 2, 1});
}

TEST_CASE("a sound mesh passes untouched, at any size and place") {
    for (const double scale : {1e-9, 1e-3, 1.0, 1e9})
        for (Mesh mesh : {test::icosphere(2), test::cube(3), test::leaf(10, 3, 1e-3, 0.1)}) {
            test::apply(mesh, scale * test::some_rotation(), scale * Eigen::Vector3d(3, -4, 5));
            const std::vector<Face> faces = mesh.faces;
            const std::vector<Eigen::Vector3d> vertices = mesh.vertices;
            Faults faults;
            CHECK(check_and_repair(mesh, faults));
            CHECK(faults.empty());
            CHECK(mesh.faces == faces);
            CHECK(mesh.vertices == vertices);
        }
}

TEST_CASE("winding is repaired") {
    const Mesh good = test::cube(3);
    SUBCASE("inside out") {
        Mesh mesh = good;
        for (Face& f : mesh.faces) std::swap(f[0], f[1]);
        Faults faults;
        REQUIRE(check_and_repair(mesh, faults));
        CHECK(warnings(faults, FaultId::mesh_inside_out) == 1);
        CHECK(faults.size() == 1);
        CHECK(volume(mesh) == doctest::Approx(1.0));
    }
    SUBCASE("some faces, the first among them") {
        Mesh mesh = good;
        std::set<std::size_t> turned = {0, 7, 8, 50};
        for (const std::size_t i : turned) std::swap(mesh.faces[i][0], mesh.faces[i][1]);
        Faults faults;
        REQUIRE(check_and_repair(mesh, faults));
        CHECK(warnings(faults, FaultId::mesh_inconsistent_winding) == 1);
        CHECK(faults.size() == 1);
        CHECK(faults[0].where == "face 0, 7, 8, 50");
        CHECK(volume(mesh) == doctest::Approx(1.0));
    }
    SUBCASE("one of two parts inside out") {
        Mesh mesh = good;
        Mesh other = test::icosphere(1);
        test::apply(other, Eigen::Matrix3d::Identity(), {5, 0, 0});
        const auto base = static_cast<uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
        for (const Face& f : other.faces) mesh.faces.push_back({base + f[1], base + f[0], base + f[2]});
        Faults faults;
        REQUIRE(check_and_repair(mesh, faults));
        CHECK(warnings(faults, FaultId::mesh_inside_out) == 1);
        CHECK(warnings(faults, FaultId::mesh_several_components) == 1);
        CHECK(volume(mesh) == doctest::Approx(volume(good) + volume(other)));
    }
}

TEST_CASE("a surface that bounds no solid is refused by number and place") {
    const Mesh sphere = test::icosphere(1);
    const auto check = [](Mesh mesh, FaultId id, const std::string& where) {
        Faults faults;
        CHECK_FALSE(check_and_repair(mesh, faults));
        REQUIRE(errors(faults, id) == 1);
        for (const Fault& f : faults)
            if (f.id == id) {
                CHECK(f.where.substr(0, where.size()) == where);
                CHECK_FALSE(f.remedy.empty());
            }
    };
    SUBCASE("empty") {
        check({}, FaultId::mesh_empty, "mesh");
    }
    SUBCASE("nan") {
        Mesh mesh = sphere;
        mesh.vertices[5].y() = std::numeric_limits<double>::quiet_NaN();
        check(mesh, FaultId::mesh_not_finite, "vertex 5");
    }
    SUBCASE("index") {
        Mesh mesh = sphere;
        mesh.faces[9][2] = 1000;
        check(mesh, FaultId::mesh_bad_index, "face 9");
    }
    SUBCASE("hole") {
        Mesh mesh = test::icosphere(0);
        mesh.faces.erase(mesh.faces.begin());
        check(mesh, FaultId::mesh_open_edge, "edge 0-5, 0-11, 5-11");
    }
    SUBCASE("fin") {
        Mesh mesh = test::icosphere(0);
        mesh.vertices.emplace_back(2, 2, 2);
        mesh.faces.push_back({0, 11, 12});
        check(mesh, FaultId::mesh_non_manifold_edge, "edge 0-11");
        check(mesh, FaultId::mesh_open_edge, "edge 0-12, 11-12");
    }
    SUBCASE("needle") {
        Mesh mesh = sphere;
        const Face f = mesh.faces[4];
        const auto middle = static_cast<uint32_t>(mesh.vertices.size());
        mesh.vertices.emplace_back(0.5 * (mesh.vertices[f[0]] + mesh.vertices[f[1]]));
        mesh.faces.push_back({f[0], f[1], middle});
        check(mesh, FaultId::mesh_degenerate_face, "face 80");
    }
    SUBCASE("sheet with both sides") {
        Mesh mesh;
        mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
        mesh.faces = {{0, 1, 2}, {0, 2, 3}, {0, 2, 1}, {0, 3, 2}};
        check(mesh, FaultId::mesh_duplicate_face, "face 2, 3");
    }
    SUBCASE("flattened") {
        Mesh mesh = test::cube(2);
        for (Eigen::Vector3d& v : mesh.vertices) v.z() = 0.3 * v.x() + 0.1 * v.y() + 1e-14 * v.z();
        Faults faults;
        CHECK_FALSE(check_and_repair(mesh, faults)); // side faces are needles, or the volume is 0
        CHECK(has_error(faults));
    }
    SUBCASE("flat double cover") {
        Mesh mesh; // two different triangulations of one square
        mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
        mesh.faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
        check(mesh, FaultId::mesh_zero_volume, "face 0");
    }
    SUBCASE("Klein bottle") {
        Mesh mesh;
        const int n = 8;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                const double u = 2 * 3.14159265358979 * i / n, v = 2 * 3.14159265358979 * j / n;
                const double r = 2 + std::cos(u / 2) * std::sin(v) - std::sin(u / 2) * std::sin(2 * v);
                mesh.vertices.emplace_back(r * std::cos(u), r * std::sin(u),
                                           std::sin(u / 2) * std::sin(v) + std::cos(u / 2) * std::sin(2 * v));
            }
        const auto at = [&](int i, int j) {
            if (i == n) return static_cast<uint32_t>((2 * n - j) % n); // glued with a flip
            return static_cast<uint32_t>(i * n + j % n);
        };
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                mesh.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
                mesh.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
            }
        check(mesh, FaultId::mesh_inconsistent_winding, "face");
    }
    SUBCASE("one part inside another") {
        Mesh mesh = sphere;
        for (const Face& f : sphere.faces) mesh.faces.push_back({f[0] + 42, f[2] + 42, f[1] + 42});
        for (const Eigen::Vector3d& v : sphere.vertices) mesh.vertices.emplace_back(0.3 * v);
        check(mesh, FaultId::mesh_several_components, "face");
    }
}

TEST_CASE("harmless flaws are repaired with a warning") {
    const Mesh sphere = test::icosphere(1);
    SUBCASE("doubled faces") {
        Mesh mesh = sphere;
        mesh.faces.push_back({sphere.faces[3][1], sphere.faces[3][2], sphere.faces[3][0]});
        Faults faults;
        REQUIRE(check_and_repair(mesh, faults));
        CHECK(warnings(faults, FaultId::mesh_duplicate_face) == 1);
        CHECK(faults[0].where == "face 80");
        CHECK(mesh.faces == sphere.faces);
    }
    SUBCASE("collapsed face") {
        Mesh mesh = sphere;
        mesh.faces.push_back({1, 1, 2});
        Faults faults;
        REQUIRE(check_and_repair(mesh, faults));
        CHECK(warnings(faults, FaultId::mesh_degenerate_face) == 1);
        CHECK(mesh.faces == sphere.faces);
    }
    SUBCASE("loose vertex") {
        Mesh mesh = sphere;
        mesh.vertices.insert(mesh.vertices.begin(), Eigen::Vector3d(9, 9, 9));
        for (Face& f : mesh.faces)
            for (uint32_t& i : f) ++i;
        Faults faults;
        REQUIRE(check_and_repair(mesh, faults));
        CHECK(warnings(faults, FaultId::mesh_isolated_vertex) == 1);
        CHECK(mesh.vertices == sphere.vertices);
        CHECK(mesh.faces == sphere.faces);
    }
    SUBCASE("two cubes that touch in one corner") {
        Mesh mesh = test::cube(2);
        Mesh other = test::cube(2);
        test::apply(other, Eigen::Matrix3d::Identity(), {1, 1, 1});
        const auto base = static_cast<uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
        for (const Face& f : other.faces) mesh.faces.push_back({base + f[0], base + f[1], base + f[2]});
        CHECK(join_identical_vertices(mesh) == 1);
        Faults faults;
        REQUIRE(check_and_repair(mesh, faults));
        CHECK(warnings(faults, FaultId::mesh_non_manifold_edge) == 1);
        CHECK(mesh.vertices.size() == 2 * base);
        CHECK(volume(mesh) == doctest::Approx(2.0));
    }
}

TEST_CASE("too many faces are refused as soon as they are counted") {
    const std::string text = to_obj(test::icosphere(2));
    MeshReadOptions options;
    for (const std::size_t limit : {320U, 319U}) {
        options.max_faces = limit;
        Mesh mesh;
        Faults faults;
        CHECK(read_mesh_memory(text.data(), text.size(), "obj", options, mesh, faults) == (limit == 320));
        CHECK(errors(faults, FaultId::mesh_too_many_faces) == (limit == 320 ? 0 : 1));
    }
}
