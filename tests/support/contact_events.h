// Events of a world's last step.
#pragma once

#include "support/colliders.h"

#include <algorithm>
#include <vector>

namespace test {

inline lr_event_list event_list(const World& world) {
    lr_event_list list = initialised(lr_event_list_init);
    REQUIRE(lr_world_get_events(world.get(), &list) == LR_OK);
    return list;
}
inline std::vector<lr_event> events_of(const World& world) {
    const lr_event_list list = event_list(world);
    return {list.events, list.events + list.count};
}
inline size_t count_of(const std::vector<lr_event>& events, int32_t kind) {
    return static_cast<size_t>(
        std::count_if(events.begin(), events.end(), [&](const lr_event& e) { return e.kind == kind; }));
}
inline void keep_events(const World& world, uint32_t capacity = 1000, uint32_t kinds = LR_EVENTS_ALL) {
    REQUIRE(lr_world_set_events(world.get(), capacity, kinds) == LR_OK);
}
// Steps, at most `most` times, until an event of this kind; returns all events of these steps.
inline std::vector<lr_event> step_until(const World& world, int32_t kind, int most, float dt = 1.0f / 60.0f,
                                        uint32_t substeps = 4) {
    std::vector<lr_event> all;
    for (int i = 0; i < most; ++i) {
        REQUIRE(lr_world_step(world.get(), dt, substeps) == LR_OK);
        const std::vector<lr_event> now = events_of(world);
        all.insert(all.end(), now.begin(), now.end());
        if (count_of(now, kind) != 0) break;
    }
    return all;
}

} // namespace test
