// The cost of checks and recordings for calls: LR_CHECK_THREADS, and a recording whose writer only counts. Four equal worlds take
// turns at the same calls: without either, checked, recorded with a hash in each step, recorded without hashes. Medians of the thread's own
// time. All must end with the same hash, which is in the row.
//     bench_calls [BODIES [TURNS]]
#include "bench/leaf_asset.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

namespace {

double nanoseconds() {
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
}

double median(std::vector<double>& of) {
    const auto middle = of.begin() + static_cast<std::ptrdiff_t>(of.size() / 2);
    std::nth_element(of.begin(), middle, of.end());
    return *middle;
}

int32_t count(void* user, const void*, uint64_t size) {
    *static_cast<uint64_t*>(user) += size;
    return 0;
}

void blow(void*, const lr_wind_query* q) {
    for (uint32_t i = 0; i < q->count; ++i) q->velocity[0][i] = 1.0f + 0.1f * q->position[1][i];
}

struct Watched {
    lr_world* world = nullptr;
    lr_batch batch{};
    std::vector<lr_body> bodies;
    uint64_t bytes = 0;
    double begin = 0.0; // ns to start the recording

    Watched() = default;
    Watched(const Watched&) = delete;
    Watched& operator=(const Watched&) = delete;
    ~Watched() { lr_world_destroy(world); }

    bool make(lr_asset* asset, uint32_t count_of_bodies, bool checked, bool wind) {
        lr_world_desc wd;
        lr_world_desc_init(&wd, sizeof wd);
        wd.checks = checked ? LR_CHECK_THREADS : 0;
        lr_batch_desc bd;
        lr_batch_desc_init(&bd, sizeof bd);
        bd.asset = asset, bd.capacity = count_of_bodies;
        lr_emitter_desc e;
        lr_emitter_desc_init(&e, sizeof e);
        e.shape = LR_EMIT_BOX;
        for (float& side : e.size) side = 10.0f;
        bodies.resize(count_of_bodies);
        return lr_world_create(&wd, &world) == LR_OK && lr_batch_create(world, &bd, &batch) == LR_OK &&
               lr_batch_set_emitter(world, batch, &e) == LR_OK &&
               lr_batch_spawn(world, batch, count_of_bodies, bodies.data()) == LR_OK &&
               lr_batch_set_emitter(world, batch, nullptr) == LR_OK &&
               (!wind || lr_world_set_wind_callback(world, blow, nullptr) == LR_OK);
    }
    bool record(uint32_t hash_interval) {
        lr_recording_desc d;
        lr_recording_desc_init(&d, sizeof d);
        d.hash_interval = hash_interval;
        d.write = count, d.user = &bytes;
        const double since = nanoseconds();
        const bool good = lr_world_record_start(world, &d) == LR_OK;
        begin = nanoseconds() - since;
        return good;
    }
    uint64_t hash() const {
        uint64_t h = 0;
        lr_world_hash(world, &h);
        return h;
    }
};

constexpr size_t ways = 4;

// `call` once in each world in turn, `repeats` times in a row if a single call is too short for the clock.
template <class Call>
bool measure(const char* name, Watched (&worlds)[ways], int turns, int repeats, const Call& call) {
    std::vector<double> times[ways];
    uint64_t before[ways];
    for (size_t w = 0; w < ways; ++w) before[w] = worlds[w].bytes;
    for (int turn = 0; turn < turns; ++turn)
        for (size_t w = 0; w < ways; ++w) {
            const double since = nanoseconds();
            for (int k = 0; k < repeats; ++k)
                if (call(worlds[w]) != LR_OK) return false;
            times[w].push_back((nanoseconds() - since) / repeats);
        }
    std::printf("%-16s", name);
    for (std::vector<double>& of : times) std::printf(" %10.0f", median(of));
    const double calls = static_cast<double>(turns) * repeats;
    std::printf(" %10.0f  %016llx\n", static_cast<double>(worlds[3].bytes - before[3]) / calls,
                static_cast<unsigned long long>(worlds[0].hash()));
    for (const Watched& w : worlds)
        if (w.hash() != worlds[0].hash()) return false;
    return true;
}

bool all(lr_asset* asset, uint32_t bodies, int turns, bool wind) {
    Watched worlds[ways];
    for (size_t w = 0; w < ways; ++w)
        if (!worlds[w].make(asset, bodies, w == 1, wind)) return false;
    if (!worlds[2].record(1) || !worlds[3].record(0)) return false;
    const auto step = [](Watched& w) { return lr_world_step(w.world, 0.016f, 2); };
    if (wind) return measure("step, callback", worlds, turns, 1, step);
    std::printf("%-16s %43.0f %10llu\n", "begin", worlds[3].begin, static_cast<unsigned long long>(worlds[3].bytes));
    lr_body_state s;
    lr_body_state_init(&s, sizeof s);
    if (lr_body_get_state(worlds[0].world, worlds[0].bodies[0], &s) != LR_OK) return false;
    return measure("set_wind", worlds, turns, 1000,
                   [](Watched& w) { return lr_world_set_uniform_wind(w.world, 0.0f, 0.0f, 0.0f); }) &&
           measure("set_state", worlds, turns, 1000,
                   [&](Watched& w) { return lr_body_set_state(w.world, w.bodies[0], &s); }) &&
           measure("step", worlds, turns, 1, step);
}

} // namespace

int main(int argc, char** argv) {
    const auto bodies = static_cast<uint32_t>(argc > 1 ? std::atoi(argv[1]) : 10000);
    const int turns = argc > 2 ? std::atoi(argv[2]) : 201;
    std::printf("%u bodies, ns a call\n%-16s %10s %10s %10s %10s %10s  %s\n", bodies, "call", "plain", "checked",
                "recorded", "no hashes", "B a call", "hash");
    lr_asset* const asset = bench::leaf_asset();
    const bool good = asset && all(asset, bodies, turns, false) && all(asset, bodies, turns, true);
    lr_asset_release(asset);
    if (!good) std::fprintf(stderr, "bench_calls failed\n");
    return good ? 0 : 1;
}
