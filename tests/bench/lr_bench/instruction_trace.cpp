#include "lr_bench/instruction_trace.h"
#include "lr_bench/rows.h"

#include <cstdio>

#if defined(__linux__) && defined(__x86_64__)
#include <sys/ptrace.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <map>
#include <sstream>
#endif

namespace lr_bench {

#if defined(__linux__) && defined(__x86_64__)
namespace {

struct Range {
    uint64_t base = 0, end = 0; // base: address of the file's offset 0
};

// The mapping of a file in this process; a forked child has the same.
Range find_mapped(const char* name) {
    std::ifstream maps("/proc/self/maps");
    Range range;
    for (std::string line; std::getline(maps, line);) {
        if (line.find(name) == std::string::npos) continue;
        uint64_t begin = 0, end = 0;
        char dash = 0;
        std::istringstream(line) >> std::hex >> begin >> dash >> end;
        if (range.base == 0) range.base = begin;
        range.end = end;
    }
    return range;
}

[[noreturn]] void run_child(Subject& subject) {
    if (ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) _exit(3);
    std::raise(SIGSTOP);
    subject.step();
    std::raise(SIGSTOP);
    _exit(0);
}

} // namespace

int write_trace(const Row& row, const char* path) {
    std::string why_not;
    const auto subject = make_subject(row, why_not);
    if (!subject) {
        std::fprintf(stderr, "lr_bench: %s: %s\n", why_not.c_str(), row.name().c_str());
        return 1;
    }
    const Range code = find_mapped(row.ours() ? "/liblangevin_rigid.so" : "/lr_bench");
    const pid_t child = fork();
    if (child == 0) run_child(*subject);
    int status = 0;
    std::map<uint64_t, uint64_t> counts;
    bool begun = false, ended = false;
    while (child > 0 && waitpid(child, &status, 0) == child && WIFSTOPPED(status)) {
        if (WSTOPSIG(status) == SIGSTOP) {
            ended = begun;
            begun = true;
        }
        if (ended) break;
        user_regs_struct registers;
        if (ptrace(PTRACE_GETREGS, child, nullptr, &registers) != 0) break;
        if (registers.rip >= code.base && registers.rip < code.end) ++counts[registers.rip - code.base];
        if (ptrace(PTRACE_SINGLESTEP, child, nullptr, nullptr) != 0) break;
    }
    if (child > 0 && (WIFSTOPPED(status))) {
        kill(child, SIGKILL);
        waitpid(child, &status, 0);
    }
    if (!ended) {
        std::fprintf(stderr, "lr_bench: the step could not be followed\n");
        return 2;
    }
    std::FILE* const file = std::fopen(path, "w");
    if (!file) return 1;
    std::fprintf(file, "address,count\n");
    for (const auto& [address, count] : counts)
        std::fprintf(file, "%llx,%llu\n", static_cast<unsigned long long>(address),
                     static_cast<unsigned long long>(count));
    return std::fclose(file) == 0 ? 0 : 1;
}
#else
int write_trace(const Row&, const char*) {
    return 2;
}
#endif

} // namespace lr_bench
