#include "baker/aerodynamics/mesh_geometry.h"

#include "baker/aerodynamics/silhouette.h"
#include "baker/aerodynamics/surface_measures.h"
#include "baker/mesh/half_edges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace lr::baker {
namespace {

struct Skin {
    std::array<Eigen::Vector3d, 3> corners;
    double sides;
};

shape::SurfaceMeasures::Point to_point(const Eigen::Vector3d& v) {
    return {v[0], v[1], v[2]};
}

std::vector<Skin> faces_of(const Mesh& mesh, double sides) {
    std::vector<Skin> skin;
    skin.reserve(mesh.faces.size());
    for (const Face& f : mesh.faces)
        skin.push_back({{mesh.vertices[f[0]], mesh.vertices[f[1]], mesh.vertices[f[2]]}, sides});
    return skin;
}

// Adds side faces along free edges, as high as the thickness.
void add_rim(const Mesh& mesh, std::size_t solid_faces, double thickness, std::vector<Skin>& skin) {
    const std::vector<HalfEdge> halves = sorted_half_edges(mesh);
    for (std::size_t i = 0; i < halves.size();) {
        std::size_t end = i + 1;
        while (end < halves.size() && same_edge(halves[i], halves[end])) ++end;
        if (end - i == 1 && halves[i].face >= solid_faces) {
            const Face& f = mesh.faces[halves[i].face];
            const Eigen::Vector3d& a = mesh.vertices[f[0]];
            const Eigen::Vector3d normal = (mesh.vertices[f[1]] - a).cross(mesh.vertices[f[2]] - a).normalized();
            const Eigen::Vector3d half = 0.5 * thickness * normal;
            const Eigen::Vector3d &p = mesh.vertices[halves[i].low], &q = mesh.vertices[halves[i].high];
            skin.push_back({{p - half, q - half, q + half}, 1.0});
            skin.push_back({{p - half, q + half, p + half}, 1.0});
        }
        i = end;
    }
}

// Weight of an edge as a sharp one: none between faces that turn by 30 degrees, as on a coarse round body; one from 60 degrees on.
double sharpness(const Eigen::Vector3d& m, const Eigen::Vector3d& n) {
    constexpr double round = 0.8660254037844387, sharp = 0.5;
    return std::clamp((round - m.dot(n)) / (round - sharp), 0.0, 1.0);
}

// Sharp share of the rim seen along each axis, where the stream leaves the body.
std::array<double, 3> sharp_rims(const Mesh& mesh, const std::array<double, 9>& axes) {
    // 1 seen, -1 hidden. Faces nearly edge-on are in between, so that noise does not decide.
    const auto seen = [](double cosine) { return std::clamp(10.0 * cosine, -1.0, 1.0); };
    const auto normal = [&](std::size_t face) {
        const Face& f = mesh.faces[face];
        const Eigen::Vector3d& a = mesh.vertices[f[0]];
        return Eigen::Vector3d((mesh.vertices[f[1]] - a).cross(mesh.vertices[f[2]] - a).normalized());
    };
    std::array<double, 3> sharp{}, all{};
    const std::vector<HalfEdge> halves = sorted_half_edges(mesh);
    for (std::size_t i = 0; i + 1 < halves.size(); ++i) {
        if (!same_edge(halves[i], halves[i + 1])) continue;
        const Eigen::Vector3d m = normal(halves[i].face), n = normal(halves[i + 1].face),
                              along = mesh.vertices[halves[i].high] - mesh.vertices[halves[i].low];
        for (std::size_t k = 0; k < 3; ++k) {
            const Eigen::Vector3d axis(axes[3 * k], axes[3 * k + 1], axes[3 * k + 2]);
            const double length = std::abs(seen(axis.dot(m)) - seen(axis.dot(n))) * along.cross(axis).norm();
            all[k] += length;
            sharp[k] += sharpness(m, n) * length;
        }
    }
    for (std::size_t k = 0; k < 3; ++k) sharp[k] = all[k] > 0.0 ? sharp[k] / all[k] : 0.0;
    return sharp;
}

using Rows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

// Relative difference below which half of the projected surface replaces the union: it is exact if the body hides nothing, and the union is only as
// accurate as its lines.
constexpr double accuracy = 1e-5;

struct Seen {
    double area;              // of the union
    Eigen::Vector3d centroid; // relative to `centre`, along the axes; zero along the line of sight
};

Seen look(const std::vector<Skin>& skin, const Rows& axes, const Eigen::Vector3d& centre, Eigen::Index k) {
    const Eigen::Index i = (k + 1) % 3, j = (k + 2) % 3;
    std::vector<FlatTriangle> flat;
    flat.reserve(skin.size());
    double area = 0.0;
    Eigen::Vector2d moment = Eigen::Vector2d::Zero();
    for (const Skin& s : skin) {
        FlatTriangle t;
        for (std::size_t v = 0; v < 3; ++v) t[v] = {axes.row(i).dot(s.corners[v]), axes.row(j).dot(s.corners[v])};
        const Eigen::Vector2d a = t[1] - t[0], b = t[2] - t[0];
        const double projected = 0.25 * s.sides * std::abs(a.x() * b.y() - a.y() * b.x());
        area += projected;
        moment += projected / 3.0 * (t[0] + t[1] + t[2]);
        flat.push_back(t);
    }
    const Silhouette whole = union_silhouette(std::move(flat));
    const auto placed = [&](const Eigen::Vector2d& at) {
        Eigen::Vector3d out = Eigen::Vector3d::Zero();
        out[i] = at.x() - axes.row(i).dot(centre);
        out[j] = at.y() - axes.row(j).dot(centre);
        return out;
    };
    const bool hides = whole.area < (1.0 - accuracy) * area || !(area > 0.0);
    return {whole.area, placed(hides ? whole.centroid : moment / area)};
}

// Stream loads act at the centroid of the silhouette: across the largest silhouette at its centroid, along its normal at the centroid of the next
// largest. Offsets from the centre of buoyancy within the noise of a mesh are zeroed, or a symmetric body would lose the kernel's fast path. If one
// component exceeds the noise, the others stay too: a plane turns by the difference of its sides.
Eigen::Vector3d centre_of_loads(const std::array<Seen, 3>& seen, double size) {
    constexpr double noise = 5e-4, rounding = 1e-6;
    std::array<Eigen::Index, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
        return seen[static_cast<std::size_t>(a)].area > seen[static_cast<std::size_t>(b)].area;
    });
    Eigen::Vector3d out = seen[static_cast<std::size_t>(order[0])].centroid;
    out[order[0]] = seen[static_cast<std::size_t>(order[1])].centroid[order[0]];
    const double least = (out.cwiseAbs().maxCoeff() <= noise * size ? noise : rounding) * size;
    for (double& x : out)
        if (std::abs(x) <= least) x = 0.0;
    return out;
}

shape::AerodynamicGeometry measure(const std::vector<Skin>& skin, double size, const std::array<double, 9>& axes,
                                   const Eigen::Vector3d& buoyancy) {
    const Rows rows = Eigen::Map<const Rows>(axes.data());
    const std::array<Seen, 3> seen{look(skin, rows, buoyancy, 0), look(skin, rows, buoyancy, 1),
                                   look(skin, rows, buoyancy, 2)};
    const Eigen::Vector3d offset = centre_of_loads(seen, size), center = rows.transpose() * offset;
    shape::SurfaceMeasures measures(axes, to_point(buoyancy + center), size);
    for (const Skin& s : skin)
        measures.add(to_point(s.corners[0]), to_point(s.corners[1]), to_point(s.corners[2]), s.sides);
    shape::AerodynamicGeometry g = measures.geometry();
    g.center = to_point(center);
    for (std::size_t k = 0; k < 3; ++k)
        if (seen[k].area < (1.0 - accuracy) * g.area[k]) g.area[k] = seen[k].area;
    return g;
}
} // namespace

shape::AerodynamicGeometry mesh_geometry(const Mesh& mesh, const std::array<double, 9>& axes,
                                         const Eigen::Vector3d& centre) {
    shape::AerodynamicGeometry g = measure(faces_of(mesh, 1.0), box_sides(mesh).maxCoeff(), axes, centre);
    g.edges = sharp_rims(mesh, axes);
    return g;
}

shape::AerodynamicGeometry sheet_geometry(const Mesh& mesh, double thickness, const std::array<double, 9>& axes,
                                          const Eigen::Vector3d& centre, std::size_t solid_faces) {
    std::vector<Skin> skin = faces_of(mesh, 2.0);
    for (std::size_t i = 0; i < solid_faces; ++i) skin[i].sides = 1.0;
    add_rim(mesh, solid_faces, thickness, skin);
    return measure(skin, box_sides(mesh).maxCoeff(), axes, centre);
}
} // namespace lr::baker
