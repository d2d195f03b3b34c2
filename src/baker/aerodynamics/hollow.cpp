#include "baker/aerodynamics/hollow.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>

namespace lr::baker {
namespace {

using Eigen::Vector3d;

constexpr double cells_along = 12.0; // along the size of the body
// Fitted to the drag of cones and of half a sphere. shallow: a cap with a rise of a tenth of its diameter counts as flat.
constexpr double share_caught = 1.56, shallow = 0.06, most_caught = 0.7, least_parallel = 0.3;
// Walls of a bowl have no leading edge: at this hollow the squared sine of the stall angle is halved.
constexpr double early_stall = 0.12;
// A flat bottom counts as a plate; a wall that leans by 40 degrees belongs wholly to the bowl.
constexpr double leaning = 2.5;

struct Cell {
    Vector3d first = Vector3d::Zero(); // of the area
    double area = 0.0;
};

// Area of the surface in cells of a grid, a few hundred for any mesh.
std::vector<Cell> cells_of(const Part& faces, double step) {
    std::map<std::tuple<int64_t, int64_t, int64_t>, Cell> found;
    for (const Facet& f : faces) {
        const Vector3d at = f.middle();
        const auto index = [&](Eigen::Index k) { return static_cast<int64_t>(std::floor(at[k] / step)); };
        Cell& cell = found[{index(0), index(1), index(2)}];
        cell.first += f.area * at;
        cell.area += f.area;
    }
    std::vector<Cell> out;
    for (const auto& [index, cell] : found) out.push_back({cell.first / cell.area, cell.area});
    return out;
}
} // namespace

Vector3d hollow_of(const Part& part, double size) {
    const Part faces = refined(part, size / cells_along);
    const std::vector<Cell> places = cells_of(faces, size / cells_along);
    Vector3d sum = Vector3d::Zero(), convex = Vector3d::Zero();
    double area = 0.0;
    for (const Facet& f : faces) {
        const Vector3d at = f.middle();
        double above = 0.0; // on the side of the normal
        for (const Cell& c : places) {
            const Vector3d to = c.first - at;
            const double square = to.squaredNorm(), height = f.normal.dot(to);
            if (square > 0.0) above += c.area * height * std::abs(height) / square;
        }
        sum -= f.area * above * f.normal;
        convex -= f.area * (above > 0.0 ? 1.0 : -1.0) * f.normal;
        area += f.area;
    }
    const double parallel = convex.norm() / area, length = sum.norm() / (area * area);
    if (!(length > 0.0)) return Vector3d::Zero();
    const double x = std::max(share_caught * length / std::max(parallel, least_parallel) - shallow, 0.0);
    return std::min(x + 0.6 * x * x, most_caught) / sum.norm() * sum;
}

void shape_as_wall(const Part& part, const Vector3d& hollow, StationData& out) {
    double area = 0.0, open = 0.0;
    for (const Facet& f : part) {
        area += f.area;
        open += f.area * f.open;
    }
    const double size = hollow.norm(), shown = area > 0.0 ? open / area : 1.0, bowl = size / early_stall;
    for (std::size_t k = 0; k < 2; ++k) {
        out.plate_lift[k] *= shown;
        out.plate_vortex[k] *= shown;
        out.plate_stall[k] /= 1.0 + bowl * bowl;
    }
    out.plate_drag *= shown;
    if (!(size > 0.0)) return;
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> axes(out.axes.data());
    const Vector3d along = axes * hollow;
    const double cosine = along.z() / size, part_of_it = std::min(leaning * (1.0 - cosine * cosine), 1.0);
    for (std::size_t k = 0; k < 3; ++k) out.hollow[k] = part_of_it * along[static_cast<Eigen::Index>(k)];
}
} // namespace lr::baker
