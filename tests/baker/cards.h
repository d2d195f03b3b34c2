// Cards made of drawn masks, and the checks that any of them must pass.
#pragma once

#include "baker/card/card.h"
#include "baker/fault_text.h"
#include "png_files.h"

#include <doctest/doctest.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace lr::test {

using namespace lr::baker;

struct Card {
    Mesh mesh;
    CardReport report;
    Faults faults;
    bool good = false;
};

inline Card read(const std::string& png, const CardOptions& options) {
    Card card;
    card.good = read_card_memory(png.data(), png.size(), options, "leaf.png", card.mesh, card.report, card.faults);
    CHECK(card.good != has_error(card.faults));
    return card;
}

// A metre per pixel.
inline CardOptions in_pixels(const Opacity& mask, std::size_t triangles = 2000) {
    CardOptions options;
    options.width = static_cast<double>(mask.width);
    options.triangles = triangles;
    return options;
}

inline Card read(const Opacity& mask, std::size_t triangles = 2000) {
    return read(test::png_file(mask), in_pixels(mask, triangles));
}

inline std::size_t count(const Faults& faults, FaultId id, Severity severity) {
    return static_cast<std::size_t>(std::count_if(
        faults.begin(), faults.end(), [&](const Fault& f) { return f.id == id && f.severity == severity; }));
}

inline const Fault& only(const Card& card) {
    REQUIRE(card.faults.size() == 1);
    CHECK_FALSE(card.faults[0].remedy.empty());
    return card.faults[0];
}

inline double area(const Mesh& mesh) {
    double sum = 0.0;
    for (const Face& f : mesh.faces)
        sum += 0.5 * (mesh.vertices[f[1]] - mesh.vertices[f[0]]).cross(mesh.vertices[f[2]] - mesh.vertices[f[0]]).z();
    return sum;
}

inline Eigen::Vector3d centroid(const Mesh& mesh) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Face& f : mesh.faces) {
        const Eigen::Vector3d &a = mesh.vertices[f[0]], &b = mesh.vertices[f[1]], &c = mesh.vertices[f[2]];
        sum += 0.5 * (b - a).cross(c - a).z() * (a + b + c) / 3.0;
    }
    return sum / area(mesh);
}

// Edges once or twice, faces towards +z, every vertex used, the area of the mask kept. Returns the Euler characteristic.
inline int check_sound(const Card& card) {
    REQUIRE(card.good);
    const Mesh& mesh = card.mesh;
    std::map<std::pair<uint32_t, uint32_t>, int> directed;
    std::vector<char> used(mesh.vertices.size(), 0);
    std::size_t bad = 0, edges = 0;
    double outline = 0.0;
    for (const Face& f : mesh.faces) {
        const Eigen::Vector3d normal =
            (mesh.vertices[f[1]] - mesh.vertices[f[0]]).cross(mesh.vertices[f[2]] - mesh.vertices[f[0]]);
        bad += !(normal.z() > 0.0);
        for (std::size_t k = 0; k < 3; ++k) {
            used[f[k]] = 1;
            bad += ++directed[{f[k], f[(k + 1) % 3]}] != 1;
        }
    }
    for (const auto& [edge, n] : directed) {
        const bool open = !directed.contains({edge.second, edge.first});
        edges += open || edge.first < edge.second;
        if (open) outline += (mesh.vertices[edge.first] - mesh.vertices[edge.second]).norm();
    }
    for (const Eigen::Vector3d& v : mesh.vertices) bad += v.z() != 0.0 || !v.allFinite();
    CHECK(bad == 0);
    CHECK(std::count(used.begin(), used.end(), 0) == 0);
    CHECK(area(mesh) == doctest::Approx(card.report.traced_area).epsilon(1e-7));
    CHECK(card.report.area == doctest::Approx(card.report.traced_area).epsilon(1e-7));
    CHECK(card.report.outline == doctest::Approx(outline).epsilon(1e-7));
    return static_cast<int>(mesh.vertices.size()) - static_cast<int>(edges) + static_cast<int>(mesh.faces.size());
}

inline Opacity disc(std::size_t size, double radius, double hole = 0.0) {
    const double c = 0.5 * static_cast<double>(size);
    return test::draw(size, size, [=](double x, double y) {
        const double r = std::hypot(x - c, y - c);
        return r < radius && r >= hole;
    });
}

// About the middle of the image, y up; spread: of the mass about its centre, along x and y.
struct PixelSums {
    double area = 0.0;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero(), spread = Eigen::Vector3d::Zero();
};

inline PixelSums pixel_sums(const Opacity& mask) {
    PixelSums sums;
    for (std::size_t y = 0; y < mask.height; ++y)
        for (std::size_t x = 0; x < mask.width; ++x) {
            const Eigen::Vector3d at(static_cast<double>(x) + 0.5 - 0.5 * static_cast<double>(mask.width),
                                     0.5 * static_cast<double>(mask.height) - static_cast<double>(y) - 0.5, 0.0);
            sums.area += mask.at(x, y);
            sums.centre += mask.at(x, y) * at;
            sums.spread += mask.at(x, y) * at.cwiseAbs2();
        }
    sums.centre /= sums.area;
    sums.spread -= sums.area * sums.centre.cwiseAbs2();
    return sums;
}
} // namespace lr::test
