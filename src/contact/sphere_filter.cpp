#include "contact/sphere_filter.h"

namespace lr {
namespace {

// Of the distance: more than what single precision takes from it here.
constexpr float rounding = 2e-6f;

float size_of(float x) {
    return x < 0.0f ? -x : x;
}

} // namespace

bool filter_bodies(const RayFilter& f, const BatchArrays& arrays, uint32_t begin, uint32_t end,
                   uint32_t (&marks)[filter_block]) {
    const float *const x = arrays.field[field_x] + begin, *const y = arrays.field[field_y] + begin,
                       *const z = arrays.field[field_z] + begin, *const scale = arrays.field[field_scale] + begin;
    const float ox = f.origin[0], oy = f.origin[1], oz = f.origin[2];
    const float dx = f.direction[0], dy = f.direction[1], dz = f.direction[2];
    uint32_t any = 0;
    for (uint32_t i = 0; i < end - begin; ++i) {
        const float px = x[i] - ox, py = y[i] - oy, pz = z[i] - oz;
        const float reach = f.reach * scale[i] + rounding * (size_of(px) + size_of(py) + size_of(pz));
        const float along = px * dx + py * dy + pz * dz;
        const float cx = py * dz - pz * dy, cy = pz * dx - px * dz, cz = px * dy - py * dx;
        const bool near = cx * cx + cy * cy + cz * cz <= reach * reach;
        const uint32_t mark = static_cast<uint32_t>(near) & static_cast<uint32_t>(along >= -reach) &
                              static_cast<uint32_t>(along <= f.most + reach);
        marks[i] = mark;
        any |= mark;
    }
    return any != 0;
}

bool filter_bodies(const SphereFilter& f, const BatchArrays& arrays, uint32_t begin, uint32_t end,
                   uint32_t (&marks)[filter_block]) {
    const float *const x = arrays.field[field_x] + begin, *const y = arrays.field[field_y] + begin,
                       *const z = arrays.field[field_z] + begin, *const scale = arrays.field[field_scale] + begin;
    uint32_t any = 0;
    for (uint32_t i = 0; i < end - begin; ++i) {
        const float px = x[i] - f.middle[0], py = y[i] - f.middle[1], pz = z[i] - f.middle[2];
        const float reach =
            f.radius + f.reach * scale[i] + rounding * (size_of(px) + size_of(py) + size_of(pz) + f.radius);
        const auto mark = static_cast<uint32_t>(px * px + py * py + pz * pz <= reach * reach);
        marks[i] = mark;
        any |= mark;
    }
    return any != 0;
}

} // namespace lr
