// Speed of a step: the library, its first sketch, and other simulators of rigid bodies, in one run.
//     lr_bench --csv rows.csv [--quick | --full] [--seconds S]     timed in turns; the source of docs/maintainers/performance.md
//     lr_bench --benchmark_filter=...                              Google Benchmark over the same rows
//     lr_bench --one ROW [--steps N]                               N steps of one row, for profilers
//     lr_bench --trace ROW --out FILE | --ports FILE | --list
// ROW: subject/model/integrator/path/target/workers/bodies/substeps
#include "lr_bench/instruction_trace.h"
#include "lr_bench/measure.h"
#include "lr_bench/rows.h"
#include "lr_bench/vector_pipes.h"
#include "peers/peers.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

using namespace lr_bench;

int write_csv(const char* path, Selection selection, const Schedule& schedule) {
    std::vector<std::string> missing;
    peer_rows(1, missing);
    for (const std::string& name : missing) std::fprintf(stderr, "lr_bench: built without %s: skipped\n", name.c_str());
    std::FILE* const file = std::fopen(path, "w");
    if (!file) {
        std::fprintf(stderr, "lr_bench: cannot write %s\n", path);
        return 1;
    }
    write_head(file);
    const std::vector<std::vector<Row>> groups = select_rows(selection);
    for (size_t g = 0; g < groups.size(); ++g) {
        if (groups.size() > 1) std::fprintf(stderr, "lr_bench: group %zu of %zu\n", g + 1, groups.size());
        for (const Measured& m : measure(groups[g], make_subject, schedule, 1.0 / static_cast<double>(groups.size())))
            write_row(file, m);
        std::fflush(file);
    }
    return std::fclose(file) == 0 ? 0 : 1;
}

int run_one(const Row& row, unsigned long steps) {
    std::string why_not;
    const auto subject = make_subject(row, why_not);
    if (!subject) {
        std::fprintf(stderr, "lr_bench: %s: %s\n", why_not.c_str(), row.name().c_str());
        return 1;
    }
    for (unsigned long i = 0; i < steps; ++i)
        if (!subject->step()) return 1;
    const Facts facts = subject->facts();
    std::printf("%s %016" PRIx64 "\n", row.name().c_str(), facts.hash);
    return 0;
}

void run_benchmark(benchmark::State& state, const Row& row) {
    std::string why_not;
    const auto subject = make_subject(row, why_not);
    if (!subject) return state.SkipWithError(why_not.c_str());
    for (auto _ : state)
        if (!subject->step()) return state.SkipWithError("step");
    const double body_steps = static_cast<double>(row.bodies) * row.substeps;
    using benchmark::Counter;
    state.counters["s/body-step"] = Counter(body_steps, Counter::kIsIterationInvariantRate | Counter::kInvert);
    const Facts facts = subject->facts();
    if (facts.memory_bytes > 0.0) state.counters["bytes/body"] = facts.memory_bytes;
    if (facts.hashed) {
        char text[20];
        std::snprintf(text, sizeof text, "%016" PRIx64, facts.hash);
        state.SetLabel(text);
    }
}

int run_google(int argc, char** argv) {
    for (const std::vector<Row>& group : select_rows(Selection::usual))
        for (const Row& row : group)
            benchmark::RegisterBenchmark(row.name().c_str(), run_benchmark, row)->UseRealTime();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    const char *csv = nullptr, *one = nullptr, *trace = nullptr, *out = nullptr, *ports = nullptr;
    Selection selection = Selection::usual;
    bool list = false;
    double seconds = 0.0;
    unsigned long steps = 1;
    for (int i = 1; i < argc; ++i) {
        const auto with_value = [&](const char* name) { return std::strcmp(argv[i], name) == 0 && i + 1 < argc; };
        if (with_value("--csv"))
            csv = argv[++i];
        else if (with_value("--one"))
            one = argv[++i];
        else if (with_value("--trace"))
            trace = argv[++i];
        else if (with_value("--out"))
            out = argv[++i];
        else if (with_value("--ports"))
            ports = argv[++i];
        else if (with_value("--seconds"))
            seconds = std::strtod(argv[++i], nullptr);
        else if (with_value("--steps"))
            steps = std::strtoul(argv[++i], nullptr, 10);
        else if (std::strcmp(argv[i], "--quick") == 0)
            selection = Selection::quick;
        else if (std::strcmp(argv[i], "--full") == 0)
            selection = Selection::product;
        else if (std::strcmp(argv[i], "--list") == 0)
            list = true;
        else
            return run_google(argc, argv);
    }
    if (list)
        for (const auto& group : select_rows(selection))
            for (const Row& row : group) std::printf("%s\n", row.name().c_str());
    if (ports) return write_ports(ports);
    if (csv) {
        Schedule schedule;
        constexpr double usual[] = {40.0, 200.0, 3600.0};
        schedule.budget = seconds > 0.0 ? seconds : usual[static_cast<int>(selection)];
        schedule.burst = std::min(schedule.burst, schedule.budget / 2000.0);
        schedule.least_rounds = schedule.budget < 5.0 ? 3 : 9;
        return write_csv(csv, selection, schedule);
    }
    if (one || trace) {
        Row row;
        if (!parse_row(one ? one : trace, row)) {
            std::fprintf(stderr, "lr_bench: not the name of a row\n");
            return 1;
        }
        if (one) return run_one(row, steps);
        if (!out) return std::fprintf(stderr, "lr_bench: --trace needs --out\n"), 1;
        return write_trace(row, out);
    }
    return list ? 0 : run_google(argc, argv);
}
