#include "baker/bake_progress.h"

#include <algorithm>
#include <string_view>

namespace lr::baker {

double overall_progress(const char* phase, double fraction) {
    struct Part {
        std::string_view phase;
        double begin, end;
    };
    constexpr Part parts[] = {{"reading", 0.0, 0.05},     {"checking", 0.05, 0.08},     {"mass", 0.08, 0.09},
                              {"hull", 0.09, 0.11},       {"aerodynamics", 0.11, 0.12}, {"added mass", 0.12, 0.8},
                              {"closed forms", 0.0, 0.1}, {"turbulence", 0.8, 1.0}};
    const double part = std::clamp(fraction, 0.0, 1.0);
    for (const Part& p : parts)
        if (phase == p.phase) return p.begin + part * (p.end - p.begin);
    return 0.0;
}
} // namespace lr::baker
