#include "tools/lr_scorecard/row.h"

#include "tools/lr_scorecard/parallel.h"

#include <algorithm>
#include <cmath>

namespace lr::scorecard {

bool Check::within() const {
    if (!std::isfinite(value)) return rule == Rule::shown;
    switch (rule) {
    case Rule::relative:
    case Rule::compared:
        return std::abs(value / reference - 1.0) <= tolerance;
    case Rule::absolute:
        return std::abs(value - reference) <= tolerance;
    case Rule::at_most:
        return value <= reference;
    case Rule::at_least:
        return value >= reference;
    case Rule::shown:
        return true;
    }
    return false;
}

void RowResult::add(std::string what, Rule rule, double value, double reference, double tolerance, std::string unit) {
    checks.push_back({std::move(what), rule, value, reference, tolerance, std::move(unit)});
}

void RowResult::show(std::string what, double value, std::string unit) {
    add(std::move(what), Rule::shown, value, 0.0, 0.0, std::move(unit));
}

bool RowResult::holds() const {
    return std::all_of(checks.begin(), checks.end(), [](const Check& c) { return c.holds(); });
}

void Context::parallel(size_t count, const std::function<void(size_t)>& job) const {
    scorecard::parallel(threads, count, job, progress);
}

std::span<const Row> all_rows() {
    static constexpr Row rows[] = {
        {"kirchhoff", "exact", "Force-free motion keeps energy, |p| and p.l", "exact", 1.0, 0.15, run_kirchhoff},
        {"sphere", "exact", "A spinning force-free sphere goes straight", "exact", 0.05, 0.05, run_sphere},
        {"galilean", "exact", "In a uniform wind as in still air, carried along", "exact", 0.05, 0.05, run_galilean},
        {"buoyancy", "exact", "Buoyancy above the centre of mass is stable, below is not", "linear theory", 0.05, 0.05,
         run_buoyancy},
        {"lamb", "exact", "Added mass of ellipsoids", "Lamb, Hydrodynamics, art. 114-115", 1.7, 0.4, run_lamb},
        {"thin-disc", "exact", "Added mass of a thin disc", "Lamb, art. 102, 108", 1.2, 0.4, run_thin_disc},
        {"rectangles", "exact", "Added mass of rectangles without thickness", "published values; physics.md, 2.2", 1.6,
         1.3, run_rectangles},
        {"k-epsilon", "exact", "Decay, shear, divergence and grid of the turbulence tables", "closed forms", 4.0, 4.0,
         run_k_epsilon},
        {"langevin", "exact", "Stationary Langevin velocity: variance and autocorrelation", "Pope 1994", 0.5, 0.2,
         run_langevin},
        {"card", "exact", "Falling card in two dimensions", "Andersen, Pesavento and Wang 2005", 0.8, 0.2, run_card},
        {"discs", "measured", "Paper discs dropped flat and edge-on", "Howison, Hughes, Giardina and Iida 2020", 10.0,
         9.0, run_discs},
        {"time-step", "measured", "The same discs at 1/60 and 1/30 s, 1 substep, against 1 ms", "own, converged", 26.0,
         12.0, run_time_step},
        {"steady-drag", "measured", "Drag of a disc held broadside", "Hoerner 1965; Clift, Grace and Weber 1978", 0.6,
         0.6, run_steady_drag},
        {"leaves", "measured", "Descent of leaves of 0.08 kg/m^2", "typical speeds", 1.0, 1.0, run_leaves},
        {"phase-map", "measured", "Discs over Re and I*: steady, periodic, chaotic, tumbling",
         "Field et al. 1997; Tinklenberg et al. 2023", 70.0, 16.0, run_phase_map},
        {"turbulence-fall", "measured", "Small discs fall slower in turbulent air", "Tinklenberg et al. 2024", 10.0,
         3.0, run_turbulence_fall},
        {"seed", "measured", "Winged seeds turn about the vertical", "published speeds of maple seeds; Green 1980", 8.0,
         3.0, run_seed},
        {"dart", "measured", "A folded dart glides, stalls, turns", "known behaviour", 4.0, 2.0, run_dart},
        {"cap", "measured", "Caps fall with their convex side down", "known behaviour", 4.0, 2.0, run_cap},
        {"bowls", "measured", "Paper cones and half a sphere fall with their convex side down", "Hoerner 1965", 4.0,
         2.0, run_bowls},
        {"curled-leaf", "measured", "Curled and twisted leaves turn about the vertical", "known behaviour", 4.0, 2.0,
         run_curled_leaf},
        {"holes", "measured", "Discs that tumble flutter with a hole", "Vincent, Shambaugh and Kanso 2016", 5.0, 2.0,
         run_holes},
        {"strips", "measured", "Paper strips turn about their length and drift",
         "Smith 1970; Iversen 1979; Wang et al. 2013", 5.0, 2.0, run_strips},
        {"cross", "measured", "A cross is no compact disc", "known behaviour", 3.0, 1.0, run_cross},
        {"snow", "measured", "Dendritic snow crystals fall flat and rock", "Nakaya and Terada 1935", 3.0, 1.0,
         run_snow},
        {"solids", "measured", "Solids, rods and spheroids sink in water",
         "Haider and Levenspiel 1989; Toupoint, Ern and Roig 2019", 2.0, 1.0, run_solids},
        {"leaf", "paper", "The paper's leaf released at 75 and 30 degrees", "paper, Fig. 3", 0.2, 0.1, run_leaf},
        {"paper-plane", "paper", "The paper's plane of 8.3 cm at 0.2 m/s", "paper, Fig. 4", 0.6, 0.6, run_paper_plane},
        {"rubber-ellipsoid", "paper", "Rubber ellipsoid in water, with and without turbulent loads", "paper, Fig. 5",
         0.1, 0.1, run_rubber_ellipsoid},
        {"tables", "paper", "Turbulence table at Re 3.8e3 on 32x32x16", "paper, Fig. 2", 0.2, 0.2, run_tables},
        {"cost", "paper", "Time of a step and of a bake", "paper, section 7 and Table 2", 0.6, 0.4, run_cost}};
    return rows;
}
} // namespace lr::scorecard
