#include "world/rules.h"

#include "kernel/limits.h"

#include <algorithm>
#include <cmath>

namespace lr {

const char* wrong_in(const lr_batch_rules& r) {
    if (r.action != LR_END_DESTROY && r.action != LR_END_RESPAWN) return "unknown action";
    if (!(r.max_age >= 0.0f && r.max_age <= most_age)) return "max_age is negative or too large";
    if (r.volume_count > LR_MAX_KILL_VOLUMES) return "more than LR_MAX_KILL_VOLUMES volumes";
    for (uint32_t k = 0; k < r.volume_count; ++k) {
        const lr_kill_volume& v = r.volumes[k];
        if (v.shape < LR_VOLUME_PLANE || v.shape > LR_VOLUME_SPHERE) return "unknown shape of a volume";
        if (v.side != LR_KILL_INSIDE && v.side != LR_KILL_OUTSIDE) return "unknown side of a volume";
        if (!within(v.center, most_place) || !within(v.size, most_place)) return "a volume reaches over 1e9 m";
        for (size_t i = 0; i < 3; ++i) {
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

} // namespace lr
