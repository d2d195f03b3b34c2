#include "baker/card/delaunay.h"

#include <boost/polygon/voronoi.hpp>

#include <algorithm>

template <> struct boost::polygon::geometry_concept<lr::baker::GridPoint> { using type = point_concept; };

template <> struct boost::polygon::point_traits<lr::baker::GridPoint> {
    using coordinate_type = int32_t;
    static coordinate_type get(const lr::baker::GridPoint& p, orientation_2d axis) {
        return axis == HORIZONTAL ? p.x : p.y;
    }
};

namespace lr::baker {
namespace {

// Points on one circle share a Voronoi vertex. Cuts the ears of their polygon, starting at the smallest index.
void cut_ears(const std::vector<GridPoint>& points, std::vector<uint32_t>& polygon, std::vector<Face>& faces) {
    std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
    while (polygon.size() > 2) {
        std::size_t ear = 1;
        const auto corner = [&](std::size_t i) { return polygon[i % polygon.size()]; };
        while (ear < polygon.size() &&
               doubled_area(points[corner(ear - 1)], points[corner(ear)], points[corner(ear + 1)]) <= 0)
            ++ear;
        if (ear == polygon.size()) return;
        faces.push_back({corner(ear - 1), corner(ear), corner(ear + 1)});
        polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(ear));
    }
}
} // namespace

int64_t doubled_area(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
    return (int64_t{b.x} - a.x) * (int64_t{c.y} - a.y) - (int64_t{b.y} - a.y) * (int64_t{c.x} - a.x);
}

std::vector<Face> delaunay(const std::vector<GridPoint>& points) {
    boost::polygon::voronoi_diagram<double> diagram;
    boost::polygon::construct_voronoi(points.begin(), points.end(), &diagram);
    std::vector<Face> faces;
    faces.reserve(2 * points.size());
    std::vector<uint32_t> polygon;
    for (const auto& vertex : diagram.vertices()) {
        polygon.clear();
        const auto* const first = vertex.incident_edge();
        const auto* edge = first;
        do {
            polygon.push_back(static_cast<uint32_t>(edge->cell()->source_index()));
            edge = edge->rot_next();
        } while (edge != first);
        cut_ears(points, polygon, faces);
    }
    return faces;
}
} // namespace lr::baker
