// Recordings: writers that accept some calls, or refuse.
#include "fuzz/api/model.h"

namespace fuzz {
namespace {

int32_t take(void* user, const void* bytes, uint64_t size) {
    Writer& writer = *static_cast<Writer*>(user);
    if (writer.refused) defect("a recording", "goes on after `write` has refused");
    if (size == 0 || !bytes) defect("a recording", "writes nothing", static_cast<int64_t>(size));
    for (uint64_t i = 0; i < size; ++i) writer.sum += static_cast<const unsigned char*>(bytes)[i]; // reads all of it
    writer.refused = writer.left != 0 && --writer.left == 0;
    return writer.refused ? -1 : 0;
}

void start(Fuzzer& f) {
    World& w = f.world();
    Input& in = f.in;
    lr_recording_desc d = initialised(LR_CALL(lr_recording_desc_init));
    d.hash_interval = in.handle(0) % 4;
    in.change(d.flags, d.hash_interval, d.reserved);
    const bool writes = in.variant() != 3;
    d.write = writes ? take : nullptr;
    const Writer before = *w.writer;
    const bool on = w.recording && !before.refused;
    const uint32_t left = in.handle(1) < 128 ? 0 : in.handle(1) % 32u;
    d.user = w.writer.get();
    Expected e;
    if (!in.null(1)) {
        e.add_if(!writes, LR_ERROR_NULL_ARGUMENT);
        e.add_if((d.flags & ~lr_record_flags{LR_RECORD_CALLBACKS}) != 0 || d.reserved != 0, LR_ERROR_INVALID_ARGUMENT);
    }
    e.add_if(on, LR_ERROR_INVALID_ARGUMENT);
    e.may_if(left != 0, LR_ERROR_INVALID_ARGUMENT); // `write` refuses at once
    Given<lr_recording_desc> given(in, d, 1, e);
    Call call(f, w, "lr_world_record_start", e);
    if (!on && !e.fails()) *w.writer = {left, false, 0};
    if (call.ended(LR_CALL(lr_world_record_start)(call.world(), given.get())))
        w.recording = true;
    else if (!on)
        w.recording = false;
}

void stop(Fuzzer& f) {
    World& w = f.world();
    Expected e;
    if (w.writer->refused) w.recording = false;
    e.add_if(!w.recording, LR_ERROR_INVALID_ARGUMENT);
    e.may_if(w.writer->left != 0, LR_ERROR_INVALID_ARGUMENT); // `write` refuses the remaining bytes
    Call call(f, w, "lr_world_record_stop", e);
    if (call.ended(LR_CALL(lr_world_record_stop)(call.world())) || w.writer->refused) w.recording = false;
}

} // namespace

std::vector<Named> recording_operations() {
    return {{"record_start", start}, {"record_stop", stop}};
}

} // namespace fuzz
