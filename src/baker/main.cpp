// lr_bake: bakes, shows and checks asset files. Exit code 0 good, 1 a numbered fault, 2 wrong usage.
#include "baker/file_io.h"
#include "baker/options.h"
#include "baker/progress.h"
#include "baker/report.h"
#include "baker/text.h"
#include "format/asset_file.h"

#include <signal.h>

#include <cerrno>
#include <cstdio>
#include <exception>
#include <new>
#include <system_error>

namespace {

using namespace lr;
using namespace lr::baker;

constexpr std::size_t max_asset_bytes = std::size_t{1} << 30; // read_asset

void print(const std::string& file, const Faults& faults, bool warnings) {
    for (Fault fault : faults) {
        if (fault.severity == Severity::warning && !warnings) continue;
        // A fault of a whole file names it; of a report or an asset to be written, that and not the mesh.
        const bool whole = fault.where == file || (static_cast<uint32_t>(fault.id) < 200 && !fault.where.empty());
        const std::string prefix = whole ? fault.where : file;
        if (whole) fault.where.clear();
        std::fprintf(stderr, "%s: %s\n", printable(prefix).c_str(), printable(to_string(fault)).c_str());
    }
}

bool check_outputs(const CommandLine& line, Faults& faults) {
    const bool has_report = !line.report.empty();
    bool good = check_output(line.output, faults);
    if (has_report) good = check_output(line.report, faults) && good;
    const auto differ = [&](const std::string& output, const std::string& other, const char* what) {
        if (!is_same_file(output, other)) return true;
        faults.push_back({FaultId::parameter_out_of_range, Severity::error, output, what, "Give another name."});
        return false;
    };
    if (good && !line.bake.semi_axes) {
        good = differ(line.output, line.bake.mesh_path, "The asset would overwrite its input.");
        if (has_report)
            good = differ(line.report, line.bake.mesh_path, "The report would overwrite its input.") && good;
    }
    if (good && has_report) good = differ(line.report, line.output, "The report would overwrite the asset.");
    return good;
}

int run_bake(const CommandLine& line) {
    const std::string input = line.bake.semi_axes ? "ellipsoid" : line.bake.mesh_path;
    Faults faults;
    AssetData asset;
    BakeTimings timings;
    Progress progress(line.quiet);
    bool good = check_outputs(line, faults) &&
                bake(line.bake, asset, faults, &timings,
                     [&](const char* phase, double fraction) { progress.update(phase, fraction); });
    std::size_t size = 0;
    if (good) {
        const std::vector<uint8_t> bytes = write_asset(asset);
        size = bytes.size();
        const std::string json = line.report.empty() ? std::string() : report_json(asset, faults, timings);
        std::vector<OutputFile> files{{line.output, bytes}};
        if (!line.report.empty())
            files.push_back({line.report, {reinterpret_cast<const uint8_t*>(json.data()), json.size()}});
        good = write_files(files, faults);
    }
    progress.clear();
    print(input, faults, !line.quiet);
    if (good && !line.quiet)
        std::printf("%s%s  written         %s, %zu bytes\n", summary(asset).c_str(), summary(timings).c_str(),
                    printable(line.output).c_str(), size);
    return good ? 0 : 1;
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
            "It cannot be written: " + std::generic_category().message(errno) + ".", "Check where it goes."}},
          true);
    return 1;
}

} // namespace

int main(int argc, char** argv) {
    // A file size limit is then an error of the write, not a death with a file left aside.
    signal(SIGXFSZ, SIG_IGN);
    try {
        int exit_code = 0;
        const std::optional<CommandLine> line = parse_command_line(argc, argv, exit_code);
        if (!line) return exit_code;
        return line->command == CommandLine::Command::bake ? run_bake(*line) : run_on_asset(*line);
    } catch (const std::bad_alloc&) {
        std::fputs("lr_bake: error: Out of memory.\n", stderr);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "lr_bake: error: %s\n", printable(error.what()).c_str());
    }
    return 1;
}
