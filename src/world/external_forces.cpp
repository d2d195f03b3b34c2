#include "world/external_forces.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace lr {

bool ExternalForces::reserve(Allocator& allocator, size_t lanes) {
    if (bodies_.size() != 0) return true;
    if (!bodies_.allocate(allocator, force_components * lanes)) return false;
    stride_ = lanes;
    clear();
    return true;
}

void ExternalForces::add(uint32_t index, size_t frame, size_t kind, const double value[3]) {
    if (value[0] == 0.0 && value[1] == 0.0 && value[2] == 0.0) return;
    float* at = bodies_.data() + force_component(frame, kind) * stride_ + index;
    for (size_t i = 0; i < 3; ++i, at += stride_) {
        constexpr auto most = static_cast<double>(std::numeric_limits<float>::max());
        *at = static_cast<float>(std::clamp(static_cast<double>(*at) + value[i], -most, most));
    }
    used_ |= 1u << force_component(frame, kind) / 3;
}

void ExternalForces::move(uint32_t from, uint32_t to) {
    if (!pending()) return;
    for (size_t i = 0; i < force_components; ++i) {
        float* const component = bodies_.data() + i * stride_;
        component[to] = component[from];
        component[from] = 0.0f;
    }
}

void ExternalForces::swap(uint32_t a, uint32_t b) {
    if (!pending()) return;
    for (size_t i = 0; i < force_components; ++i) {
        float* const component = bodies_.data() + i * stride_;
        std::swap(component[a], component[b]);
    }
}

void ExternalForces::clear(uint32_t index) {
    clear(index, index + 1);
}

void ExternalForces::clear(uint32_t begin, uint32_t end) {
    if (!pending()) return;
    for (size_t i = 0; i < force_components; ++i) {
        float* const component = bodies_.data() + i * stride_;
        std::fill(component + begin, component + end, 0.0f);
    }
}

void ExternalForces::clear() {
    std::fill_n(bodies_.data(), bodies_.size(), 0.0f);
    used_ = 0;
}

void ExternalForces::set_batch(const float (&force)[force_components]) {
    // No negative zeros: with them a sum would depend on whether zeros are added to it.
    std::transform(force, force + force_components, batch_, [](float f) { return f + 0.0f; });
    on_batch_ = std::any_of(force, force + force_components, [](float f) { return f != 0.0f; });
}

void ExternalForces::spread(float part, uint32_t count) {
    for (size_t i = 0; i < force_components; ++i)
        if (used_ >> i / 3 & 1u) std::for_each_n(bodies_.data() + i * stride_, count, [=](float& f) { f *= part; });
}

void ExternalForces::fill(ExternalInput& in) {
    in.any = on_batch_ || pending();
    in.used = used_;
    if (!in.any) return; // and the rest is not looked at
    in.clear = true;
    std::copy(batch_, batch_ + force_components, in.batch);
    in.bodies = bodies_.data();
    in.stride = stride_;
}

Kick impulse_response(const BodyConstants& body, double scale, const double linear[3], const double angular[3]) {
    // Kernel units: linear/(U s^3), angular/(U s^3 d s); u = d s w.
    const double length = static_cast<double>(body.length) * scale;
    const double mass = static_cast<double>(body.unit_mass) * scale * scale * scale;
    double p[6];
    for (size_t i = 0; i < 3; ++i) p[i] = linear[i] / mass, p[i + 3] = angular[i] / (mass * length);
    double t[6] = {};
    size_t n = 0; // of the upper triangle
    for (size_t i = 0; i < 6; ++i)
        for (size_t j = i; j < 6; ++j, ++n) {
            const double entry = static_cast<double>(body.full_inverse[n]);
            t[i] += entry * p[j];
            if (j != i) t[j] += entry * p[i];
        }
    return {{t[0], t[1], t[2]}, {t[3] / length, t[4] / length, t[5] / length}};
}

} // namespace lr
