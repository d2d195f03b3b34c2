#include "baker/aerodynamics/camber.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace lr::baker {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int steps = 128; // of the angle of Glauert's substitution

struct Angle {
    double cosine = 1.0, sine = 0.0;
    void turn_by(const Angle& a) {
        const double c = cosine * a.cosine - sine * a.sine;
        sine = sine * a.cosine + cosine * a.sine;
        cosine = c;
    }
};

// pi/(2 steps), by halving: without the C library's functions.
Angle half_step() {
    double c = -1.0;
    for (int n = 2 * steps; n > 1; n /= 2) c = std::sqrt(0.5 * (1.0 + c));
    return {c, std::sqrt((1.0 - c) * (1.0 + c))};
}

struct Section {
    std::vector<std::array<Vector2d, 2>> pieces; // (towards the trailing edge, along the normal)
    double leading = std::numeric_limits<double>::infinity(), trailing = -leading;
};

Section section_of(const Part& strip, const Vector3d& at, const Vector3d& chord, const Vector3d& normal) {
    Section out;
    const Vector3d span = normal.cross(chord);
    for (const Facet& f : strip) {
        std::array<Vector2d, 2> ends;
        std::size_t found = 0;
        for (std::size_t v = 0; v < 3 && found < 2; ++v) {
            const Vector3d p = f.at[v] - at, q = f.at[(v + 1) % 3] - at;
            const double a = span.dot(p), b = span.dot(q);
            if ((a > 0.0) == (b > 0.0)) continue;
            const Vector3d r = p + a / (a - b) * (q - p);
            ends[found++] = {-chord.dot(r), normal.dot(r)};
        }
        if (found < 2) continue;
        if (ends[1].x() < ends[0].x()) std::swap(ends[0], ends[1]);
        out.pieces.push_back(ends);
        out.leading = std::min(out.leading, ends[0].x());
        out.trailing = std::max(out.trailing, ends[1].x());
    }
    return out;
}

// Mean height of all layers at x; false in a gap.
bool height_at(const Section& section, double x, double& height) {
    double sum = 0.0;
    std::size_t layers = 0;
    for (const auto& [a, b] : section.pieces) {
        if (!(a.x() <= x && x < b.x())) continue;
        sum += a.y() + (x - a.x()) / (b.x() - a.x()) * (b.y() - a.y());
        ++layers;
    }
    if (layers) height = sum / static_cast<double>(layers);
    return layers > 0;
}
} // namespace

double camber_of(const Part& strip, const Vector3d& at, const Vector3d& chord, const Vector3d& normal) {
    const Section section = section_of(strip, at, chord, normal);
    const double length = section.trailing - section.leading;
    if (!(length > 0.0)) return 0.0;
    // x = leading + length (1 - cos t)/2. Heights are at odd half steps, slopes and weights between them; the first and last slope also cover the
    // ends.
    const Angle half = half_step();
    Angle t = half;
    double before = 0.0, x_before = 0.0, sum = 0.0; // sum: of slope times (cos t - 1)
    bool begun = false;
    for (int i = 0; i < steps; ++i) {
        const double x = section.leading + 0.5 * length * (1.0 - t.cosine);
        double height = before;
        if (height_at(section, x, height)) {
            if (begun) {
                Angle middle = t;
                middle.turn_by({half.cosine, -half.sine});
                const double slope = (height - before) / (x - x_before);
                const double weight = i == 1 || i + 1 == steps ? 1.5 : 1.0;
                sum += weight * slope * (middle.cosine - 1.0);
            }
            begun = true;
            before = height;
            x_before = x;
        }
        t.turn_by(half);
        t.turn_by(half);
    }
    return sum / steps;
}
} // namespace lr::baker
