// The cost of snapshots for rollback: save, restore after a step of 16 ms, and memcpy of the same size, in turns. Medians of the thread's own time; `hash` is lr_world_hash of the saved state.
//     bench_snapshot [BODIES [TURNS [SCENE]]]
#include "bench/rollback_scene.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

namespace {

using namespace bench;

// ms of this thread's own time
double now() {
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

class Median {
public:
    template <class F> bool take(F&& f) {
        const double begin = now();
        const bool good = f();
        of_.push_back(now() - begin);
        return good;
    }
    double value() {
        const auto middle = of_.begin() + static_cast<std::ptrdiff_t>(of_.size() / 2);
        std::nth_element(of_.begin(), middle, of_.end());
        return *middle;
    }

private:
    std::vector<double> of_;
};

bool measure(const RollbackKind& kind, uint32_t bodies, int turns) {
    RollbackScene scene;
    if (!scene.make(kind, bodies)) return false;
    const uint64_t size = lr_world_snapshot_size(scene.world()), hash = scene.hash();
    const uint32_t awake = scene.awake();
    std::vector<unsigned char> base(size), copy(size);
    Median save, restore, memcpy_time;
    bool good = true;
    for (int i = 0; i < turns && good; ++i) {
        good = save.take([&] { return lr_world_snapshot_save(scene.world(), base.data(), size, nullptr) == LR_OK; }) &&
               memcpy_time.take([&] {
                   std::memcpy(copy.data(), base.data(), size);
                   return copy[size / 2] == base[size / 2];
               }) &&
               scene.step() &&
               restore.take([&] { return lr_world_snapshot_restore(scene.world(), base.data(), size) == LR_OK; });
    }
    good = good && scene.hash() == hash && scene.step();
    if (!good) return false;
    std::printf("%-8s %8u %8u %8.1f %9.4f %9.4f %9.4f  %016llx\n", kind.name, bodies, awake,
                static_cast<double>(size) / bodies, save.value(), restore.value(), memcpy_time.value(),
                static_cast<unsigned long long>(hash));
    return true;
}

} // namespace

int main(int argc, char** argv) {
    const auto bodies = static_cast<uint32_t>(argc > 1 ? std::atoi(argv[1]) : 10000);
    const int turns = argc > 2 ? std::atoi(argv[2]) : 201;
    std::printf("%-8s %8s %8s %8s %9s %9s %9s  %s\n", "scene", "bodies", "awake", "B/body", "save ms", "restore",
                "memcpy", "hash");
    for (const RollbackKind& kind : rollback_kinds)
        if ((argc < 4 || std::strcmp(argv[3], kind.name) == 0) && !measure(kind, bodies, turns)) {
            std::fprintf(stderr, "%s failed\n", kind.name);
            return 1;
        }
}
