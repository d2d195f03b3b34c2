#include "contact/ground_samples.h"

#include <algorithm>

namespace lr {
namespace {

Vector point(const BodyShape& s, uint32_t i) {
    return {s.x[i], s.y[i], s.z[i]};
}

// Twice the area of a face, and its middle.
float measure(const BodyShape& s, const ShapeFace& f, Vector& middle) {
    const Vector first = point(s, s.corners[f.first]);
    middle = {0.0f, 0.0f, 0.0f};
    Vector area{0.0f, 0.0f, 0.0f};
    const uint32_t count = f.count;
    for (uint32_t k = 0; k < count; ++k) {
        const Vector a = point(s, s.corners[f.first + k]), b = point(s, s.corners[f.first + (k + 1) % count]);
        middle = middle + a;
        area = area + cross(a - first, b - first);
    }
    middle = 1.0f / static_cast<float>(f.count) * middle;
    return length(area);
}

} // namespace

GroundSamples make_ground_samples(const BodyShape& s) {
    GroundSamples out{};
    out.count = s.count;
    std::copy_n(s.x, s.count, out.x);
    std::copy_n(s.y, s.count, out.y);
    std::copy_n(s.z, s.count, out.z);
    const auto add = [&](Vector p) {
        if (out.count == most_ground_samples) return;
        out.x[out.count] = p.x, out.y[out.count] = p.y, out.z[out.count] = p.z;
        ++out.count;
    };
    if (s.count == 0) return out;
    // Faces by their size; of a flat body both are the same.
    uint32_t order[most_shape_faces];
    float area[most_shape_faces];
    Vector middle[most_shape_faces];
    const bool flat = s.face_count == 2;
    const uint32_t faces = flat ? 1 : s.face_count;
    float total = 0.0f;
    for (uint32_t f = 0; f < faces; ++f) {
        order[f] = f;
        area[f] = measure(s, s.faces[f], middle[f]);
        total += area[f];
    }
    std::stable_sort(order, order + faces, [&](uint32_t a, uint32_t b) { return area[a] > area[b]; });
    for (uint32_t k = 0; k < faces && out.count < most_ground_samples; ++k) {
        const uint32_t f = order[k];
        if (area[f] < 0.05f * total) break;
        add(middle[f]);
        // Half way to some of its corners.
        const ShapeFace& face = s.faces[f];
        const uint32_t corners = face.count, stride = (corners + 7) / 8;
        for (uint32_t c = 0; c < corners; c += stride) add(0.5f * (middle[f] + point(s, s.corners[face.first + c])));
    }
    return out;
}

} // namespace lr
