// Every scene, recorded from the start and from the middle, replays to the same hashes.
#include "support/determinism_scenes.h"
#include "support/quick.h"
#include "support/threads.h" // workers
#include "tools/lr_replay/recording.h"

using namespace test;

TEST_CASE(
    "scenes are recorded without a change of their bits, and played again with other workers and instruction sets" *
    doctest::test_suite("long")) {
    const std::vector<int32_t> targets = simd_targets();
    size_t number = 0;
    for (PlayedScene& scene : played_scenes()) {
        scene.frames = std::min(scene.frames, 20);
        if (quick()) {
            if (number++ % 4 != 0) continue;
            scene.frames = 8;
        }
        CAPTURE(std::string(scene.name));
        const uint64_t expected = outcome(scene);
        for (int at : {-1, scene.frames / 2}) {
            CAPTURE(at);
            Recording recording;
            const lr_recording_desc d = recording.desc();
            REQUIRE(outcome(scene, {.workers = 2, .recording = &d, .record_at = at}) == expected);
            lr::replay::Options options;
            options.simd = targets[number++ % targets.size()];
            options.workers = static_cast<uint32_t>(number % 3);
            const lr::replay::Outcome played = recording.play(options);
            CHECK(wrong_in(played) == "");
            CHECK(played.hash == expected);
            const auto frames = static_cast<uint64_t>(scene.frames - std::max(at, 0));
            CHECK(played.steps == frames);
            CHECK(played.hashes == frames);
            CHECK(played.first_step == static_cast<uint64_t>(std::max(at, 0)));
            CHECK_FALSE(played.cut);
            CHECK(played.within == "");
        }
    }
}
