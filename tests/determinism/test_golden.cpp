// Hashes that are held in the tree: the same on every machine, compiler and release, until the motion is meant to
// change. Then write them anew, and say so in the notes of the release:
//     LR_UPDATE_GOLDEN=1 tests_api --test-case="held hashes"
#include "support/played_scene.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>

using namespace test;

TEST_CASE("held hashes") {
    std::map<std::string, uint64_t> got;
    for (const PlayedScene& scene : played_scenes()) got[scene.name] = outcome(scene);
    if (std::getenv("LR_UPDATE_GOLDEN")) {
        std::ofstream file(LR_GOLDEN);
        file << "# Scene and hash after " << Play::frames << " frames; see test_golden.cpp.\n";
        for (const auto& [name, hash] : got) {
            char text[32];
            std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
            file << name << ' ' << text << '\n';
        }
        REQUIRE(file.good());
        MESSAGE("hashes were written");
    }
    std::map<std::string, uint64_t> held;
    std::ifstream file(LR_GOLDEN);
    for (std::string line; std::getline(file, line);) {
        const size_t space = line.find(' ');
        if (line.empty() || line[0] == '#' || space == std::string::npos) continue;
        held[line.substr(0, space)] = std::strtoull(line.c_str() + space, nullptr, 16);
    }
    REQUIRE(held.size() == got.size());
    for (const auto& scene : got) {
        CAPTURE(scene.first);
        CHECK(scene.second == held[scene.first]);
    }
}
