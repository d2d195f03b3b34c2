#include "baker/aerodynamics/mesh_geometry.h"

#include "baker/aerodynamics/silhouette.h"
#include "baker/mesh/half_edges.h"
#include "shape/surface_measures.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace lr::baker {
namespace {

struct Skin {
    std::array<Eigen::Vector3d, 3> corners;
    double sides;
};

double largest_extent(const Mesh& mesh) {
    Eigen::Vector3d low = mesh.vertices[mesh.faces[0][0]], high = low;
    for (const Face& f : mesh.faces)
        for (const uint32_t v : f) {
            low = low.cwiseMin(mesh.vertices[v]);
            high = high.cwiseMax(mesh.vertices[v]);
        }
    return (high - low).maxCoeff();
}

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

// Where a face ends the sheet does, with a cut as high as the sheet is thick.
void add_rim(const Mesh& mesh, double thickness, std::vector<Skin>& skin) {
    const std::vector<HalfEdge> halves = sorted_half_edges(mesh);
    for (std::size_t i = 0; i < halves.size();) {
        std::size_t end = i + 1;
        while (end < halves.size() && same_edge(halves[i], halves[end])) ++end;
        if (end - i == 1) {
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

double silhouette(const std::vector<Skin>& skin, const std::array<double, 9>& axes, std::size_t k) {
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> rows(axes.data());
    const auto i = static_cast<Eigen::Index>((k + 1) % 3), j = static_cast<Eigen::Index>((k + 2) % 3);
    std::vector<FlatTriangle> flat;
    flat.reserve(skin.size());
    for (const Skin& s : skin) {
        FlatTriangle t;
        for (std::size_t v = 0; v < 3; ++v) t[v] = {rows.row(i).dot(s.corners[v]), rows.row(j).dot(s.corners[v])};
        flat.push_back(t);
    }
    return union_area(std::move(flat));
}

shape::AerodynamicGeometry measure(const std::vector<Skin>& skin, double size, const std::array<double, 9>& axes,
                                   const Eigen::Vector3d& centre) {
    shape::SurfaceMeasures measures(axes, to_point(centre), size);
    for (const Skin& s : skin)
        measures.add(to_point(s.corners[0]), to_point(s.corners[1]), to_point(s.corners[2]), s.sides);
    shape::AerodynamicGeometry g = measures.geometry();
    // Where nothing is hidden, half of what the surface projects to is exact, and the union is as good as its lines.
    constexpr double accuracy = 1e-5;
    for (std::size_t k = 0; k < 3; ++k) {
        const double seen = silhouette(skin, axes, k);
        if (seen < (1.0 - accuracy) * g.area[k]) g.area[k] = seen;
    }
    return g;
}

} // namespace

shape::AerodynamicGeometry mesh_geometry(const Mesh& mesh, const std::array<double, 9>& axes,
                                         const Eigen::Vector3d& centre) {
    return measure(faces_of(mesh, 1.0), largest_extent(mesh), axes, centre);
}

shape::AerodynamicGeometry sheet_geometry(const Mesh& mesh, double thickness, const std::array<double, 9>& axes,
                                          const Eigen::Vector3d& centre) {
    std::vector<Skin> skin = faces_of(mesh, 2.0);
    add_rim(mesh, thickness, skin);
    return measure(skin, largest_extent(mesh), axes, centre);
}

} // namespace lr::baker
