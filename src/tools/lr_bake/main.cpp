// lr_bake: bakes, shows and checks asset files. Exit code 0: success, 1: a numbered fault, 2: wrong usage.
#include "asset/asset_file.h"
#include "baker/asset_report.h"
#include "baker/fault_text.h"
#include "baker/file_io.h"
#include "baker/printable_text.h"
#include "tools/console.h"
#include "tools/lr_bake/bake_job.h"
#include "tools/lr_bake/bake_many.h"
#include "tools/lr_bake/memory_budget.h"
#include "tools/lr_bake/options.h"
#include "tools/lr_bake/progress.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace {

using namespace lr;
using namespace lr::baker;

constexpr std::size_t max_asset_bytes = std::size_t{1} << 30; // read_asset

void print(const std::string& file, const Faults& faults, bool warnings) {
    for (Fault fault : faults) {
        if (fault.severity == Severity::warning && !warnings) continue;
        // A fault of an output file names that file instead of the mesh.
        const bool whole = fault.where == file || (static_cast<uint32_t>(fault.id) < 200 && !fault.where.empty());
        const std::string prefix = whole ? fault.where : file;
        if (whole) fault.where.clear();
        std::fprintf(stderr, "%s: %s\n", printable(prefix).c_str(), printable(to_string(fault)).c_str());
    }
}

std::string remark(const BakeOutcome& outcome) {
    if (outcome.fall.empty()) return "";
    const double density = outcome.asset.fluid_density;
    return std::string(std::abs(density - 1.2) < 0.12     ? "  in air          "
                       : std::abs(density - 998.0) < 50.0 ? "  in water        "
                                                          : "  in its fluid    ") +
           outcome.fall + "\n";
}

BakeJob single_job(const CommandLine& line) {
    BakeJob job;
    job.bake = line.bake;
    job.output = line.output;
    job.report = line.report;
    job.preview = line.preview;
    job.plots = line.plots;
    job.if_changed = line.if_changed;
    job.drop = !line.quiet;
    return job;
}

int run_bake(const CommandLine& line) {
    const BakeJob job = single_job(line);
    for (const std::string& path : job.outputs()) clear_abandoned(path);
    Progress progress(line.quiet);
    BakeOutcome outcome =
        make_outputs(job, [&](const char* phase, double fraction) { progress.update(phase, fraction); }, {});
    const std::size_t size = outcome.files.empty() ? 0 : outcome.files[0].size();
    write_outputs(job, outcome);
    progress.clear();
    print(job.input_name(), outcome.faults, !line.quiet);
    if (outcome.state == BakeOutcome::State::failed) return 1;
    if (line.quiet) return 0;
    const std::string output = printable(job.output);
    if (outcome.state == BakeOutcome::State::unchanged)
        std::printf("%s: unchanged\n", output.c_str());
    else
        std::printf("%s%s  written         %s, %zu bytes\n%s", summary(outcome.asset).c_str(),
                    summary(outcome.timings).c_str(), output.c_str(), size, remark(outcome).c_str());
    return 0;
}

std::string describe(const BakeOutcome& outcome) {
    if (outcome.state == BakeOutcome::State::unchanged) return "unchanged";
    std::size_t warnings = 0;
    for (const Fault& fault : outcome.faults) {
        if (outcome.state == BakeOutcome::State::failed && fault.severity == Severity::error)
            return "failed, error " + std::to_string(static_cast<uint32_t>(fault.id));
        warnings += fault.severity == Severity::warning;
    }
    return warnings == 0 ? "baked" : "baked, " + std::to_string(warnings) + (warnings == 1 ? " warning" : " warnings");
}

int run_batch(const CommandLine& line) {
    std::vector<std::string> inputs = line.inputs;
    Faults faults;
    if (!line.list.empty() && !read_list(line.list, inputs, faults)) {
        print(line.list, faults, true);
        return 1;
    }
    std::string clash;
    std::optional<std::vector<BakeJob>> jobs =
        line.folders ? plan_batch(inputs, line.bake, {line.output, line.report, line.plots, line.preview},
                                  line.if_changed, clash)
                     : std::vector<BakeJob>{single_job(line)};
    if (!jobs) return wrong_usage(clash);
    std::vector<std::string> folders{line.plots};
    if (line.folders) folders.insert(folders.end(), {line.output, line.report, line.preview});
    for (const std::string& folder : folders)
        if (!folder.empty() && !make_folder(folder, faults)) {
            print(folder, faults, true);
            return 1;
        }
    for (const std::string& folder : folders)
        if (!folder.empty()) clear_abandoned(folder + "/");
    if (line.islands) jobs = plan_islands(*jobs);
    BatchLimits limits;
    limits.threads = line.jobs > 0 ? line.jobs : std::max(std::thread::hardware_concurrency(), 1U);
    limits.memory = available_memory() / 10 * 8;
    BatchProgress progress(line.quiet, jobs->size());
    std::size_t baked = 0, unchanged = 0;
    BatchEvents events;
    events.progress = [&](double finished) { progress.update(finished); };
    events.done = [&](const BakeJob& job, const BakeOutcome& outcome) {
        progress.clear();
        baked += outcome.state == BakeOutcome::State::baked;
        unchanged += outcome.state == BakeOutcome::State::unchanged;
        if (!line.quiet)
            std::printf("%s: %s, %.2f s\n", printable(line.islands ? job.output : job.input_name()).c_str(),
                        describe(outcome).c_str(), outcome.seconds);
        std::fflush(stdout);
        print(job.input_name(), outcome.faults, !line.quiet);
    };
    const std::size_t failed = baker::run_batch(*jobs, limits, events);
    progress.clear();
    if (!line.quiet) std::printf("%zu baked, %zu unchanged, %zu failed\n", baked, unchanged, failed);
    if (failed == 0) return 0;
    std::fflush(stdout);
    std::fprintf(stderr, "lr_bake: %zu of %zu failed\n", failed, jobs->size());
    return 1;
}

int run_on_asset(const CommandLine& line) {
    Faults faults;
    AssetData asset;
    std::vector<uint8_t> bytes;
    const bool good =
        read_file(line.asset, max_asset_bytes, bytes, faults) && read_asset(bytes.data(), bytes.size(), asset, faults);
    print(line.asset, faults, true);
    if (!good) return 1;
    if (line.command == CommandLine::Command::check) {
        std::printf("%s: good\n", printable(line.asset).c_str());
        return 0;
    }
    if (line.json) {
        std::fputs(report_json(asset).c_str(), stdout);
    } else {
        const ProvenanceData& p = asset.provenance;
        std::printf("%s  made by         %s %s from %s (%u faces, %u vertices)\n  options         %s\n",
                    summary(asset).c_str(), printable(p.tool).c_str(), printable(p.tool_version).c_str(),
                    printable(p.source).c_str(), p.faces, p.vertices, printable(p.options).c_str());
    }
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return 0;
    print("standard output",
          {{FaultId::file_write, Severity::error, "",
            "It cannot be written: " + std::generic_category().message(errno) + ".", "Check its disk and rights."}},
          true);
    return 1;
}
} // namespace

int main(int argc, char** argv) {
    set_up_console();
    try {
        std::vector<std::string> arguments = utf8_arguments(argc, argv);
        std::vector<char*> pointers;
        for (std::string& argument : arguments) pointers.push_back(argument.data());
        int exit_code = 0;
        const std::optional<CommandLine> line =
            parse_command_line(static_cast<int>(pointers.size()), pointers.data(), exit_code);
        if (!line) return exit_code;
        if (line->command != CommandLine::Command::bake) return run_on_asset(*line);
        return line->folders || line->islands ? run_batch(*line) : run_bake(*line);
    } catch (const std::bad_alloc&) {
        std::fputs("lr_bake: error: Out of memory. Reduce the mesh or the --grid, or use fewer --jobs.\n", stderr);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "lr_bake: error: %s\n", printable(error.what()).c_str());
    }
    return 1;
}
