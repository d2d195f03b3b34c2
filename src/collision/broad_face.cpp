#include "collision/broad_face.h"

#include "base/float4.h"
#include "collision/body_narrow_phase.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lr {
namespace {

constexpr uint32_t rows = 4;
static_assert(rows * rows == face_points);

Pose own_frame(const PairHull& hull, float scale, const Pose& at) {
    return {at.position + scale * rotate(at.rotation, hull.origin), at.rotation * hull.frame};
}

// The parts of a body's face lines within a convex set, four lines at a time. All lines have one direction.
class LineParts {
public:
    LineParts(const BroadFace& face, float half) : face_(&face) {
        std::fill_n(first_, vectors, all(-half));
        std::fill_n(last_, vectors, all(half));
    }
    // Keeps the parts where height + u rise_u + v rise_v + t rise <= 0. False if nothing is left of any line.
    bool clip(float height, float rise_u, float rise_v, float rise) {
        constexpr float far = std::numeric_limits<float>::max();
        Int4 some{};
        for (size_t k = 0; k < vectors; ++k) {
            const Float4 at = height + rise_u * load(face_->u + 4 * k) + rise_v * load(face_->v + 4 * k);
            if (rise > 0.0f)
                last_[k] = less(last_[k], -1.0f / rise * at);
            else if (rise < 0.0f)
                first_[k] = greater(first_[k], -1.0f / rise * at);
            else
                last_[k] = choose(at <= all(0.0f), last_[k], all(-far));
            some |= first_[k] <= last_[k];
        }
        return any(some);
    }
    // A body that crosses the middle plane covers the side on which most of it lies.
    void hide(Hidden& hidden) const {
        for (uint32_t k = 0; k < face_points; ++k) {
            const float first = first_[k / 4][k % 4], last = last_[k / 4][k % 4];
            if (first <= last) (first + last > 0.0f ? hidden.above : hidden.below) |= 1u << k;
        }
    }

private:
    static constexpr uint32_t vectors = face_points / 4;
    const BroadFace* face_;
    Float4 first_[vectors], last_[vectors]; // m, from the middle plane
};
} // namespace

// Four rows across the silhouette, four points on each. A row's ends lie on edges of the silhouette; each joins two of the hull's points, and no
// segment between two points reaches farther, so all pairs are tried.
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
    middle = own.position;
    u = rotate(own.rotation, along_axis((across + 1) % 3, scale));
    v = rotate(own.rotation, along_axis((across + 2) % 3, scale));
    direction = rotate(own.rotation, along_axis(across, 1.0f));
}

void hide(const PairHull& hull, float scale, const Pose& at, const PairHull& by, float by_scale, const Pose& by_at,
          Hidden& hidden) {
    const float reach = scale * hull.shape.reach, by_reach = by_scale * by.shape.reach;
    const float half = scale * hull.face.half + covering_gap * std::min(reach, by_reach);
    const FaceLines lines(hull, scale, relative(own_frame(by, by_scale, by_at), at));
    const Vector m = lines.middle, d = lines.direction;
    // Cheap test first: in heaps most pairs with overlapping boxes are far apart across the face.
    const float radius = by_scale * by.shape.radius;
    const Vector box = by_scale * by.core_half;
    if (std::abs(dot(m, d)) > half + radius + (std::abs(d.x) * box.x + std::abs(d.y) * box.y + std::abs(d.z) * box.z))
        return;
    LineParts parts(hull.face, half);
    const auto clip = [&](Vector n, float offset) {
        return parts.clip(dot(n, m) - offset, dot(n, lines.u), dot(n, lines.v), dot(n, d));
    };
    for (uint32_t f = 0; f < by.shape.face_count; ++f)
        if (!clip(by.face_normal(f), by_scale * by.face_offset[f] + radius)) return;
    const uint32_t corners = by.flat ? by.shape.count : 0;
    for (uint32_t i = 0; i < corners; ++i) {
        const uint32_t next = i + 1 < corners ? i + 1 : 0;
        const Vector n{by.ring_y[next] - by.ring_y[i], by.ring_x[i] - by.ring_x[next], 0.0f};
        if (!clip(n, by_scale * (n.x * by.ring_x[i] + n.y * by.ring_y[i]))) return;
    }
    parts.hide(hidden);
}
} // namespace lr
