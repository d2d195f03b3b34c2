// lr_load: long runs, many bodies, many worlds, many threads. docs/maintainers/testing.md. Exit code 0 if all bounds hold, otherwise 1.
#include "load/load.h"

#include <chrono>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#if defined(__linux__)
#include <unistd.h>
#endif

namespace load {

int verdict(bool good, const char* what, const char* format, ...) {
    char value[256];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(value, sizeof value, format, arguments);
    va_end(arguments);
    std::printf("%-5s %-40s %s\n", good ? "good" : "BAD", what, value);
    std::fflush(stdout);
    return good ? 0 : 1;
}

uint64_t resident_bytes() {
#if defined(__linux__)
    unsigned long long size = 0, resident = 0;
    if (std::FILE* const file = std::fopen("/proc/self/statm", "r")) {
        if (std::fscanf(file, "%llu %llu", &size, &resident) != 2) resident = 0;
        std::fclose(file);
    }
    return resident * static_cast<uint64_t>(sysconf(_SC_PAGESIZE));
#else
    return 0;
#endif
}

uint64_t memory_free() {
    unsigned long long kilobytes = 0;
    if (std::FILE* const file = std::fopen("/proc/meminfo", "r")) {
        char line[128];
        while (std::fgets(line, sizeof line, file))
            if (std::sscanf(line, "MemAvailable: %llu", &kilobytes) == 1) break;
        std::fclose(file);
    }
    return kilobytes << 10;
}

double seconds_now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace load

int main(int argc, char** argv) {
    const char* const what = argc > 1 ? argv[1] : "";
    const auto number = [&](int at, double otherwise) { return argc > at ? std::atof(argv[at]) : otherwise; };
    const auto count = [&](int at, uint32_t otherwise) { return static_cast<uint32_t>(number(at, otherwise)); };
    if (std::strcmp(what, "soak") == 0) return load::soak(number(2, 24.0), argc > 3 ? argv[3] : "") != 0;
    if (std::strcmp(what, "bodies") == 0) return load::many_bodies(count(2, 4000000)) != 0;
    if (std::strcmp(what, "worlds") == 0) return load::many_worlds(count(2, 1000)) != 0;
    if (std::strcmp(what, "threads") == 0) return load::many_threads(count(2, 64), count(3, 300)) != 0;
    std::fputs("usage: lr_load soak [HOURS [CSV]] | bodies [COUNT] | worlds [COUNT] | threads [WORKERS [STEPS]]\n",
               stderr);
    return 2;
}
