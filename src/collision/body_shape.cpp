#include "collision/body_shape.h"

#include "collision/build_collider_geometry.h"
#include "collision/local_pair.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace lr {
namespace {

using Points = std::vector<shape::HullPoint>;

// Tolerance of the reduced hull: dropped vertices outside it, as shares of the largest extent and of the width (else long bodies would lean).
constexpr double fine = 0.01, fine_width = 0.05;
// A body becomes a plate if it is thinner than `thin` of its largest extent and fills `plate` of the plate around it, or is thinner than `very_thin`.
constexpr double thin = 0.05, very_thin = 0.01, plate = 0.75;
constexpr double wide = 4.0;          // times as wide as thick: else the rounding is too large
constexpr uint32_t most_outline = 24; // points of a plate: each costs time in each contact
constexpr double full_box = 0.9;      // a body that fills this share of its extents' box is a box
// A body becomes an ellipsoid if it has more corners than a hull keeps, all near the ellipsoid's surface, fills it, and is not flat.
constexpr double round_surface = 0.03, round_volume = 0.8, round_width = 0.35;

Points corners_of(const Points& all, const shape::ConvexHull& hull) {
    Points points;
    for (const uint32_t i : hull.points) points.push_back(all[i]);
    return points;
}

void set_bounds(BodyShape& shape) {
    float most = 0.0f;
    Vector& extent = shape.extent;
    for (uint32_t i = 0; i < shape.count; ++i) {
        const Vector p = shape.point(i);
        most = std::max(most, length(p));
        extent = high_of(extent, high_of(p, -p));
    }
    extent = extent + Vector{shape.radius, shape.radius, shape.radius};
    shape.reach = (most + shape.radius) * (1.0f + 1e-6f); // margin for the rounding of rotated points
}

void set_points(BodyShape& shape, const Points& points) {
    shape.count = static_cast<uint32_t>(points.size());
    Double3 middle{0.0, 0.0, 0.0};
    for (uint32_t i = 0; i < shape.count; ++i) {
        shape.x[i] = static_cast<float>(points[i][0]);
        shape.y[i] = static_cast<float>(points[i][1]);
        shape.z[i] = static_cast<float>(points[i][2]);
        middle = middle + 1.0 / static_cast<double>(shape.count) * of(points[i]);
    }
    shape.center = to_float(middle);
}

void add_face(BodyShape& shape, Double3 normal, double offset, const std::vector<uint32_t>& corners) {
    const size_t used = shape.face_count == 0
                            ? 0
                            : size_t{shape.faces[shape.face_count - 1].first} + shape.faces[shape.face_count - 1].count;
    if (shape.face_count == most_shape_faces || corners.size() < 3 || used + corners.size() > most_shape_corners)
        return;
    ShapeFace& face = shape.faces[shape.face_count++];
    face.normal = to_float(normal);
    face.offset = static_cast<float>(offset);
    face.first = static_cast<uint8_t>(used);
    face.count = static_cast<uint8_t>(corners.size());
    for (size_t i = 0; i < corners.size(); ++i) shape.corners[used + i] = static_cast<uint8_t>(corners[i]);
}
} // namespace

void drop_corners(const Points& points, std::vector<uint32_t>& corners, double enough, size_t most) {
    for (bool dropped = true; dropped || corners.size() > most;) {
        if (!dropped) enough *= 1.2;
        dropped = false;
        std::vector<uint32_t> left;
        const size_t count = corners.size();
        bool last_stays = true; // dropping two neighbours in one pass could exceed the tolerance
        for (size_t i = 0; i < count; ++i) {
            const Double3 before = of(points[corners[(i + count - 1) % count]]);
            const Double3 side = of(points[corners[(i + 1) % count]]) - before;
            const double out = length(cross(of(points[corners[i]]) - before, side));
            last_stays = !last_stays || !(out <= enough * length(side)) || left.size() + count - i <= 3;
            if (last_stays) left.push_back(corners[i]);
            dropped = dropped || !last_stays;
        }
        corners = left;
    }
}

bool set_hull(BodyShape& shape, const Points& all) {
    shape::ConvexHull hull;
    if (shape::convex_hull(all, hull) != shape::HullOutcome::done || hull.flat) return false;
    set_points(shape, corners_of(all, hull));
    shape.radius = 0.0f;
    double thickness = std::numeric_limits<double>::infinity();
    for (const HullFace& face : hull_faces(all, hull)) {
        thickness = std::min(thickness, face.width);
        add_face(shape, face.normal, face.offset, face.corners);
    }
    shape.thickness = static_cast<float>(thickness);
    set_bounds(shape);
    return true;
}

void set_outline(BodyShape& shape, const Points& corners, Double3 normal, double radius) {
    set_points(shape, corners);
    shape.radius = static_cast<float>(radius);
    shape.thickness = 2.0f * shape.radius;
    std::vector<uint32_t> places(corners.size());
    std::iota(places.begin(), places.end(), 0u);
    add_face(shape, normal, dot(normal, of(corners[0])), places);
    std::reverse(places.begin(), places.end());
    add_face(shape, -normal, -dot(normal, of(corners[0])), places);
    set_bounds(shape);
}

namespace {

// Picks at most `most` points, repeatedly the one farthest outside the hull so far, until the rest lie within the tolerance. width: the least width.
Points reduced(const Points& from, double extent, double width, uint32_t most) {
    const double enough = std::min(fine * extent, fine_width * width);
    Points kept;
    std::vector<char> used(from.size(), 0);
    const auto take = [&](const auto& measure) {
        size_t best = from.size();
        double far = -1.0;
        for (size_t i = 0; i < from.size(); ++i) {
            if (used[i]) continue;
            const double value = measure(of(from[i]));
            if (!(value > far)) continue;
            far = value;
            best = i;
        }
        if (best == from.size()) return -1.0;
        used[best] = 1;
        kept.push_back(from[best]);
        return far;
    };
    take([&](Double3 p) { return length(p - of(from[0])); });
    take([&](Double3 p) { return length(p - of(kept[0])); });
    take([&](Double3 p) { return length(cross(p - of(kept[0]), of(kept[1]) - of(kept[0]))); });
    const Double3 normal = cross(of(kept[1]) - of(kept[0]), of(kept[2]) - of(kept[0]));
    take([&](Double3 p) { return std::abs(dot(normal, p - of(kept[0]))); });
    while (kept.size() < most) {
        shape::ConvexHull hull;
        if (shape::convex_hull(kept, hull) != shape::HullOutcome::done) break;
        std::vector<HullFace> faces;
        if (!hull.flat) faces = hull_faces(kept, hull);
        const auto outside = [&](Double3 p) {
            double far = 0.0;
            for (const HullFace& face : faces) far = std::max(far, dot(face.normal, p) - face.offset);
            return far;
        };
        const size_t before = kept.size();
        const double far = take(outside);
        if (far <= enough) {
            kept.resize(before);
            break;
        }
    }
    return kept;
}

double hull_volume(const Points& points, const shape::ConvexHull& hull) {
    double sum = 0.0;
    const Double3 origin = of(points[hull.points[0]]);
    for (const auto& t : hull.triangles) {
        const Double3 a = of(points[hull.points[t[0]]]) - origin, b = of(points[hull.points[t[1]]]) - origin;
        sum += dot(a, cross(b, of(points[hull.points[t[2]]]) - origin)) / 6.0;
    }
    return sum;
}

// The outline in the middle plane, drawn in by half the thickness and rounded by as much.
bool set_plate(BodyShape& shape, const Points& points, double extent, Double3 normal, double middle, double thickness,
               double volume) {
    Points projected;
    for (const auto& p : points) {
        const Double3 q = of(p) - (dot(normal, of(p)) - middle) * normal;
        projected.push_back({q.x, q.y, q.z});
    }
    // Rounding leaves projected points slightly off their plane; the hull's grid ignores that.
    shape::ConvexHull hull;
    if (shape::convex_hull(projected, hull) != shape::HullOutcome::done || !hull.flat) return false;
    double area = 0.0;
    for (size_t t = 0; t < hull.triangles.size(); t += 2) {
        const Double3 a = of(projected[hull.points[hull.triangles[t][0]]]);
        const Double3 b = of(projected[hull.points[hull.triangles[t][1]]]) - a;
        area += 0.5 * length(cross(b, of(projected[hull.points[hull.triangles[t][2]]]) - a));
    }
    if (thickness > very_thin * extent && volume < plate * area * thickness) return false;
    if (area < wide * extent * thickness) return false;
    const Points outline = corners_of(projected, hull);
    std::vector<uint32_t> corners(outline.size());
    std::iota(corners.begin(), corners.end(), 0u);
    put_in_turn(outline, normal, corners);
    drop_corners(outline, corners, std::min(fine * extent, fine_width * area / extent), most_outline);
    Double3 center{0.0, 0.0, 0.0};
    for (const uint32_t i : corners) center = center + 1.0 / static_cast<double>(corners.size()) * of(outline[i]);
    Points kept;
    for (const uint32_t i : corners) {
        const Double3 from = of(outline[i]) - center;
        const double size = length(from);
        const Double3 in = center + (size > thickness ? 1.0 - 0.5 * thickness / size : 0.5) * from;
        kept.push_back({in.x, in.y, in.z});
    }
    set_outline(shape, kept, normal, 0.5 * thickness);
    return true;
}

void set_ellipsoid(BodyShape& shape, const std::array<double, 3>& center, const std::array<double, 3>& semi) {
    shape.count = 0;
    shape.radius = 0.0f;
    shape.center = to_float(of(center));
    shape.semi_axes = to_float(of(semi));
    shape.extent =
        Vector{std::abs(shape.center.x), std::abs(shape.center.y), std::abs(shape.center.z)} + shape.semi_axes;
    shape.reach = static_cast<float>((length(of(center)) + std::max({semi[0], semi[1], semi[2]})) * (1.0 + 1e-6));
    shape.thickness = static_cast<float>(2.0 * std::min({semi[0], semi[1], semi[2]}));
}

// Semi-axes of the uniform ellipsoid with the asset's inertia, if there is one.
std::array<double, 3> inertia_axes(const AssetData& asset) {
    std::array<double, 3> semi{};
    const double sum = asset.inertia[0] + asset.inertia[4] + asset.inertia[8];
    for (size_t i = 0; i < 3; ++i) {
        const double square = 2.5 / asset.mass * (sum - 2.0 * asset.inertia[i * 4]);
        semi[i] = std::sqrt(std::max(square, 1e-8 * sum / asset.mass));
    }
    return semi;
}

// Whether the asset is a closed-form solid ellipsoid, by its numbers and its hull of 42 points.
bool is_ellipsoid(const AssetData& asset, const std::array<double, 3>& semi) {
    if (asset.provenance.source != "ellipsoid" || asset.hull.vertices.size() != size_t{3} * 42) return false;
    const double volume = 4.0 / 3.0 * std::numbers::pi * semi[0] * semi[1] * semi[2];
    if (std::abs(volume - asset.volume) > 1e-3 * asset.volume) return false;
    for (size_t i = 0; i < asset.hull.vertices.size(); i += 3) {
        double depth = 0.0; // 1 on the surface
        for (size_t k = 0; k < 3; ++k) {
            const double p = (static_cast<double>(asset.hull.vertices[i + k]) - asset.center_of_buoyancy[k]) / semi[k];
            depth += p * p;
        }
        if (std::abs(depth - 1.0) > 1e-2) return false;
    }
    return true;
}

// Round bodies become ellipsoids: with the corners that a hull keeps, a ball would sink in by an eighth of its radius.
bool set_round(BodyShape& shape, const Points& points, const std::array<double, 3>& middle, double volume) {
    if (points.size() <= most_shape_points) return false;
    std::array<double, 3> semi{};
    for (const auto& p : points)
        for (size_t k = 0; k < 3; ++k) semi[k] = std::max(semi[k], std::abs(p[k] - middle[k]));
    const auto [least, most] = std::minmax_element(semi.begin(), semi.end());
    if (*least < round_width * *most) return false;
    if (volume < round_volume * 4.0 / 3.0 * std::numbers::pi * semi[0] * semi[1] * semi[2]) return false;
    for (const auto& p : points) {
        double square = 0.0;
        for (size_t k = 0; k < 3; ++k) square += (p[k] - middle[k]) * (p[k] - middle[k]) / (semi[k] * semi[k]);
        if (std::abs(std::sqrt(square) - 1.0) > round_surface) return false;
    }
    set_ellipsoid(shape, middle, semi);
    return true;
}

bool set_from_hull(BodyShape& shape, const AssetData& asset) {
    Points all;
    for (size_t i = 0; i + 2 < asset.hull.vertices.size(); i += 3) {
        const float* v = asset.hull.vertices.data() + i;
        all.push_back({static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])});
    }
    shape::ConvexHull hull;
    if (shape::convex_hull(all, hull) != shape::HullOutcome::done) return false;
    const Points points = corners_of(all, hull);
    const double extent = extent_of(points);
    if (hull.flat) {
        const auto& t = hull.triangles[0];
        const Double3 a = of(points[t[0]]);
        const Double3 across = cross(of(points[t[1]]) - a, of(points[t[2]]) - a);
        const double size = length(across);
        if (!(size > 0.0)) return false;
        const Double3 normal = 1.0 / size * across;
        return set_plate(shape, points, extent, normal, dot(normal, a), 1e-3 * extent, 0.0);
    }
    const double volume = hull_volume(all, hull);
    if (set_round(shape, points, asset.center_of_buoyancy, volume)) return true;
    const std::vector<HullFace> faces = hull_faces(all, hull);
    const HullFace& face = *std::min_element(faces.begin(), faces.end(),
                                             [](const HullFace& a, const HullFace& b) { return a.width < b.width; });
    const double thickness = face.width, middle = face.offset - 0.5 * thickness;
    if (thickness < thin * extent && set_plate(shape, points, extent, face.normal, middle, thickness, volume))
        return true;
    shape = {};
    return set_hull(shape, reduced(points, extent, thickness, most_shape_points));
}

Vector middle_of(const BodyShape& s, const ShapeFace& f) {
    Vector sum{0.0f, 0.0f, 0.0f};
    for (uint32_t k = 0; k < f.count; ++k) sum = sum + s.corner(f, k);
    return 1.0f / static_cast<float>(f.count) * sum;
}

void add_samples(BodyShape& s) {
    s.sample_count = s.count;
    const auto add = [&](Vector p) {
        if (s.sample_count == most_shape_samples) return;
        s.x[s.sample_count] = p.x, s.y[s.sample_count] = p.y, s.z[s.sample_count] = p.z;
        ++s.sample_count;
    };
    // Faces by size; those of a flat body are equal.
    uint32_t order[most_shape_faces];
    float area[most_shape_faces];
    Vector middle[most_shape_faces];
    const bool flat = s.face_count == 2;
    const uint32_t faces = flat ? 1 : s.face_count;
    float total = 0.0f;
    for (uint32_t f = 0; f < faces; ++f) {
        order[f] = f;
        area[f] = length(s.doubled_area(s.faces[f]));
        middle[f] = middle_of(s, s.faces[f]);
        total += area[f];
    }
    std::sort(order, order + faces,
              [&](uint32_t a, uint32_t b) { return area[a] > area[b] || (area[a] == area[b] && a < b); });
    for (uint32_t k = 0; k < faces && s.sample_count < most_shape_samples; ++k) {
        const uint32_t f = order[k];
        if (area[f] < 0.05f * total) break;
        add(middle[f]);
        // Points half-way to some of its corners.
        const ShapeFace& face = s.faces[f];
        const uint32_t corners = face.count, stride = (corners + 7) / 8;
        for (uint32_t c = 0; c < corners; c += stride) add(0.5f * (middle[f] + s.corner(face, c)));
    }
}

BodyShape shape_of(const AssetData& asset, const std::array<double, 3>& extents) {
    BodyShape shape{};
    const std::array<double, 3>& middle = asset.center_of_buoyancy;
    std::array<double, 3> semi = inertia_axes(asset);
    if (!is_ellipsoid(asset, semi) && asset.hull.vertices.size() >= 12 && set_from_hull(shape, asset)) return shape;
    shape = {};
    const double box = extents[0] * extents[1] * extents[2];
    if (box > 0.0) {
        semi = {0.5 * extents[0], 0.5 * extents[1], 0.5 * extents[2]};
        if (asset.volume > full_box * box) {
            AssetData corners;
            for (uint32_t i = 0; i < 8; ++i)
                for (uint32_t k = 0; k < 3; ++k)
                    corners.hull.vertices.push_back(
                        static_cast<float>(middle[k] + ((i >> k & 1u) != 0 ? semi[k] : -semi[k])));
            if (set_from_hull(shape, corners)) return shape;
            shape = {};
        }
    }
    set_ellipsoid(shape, middle, semi);
    return shape;
}
} // namespace

BodyShape make_body_shape(const AssetData& asset, const std::array<double, 3>& extents) {
    BodyShape shape = shape_of(asset, extents);
    add_samples(shape);
    return shape;
}
} // namespace lr
