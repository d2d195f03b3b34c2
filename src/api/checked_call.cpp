#include "api/checked_call.h"

namespace lr::api {
namespace {

lr_status run(const lr_world& world, const char* function, Ref<Outcome()> body) {
    const FloatMode mode;
    const char* why = nullptr;
    const lr_status status = guarded([&] {
        const Outcome outcome = body();
        why = outcome.why;
        return outcome.status;
    });
    if (status != LR_OK) world.log(LR_LOG_ERROR, function, why ? why : lr_status_string(status));
    return status;
}
} // namespace

lr_status query(const lr_world* world, const char* function, Ref<Outcome()> body) {
    if (!world) return note_refusal(function, {LR_ERROR_NULL_ARGUMENT, "world is null"});
    const Entry entry(*world, function);
    return entry.status() == LR_OK ? run(*world, function, body) : entry.status();
}

lr_status change(lr_world* world, const char* function, Record record, Ref<Outcome()> body) {
    if (!world) return note_refusal(function, {LR_ERROR_NULL_ARGUMENT, "world is null"});
    const Entry entry(*world, function);
    if (entry.status() != LR_OK) return entry.status();
    recording::Recorder* const recorder = world->recorder;
    if (!recorder) return run(*world, function, body);
    Call call(*recorder, function);
    const auto record_now = [&] { return call.arguments(record); };
    if (call.names_memory(record))
        recorder->wait_for(record_now);
    else
        record_now();
    const lr_status status = run(*world, function, body);
    if (status == LR_OK) recorder->accepted();
    recorder->wait_for_nothing();
    if (!call.recorded()) call.refused();
    call.result(record, status, *world);
    if (recorder->failed()) end_recording(*world, "the recording has ended: its `write` returned an error");
    return status;
}
} // namespace lr::api
