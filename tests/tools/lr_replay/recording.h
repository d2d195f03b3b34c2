// A recording in memory, and its replay.
#pragma once

#include "support/scene.h"
#include "tools/lr_replay/player.h"
#include "tools/lr_replay/replay_faults.h"

namespace test {

struct Recording {
    std::vector<unsigned char> bytes;
    uint64_t refuse_at = UINT64_MAX; // counts calls of `write` from 0
    uint64_t calls = 0;

    lr_recording_desc desc() {
        lr_recording_desc d = initialised(lr_recording_desc_init);
        d.user = this;
        d.write = [](void* user, const void* from, uint64_t size) -> int32_t {
            auto& self = *static_cast<Recording*>(user);
            if (self.calls++ >= self.refuse_at) return 1;
            const auto* const at = static_cast<const unsigned char*>(from);
            self.bytes.insert(self.bytes.end(), at, at + size);
            return 0;
        };
        return d;
    }
    void start(const World& world) {
        const lr_recording_desc d = desc();
        REQUIRE(lr_world_record_start(world.get(), &d) == LR_OK);
    }
    lr::replay::Outcome play(const lr::replay::Options& options = {}) const {
        return lr::replay::play(bytes.data(), bytes.size(), options);
    }
};

// The first problem, or empty.
inline std::string wrong_in(const lr::replay::Outcome& o) {
    if (!o.difference) return "";
    return "call " + std::to_string(o.difference->call) + ", step " + std::to_string(o.difference->step) + ": " +
           o.difference->what;
}
// The fault of a refused recording; 0: none.
inline int fault_of(const std::vector<unsigned char>& bytes, uint64_t until = UINT64_MAX) {
    lr::replay::Options o;
    o.until = until;
    o.most_memory = uint64_t{64} << 20;
    try {
        lr::replay::play(bytes.data(), bytes.size(), o);
    } catch (const lr::replay::Fault& fault) {
        return static_cast<int>(fault.id);
    }
    return 0;
}

} // namespace test
