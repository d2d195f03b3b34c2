#include "baker/turbulence/turbulence.h"

#include "baker/fault_text.h"
#include "baker/turbulence/k_epsilon.h"
#include "baker/turbulence/mean_flow.h"
#include "baker/turbulence/turbulence_production.h"
#include "baker/turbulence/wake_history.h"
#include "baker/turbulence/wake_probe.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace lr::baker {

namespace {

using shape::TurbulenceState;

constexpr size_t max_cells = size_t{1} << 22;
constexpr double max_steps = 1e5;
// Largest change of a step, over U0, of a steady flow, which is not computed further.
constexpr double steady_change = 1e-12;
// Time step of the wake, and the time over which it must be steady, in w/U0 with the body's breadth w. The step and its error are the same on all
// grids; the advection error falls with the square of the cell size.
constexpr double wake_step = 0.1, settled_window = 2.0;
constexpr double wake_passages = 4.0;
constexpr double most_wake_k = 1.5; // in U0^2: an intensity of 100 %
// Divergence left in a wake, in U0/d.
constexpr double enough_divergence = 1e-7;

// Units are U0 and l, so that bodies of any size and speed get the same arithmetic.
struct Scales {
    bool wake;        // a solid is in the stream
    double d;         // length_d/l
    GridPoint domain; // lengths
    GridPoint body;   // position
    double width;     // breadth of the body
    double dt;        // without a solid: one cell per step, so that uniform advection is exact
    double duration;  // of the table
    double run;       // longest time simulated
    double viscosity; // nu/(U0 l)
};

struct Sample {
    double t;
    TurbulenceState state;
    double strain; // at the particle, until the next sample
};

bool in_range(double x, double low, double high) {
    return x > low && x <= high;
} // false for NaN

Scales find_scales(const TurbulenceOptions& o) {
    Scales s{};
    const auto any = [](const std::vector<uint8_t>& mask) {
        return std::any_of(mask.begin(), mask.end(), [](uint8_t cell) { return cell != 0; });
    };
    s.wake = any(o.solid) || std::any_of(o.closed_faces.begin(), o.closed_faces.end(), any);
    s.d = o.length_d / o.length_l;
    for (size_t a = 0; a < 3; ++a) s.domain[a] = o.domain_lengths[a] * s.d;
    s.body = {0.25 * s.domain[0], 0.5 * s.domain[1], 0.5 * s.domain[2]};
    if (s.wake) {
        const double wy = o.body_box[1][1] - o.body_box[0][1], wz = o.body_box[1][2] - o.body_box[0][2];
        s.width = std::max(std::sqrt(wy * wz), 0.1 * o.length_d) / o.length_l;
        if (!(wy > 0.0 && wz > 0.0)) s.width = s.d;
        s.dt = wake_step * s.width;
        s.duration = wake_passages * s.domain[0];
        if (o.duration_star > 0.0) s.duration = o.duration_star;
        s.run = std::max(s.duration, wake_passages * s.domain[0]);
    } else {
        s.dt = s.domain[0] / o.cells[0];
        const double chi0 = shape::turbulent_frequency(shape::inflow_state(1.0, o.intensity, 1.0));
        s.duration = o.duration_star > 0.0 ? o.duration_star : 9.0 / ((shape::c_epsilon_2 - 1.0) * chi0);
        s.run = s.duration;
    }
    s.viscosity = o.viscosity / (o.u0 * o.length_l);
    return s;
}

void check_options(const TurbulenceOptions& o, Faults& faults) {
    const auto fault = [&](const char* where, std::string what, const char* remedy) {
        faults.push_back({FaultId::parameter_out_of_range, Severity::error, where, std::move(what), remedy});
    };
    size_t cells = 1;
    for (size_t a = 0; a < 3; ++a) {
        cells *= o.cells[a];
        if (o.cells[a] < 4 || o.cells[a] > 512) {
            fault("turbulence.cells", "The grid has " + std::to_string(o.cells[a]) + " cells along an axis.",
                  "Give 4 to 512 cells along each axis.");
            return;
        }
    }
    if (cells > max_cells)
        fault("turbulence.cells", "The grid has " + std::to_string(cells) + " cells.",
              "Give at most 4194304 cells, for instance 160 along each axis.");
    if (!in_range(o.intensity, 0.0, 10.0) || o.intensity < 1e-6)
        fault("turbulence.intensity", "The turbulence intensity is " + std::to_string(o.intensity) + ".",
              "Give an intensity from 0.000001 to 10; 1 is the paper's 100 %.");
    const std::pair<const char*, double> sizes[] = {{"turbulence.u0", o.u0},
                                                    {"turbulence.length_l", o.length_l},
                                                    {"turbulence.length_d", o.length_d},
                                                    {"turbulence.viscosity", o.viscosity}};
    for (const auto& [where, value] : sizes)
        if (!in_range(value, 1e-12, 1e12))
            fault(where, "The value " + std::to_string(value) + " is not a finite positive SI quantity.",
                  "Give a finite positive number in SI units, between 1e-12 and 1e12.");
    for (double length : o.domain_lengths)
        if (!in_range(length, 0.0, 1e4) || length < 1e-2)
            fault("turbulence.domain_lengths", "A side of the domain is " + std::to_string(length) + " d.",
                  "Give sides of 0.01 to 10000 times the characteristic length d.");
    if (!(o.duration_star >= 0.0 && o.duration_star <= 1e9))
        fault("turbulence.duration_star", "The duration is " + std::to_string(o.duration_star) + " l/U0.",
              "Give 0 for the automatic duration, or at most 1e9.");
    if (o.samples < 2 || o.samples > 65536)
        fault("turbulence.samples", "The table has " + std::to_string(o.samples) + " samples.",
              "Give 2 to 65536 samples.");
    if (has_error(faults)) return;

    const Scales s = find_scales(o);
    if (s.wake || o.initial_velocity) {
        if (s.run / s.dt > max_steps)
            fault("turbulence.duration_star", "The flow would take more than 100000 steps.",
                  "Shorten duration_star, coarsen the grid, or give a length l closer to d.");
    }
    for (const std::vector<uint8_t>* mask : {&o.solid, &o.closed_faces[0], &o.closed_faces[1], &o.closed_faces[2]})
        if (!mask->empty() && mask->size() != cells) {
            fault("turbulence.solid",
                  "A mask of the body has " + std::to_string(mask->size()) + " entries for " + std::to_string(cells) +
                      " cells.",
                  "Give one entry per cell, x fastest, or none.");
            return;
        }
    if (std::any_of(o.closed_faces.begin(), o.closed_faces.end(), [](const auto& mask) { return !mask.empty(); })) {
        bool good = true;
        for (size_t a = 0; a < 3; ++a)
            good = good && o.body_box[0][a] <= o.body_box[1][a] && std::abs(o.body_box[0][a]) < 1e12 &&
                   std::abs(o.body_box[1][a]) < 1e12;
        if (!good) {
            fault("turbulence.body_box", "The box of the body is not finite, or its corners are swapped.",
                  "Give its lowest and its highest corner in the domain, in m.");
            return;
        }
    }
    if (o.solid.empty()) return;
    for (size_t row = 0; row < cells; row += o.cells[0])
        if (o.solid[row] != 0 || o.solid[row + o.cells[0] - 1] != 0) {
            fault("turbulence.solid", "The solid reaches the inflow or the outflow.",
                  "Lengthen the domain, or keep the first and last layer of cells fluid.");
            return;
        }
}

bool set_velocity(MacGrid& grid, const TurbulenceOptions& o, Faults& faults) {
    for (size_t a = 0; a < 3; ++a) {
        GridField& field = grid.velocity[a];
        for (uint32_t k = 0; k < field.count[2]; ++k)
            for (uint32_t j = 0; j < field.count[1]; ++j)
                for (uint32_t i = 0; i < field.count[0]; ++i) {
                    double value = a == 0 ? 1.0 : 0.0;
                    if (o.initial_velocity) {
                        const GridPoint p = field.position(i, j, k);
                        value = o.initial_velocity({p[0] * o.length_l, p[1] * o.length_l, p[2] * o.length_l})[a] / o.u0;
                    }
                    if (!(std::abs(value) <= 1e6)) {
                        faults.push_back({FaultId::parameter_out_of_range, Severity::error,
                                          "turbulence.initial_velocity",
                                          "The initial velocity is not finite or above a million times U0.",
                                          "Return finite velocities in m/s."});
                        return false;
                    }
                    field.values[field.index(i, j, k)] = value;
                }
    }
    return true;
}

struct Run {
    std::vector<Sample> history;
    bool particle_left = false; // after the last sample the particle's turbulence decays
    WakeSummary wake;
    double max_divergence = 0.0;
    long pressure_iterations = 0;
    bool converged = true;
};

WakeProbe make_probe(const TurbulenceOptions& o, const Scales& scales, const MacGrid& grid) {
    if (!scales.wake) return {};
    std::array<GridPoint, 2> box = o.body_box;
    for (GridPoint& corner : box)
        for (double& x : corner) x /= o.length_l;
    return {grid, box, scales.d};
}

// Algorithm 1.
Run run_flow(const TurbulenceOptions& o, const Scales& scales, MacGrid grid, const WakeProbe& probe,
             const std::function<void(double)>& progress) {
    Run run;
    const bool wake = scales.wake;
    const auto window = static_cast<size_t>(std::ceil(settled_window * scales.width / scales.dt));
    std::vector<TurbulenceState> states;
    MeanFlow flow(std::move(grid), wake ? enough_divergence / scales.d : 0.0);
    const TurbulenceState inflow = shape::inflow_state(1.0, o.intensity, 1.0);
    KEpsilon turbulence(flow.grid, inflow, wake ? std::max(most_wake_k, inflow.k) : 0.0);
    turbulence.follow(flow.grid, scales.dt);
    std::vector<double> viscosity;
    GridPoint particle = scales.body;
    const auto particle_strain = [&] {
        uint32_t at[3];
        for (size_t a = 0; a < 3; ++a)
            at[a] = static_cast<uint32_t>(
                std::clamp(particle[a] / flow.grid.spacing[a], 0.0, static_cast<double>(o.cells[a] - 1)));
        return turbulence.strain_at(at[0], at[1], at[2]);
    };
    const auto record = [&](double t) {
        run.history.push_back(wake ? Sample{t, probe.mean(turbulence), 0.0}
                                   : Sample{t, turbulence.at(particle), particle_strain()});
        if (wake) states.push_back(run.history.back().state);
    };
    record(0.0);

    bool steady = false;
    const double end = wake ? scales.run : scales.duration;
    for (uint32_t n = 1; run.history.back().t < end; ++n) {
        if (!wake) {
            const GridPoint next = flow.grid.trace_back(particle, -scales.dt);
            // Stops one cell before the outflow, so that the particle never gets the k of the boundary.
            if (next[0] > scales.domain[0] - flow.grid.spacing[0]) {
                run.particle_left = true;
                break;
            }
            particle = next;
        }
        bool diffuse = false;
        if (!steady) {
            diffuse = o.diffusion && turbulence.largest_strain() > steady_change;
            if (diffuse) {
                turbulence.eddy_viscosity(viscosity);
                for (double& nu : viscosity)
                    if (nu > 0.0) nu += scales.viscosity;
            }
            flow.step(scales.dt, diffuse ? &viscosity : nullptr);
            if (flow.last_change() > steady_change) turbulence.follow(flow.grid, scales.dt);
            // With diffusion nu_T keeps changing, so only a flow without diffusion is known to stay steady.
            steady = !diffuse && flow.last_change() <= steady_change;
        }
        turbulence.step(scales.dt);
        if (diffuse) turbulence.diffuse(scales.dt, scales.viscosity);
        record(n * scales.dt);
        if (progress) progress(std::min(run.history.back().t / end, 1.0));
        if (wake && run.history.back().t >= scales.domain[0] && is_stationary(states, window)) break;
    }
    if (wake) run.wake = summarise_wake(states, window);
    run.max_divergence = flow.max_divergence();
    run.pressure_iterations = flow.pressure_iterations();
    run.converged = flow.converged();
    return run;
}

// Between two samples: the local solution from the first, plus a correction proportional to the elapsed fraction, so that it ends at the second.
// Exact for decay and for constant strain with any step.
TurbulenceState state_at(const std::vector<Sample>& history, bool particle_left, double t, size_t& from) {
    while (from + 1 < history.size() && history[from + 1].t <= t) ++from;
    const Sample& a = history[from];
    if (from + 1 == history.size()) return particle_left ? shape::decay(a.state, t - a.t) : a.state;
    const Sample& b = history[from + 1];
    const double step = b.t - a.t, share = (t - a.t) / step;
    const TurbulenceState whole = shape::evolve(a.state, a.strain, step);
    TurbulenceState s = shape::evolve(a.state, a.strain, t - a.t);
    s.k *= std::pow(b.state.k / whole.k, share);
    s.epsilon *= std::pow(b.state.epsilon / whole.epsilon, share);
    return s;
}

void fill_table(const TurbulenceOptions& o, const Scales& scales, const Run& run, TurbulenceTable& table) {
    const double time_unit = o.length_l / o.u0, u2 = o.u0 * o.u0;
    const double step = scales.duration / static_cast<double>(o.samples - 1);
    table.dt = step * time_unit;
    table.u0 = o.u0;
    table.l = o.length_l;
    table.intensity = o.intensity;
    table.cells = o.cells;
    table.steps = static_cast<uint32_t>(run.history.size() - 1);
    table.max_divergence = run.max_divergence * scales.d;
    table.pressure_iterations = static_cast<uint32_t>(run.pressure_iterations);
    table.wake = scales.wake;
    table.domain_lengths = o.domain_lengths;
    TurbulenceState stationary = run.history.front().state;
    table.settled = true;
    const uint32_t last = o.samples - 1;
    if (scales.wake) {
        stationary = run.wake.mean;
        table.settled = run.wake.end != WakeEnd::unsettled;
        table.stationary_index = last;
        if (run.wake.end == WakeEnd::stationary)
            table.stationary_index =
                static_cast<uint32_t>(std::min<double>(std::ceil(run.history[run.wake.begin].t / step), last));
        if (run.wake.end == WakeEnd::loop) {
            const double period = std::round(static_cast<double>(run.wake.count) * scales.dt / step);
            table.loop_end = last;
            table.loop_begin = last - static_cast<uint32_t>(std::clamp<double>(period, 1.0, last));
        }
    }
    size_t from = 0;
    for (uint32_t n = 0; n < o.samples; ++n) {
        const bool held = scales.wake && n >= table.stationary_index;
        const TurbulenceState s = held ? stationary : state_at(run.history, run.particle_left, n * step, from);
        table.t.push_back(n * table.dt);
        table.k.push_back(s.k * u2);
        table.chi.push_back(shape::turbulent_frequency(s) / time_unit);
        table.epsilon.push_back(s.epsilon * u2 / time_unit);
    }
    table.stationary_chi_star = shape::turbulent_frequency(stationary);
    table.stationary_epsilon_star = stationary.epsilon;
    table.r_lambda = shape::taylor_reynolds(stationary, scales.viscosity);
    table.c0 = shape::kolmogorov_c0(table.r_lambda);
}
} // namespace

std::array<double, 3> body_position(const TurbulenceOptions& o) {
    return {0.25 * o.domain_lengths[0] * o.length_d, 0.5 * o.domain_lengths[1] * o.length_d,
            0.5 * o.domain_lengths[2] * o.length_d};
}

bool compute_turbulence_table(const TurbulenceOptions& options, TurbulenceTable& table, Faults& faults,
                              const std::function<void(double)>& progress) {
    Faults found;
    check_options(options, found);
    if (!has_error(found)) {
        const Scales scales = find_scales(options);
        MacGrid grid(options.cells, scales.domain);
        if (set_velocity(grid, options, found)) {
            grid.set_solid(options.solid, options.closed_faces);
            bool open = true;
            for (uint32_t k = 0; k < options.cells[2]; ++k)
                for (uint32_t j = 0; j < options.cells[1]; ++j) open = open && grid.solid[grid.cell(0, j, k)] == 0;
            if (!open) {
                found.push_back({FaultId::parameter_out_of_range, Severity::error, "turbulence.solid",
                                 "The solid blocks the stream.",
                                 "Widen the domain so that fluid can pass around the body."});
            } else if (const WakeProbe probe = make_probe(options, scales, grid); scales.wake && probe.empty()) {
                found.push_back({FaultId::parameter_out_of_range, Severity::error, "turbulence.body_box",
                                 "No fluid is around the body or behind it.",
                                 "Give the box of the body within the domain, with space behind it."});
            } else {
                const Run run = run_flow(options, scales, std::move(grid), probe, progress);
                if (run.converged) {
                    TurbulenceTable made;
                    fill_table(options, scales, run, made);
                    table = std::move(made);
                } else {
                    found.push_back({FaultId::parameter_out_of_range, Severity::error, "turbulence.domain_lengths",
                                     "The pressure solve did not converge on this grid.",
                                     "Use cells whose sides differ by less than a factor of ten."});
                }
            }
        }
    }
    const bool good = !has_error(found);
    faults.insert(faults.end(), found.begin(), found.end());
    if (good && progress) progress(1.0);
    return good;
}
} // namespace lr::baker
