// The cost of contact: leaves falling over a ground and without it, all landing within a second, on fine triangles, in a wind among houses, a million
// asleep, and a capsule that walks through lying leaves. Steps of 1/60 s with two substeps, AERODYNAMIC loads, still air but for the houses.
//     bench_landing [--bodies N] [--turns N] [--workers N] [--asset FILE] [--ground mesh]
//                   [--only flight|landing|fine|houses|rest|walk]
// Default: 100,000 bodies, asleep ten times as many; workers 0 and then 1, with the same hashes. Times are medians of turns that
// alternate between the compared scenes; cpu is the sum over all threads.
#include "bench/landing_scene.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <vector>

namespace {

using namespace bench;

struct Options {
    uint32_t bodies = 100000, turns = 5;
    int workers = -1; // both
    const char* asset = nullptr;
    const char* only = nullptr;
    bool mesh = false;
};

struct Cost {
    double wall, cpu; // s
};

template <class F> Cost timed(F&& f) {
    const std::clock_t cpu = std::clock();
    const auto since = std::chrono::steady_clock::now();
    f();
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - since;
    return {wall.count(), static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC};
}

Cost median(std::vector<Cost> costs) {
    const auto middle = [&](double Cost::*field) {
        std::sort(costs.begin(), costs.end(), [&](const Cost& a, const Cost& b) { return a.*field < b.*field; });
        return costs[costs.size() / 2].*field;
    };
    const double wall = middle(&Cost::wall);
    return {wall, middle(&Cost::cpu)};
}

void row(const char* name, uint32_t workers, const Cost& of_step, uint32_t bodies, const Scene& scene) {
    const double each = 1e9 / (static_cast<double>(bodies) * substeps);
    std::printf("%-24s workers %u  %8.4f ms a step, cpu %8.4f  %7.2f ns a body and substep, cpu %7.2f  hash %016llx\n",
                name, workers, 1e3 * of_step.wall, 1e3 * of_step.cpu, each * of_step.wall, each * of_step.cpu,
                static_cast<unsigned long long>(scene.hash()));
}

// Spread over 20 m; each turn is the same ten steps of the same state.
bool flight(const Options& o, uint32_t workers) {
    Scene with, without;
    if (!with.make(o.asset, o.bodies, workers) || !without.make(o.asset, o.bodies, workers) ||
        !with.add_ground(o.mesh) || !with.emit(o.bodies, 0.0f, 20.0f) || !without.emit(o.bodies, 0.0f, 20.0f))
        return false;
    constexpr int warm = 10, steps = 10;
    for (int i = 0; i < warm; ++i) with.step(), without.step();
    std::vector<Cost> times[2];
    for (Scene* scene : {&with, &without}) scene->save();
    for (uint32_t t = 0; t < o.turns; ++t)
        for (int k = 0; k < 2; ++k) {
            Scene& scene = k == 0 ? with : without;
            scene.restore();
            Cost cost = timed([&] {
                for (int i = 0; i < steps; ++i) scene.step();
            });
            cost.wall /= steps, cost.cpu /= steps;
            times[k].push_back(cost);
        }
    const Cost a = median(times[0]), b = median(times[1]);
    row("in flight over ground", workers, a, o.bodies, with);
    row("in flight, nothing there", workers, b, o.bodies, without);
    std::printf("%-24s workers %u  ratio %.3f, cpu %.3f\n\n", "in flight", workers, a.wall / b.wall, a.cpu / b.cpu);
    return true;
}

constexpr int landing_steps = 240;

// From between half a metre and 1.5 m.
bool landing(const Options& o, uint32_t workers) {
    Scene with, without;
    if (!with.make(o.asset, o.bodies, workers) || !without.make(o.asset, o.bodies, workers) ||
        !with.add_ground(o.mesh) || !with.emit(o.bodies, 0.5f, 1.5f) || !without.emit(o.bodies, 0.5f, 1.5f))
        return false;
    for (Scene* scene : {&with, &without}) scene->save();
    const uint32_t turns = std::max(o.turns / 2, 1u);
    std::vector<Cost> of_step[landing_steps], free;
    uint32_t awake[landing_steps] = {};
    for (uint32_t t = 0; t < turns; ++t) {
        with.restore(), without.restore();
        for (int i = 0; i < landing_steps; ++i) {
            of_step[i].push_back(timed([&] { with.step(); }));
            awake[i] = with.awake();
            if (i < landing_steps / 5) free.push_back(timed([&] { without.step(); }));
        }
    }
    const Cost nothing = median(free);
    Cost most{0.0, 0.0}, sum{0.0, 0.0};
    for (int i = 0; i < landing_steps; ++i) {
        const Cost c = median(of_step[i]);
        most = {std::max(most.wall, c.wall), std::max(most.cpu, c.cpu)};
        sum = {sum.wall + c.wall, sum.cpu + c.cpu};
        if (i % 20 == 0)
            std::printf("    after %4.2f s  %7.2f ms, cpu %7.2f  awake %u\n",
                        (i + 1) * static_cast<double>(step_seconds), 1e3 * c.wall, 1e3 * c.cpu, awake[i]);
    }
    row("landing, mean", workers, {sum.wall / landing_steps, sum.cpu / landing_steps}, o.bodies, with);
    row("landing, costliest", workers, most, o.bodies, with);
    row("landing, nothing there", workers, nothing, o.bodies, without);
    std::printf("%-24s workers %u  costliest step over one of free bodies %.3f, cpu %.3f\n\n", "landing", workers,
                most.wall / nothing.wall, most.cpu / nothing.cpu);
    return true;
}

// On meshes with ever finer triangles, smooth and uneven, 1,000 bodies at most: us for each awake body and substep over three seconds.
bool fine(const Options& o, uint32_t workers) {
    const uint32_t bodies = std::min(o.bodies, 1000u);
    struct Sheet {
        float width;
        bool uneven;
    };
    constexpr Sheet sheets[] = {{0.5f, false},   {0.1f, false}, {0.05f, false}, {0.02f, false}, {0.01f, false},
                                {0.005f, false}, {0.1f, true},  {0.05f, true},  {0.02f, true}};
    for (const Sheet& sheet : sheets) {
        Scene scene;
        if (!scene.make(o.asset, bodies, workers) || !scene.add_sheet(sheet.width, sheet.uneven) ||
            !scene.emit(bodies, 0.2f, 0.4f, 1.6f))
            return false;
        double cpu = 0.0, awake = 0.0;
        for (int i = 0; i < 180; ++i) {
            awake += scene.awake();
            cpu += timed([&] { scene.step(); }).cpu;
        }
        std::printf("%s triangles, %4.1f cm workers %u  %7.2f us an awake body and substep  hash %016llx\n",
                    sheet.uneven ? "uneven" : "smooth", 100.0 * static_cast<double>(sheet.width), workers,
                    1e6 * cpu / (awake * substeps), static_cast<unsigned long long>(scene.hash()));
    }
    return true;
}

// In 8 m/s, which takes every leaf along the ground until it comes to a house: us for each awake body and substep, and how many are awake, over ten
// seconds.
bool among_houses(const Options& o, uint32_t workers) {
    Scene scene;
    if (!scene.make(o.asset, o.bodies, workers) || !scene.add_houses() || !scene.emit(o.bodies, 0.3f, 4.0f))
        return false;
    double cpu = 0.0, awake = 0.0;
    for (int i = 1; i <= 600; ++i) {
        awake += scene.awake();
        cpu += timed([&] { scene.step(); }).cpu;
        if (i % 200 == 0)
            std::printf(
                "among houses, %2.0f s         workers %u  %7.2f s, %6.2f us an awake body and substep, awake %u\n",
                i * static_cast<double>(step_seconds), workers, cpu, 1e6 * cpu / (awake * substeps), scene.awake());
    }
    std::printf("%-24s workers %u  hash %016llx\n\n", "among houses", workers,
                static_cast<unsigned long long>(scene.hash()));
    return true;
}

bool at_rest(const Options& o, uint32_t workers) {
    Scene scene;
    const uint32_t bodies = 10 * o.bodies;
    if (!scene.make(o.asset, bodies, workers) || !scene.add_ground(o.mesh, false) || !scene.emit(bodies, 0.0f, 0.1f))
        return false;
    for (int i = 0; i < 2; ++i) { // new colliders wake the bodies near them
        if (!scene.lay_down()) return false;
        scene.step();
    }
    scene.lay_down();
    constexpr int steps = 200;
    for (int i = 0; i < 20; ++i) scene.step();
    std::vector<Cost> times;
    for (uint32_t t = 0; t < o.turns; ++t) {
        Cost cost = timed([&] {
            for (int i = 0; i < steps; ++i) scene.step();
        });
        cost.wall /= steps, cost.cpu /= steps;
        times.push_back(cost);
    }
    row("at rest", workers, median(times), bodies, scene);
    std::printf("%-24s workers %u  awake %u\n\n", "at rest", workers, scene.awake());
    return true;
}

// 35 cm radius, 1.7 m tall, at 1.4 m/s across the middle of the ground.
bool walk(const Options& o, uint32_t workers) {
    Scene scene;
    if (!scene.make(o.asset, o.bodies, workers) || !scene.add_ground(o.mesh) || !scene.emit(o.bodies, 0.3f, 0.6f))
        return false;
    for (int i = 0; i < 360 && scene.awake() > o.bodies / 200; ++i) scene.step();
    const uint32_t before = scene.awake();
    if (!scene.add_walker()) return false;
    constexpr int steps = 600;
    std::vector<Cost> times;
    uint32_t most = 0;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        scene.move_walker(i);
        times.push_back(timed([&] { scene.step(); }));
        most = std::max(most, scene.awake());
        sum += scene.awake();
    }
    row("walking, median", workers, median(times), o.bodies, scene);
    const auto costliest =
        std::max_element(times.begin(), times.end(), [](auto& a, auto& b) { return a.wall < b.wall; });
    row("walking, costliest", workers, *costliest, o.bodies, scene);
    std::printf("%-24s workers %u  awake before %u, meanwhile %.0f, at most %u\n\n", "walking", workers, before,
                sum / steps, most);
    return true;
}

bool parse(int argc, char** argv, Options& o) {
    for (int i = 1; i < argc; i += 2) {
        const char* const name = argv[i];
        if (i + 1 == argc) return false;
        const char* const value = argv[i + 1];
        const long number = std::strtol(value, nullptr, 10);
        if (std::strcmp(name, "--bodies") == 0 && number > 0 && number <= 1000000)
            o.bodies = static_cast<uint32_t>(number);
        else if (std::strcmp(name, "--turns") == 0 && number > 0 && number <= 1000)
            o.turns = static_cast<uint32_t>(number);
        else if (std::strcmp(name, "--workers") == 0 && number >= 0 && number <= 64)
            o.workers = static_cast<int>(number);
        else if (std::strcmp(name, "--asset") == 0)
            o.asset = value;
        else if (std::strcmp(name, "--ground") == 0 && std::strcmp(value, "mesh") == 0)
            o.mesh = true;
        else if (std::strcmp(name, "--only") == 0)
            o.only = value;
        else
            return false;
    }
    return true;
}

} // namespace

int main(int argc, char** argv) {
    Options o;
    if (!parse(argc, argv, o)) {
        std::fprintf(stderr,
                     "usage: bench_landing [--bodies N] [--turns N] [--workers N] [--asset FILE] [--ground mesh] "
                     "[--only flight|landing|fine|houses|rest|walk]\n");
        return 2;
    }
    struct Part {
        const char* name;
        bool (*run)(const Options&, uint32_t workers);
    };
    constexpr Part parts[] = {{"flight", flight},       {"landing", landing}, {"fine", fine},
                              {"houses", among_houses}, {"rest", at_rest},    {"walk", walk}};
    for (const Part& part : parts) {
        if (o.only && std::strcmp(o.only, part.name) != 0) continue;
        for (int workers = o.workers < 0 ? 0 : o.workers; workers <= (o.workers < 0 ? 1 : o.workers); ++workers)
            if (!part.run(o, static_cast<uint32_t>(workers))) {
                std::fprintf(stderr, "bench_landing: %s: no world\n", part.name);
                return 1;
            }
    }
    return 0;
}
