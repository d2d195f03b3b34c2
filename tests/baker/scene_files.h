// The same small scene in every scene format: two nested nodes, the inner one mirrored.
#pragma once

#include "baker/mesh/mesh.h"

#include <Eigen/Geometry>

#include <cstring>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace lr::test {

// Volume 1, centroid (0.25, 0.5, 0.75), no symmetry.
inline baker::Mesh tetrahedron() {
    baker::Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
    mesh.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    return mesh;
}

struct SceneNode {
    const char* name;
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();
    double degrees = 0.0; // about z
    Eigen::Vector3d scale = Eigen::Vector3d::Ones();
    int parent = -1; // an earlier node
    bool has_mesh = true;

    Eigen::Affine3d transform() const {
        return Eigen::Translation3d(translation) *
               Eigen::AngleAxisd(degrees * 3.14159265358979323846 / 180.0, Eigen::Vector3d::UnitZ()) *
               Eigen::Scaling(scale);
    }
};
using SceneNodes = std::vector<SceneNode>;

inline SceneNodes nested_nodes() {
    return {{"Outer", {10, 0, 0}, 90.0, {2, 2, 2}, -1, false}, {"Inner", {0, 1, 0}, 30.0, {-1, 1, 0.5}, 0}};
}

inline Eigen::Affine3d nested_transform() {
    const SceneNodes nodes = nested_nodes();
    return nodes[0].transform() * nodes[1].transform();
}

inline SceneNodes two_nodes() {
    return {{"Left"}, {"Right", {20, 0, 0}}};
}

inline std::string triple(const Eigen::Vector3d& v, const char* between) {
    std::ostringstream text;
    text << v[0] << between << v[1] << between << v[2];
    return text.str();
}

// asset: contents of that element, such as <unit>.
inline std::string collada(const baker::Mesh& mesh, const SceneNodes& nodes, const std::string& asset) {
    std::ostringstream text;
    text << R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">)"
         << "<asset>" << asset << "</asset>"
         << R"(<library_geometries><geometry id="geo-id" name="Geo"><mesh><source id="p"><float_array id="pa" count=")"
         << 3 * mesh.vertices.size() << "\">";
    for (const Eigen::Vector3d& v : mesh.vertices) text << triple(v, " ") << ' ';
    text << R"(</float_array><technique_common><accessor source="#pa" count=")" << mesh.vertices.size()
         << R"(" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>)"
         << R"(</accessor></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/>)"
         << R"(</vertices><triangles count=")" << mesh.faces.size()
         << R"("><input semantic="VERTEX" source="#v" offset="0"/><p>)";
    for (const baker::Face& f : mesh.faces) text << f[0] << ' ' << f[1] << ' ' << f[2] << ' ';
    text << "</p></triangles></mesh></geometry></library_geometries><library_visual_scenes><visual_scene id=\"s\">";
    const auto write = [&](const auto& self, int parent) -> void {
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const SceneNode& n = nodes[i];
            if (n.parent != parent) continue;
            text << "<node id=\"" << n.name << "-id\" name=\"" << n.name << "\"><translate>"
                 << triple(n.translation, " ") << "</translate><rotate>0 0 1 " << n.degrees << "</rotate><scale>"
                 << triple(n.scale, " ") << "</scale>";
            if (n.has_mesh) text << "<instance_geometry url=\"#geo-id\"/>";
            self(self, static_cast<int>(i));
            text << "</node>";
        }
    };
    write(write, -1);
    text << R"(</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
    return text.str();
}

// ASCII, version 7.3. settings: lines of the global settings.
inline std::string fbx(const baker::Mesh& mesh, const SceneNodes& nodes, const std::string& settings) {
    std::ostringstream text;
    text << "; FBX 7.3.0 project file\nFBXHeaderExtension:  {\n\tFBXHeaderVersion: 1003\n\tFBXVersion: 7300\n}\n"
         << "GlobalSettings:  {\n\tVersion: 1000\n\tProperties70:  {\n"
         << settings << "\t}\n}\nObjects:  {\n\tGeometry: 1000, \"Geometry::Geo\", \"Mesh\" {\n\t\tVertices: *"
         << 3 * mesh.vertices.size() << " {\n\t\t\ta: ";
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) text << (i ? "," : "") << triple(mesh.vertices[i], ",");
    text << "\n\t\t}\n\t\tPolygonVertexIndex: *" << 3 * mesh.faces.size() << " {\n\t\t\ta: ";
    for (std::size_t i = 0; i < mesh.faces.size(); ++i)
        text << (i ? "," : "") << mesh.faces[i][0] << ',' << mesh.faces[i][1] << ",-" << mesh.faces[i][2] + 1;
    text << "\n\t\t}\n\t\tGeometryVersion: 124\n\t}\n";
    std::ostringstream connections;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const SceneNode& n = nodes[i];
        text << "\tModel: " << 2000 + i << ", \"Model::" << n.name << "\", \"" << (n.has_mesh ? "Mesh" : "Null")
             << "\" {\n\t\tVersion: 232\n\t\tProperties70:  {\n"
             << "\t\t\tP: \"Lcl Translation\", \"Lcl Translation\", \"\", \"A\"," << triple(n.translation, ",")
             << "\n\t\t\tP: \"Lcl Rotation\", \"Lcl Rotation\", \"\", \"A\",0,0," << n.degrees
             << "\n\t\t\tP: \"Lcl Scaling\", \"Lcl Scaling\", \"\", \"A\"," << triple(n.scale, ",") << "\n\t\t}\n\t}\n";
        connections << "\tC: \"OO\"," << 2000 + i << ',' << (n.parent < 0 ? 0 : 2000 + n.parent) << '\n';
        if (n.has_mesh) connections << "\tC: \"OO\",1000," << 2000 + i << '\n';
    }
    text << "}\nConnections:  {\n" << connections.str() << "}\n";
    return text.str();
}

inline std::string fbx_unit(double centimetres) {
    std::ostringstream text;
    text << "\t\tP: \"UpAxis\", \"int\", \"Integer\", \"\",1\n"
         << "\t\tP: \"UnitScaleFactor\", \"double\", \"Number\", \"\"," << centimetres << "\n";
    return text.str();
}

// A binary container.
inline std::string glb(const baker::Mesh& mesh, const SceneNodes& nodes) {
    std::string bytes;
    const auto append = [](std::string& to, const auto value) {
        char raw[sizeof value];
        std::memcpy(raw, &value, sizeof value);
        to.append(raw, sizeof value);
    };
    for (const Eigen::Vector3d& v : mesh.vertices)
        for (const double x : v) append(bytes, static_cast<float>(x));
    const std::size_t positions = bytes.size();
    for (const baker::Face& f : mesh.faces)
        for (const uint32_t i : f) append(bytes, i);
    const std::size_t half = mesh.faces.size() / 2 * 12, rest = bytes.size() - positions - half;
    std::ostringstream json;
    json.precision(17);
    json << R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[)";
    const char* comma = "";
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (nodes[i].parent < 0) json << std::exchange(comma, ",") << i;
    json << R"(]}],"nodes":[)";
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const SceneNode& n = nodes[i];
        const Eigen::Quaterniond q(
            Eigen::AngleAxisd(n.degrees * 3.14159265358979323846 / 180.0, Eigen::Vector3d::UnitZ()));
        json << (i ? "," : "") << R"({"name":")" << n.name << R"(","translation":[)" << triple(n.translation, ",")
             << R"(],"rotation":[)" << q.x() << ',' << q.y() << ',' << q.z() << ',' << q.w() << R"(],"scale":[)"
             << triple(n.scale, ",") << ']';
        if (n.has_mesh) json << R"(,"mesh":0)";
        comma = R"(,"children":[)";
        bool has_children = false;
        for (std::size_t k = 0; k < nodes.size(); ++k)
            if (nodes[k].parent == static_cast<int>(i)) {
                json << std::exchange(comma, ",") << k;
                has_children = true;
            }
        json << (has_children ? "]}" : "}");
    }
    // Two primitives, as in a mesh of two materials.
    json << R"(],"meshes":[{"name":"Geo","primitives":[{"attributes":{"POSITION":0},"indices":1},)"
         << R"({"attributes":{"POSITION":0},"indices":2}]}],"buffers":[{"byteLength":)" << bytes.size()
         << R"(}],"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":)" << positions
         << R"(},{"buffer":0,"byteOffset":)" << positions << R"(,"byteLength":)" << half
         << R"(},{"buffer":0,"byteOffset":)" << positions + half << R"(,"byteLength":)" << rest
         << R"(}],"accessors":[{"bufferView":0,"componentType":5126,"count":)" << mesh.vertices.size()
         << R"(,"type":"VEC3","min":[-10,-10,-10],"max":[10,10,10]},{"bufferView":1,"componentType":5125,"count":)"
         << half / 4 << R"(,"type":"SCALAR"},{"bufferView":2,"componentType":5125,"count":)" << rest / 4
         << R"(,"type":"SCALAR"}]})";
    std::string text = json.str();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string file = "glTF";
    append(file, uint32_t{2});
    append(file, static_cast<uint32_t>(12 + 8 + text.size() + 8 + bytes.size()));
    append(file, static_cast<uint32_t>(text.size()));
    file += "JSON" + text;
    append(file, static_cast<uint32_t>(bytes.size()));
    file += std::string("BIN\0", 4) + bytes;
    return file;
}

inline std::string binary_stl(const baker::Mesh& mesh) {
    std::string bytes(80, ' ');
    const auto append = [&](const auto value) {
        char raw[sizeof value];
        std::memcpy(raw, &value, sizeof value);
        bytes.append(raw, sizeof value);
    };
    append(static_cast<uint32_t>(mesh.faces.size()));
    for (const baker::Face& f : mesh.faces) {
        for (int k = 0; k < 3; ++k) append(0.0F);
        for (const uint32_t i : f)
            for (const double x : mesh.vertices[i]) append(static_cast<float>(x));
        append(uint16_t{0});
    }
    return bytes;
}

inline std::string ascii_stl(const std::vector<std::pair<std::string, baker::Mesh>>& solids) {
    std::ostringstream text;
    text.precision(9);
    for (const auto& [name, mesh] : solids) {
        text << "solid " << name << '\n';
        for (const baker::Face& f : mesh.faces) {
            text << "facet normal 0 0 0\nouter loop\n";
            for (const uint32_t i : f) text << "vertex " << triple(mesh.vertices[i], " ") << '\n';
            text << "endloop\nendfacet\n";
        }
        text << "endsolid " << name << '\n';
    }
    return text.str();
}

} // namespace lr::test
