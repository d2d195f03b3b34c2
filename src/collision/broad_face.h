// The broad faces of a body, and which of their points other things hide from the wind. docs/maintainers/contact.md, "Shelter".
#pragma once

#include "base/pose.h"

#include <cstdint>

namespace lr {

struct PairHull;

inline constexpr uint32_t face_points = 16;

// The two faces across the thinnest axis of a hull's own frame, at scale 1.
struct BroadFace {
    uint32_t across;                      // that axis
    float half;                           // m, half the thickness
    float share;                          // of both faces in the surface of the hull's box; the rest is the rim
    float u[face_points], v[face_points]; // m, along the next two axes: spread evenly over the silhouette
};
// Of a hull with its own points and rounding.
BroadFace make_broad_face(const PairHull& hull);

// A bit for each point that something lies over, on the side to which the axis points, and on the other.
struct Hidden {
    uint32_t above = 0, below = 0;
};
// Something farther from the face than this share of the smaller one's reach leaves it open.
inline constexpr float covering_gap = 0.125f;

// A line across the faces through one of their points, both ways from the middle plane.
struct FaceLine {
    Vector point, direction; // m; unit, to the side above
};
// The lines through a placed body, in the frame in which `at` is given.
struct FaceLines {
    FaceLines(const PairHull& hull, float scale, const Pose& at);
    FaceLine operator[](uint32_t k) const { return {middle + face_->u[k] * u + face_->v[k] * v, direction}; }

    Vector middle, u, v, direction; // u, v: of a unit of the face's u and v

private:
    const BroadFace* face_;
};

// Adds the points that another body hides.
void hide(const PairHull& hull, float scale, const Pose& at, const PairHull& by, float by_scale, const Pose& by_at,
          Hidden& hidden);

// The share of the surface that lies open, 0 to 1: the rim, and all of the faces but what is hidden on both sides.
inline float open_share(const BroadFace& face, const Hidden& hidden) {
    uint32_t shut = 0; // std::popcount() would import a function of the compiler
    for (uint32_t k = 0; k < face_points; ++k) shut += (hidden.above & hidden.below) >> k & 1u;
    return 1.0f - face.share * (static_cast<float>(shut) / static_cast<float>(face_points));
}
} // namespace lr
