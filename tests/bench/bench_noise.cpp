// The cost of noise per body and substep, on every instruction set of this processor: items are bodies.
//     bench_noise --benchmark_repetitions=9 --benchmark_report_aggregates_only=true
#include "kernel/math/lanes.h"

#include <benchmark/benchmark.h>

#include <numeric>
#include <string>

using namespace test;

int main(int argc, char** argv) {
    constexpr size_t bodies = 1024; // all fit in the first-level cache
    for (const Lanes& target : lanes()) {
        const auto add = [&](const char* what, auto draw, size_t arrays) {
            benchmark::RegisterBenchmark((std::string(target.name) + "/" + what).c_str(), [=](benchmark::State& state) {
                Aligned<uint32_t> noise_seeds(bodies);
                std::iota(noise_seeds.begin(), noise_seeds.end(), 1u);
                draw(state, noise_seeds.data(), arrays * bodies);
                state.counters["body"] =
                    benchmark::Counter(static_cast<double>(bodies),
                                       benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
            });
        };
        const auto gaussians = [](auto function) {
            return [=](benchmark::State& state, const uint32_t* noise_seeds, size_t n) {
                Aligned<float> out(n);
                uint64_t substep = 0;
                for (auto _ : state) {
                    function(noise_seeds, substep++, 1, out.data(), bodies);
                    benchmark::DoNotOptimize(out.data());
                }
            };
        };
        add("six", gaussians(target.gaussians), 6);
        add("three", gaussians(target.three_gaussians), 3);
        const auto function = target.words;
        const auto words = [=](benchmark::State& state, const uint32_t* noise_seeds, size_t n) {
            Aligned<uint32_t> out(n);
            uint64_t substep = 0;
            for (auto _ : state) {
                function(noise_seeds, substep++, 1, out.data(), bodies);
                benchmark::DoNotOptimize(out.data());
            }
        };
        add("words", words, 4);
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
