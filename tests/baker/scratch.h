// A temporary folder for the duration of a test, with its files and programs run in it.
#pragma once

#include "baker/mesh/mesh.h"

#include <doctest/doctest.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace lr::test {

class Scratch {
public:
    Scratch() {
        std::string name = (std::filesystem::temp_directory_path() / "lr_test-XXXXXX").string();
        REQUIRE(mkdtemp(name.data()) != nullptr);
        folder_ = name;
    }
    ~Scratch() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    std::string write(const std::string& name, const std::string& bytes) const {
        std::ofstream(path(name), std::ios::binary) << bytes;
        return path(name);
    }
    std::string read(const std::string& name) const {
        std::ifstream stream(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    bool has(const std::string& name) const { return std::filesystem::exists(path(name)); }
    std::vector<std::string> names() const {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(folder_))
            names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        return names;
    }

private:
    std::filesystem::path folder_;
};

inline std::string obj_text(const baker::Mesh& mesh, double units_per_metre = 1.0) {
    std::string text;
    char line[128];
    for (const Eigen::Vector3d& v : mesh.vertices) {
        std::snprintf(line, sizeof line, "v %.17g %.17g %.17g\n", v[0] * units_per_metre, v[1] * units_per_metre,
                      v[2] * units_per_metre);
        text += line;
    }
    for (const baker::Face& f : mesh.faces) {
        std::snprintf(line, sizeof line, "f %u %u %u\n", f[0] + 1, f[1] + 1, f[2] + 1);
        text += line;
    }
    return text;
}

struct Outcome {
    int exit_code = -1; // 128 + signal when killed
    std::string out, err;
};

struct RunOptions {
    std::string standard_output;      // replaces the captured output
    int kill_after_microseconds = -1; // with SIGTERM
    long file_size_limit = -1;        // bytes
};

inline Outcome run(const std::string& program, const std::vector<std::string>& arguments,
                   const RunOptions& options = {}) {
    const Scratch captured;
    const std::string out = options.standard_output.empty() ? captured.path("out") : options.standard_output;
    const std::string err = captured.path("err");
    std::vector<char*> argv{const_cast<char*>(program.c_str())};
    for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
    argv.push_back(nullptr);
    // The test's own handlers must not run in the child, not even before exec.
    sigset_t all, before;
    sigfillset(&all);
    sigprocmask(SIG_SETMASK, &all, &before);
    const pid_t child = fork();
    if (child == 0) {
        for (const int s : {SIGINT, SIGTERM, SIGSEGV, SIGFPE, SIGILL, SIGABRT}) signal(s, SIG_DFL);
        sigprocmask(SIG_SETMASK, &before, nullptr);
        const int null = open("/dev/null", O_RDONLY);
        const int out_file = open(out.c_str(), O_WRONLY | O_CREAT, 0600),
                  err_file = open(err.c_str(), O_WRONLY | O_CREAT, 0600);
        if (null < 0 || out_file < 0 || err_file < 0) _exit(127);
        dup2(null, 0);
        dup2(out_file, 1);
        dup2(err_file, 2);
        if (options.file_size_limit >= 0) {
            const rlimit limit{static_cast<rlim_t>(options.file_size_limit),
                               static_cast<rlim_t>(options.file_size_limit)};
            setrlimit(RLIMIT_FSIZE, &limit);
        }
        execv(program.c_str(), argv.data());
        _exit(127);
    }
    sigprocmask(SIG_SETMASK, &before, nullptr);
    REQUIRE(child >= 0);
    if (options.kill_after_microseconds >= 0) {
        usleep(static_cast<useconds_t>(options.kill_after_microseconds));
        kill(child, SIGTERM);
    }
    int status = 0;
    waitpid(child, &status, 0);
    Outcome outcome;
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    if (options.standard_output.empty()) outcome.out = captured.read("out");
    outcome.err = captured.read("err");
    return outcome;
}

} // namespace lr::test
