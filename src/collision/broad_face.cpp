#include "collision/broad_face.h"

#include "collision/body_narrow_phase.h"

#include <algorithm>
#include <limits>

namespace lr {
namespace {

constexpr uint32_t rows = 4;
static_assert(rows * rows == face_points);

Pose own_frame(const PairHull& hull, float scale, const Pose& at) {
    return {at.position + scale * rotate(at.rotation, hull.origin), at.rotation * hull.frame};
}

// The part of a line, from -half to half, that lies in a convex set.
struct LinePart {
    float first, last; // m
    // Keeps the part at which height + rise * t <= 0. False if nothing is left.
    bool clip(float height, float rise) {
        if (rise == 0.0f) return height <= 0.0f;
        const float t = -height / rise;
        if (rise > 0.0f)
            last = std::min(last, t);
        else
            first = std::max(first, t);
        return first <= last;
    }
};

// line: in the hull's own frame.
bool crosses(const PairHull& hull, float scale, const FaceLine& line, LinePart& part) {
    const Vector p = line.point, d = line.direction;
    for (uint32_t f = 0; f < hull.shape.face_count; ++f) {
        const Vector n = hull.face_normal(f);
        if (!part.clip(dot(n, p) - scale * (hull.face_offset[f] + hull.shape.radius), dot(n, d))) return false;
    }
    const uint32_t corners = hull.flat ? hull.shape.count : 0;
    for (uint32_t i = 0; i < corners; ++i) {
        const uint32_t next = i + 1 < corners ? i + 1 : 0;
        const float x = hull.ring_x[next] - hull.ring_x[i], y = hull.ring_y[next] - hull.ring_y[i];
        const float outside = (p.x - scale * hull.ring_x[i]) * y - (p.y - scale * hull.ring_y[i]) * x;
        if (!part.clip(outside, d.x * y - d.y * x)) return false;
    }
    return true;
}
} // namespace

// Four lines across the silhouette, four points on each. An edge of the silhouette joins two of the hull's points, and no segment
// between two of them leaves it.
BroadFace make_broad_face(const PairHull& hull) {
    const Vector half = hull.core_half;
    const float radius = hull.shape.radius;
    BroadFace face{};
    face.across = half.z <= half.x && half.z <= half.y ? 2 : half.x <= half.y ? 0 : 1;
    const uint32_t along_u = (face.across + 1) % 3, along_v = (face.across + 2) % 3;
    const float u = half[along_u] + radius, v = half[along_v] + radius;
    face.half = half[face.across] + radius;
    const float broad = u * v, rim = face.half * (u + v);
    face.share = broad / (broad + rim);
    for (uint32_t row = 0; row < rows; ++row) {
        const float at = half[along_v] * ((2.0f * static_cast<float>(row) + 1.0f) / rows - 1.0f);
        float low = std::numeric_limits<float>::max(), high = -low;
        for (uint32_t i = 0; i < hull.shape.count; ++i)
            for (uint32_t k = 0; k < hull.shape.count; ++k) {
                const float v_i = hull.point(i)[along_v], v_k = hull.point(k)[along_v];
                if (!(v_i <= at && at < v_k)) continue;
                const float part = (at - v_i) / (v_k - v_i);
                const float u_i = hull.point(i)[along_u], here = u_i + part * (hull.point(k)[along_u] - u_i);
                low = std::min(low, here);
                high = std::max(high, here);
            }
        if (low > high) low = high = 0.0f; // a hull without width
        for (uint32_t i = 0; i < rows; ++i) {
            face.u[rows * row + i] = low + (high - low) * ((static_cast<float>(i) + 0.5f) / rows);
            face.v[rows * row + i] = at;
        }
    }
    return face;
}

FaceLines::FaceLines(const PairHull& hull, float scale, const Pose& at) : face_(&hull.face) {
    const Pose own = own_frame(hull, scale, at);
    const uint32_t across = face_->across;
    middle_ = own.position;
    u_ = rotate(own.rotation, along_axis((across + 1) % 3, scale));
    v_ = rotate(own.rotation, along_axis((across + 2) % 3, scale));
    direction_ = rotate(own.rotation, along_axis(across, 1.0f));
}

void hide(const PairHull& hull, float scale, const Pose& at, const PairHull& by, float by_scale, const Pose& by_at,
          Hidden& hidden) {
    const float reach = scale * hull.shape.reach, by_reach = by_scale * by.shape.reach;
    const float half = scale * hull.face.half + covering_gap * std::min(reach, by_reach);
    const FaceLines lines(hull, scale, relative(own_frame(by, by_scale, by_at), at));
    for (uint32_t k = 0; k < face_points; ++k) {
        LinePart part{-half, half};
        if (!crosses(by, by_scale, lines[k], part)) continue;
        // A body that reaches through the middle plane hides the side on which most of it lies.
        (part.first + part.last > 0.0f ? hidden.above : hidden.below) |= 1u << k;
    }
}
} // namespace lr
