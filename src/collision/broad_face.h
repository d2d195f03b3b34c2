// Shelter from wind: the broad faces of a body, and which of their points other things cover. docs/maintainers/contact.md, section 18.
#pragma once

#include "base/pose.h"

#include <cstdint>

namespace lr {

struct PairHull;

inline constexpr uint32_t face_points = 16;

// The two faces across the thinnest axis of a hull's own frame, at scale 1.
struct BroadFace {
    uint32_t across;                      // the thinnest axis
    float half;                           // m, half the thickness
    float share;                          // of both faces in the surface of the hull's box; the rim has the rest
    float u[face_points], v[face_points]; // m, along the next two axes: sample points spread evenly over the silhouette
};
BroadFace make_broad_face(const PairHull& hull);

// One bit for each sample point that is covered, above (the side to which the axis points) and below.
struct Hidden {
    uint32_t above = 0, below = 0;
};
// Covers count up to this distance from the face, as a share of the smaller body's reach; beyond it wind reaches the face.
inline constexpr float covering_gap = 0.125f;

// The line across the faces through a sample point, from the middle plane to both sides.
struct FaceLine {
    Vector point, direction; // m; unit, to the side above
};
// These lines for a placed body, in the frame of its pose.
struct FaceLines {
    FaceLines(const PairHull& hull, float scale, const Pose& at);
    FaceLine operator[](uint32_t k) const { return {middle + face_->u[k] * u + face_->v[k] * v, direction}; }

    Vector middle, u, v, direction; // u, v: one unit along the face's u and v

private:
    const BroadFace* face_;
};

// Marks the sample points that another body covers.
void hide(const PairHull& hull, float scale, const Pose& at, const PairHull& by, float by_scale, const Pose& by_at,
          Hidden& hidden);

// Share of the surface open to wind, 0 to 1: the rim, and the faces less the points covered on both sides.
inline float open_share(const BroadFace& face, const Hidden& hidden) {
    uint32_t shut = 0; // std::popcount() would import a function of the compiler
    for (uint32_t k = 0; k < face_points; ++k) shut += (hidden.above & hidden.below) >> k & 1u;
    return 1.0f - face.share * (static_cast<float>(shut) / static_cast<float>(face_points));
}
} // namespace lr
