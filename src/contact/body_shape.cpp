#include "contact/body_shape.h"

#include "contact/build_geometry.h"
#include "contact/placed.h"
#include "shape/convex_hull.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace lr {
namespace {

using Points = std::vector<shape::HullPoint>;

// How far outside what is kept a vertex may lie: of the largest extent, and of the width of what is long and narrow, which would sink
// in or lean by it.
constexpr double fine = 0.01, fine_width = 0.05;
// Of the largest extent: bodies thinner than this lose one of their two sides, if they are plates: if this part of the plate
// around them is filled, or if they are so thin that it does not show.
constexpr double thin = 0.05, very_thin = 0.01, plate = 0.75;
constexpr double wide = 4.0;          // times as wide as thick: the rounding of what is narrower would be much of it
constexpr uint32_t most_outline = 24; // of a plate: each costs in each contact
constexpr double full_box = 0.9;      // of the extents' box: a body with this volume is one
// More corners than are kept, all this near an ellipsoid's surface (of its size there), which the hull fills; and no flat one.
constexpr double round_surface = 0.03, round_volume = 0.8, round_width = 0.35;

Double3 of(const shape::HullPoint& p) {
    return {p[0], p[1], p[2]};
}

void set_bounds(BodyShape& shape) {
    float most = 0.0f;
    Vector& extent = shape.extent;
    for (uint32_t i = 0; i < shape.count; ++i) {
        const Vector p{shape.x[i], shape.y[i], shape.z[i]};
        most = std::max(most, length(p));
        extent = {std::max(extent.x, std::abs(p.x)), std::max(extent.y, std::abs(p.y)),
                  std::max(extent.z, std::abs(p.z))};
    }
    extent = extent + Vector{shape.radius, shape.radius, shape.radius};
    shape.reach = (most + shape.radius) * (1.0f + 1e-6f); // rounding of turned points
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

// Corners of a face, counter-clockwise around the normal.
void add_face(BodyShape& shape, const Points& points, Double3 normal, std::vector<uint32_t> corners) {
    const size_t used = shape.face_count == 0
                            ? 0
                            : size_t{shape.faces[shape.face_count - 1].first} + shape.faces[shape.face_count - 1].count;
    if (shape.face_count == most_shape_faces || corners.size() < 3 || used + corners.size() > most_shape_corners)
        return;
    Double3 middle{0.0, 0.0, 0.0};
    double offset = -std::numeric_limits<double>::infinity();
    for (const uint32_t i : corners) {
        middle = middle + 1.0 / static_cast<double>(corners.size()) * of(points[i]);
        offset = std::max(offset, dot(normal, of(points[i])));
    }
    const Double3 start = of(points[corners[0]]) - middle;
    // By halves of the turn from the first, then by the sense of rotation.
    const auto half = [&](Double3 a) {
        const double across = dot(normal, cross(start, a));
        return across > 0.0 || (across == 0.0 && dot(start, a) > 0.0) ? 0 : 1;
    };
    std::sort(corners.begin() + 1, corners.end(), [&](uint32_t i, uint32_t j) {
        const Double3 a = of(points[i]) - middle, b = of(points[j]) - middle;
        if (half(a) != half(b)) return half(a) < half(b);
        return dot(normal, cross(a, b)) > 0.0;
    });
    ShapeFace& face = shape.faces[shape.face_count++];
    face.normal = to_float(normal);
    face.offset = static_cast<float>(offset);
    face.first = static_cast<uint8_t>(used);
    face.count = static_cast<uint8_t>(corners.size());
    for (size_t i = 0; i < corners.size(); ++i) shape.corners[used + i] = static_cast<uint8_t>(corners[i]);
}

// A solid hull of these points. False: they have none.
bool set_hull(BodyShape& shape, const Points& all) {
    shape::ConvexHull hull;
    if (shape::convex_hull(all, hull) != shape::HullOutcome::done || hull.flat) return false;
    Points points;
    for (const uint32_t i : hull.points) points.push_back(all[i]);
    set_points(shape, points);
    shape.radius = 0.0f;
    double size = 0.0, thickness = std::numeric_limits<double>::infinity();
    for (const auto& p : points) size = std::max(size, length(of(p) - of(points[0])));
    for (const HullPlane& plane : hull_planes(all, hull)) {
        std::vector<uint32_t> corners;
        double least = plane.offset;
        for (uint32_t i = 0; i < points.size(); ++i) {
            const double along = dot(plane.normal, of(points[i]));
            least = std::min(least, along);
            if (plane.offset - along <= 4.0 * hull.slack + 2e-6 * size) corners.push_back(i);
        }
        thickness = std::min(thickness, plane.offset - least);
        add_face(shape, points, plane.normal, corners);
    }
    shape.thickness = static_cast<float>(thickness);
    set_bounds(shape);
    return true;
}

// Those of the points, at most `most`, whose hull leaves none of them farther outside than it may: always the one that is
// farthest outside. width: the least, of a flat body of its outline. across: of a flat body, its normal, or zero.
Points reduced(const Points& from, double extent, double width, Double3 across, uint32_t most) {
    const double enough = std::min(fine * extent, fine_width * width);
    const bool is_flat = length(across) > 0.0;
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
    if (!is_flat) {
        const Double3 normal = cross(of(kept[1]) - of(kept[0]), of(kept[2]) - of(kept[0]));
        take([&](Double3 p) { return std::abs(dot(normal, p - of(kept[0]))); });
    }
    while (kept.size() < most) {
        shape::ConvexHull hull;
        if (shape::convex_hull(kept, hull) != shape::HullOutcome::done) break;
        std::vector<HullPlane> planes;
        if (is_flat) {
            // Edges of one of the two sides, each as a plane across.
            for (size_t t = 0; t < hull.triangles.size(); t += 2)
                for (size_t k = 0; k < 3; ++k) {
                    const Double3 a = of(kept[hull.points[hull.triangles[t][k]]]);
                    const Double3 b = of(kept[hull.points[hull.triangles[t][(k + 1) % 3]]]);
                    Double3 out = cross(b - a, across);
                    const double size = length(out);
                    if (!(size > 0.0)) continue;
                    out = 1.0 / size * out;
                    double low = 0.0, high = 0.0;
                    for (const auto& p : kept) {
                        low = std::min(low, dot(out, of(p) - a));
                        high = std::max(high, dot(out, of(p) - a));
                    }
                    if (low < -1e-5 * extent && high > 1e-5 * extent) continue; // a diagonal
                    if (high > -low) out = -out;
                    planes.push_back({out, dot(out, a)});
                }
        } else if (!hull.flat) {
            planes = hull_planes(kept, hull);
        }
        const auto outside = [&](Double3 p) {
            double far = 0.0;
            for (const HullPlane& plane : planes) far = std::max(far, dot(plane.normal, p) - plane.offset);
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

// The direction in which the hull is thinnest, of those of its faces, and how thin.
double thinnest(const Points& points, const std::vector<HullPlane>& planes, Double3& along, double& middle) {
    double least = std::numeric_limits<double>::infinity();
    for (const HullPlane& plane : planes) {
        double low = plane.offset;
        for (const auto& p : points) low = std::min(low, dot(plane.normal, of(p)));
        if (plane.offset - low >= least) continue;
        least = plane.offset - low;
        along = plane.normal;
        middle = 0.5 * (plane.offset + low);
    }
    return least;
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

// A plate: its outline in the middle plane, rounded by half of its thickness, by which the outline is drawn in.
bool set_plate(BodyShape& shape, const Points& points, double extent, Double3 normal, double middle, double thickness,
               double volume) {
    Points projected;
    for (const auto& p : points) {
        const Double3 q = of(p) - (dot(normal, of(p)) - middle) * normal;
        projected.push_back({q.x, q.y, q.z});
    }
    // Projected points of one plane are off it by rounding; the hull's grid does not see that.
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
    Points outline;
    for (const uint32_t i : hull.points) outline.push_back(projected[i]);
    Points kept = reduced(outline, extent, area / extent, normal, most_outline);
    if (kept.size() < 3) return false;
    set_points(shape, kept);
    const Double3 center = to_double(shape.center);
    for (auto& p : kept) {
        const Double3 from = of(p) - center;
        const double size = length(from);
        const Double3 in = center + (size > thickness ? 1.0 - 0.5 * thickness / size : 0.5) * from;
        p = {in.x, in.y, in.z};
    }
    set_points(shape, kept);
    shape.radius = static_cast<float>(0.5 * thickness);
    shape.thickness = static_cast<float>(thickness);
    std::vector<uint32_t> corners(kept.size());
    for (uint32_t i = 0; i < corners.size(); ++i) corners[i] = i;
    add_face(shape, kept, normal, corners);
    add_face(shape, kept, -normal, corners);
    set_bounds(shape);
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

// Semi-axes of the uniform ellipsoid with this inertia, as far as there is one.
std::array<double, 3> inertia_axes(const AssetData& asset) {
    std::array<double, 3> semi{};
    const double sum = asset.inertia[0] + asset.inertia[4] + asset.inertia[8];
    for (size_t i = 0; i < 3; ++i) {
        const double square = 2.5 / asset.mass * (sum - 2.0 * asset.inertia[i * 4]);
        semi[i] = std::sqrt(std::max(square, 1e-8 * sum / asset.mass));
    }
    return semi;
}

// Whether these are the numbers, and the hull of 42 points, that closed forms give of a solid ellipsoid.
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

// The hull of the most corners that are kept lets a ball sink in by an eighth of its radius: what is round stays so.
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
    Points points;
    for (const uint32_t i : hull.points) points.push_back(all[i]);
    double extent = 0.0;
    for (size_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                                     [k](const auto& a, const auto& b) { return a[k] < b[k]; });
        extent = std::max(extent, (*high)[k] - (*low)[k]);
    }
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
    Double3 normal{};
    double middle = 0.0;
    const double thickness = thinnest(points, hull_planes(all, hull), normal, middle);
    if (thickness < thin * extent && set_plate(shape, points, extent, normal, middle, thickness, volume)) return true;
    shape = {};
    return set_hull(shape, reduced(points, extent, thickness, {0.0, 0.0, 0.0}, most_shape_points));
}

Vector point(const BodyShape& s, uint32_t i) {
    return {s.x[i], s.y[i], s.z[i]};
}

// Twice the area of a face, and its middle.
float measure(const BodyShape& s, const ShapeFace& f, Vector& middle) {
    const Vector first = point(s, s.corners[f.first]);
    middle = {0.0f, 0.0f, 0.0f};
    Vector area{0.0f, 0.0f, 0.0f};
    const uint32_t count = f.count;
    for (uint32_t k = 0; k < count; ++k) {
        const Vector a = point(s, s.corners[f.first + k]), b = point(s, s.corners[f.first + (k + 1) % count]);
        middle = middle + a;
        area = area + cross(a - first, b - first);
    }
    middle = 1.0f / static_cast<float>(f.count) * middle;
    return length(area);
}

void add_samples(BodyShape& s) {
    s.sample_count = s.count;
    const auto add = [&](Vector p) {
        if (s.sample_count == most_shape_samples) return;
        s.x[s.sample_count] = p.x, s.y[s.sample_count] = p.y, s.z[s.sample_count] = p.z;
        ++s.sample_count;
    };
    // Faces by their size; of a flat body both are the same.
    uint32_t order[most_shape_faces];
    float area[most_shape_faces];
    Vector middle[most_shape_faces];
    const bool flat = s.face_count == 2;
    const uint32_t faces = flat ? 1 : s.face_count;
    float total = 0.0f;
    for (uint32_t f = 0; f < faces; ++f) {
        order[f] = f;
        area[f] = measure(s, s.faces[f], middle[f]);
        total += area[f];
    }
    std::stable_sort(order, order + faces, [&](uint32_t a, uint32_t b) { return area[a] > area[b]; });
    for (uint32_t k = 0; k < faces && s.sample_count < most_shape_samples; ++k) {
        const uint32_t f = order[k];
        if (area[f] < 0.05f * total) break;
        add(middle[f]);
        // Half way to some of its corners.
        const ShapeFace& face = s.faces[f];
        const uint32_t corners = face.count, stride = (corners + 7) / 8;
        for (uint32_t c = 0; c < corners; c += stride) add(0.5f * (middle[f] + point(s, s.corners[face.first + c])));
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
