// lr_scorecard: compares the library with closed forms and with measurements of real falling bodies. Exit code 0: all rows that
// ran hold, 1: a row does not, 2: wrong usage, 3: a row could not be run or a file not written.
#include "tools/lr_scorecard/progress.h"
#include "tools/lr_scorecard/report.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>

namespace {

using namespace lr::scorecard;

struct Options {
    std::vector<std::string> only, groups;
    std::string output_dir, json;
    bool list = false, quiet = false, report_only = false;
    Context context;
};

void write(const std::filesystem::path& path, const std::string& text) {
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    if (!file) throw std::runtime_error("cannot write " + path.string());
}

bool wanted(const Options& o, const Row& row) {
    const auto among = [](const std::vector<std::string>& names, const char* name) {
        return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
    };
    return among(o.only, row.id) && among(o.groups, row.group);
}

int run(Options& o) {
    std::vector<const Row*> rows;
    double expected = 0.0;
    for (const Row& row : all_rows())
        if (wanted(o, row)) {
            rows.push_back(&row);
            expected += o.context.quick ? row.quick_seconds : row.seconds;
        }
    if (o.list) {
        for (const Row* row : rows) std::printf("%-18s %-9s %s (%s)\n", row->id, row->group, row->title, row->source);
        return 0;
    }
    if (!o.output_dir.empty())
        std::filesystem::create_directories(std::filesystem::path(o.output_dir) / "images" / "scorecard");
    Progress progress(o.quiet, expected);
    std::vector<Finished> finished;
    bool all = true;
    for (const Row* row : rows) {
        const double cost = o.context.quick ? row->quick_seconds : row->seconds;
        o.context.progress = [&](double part) { progress.update(row->id, part, cost); };
        progress.update(row->id, 0.0, cost);
        const auto begin = std::chrono::steady_clock::now();
        RowResult result;
        try {
            result = row->run(o.context);
        } catch (const std::exception& e) {
            throw std::runtime_error(std::string(row->id) + ": " + e.what());
        }
        result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        progress.finish(cost);
        finished.push_back({row, std::move(result)});
        all = all && finished.back().result.holds();
        std::fputs(to_text(finished.back()).c_str(), stdout);
        std::fflush(stdout);
    }
    size_t held = 0;
    for (const Finished& f : finished) held += f.result.holds();
    std::printf("%zu of %zu rows hold.\n", held, finished.size());
    if (!o.output_dir.empty()) {
        const std::filesystem::path folder = o.output_dir;
        write(folder / "scorecard.md", to_markdown(finished, o.context));
        for (const Finished& f : finished)
            for (const Picture& p : f.result.pictures) write(folder / "images" / "scorecard" / p.file, p.svg);
    }
    if (!o.json.empty()) write(o.json, to_json(finished, o.context));
    return all || o.report_only ? 0 : 1;
}
} // namespace

int main(int argc, char** argv) {
    CLI::App app("Compares Langevin Rigid with closed forms and with measured falls of real bodies.");
    app.set_version_flag("--version", langevin_rigid::baker_version());
    Options o;
    std::vector<std::string> ids;
    for (const Row& row : all_rows()) ids.emplace_back(row.id);
    std::map<std::string, int32_t> models{{"default", LR_LOADS_DEFAULT}, {"langevin", LR_LOADS_LANGEVIN}};
    models["aerodynamic"] = LR_LOADS_AERODYNAMIC;
    std::vector<std::string> model_names;
    for (const auto& [name, model] : models) model_names.push_back(name);
    app.add_flag("--list", o.list, "list the rows without running them");
    app.add_option("--only", o.only, "run only these rows")
        ->check(CLI::IsMember(ids))
        ->delimiter(',')
        ->type_name("ROW,...");
    app.add_option("--group", o.groups, "run rows of these groups")
        ->check(CLI::IsMember({"exact", "measured", "paper"}))
        ->delimiter(',');
    app.add_flag("--quick", o.context.quick, "fewer and shorter runs: seconds instead of minutes");
    app.add_option("--seeds", o.context.seeds, "falls per cell of discs and set of seeds")
        ->check(CLI::Range(2, 1000000))
        ->capture_default_str();
    app.add_option("--phase-seeds", o.context.phase_seeds, "releases per point of the phase map")
        ->check(CLI::Range(1, 10000))
        ->capture_default_str();
    app.add_option("--threads", o.context.threads, "number of threads; results do not depend on it")
        ->check(CLI::Range(1, 64))
        ->capture_default_str();
    app.add_option("--loads", o.context.loads.name, "load model of the rows without one of their own")
        ->check(CLI::IsMember(model_names))
        ->capture_default_str();
    app.add_option("--output-dir", o.output_dir, "write scorecard.md and images/scorecard/*.svg here")
        ->type_name("DIR");
    app.add_option("--json", o.json, "write all results to this file")->type_name("FILE");
    app.add_flag("--report-only", o.report_only, "exit code 0 even if rows do not hold");
    app.add_flag("-q,--quiet", o.quiet, "no progress");
    app.footer(
        "Exit code: 0 all rows hold; 1 some do not; 2 wrong usage; 3 a row could not be run, or a file not written.");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : 2;
    }
    o.context.loads.model = models.at(o.context.loads.name);
    try {
        return run(o);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "lr_scorecard: %s\n", e.what());
        return 3;
    }
}
