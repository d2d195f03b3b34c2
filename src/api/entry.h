// How calls on a world come in: whoever else is inside it is found, and what changes it is recorded, where that is asked for.
#pragma once

#include "api/inner.h"
#include "api/recorded_call.h"
#include "api/refuse.h"
#include "world/world.h"

namespace lr::api {

using record::Op;

// The world is the caller's as long as this lives, if `status` is LR_OK.
class Entry {
public:
    Entry(const lr_world& world, const char* function) : use_(world.use), status_(enter(world, function)) {}
    ~Entry() {
        if (status_ == LR_OK) use_.leave();
    }
    Entry(const Entry&) = delete;
    Entry& operator=(const Entry&) = delete;
    lr_status status() const { return status_; }

private:
    Use& use_;
    lr_status status_;
};

// Of a call that changes nothing.
template <class Inner> lr_status query(const lr_world* world, const char* function, Inner&& inner) {
    if (!world || !world->use.checked()) return inner();
    const Entry entry(*world, function);
    return entry.status() == LR_OK ? inner() : entry.status();
}

void end_recording(lr_world& world, const char* why); // why: null for no message

// Of one that may change the world. `tell` says a Call what its arguments are, and what came out. Those that name none of the caller's memory
// are recorded at once; others when the inner function says accepted(), or at the latest when it has succeeded: a call that is refused has
// perhaps read nothing, and is recorded without them.
template <class Inner, class Tell> lr_status change(lr_world* world, Op op, Inner&& inner, Tell&& tell) {
    const auto go = [&]() -> lr_status {
        record::Recorder* const recorder = world->recorder;
        if (!recorder) return inner();
        Call call(*recorder, op);
        const auto record = [&] { return call.arguments(tell); };
        if (call.names_memory(tell))
            recorder->wait_for(record);
        else
            record();
        const lr_status status = inner();
        if (status == LR_OK) recorder->accepted();
        recorder->wait_for_nothing();
        if (!call.recorded()) call.refused();
        call.result(tell, status, *world);
        if (recorder->failed()) end_recording(*world, "the recording's `write` has refused: it has ended");
        return status;
    };
    if (!world) return inner();
    if (!world->use.checked()) return go();
    const Entry entry(*world, record::name_of(op));
    return entry.status() == LR_OK ? go() : entry.status();
}

// Of calls whose arguments are plain: numbers, handles, single structs.
template <class... P, class... A>
lr_status plain_query(const lr_world* world, const char* function, lr_status (*inner)(const lr_world*, P...),
                      A... arguments) {
    return query(world, function, [&] { return inner(world, arguments...); });
}
template <class... P, class... A>
lr_status plain_change(lr_world* world, Op op, lr_status (*inner)(lr_world*, P...), A... arguments) {
    return change(
        world, op, [&] { return inner(world, arguments...); }, [&](Call& call) { (call.argument(arguments), ...); });
}

} // namespace lr::api
