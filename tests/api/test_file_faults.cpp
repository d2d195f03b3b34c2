// The only file that the runtime reads, and threads that cannot be created: docs/maintainers/testing.md.
#include "support/counting_memory.h"
#include "support/scene.h"
#include "support/system_faults.h"

#if defined(__linux__)

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <thread>

using namespace test;

namespace {

const std::string fixture = LR_FIXTURES "/leaf.lrb";

lr_status load(const std::string& path, uint64_t* hash = nullptr) {
    lr_asset* asset = nullptr;
    const uint64_t live = global_live;
    const lr_status status = lr_asset_load_file(path.c_str(), &asset);
    const bool kept = global_live != live;
    CHECK((status == LR_OK) == (asset != nullptr));
    if (counts_global) CHECK(kept == (asset != nullptr));
    const Asset owned(asset);
    if (asset && hash) *hash = info_of(owned).content_hash;
    return status;
}

// The result of `body` as another user without rights, in its own process; -1 if that is impossible.
int as_nobody(const std::function<int()>& body) {
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        if (geteuid() == 0 && (setgid(65534) != 0 || setuid(65534) != 0)) _exit(255);
        _exit(body());
    }
    REQUIRE(child > 0);
    int status = 0;
    waitpid(child, &status, 0);
    REQUIRE(WIFEXITED(status));
    return WEXITSTATUS(status) == 255 ? -1 : WEXITSTATUS(status);
}

int running_threads() {
    int count = 0;
    for ([[maybe_unused]] const auto& task : std::filesystem::directory_iterator("/proc/self/task")) ++count;
    return count;
}

struct Folder {
    std::string path;
    Folder() {
        path = (std::filesystem::temp_directory_path() / "lr_faults-XXXXXX").string();
        REQUIRE(mkdtemp(path.data()) != nullptr);
        std::filesystem::permissions(path, std::filesystem::perms::all);
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
};

} // namespace

TEST_CASE("an asset file that is read in pieces, and interrupted, is the same asset") {
    uint64_t expected = 0, hash = 0;
    REQUIRE(load(fixture, &expected) == LR_OK);
    for (size_t most : {1u, 7u, 4096u})
        for (bool interrupted : {false, true}) {
            SystemFaults faults;
            faults.most = most;
            faults.interrupted = interrupted;
            faults.ends_after = SIZE_MAX;
            {
                const WithFaults armed(faults);
                CHECK(load(fixture, &hash) == LR_OK);
            }
            if (interrupted) CHECK(faults.reads > 2); // the reads were interrupted
            CHECK(hash == expected);
        }
}

TEST_CASE("an asset file that ends or breaks while it is read is a status") {
    const auto size = static_cast<size_t>(std::filesystem::file_size(fixture));
    for (size_t part = 0; part < 40; ++part) {
        SystemFaults faults;
        faults.most = 65536;
        faults.ends_after = size * part / 40;
        lr_status status = LR_OK;
        {
            const WithFaults armed(faults);
            status = load(fixture);
        }
        CAPTURE(part);
        CHECK((status == LR_ERROR_ASSET_FORMAT || status == LR_ERROR_ASSET_CORRUPT));
        for (int reason : {EIO, EISDIR, ESTALE, ENOMEM}) {
            faults.ends_after = size * part / 40;
            faults.broken_by = reason;
            const WithFaults armed(faults);
            status = load(fixture);
            CHECK(status == (reason == ENOMEM ? LR_ERROR_OUT_OF_MEMORY : LR_ERROR_FILE_READ));
        }
    }
}

TEST_CASE("an unreadable or invalid asset file gives a status without waiting") {
    const Folder folder;
    const std::string pipe = folder.path + "/pipe", secret = folder.path + "/secret.lrb", loop = folder.path + "/loop";
    REQUIRE(mkfifo(pipe.c_str(), 0666) == 0);
    std::filesystem::copy_file(fixture, secret);
    std::filesystem::permissions(secret, std::filesystem::perms::none);
    std::filesystem::create_symlink(loop, loop);
    CHECK(load(folder.path) == LR_ERROR_FILE_READ);
    CHECK(load(folder.path + "/") == LR_ERROR_FILE_READ);
    CHECK(load(folder.path + "/none.lrb") == LR_ERROR_FILE_NOT_FOUND);
    CHECK(load(fixture + "/leaf.lrb") == LR_ERROR_FILE_NOT_FOUND);
    CHECK(load("") == LR_ERROR_FILE_NOT_FOUND);
    CHECK(load(folder.path + "/" + std::string(300, 'x')) == LR_ERROR_FILE_READ);
    CHECK(load(loop) == LR_ERROR_FILE_READ);
    CHECK(load(pipe) == LR_ERROR_FILE_READ);
    CHECK(load("/dev/zero") == LR_ERROR_FILE_READ);
    CHECK(load("/dev/null") == LR_ERROR_FILE_READ);
    CHECK(load("/proc/self/stat") == LR_ERROR_ASSET_FORMAT); // size 0, but with contents
    const std::string huge = folder.path + "/huge.lrb";      // a hole, except the asset at its start
    std::filesystem::copy_file(fixture, huge);
    for (off_t size : {(off_t{1} << 30) + 1, off_t{1} << 40}) {
        if (truncate(huge.c_str(), size) != 0) continue; // not every file system has holes or such large files
        SystemFaults none_read;
        none_read.ends_after = 0;
        const WithFaults armed(none_read);
        CHECK((load(huge) == LR_ERROR_ASSET_CORRUPT && none_read.reads == 0));
    }
    const int denied = as_nobody([&] { return load(secret) == LR_ERROR_FILE_READ ? 7 : 1; });
    CHECK((denied == 7 || denied == -1));
    std::filesystem::permissions(folder.path, std::filesystem::perms::none);
    const int closed = as_nobody([&] { return load(folder.path + "/none.lrb") == LR_ERROR_FILE_READ ? 7 : 1; });
    CHECK((closed == 7 || closed == -1));
    std::filesystem::permissions(folder.path, std::filesystem::perms::all);
}

TEST_CASE("no file handles left: a status, and none is kept by a call that fails") {
    const int before = dup(0);
    REQUIRE(before >= 0);
    close(before);
    SystemFaults faults;
    faults.most = 100;
    faults.ends_after = 50;
    faults.broken_by = EIO;
    {
        const WithFaults armed(faults);
        CHECK(load(fixture) == LR_ERROR_FILE_READ);
    }
    rlimit limit{};
    REQUIRE(getrlimit(RLIMIT_NOFILE, &limit) == 0);
    const rlim_t normal = limit.rlim_cur;
    limit.rlim_cur = static_cast<rlim_t>(before);
    REQUIRE(setrlimit(RLIMIT_NOFILE, &limit) == 0);
    const lr_status status = load(fixture);
    limit.rlim_cur = normal;
    REQUIRE(setrlimit(RLIMIT_NOFILE, &limit) == 0);
    CHECK(status == LR_ERROR_FILE_READ);
    const int after = dup(0);
    CHECK(after == before);
    close(after);
    CHECK(load(fixture) == LR_OK);
}

TEST_CASE(
    "worker threads that cannot be started: LR_ERROR_THREADS, those that were have ended, and all memory is back") {
    std::thread([] {}).join(); // with the first thread, sanitizers start their own
    // A joined thread stays listed for a moment.
    const auto are_running = [](int count) {
        for (int tries = 0; tries < 2000 && running_threads() != count; ++tries)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return running_threads() == count;
    };
    const int threads = running_threads();
    for (int allowed = 0; allowed <= 5; ++allowed) {
        CAPTURE(allowed);
        CountingAllocator memory;
        lr_world_desc d = world_desc();
        d.allocator = memory.callbacks();
        d.worker_count = 5;
        lr_world* world = nullptr;
        SystemFaults faults;
        faults.threads_allowed = allowed;
        lr_status status = LR_OK;
        {
            const WithFaults armed(faults);
            status = lr_world_create(&d, &world);
        }
        const World owned(world);
        if (allowed == 5) {
            CHECK(status == LR_OK);
            continue;
        }
        CHECK(status == LR_ERROR_THREADS);
        CHECK(world == nullptr);
        CHECK(memory.live() == 0);
        CHECK_FALSE(memory.mismatch);
        CHECK(are_running(threads));
    }
    CHECK(are_running(threads));
}

TEST_CASE("a user without any more threads: LR_ERROR_THREADS, and a world without workers" *
          doctest::skip(!counts_global)) {
    const int result = as_nobody([] {
        const rlimit none{1, 1};
        if (setrlimit(RLIMIT_NPROC, &none) != 0) return 255;
        lr_world_desc d = world_desc();
        d.worker_count = 3;
        lr_world* world = nullptr;
        if (lr_world_create(&d, &world) != LR_ERROR_THREADS || world) return 1;
        d.worker_count = 0;
        if (lr_world_create(&d, &world) != LR_OK) return 2;
        const lr_status status = lr_world_step(world, 0.01f, 1);
        lr_world_destroy(world);
        return status == LR_OK ? 7 : 3;
    });
    CHECK((result == 7 || result == -1));
}

#endif
