// A snapshot between processes, also of different processors: tests/snapshot_travel/check.sh.
//     snapshot_file targets                instruction sets that this processor can run, by number
//     snapshot_file save FILE [TARGET]     saves the scene; prints its hash now and after more steps
//     snapshot_file resume FILE [TARGET]   restores it and prints the same two hashes
// SPDX-License-Identifier: MIT
#include "support/travelling_scene.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

int fail(const char* what) {
    std::fprintf(stderr, "snapshot_file: %s\n", what);
    return 1;
}

bool write(const char* path, const std::vector<unsigned char>& bytes) {
    std::FILE* const file = std::fopen(path, "wb");
    if (!file) return false;
    const bool whole = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    return std::fclose(file) == 0 && whole;
}

std::vector<unsigned char> read(const char* path) {
    std::vector<unsigned char> bytes;
    std::FILE* const file = std::fopen(path, "rb");
    if (!file) return bytes;
    unsigned char part[4096];
    for (size_t n; (n = std::fread(part, 1, sizeof part, file)) > 0;) bytes.insert(bytes.end(), part, part + n);
    std::fclose(file);
    return bytes;
}

} // namespace

int main(int argc, char** argv) {
    if (argc == 2 && std::strcmp(argv[1], "targets") == 0) {
        int32_t targets[16] = {};
        uint32_t count = 0;
        if (lr_simd_targets(targets, 16, &count) != LR_OK) return fail("no instruction sets");
        for (uint32_t i = 0; i < count; ++i) std::printf("%d\n", targets[i]);
        return 0;
    }
    const bool saving = argc >= 3 && std::strcmp(argv[1], "save") == 0;
    if (argc < 3 || argc > 4 || (!saving && std::strcmp(argv[1], "resume") != 0))
        return fail("usage: snapshot_file targets | save FILE [TARGET] | resume FILE [TARGET]");
    test::TravellingScene scene(argc == 4 ? std::atoi(argv[3]) : LR_SIMD_AUTO, saving);
    if (!scene.good()) return fail("no scene");
    if (saving) {
        if (!write(argv[2], scene.save())) return fail("the file cannot be written");
    } else {
        const std::vector<unsigned char> bytes = read(argv[2]);
        if (bytes.empty()) return fail("the file cannot be read");
        const lr_status status = lr_world_snapshot_restore(scene.world(), bytes.data(), bytes.size());
        if (status != LR_OK) return fail(lr_status_string(status));
    }
    const uint64_t then = scene.hash(), later = scene.go_on();
    if (!scene.good()) return fail("the scene does not go on");
    std::printf("%016llx %016llx\n", static_cast<unsigned long long>(then), static_cast<unsigned long long>(later));
    return 0;
}
