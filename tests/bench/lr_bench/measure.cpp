#include "lr_bench/measure.h"

#include <algorithm>
#include <chrono>
#include <cinttypes>
#include <cstdio>
#include <ctime>

namespace lr_bench {
namespace {

struct Instant {
    double wall, cpu;
};

Instant now() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    const double cpu = static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
    return {std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(), cpu};
}

// Of this thread alone: workers can still be waiting for work.
double thread_seconds() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Lane {
    Row row;
    std::unique_ptr<Subject> subject;
    Facts facts;
    uint64_t steps = 1; // per burst
    bool warm = true;   // an untimed step before each burst
    std::vector<double> wall, cpu, cycles;
};

bool burst(Lane& lane, uint64_t steps, Instant& spent) {
    const Instant begin = now();
    for (uint64_t i = 0; i < steps; ++i)
        if (!lane.subject->step()) return false;
    const Instant end = now();
    spent = {end.wall - begin.wall, end.cpu - begin.cpu};
    return true;
}

// Steps that fill a burst.
bool calibrate(Lane& lane, double seconds) {
    Instant spent{};
    for (;;) {
        if (!burst(lane, lane.steps, spent)) return false;
        if (spent.wall >= 0.5 * seconds || lane.steps > (1u << 24)) break;
        lane.steps *= 2;
    }
    const double step = spent.wall / static_cast<double>(lane.steps);
    lane.steps = std::max<uint64_t>(1, static_cast<uint64_t>(seconds / step));
    lane.warm = step < 0.01;
    return true;
}

double median(std::vector<double> v) {
    if (v.empty()) return 0.0;
    const auto middle = v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2);
    std::nth_element(v.begin(), middle, v.end());
    return *middle;
}

double ratio_of(const std::vector<double>& above, const std::vector<double>& below) {
    std::vector<double> ratios;
    for (size_t i = 0; i < above.size(); ++i) ratios.push_back(above[i] / below[i]);
    return median(std::move(ratios));
}

double over_sketch(const Lane& lane, const std::vector<Lane>& all, const char* target) {
    for (const Lane& s : all)
        if (s.row.subject == "sketch" && s.row.target == target && s.row.bodies == lane.row.bodies &&
            s.row.substeps == lane.row.substeps)
            return lane.row.workers ? ratio_of(s.wall, lane.wall) : ratio_of(s.cpu, lane.cpu);
    return 0.0;
}

void write_number(std::FILE* file, double value) {
    if (value > 0.0)
        std::fprintf(file, ",%.4g", value);
    else
        std::fprintf(file, ",");
}

} // namespace

std::string Row::name() const {
    std::string text;
    for (const std::string& word : {subject, model, integrator, path, target, std::to_string(workers),
                                    std::to_string(bodies), std::to_string(substeps)})
        text += (text.empty() ? "" : "/") + word;
    return text;
}

void write_head(std::FILE* file) {
    std::fprintf(file, "subject,model,integrator,path,target,workers,bodies,substeps,wall_ns,wall_ns_least,cpu_ns,"
                       "cpu_ns_least,cycles,speed_over_sketch,speed_over_sketch_avx2,memory_bytes_per_body,"
                       "snapshot_bytes_per_body,hash,lost,rounds\n");
}

void write_row(std::FILE* file, const Measured& m) {
    const Row& r = m.row;
    std::fprintf(file, "%s,%s,%s,%s,%s,%u,%u,%u", r.subject.c_str(), r.model.c_str(), r.integrator.c_str(),
                 r.path.c_str(), r.target.c_str(), r.workers, r.bodies, r.substeps);
    for (const double v : {m.wall_median, m.wall_least, m.cpu_median, m.cpu_least, m.cycles, m.over_sketch,
                           m.over_sketch_avx2, m.facts.memory_bytes, m.facts.state_bytes})
        write_number(file, v);
    if (m.facts.hashed)
        std::fprintf(file, ",%016" PRIx64, m.facts.hash);
    else
        std::fprintf(file, ",");
    std::fprintf(file, ",%" PRIu64 ",%u\n", m.lost, m.rounds);
}

std::vector<Measured> measure(const std::vector<Row>& rows, Make make, const Schedule& schedule, double share) {
    std::vector<Lane> lanes;
    const auto add = [&](const Row& row, std::unique_ptr<Subject> subject) {
        Lane lane{row, std::move(subject), {}, 1, true, {}, {}, {}};
        lane.facts = lane.subject->facts();
        if (calibrate(lane, schedule.burst))
            lanes.push_back(std::move(lane));
        else
            std::fprintf(stderr, "lr_bench: a step failed: %s\n", row.name().c_str());
    };
    const auto clock = make_clock();
    add({"clock", "-", "-", "-", "-", 0, clock_chain, 1}, make_clock());
    for (const Row& row : rows) {
        std::string why_not;
        if (auto subject = make(row, why_not))
            add(row, std::move(subject));
        else
            std::fprintf(stderr, "lr_bench: left out, %s: %s\n", why_not.c_str(), row.name().c_str());
    }

    const double begin = now().wall, budget = schedule.budget * share;
    unsigned rounds = 0;
    while (rounds < schedule.most_rounds && (rounds < schedule.least_rounds || now().wall - begin < budget)) {
        for (Lane& lane : lanes) {
            Instant spent{};
            if (lane.warm) lane.subject->step();
            burst(lane, lane.steps, spent);
            const double body_steps = static_cast<double>(lane.steps) * lane.row.bodies * lane.row.substeps;
            lane.wall.push_back(1e9 * spent.wall / body_steps);
            lane.cpu.push_back(1e9 * spent.cpu / body_steps);
            // The clock frequency changes between bursts.
            constexpr int ticks = 200;
            const double before = thread_seconds();
            for (int i = 0; i < ticks; ++i) clock->step();
            const double cycle = (thread_seconds() - before) / (ticks * clock_chain);
            lane.cycles.push_back(spent.cpu / body_steps / cycle);
        }
        ++rounds;
    }

    std::vector<Measured> out;
    for (const Lane& lane : lanes) {
        Measured m;
        m.row = lane.row;
        m.facts = lane.facts;
        m.lost = lane.subject->lost();
        m.rounds = rounds;
        m.wall_median = median(lane.wall);
        m.wall_least = *std::min_element(lane.wall.begin(), lane.wall.end());
        m.cpu_median = median(lane.cpu);
        m.cpu_least = *std::min_element(lane.cpu.begin(), lane.cpu.end());
        m.cycles = median(lane.cycles);
        m.over_sketch = over_sketch(lane, lanes, "native");
        m.over_sketch_avx2 = over_sketch(lane, lanes, "x86-64-v3");
        out.push_back(std::move(m));
    }
    return out;
}

} // namespace lr_bench
