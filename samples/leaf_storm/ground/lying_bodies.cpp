// SPDX-License-Identifier: MIT
#include "ground/lying_bodies.h"

#include <algorithm>
#include <cmath>
#include <numbers>

void Lying::add(const lr_batch_view& view, const Mesh& mesh, int thin, const Park& park) {
    const auto radius = static_cast<double>(mesh.radius());
    bodies += view.count;
    at_rest += view.count - view.awake_count;
    for (std::uint32_t i = 0; i < view.count; ++i) {
        const auto value = [i](const float* field) { return static_cast<double>(field[i]); };
        const Vector place{value(view.position[0]), value(view.position[1]), value(view.position[2])};
        if (std::max(std::abs(place[0]), std::abs(place[2])) > static_cast<double>(Terrain::half_width)) continue;
        const Quaternion q{value(view.orientation[0]), value(view.orientation[1]), value(view.orientation[2]),
                           value(view.orientation[3])};
        const double scale = value(view.scale), reach = scale * radius;
        const Terrain::Place ground = park.terrain().at(place[0], place[2]);
        const bool rests = i >= view.awake_count;
        if (!rests && place[1] > ground.height + 2.0 * reach + 0.1) continue;
        double gap = 1e9; // m, along the normal of the triangle below
        for (const Vertex& vertex : mesh.vertices) {
            const Vector arm{static_cast<double>(vertex.position[0]), static_cast<double>(vertex.position[1]),
                             static_cast<double>(vertex.position[2])};
            const Vector p = plus(place, times(scale, turned(q, arm)));
            const Terrain::Place below_it = park.terrain().at(p[0], p[2]);
            gap = std::min(gap, (p[1] - below_it.height) * below_it.normal[1]);
        }
        const float* walker = park.walker();
        if (walker && std::hypot(place[0] - static_cast<double>(walker[0]), place[2] - static_cast<double>(walker[2])) <
                          static_cast<double>(Park::walker_radius) + reach) {
            trodden += gap < -tolerance ? 1 : 0;
        } else {
            deepest = std::max(deepest, -gap);
            below += gap < -tolerance ? 1 : 0;
        }
        if (!rests) {
            near_awake += gap < 0.05 ? 1 : 0;
            continue;
        }
        if (park.furnished(place[0], place[2], reach)) continue;
        highest = std::max(highest, gap);
        hovering += gap > tolerance ? 1 : 0;
        Vector axis{};
        axis[static_cast<std::size_t>(thin)] = 1.0;
        const double cosine = std::min(1.0, std::abs(dot(turned(q, axis), ground.normal)));
        const double tilt = std::acos(cosine) * 180.0 / std::numbers::pi;
        ++tilts_[static_cast<std::size_t>(tilt)];
        on_edge += tilt > 60.0 ? 1 : 0;
    }
}

void Lying::finish() {
    std::uint64_t all = 0, sum = 0;
    for (const std::uint64_t n : tilts_) all += n;
    for (std::size_t k = 0; all > 0 && 2 * sum < all; ++k) {
        sum += tilts_[k];
        median_tilt = static_cast<double>(k) + 0.5;
    }
}
