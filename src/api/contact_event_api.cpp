#include "api/refuse.h"
#include "world/world.h"

namespace {

using namespace lr::api;

} // namespace

extern "C" {

lr_status lr_inner_world_set_contact_events(lr_world* world, uint32_t capacity, uint32_t kinds) {
    constexpr const char* name = "lr_world_set_contact_events";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    if ((kinds & ~LR_EVENTS_ALL) != 0) return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, "unknown kinds of events");
    if (capacity != 0 && kinds == 0)
        return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, "no kind of event is wanted");
    const lr_status status = world->set_contact_events(capacity, kinds);
    return status == LR_OK ? status : refuse(world, name, status);
}

lr_status lr_contact_event_list_init(lr_contact_event_list* list, uint32_t struct_size) {
    return begin_init(list, struct_size);
}

lr_status lr_inner_world_get_contact_events(const lr_world* world, lr_contact_event_list* list) {
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    const lr_status status = check_size(list);
    if (status != LR_OK) return refuse(world, "lr_world_get_contact_events", status);
    const lr::EventList& from = world->contact_events;
    lr_contact_event_list out{};
    out.count = from.count;
    out.events = from.events.data();
    out.lost = from.lost;
    out.total_lost = from.total_lost;
    write_struct(out, list);
    return LR_OK;
}

} // extern "C"
