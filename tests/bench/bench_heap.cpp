// The cost of plates that collide with each other, and how well they lie. Steps of 1/60 s with two substeps, AERODYNAMIC loads.
//     bench_heap [--only SCENE] [--bodies N] [--threads 1|2|both] [--asset FILE] [--csv FILE]
// Scenes: heap, layers, fall, walk, colliders, and bullet: the heap by Bullet, if it was found, of plates ten times as thick, as it
// cannot hold these. Default: all, with one thread. --bodies: in each scene, over as much less ground.
// --asset: instead of the plate baked here, as for a library that reads older files; overlaps stay those of the plate.
// CPU time is the sum over all threads; `us` is CPU time over awake bodies and substeps, of a whole phase. Overlaps are those of
// support/heap_quality.h. The same hash in each row for any number of threads.
#include "bench/heap_scene.h"
#include "bench/peers/bullet_heap.h"

#include <chrono>
#include <cinttypes>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <memory>
#include <optional>
#include <string>

namespace {

using namespace bench;

struct Options {
    uint32_t bodies = 0; // of the scene
    int threads = 1;     // 0: both
    const char* only = nullptr;
    const char* csv = nullptr;
    const char* asset = nullptr;
};

struct Cost {
    double wall, cpu; // ms
    uint32_t awake;   // before the step
};

struct Quality {
    test::HeapQuality lying;
    uint32_t awake = 0;
    double awake_speed = 0.0;     // m/s, rms
    std::optional<double> tremor; // m, the largest movement of any body within the next second
};

double quantile(const std::vector<Cost>& costs, double Cost::*field, double part) {
    std::vector<double> values;
    values.reserve(costs.size());
    for (const Cost& cost : costs) values.push_back(cost.*field);
    std::sort(values.begin(), values.end());
    return values[std::min(values.size() - 1, static_cast<size_t>(part * static_cast<double>(values.size())))];
}

struct Phase {
    const char* name;
    std::vector<Cost> costs{};
    std::optional<Quality> quality{};
    double over_flight = 0.0; // CPU time of the costliest step over free flight; 0: not measured
};

// Prints rows as they come, and collects them for the file.
class Table {
public:
    explicit Table(std::FILE* csv) : csv_(csv) {
        if (csv_)
            std::fprintf(csv_, "scene,phase,threads,bodies,steps,awake,wall_ms,wall_ms_worst,cpu_ms,cpu_ms_worst,us,"
                               "over_flight,overlaps,depth_mm,depth_99_mm,share_deep,height_mm,height_95_mm,awake_then,"
                               "awake_speed_mm_s,tremor_mm,hash\n");
        std::printf("%-9s %-8s %7s %6s %5s %7s %8s %8s %8s %8s %7s  %s\n", "scene", "phase", "threads", "bodies",
                    "steps", "awake", "wall, ms", "worst", "CPU, ms", "worst", "us", "hash");
    }
    void add(const char* scene, uint32_t threads, uint32_t bodies, const Phase& phase, uint64_t hash) {
        if (phase.costs.empty()) return;
        const auto steps = static_cast<double>(phase.costs.size());
        double awake = 0.0, cpu = 0.0;
        for (const Cost& cost : phase.costs) awake += cost.awake, cpu += cost.cpu;
        const double us = awake > 0.0 ? 1e3 * cpu / (awake * substeps) : 0.0;
        const double wall_median = quantile(phase.costs, &Cost::wall, 0.5),
                     wall_worst = quantile(phase.costs, &Cost::wall, 1.0),
                     cpu_median = quantile(phase.costs, &Cost::cpu, 0.5),
                     cpu_worst = quantile(phase.costs, &Cost::cpu, 1.0);
        std::printf("%-9s %-8s %7u %6u %5.0f %7.0f %8.2f %8.2f %8.2f %8.2f %7.3f  %016" PRIx64 "\n", scene, phase.name,
                    threads, bodies, steps, awake / steps, wall_median, wall_worst, cpu_median, cpu_worst, us, hash);
        if (phase.over_flight > 0.0) std::printf("    costliest step over free flight %.2f\n", phase.over_flight);
        if (phase.quality) print(*phase.quality);
        std::fflush(stdout);
        if (!csv_) return;
        std::fprintf(csv_, "%s,%s,%u,%u,%.0f,%.1f,%.4f,%.4f,%.4f,%.4f,%.4f,", scene, phase.name, threads, bodies, steps,
                     awake / steps, wall_median, wall_worst, cpu_median, cpu_worst, us);
        if (phase.over_flight > 0.0) std::fprintf(csv_, "%.3f", phase.over_flight);
        if (phase.quality)
            write(*phase.quality);
        else
            std::fprintf(csv_, ",,,,,,,,,");
        std::fprintf(csv_, ",%016" PRIx64 "\n", hash);
        std::fflush(csv_);
    }

private:
    static void print(const Quality& q) {
        std::printf(
            "    a body: %.3f overlaps above 0.1 mm; depth, mm: median %.3f, 99 %% %.3f; deeper than thick %.2f %%; "
            "height, mm: mean %.1f, 95 %% %.1f; awake %u at %.2f mm/s",
            q.lying.overlaps, 1e3 * q.lying.depth_median, 1e3 * q.lying.depth_99, 100.0 * q.lying.share_deep,
            1e3 * q.lying.height_mean, 1e3 * q.lying.height_95, q.awake, 1e3 * q.awake_speed);
        if (q.tremor) std::printf("; largest movement in the next second %.3f mm", 1e3 * *q.tremor);
        std::printf("\n");
    }
    void write(const Quality& q) {
        std::fprintf(csv_, ",%.4f,%.4f,%.4f,%.5f,%.2f,%.2f,%u,%.3f,", q.lying.overlaps, 1e3 * q.lying.depth_median,
                     1e3 * q.lying.depth_99, q.lying.share_deep, 1e3 * q.lying.height_mean, 1e3 * q.lying.height_95,
                     q.awake, 1e3 * q.awake_speed);
        if (q.tremor) std::fprintf(csv_, "%.4f", 1e3 * *q.tremor);
    }

    std::FILE* csv_;
};

// One scene with one number of threads.
struct Run {
    const char* name;
    Table& table;
    const lr_asset* plate;
    uint32_t bodies, threads;
    HeapScene scene{};
    HeapScene::Seen seen{};
    int since_start = 0;
    bool failed = false;

    bool make(bool body_contact = true) {
        return scene.make(plate, bodies, threads) && scene.add_ground() && (!body_contact || scene.set_body_contact());
    }
    // The side of the square that this many layers cover, m.
    double side(double layers) const { return std::sqrt(4.0 * plate_half[0] * plate_half[1] * bodies / layers); }

    static Cost timed(HeapScene& stepped, uint32_t awake) {
        const std::clock_t cpu = std::clock();
        const auto since = std::chrono::steady_clock::now();
        stepped.step();
        const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - since;
        return {wall.count(), 1e3 * static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC, awake};
    }
    void step(Phase& phase) {
        failed = failed || !scene.start_next();
        seen.awake = scene.awake(); // with those that start now
        phase.costs.push_back(timed(scene, seen.awake));
        seen = scene.look();
        if (++since_start % 30 == 0)
            std::fprintf(stderr, "%s, %s: %.1f s, %u of %u awake, %.1f ms a step\n", name, phase.name,
                         since_start / 60.0, seen.awake, seen.count, phase.costs.back().wall);
    }
    void end(const Phase& phase) { table.add(name, threads, bodies, phase, scene.hash()); }
    Starts starts(const Source& source, double seconds = 0.0) const { return {source, bodies, seconds}; }

    Quality quality() const {
        const test::HeapState state = scene.state();
        return {test::heap_quality(plate_half, state.poses), state.awake, state.awake_speed, {}};
    }

    // Until the last plate has landed: at most 0.2 % are faster than 0.3 m/s, all have started, and this holds for a tenth of a second.
    void land(Phase& phase, int most) {
        for (int k = 0, slow = 0; k < most && slow < 6; ++k) {
            step(phase);
            slow = seen.count == bodies && seen.fast <= bodies / 500 ? slow + 1 : 0;
        }
    }
    // Until 1 % are awake or 4 s have passed; then lies until 4 s and a second more, in which tremor is looked for.
    void settle_and_lie() {
        constexpr int four_seconds = 240, one_second = 60;
        Phase settling{"settling"}, lying{"lying"};
        int k = 0;
        for (; k < four_seconds && seen.awake > bodies / 100; ++k) step(settling);
        if (!settling.costs.empty()) settling.quality = quality();
        end(settling);
        for (; k < four_seconds; ++k) step(lying);
        const test::HeapState before = scene.state();
        lying.quality = quality();
        for (int n = 0; n < one_second; ++n) step(lying);
        lying.quality->tremor = test::largest_movement(plate_half, before.poses, scene.state().poses);
        end(lying);
    }
    // A gust of two seconds that rises to 9 m/s, 10 m above the ground, and falls.
    void blow() {
        Phase gust{"gust"};
        for (int k = 0; k < 120; ++k) {
            const float t = static_cast<float>(k + 1) / 60.0f;
            scene.blow(9.0f * t * (2.0f - t));
            step(gust);
        }
        end(gust);
    }

    // A column 0.4 m wide, dropped from half a metre in three seconds; other numbers of bodies make it wider, so that as many fall
    // on an area.
    Starts column() const {
        const uint32_t across = std::max(1u, static_cast<uint32_t>(5.0 * std::sqrt(bodies / 1800.0)));
        return starts({{across, across}, {0.082f, 0.082f}, 0.5f, 0.0f, 2.2f}, 3.0);
    }
    bool heap() {
        if (!make() || !scene.start(column())) return false;
        Phase landing{"landing"};
        land(landing, 600);
        end(landing);
        settle_and_lie();
        blow();
        return true;
    }
    // All land within a second.
    bool layers() {
        if (!make() || !scene.start(starts(square(side(3.0), 0.2f, 0.14f)))) return false;
        seen = scene.look();
        Phase falling{"falling"}, landing{"landing"};
        double fastest = 0.0;
        do {
            step(falling);
            fastest = std::max(fastest, seen.speed);
        } while (seen.speed >= 0.7 * fastest);
        end(falling);
        land(landing, 300);
        end(landing);
        settle_and_lie();
        blow();
        return true;
    }
    // They land over five seconds, as under trees.
    bool fall() {
        if (!make() || !scene.start(starts(square(side(3.0), 1.5f, 0.0f), 5.0))) return false;
        Phase landing{"landing"};
        land(landing, 900);
        end(landing);
        settle_and_lie();
        return true;
    }
    bool walk() {
        const Source source = square(side(3.0), 0.2f, 0.14f);
        if (!make() || !scene.start(starts(source))) return false;
        seen = scene.look();
        Phase before{"before"}, walking{"walking"};
        land(before, 300);
        for (int k = 0; k < 360 && seen.awake > bodies / 1000; ++k) step(before);
        before.quality = quality();
        end(before);
        if (!scene.add_walker(source.half_side())) return false;
        for (int k = 0; k < scene.walk_steps(); ++k) {
            scene.move_walker(k);
            step(walking);
        }
        walking.quality = quality();
        end(walking);
        return true;
    }
    // Without body contact; beside the same plates over nothing.
    bool colliders() {
        const Source source = square(side(0.7), 0.6f, 0.2f);
        HeapScene free;
        if (!make(false) || !scene.add_boxes(source.half_side()) || !scene.start(starts(source)) ||
            !free.make(plate, bodies, threads) || !free.start(starts(source)))
            return false;
        seen = scene.look();
        Phase flight{"flight"}, landing{"landing"};
        for (int k = 0; k < 180; ++k) {
            if (k < 60) flight.costs.push_back(timed(free, bodies));
            step(landing);
        }
        table.add(name, threads, bodies, flight, free.hash());
        landing.over_flight = quantile(landing.costs, &Cost::cpu, 1.0) / quantile(flight.costs, &Cost::cpu, 0.5);
        end(landing);
        return true;
    }
};

// By Bullet, as long as this takes to land and to settle.
bool bullet_heap(Run& run) {
    const std::unique_ptr<Peer> peer = make_bullet_heap();
    if (!peer) return std::fprintf(stderr, "bench_heap: without Bullet (libbullet-dev)\n"), true;
    Starts starts = run.column();
    uint32_t count = 0;
    const auto step = [&](Phase& phase, uint32_t awake) {
        for (const lr_body_desc& start : starts.next()) peer->add(start), ++count, ++awake;
        const std::clock_t cpu = std::clock();
        const auto since = std::chrono::steady_clock::now();
        peer->step();
        const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - since;
        phase.costs.push_back({wall.count(), 1e3 * static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC, awake});
    };
    Phase landing{"landing"}, settling{"settling"};
    Peer::Seen seen{};
    for (int slow = 0; landing.costs.size() < 600 && slow < 6;) {
        step(landing, seen.awake);
        seen = peer->look();
        slow = count == run.bodies && seen.fast <= run.bodies / 500 ? slow + 1 : 0;
    }
    run.table.add(run.name, 1, run.bodies, landing, 0);
    while (settling.costs.size() < 240 && seen.awake > run.bodies / 100) {
        step(settling, seen.awake);
        seen = peer->look();
    }
    test::Vec half = plate_half;
    half[2] *= Peer::thicker;
    settling.quality = {test::heap_quality(half, peer->poses()), seen.awake, 0.0, {}};
    run.table.add(run.name, 1, run.bodies, settling, 0);
    return true;
}

struct Part {
    const char* name;
    uint32_t bodies;
    bool (*run)(Run&);
};
template <bool (Run::*scene)()> bool of(Run& run) {
    return (run.*scene)();
}
constexpr Part parts[] = {
    {"heap", 1800, of<&Run::heap>}, {"layers", 20000, of<&Run::layers>},        {"fall", 20000, of<&Run::fall>},
    {"walk", 5000, of<&Run::walk>}, {"colliders", 100000, of<&Run::colliders>}, {"bullet", 1800, bullet_heap}};

bool parse(int argc, char** argv, Options& o) {
    for (int i = 1; i < argc; i += 2) {
        const std::string name = argv[i];
        if (i + 1 == argc) return false;
        const std::string value = argv[i + 1];
        const long number = std::strtol(argv[i + 1], nullptr, 10);
        if (name == "--bodies" && number >= 10 && number <= 1000000)
            o.bodies = static_cast<uint32_t>(number);
        else if (name == "--threads" && (value == "1" || value == "2" || value == "both"))
            o.threads = static_cast<int>(number);
        else if (name == "--csv")
            o.csv = argv[i + 1];
        else if (name == "--asset")
            o.asset = argv[i + 1];
        else if (name == "--only" &&
                 std::any_of(std::begin(parts), std::end(parts), [&](const Part& part) { return value == part.name; }))
            o.only = argv[i + 1];
        else
            return false;
    }
    return true;
}

bool run(const Options& o, const lr_asset* plate, Table& table) {
    for (const Part& part : parts) {
        if (o.only && std::strcmp(o.only, part.name) != 0) continue;
        for (int threads = o.threads == 0 ? 1 : o.threads; threads <= (o.threads == 0 ? 2 : o.threads); ++threads) {
            Run r{part.name, table, plate, o.bodies > 0 ? o.bodies : part.bodies, static_cast<uint32_t>(threads)};
            if (!part.run(r) || r.failed) {
                std::fprintf(stderr, "bench_heap: %s: no world\n", part.name);
                return false;
            }
        }
    }
    return true;
}

} // namespace

int main(int argc, char** argv) {
    Options o;
    if (!parse(argc, argv, o)) {
        std::fprintf(stderr, "usage: bench_heap [--only heap|layers|fall|walk|colliders|bullet] [--bodies N] "
                             "[--threads 1|2|both] [--asset FILE] [--csv FILE]\n");
        return 2;
    }
    lr_asset* plate = nullptr;
    if (!o.asset)
        plate = plate_asset();
    else if (lr_asset_load_file(o.asset, &plate) != LR_OK)
        plate = nullptr;
    if (!plate) return std::fprintf(stderr, "bench_heap: no plate\n"), 1;
    std::FILE* const csv = o.csv ? std::fopen(o.csv, "w") : nullptr;
    if (o.csv && !csv) return std::fprintf(stderr, "bench_heap: cannot write %s\n", o.csv), 1;
    Table table(csv);
    const bool done = run(o, plate, table);
    lr_asset_release(plate);
    return (!csv || std::fclose(csv) == 0) && done ? 0 : 1;
}
