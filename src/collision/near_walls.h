// Walls and ceilings beside a body: air does not flow into them. docs/maintainers/contact.md, section 19.
#pragma once

#include "collision/collider_contact_group.h"

namespace lr {

struct NearWalls {
    struct Wall {
        Vector normal;
        float share; // of the flow's component into the wall that is missing here, 0 to 1
        float speed; // m/s, of the wall along its normal
    };
    static constexpr uint32_t most = 3;
    uint32_t count;
    Wall wall[most];

    // The wind's component into a wall, m/s, not positive. A wall that retreats meets less of it; one that advances takes no more than there is.
    static float into(const Wall& w, Vector wind) {
        const float toward = dot(w.normal, wind);
        return std::min(std::max(toward, toward - w.speed), 0.0f);
    }
    bool met_by(Vector wind) const;
    // Takes its component into the walls from a flow, and the same share from each vector that `also` is called with.
    template <class Also> void turn(Vector& flow, Also&& also) const {
        for (const Wall* w = wall; w != wall + count; ++w) {
            const float toward = into(*w, flow);
            if (toward == 0.0f) continue;
            flow = flow - w->share * toward * w->normal;
            also([w](Vector v) { return v - w->share * dot(w->normal, v) * w->normal; });
        }
    }
};

// The flow that a body feels where others shelter it and walls turn the flow.
struct FeltFlow {
    float share; // of the wind's speed
    NearWalls walls;
};

// Beside a body as the substep begins. grounds: only planes and heightfields can be near.
NearWalls walls_near(const ContactStep& step, const BatchArrays& arrays, uint32_t body, bool grounds,
                     const ContactSubstep& substep);
} // namespace lr
