// lr_replay itself: its exit codes.
#include "tools/lr_replay/recording.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#if defined(LR_REPLAY_PATH) && !defined(_WIN32)
#include <sys/wait.h>

using namespace test;

TEST_CASE("lr_replay ends with 0, 1, 2 or 3") {
    const Asset flat = leaf();
    const World world = make(world_desc());
    Recording recording;
    recording.start(world);
    const lr_body body = add_body(world, add_batch(world, flat, 4), body_desc());
    steps(world, 3, 0.01f);
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("lr_replay " + std::to_string(reinterpret_cast<uintptr_t>(&body)));
    std::filesystem::create_directory(folder);
    const std::string file = (folder / "a recording").string(), table = (folder / "path.csv").string();
    const auto run = [&](const std::vector<unsigned char>& bytes, const std::string& options) {
        std::ofstream(file, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        const std::string command = "'" LR_REPLAY_PATH "' '" + file + "' " + options + " >/dev/null 2>&1";
        const int status = std::system(command.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    };
    CHECK(run(recording.bytes, "") == 0);
    CHECK(run(recording.bytes,
              std::string("--workers 2 --print --simd ") + lr_simd_target_name(simd_targets().back())) == 0);
    CHECK(run(recording.bytes, "--until 2 --csv '" + table + "' --body " + std::to_string(body.id)) == 0);
    CHECK(std::filesystem::file_size(table) > 30);
    CHECK(run(recording.bytes, "--until 0") == 0);
    CHECK(run(recording.bytes, "--until -1") == 3);
    CHECK(run(recording.bytes, "--csv '" + table + "' --body ''") == 3);
    CHECK(run(recording.bytes, "--csv '" + file + "' --body 1") == 3);
    CHECK(run(recording.bytes, "--body 1") == 3);                      // what for?
    CHECK(std::filesystem::file_size(file) == recording.bytes.size()); // not overwritten
    std::vector<unsigned char> damaged = recording.bytes;
    damaged[100] ^= 1;
    CHECK(run(damaged, "") == 2);
    CHECK(run(recording.bytes, "--simd MMX") == 3);
    CHECK(run(recording.bytes, "--unknown") == 3);
    CHECK(run(recording.bytes, "--csv /nowhere/at/all --body 1") == 3);
    // Its last hash differs.
    std::vector<unsigned char> other = recording.bytes;
    size_t at = sizeof(lr::recording::FileHeader), last = 0;
    uint64_t frame = 0;
    lr::recording::FrameHeader h;
    for (; at < other.size(); at += sizeof h + h.size, ++frame) {
        std::memcpy(&h, other.data() + at, sizeof h);
        last = at;
    }
    std::memcpy(&h, other.data() + last, sizeof h);
    other[last + sizeof h + offsetof(lr::recording::ResultRecord, hash)] ^= 1;
    h.checksum = lr::recording::frame_checksum(h, frame - 1, other.data() + last + sizeof h);
    std::memcpy(other.data() + last, &h, sizeof h);
    CHECK(run(other, "") == 1);
    std::filesystem::remove_all(folder);
}

TEST_CASE("lr_replay prints the ids of bodies, and says whether the body of a path was there") {
    const Asset flat = leaf();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, flat, 8);
    lr_emitter_desc emitter = initialised(lr_emitter_desc_init);
    REQUIRE(lr_batch_set_emitter(world.get(), batch, &emitter) == LR_OK);
    Recording recording;
    recording.start(world);
    lr_body bodies[5];
    REQUIRE(lr_batch_spawn(world.get(), batch, 3, bodies) == LR_OK);
    REQUIRE(lr_body_destroy(world.get(), bodies, 2) == LR_OK);
    REQUIRE(lr_batch_spawn(world.get(), batch, 5, bodies) == LR_OK);
    steps(world, 1, 0.01f);
    std::ostringstream text, csv;
    lr::replay::Options options;
    options.print = &text;
    options.csv = &csv;
    options.body = {1};
    CHECK_FALSE(recording.play(options).body);
    options.body = bodies[4];
    CHECK(recording.play(options).body);
    // Runs of ids: their ends are shown.
    for (size_t i = 0; i < 5; ++i) {
        const bool begins = i == 0 || bodies[i].id != bodies[i - 1].id + 1;
        const bool ends = i == 4 || bodies[i + 1].id != bodies[i].id + 1;
        char id[24];
        std::snprintf(id, sizeof id, "0x%016llx", static_cast<unsigned long long>(bodies[i].id));
        CAPTURE(text.str());
        CHECK((text.str().find(id) != std::string::npos) == (begins || ends));
    }
}
#endif
