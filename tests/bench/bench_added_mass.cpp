// Added mass of an ellipsoid of 320, 1280 and 5120 triangles, assembly and solution, on one thread.
#include "baker/added_mass.h"
#include "baker/boundary_operators.h"
#include "baker/mesh_shapes.h"

#include <benchmark/benchmark.h>

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

BENCHMARK(assembly)->DenseRange(2, 4)->Unit(benchmark::kMillisecond);
BENCHMARK(added_mass)->DenseRange(2, 4)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
