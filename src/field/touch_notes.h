// What is noted of contact while bodies are stepped, for the events of the step.
#pragma once

#include "contact/contact_group.h"
#include "langevin_rigid.h"
#include "world/handles.h"

#include <cstdint>

namespace lr {

inline constexpr uint32_t most_touches = 4; // colliders of a body that count
inline constexpr uint32_t stay_rows = 7;    // of ContactArrays::stay

// What a body touches: the slot of a collider + 1, or this for other bodies, however many; 0: nothing.
inline constexpr uint32_t touching_body = UINT32_MAX;
static_assert(LR_MAX_COLLIDERS < touching_body);
inline bool is_collider(uint32_t touched) {
    return touched != 0 && touched != touching_body;
}

struct Meetings {
    Touch touch[most_touches]; // unused ones last
};

// By slot of the body. Each is written by the thread that steps the body. Null arrays: nothing is noted.
struct TouchNotes {
    const lr_body* ids = nullptr; // by dense index
    uint8_t* noted = nullptr;     // noted_* bits
    Meetings* met = nullptr;      // of the step
    bool all = false;             // whatever is touched may not be what was

    uint32_t slot(uint32_t index) const { return unpack(ids[index]).slot; }
};

enum Note : uint8_t { noted_touch = 1, noted_landing = 2, noted_waking = 4, noted_fault = 8 };

} // namespace lr
