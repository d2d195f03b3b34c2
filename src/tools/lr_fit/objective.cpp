#include "tools/lr_fit/objective.h"

#include "tools/lr_scorecard/measured_bodies.h"
#include "tools/lr_scorecard/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lr::fit {
namespace {

using namespace scorecard;

double square(double x) {
    return x * x;
}

constexpr double lightest = 1e-3; // I*

double excess(double x, double limit) {
    return std::max(0.0, std::abs(x) - limit);
}

// One cell of paper discs; docs/maintainers/measurements.md, "Falls of discs", has the tolerances.
void add_cell(const MeasuredCell& cell, const CellStatistics& ours, Score& score) {
    for (size_t q = 0; q < quantities.size(); ++q) {
        const double off = ours.quantity[q].mean / cell.mean[q] - 1.0;
        score.means += std::abs(off) <= 0.15;
        score.worst_mean = std::max(score.worst_mean, std::abs(off));
        // Means: by their tolerance, and steeply from 11 % on, so that few end just outside.
        score.misfit += 0.5 * square(off / 0.15) + 0.5 * square(excess(off, 0.11) / 0.04);
    }
    const double spread = ours.vz.deviation / cell.vz_deviation - 1.0;
    score.spreads += std::abs(spread) <= 0.2;
    // Standard deviation of vz: likewise, but bounded, because no coefficients fit every cell.
    score.misfit += 0.7 * square(spread / 0.2) + std::min(8.0, 0.8 * square(excess(spread, 0.15) / 0.05));
    const std::array<double, 5> vz{ours.vz.p5, ours.vz.p25, ours.vz.p50, ours.vz.p75, ours.vz.p95};
    for (size_t k = 0; k < vz.size(); ++k) {
        const double off = vz[k] - cell.vz[k];
        score.quantiles += std::abs(off) <= 0.12;
        score.misfit += 0.4 * square(off / 0.12); // quantiles of vz, m/s
    }
    if (cell.release != Release::flat) return;
    const double late = excess(ours.sideways.p50 - 0.475, 0.125);
    score.sideways += late == 0.0;
    score.misfit += square(late / 0.05); // median time to 5 cm sideways, s
}
} // namespace

Objective::Objective(uint32_t threads) {
    phase_options_.step = 0.02; // coarser and shorter than in the scorecard
    phase_options_.duration = 150.0;
    std::vector<double> inertia;
    for (const ExpectedPoint& e : expected_points()) {
        if (inertia.empty() || inertia.back() != e.at.inertia) inertia.push_back(e.at.inertia);
        map_.push_back({e, inertia.size() - 1});
    }
    // Near the onset: three points for each I*, so that even every other point of the map has some on both sides.
    for (const double i : {0.001, 0.004, 0.01, 0.02, 0.04}) {
        inertia.push_back(i);
        for (const double reynolds : {83.0, 140.0, 155.0}) {
            const auto regime = reynolds < first_onset ? falls::Regime::steady : falls::Regime::periodic;
            map_.push_back({{{reynolds, i}, regime}, inertia.size() - 1});
        }
    }
    paper_.resize(measured_cells().size());
    map_discs_.resize(inertia.size());
    parallel(threads, paper_.size(), [&](size_t i) { paper_[i] = bake_cell(measured_cells()[i]); });
    parallel(threads, inertia.size(), [&](size_t i) { map_discs_[i] = phase_disc(inertia[i], phase_options_); });
    for (const SmallDisc& disc : small_discs) small_.push_back(disc_sinking_at(disc.reynolds, disc.diameter));
}

Score Objective::score(const PlateCoefficients& coefficients, const Effort& effort, uint32_t threads,
                       const std::function<void(double)>& progress) const {
    constexpr double paper_part = 0.25; // of the time
    const auto part_of = [&](double from, double to) -> std::function<void(double)> {
        if (!progress) return {};
        return [&progress, from, to](double part) { progress(from + part * (to - from)); };
    };
    const Loads loads = loads_with(coefficients);
    Score out;

    DiscFallOptions falls;
    falls.loads = loads;
    falls.falls = effort.falls;
    falls.dt = static_cast<float>(1.0 / frame_rate);
    falls.substeps = effort.substeps;
    falls.seed = 100;
    std::vector<CellStatistics> cells(paper_.size());
    const auto run_cell = [&](size_t i) {
        cells[i] = summarise_falls(drop_cell(measured_cells()[i], paper_[i], falls));
    };
    parallel(threads, cells.size(), run_cell, part_of(0.0, paper_part));
    for (size_t i = 0; i < cells.size(); ++i) add_cell(measured_cells()[i], cells[i], out);
    constexpr double most_of_rest = 200.0; // more than all terms below can add up to
    if (!std::isfinite(out.misfit)) out.misfit = 1e9;
    if (out.misfit >= effort.hopeless) {
        out.misfit += most_of_rest;
        return out;
    }

    PhaseOptions phase = phase_options_;
    phase.loads = loads;
    phase.seeds = effort.map_seeds;
    const size_t points = (map_.size() + effort.map_stride - 1) / effort.map_stride;
    std::vector<double> agreeing(points); // share of the releases
    std::vector<double> drag(points);     // of the lightest discs
    const auto run_rest = [&](size_t i) { // longest jobs first
        if (i < small_.size()) {
            out.tumbling[i] = drop_small_disc(small_discs[i], small_[i], effort.small_falls, 1000.0, loads).tumbling;
            return;
        }
        const MapPoint& p = map_[(i - small_.size()) * effort.map_stride];
        const PhaseResult fell = run_phase_point(map_discs_[p.disc], p.expected.at, phase);
        agreeing[i - small_.size()] = fell.share[static_cast<size_t>(p.expected.regime)];
        if (p.expected.at.inertia < lightest) drag[i - small_.size()] = fell.drag;
    };
    parallel(threads, small_.size() + points, run_rest, part_of(paper_part, 1.0));
    double mean = 0.0;
    for (double share : agreeing) {
        out.map += (share > 0.5 ? 1.0 : 0.0) / static_cast<double>(points);
        mean += share / static_cast<double>(points);
    }
    // The map: half by agreeing points, half by releases, which change more smoothly.
    out.misfit += 60.0 * (1.0 - 0.5 * out.map - 0.5 * mean);
    // Discs with hardly any inertia must not hover.
    out.drag = *std::max_element(drag.begin(), drag.end());
    for (double d : drag) out.misfit += 2.0 * std::clamp(d - 2.0, 0.0, 4.0);
    // Most discs of 1 mm must tumble, and more than those of 3 mm.
    out.misfit +=
        10.0 * std::max(0.0, 0.6 - out.tumbling[0]) + 5.0 * std::max(0.0, out.tumbling[1] - out.tumbling[0] + 0.2);
    return out;
}

std::string describe(const Score& s) {
    const size_t cells = measured_cells().size();
    const auto flat = std::count_if(measured_cells().begin(), measured_cells().end(),
                                    [](const MeasuredCell& c) { return c.release == Release::flat; });
    char text[512];
    std::snprintf(text, sizeof text,
                  "misfit %.2f\n"
                  "means within 15 %%: %d of %zu, the worst %.0f %% off\n"
                  "spreads of the descent within 20 %%: %d of %zu\n"
                  "quantiles of the descent within 0.12 m/s: %d of %zu\n"
                  "times to 5 cm sideways within 0.35 to 0.6 s: %d of %td\n"
                  "phase map: %.2f of the points; drag of the lightest discs up to %.1f times that broadside\n"
                  "tumbling: %.2f of the discs of 1 mm, %.2f of 3 mm\n",
                  s.misfit, s.means, 5 * cells, 100.0 * s.worst_mean, s.spreads, cells, s.quantiles, 5 * cells,
                  s.sideways, flat, s.map, s.drag, s.tumbling[0], s.tumbling[1]);
    return text;
}
} // namespace lr::fit
