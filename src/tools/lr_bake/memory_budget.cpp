#include "tools/lr_bake/memory_budget.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <string>

#if defined(_WIN32)
#include "baker/windows_text.h"
#endif

namespace lr::baker {
#if defined(_WIN32)

uint64_t available_memory() {
    MEMORYSTATUSEX memory{};
    memory.dwLength = sizeof memory;
    return GlobalMemoryStatusEx(&memory) != 0 ? memory.ullAvailPhys : uint64_t{4} << 30;
}

#else
namespace {

std::optional<uint64_t> number_in(const char* path) {
    std::ifstream stream(path);
    uint64_t value = 0;
    if (stream >> value) return value; // fails for "max", which is no limit
    return {};
}

std::optional<uint64_t> available_to_machine() {
    std::ifstream stream("/proc/meminfo");
    std::string key, unit;
    uint64_t kibibytes = 0;
    while (stream >> key >> kibibytes && std::getline(stream, unit))
        if (key == "MemAvailable:") return kibibytes * 1024;
    return {};
}
} // namespace

uint64_t available_memory() {
    uint64_t bytes = available_to_machine().value_or(uint64_t{4} << 30);
    const std::optional<uint64_t> limit = number_in("/sys/fs/cgroup/memory.max"),
                                  used = number_in("/sys/fs/cgroup/memory.current");
    if (limit && used) bytes = std::min(bytes, *limit - std::min(*limit, *used));
    return bytes;
}

#endif

uint64_t solve_memory(std::size_t faces) {
    const auto n = static_cast<uint64_t>(faces);
    return faces <= 8000 ? 8 * n * n : 12000 * n; // a dense matrix; else near blocks of 3 to 9 kB per panel
}

void MemoryBudget::acquire(uint64_t bytes) {
    std::unique_lock lock(mutex_);
    freed_.wait(lock, [&] { return used_ == 0 || (used_ < total_ && bytes <= total_ - used_); });
    used_ += bytes;
}

void MemoryBudget::release(uint64_t bytes) {
    {
        const std::lock_guard lock(mutex_);
        used_ -= bytes;
    }
    freed_.notify_all();
}
} // namespace lr::baker
