// A row of the scorecard: measurement, reference and result.
#pragma once

#include "tools/lr_scorecard/runtime_handles.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace lr::scorecard {

enum class Rule : uint8_t {
    relative, // |value/reference - 1| <= tolerance
    absolute, // |value - reference| <= tolerance
    at_most,  // value <= reference
    at_least, // value >= reference
    compared, // as relative, but without a verdict: another check counts it
    shown     // no verdict
};

struct Check {
    std::string what;
    Rule rule = Rule::shown;
    double value = 0.0, reference = 0.0, tolerance = 0.0;
    std::string unit;

    bool within() const; // false for a value that is not finite, except with Rule::shown
    bool holds() const { return rule == Rule::compared || within(); }
};

struct Picture {
    std::string file, svg, caption;
};

struct RowResult {
    std::vector<Check> checks;
    std::vector<Picture> pictures;
    std::vector<std::string> remarks; // text below the numbers
    double seconds = 0.0;

    void add(std::string what, Rule rule, double value, double reference, double tolerance, std::string unit = "");
    void show(std::string what, double value, std::string unit = "");
    bool holds() const;
};

struct LoadChoice {
    std::string name;
    int32_t model;
};

class Context {
public:
    bool quick = false;
    uint32_t seeds = 600; // falls per cell of discs and set of seeds
    uint32_t phase_seeds = 48;
    uint32_t threads = 1;
    LoadChoice loads{"default", LR_LOADS_DEFAULT}; // for rows without loads of their own
    std::function<void(double)> progress;          // of the running row, 0 to 1; can be empty

    // Runs the independent jobs 0 to count - 1 on `threads` threads and reports progress. Rethrows a job's exception.
    void parallel(size_t count, const std::function<void(size_t)>& job) const;
};

struct Row {
    const char* id;
    const char* group; // exact, measured, paper
    const char* title;
    const char* source; // of the reference
    double seconds;     // expected on one core, for the time left
    double quick_seconds;
    RowResult (*run)(const Context&);
};

// In the order of the report.
std::span<const Row> all_rows();

RowResult run_kirchhoff(const Context&);
RowResult run_sphere(const Context&);
RowResult run_galilean(const Context&);
RowResult run_buoyancy(const Context&);
RowResult run_lamb(const Context&);
RowResult run_thin_disc(const Context&);
RowResult run_rectangles(const Context&);
RowResult run_k_epsilon(const Context&);
RowResult run_langevin(const Context&);
RowResult run_card(const Context&);
RowResult run_discs(const Context&);
RowResult run_time_step(const Context&);
RowResult run_steady_drag(const Context&);
RowResult run_leaves(const Context&);
RowResult run_phase_map(const Context&);
RowResult run_turbulence_fall(const Context&);
RowResult run_seed(const Context&);
RowResult run_dart(const Context&);
RowResult run_cap(const Context&);
RowResult run_bowls(const Context&);
RowResult run_curled_leaf(const Context&);
RowResult run_holes(const Context&);
RowResult run_strips(const Context&);
RowResult run_cross(const Context&);
RowResult run_snow(const Context&);
RowResult run_solids(const Context&);
RowResult run_leaf(const Context&);
RowResult run_paper_plane(const Context&);
RowResult run_rubber_ellipsoid(const Context&);
RowResult run_tables(const Context&);
RowResult run_cost(const Context&);
} // namespace lr::scorecard
