#include "baker/turbulence/stream_body.h"

#include "baker/turbulence/voxelise.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lr::baker {
namespace {

constexpr double margin = 1.5; // ahead and behind, in w
constexpr double across = 4.0; // sides of the cross section, in the body's extents
// A narrower body gets the cross section of this width, or cells would become needles.
constexpr double narrowest = 0.1;
} // namespace

bool put_in_stream(const Mesh& mesh, const Eigen::Matrix3d& axes, const Eigen::Vector3d& projected_areas,
                   TurbulenceOptions& options, Faults& faults) {
    const auto fail = [&](FaultId id, const char* where, const char* what, const char* remedy) {
        faults.push_back({id, Severity::error, where, what, remedy});
        return false;
    };
    Eigen::Index broad = 0;
    projected_areas.maxCoeff(&broad);
    Eigen::Index along_y = (broad + 1) % 3, along_z = (broad + 2) % 3;
    const auto extent = [&](Eigen::Index axis, double& low) {
        low = 1e300;
        double high = -1e300;
        for (const Eigen::Vector3d& v : mesh.vertices) {
            const double x = axes.col(axis).dot(v);
            low = std::min(low, x);
            high = std::max(high, x);
        }
        return high - low;
    };
    for (const Eigen::Vector3d& v : mesh.vertices)
        if (!v.allFinite() || !axes.allFinite())
            return fail(FaultId::mesh_not_finite, "wake", "A position is NaN or infinite.",
                        "Correct or delete the vertex.");
    double ignored = 0.0;
    if (extent(along_z, ignored) > extent(along_y, ignored)) std::swap(along_y, along_z);
    const Eigen::Index order[3] = {broad, along_y, along_z};
    Eigen::Vector3d low, size;
    for (Eigen::Index a = 0; a < 3; ++a) size[a] = extent(order[a], low[a]);

    if (!(size[1] > 0.0))
        return fail(FaultId::parameter_out_of_range, "wake", "The body has no extent across the stream.",
                    "Check the mesh, or leave out --wake.");
    const double d = options.length_d;
    const double width = std::max(std::sqrt(size[1] * size[2]), narrowest * d);
    GridPoint lengths = {size[0] + d + 2.0 * margin * width, across * size[1],
                         across * size[2] * std::ceil(size[1] / (16.0 * size[2]))};
    if (!(size[2] > 1e-9 * size[1])) lengths[2] = 0.25 * size[1];
    // Whole cells along a thick body, if the grid has a multiple of 32 cells along the stream.
    const double whole = 2.0 * std::floor(0.5 * 32.0 * size[0] / lengths[0]);
    if (whole > 0.0) lengths[0] = 32.0 * size[0] / whole;
    for (size_t a = 0; a < 3; ++a) options.domain_lengths[a] = lengths[a] / d;
    const double cell = lengths[0] / options.cells[0];
    const double ahead = std::max(1.0, std::floor((margin * width + 0.5 * size[0]) / cell + 0.5)) * cell;
    const Eigen::Vector3d middle(ahead, 0.5 * lengths[1], 0.5 * lengths[2]);

    // At least two cells wide across the stream, or the body could lie between cell centres.
    Eigen::Vector3d stretch = Eigen::Vector3d::Ones();
    for (Eigen::Index a = 1; a < 3; ++a) {
        const auto axis = static_cast<size_t>(a);
        const double least = 2.01 * lengths[axis] / options.cells[axis];
        if (size[a] > 0.0 && size[a] < least) {
            stretch[a] = least / size[a];
            size[a] = least;
        }
    }
    Mesh turned;
    turned.faces = mesh.faces;
    turned.vertices.reserve(mesh.vertices.size());
    for (const Eigen::Vector3d& v : mesh.vertices) {
        Eigen::Vector3d p;
        for (Eigen::Index a = 0; a < 3; ++a)
            p[a] = stretch[a] * (axes.col(order[a]).dot(v) - low[a]) - 0.5 * size[a] + middle[a];
        turned.vertices.push_back(p);
    }
    options.closed_faces = voxelise(turned, options.cells, lengths);
    bool seen = false;
    for (const std::vector<uint8_t>& faces : options.closed_faces)
        seen = seen || std::any_of(faces.begin(), faces.end(), [](uint8_t face) { return face != 0; });
    if (!seen)
        return fail(FaultId::parameter_out_of_range, "grid", "The body is too small for the cells of the wake's grid.",
                    "Give more cells with --grid, or leave out --wake.");
    for (Eigen::Index a = 0; a < 3; ++a) {
        options.body_box[0][static_cast<size_t>(a)] = middle[a] - 0.5 * size[a];
        options.body_box[1][static_cast<size_t>(a)] = middle[a] + 0.5 * size[a];
    }
    return true;
}
} // namespace lr::baker
