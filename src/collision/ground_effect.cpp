// The air under a sheet that comes down flat on the ground. docs/maintainers/contact.md, section 4.
#include "collision/collider_contact_group.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

// Area of a sheet at scale 1 and its normal in the body frame; 0 for other shapes.
float sheet(const BodyShape& s, Vector& normal) {
    if (s.count == 0 || s.face_count != 2) return 0.0f;
    const ShapeFace& f = s.faces[0];
    normal = f.normal;
    return 0.5f * length(s.doubled_area(f));
}

// Mass of body and added mass along the normal, kg at scale 1.
float inertia_along(const BodyConstants& c, Vector n) {
    const float* const m = c.full_mass;
    const float in_units = c.diagonal ? c.mass[0] * n.x * n.x + c.mass[1] * n.y * n.y + c.mass[2] * n.z * n.z
                                      : m[0] * n.x * n.x + m[6] * n.y * n.y + m[11] * n.z * n.z +
                                            2.0f * (m[1] * n.x * n.y + m[2] * n.x * n.z + m[7] * n.y * n.z);
    return c.unit_mass * in_units;
}
} // namespace

// Ground effect: a disc of radius a that comes down flat at the height z sets the air under it in motion, with the energy 1/2 (K/z) v^2,
// K = pi rho a^4/8. The sheet shares its energy with that air: with l = K/m, (1 + l/z) v^2 is constant along the normal. Air that leaves at the edge
// does not come back, so a rising sheet is not pulled.
void ContactGroup::ground_effect(const ContactSubstep& substep) {
    const LaneRow* const before = substep.before;
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
            if (!is_ground(c.geometry.kind)) continue;
            const Pose from = pose_at(c, substep.begin), to = pose_at(c, substep.end);
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
            // The velocity gained from forces in this substep moves the air too.
            const float slow = kept * (began + (speed - began) / (1.0f + 2.0f * l / (first + last)));
            put_in(arrays_.field, field_vx, i, v - (speed - slow) * n);
            // The displacement follows the mean of both end velocities.
            pose.position = pose.position + ((first - last) * (speed - slow) / (began + speed)) * up;
            put_in(arrays_.field, field_x, i, pose.position);
        }
    }
}
} // namespace lr
