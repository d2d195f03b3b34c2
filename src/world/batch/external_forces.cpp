#include "world/batch/external_forces.h"

#include <algorithm>
#include <limits>

namespace lr {

void ExternalForces::add(uint32_t index, size_t frame, size_t kind, Double3 value) {
    if (value.x == 0.0 && value.y == 0.0 && value.z == 0.0) return;
    float* at = rows_ + force_component(frame, kind) * stride_ + index;
    for (uint32_t i = 0; i < 3; ++i, at += stride_) {
        constexpr auto most = static_cast<double>(std::numeric_limits<float>::max());
        *at = static_cast<float>(std::clamp(static_cast<double>(*at) + value[i], -most, most));
    }
    used_ |= 1u << force_component(frame, kind) / 3;
}

void ExternalForces::set_batch(const float (&force)[force_components]) {
    // Without negative zeros, sums do not depend on whether zeros are added.
    std::transform(force, force + force_components, batch_, [](float f) { return f + 0.0f; });
    on_batch_ = std::any_of(force, force + force_components, [](float f) { return f != 0.0f; });
}

void ExternalForces::forget_zeros(uint32_t count) {
    const auto none = [&](size_t i) {
        const float* const row = rows_ + i * stride_;
        return std::all_of(row, row + count, [](float f) { return f == 0.0f; });
    };
    for (size_t i = 0; i < force_components && pending(); i += 3)
        if (none(i) && none(i + 1) && none(i + 2)) used_ &= ~(1u << i / 3);
}

void ExternalForces::spread(float part, uint32_t count) {
    for (size_t i = 0; i < force_components; ++i)
        if (used_ >> i / 3 & 1u) std::for_each_n(rows_ + i * stride_, count, [=](float& f) { f *= part; });
}

void ExternalForces::fill(ExternalInput& in) const {
    in.any = on_batch_ || pending();
    in.used = used_;
    if (!in.any) return; // in.any decides whether the rest is read
    in.clear = true;
    std::copy(batch_, batch_ + force_components, in.batch);
    in.bodies = rows_;
    in.stride = stride_;
}

Kick impulse_response(const BodyConstants& body, double scale, const Kick& impulse) {
    // Kernel units: linear/(U s^3), angular/(U s^3 d s); u = d s w.
    const double length = wide(body.length) * scale;
    const double mass = wide(body.unit_mass) * scale * scale * scale;
    const Double3 linear = impulse.v / mass, angular = impulse.w / (mass * length);
    const double p[6] = {linear.x, linear.y, linear.z, angular.x, angular.y, angular.z};
    double t[6] = {};
    size_t n = 0; // of the upper triangle
    for (size_t i = 0; i < 6; ++i)
        for (size_t j = i; j < 6; ++j, ++n) {
            const double entry = wide(body.full_inverse[n]);
            t[i] += entry * p[j];
            if (j != i) t[j] += entry * p[i];
        }
    return {{t[0], t[1], t[2]}, {t[3] / length, t[4] / length, t[5] / length}};
}
} // namespace lr
