#include "world/kill_test.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

// Plain loops over one array of floats after the other: the compiler makes vectors of them. Masks are joined by & and
// not &&, which would be branches.
struct Places {
    const float* x;
    const float* y;
    const float* z;
    size_t count;
};

template <class Inside> void judge(const Places& p, uint32_t* cause, uint32_t code, bool outside, Inside&& inside) {
    for (size_t i = 0; i < p.count; ++i) {
        const bool in = inside(p.x[i], p.y[i], p.z[i]);
        cause[i] = in != outside ? code : cause[i];
    }
}

void judge_volume(const lr_kill_volume& v, const Places& p, uint32_t code, uint32_t* cause) {
    const bool outside = v.side == LR_KILL_OUTSIDE;
    const float cx = v.center[0], cy = v.center[1], cz = v.center[2];
    const float sx = v.size[0], sy = v.size[1], sz = v.size[2];
    switch (v.shape) {
    case LR_VOLUME_PLANE:
        return judge(p, cause, code, outside,
                     [=](float x, float y, float z) { return sx * (x - cx) + sy * (y - cy) + sz * (z - cz) < 0.0f; });
    case LR_VOLUME_BOX:
        return judge(p, cause, code, outside, [=](float x, float y, float z) {
            return (std::abs(x - cx) <= sx) & (std::abs(y - cy) <= sy) & (std::abs(z - cz) <= sz);
        });
    default:
        return judge(p, cause, code, outside, [=](float x, float y, float z) {
            const float a = x - cx, b = y - cy, c = z - cz;
            return a * a + b * b + c * c <= sx * sx;
        });
    }
}

} // namespace

const char* wrong_in(const lr_batch_rules& r) {
    const auto within = [](float value, float limit) { return value >= -limit && value <= limit; };
    if (r.action != LR_END_DESTROY && r.action != LR_END_RESPAWN) return "unknown action";
    if (!(r.max_age >= 0.0f && r.max_age <= 1e9f)) return "max_age is negative or too large";
    if (r.volume_count > LR_MAX_KILL_VOLUMES) return "more than LR_MAX_KILL_VOLUMES volumes";
    for (uint32_t k = 0; k < r.volume_count; ++k) {
        const lr_kill_volume& v = r.volumes[k];
        if (v.shape < LR_VOLUME_PLANE || v.shape > LR_VOLUME_SPHERE) return "unknown shape of a volume";
        if (v.side != LR_KILL_INSIDE && v.side != LR_KILL_OUTSIDE) return "unknown side of a volume";
        for (size_t i = 0; i < 3; ++i) {
            if (!within(v.center[i], 1e9f) || !within(v.size[i], 1e9f)) return "a volume reaches over 1e9 m";
            if (v.shape != LR_VOLUME_PLANE && v.size[i] < 0.0f) return "a volume's size is negative";
        }
        const bool flat = v.size[0] == 0.0f && v.size[1] == 0.0f && v.size[2] == 0.0f;
        if (v.shape == LR_VOLUME_PLANE && flat) return "a plane's normal is 0";
    }
    return nullptr;
}

bool all_finite(const lr_batch_rules& r) {
    bool finite = std::isfinite(r.max_age);
    for (uint32_t k = 0; k < std::min(r.volume_count, LR_MAX_KILL_VOLUMES); ++k)
        for (size_t i = 0; i < 3; ++i)
            finite = finite && std::isfinite(r.volumes[k].center[i]) && std::isfinite(r.volumes[k].size[i]);
    return finite;
}

uint32_t find_ended(const lr_batch_rules& rules, const BatchArrays& a, size_t begin, size_t end, uint32_t* cause) {
    const Places p{a.field[field_x] + begin, a.field[field_y] + begin, a.field[field_z] + begin, end - begin};
    const float* const age = a.field[field_age] + begin;
    cause += begin;
    std::fill_n(cause, p.count, uint32_t{cause_none});
    // The first of the causes counts: they are written over each other in reverse.
    for (uint32_t k = rules.volume_count; k-- > 0;) judge_volume(rules.volumes[k], p, cause_volume + k, cause);
    if (rules.max_age > 0.0f)
        for (size_t i = 0; i < p.count; ++i) cause[i] = age[i] >= rules.max_age ? uint32_t{cause_age} : cause[i];
    // x - x is 0 for finite x only.
    judge(p, cause, cause_not_finite, true,
          [](float x, float y, float z) { return (x - x) + (y - y) + (z - z) == 0.0f; });
    uint32_t ended = 0;
    for (size_t i = 0; i < p.count; ++i) ended += cause[i] != cause_none ? 1u : 0u;
    return ended;
}

} // namespace lr
