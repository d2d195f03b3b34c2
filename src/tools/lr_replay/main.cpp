// lr_replay: plays a recording of lr_world_record_start. Exit code 0: equal, 1: a difference, 2: the recording is refused
// with a numbered fault, 3: wrong usage, or a file cannot be read or written.
#include "tools/console.h"
#include "tools/lr_replay/player.h"
#include "tools/lr_replay/replay_faults.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace {

using namespace lr::replay;

std::filesystem::path path_of(const std::string& utf8) {
    return std::u8string(utf8.begin(), utf8.end());
}

std::string lower(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

bool read(const std::string& path, Bytes& bytes) {
    std::error_code no_file;
    if (std::filesystem::is_directory(path_of(path), no_file)) return false;
    std::ifstream file(path_of(path), std::ios::binary);
    if (!file) return false;
    bytes.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    return !file.bad();
}

bool simd_of(const std::string& name, int32_t& out) {
    for (int32_t target = LR_SIMD_AUTO; target <= LR_SIMD_PLAIN; ++target)
        if (lower(lr_simd_target_name(target)) == lower(name)) {
            out = target;
            return true;
        }
    return false;
}

std::string version(uint32_t v) {
    return std::to_string(v >> 22) + "." + std::to_string(v >> 12 & 1023) + "." + std::to_string(v & 4095);
}

int report(const Outcome& o) {
    if (o.library != lr_version())
        std::fprintf(stderr, "warning: recorded by version %s, played by %s: bits may differ\n",
                     version(o.library).c_str(), version(lr_version()).c_str());
    if (o.difference) {
        std::printf("differs at call %llu, step %llu: %s\n", static_cast<unsigned long long>(o.difference->call),
                    static_cast<unsigned long long>(o.difference->step), o.difference->what.c_str());
        return 1;
    }
    if (!o.within.empty())
        std::printf("the recording ends during call %llu, %s, which completed here\n",
                    static_cast<unsigned long long>(o.calls), o.within.c_str());
    else if (o.cut)
        std::printf("the recording ends within a record; everything before it was played\n");
    std::printf("equal: %llu steps from step %llu on, %llu calls, %llu hashes; the last is %016llx\n",
                static_cast<unsigned long long>(o.steps), static_cast<unsigned long long>(o.first_step),
                static_cast<unsigned long long>(o.calls), static_cast<unsigned long long>(o.hashes),
                static_cast<unsigned long long>(o.hash));
    return 0;
}

int run(int argc, char** argv) {
    CLI::App app("Replays a recording of a Langevin Rigid world and reports the first difference.");
    std::string path, simd = "auto", csv, body;
    bool print = false;
    Options options;
    uint64_t megabytes = options.most_memory >> 20;
    app.add_option("FILE", path, "The recording: all bytes given to lr_recording_desc.write")->required();
    app.add_option("--simd", simd, "Instruction set: auto, SSE4, AVX2, AVX-512, NEON, WebAssembly");
    app.add_option("--workers", options.workers, "Threads besides the calling one")->check(CLI::Range(0, 64));
    app.add_option("--until", options.until, "Stop after this many steps of the recording")
        ->check(CLI::NonNegativeNumber);
    app.add_flag("--print", print, "Print each call as text");
    CLI::Option* const of = app.add_option("--body", body, "Id of a body for --csv, as shown by --print");
    of->needs(app.add_option("--csv", csv, "Write the pose of the body after each step to this file")->needs(of));
    app.add_option("--memory", megabytes, "Memory limit of the world, MB")
        ->capture_default_str()
        ->check(CLI::Range(uint64_t{1}, uint64_t{1} << 24));
    app.footer(
        "Exit code: 0 equal; 1 a difference; 2 a recording that is refused, R01 to R10; 3 wrong usage or a bad file.");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : 3;
    }
    options.most_memory = megabytes << 20;
    if (!simd_of(simd, options.simd)) {
        std::fprintf(stderr, "--simd: unknown instruction set %s; --help lists them\n", simd.c_str());
        return 3;
    }
    if (print) options.print = &std::cout;
    Bytes bytes;
    if (!read(path, bytes)) {
        std::fprintf(stderr, "%s: the recording cannot be read; check the path and the rights\n", path.c_str());
        return 3;
    }
    std::ofstream table;
    if (!csv.empty()) {
        char* end = nullptr;
        options.body = {std::strtoull(body.c_str(), &end, 0)};
        std::error_code no_file;
        const bool number = end != body.c_str() && *end == '\0';
        const bool other = number && !std::filesystem::equivalent(path_of(path), path_of(csv), no_file);
        if (other) table.open(path_of(csv));
        if (!other || !table) {
            std::fprintf(stderr, "%s\n",
                         !number  ? "--body: not an id that --print shows"
                         : !other ? "--csv: it would overwrite the recording"
                                  : "--csv: cannot be written");
            return 3;
        }
        options.csv = &table;
    }
    int code = 0;
    try {
        const Outcome outcome = play(bytes.data(), bytes.size(), options);
        code = report(outcome);
        if (options.csv && !outcome.body)
            std::fprintf(stderr, "warning: no body had the id %s after a step; --print shows ids\n", body.c_str());
    } catch (const Fault& fault) {
        std::fprintf(stderr, "%s: error R%02d: %s\n", path.c_str(), static_cast<int>(fault.id), fault.what());
        return 2;
    }
    std::cout.flush();
    if (table.is_open()) table.close();
    if (!std::cout || (!csv.empty() && !table)) {
        std::fprintf(stderr, "the output is incomplete: check the disk space\n");
        return 3;
    }
    return code;
}
} // namespace

int main(int argc, char** argv) {
    lr::baker::set_up_console();
    try {
        std::vector<std::string> arguments = lr::baker::utf8_arguments(argc, argv);
        std::vector<char*> pointers;
        for (std::string& argument : arguments) pointers.push_back(argument.data());
        return run(static_cast<int>(pointers.size()), pointers.data());
    } catch (const std::exception& e) {
        std::fprintf(stderr, "%s\n", e.what());
        return 3;
    }
}
