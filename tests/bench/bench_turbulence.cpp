// Turbulence tables, one thread: the paper's empty stream on 32x32x8, and the wake of a leaf.
#include "baker/mesh/mass_properties.h"
#include "baker/mesh_shapes.h"
#include "baker/turbulence/pressure_projection.h"
#include "baker/turbulence/stream_body.h"
#include "baker/turbulence/turbulence.h"

#include <benchmark/benchmark.h>

namespace {

using namespace lr;
using namespace lr::baker;

TurbulenceOptions leaf(const std::array<uint32_t, 3>& cells) {
    TurbulenceOptions o;
    o.cells = cells;
    o.u0 = 0.74;
    o.length_l = 0.02;
    o.length_d = 0.08;
    o.viscosity = 1.5e-5;
    return o;
}

bool put_leaf(TurbulenceOptions& o) {
    Mesh mesh = test::leaf(40, 10, 0.01, 0.15);
    for (Eigen::Vector3d& v : mesh.vertices) v *= 0.5 * o.length_d;
    const MassProperties p = compute_mass_properties(mesh);
    Faults faults;
    return put_in_stream(mesh, p.axes, p.projected_areas, o, faults);
}

void run(benchmark::State& state, const TurbulenceOptions& o) {
    TurbulenceTable table;
    for (auto _ : state) {
        Faults faults;
        if (!compute_turbulence_table(o, table, faults)) state.SkipWithError("no table");
        benchmark::DoNotOptimize(table.chi.data());
    }
    state.counters["steps"] = table.steps;
    state.counters["pressure iterations"] = static_cast<double>(table.pressure_iterations) / (table.steps + 1.0);
    state.counters["chi*"] = table.stationary_chi_star;
    state.counters["epsilon*"] = table.stationary_epsilon_star;
}

void empty_stream(benchmark::State& state) {
    run(state, leaf({32, 32, 8}));
}

void wake(benchmark::State& state) {
    const auto n = static_cast<uint32_t>(state.range(0));
    TurbulenceOptions o = leaf({n, n, n / 2});
    if (!put_leaf(o)) state.SkipWithError("no body");
    run(state, o);
}

// A projection of the stream at its sudden start around the leaf, from zero, to 1e-9.
void projection(benchmark::State& state) {
    const auto n = static_cast<uint32_t>(state.range(0));
    TurbulenceOptions o = leaf({n, n, n / 2});
    if (!put_leaf(o)) state.SkipWithError("no body");
    MacGrid grid(o.cells, o.domain_lengths);
    for (double& u : grid.velocity[0].values) u = 1.0;
    grid.set_solid(o.solid, o.closed_faces);
    double iterations = 0.0;
    for (auto _ : state) {
        MacGrid flow = grid;
        PressureProjection solver(flow);
        iterations = solver.project(flow).iterations;
    }
    state.counters["iterations"] = iterations;
}

BENCHMARK(empty_stream)->Unit(benchmark::kMillisecond);
BENCHMARK(wake)->Arg(32)->Arg(64)->Arg(96)->Unit(benchmark::kMillisecond);
BENCHMARK(projection)->Arg(32)->Arg(64)->Arg(96)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
