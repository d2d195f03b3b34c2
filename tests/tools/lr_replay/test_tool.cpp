// lr_replay itself: its exit codes.
#include "tools/lr_replay/recording.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

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
#endif
