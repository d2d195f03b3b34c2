// Added mass of an ellipsoid: 320, 1280 and 5120 triangles on one thread with the dense matrix, assembly and solution;
// 20,480 and 81,920 triangles with expansions on as many threads as there are.
#include "baker/added_mass/added_mass.h"
#include "baker/added_mass/boundary_operators.h"
#include "baker/mesh_shapes.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>

namespace {

void assembly(benchmark::State& state) {
    const lr::baker::Mesh mesh = lr::test::ellipsoid(4, 2, 1, static_cast<int>(state.range(0)));
    for (auto _ : state) {
        const lr::baker::BoundaryOperators op =
            lr::baker::assemble_boundary_operators(mesh, lr::baker::closed_basis(mesh), [](double) {});
        benchmark::DoNotOptimize(op.hypersingular.data());
    }
    state.counters["triangles"] = static_cast<double>(mesh.faces.size());
}

void added_mass(benchmark::State& state) {
    const lr::baker::Mesh mesh = lr::test::ellipsoid(4, 2, 1, static_cast<int>(state.range(0)));
    for (auto _ : state) {
        lr::baker::AddedMass result;
        lr::Faults faults;
        if (!lr::baker::compute_added_mass(mesh, {0, 0, 0}, result, faults)) state.SkipWithError("no result");
        benchmark::DoNotOptimize(result.value.data());
    }
    state.counters["triangles"] = static_cast<double>(mesh.faces.size());
}

double megabytes_in_use() {
    double pages = 0.0;
    if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
        unsigned long all = 0, resident = 0;
        if (std::fscanf(file, "%lu %lu", &all, &resident) == 2) pages = static_cast<double>(resident);
        std::fclose(file);
    }
    return pages * 4096e-6;
}

void added_mass_fast(benchmark::State& state) {
    const lr::baker::Mesh mesh = lr::test::ellipsoid(4, 2, 1, static_cast<int>(state.range(0)));
    double iterations = 0.0, megabytes = 0.0;
    for (auto _ : state) {
        lr::baker::AddedMass result;
        lr::Faults faults;
        const auto progress = [&](double) { megabytes = std::max(megabytes, megabytes_in_use()); };
        if (!lr::baker::compute_added_mass(mesh, {0, 0, 0}, result, faults, progress)) state.SkipWithError("no result");
        benchmark::DoNotOptimize(result.value.data());
        iterations = static_cast<double>(result.iterations);
    }
    state.counters["triangles"] = static_cast<double>(mesh.faces.size());
    state.counters["iterations"] = iterations;
    state.counters["megabytes"] = megabytes;
}

BENCHMARK(assembly)->DenseRange(2, 4)->Unit(benchmark::kMillisecond);
BENCHMARK(added_mass)->DenseRange(2, 4)->Unit(benchmark::kMillisecond);
BENCHMARK(added_mass_fast)->DenseRange(5, 6)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

} // namespace

BENCHMARK_MAIN();
