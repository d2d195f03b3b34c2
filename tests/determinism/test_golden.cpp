// Hashes stored in the tree: the same on every machine, compiler and release, until the motion changes intentionally.
// Then write them again, and say so in the notes of the release:
//     LR_UPDATE_GOLDEN=1 tests_determinism --test-case="held hashes"
#include "support/determinism_scenes.h"
#include "support/threads.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <string>

using namespace test;

namespace {

// On every core, because an emulator of another processor is slow.
std::map<std::string, uint64_t> outcomes() {
    const std::vector<PlayedScene> scenes = played_scenes();
    std::vector<uint64_t> hashes(scenes.size());
    std::atomic<size_t> next = 0;
    const auto play = [&] {
        for (size_t at = next++; at < scenes.size(); at = next++) hashes[at] = outcome(scenes[at]);
    };
#if LR_TEST_THREADS
    {
        std::vector<std::jthread> threads;
        for (uint32_t i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i) threads.emplace_back(play);
    }
#else
    play();
#endif
    std::map<std::string, uint64_t> out;
    for (size_t i = 0; i < scenes.size(); ++i) out[scenes[i].name] = hashes[i];
    return out;
}

} // namespace

TEST_CASE("held hashes" * doctest::test_suite("exact")) {
    const std::map<std::string, uint64_t> got = outcomes();
    if (std::getenv("LR_UPDATE_GOLDEN")) {
        std::ofstream file(LR_GOLDEN);
        file << "# Scene and hash after " << PlayedScene{}.frames << " frames; see test_golden.cpp.\n";
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
    CHECK(held.size() == got.size());
    for (const auto& scene : got) {
        CAPTURE(scene.first);
        CHECK(held.count(scene.first) == 1);
        CHECK(scene.second == held[scene.first]);
    }
    // A hash that is always the same would pass all tests of equal bits.
    std::set<uint64_t> different;
    for (const auto& scene : got) different.insert(scene.second);
    CHECK(different.size() == got.size());
}
