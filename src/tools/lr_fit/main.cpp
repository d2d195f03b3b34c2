// lr_fit: fits the coefficients of plates to measured falls of discs. Exit code 0: done, 2: wrong usage, 3: could not be run.
#include "tools/command_line.h"
#include "tools/lr_fit/cma_es.h"
#include "tools/lr_fit/objective.h"
#include "tools/lr_scorecard/parallel.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>

namespace {

using namespace lr::fit;

constexpr uint32_t population = 12;

struct Options {
    double seconds = 600.0, step = 0.12;
    uint32_t seed = 1, threads = 1, generations = 1000000;
    std::vector<std::string> start, fixed;
    bool evaluate = false;
};

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

PlateCoefficients starting_at(const std::vector<std::string>& assignments) {
    PlateCoefficients out;
    for (const std::string& text : assignments) {
        const std::string name = text.substr(0, text.find('='));
        const auto all = fitted_coefficients();
        const auto c = std::find_if(all.begin(), all.end(), [&](const Coefficient& k) { return k.name == name; });
        if (c == all.end() || name.size() == text.size())
            throw CLI::ValidationError("--start", "'" + text + "' is not name=value of a fitted coefficient");
        const double value = lr::baker::parse_number<double>(text.substr(name.size() + 1), "--start");
        if (!(value >= c->least && value <= c->most))
            throw CLI::ValidationError("--start", "'" + text + "' is not between " + std::to_string(c->least) +
                                                      " and " + std::to_string(c->most));
        out.*c->member = value;
    }
    return out;
}

PlateCoefficients search(const Objective& objective, const PlateCoefficients& start, const Options& o) {
    std::vector<Coefficient> active;
    for (const Coefficient& c : fitted_coefficients())
        if (std::find(o.fixed.begin(), o.fixed.end(), c.name) == o.fixed.end()) active.push_back(c);
    if (active.empty()) return start;
    Point at;
    for (const Coefficient& c : active) at.push_back((start.*c.member - c.least) / (c.most - c.least));
    const auto coefficients = [&](const Point& p) {
        PlateCoefficients out = start;
        for (size_t i = 0; i < p.size(); ++i)
            out.*active[i].member = active[i].least + p[i] * (active[i].most - active[i].least);
        return out;
    };
    SeparableCmaEs strategy(at, o.step, population, o.seed);
    std::vector<double> misfits(population);
    const double before = objective.score(start, search_effort, o.threads).misfit;
    std::fprintf(stderr, "start: misfit %.2f\n", before);
    const Clock::time_point begin = Clock::now();
    for (uint32_t done = 0; done < o.generations && seconds_since(begin) < o.seconds;) {
        const std::vector<Point>& points = strategy.ask();
        lr::scorecard::parallel(o.threads, points.size(), [&](size_t i) {
            misfits[i] = objective.score(coefficients(points[i]), search_effort, 1).misfit;
        });
        strategy.tell(misfits);
        const double elapsed = seconds_since(begin), each = elapsed / ++done;
        std::fprintf(stderr, "generation %u: misfit %.2f, least so far %.2f, step %.3f; about %.0f s left\n", done,
                     *std::min_element(misfits.begin(), misfits.end()), strategy.best_value(), strategy.step(),
                     std::max(0.0, std::min(o.seconds - elapsed, each * (o.generations - done))));
    }
    return strategy.best_value() < before ? coefficients(strategy.best()) : start;
}

void run(const Options& o, const PlateCoefficients& start) {
    std::fputs("baking the discs\n", stderr);
    const Objective objective(o.threads);
    const PlateCoefficients found = rounded(o.evaluate ? start : search(objective, start, o));
    const Clock::time_point begin = Clock::now();
    double shown = 0.0;
    const Score score = objective.score(found, summary_effort, o.threads, [&](double part) {
        const double elapsed = seconds_since(begin);
        if (elapsed < shown + 1.0) return;
        shown = elapsed;
        std::fprintf(stderr, "summary: %.0f %%, about %.0f s left\n", 100.0 * part, elapsed * (1.0 / part - 1.0));
    });
    std::printf("%s%s", members(found).c_str(), describe(score).c_str());
}
} // namespace

int main(int argc, char** argv) {
    CLI::App app("Fits the coefficients of plates (PlateCoefficients) to measured falls of discs.");
    Options o;
    std::vector<std::string> names;
    for (const Coefficient& c : fitted_coefficients()) names.emplace_back(c.name);
    app.add_option("--seconds", o.seconds, "no generation begins later")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--generations", o.generations, "at most so many; for results that can be repeated exactly")
        ->check(CLI::PositiveNumber);
    app.add_option("--seed", o.seed, "of the search")->capture_default_str();
    app.add_option("--threads", o.threads, "number of threads; results of a generation do not depend on it")
        ->check(CLI::Range(1, 64))
        ->capture_default_str();
    app.add_option("--step", o.step, "first standard deviation, over the width of the bounds")
        ->check(CLI::Range(0.001, 0.4))
        ->capture_default_str();
    app.add_option("--start", o.start, "begin here instead of at the present value")->type_name("NAME=VALUE ...");
    app.add_option("--fix", o.fixed, "do not change these")->check(CLI::IsMember(names))->type_name("NAME ...");
    app.add_flag("--evaluate", o.evaluate, "no search: the summary of the start");
    app.footer("Exit code: 0 done; 2 wrong usage; 3 could not be run.");
    PlateCoefficients start;
    try {
        app.parse(argc, argv);
        start = starting_at(o.start);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : 2;
    }
    try {
        run(o, start);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "lr_fit: %s\n", e.what());
        return 3;
    }
    return 0;
}
