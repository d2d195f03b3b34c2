// Scenes with contact really have contacts.
#include "support/determinism_scenes.h"

#include <string>

using namespace test;

TEST_CASE("in scenes with contact some bodies rest in the end and others move, and what lies in the way matters" *
          doctest::test_suite("exact")) {
    size_t found = 0;
    for (PlayedScene scene : played_scenes()) {
        if (scene.solids == Solids::none || scene.body_contact || scene.faulty) continue;
        ++found;
        CAPTURE(std::string(scene.name));
        Play play(scene, {});
        const uint64_t hash = play.run();
        const lr_world_info info = info_of(play.world);
        MESSAGE(std::string(scene.name), ": ", info.awake_count, " of ", info.body_count, " awake");
        CHECK(info.awake_count > info.body_count / 20);
        CHECK(info.awake_count + 10 <= info.body_count);
        scene.solids = scene.solids == Solids::ground ? Solids::edges : Solids::ground;
        CHECK(outcome(scene) != hash);
    }
    CHECK(found == 4);
}

TEST_CASE("in scenes of piles bodies touch each other, and that they meet matters" * doctest::test_suite("exact")) {
    size_t found = 0;
    for (PlayedScene scene : played_scenes()) {
        if (!scene.body_contact || scene.faulty) continue;
        ++found;
        CAPTURE(std::string(scene.name));
        Play play(scene, {});
        const uint64_t hash = play.run();
        MESSAGE(std::string(scene.name), ": ", info_of(play.world).awake_count, " of ", info_of(play.world).body_count,
                " awake");
        CHECK(info_of(play.world).awake_count > 0); // it has not come to rest before its end
        scene.body_contact = false;
        CHECK(outcome(scene) != hash);
    }
    CHECK(found == 7);
}
