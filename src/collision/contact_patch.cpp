#include "collision/contact_patch.h"

#include "base/float4.h"

#include <utility>

namespace lr {
namespace {

constexpr uint32_t lanes = Patch::lanes;

// Cuts a patch to at most `most` beyond the line through a place; `out` points across the line.
void cut(Patch& patch, float from_u, float from_v, float out_u, float out_v, float most) {
    alignas(16) float beyond[Patch::room];
    Float4 farthest = all(0.0f);
    for (uint32_t i = 0; i < patch.count; i += lanes) {
        const Float4 at = out_u * (load(patch.u + i) - from_u) + out_v * (load(patch.v + i) - from_v) - most;
        store(at, beyond + i);
        farthest = greater(at, farthest);
    }
    if (!(greatest(farthest) > 0.0f)) return;
    Patch before;
    before.count = std::exchange(patch.count, 0u);
    std::copy_n(patch.u, before.count, before.u);
    std::copy_n(patch.v, before.count, before.v);
    for (uint32_t i = 0; i < before.count; ++i) {
        if (beyond[i] <= 0.0f) patch.add(before.u[i], before.v[i]);
        const uint32_t next = i + 1 < before.count ? i + 1 : 0;
        if ((beyond[i] <= 0.0f) == (beyond[next] <= 0.0f) || (next == 0 && before.count == 2)) continue;
        const float part = beyond[i] / (beyond[i] - beyond[next]);
        patch.add(before.u[i] + part * (before.u[next] - before.u[i]),
                  before.v[i] + part * (before.v[next] - before.v[i]));
    }
    patch.pad();
}
} // namespace

void Side::set_edge(const Across& across, Vector from, Vector to) {
    const Vector way = to - from;
    const float du = dot(across.u, way), dv = dot(across.v, way), square = du * du + dv * dv;
    if (!(square > 0.0f)) return;
    const float rise = dot(across.normal, way) / square;
    slope_u = rise * du;
    slope_v = rise * dv;
    append(across, from);
    append(across, to);
}

// Clips by half planes (Sutherland and Hodgman 1974).
void lay_over(const Side& upper, const Side& lower, float slack, Patch& out) {
    const bool by_lower = lower.count >= 3;
    const Side &cut_by = by_lower ? lower : upper, &other = by_lower ? upper : lower;
    out.count = other.count;
    if (cut_by.count < 3) out.count = 0;
    std::copy_n(other.u, out.count, out.u);
    std::copy_n(other.v, out.count, out.v);
    out.pad();
    const float sense = cut_by.clockwise ? -1.0f : 1.0f;
    for (uint32_t i = 0; i < cut_by.count && out.count > 0; ++i) {
        const uint32_t next = i + 1 < cut_by.count ? i + 1 : 0;
        const float du = sense * (cut_by.u[next] - cut_by.u[i]), dv = sense * (cut_by.v[next] - cut_by.v[i]);
        cut(out, cut_by.u[i], cut_by.v[i], dv, -du, slack * (std::abs(du) + std::abs(dv)));
    }
    for (uint32_t i = 0; i < out.count; ++i)
        out.gap[i] = upper.height_at(out.u[i], out.v[i]) - lower.height_at(out.u[i], out.v[i]);
}
} // namespace lr
