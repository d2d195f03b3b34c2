// Unreadable or unwritable files, and killed bakes: docs/maintainers/testing.md.
#include "asset/asset_file.h"
#include "baker/file_io.h"
#include "json.h"
#include "mesh_shapes.h"
#include "scratch.h"
#include "support/system_faults.h"

#include <doctest/doctest.h>

#if defined(__linux__)

#include <sys/file.h>
#include <sys/mount.h>

#include <cerrno>
#include <cstdlib>

using namespace lr;
using namespace lr::baker;
using lr::test::Outcome;
using lr::test::Scratch;
using ::test::SystemFaults;
using ::test::WithFaults;

namespace {

const std::string old_text(3000, 'o'), new_text(5000, 'n');

// An existing asset and report, and missing pictures.
struct Outputs {
    const Scratch& scratch;
    std::vector<std::string> names{"a.lrb", "a.json", "a.svg"};

    explicit Outputs(const Scratch& in) : scratch(in) { reset(); }
    void reset() const {
        for (const std::string& name : scratch.names()) std::filesystem::remove(scratch.path(name));
        scratch.write(names[0], old_text);
        scratch.write(names[1], old_text);
    }
    bool write(Faults& faults) const {
        std::vector<OutputFile> files;
        for (const std::string& name : names)
            files.push_back({scratch.path(name), {reinterpret_cast<const uint8_t*>(new_text.data()), new_text.size()}});
        return write_files(files, faults);
    }
    // Number of new files. Each must be complete, and there must be no others, except abandoned temporary files.
    size_t new_ones(bool aside) const {
        size_t count = 0;
        for (const std::string& name : scratch.names()) {
            if (name.starts_with(".lr_bake-") && name.ends_with(".part")) {
                CHECK(aside);
                continue;
            }
            const std::string text = scratch.read(name);
            CHECK((text == new_text || (text == old_text && name != names[2])));
            count += text == new_text;
        }
        CHECK(scratch.has(names[0]));
        CHECK(scratch.has(names[1]));
        return count;
    }
    size_t left_aside() const {
        size_t count = 0;
        for (const std::string& name : scratch.names()) count += name.starts_with(".lr_bake-");
        return count;
    }
};

struct Trouble {
    int kill_after_microseconds = -1;
    bool without_rights = false; // as another user; exit code 126 if that is impossible
};

// Exit code 128 + signal if killed. Its output is outside of its working folder.
Outcome lr_bake(const std::vector<std::string>& arguments, const Trouble& trouble = {}) {
    const Scratch captured;
    const std::string err = captured.write("err", "");
    std::string program = LR_BAKE_PATH;
    std::vector<std::string> strings = arguments;
    std::vector<char*> argv{program.data()};
    for (std::string& a : strings) argv.push_back(a.data());
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        for (const int s : {SIGINT, SIGTERM, SIGSEGV, SIGFPE, SIGILL, SIGABRT}) signal(s, SIG_DFL);
        const int file = open(err.c_str(), O_WRONLY), null = open("/dev/null", O_RDWR);
        if (file < 0 || null < 0) _exit(127);
        dup2(null, 0), dup2(null, 1), dup2(file, 2);
        if (trouble.without_rights && geteuid() == 0 && (setgid(65534) != 0 || setuid(65534) != 0)) _exit(126);
        execv(program.c_str(), argv.data());
        _exit(126);
    }
    REQUIRE(child > 0);
    if (trouble.kill_after_microseconds >= 0) {
        usleep(static_cast<useconds_t>(trouble.kill_after_microseconds));
        kill(child, SIGKILL);
    }
    int status = 0;
    waitpid(child, &status, 0);
    Outcome outcome;
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    outcome.err = captured.read("err");
    return outcome;
}
bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}
bool good_asset(const std::string& bytes) {
    AssetData asset;
    Faults faults;
    return read_asset(bytes.data(), bytes.size(), asset, faults);
}

} // namespace

TEST_CASE(
    "any call of the system that fails while files are written: fault 103, the old files, and nothing beside them") {
    const Scratch scratch;
    const Outputs outputs(scratch);
    for (bool without_nameless : {false, true})
        for (int reason : {ENOSPC, EIO, EDQUOT, EACCES, EROFS}) {
            int calls = 1;
            for (int n = 0; n < calls; ++n) {
                CAPTURE(without_nameless);
                CAPTURE(n);
                CAPTURE(reason);
                SystemFaults system;
                system.without_nameless = without_nameless;
                {
                    Faults faults;
                    const WithFaults armed(system);
                    REQUIRE(outputs.write(faults));
                }
                calls = system.calls;
                outputs.reset();
                system.calls = 0;
                system.fail_at = n;
                system.reason = reason;
                Faults faults;
                bool written = false;
                {
                    const WithFaults armed(system);
                    written = outputs.write(faults);
                }
                // The nameless file is only the first attempt, and flushing the folder can be refused.
                if (written) {
                    CHECK(outputs.new_ones(false) == 3);
                } else {
                    REQUIRE(faults.size() == 1);
                    CHECK(faults[0].id == FaultId::file_write);
                    CHECK(faults[0].where.starts_with(scratch.path("a.")));
                    CHECK(contains(faults[0].what, std::generic_category().message(reason)));
                    CHECK_FALSE(faults[0].remedy.empty());
                    const size_t renamed = outputs.new_ones(false);
                    // Renames come last, file by file, the asset first.
                    CHECK(renamed < 3);
                    if (renamed != 0) CHECK(scratch.read("a.lrb") == new_text);
                    if (n < calls / 2) CHECK(renamed == 0);
                }
                outputs.reset();
            }
            CHECK(calls >= 12);
        }
}

TEST_CASE("writes that are short and interrupted, and a disk that is full from any call on") {
    const Scratch scratch;
    const Outputs outputs(scratch);
    SystemFaults system;
    system.short_writes = true;
    {
        Faults faults;
        const WithFaults armed(system);
        CHECK(outputs.write(faults));
    }
    CHECK(system.calls > 60);
    CHECK(outputs.new_ones(false) == 3);
    for (int n = 0; n < 12; ++n) {
        outputs.reset();
        SystemFaults full;
        full.fail_at = n;
        full.fail_after = true;
        full.reason = ENOSPC;
        Faults faults;
        {
            const WithFaults armed(full);
            CHECK_FALSE(outputs.write(faults));
        }
        CHECK(faults[0].remedy == "Free some space there, or write elsewhere.");
        outputs.new_ones(false);
    }
}

TEST_CASE("a process that is killed in any call of the system leaves whole files, and what it leaves aside the next "
          "one removes") {
    const Scratch scratch;
    const Outputs outputs(scratch);
    size_t left = 0;
    for (bool without_nameless : {false, true}) {
        bool finished = false;
        for (int n = 0; !finished; ++n) {
            CAPTURE(without_nameless);
            CAPTURE(n);
            REQUIRE(n < 100);
            outputs.reset();
            const pid_t child = fork();
            if (child == 0) {
                SystemFaults system;
                system.without_nameless = without_nameless;
                system.fail_at = n;
                const WithFaults armed(system);
                Faults faults;
                _exit(outputs.write(faults) ? 0 : 1);
            }
            REQUIRE(child > 0);
            int status = 0;
            waitpid(child, &status, 0);
            finished = WIFEXITED(status);
            CHECK((finished ? WEXITSTATUS(status) == 0 : WTERMSIG(status) == SIGKILL));
            const size_t renamed = outputs.new_ones(true);
            if (finished) CHECK(renamed == 3);
            left += outputs.left_aside();
            clear_abandoned(scratch.path("a.lrb"));
            CHECK(outputs.left_aside() == 0);
            CHECK(outputs.new_ones(false) == renamed);
        }
    }
    CHECK(left > 3); // otherwise the test has shown nothing
}

TEST_CASE("files that another process still writes are not removed, nor similar names") {
    const Scratch scratch;
    const std::string live = scratch.write(".lr_bake-1-0.part", "live"),
                      dead = scratch.write(".lr_bake-1-1.part", "dead");
    scratch.write("lr_bake-1-1.part", "another's");
    scratch.write(".lr_bake-notes", "another's");
    std::filesystem::create_directory(scratch.path(".lr_bake-2-0.part"));
    std::filesystem::create_symlink(scratch.path("lr_bake-1-1.part"), scratch.path(".lr_bake-3-0.part"));
    const int held = open(live.c_str(), O_RDONLY | O_CLOEXEC);
    REQUIRE(held >= 0);
    REQUIRE(flock(held, LOCK_EX) == 0);
    clear_abandoned(scratch.path("out.lrb"));
    std::vector<std::string> expected{".lr_bake-1-0.part", ".lr_bake-2-0.part", ".lr_bake-3-0.part", ".lr_bake-notes",
                                      "lr_bake-1-1.part"};
    CHECK(scratch.names() == expected);
    close(held);
    clear_abandoned(scratch.path("")); // as a folder
    expected.erase(expected.begin());
    CHECK(scratch.names() == expected);
    clear_abandoned(scratch.path("none/out.lrb"));
    clear_abandoned("/dev/null");
    clear_abandoned("");
}

TEST_CASE("lr_bake: killed at any moment, it leaves the old asset or the new one, and the next bake cleans up") {
    const Scratch scratch;
    const std::string out = scratch.path("out.lrb"), report = scratch.path("r.json");
    const std::vector<std::string> arguments{"ellipsoid", "0.04",     "0.02", "0.01",   "-o",
                                             out,         "--report", report, "--quiet"};
    REQUIRE(lr_bake({"ellipsoid", "0.03", "0.02", "0.01", "-o", out, "--report", report, "--quiet"}).exit_code == 0);
    const std::string before = scratch.read("out.lrb");
    scratch.write(".lr_bake-1-0.part", "left by one");
    int killed = 0;
    uint32_t random = 12345;
    for (int i = 0; i < 40; ++i) {
        random = random * 1664525u + 1013904223u;
        Trouble options;
        options.kill_after_microseconds = static_cast<int>(random >> 17); // up to 33 ms
        const Outcome outcome = lr_bake(arguments, options);
        killed += outcome.exit_code == 128 + SIGKILL;
        const std::string asset = scratch.read("out.lrb");
        CHECK((asset == before || good_asset(asset)));
        CHECK(lr::test::Json::is_json(scratch.read("r.json")));
    }
    CHECK(killed > 0);
    REQUIRE(lr_bake(arguments).exit_code == 0);
    CHECK(scratch.names() == std::vector<std::string>{"out.lrb", "r.json"});
    CHECK(scratch.read("out.lrb") != before);
}

TEST_CASE("lr_bake: a batch that is killed, and then run again, is as if nothing had been") {
    const Scratch scratch;
    std::vector<std::string> arguments{"mesh", "-d", scratch.path("out"), "--report", scratch.path("out"), "--quiet"};
    std::string name = "m0.obj";
    for (int i = 0; i < 6; ++i, ++name[1])
        arguments.push_back(
            scratch.write(name, lr::test::obj_text(lr::test::ellipsoid(0.03 + 0.001 * i, 0.027, 0.024, 2))));
    for (int delay : {5000, 20000, 40000, 80000, 120000}) {
        Trouble options;
        options.kill_after_microseconds = delay;
        lr_bake(arguments, options);
    }
    std::filesystem::create_directory(scratch.path("out"));
    scratch.write("out/.lr_bake-1-0.part", "left by one");
    REQUIRE(lr_bake(arguments).exit_code == 0);
    size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(scratch.path("out"))) {
        const std::string made = entry.path().filename().string();
        CHECK((made.ends_with(".lrb") || made.ends_with(".json")));
        ++files;
    }
    CHECK(files == 12);
}

TEST_CASE("lr_bake: a file size limit, also for reports and plots and in a batch, is fault 103 and leaves nothing") {
    const Scratch scratch;
    const std::string mesh = scratch.write("m.obj", lr::test::obj_text(lr::test::ellipsoid(0.03, 0.027, 0.024, 2)));
    const std::string out = scratch.path("out.lrb");
    lr::test::RunOptions limited;
    limited.file_size_limit = 1000;
    for (const std::vector<std::string>& more : {std::vector<std::string>{"-o", out},
                                                 {"-o", "/dev/null", "--report", scratch.path("r.json")},
                                                 {"-o", "/dev/null", "--plots", scratch.path("plots")},
                                                 {"-d", scratch.path("d")}}) {
        std::vector<std::string> arguments{"mesh", mesh, "--quiet"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = lr::test::run(LR_BAKE_PATH, arguments, limited);
        INFO(outcome.err);
        CHECK(outcome.exit_code == 1);
        CHECK(contains(outcome.err, "error 103"));
        CHECK(contains(outcome.err, "Free some space"));
        std::filesystem::remove(scratch.path("d")); // the batch's folder, which is empty
        CHECK(scratch.names() == std::vector<std::string>{"m.obj"});
    }
}

TEST_CASE("lr_bake: a disk that is full in the middle of an asset") {
    const Scratch scratch;
    const std::string disk = scratch.path("disk");
    std::filesystem::create_directory(disk);
    if (mount("none", disk.c_str(), "tmpfs", 0, "size=8k,nr_inodes=16") != 0) {
        MESSAGE("SKIPPED: a small file system cannot be mounted here: ", std::strerror(errno));
        return;
    }
    scratch.write("disk/full", std::string(4096, 'x')); // half of it
    const std::string out = disk + "/out.lrb", report = disk + "/r.json";
    const Outcome outcome = lr_bake({"ellipsoid", "0.04", "0.02", "0.01", "-o", out, "--report", report, "--quiet"});
    std::vector<std::string> left;
    for (const auto& entry : std::filesystem::directory_iterator(disk))
        left.push_back(entry.path().filename().string());
    umount(disk.c_str());
    INFO(outcome.err);
    CHECK(outcome.exit_code == 1);
    CHECK(contains(outcome.err, disk));
    CHECK(contains(outcome.err, ": error 103"));
    CHECK(contains(outcome.err, "Free some space"));
    CHECK(left == std::vector<std::string>{"full"});
}

TEST_CASE("lr_bake: a folder without rights is fault 103, a file without them 102") {
    const Scratch scratch;
    std::filesystem::permissions(scratch.path(""), std::filesystem::perms::all);
    const std::string mesh = scratch.write("m.obj", lr::test::obj_text(lr::test::ellipsoid(0.03, 0.027, 0.024, 2)));
    std::filesystem::create_directory(scratch.path("closed"));
    scratch.write("closed/out.lrb", old_text);
    std::filesystem::permissions(scratch.path("closed"),
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec |
                                     std::filesystem::perms::others_read | std::filesystem::perms::others_exec);
    Trouble nobody;
    nobody.without_rights = true;
    const Outcome written = lr_bake({"mesh", mesh, "-o", scratch.path("closed/out.lrb"), "--quiet"}, nobody);
    if (written.exit_code == 126) {
        MESSAGE("SKIPPED: rights cannot be given up here");
        return;
    }
    INFO(written.err);
    CHECK(written.exit_code == 1);
    CHECK(contains(written.err, scratch.path("closed/out.lrb") + ": error 103"));
    CHECK(scratch.read("closed/out.lrb") == old_text);
    std::filesystem::permissions(mesh, std::filesystem::perms::none);
    const Outcome read = lr_bake({"mesh", mesh, "-o", scratch.path("out.lrb"), "--quiet"}, nobody);
    INFO(read.err);
    CHECK(read.exit_code == 1);
    CHECK(contains(read.err, mesh + ": error 102"));
    CHECK_FALSE(scratch.has("out.lrb"));
    std::filesystem::permissions(scratch.path("closed"), std::filesystem::perms::owner_all);
}

TEST_CASE("files that are read in pieces are whole, and those that break or end are faults") {
    const Scratch scratch;
    const std::string path = scratch.write("f", new_text);
    for (size_t most : {1u, 100u, 100000u})
        for (bool interrupted : {false, true}) {
            SystemFaults system;
            system.most = most;
            system.interrupted = interrupted;
            std::vector<uint8_t> bytes;
            Faults faults;
            const WithFaults armed(system);
            CHECK(read_file(path, 1 << 20, bytes, faults));
            CHECK(std::string(bytes.begin(), bytes.end()) == new_text);
            if (interrupted) CHECK(system.reads > 2);
        }
    SystemFaults system;
    system.most = 100;
    system.ends_after = 1234;
    std::vector<uint8_t> bytes;
    Faults faults;
    const WithFaults armed(system);
    CHECK(read_file(path, 1 << 20, bytes, faults));
    CHECK(bytes.size() == 1234);
    system.ends_after = 1234;
    system.broken_by = EIO;
    CHECK_FALSE(read_file(path, 1 << 20, bytes, faults));
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].id == FaultId::file_read);
    CHECK(faults[0].remedy == "Check the disk for errors.");
}

#endif
