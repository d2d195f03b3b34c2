// The cost of body contact between leaves: they fall on the ground, lie there some layers deep, a walker crosses them, and a gust
// comes. The same leaves without body contact run alongside. Steps of 1/60 s with two substeps, AERODYNAMIC loads.
//     bench_pile [--bodies N] [--layers N] [--workers N] [--asset FILE] [--seconds N]
// Default: 20,000 bodies; 3 and then 10 layers; workers 0 and then 1, with the same hashes. --seconds: time for the leaves to fall
// asleep; 8. cpu is the sum over all threads.
#include "bench/pile_scene.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <vector>

namespace {

using namespace bench;

struct Options {
    uint32_t bodies = 20000;
    int layers = -1, workers = -1; // both
    double seconds = 8.0;
    const char* asset = nullptr;
};

struct Cost {
    double wall, cpu; // ms
    uint32_t awake;   // before the step
};

Cost timed_step(PileScene& scene, uint32_t awake) {
    const std::clock_t cpu = std::clock();
    const auto since = std::chrono::steady_clock::now();
    scene.step();
    const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - since;
    return {wall.count(), 1e3 * static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC, awake};
}

double quantile(const std::vector<Cost>& costs, double Cost::*field, double part) {
    std::vector<double> values;
    values.reserve(costs.size());
    for (const Cost& cost : costs) values.push_back(cost.*field);
    std::sort(values.begin(), values.end());
    return values[std::min(values.size() - 1, static_cast<size_t>(part * static_cast<double>(values.size())))];
}

// For the same steps, with body contact and without.
struct Phase {
    const char* name;
    std::vector<Cost> with, without;

    void print(uint32_t bodies) const {
        if (with.empty()) return;
        double awake = 0.0, cpu = 0.0, alone = 0.0;
        for (const Cost& cost : with) awake += cost.awake, cpu += cost.cpu;
        for (const Cost& cost : without) alone += cost.cpu;
        const auto steps = static_cast<double>(with.size());
        const double median = quantile(with, &Cost::cpu, 0.5);
        const auto late =
            std::count_if(with.begin(), with.end(), [](const Cost& cost) { return cost.wall > 1e3 / 60.0; });
        std::printf("%-9s %5.0f  %8.2f %8.2f %8.2f  %8.2f %8.2f %5.0f%%  %8.0f %7.2f %7.2f  %8.3f %6.1f", name, steps,
                    median, quantile(with, &Cost::cpu, 0.99), cpu / steps, quantile(with, &Cost::wall, 0.5),
                    quantile(with, &Cost::wall, 0.99), 100.0 * static_cast<double>(late) / steps, awake / steps,
                    awake > 0.0 ? 1e3 * cpu / (awake * substeps) : 0.0, 1e3 * cpu / (steps * bodies * substeps),
                    alone / steps, cpu / alone);
    }
};

struct Run {
    const Options& options;
    PileScene with, without;
    PileScene::Seen seen{}, alone{};

    void step(Phase& phase) {
        phase.with.push_back(timed_step(with, seen.awake));
        phase.without.push_back(timed_step(without, alone.awake));
        seen = with.look(), alone = without.look();
    }
    void end(const Phase& phase) {
        phase.print(options.bodies);
        if (!phase.with.empty())
            std::printf("  %6u %6u  %7.4f %7.4f  %016llx\n", seen.awake, alone.awake, seen.height, alone.height,
                        static_cast<unsigned long long>(with.hash()));
        std::fflush(stdout);
    }

    // Falling until most leaves have touched another, landing until they are slow, settling until all but a hundredth sleep.
    void land() {
        Phase falling{"falling", {}, {}}, landing{"landing", {}, {}}, settling{"settling", {}, {}};
        const int most = static_cast<int>(options.seconds / static_cast<double>(step_seconds));
        double fastest = 0.0;
        int k = 0;
        for (; k < most && seen.speed >= 0.7 * fastest; ++k, fastest = std::max(fastest, seen.speed)) step(falling);
        end(falling);
        for (; k < most && seen.speed > 0.05 * fastest; ++k) step(landing);
        end(landing);
        for (; k < most && seen.awake > options.bodies / 100; ++k) step(settling);
        end(settling);
    }
    void lie() {
        Phase lying{"lying", {}, {}};
        for (int k = 0; k < 60; ++k) step(lying);
        end(lying);
    }
    bool walk() {
        if (!with.add_walker() || !without.add_walker()) return false;
        Phase walking{"walking", {}, {}};
        for (int k = 0; k < with.walk_steps(); ++k) {
            with.move_walker(k), without.move_walker(k);
            step(walking);
        }
        end(walking);
        return true;
    }
    // A gust of two seconds that rises to 9 m/s, 10 m above the ground, and falls.
    void blow() {
        Phase gust{"gust", {}, {}};
        for (int k = 0; k < 120; ++k) {
            const float t = static_cast<float>(k + 1) / 60.0f, speed = 9.0f * t * (2.0f - t);
            with.blow(speed), without.blow(speed);
            step(gust);
        }
        end(gust);
    }
};

bool run(const Options& options, float layers, uint32_t workers) {
    Run r{options, {}, {}};
    if (!r.with.make(options.asset, options.bodies, layers, workers, true) ||
        !r.without.make(options.asset, options.bodies, layers, workers, false))
        return false;
    r.seen.awake = r.alone.awake = options.bodies;
    std::printf("%u bodies, %.0f layers on %.2f m x %.2f m, workers %u\n", options.bodies, static_cast<double>(layers),
                static_cast<double>(r.with.side()), static_cast<double>(r.with.side()), workers);
    std::printf("%15s  %26s  %24s  %24s  %15s  %13s  %15s\n", "", "cpu, ms a step", "wall, ms a step",
                "us a substep of one", "alone: cpu, ms", "awake then", "height then, m");
    std::printf("%-9s %5s  %8s %8s %8s  %8s %8s %6s  %8s %7s %7s  %8s %6s  %6s %6s  %7s %7s  %s\n", "", "steps",
                "median", "99 %", "mean", "median", "99 %", "> 1/60", "awake", "awake", "all", "mean", "times", "with",
                "alone", "with", "alone", "hash");
    r.land();
    r.lie();
    if (!r.walk()) return false;
    r.blow();
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
        else if (std::strcmp(name, "--layers") == 0 && number > 0 && number <= 1000)
            o.layers = static_cast<int>(number);
        else if (std::strcmp(name, "--workers") == 0 && number >= 0 && number <= 64)
            o.workers = static_cast<int>(number);
        else if (std::strcmp(name, "--seconds") == 0 && number > 0 && number <= 1000)
            o.seconds = static_cast<double>(number);
        else if (std::strcmp(name, "--asset") == 0)
            o.asset = value;
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
                     "usage: bench_pile [--bodies N] [--layers N] [--workers N] [--asset FILE] [--seconds N]\n");
        return 2;
    }
    for (const int layers : {3, 10}) {
        if (o.layers > 0 && layers == 10) break;
        for (int workers = o.workers < 0 ? 0 : o.workers; workers <= (o.workers < 0 ? 1 : o.workers); ++workers)
            if (!run(o, static_cast<float>(o.layers > 0 ? o.layers : layers), static_cast<uint32_t>(workers))) {
                std::fprintf(stderr, "bench_pile: no world\n");
                return 1;
            }
    }
    return 0;
}
