// The cushion of air between a sheet and the ground (docs/maintainers/contact.md, "Ground effect").
#include "contact/contact_group.h"
#include "contact/terrain.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

// A flat shape's normal in the body frame and its area at scale 1; 0 for bodies that are no sheets.
float sheet(const BodyShape& s, Vector& normal) {
    if (s.count == 0 || s.face_count != 2) return 0.0f;
    const ShapeFace& f = s.faces[0];
    const auto point = [&](uint32_t k) {
        const uint32_t i = s.corners[f.first + k];
        return Vector{s.x[i], s.y[i], s.z[i]};
    };
    Vector twice{0.0f, 0.0f, 0.0f};
    const uint32_t count = f.count;
    for (uint32_t k = 1; k + 1 < count; ++k) twice = twice + cross(point(k) - point(0), point(k + 1) - point(0));
    normal = f.normal;
    return 0.5f * length(twice);
}

// Body and fluid that go along the normal, kg at scale 1.
float inertia_along(const BodyConstants& c, Vector n) {
    const float* const m = c.full_mass;
    const float in_units = c.diagonal ? c.mass[0] * n.x * n.x + c.mass[1] * n.y * n.y + c.mass[2] * n.z * n.z
                                      : m[0] * n.x * n.x + m[6] * n.y * n.y + m[11] * n.z * n.z +
                                            2.0f * (m[1] * n.x * n.y + m[2] * n.x * n.z + m[7] * n.y * n.z);
    return c.unit_mass * in_units;
}

// Height over a plane or heightfield in its own frame; negative without ground below.
float height_over(const Geometry& g, Vector at) {
    const HeightfieldGeometry* const f = g.heightfield;
    if (!f) return at.y;
    const auto within = [&](float x, int k) {
        return x >= 0.0f && x < static_cast<float>(f->counts[k] - 1) * f->spacing[k];
    };
    return within(at.x, 0) && within(at.z, 1) ? at.y - height_at(*f, at.x, at.z).height : -1.0f;
}

} // namespace

// A disc of radius a that comes down flat on a wall at the height z sets the air under it in motion: its kinetic energy is
// 1/2 K/z v^2, K = pi rho a^4/8, of a flow between two plates. What the sheet has along the normal is shared with it: with
// l = K/m, (1 + l/z) v^2 stays. What leaves at the edge does not come back, so that a sheet that rises is not pulled.
void ContactGroup::press_air(const LaneRow (&before)[pose_fields], float begin, float end) {
    Vector face;
    const float area = sheet(*step_->shape, face);
    if (!(area > 0.0f)) return;
    constexpr float pi = 3.14159265f;
    const float radius_squared = area / pi, radius = std::sqrt(radius_squared);
    const float inertia = inertia_along(*body_, face);
    const float share =
        step_->settings->ground_effect * 0.125f * pi * step_->fluid_density * radius_squared * radius_squared / inertia;
    for (uint32_t i = 0; i < count_; ++i) {
        const float scale = arrays_.field[field_scale][i];
        Pose pose = pose_of(i);
        const Pose was = pose_in(before, i);
        for (uint32_t k = 0; k < near_[i].count; ++k) {
            const Collider& c = step_->colliders->at(near_[i].candidate[k].slot);
            const bool plane = c.geometry.kind == ColliderKind::plane;
            if (!plane && c.geometry.kind != ColliderKind::heightfield) continue;
            const Pose from = pose_at(c, begin), to = pose_at(c, end);
            const Vector up = rotate(to.rotation, {0.0f, 1.0f, 0.0f});
            const float flat = dot(up, rotate(pose.rotation, face)), squared = flat * flat;
            const float least = 0.02f * radius * scale, most = radius * scale;
            const float first = std::max(height_over(c.geometry, to_inner(from, was.position)), least);
            const float last = std::max(height_over(c.geometry, to_inner(to, pose.position)), least);
            if (!(last < first) || first > most) continue;
            const float l = share * scale * squared * squared;
            const float kept = std::sqrt((1.0f + l / first) / (1.0f + l / last));
            const Vector n = rotate(inverse(pose.rotation), up);
            const Vector v = vector_in(arrays_.field, field_vx, i);
            const float speed = dot(n, v);
            const Vector v0 = rotate(was.rotation, vector_in(before, field_vx, i));
            const float began = dot(up, v0);
            if (!(speed < 0.0f && began <= 0.0f)) continue;
            // What the substep's forces gave moves the air as well.
            const float slow = kept * (began + (speed - began) / (1.0f + 2.0f * l / (first + last)));
            put_in(arrays_.field, field_vx, i, v - (speed - slow) * n);
            // The way goes with the mean of both ends.
            pose.position = pose.position + ((first - last) * (speed - slow) / (began + speed)) * up;
            put_in(arrays_.field, field_x, i, pose.position);
        }
    }
}

} // namespace lr
