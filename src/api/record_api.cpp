#include "api/entry.h"
#include "api/refuse.h"
#include "record/recorder.h"

namespace lr::api {

void end_recording(lr_world& world, const char* why) {
    world.recorder->end(world);
    record::Recorder::destroy(world.recorder);
    world.recorder = nullptr;
    if (why) world.log(LR_LOG_WARNING, "lr_world_record_start", why);
}

} // namespace lr::api

namespace {

using namespace lr::api;

lr_status start(lr_world& world, const lr_recording_desc* desc) {
    constexpr const char* name = "lr_world_record_start";
    lr_recording_desc d;
    lr_status status = read_struct(desc, d);
    if (status != LR_OK) return refuse(&world, name, status);
    if (!d.write) return refuse(&world, name, LR_ERROR_NULL_ARGUMENT, "desc->write is null");
    if ((d.flags & ~LR_RECORD_CALLBACKS) != 0 || d.reserved != 0)
        return refuse(&world, name, LR_ERROR_INVALID_ARGUMENT, "unknown flags, or reserved is not 0");
    if (world.recorder) return refuse(&world, name, LR_ERROR_INVALID_ARGUMENT, "the world is being recorded");
    lr::record::Recorder* const recorder = lr::record::Recorder::create(world.allocator, d);
    if (!recorder) return refuse(&world, name, LR_ERROR_OUT_OF_MEMORY);
    status = guarded([&] { return recorder->begin(world); });
    if (status == LR_OK) {
        world.recorder = recorder;
        return status;
    }
    lr::record::Recorder::destroy(recorder);
    return refuse(&world, name, status, status == LR_ERROR_INVALID_ARGUMENT ? "`write` has refused" : nullptr);
}

} // namespace

extern "C" {

lr_status lr_recording_desc_init(lr_recording_desc* desc, uint32_t struct_size) {
    const lr_status status = begin_init(desc, struct_size);
    if (status != LR_OK) return status;
    desc->flags = LR_RECORD_CALLBACKS;
    desc->hash_interval = 1;
    return LR_OK;
}

lr_status lr_world_record_start(lr_world* world, const lr_recording_desc* desc) {
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    return query(world, "lr_world_record_start", [&] {
        const lr::FloatMode mode;
        return start(*world, desc);
    });
}

lr_status lr_world_record_stop(lr_world* world) {
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    return query(world, "lr_world_record_stop", [&] {
        if (!world->recorder)
            return refuse(world, "lr_world_record_stop", LR_ERROR_INVALID_ARGUMENT, "no recording is under way");
        end_recording(*world, nullptr);
        return LR_OK;
    });
}

} // extern "C"
