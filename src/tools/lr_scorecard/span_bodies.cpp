#include "tools/lr_scorecard/span_bodies.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace lr::scorecard {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;
constexpr double degree = pi / 180.0;

uint32_t add_vertex(Triangles& mesh, double x, double y, double z) {
    mesh.positions.insert(mesh.positions.end(), {x, y, z});
    return static_cast<uint32_t>(mesh.positions.size() / 3 - 1);
}

void add_triangle(Triangles& mesh, uint32_t a, uint32_t b, uint32_t c) {
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

Vector3d corner(const Triangles& mesh, size_t i) {
    return Vector3d(&mesh.positions[size_t{3} * mesh.indices[i]]);
}

struct Solid {
    double volume = 0.0;
    Vector3d centroid = Vector3d::Zero();
};

Solid solid_of(const Triangles& mesh) {
    Solid s;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vector3d a = corner(mesh, i), b = corner(mesh, i + 1), c = corner(mesh, i + 2);
        const double volume = a.dot(b.cross(c)) / 6.0;
        s.volume += volume;
        s.centroid += volume * (a + b + c) / 4.0;
    }
    s.centroid /= s.volume;
    return s;
}

double area_of(const Triangles& mesh) {
    double area = 0.0;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vector3d a = corner(mesh, i);
        area += 0.5 * (corner(mesh, i + 1) - a).cross(corner(mesh, i + 2) - a).norm();
    }
    return area;
}

double smoothstep(double x) {
    x = std::clamp(x, 0.0, 1.0);
    return x * x * (3.0 - 2.0 * x);
}

// n steps from 0 to 1, finer at both ends.
double spaced(uint32_t i, uint32_t n) {
    return 0.5 - 0.5 * std::cos(pi * i / n);
}

// Chord of the wing over its widest: narrow at the root, widest at 0.62 of the span, round at the tip.
double planform(double part) {
    const double before = 0.45 + 0.55 * std::sin(0.5 * pi * std::min(part / 0.62, 1.0));
    return before * std::sqrt(std::max(0.0, 1.0 - std::pow(std::max(0.0, part - 0.62) / 0.38, 2.2)));
}

// Parts of a seed, m. Positions along x are from the centre of the nut.
struct SeedParts {
    double nut_length, nut_width, nut_thickness, nut_y, root, tip, widest;
    double membrane, rib; // thickness; at mid-span the rib along the leading edge adds `rib`

    double part(double x) const { return std::clamp((x - root) / (tip - root), 0.0, 1.0); }
    // y of leading and trailing edge.
    std::pair<double, double> edges(double x) const {
        const double end = 2.0 * x / nut_length, half = 0.5 * nut_width * std::sqrt(std::max(0.0, 1.0 - end * end));
        const double wing = smoothstep(x / root), chord = widest * planform(part(x)); // 0 along the nut alone
        const double nut_front = std::abs(end) < 1.0 ? nut_y - half : nut_y,
                     nut_back = std::abs(end) < 1.0 ? nut_y + half : 0.0;
        return {nut_front * (1.0 - wing), std::max(nut_back, chord * wing)};
    }
    double thickness(double x, double y, double across) const { // across: 0 at the leading edge, 1 at the trailing one
        const Vector2d place(2.0 * x / nut_length, 2.0 * (y - nut_y) / nut_width);
        const double nut = nut_thickness * std::sqrt(std::max(0.0, 1.0 - place.squaredNorm()));
        const double ribbed = rib * (1.5 - part(x)) * (1.0 - smoothstep((across - 0.06) / 0.10));
        return std::max(nut, membrane + ribbed);
    }
};

// Two pages over rows along x that share their rim.
Triangles seed_pages(const SeedParts& parts) {
    constexpr uint32_t rows = 44, columns = 14;
    Triangles mesh;
    const double low = -0.5 * parts.nut_length;
    std::array<std::vector<std::vector<uint32_t>>, 2> pages; // upper, lower; vertices by row and column
    for (uint32_t i = 0; i <= rows; ++i) {
        const double x = low + (parts.tip - low) * spaced(i, rows);
        const auto [front, back] = parts.edges(x);
        std::array<std::vector<uint32_t>, 2> row;
        if (i == 0 || i == rows) {
            const uint32_t end = add_vertex(mesh, x, i == 0 ? parts.nut_y : 0.5 * (front + back), 0.0);
            row[0] = row[1] = {end};
        } else
            for (uint32_t j = 0; j <= columns; ++j) {
                const double across = spaced(j, columns), y = front + (back - front) * across;
                const bool rim = j == 0 || j == columns;
                const double half = rim ? 0.0 : 0.5 * parts.thickness(x, y, across);
                row[0].push_back(add_vertex(mesh, x, y, half));
                row[1].push_back(rim ? row[0].back() : add_vertex(mesh, x, y, -half));
            }
        for (size_t k = 0; k < 2; ++k) pages[k].push_back(row[k]);
    }
    for (size_t k = 0; k < 2; ++k) {
        const auto face = [&](uint32_t a, uint32_t b, uint32_t c) {
            k == 0 ? add_triangle(mesh, a, b, c) : add_triangle(mesh, a, c, b);
        };
        for (uint32_t i = 0; i < rows; ++i) {
            const std::vector<uint32_t>&a = pages[k][i], &b = pages[k][i + 1];
            for (uint32_t j = 0; j < columns; ++j) {
                if (a.size() > 1) face(a[j], b.size() > 1 ? b[j] : b[0], a[j + 1]);
                if (b.size() > 1) face(a.size() > 1 ? a[j + 1] : a[0], b[j], b[j + 1]);
            }
        }
    }
    return mesh;
}

// Triangle in rows from the nose at the origin to a straight tail at x = -length. place: (part of the length, part of the width).
void add_wing(Triangles& mesh, uint32_t rows, const std::function<Vector3d(double, double)>& place) {
    std::vector<uint32_t> before, now;
    for (uint32_t i = 0; i <= rows; ++i, before = std::exchange(now, {})) {
        for (uint32_t j = 0; j <= i; ++j) {
            const Vector3d p = place(static_cast<double>(i) / rows, static_cast<double>(j) / rows);
            now.push_back(add_vertex(mesh, p.x(), p.y(), p.z()));
        }
        for (uint32_t j = 0; j < i; ++j) {
            add_triangle(mesh, before[j], now[j], now[j + 1]);
            if (j + 1 < i) add_triangle(mesh, before[j], now[j + 1], before[j + 1]);
        }
    }
}

constexpr double dart_length = 0.20, dart_half_span = 0.0525, dart_keel = 0.025, dart_mass = 0.005;

Triangles dart_surface(const DartShape& shape) {
    Triangles mesh;
    const double rise = 0.12, flap = std::tan(shape.flap * degree);
    for (const double hand : {1.0, -1.0})
        add_wing(mesh, 10, [&](double along, double across) {
            const double y = dart_half_span * across, back = dart_length * along;
            double z = rise * y + flap * std::max(0.0, back - 0.9 * dart_length);
            if (hand > 0.0) // turns about mid-chord; the root stays in place
                z -= std::tan(shape.twist * degree) * std::min(1.0, across / 0.1) *
                     (back - 0.5 * dart_length * (1.0 + across));
            return Vector3d(-back, hand * y, z);
        });
    add_wing(mesh, 10,
             [](double along, double down) { return Vector3d(-dart_length * along, 0.0, -dart_keel * down); });
    return mesh;
}

Triangles bent(Triangles mesh, const std::function<double(double, double)>& height) {
    for (size_t i = 0; i < mesh.positions.size(); i += 3)
        mesh.positions[i + 2] = height(mesh.positions[i], mesh.positions[i + 1]);
    return mesh;
}
} // namespace

Seed seed_mesh(const SeedShape& shape) {
    constexpr double nut_share = 0.72, rib_share = 0.5; // of the mass; of the wing's mass
    const double scale = std::cbrt(shape.mass / 232e-6);
    SeedParts p{};
    p.nut_length = 0.008 * scale, p.nut_width = 0.006 * scale, p.nut_thickness = 0.004 * scale;
    p.root = 0.35 * p.nut_length;
    p.tip = shape.radius + p.nut_length;
    double mean = 0.0;
    for (int i = 0; i < 400; ++i) mean += planform((i + 0.5) / 400.0) / 400.0;
    Seed seed;
    for (int round = 0; round < 12; ++round) { // until the tip is at the radius from the centre of mass
        const double span = p.tip - p.root, area = shape.chord * shape.radius * shape.radius,
                     nut = pi / 6.0 * p.nut_length * p.nut_width * p.nut_thickness,
                     wing = nut * (1.0 - nut_share) / nut_share;
        p.widest = area / (mean * span);
        p.nut_y = shape.nut_place * p.widest;
        p.membrane = (1.0 - rib_share) * wing / area;
        p.rib = rib_share * wing / (0.11 * area);
        seed.mesh = seed_pages(p);
        const Solid solid = solid_of(seed.mesh);
        seed.density = shape.mass / solid.volume;
        seed.widest = p.widest;
        p.tip = shape.radius + solid.centroid.x();
    }
    return seed;
}

Asset bake_seed(const Seed& seed) {
    langevin_rigid::BakeOptions options;
    options.unit = langevin_rigid::Unit::metre;
    options.density = seed.density;
    options.name = "winged seed";
    return load(seed.mesh.bake(options));
}

Asset bake_dart(const DartShape& shape) {
    const Triangles surface = dart_surface(shape);
    // More layers at the nose: n similar triangles of `size` move the centre of mass from 2/3 of the length to 2/3 (1 + n size^3)/(1 + n size^2).
    constexpr double layers = 6.0;
    const auto place = [](double size) {
        return 2.0 / 3.0 * (1.0 + layers * std::pow(size, 3.0)) / (1.0 + layers * size * size);
    };
    double low = 0.55, high = 1.0;
    if (shape.weight_place < place(low) || shape.weight_place > place(high)) throw std::runtime_error("no such dart");
    for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (low + high);
        (place(middle) < shape.weight_place ? low : high) = middle;
    }
    Triangles paper = surface, layer = dart_surface({shape.weight_place, 0.0, 0.0});
    for (double& x : layer.positions) x *= low;
    for (int i = 0; i < static_cast<int>(layers); ++i) {
        const auto first = static_cast<uint32_t>(paper.positions.size() / 3);
        paper.positions.insert(paper.positions.end(), layer.positions.begin(), layer.positions.end());
        for (uint32_t v : layer.indices) paper.indices.push_back(first + v);
    }
    langevin_rigid::BakeOptions options = sheet_options(1e-4, dart_mass / area_of(paper), Fluid{});
    options.mass = langevin_rigid::BakeMass{{}, std::move(paper.positions), std::move(paper.indices)};
    return load(surface.bake(options));
}

Asset bake_cap(double diameter, double rise, double areal_density) {
    const double height = rise * diameter,
                 sphere = height > 0.0 ? (0.25 * diameter * diameter + height * height) / (2.0 * height) : 0.0;
    const Triangles mesh = bent(disc_mesh(0.5 * diameter, 12), [&](double x, double y) {
        const double r2 = x * x + y * y; // (sphere - root) without cancellation
        return height > 0.0 ? r2 / (sphere + std::sqrt(sphere * sphere - r2)) : 0.0;
    });
    return load(mesh.bake(sheet_options(1e-4, areal_density, Fluid{})));
}

Asset bake_bowl(double diameter, double half_angle, double areal_density) {
    const double radius = 0.5 * diameter;
    Triangles mesh = disc_mesh(radius, 12);
    for (size_t i = 0; i < mesh.positions.size(); i += 3) {
        double *const at = &mesh.positions[i], r = std::hypot(at[0], at[1]);
        if (half_angle > 0.0) {
            at[2] = r / std::tan(half_angle * pi / 180.0);
            continue;
        }
        const double t = 0.5 * pi * r / radius, wider = r > 0.0 ? radius * std::sin(t) / r : 1.0;
        at[0] *= wider, at[1] *= wider, at[2] = radius * (1.0 - std::cos(t));
    }
    return load(mesh.bake(sheet_options(1e-4, areal_density, Fluid{})));
}

Asset bake_curled_leaf(double width, double length, double curl, double twist, double areal_density) {
    Triangles mesh = disc_mesh(0.5, 12);
    for (size_t i = 0; i < mesh.positions.size(); i += 3) {
        mesh.positions[i] *= width;
        mesh.positions[i + 1] *= length;
    }
    mesh = bent(std::move(mesh), [&](double x, double y) { return 0.5 * curl * x * x + twist * x * y; });
    return load(mesh.bake(sheet_options(1e-4, areal_density, Fluid{})));
}

Asset bake_ring(double diameter, double hole, double areal_density) {
    if (hole <= 0.0) return bake_disc(0.5 * diameter, 1e-4, areal_density, Fluid{});
    constexpr uint32_t around = 72;
    const uint32_t rings = hole < 0.6 ? 6 : 4;
    // Area of the circle, as in disc_mesh.
    const double step = 2.0 * pi / around, area = std::sqrt(step / std::sin(step));
    Triangles mesh;
    for (uint32_t i = 0; i <= rings; ++i)
        for (uint32_t j = 0; j < around; ++j) {
            const double r = 0.5 * diameter * area * (hole + (1.0 - hole) * spaced(i, rings)), angle = step * j;
            add_vertex(mesh, r * std::cos(angle), r * std::sin(angle), 0.0);
        }
    for (uint32_t i = 0; i < rings; ++i)
        for (uint32_t j = 0; j < around; ++j) {
            const uint32_t a = i * around + j, b = i * around + (j + 1) % around;
            add_triangle(mesh, a, a + around, b + around);
            add_triangle(mesh, a, b + around, b);
        }
    return load(mesh.bake(sheet_options(1e-4, areal_density, Fluid{})));
}

Asset bake_strip(double width, double length, double rise, double areal_density) {
    const Triangles mesh =
        bent(rectangle_mesh(width, length, 4, 40), [&](double, double y) { return 4.0 * rise * y * y / length; });
    return load(mesh.bake(sheet_options(1e-4, areal_density, Fluid{})));
}

Asset bake_cross(double length, double width, double areal_density) {
    constexpr uint32_t in_arm = 8, in_width = 4;
    std::vector<double> lines;
    const double arm = 0.5 * (length - width);
    for (uint32_t i = 0; i < in_arm; ++i) lines.push_back(-0.5 * length + arm * i / in_arm);
    for (uint32_t i = 0; i < in_width; ++i) lines.push_back(-0.5 * width + width * i / in_width);
    for (uint32_t i = 0; i <= in_arm; ++i) lines.push_back(0.5 * width + arm * i / in_arm);
    const auto in_bar = [](uint32_t i) { return i >= in_arm && i < in_arm + in_width; };
    Triangles mesh;
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> known;
    const auto vertex = [&](uint32_t i, uint32_t j) {
        const auto [at, fresh] = known.try_emplace({i, j}, 0);
        if (fresh) at->second = add_vertex(mesh, lines[i], lines[j], 0.0);
        return at->second;
    };
    for (uint32_t i = 0; i + 1 < lines.size(); ++i)
        for (uint32_t j = 0; j + 1 < lines.size(); ++j) {
            if (!in_bar(i) && !in_bar(j)) continue;
            const uint32_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
            add_triangle(mesh, a, b, c);
            add_triangle(mesh, a, c, d);
        }
    return load(mesh.bake(sheet_options(1e-4, areal_density, Fluid{})));
}

Asset bake_snow_crystal(double diameter) {
    // Cells of a triangular lattice. Rows along an arm are `row` high.
    constexpr int cells = 14; // in an arm
    const double cell = 0.5 * diameter / cells, row = 0.5 * std::sqrt(3.0) * cell;
    static constexpr std::array<std::pair<double, double>, 3> branches{
        {{5.0, 4.0}, {8.0, 3.0}, {11.0, 2.0}}}; // at, length
    const auto turned = [](const Vector2d& p, double angle) -> Vector2d { return Eigen::Rotation2Dd(-angle) * p; };
    const auto solid = [&](const Vector2d& p) {
        double outside = 0.0; // of the central hexagon
        for (int k = 0; k < 6; ++k) {
            Vector2d q = turned(p, k * pi / 3.0);
            outside = std::max(outside, std::abs(q.y()));
            q.y() = std::abs(q.y());
            if (q.x() > 0.0 && q.x() < cells * cell && q.y() < row) return true;
            for (const auto& [at, length] : branches) {
                const Vector2d b = turned(q - Vector2d(at * cell, 0.0), pi / 3.0);
                if (b.x() > 0.0 && b.x() < length * cell && b.y() > -row && b.y() < 0.0) return true;
            }
        }
        return outside < 3.0 * row;
    };
    Triangles mesh;
    std::map<std::pair<int, int>, uint32_t> known;
    const auto at = [&](int i, int j) { return Vector2d((i + 0.5 * j) * cell, j * row); };
    const auto vertex = [&](std::pair<int, int> ij) {
        const auto [found, fresh] = known.try_emplace(ij, 0);
        if (fresh) {
            const Vector2d p = at(ij.first, ij.second);
            found->second = add_vertex(mesh, p.x(), p.y(), 0.0);
        }
        return found->second;
    };
    for (int j = -cells; j < cells; ++j)
        for (int i = -2 * cells; i < 2 * cells; ++i)
            for (const bool upright : {true, false}) {
                const std::pair<int, int> a{upright ? i : i + 1, j}, b{upright ? i + 1 : i + 1, upright ? j : j + 1},
                    c{i, j + 1};
                if (!solid((at(a.first, a.second) + at(b.first, b.second) + at(c.first, c.second)) / 3.0)) continue;
                add_triangle(mesh, vertex(a), vertex(b), vertex(c));
            }
    constexpr double ice = 917.0;
    const double areal = 3.8e-3 * diameter * diameter / area_of(mesh);
    return load(mesh.bake(sheet_options(areal / ice, areal, cold_air)));
}
} // namespace lr::scorecard
