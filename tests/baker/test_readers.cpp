// Files that are not as they should be: other encodings, strips, references out of their folder, and unknown kinds.
#include "baker/fault_text.h"
#include "baker/mesh/mesh.h"
#include "baker/mesh/mesh_check.h"
#include "scene_files.h"
#include "scratch.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

using namespace lr;
using namespace lr::baker;
using test::Scratch;

namespace {

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

Mesh read(const std::string& text, const char* extension, Faults& faults) {
    Mesh mesh;
    const bool good = read_mesh_memory(text.data(), text.size(), extension, 1.0, mesh, faults);
    CHECK(good != has_error(faults));
    return mesh;
}

std::string only_fault(const std::string& text, const char* extension) {
    Faults faults;
    read(text, extension, faults);
    REQUIRE(faults.size() == 1);
    return to_string(faults[0]);
}

std::string utf16(const std::string& ascii, bool little) {
    std::string out = little ? "\xff\xfe" : "\xfe\xff";
    for (const char c : ascii) {
        if (!little) out += '\0';
        out += c;
        if (little) out += '\0';
    }
    return out;
}

// A triangle whose positions lie in another file.
std::string gltf_of(const std::string& uri) {
    return R"({"asset":{"version":"2.0"},"buffers":[{"uri":")" + uri +
           R"(","byteLength":48}],"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36},)"
           R"({"buffer":0,"byteOffset":36,"byteLength":12}],"accessors":[)"
           R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},)"
           R"({"bufferView":1,"componentType":5125,"count":3,"type":"SCALAR"}],)"
           R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
           R"("nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],"scene":0})";
}

std::string triangle_bytes() {
    const float positions[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const uint32_t indices[3] = {0, 1, 2};
    return std::string(reinterpret_cast<const char*>(positions), sizeof positions) +
           std::string(reinterpret_cast<const char*>(indices), sizeof indices);
}

// An archive of one file that is not packed. large: Zip64, as lib3mf writes all.
std::string zip_of(const std::string& name, const std::string& text, bool large = false) {
    const auto number = [](uint64_t value, int bytes) {
        std::string out;
        for (; bytes > 0; --bytes, value >>= 8) out += static_cast<char>(value & 255U);
        return out;
    };
    const uint64_t size = text.size(), elsewhere = large ? UINT64_MAX : 0;
    const auto sizes = [&](uint64_t other, uint64_t extra) {
        return number(0, 4) + number(size | other, 4) + number(size | other, 4) + number(name.size(), 2) +
               number(extra, 2);
    };
    const std::string local = "PK\3\4" + number(20, 2) + number(0, 8) + sizes(0, 0) + name + text;
    const std::string extra = large ? number(7, 2) + number(1, 2) + "?" + number(1, 2) + number(24, 2) +
                                          number(size, 8) + number(size, 8) + number(0, 8)
                                    : "";
    const std::string central = "PK\1\2" + number(20, 2) + number(20, 2) + number(0, 8) +
                                sizes(elsewhere, extra.size()) + number(0, 10) + number(elsewhere, 4) + name + extra;
    const std::string end = "PK\6\6" + number(44, 8) + number(0, 12) + number(1, 8) + number(1, 8) +
                            number(central.size(), 8) + number(local.size(), 8) + "PK\6\7" + number(0, 4) +
                            number(local.size() + central.size(), 8) + number(1, 4);
    return local + central + (large ? end : "") + "PK\5\6" + number(0, 4) + number(1 | elsewhere, 2) +
           number(1 | elsewhere, 2) + number(central.size() | elsewhere, 4) + number(local.size() | elsewhere, 4) +
           number(0, 2);
}

} // namespace

TEST_CASE("readers: OBJ with decimal commas, and with the line ends of old Macs") {
    Faults faults;
    for (const char* text :
         {"v 0,5 0 0\nv 1,5 0 0\nv 0,5 -2,25e0 0\nf 1 2 3\n", "v 0.5 0 0\rv 1.5 0 0\rv 0.5 -2.25 0\rf 1 2 3\r"}) {
        const Mesh mesh = read(text, "obj", faults);
        REQUIRE(mesh.faces.size() == 1);
        CHECK(mesh.vertices[2] == Eigen::Vector3d(0.5, -2.25, 0.0));
    }
    CHECK(contains(only_fault("v 1,2,3\nf 1 1 1\n", "obj"), "needs three numbers"));
}

TEST_CASE("readers: a polygon whose hole is joined to its outline by a cut keeps the hole") {
    // The cut between the first corners of two rings passes both twice.
    for (const int n : {4, 5, 16}) {
        std::string text, face = "f";
        for (const double radius : {1.0, 0.5})
            for (int i = 0; i < n; ++i) {
                const double turn = 6.283185307179586 * i / n;
                text += "v " + std::to_string(radius * std::cos(turn)) + " " + std::to_string(radius * std::sin(turn)) +
                        " 0\n";
            }
        for (int i = 0; i < n; ++i) face += " " + std::to_string(i + 1);
        face += " 1 " + std::to_string(n + 1);
        for (int i = n - 1; i >= 0; --i) face += " " + std::to_string(n + 1 + i);
        Faults faults;
        const Mesh mesh = read(text + face + "\n", "obj", faults);
        double area = 0.0;
        for (const Face& f : mesh.faces)
            area += 0.5 *
                    (mesh.vertices[f[1]] - mesh.vertices[f[0]]).cross(mesh.vertices[f[2]] - mesh.vertices[f[0]]).norm();
        CHECK(mesh.faces.size() == static_cast<std::size_t>(2 * n));
        CHECK(area == doctest::Approx(0.375 * n * std::sin(6.283185307179586 / n)).epsilon(1e-5));
    }
}

// Of a rectangle's corners all are equally good ears, and the back begins at another one.
TEST_CASE(
    "readers: both sides of a polygon have the same triangles, wherever each begins and whether they share vertices") {
    const std::string corners = "v 0 0 0\nv 5 0 0\nv 5 3 0\nv 0 3 0\n";
    for (const char* back : {"4 3 2 1", "3 2 1 4", "2 1 4 3", "1 4 3 2", "8 7 6 5", "6 5 8 7", "2 3 4 1"}) {
        CAPTURE(back);
        Faults faults;
        const Mesh mesh = read(corners + corners + "f 1 2 3 4\nf " + back + "\n", "obj", faults);
        REQUIRE(mesh.faces.size() == 4);
        const auto places = [&](std::size_t f) {
            std::vector<std::array<double, 3>> all;
            for (const uint32_t i : mesh.faces[f]) {
                const Eigen::Vector3d& p = mesh.vertices[i];
                all.push_back({p.x(), p.y(), p.z()});
            }
            std::sort(all.begin(), all.end());
            return all;
        };
        const auto normal = [&](std::size_t f) {
            const Face& c = mesh.faces[f];
            const Eigen::Vector3d a = mesh.vertices[c[1]] - mesh.vertices[c[0]];
            return a.cross(mesh.vertices[c[2]] - mesh.vertices[c[0]]).eval();
        };
        const double sense = back == std::string("2 3 4 1") ? 1.0 : -1.0;
        for (std::size_t f = 0; f < 2; ++f) {
            CHECK(places(f) == places(f + 2));
            CHECK((normal(f) - sense * normal(f + 2)).norm() < 1e-12);
        }
    }
}

TEST_CASE("readers: STL as text, with blanks in names, without normals, in double precision") {
    const std::string facet =
        "FACET\nouter loop\nvertex 0 0 0\nvertex 1.0000000001 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
    const std::string text = "\n solid Maple leaf \r\n" + facet + "endsolid Maple leaf\n  SOLID\tTwo  Stalks\n" +
                             facet + "ENDSOLID\nsolid nothing\nendsolid\nsolid " + std::string(2000, 'x') + "\n" +
                             facet;
    for (const char* name : {"Maple leaf", "Two  Stalks"}) {
        MeshReadOptions options;
        options.mesh = name;
        Mesh mesh;
        Faults faults;
        REQUIRE(read_mesh_memory(text.data(), text.size(), "stl", options, mesh, faults));
        REQUIRE(mesh.faces.size() == 1);
        CHECK(mesh.vertices[1].x() == 1.0000000001);
    }
    CHECK(contains(only_fault("solid a\nfacet\nvertex 0 0 0\nvertex 1 0\nendloop\n", "stl"), "error 201 at line 5"));
}

TEST_CASE("readers: STL in capitals, and glTF whose meshes are packed") {
    Faults faults;
    const Mesh mesh =
        read("SOLID A\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 0 1.5E0 0\nENDLOOP\n"
             "ENDFACET\nENDSOLID A\n",
             "stl", faults);
    REQUIRE(mesh.faces.size() == 1);
    CHECK(mesh.vertices[mesh.faces[0][2]].y() == 1.5);
    const std::string text = R"({"asset":{"version":"2.0"},"extensionsRequired" : ["KHR_mesh_quantization",)"
                             R"("EXT_meshopt_compression"]})";
    CHECK(contains(only_fault(text, "gltf"), "packed (EXT_meshopt_compression)"));
}

TEST_CASE("readers: instances of glTF by EXT_mesh_gpu_instancing") {
    // A triangle, two places, and two turns about z as normalized bytes.
    const float numbers[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 10, 0, 0};
    const int8_t turns[] = {0, 0, 0, 127, 0, 0, 127, 0};
    std::string bytes(reinterpret_cast<const char*>(numbers), sizeof numbers);
    bytes.append(reinterpret_cast<const char*>(turns), sizeof turns);
    const Scratch scratch;
    scratch.write("copies.bin", bytes);
    const std::string text =
        R"({"asset":{"version":"2.0"},"extensionsRequired":["EXT_mesh_gpu_instancing"],"buffers":[{"uri":"copies.bin","byteLength":68}],)"
        R"("bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":24},{"buffer":0,"byteOffset":60,"byteLength":8}],)"
        R"("accessors":[{"bufferView":0,"count":3,"type":"VEC3","componentType":5126},{"bufferView":1,"count":2,"type":"VEC3","componentType":5126},)"
        R"({"bufferView":2,"count":2,"type":"VEC4","componentType":5120,"normalized":true}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
        R"("nodes":[{"name":"twig","mesh":0,"translation":[0,0,5],"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":1,"ROTATION":2}}}}],)"
        R"("scenes":[{"nodes":[0]}],"scene":0})";
    MeshReadOptions options;
    options.mesh = "twig";
    Mesh mesh;
    Faults faults;
    REQUIRE(read_mesh(scratch.write("copies.gltf", text), options, mesh, faults));
    REQUIRE(mesh.faces.size() == 2);
    CHECK(mesh.vertices[mesh.faces[0][1]].isApprox(Eigen::Vector3d(1, 0, 5), 1e-6));
    CHECK(mesh.vertices[mesh.faces[1][1]].isApprox(Eigen::Vector3d(9, 0, 5), 1e-6)); // half a turn about z
    std::string outside = text;
    outside.replace(outside.find(R"("count":2)"), 9, R"("count":9)");
    CHECK_FALSE(read_mesh(scratch.write("outside.gltf", outside), options, mesh, faults));
}

TEST_CASE("readers: glTF positions that are whole numbers") {
    const Scratch scratch;
    // Four triangles of the same place: shorts 8 bytes apart, their bytes as parts of the largest number, and so without a sign.
    const int16_t wide[] = {0, 0, 0, 99, 32767, 0, 0, 99, 0, -32768, 16384, 99};
    const int8_t narrow[] = {0, 0, 0, 99, 127, 0, 0, 99, 0, -128, 64, 99};
    const uint16_t wide_up[] = {0, 0, 0, 99, 65535, 0, 0, 99, 0, 13107, 100, 99};
    const uint8_t narrow_up[] = {0, 0, 0, 99, 255, 0, 0, 99, 0, 51, 100, 99};
    std::string bytes;
    for (const auto& [from, size] :
         {std::pair<const void*, std::size_t>{wide, 24}, {narrow, 12}, {wide_up, 24}, {narrow_up, 12}})
        bytes.append(static_cast<const char*>(from), size);
    scratch.write("packed.bin", bytes);
    const auto scene = [](const std::string& uri, const std::string& type, const std::string& begin,
                          const char* stride) {
        return R"({"asset":{"version":"2.0"},"extensionsRequired":["KHR_mesh_quantization"],"buffers":[{)" + uri +
               R"("byteLength":72}],"bufferViews":[{"buffer":0,"byteOffset":)" + begin + R"(,"byteStride":)" + stride +
               R"(,"byteLength":12}],"accessors":[{"bufferView":0,"count":3,"type":"VEC3",)" + type +
               R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0,"scale":[3,3,3]}],)"
               R"("scenes":[{"nodes":[0]}],"scene":0})";
    };
    struct Case {
        const char *type, *begin, *stride;
        Eigen::Vector3d second, third;
    };
    for (const auto& [type, begin, stride, second, third] :
         {Case{R"("componentType":5122,"normalized":true)", "0", "8", {3, 0, 0}, {0, -3, 3 * 16384.0 / 32767}},
          Case{R"("componentType":5120,"normalized":true)", "24", "4", {3, 0, 0}, {0, -3, 3 * 64.0 / 127}},
          Case{R"("componentType":5120)", "24", "4", {381, 0, 0}, {0, -384, 192}},
          Case{R"("componentType":5123,"normalized":true)", "36", "8", {3, 0, 0}, {0, 0.6, 300.0 / 65535}},
          Case{R"("componentType":5121,"normalized":true)", "60", "4", {3, 0, 0}, {0, 0.6, 300.0 / 255}}}) {
        CAPTURE(type);
        Mesh mesh;
        Faults faults;
        const std::string path = scratch.write("packed.gltf", scene(R"("uri":"packed.bin",)", type, begin, stride));
        REQUIRE(read_mesh(path, MeshReadOptions{}, mesh, faults));
        REQUIRE(mesh.vertices.size() == 3);
        CHECK((mesh.vertices[1] - second).norm() < 1e-5);
        CHECK((mesh.vertices[2] - third).norm() < 1e-5);
    }
    // Bytes in the text; and what is not read.
    Faults faults;
    const std::string inside =
        R"("uri":"data:application/octet-stream;base64,AAAAAAAAAAAFAAAAAAAAAAAABwAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA",)";
    const Mesh mesh = read(scene(inside, R"("componentType":5123)", "0", "8"), "gltf", faults);
    REQUIRE(mesh.vertices.size() == 3);
    CHECK(mesh.vertices[1].isApprox(Eigen::Vector3d(15, 0, 0)));
    CHECK(mesh.vertices[2].isApprox(Eigen::Vector3d(0, 21, 0)));
    CHECK(contains(only_fault(scene(inside, R"("componentType":5123,"sparse":{"count":0})", "0", "8"), "gltf"),
                   "(positions in KHR_mesh_quantization)"));
    CHECK(
        contains(only_fault(scene(R"("uri":"gone.bin",)", R"("componentType":5123)", "0", "8"), "gltf"), "is missing"));
}

TEST_CASE("readers: the joints of a skinned glTF mesh place it, not its node") {
    const Scratch scratch;
    const float numbers[] = {0,   0, 0, 1, 0, 0,   0, 2, 0, // positions
                             100, 0, 0, 0, 0, 100, 0, 0, 0, 0, 100, 0,
                             0,   0, 0, 1,                              // the joint's inverse, as it is when bound
                             1,   0, 0, 0, 1, 0,   0, 0, 1, 0, 0,   0}; // weights
    const uint32_t indices[] = {0, 1, 2}, joints[] = {0, 0, 0};         // the latter four bytes a vertex
    std::string bytes;
    for (const auto& [from, size] :
         {std::pair<const void*, std::size_t>{numbers, sizeof numbers}, {indices, 12}, {joints, 12}})
        bytes.append(static_cast<const char*>(from), size);
    scratch.write("skin.bin", bytes);
    const std::string scene =
        R"({"asset":{"version":"2.0"},"buffers":[{"uri":"skin.bin","byteLength":172}],"bufferViews":[)"
        R"({"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":64},{"buffer":0,"byteOffset":100,"byteLength":48},)"
        R"({"buffer":0,"byteOffset":148,"byteLength":12},{"buffer":0,"byteOffset":160,"byteLength":12}],"accessors":[)"
        R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},{"bufferView":1,"componentType":5126,"count":1,"type":"MAT4"},)"
        R"({"bufferView":2,"componentType":5126,"count":3,"type":"VEC4"},{"bufferView":3,"componentType":5125,"count":3,"type":"SCALAR"},)"
        R"({"bufferView":4,"componentType":5121,"count":3,"type":"VEC4"}],)"
        R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"WEIGHTS_0":2,"JOINTS_0":4},"indices":3}]}],)"
        R"("skins":[{"joints":[1],"inverseBindMatrices":1}],"nodes":[{"scale":[0.01,0.01,0.01],"children":[1,2]},)"
        R"({"name":"bone","translation":[300,0,0]},{"mesh":0,"skin":0,"translation":[0,9,0]}],"scenes":[{"nodes":[0]}],"scene":0})";
    std::string unbound = scene; // the identity then
    unbound.erase(unbound.find(R"(,"inverseBindMatrices":1)"), 24);
    for (const auto& [text, tip] : {std::pair(scene, Eigen::Vector3d(3, 2, 0)), {unbound, {3, 0.02, 0}}}) {
        Mesh mesh;
        Faults faults;
        REQUIRE(read_mesh(scratch.write("skin.gltf", text), MeshReadOptions{}, mesh, faults));
        REQUIRE(mesh.vertices.size() == 3);
        CHECK(mesh.vertices[2].isApprox(tip, 1e-5));
    }
}

TEST_CASE("readers: coarser levels of detail and collision shapes are not baked with the object") {
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n";
    std::string text;
    for (const char* name :
         {"oak_LOD1", "oak_LOD0", "oak_LOD2", "elm_lod1", "ash", "UCX_oak_01", "ash-colonly", "balloon_load2"})
        text += std::string("o ") + name + "\n" + triangle;
    MeshReadOptions options;
    Mesh mesh;
    Faults faults;
    REQUIRE(read_mesh_memory(text.data(), text.size(), "obj", options, mesh, faults));
    CHECK(mesh.faces.size() == 8); // where nothing is repaired
    options.repair = true;
    faults.clear();
    REQUIRE(read_mesh_memory(text.data(), text.size(), "obj", options, mesh, faults));
    CHECK(mesh.faces.size() == 4);
    CHECK(contains(faults[0].what, "collision shapes: 'oak_LOD1', 'oak_LOD2', 'UCX_oak_01', 'ash-colonly'."));
    options.mesh = "UCX_oak_01";
    REQUIRE(read_mesh_memory(text.data(), text.size(), "obj", options, mesh, faults));
    CHECK(mesh.faces.size() == 1);
}

TEST_CASE("readers: names of levels of detail and collision shapes, as programs write them") {
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n";
    for (const auto& [fine, coarse] : {std::pair{"oak", "oak_LOD1"},
                                       {"oak-LOD0", "oak-LOD1"},
                                       {"oak.lod0", "oak.lod1"},
                                       {"oakLOD0", "oakLOD1"},
                                       {"LOD0", "LOD1"},
                                       {"LOD0_oak", "LOD1_oak"},
                                       {"oak_LOD0.001", "oak_LOD1.001"},
                                       {"oak_LOD_00", "oak_LOD_01"},
                                       {"oak_LOD2", "oak_LOD10"},
                                       {"oak LOD0 bark", "oak LOD1 bark"},
                                       {"oak", "ucx_oak"},
                                       {"oak", "MCDCX_oak_00"},
                                       {"oak", "oak-colonly.001"},
                                       {"oak", "Oak_Collision"},
                                       {"oak", "oak_collider"}}) {
        CAPTURE(coarse);
        MeshReadOptions options;
        options.repair = true;
        Mesh mesh;
        Faults faults;
        const auto faces = [&](const std::string& one, const std::string& other) {
            const std::string text = "o " + one + "\n" + triangle + "o " + other + "\n" + triangle;
            REQUIRE(read_mesh_memory(text.data(), text.size(), "obj", options, mesh, faults));
            return mesh.faces.size();
        };
        CHECK(faces(fine, coarse) == 1);
        CHECK(faces(coarse, fine) == 1);
        CHECK(faces(coarse, coarse) == 2);
    }
    for (const auto& [one, other] :
         {std::pair{"melod0", "melod1"}, {"oak_LOD0", "elm_LOD1"}, {"oak_LOD0a", "oak_LOD1a"}}) {
        const std::string text = std::string("o ") + one + "\n" + triangle + "o " + other + "\n" + triangle;
        MeshReadOptions options;
        options.repair = true;
        Mesh mesh;
        Faults faults;
        REQUIRE(read_mesh_memory(text.data(), text.size(), "obj", options, mesh, faults));
        CHECK(mesh.faces.size() == 2);
    }
}

TEST_CASE("readers: OFF keeps every face") {
    const std::string corners = "0 0 0\n1 0 0 # comment\n\n0 1 0 0.5 0.5 1\n0 0 1.0000000001\n";
    const std::string faces = "3 0 2 1\n3 0 1 3 255 0 0\n3 0 3 2 # red\n3 1 2 3";
    for (const std::string& text : {"OFF\n4 4 6\n" + corners + faces, "# made by hand\nCOFF 4 4 6\n" + corners + faces,
                                    "4 4 0\n" + corners + faces, "OFF\n4 4\n" + corners + faces,
                                    "\xef\xbb\xbfNOFF\r\n4 4 0\r\n" + corners + faces}) {
        CAPTURE(text);
        Faults faults;
        const Mesh mesh = read(text, "off", faults);
        CHECK(faults.empty());
        REQUIRE(mesh.faces.size() == 4);
        CHECK(mesh.faces[1] == Face{0, 1, 3});
        CHECK(mesh.vertices[3].z() == 1.0000000001); // double precision
    }
}

TEST_CASE("readers: damaged OFF files name the line") {
    CHECK(contains(only_fault("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n", "off"), "error 204 at line 6"));
    CHECK(contains(only_fault("OFF\n3 1 0\n0 0 0\n1 0\n", "off"), "error 201 at line"));
    CHECK(contains(only_fault("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 nan\n3 0 1 2\n", "off"), "error 203 at vertex 2"));
    CHECK(contains(only_fault("OFF BINARY\n", "off"), "binary OFF"));
    CHECK(contains(only_fault("4OFF\n", "off"), "four or more dimensions"));
    CHECK(contains(only_fault("OFF\n1000000000 1 0\n0 0 0\n", "off"), "error 201"));
}

TEST_CASE("readers: PLY strips become triangles of one winding") {
    // A strip over a square of two by one, a seam, and a second strip.
    Faults faults;
    const Mesh mesh =
        read("ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
             "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
             "0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n2 1 0\n11 1 0 3 2 2 -1 -1 3 2 5 4\n",
             "ply", faults);
    CHECK(faults.empty());
    REQUIRE(mesh.faces.size() == 4);
    for (const Face& f : mesh.faces) {
        const Eigen::Vector3d normal =
            (mesh.vertices[f[1]] - mesh.vertices[f[0]]).cross(mesh.vertices[f[2]] - mesh.vertices[f[0]]);
        CHECK(normal.z() == 1.0);
    }
    CHECK(contains(
        only_fault("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
                   "z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n"
                   "0 0 0\n0 1 0\n1 0 0\n3 0 1 -2\n",
                   "ply"),
        "error 204"));
}

TEST_CASE("readers: text in UTF-16") {
    for (const bool little : {true, false}) {
        Faults faults;
        CHECK(read(utf16("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", little), "obj", faults).faces.size() == 1);
        CHECK(faults.empty());
    }
    Faults faults;
    CHECK(read("\xef\xbb\xbfv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "obj", faults).faces.size() == 1);
}

TEST_CASE("readers: a scene opens no file outside its folder") {
    const Scratch scratch;
    namespace fs = std::filesystem;
    fs::create_directories(scratch.path("model/parts"));
    scratch.write("outside.bin", triangle_bytes());
    scratch.write("model/inside.bin", triangle_bytes());
    scratch.write("model/parts/below.bin", triangle_bytes());
    scratch.write("model/oak leaf ä.bin", triangle_bytes());
    scratch.write("model/5%20.bin", triangle_bytes());
    fs::create_symlink(scratch.path("outside.bin"), scratch.path("model/link.bin"));
    fs::create_symlink(scratch.path("model/inside.bin"), scratch.path("model/inner.bin"));
    const auto read_scene = [&](const std::string& uri, Faults& faults) {
        Mesh mesh;
        return read_mesh(scratch.write("model/scene.gltf", gltf_of(uri)), MeshReadOptions{}, mesh, faults) &&
               mesh.faces.size() == 1;
    };
    for (const char* uri : {"inside.bin", "parts/below.bin", "./parts/../inside.bin", "inner.bin",
                            "oak%20leaf%20%C3%a4.bin", "5%20.bin"}) {
        CAPTURE(uri);
        Faults faults;
        CHECK(read_scene(uri, faults));
        CHECK(faults.empty());
    }
    for (const char* uri : {"../outside.bin", "parts/../../outside.bin", "link.bin", "%2e%2e/outside.bin"}) {
        CAPTURE(uri);
        Faults faults;
        CHECK_FALSE(read_scene(uri, faults));
        REQUIRE(faults.size() == 1);
        CHECK(faults[0].id == FaultId::file_outside);
    }
    // Absolute paths name files in the folder, which are missing.
    for (const std::string& uri : {scratch.path("outside.bin"), std::string("inside.bin%00"), std::string("gone%2")}) {
        CAPTURE(uri);
        Faults faults;
        CHECK_FALSE(read_scene(uri, faults));
        CHECK(has_error(faults));
    }
    Faults faults;
    CHECK_FALSE(read_scene("gone.bin", faults));
    REQUIRE(faults.size() == 1);
    CHECK(contains(faults[0].what, "belongs to it is missing"));
    CHECK(contains(faults[0].what, "gone.bin"));
    // The same from within the folder, by a path without one.
    const fs::path before = fs::current_path();
    fs::current_path(scratch.path("model"));
    Mesh mesh;
    faults.clear();
    CHECK_FALSE(read_mesh("scene.gltf", MeshReadOptions{}, mesh, faults));
    fs::current_path(before);
    REQUIRE(faults.size() == 1);
    CHECK(contains(faults[0].what, "belongs to it is missing"));
}

TEST_CASE("readers: what a file is, and the way out, in a modeller's words") {
    CHECK(contains(only_fault("BLENDER-v300 and so on", "blend2"), "a Blender file"));
    CHECK(contains(only_fault("ISO-10303-21;\nHEADER;", "step"), "exact surfaces"));
    CHECK(contains(only_fault("anything", "c4d"), "own file"));
    CHECK(contains(only_fault("anything", "txt"), "No reader knows this kind of file"));
    CHECK(contains(only_fault(std::string("glTF\1\0\0\0\x14\0\0\0", 12), "glb"), "glTF 1"));
    CHECK(contains(only_fault(R"({"meshes":[]})", "gltf"), "does not state its version: it has no \"asset\""));
    CHECK(contains(only_fault(R"({"meshes":{}})", "gltf"), "a draft of glTF 1"));
    CHECK(contains(only_fault(R"({"asset":{"version":"3.0"}})", "gltf"), "This is glTF 3.0"));
    CHECK(contains(only_fault(R"({"asset":{"version":"2.0"},"meshes":[)", "gltf"), "cut off or damaged"));
    CHECK(contains(only_fault("PK anything", "3mf"), "no 3MF archive"));
    for (const char* extension : {"obj", "ply", "glb", "fbx"})
        CHECK(contains(only_fault("version https://git-lfs.github.com/spec/v1\noid sha256:0\n", extension), "Git LFS"));
    CHECK(contains(only_fault("v 0 0 0\nv 1 0 0\nl 1 2\n", "obj"), "2 points, lines or curves"));
}

TEST_CASE("readers: 3MF has a unit, and objects made of placed components") {
    const std::string triangle =
        "<mesh><vertices><vertex x='0' y='0' z='0'/><vertex x='2' y='0' z='0'/><vertex x='0' y='2' z='0'/></vertices>"
        "<triangles><triangle v1='0' v2='1' v3='2'/></triangles></mesh>";
    const std::string model =
        "<?xml version='1.0'?><model unit='centimeter'><resources>"
        "<object id='1' name='blade'>" +
        triangle + "</object><object id='7' name='spare'>" + triangle +
        "</object>"
        "<object id='2' name='fan'><components><component objectid='1'/>"
        "<component objectid='1' transform='-1 0 0 0 1 0 0 0 1 10 0 5'/></components></object></resources>"
        "<build><item objectid='2' transform='1 0 0 0 1 0 0 0 1 0 0 1'/></build></model>";
    MeshReadOptions options;
    Mesh mesh;
    Faults faults;
    std::string bytes;
    SUBCASE("archive") {
        bytes = zip_of("3D/3dmodel.model", model);
    }
    SUBCASE("large archive") {
        bytes = zip_of("3D/3dmodel.model", model, true);
    }
    REQUIRE(read_mesh_memory(bytes.data(), bytes.size(), "3mf", options, mesh, faults));
    REQUIRE(mesh.faces.size() == 2);
    REQUIRE(mesh.vertices.size() == 6);
    CHECK(mesh.vertices[1].isApprox(Eigen::Vector3d(0.02, 0.0, 0.01)));
    CHECK(mesh.vertices[4].isApprox(Eigen::Vector3d(0.08, 0.0, 0.06)));
    const Face& f = mesh.faces[1]; // mirrored, and wound back
    CHECK((mesh.vertices[f[1]] - mesh.vertices[f[0]]).cross(mesh.vertices[f[2]] - mesh.vertices[f[0]]).z() > 0.0);
    options.mesh = "spare";
    CHECK_FALSE(read_mesh_memory(bytes.data(), bytes.size(), "3mf", options, mesh, faults));
    for (std::size_t n = 0; n < bytes.size(); n += 7) { // cut or damaged, it is read or refused
        std::string changed = bytes;
        changed[n] = '\xff';
        for (const std::string& damaged : {bytes.substr(0, n), changed}) {
            faults.clear();
            const bool good = read_mesh_memory(damaged.data(), damaged.size(), "3mf", MeshReadOptions{}, mesh, faults);
            CHECK(good != has_error(faults));
        }
    }
}

TEST_CASE("readers: faults name object, material and the place in the file") {
    const std::string text = "o lid\nv 0 0 0\nv 40 0 0\nv 0 40 0\nusemtl tin\nf 1 2 3\n"
                             "o rim\nv 100 7 3\nv 200 7 3\nv 300 7 3\nusemtl zinc\nf 4 5 6\n";
    MeshReadOptions options;
    options.unit_scale = 0.001;
    options.up = UpAxis::y;
    Mesh mesh;
    Faults faults;
    REQUIRE(read_mesh_memory(text.data(), text.size(), "obj", options, mesh, faults));
    CHECK_FALSE(check_sheet(mesh, faults));
    CHECK(faults.back().where == "face 1 at (200, 7, 3) of object 'rim', material 'zinc'");
    mesh.source->scale_by(2.0);
    mesh.source->move_to({0.02, 0.0, 0.0});
    CHECK(mesh.source->place({0.0, 0.0, 0.0}) == "(10, 0, 0) of object 'lid', material 'tin'");
    CHECK(contains(mesh.source->largest(), "of 2 faces"));
}

TEST_CASE("readers: vertices without a position are left out where meshes are repaired") {
    const std::string text = "v 0 0 0\nv nan 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 1 3 4\nf 3 5 4\n";
    MeshReadOptions options;
    Mesh mesh;
    Faults faults;
    CHECK_FALSE(read_mesh_memory(text.data(), text.size(), "obj", options, mesh, faults));
    options.repair = true;
    faults.clear();
    REQUIRE(read_mesh_memory(text.data(), text.size(), "obj", options, mesh, faults));
    CHECK(mesh.vertices.size() == 4);
    CHECK(mesh.faces.size() == 2);
    REQUIRE(faults.size() == 1);
    CHECK(contains(faults[0].what, "1 face there was left out"));
}

TEST_CASE("polygons of thousands of corners keep their area") {
    const int n = 3001;
    std::string star, face = "f";
    for (int i = 0; i < n; ++i) {
        const double turn = 6.283185307179586 * i / n, radius = i % 2 ? 1.0 : 0.5;
        star += "v " + std::to_string(radius * std::cos(turn)) + " " + std::to_string(radius * std::sin(turn)) + " 0\n";
        face += " " + std::to_string(i + 1);
    }
    Faults faults;
    const Mesh mesh = read(star + face + "\n", "obj", faults);
    CHECK(mesh.faces.size() == n - 2);
    double area = 0.0, turned = 0.0;
    for (int i = 0; i < n; ++i) {
        const Eigen::Vector3d &a = mesh.vertices[static_cast<std::size_t>(i)],
                              &b = mesh.vertices[static_cast<std::size_t>((i + 1) % n)];
        area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    double sum = 0.0;
    for (const Face& f : mesh.faces) {
        const double z =
            0.5 * (mesh.vertices[f[1]] - mesh.vertices[f[0]]).cross(mesh.vertices[f[2]] - mesh.vertices[f[0]]).z();
        sum += z;
        turned += std::min(z, 0.0);
    }
    CHECK(sum == doctest::Approx(area));
    CHECK(turned == 0.0);
}
