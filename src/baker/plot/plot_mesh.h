// Draws a mesh: sorted from far to near, shaded, and coarsened to limit the file size.
#pragma once

#include "baker/mesh/mesh.h"
#include "baker/plot/svg.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <string>

namespace lr::baker {

// Parallel projection that maps the body's origin to `origin`.
struct PlotView {
    Eigen::Vector3d right, up; // orthonormal
    double scale = 1.0;        // px/m
    SvgPoint origin{};

    SvgPoint place(double along_right, double along_up) const {
        return {origin.x + scale * along_right, origin.y - scale * along_up};
    }
    SvgPoint at(const Eigen::Vector3d& p) const { return place(right.dot(p), up.dot(p)); }
};

class DrawnMesh {
public:
    explicit DrawnMesh(const Mesh& mesh);

    // CSS classes for draw(); needed once in a document.
    std::string style() const;
    void draw(Svg& svg, const PlotView& view) const;
    bool is_thinned() const { return thinned_; }

private:
    Mesh mesh_;
    bool closed_ = false, thinned_ = false;
};
} // namespace lr::baker
