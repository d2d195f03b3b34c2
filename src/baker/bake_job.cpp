#include "baker/bake_job.h"

#include "baker/file_io.h"
#include "baker/report.h"
#include "format/asset_file.h"

#include <chrono>
#include <string_view>

namespace lr::baker {
namespace {

constexpr std::size_t max_output_bytes = std::size_t{1} << 30;

bool check_outputs(const BakeJob& job, Faults& faults) {
    const std::vector<std::string> outputs = job.outputs();
    bool good = true;
    for (const std::string& path : outputs) good = check_output(path, faults) && good;
    const auto differ = [&](const std::string& output, const std::string& other, const std::string& what) {
        if (!is_same_file(output, other)) return true;
        faults.push_back({FaultId::parameter_out_of_range, Severity::error, output, what, "Give another name."});
        return false;
    };
    const auto kind = [&](const std::string& path) {
        return std::string(path == job.output ? "The asset" : path == job.report ? "The report" : "A plot");
    };
    for (std::size_t i = 0; good && i < outputs.size(); ++i) {
        if (!job.bake.semi_axes)
            good = differ(outputs[i], job.bake.mesh_path, kind(outputs[i]) + " would overwrite the mesh.");
        for (std::size_t j = 0; good && j < i; ++j)
            good = differ(outputs[i], outputs[j],
                          kind(outputs[i]) + " would overwrite " + (j == 0 ? "the asset." : "another output."));
    }
    return good;
}

std::string_view as_text(const std::vector<uint8_t>& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// Every output is there, sound, and says that it was made by this baker, from these bytes with these options.
bool is_current(const BakeJob& job) {
    std::vector<uint8_t> bytes;
    Faults ignored;
    AssetData asset;
    if (!read_file(job.output, max_output_bytes, bytes, ignored) ||
        !read_asset(bytes.data(), bytes.size(), asset, ignored))
        return false;
    const ProvenanceData& made = asset.provenance;
    if (made.tool != "lr_bake" || made.tool_version != baker_version() || made.options != canonical_options(job.bake) ||
        made.source != source_name(job.bake) || asset.name != asset_name(job.bake))
        return false;
    if (!job.report.empty() &&
        (!read_file(job.report, max_output_bytes, bytes, ignored) || !is_report_of(as_text(bytes), made)))
        return false;
    return find_input_hash(job.bake) == made.input_hash;
}

std::vector<uint8_t> to_bytes(const std::string& text) {
    return {text.begin(), text.end()};
}

} // namespace

std::vector<std::string> BakeJob::outputs() const {
    std::vector<std::string> paths{output};
    if (!report.empty()) paths.push_back(report);
    return paths;
}

BakeOutcome make_outputs(const BakeJob& job, const BakeProgress& progress, const BakeHooks& hooks) {
    const auto start = std::chrono::steady_clock::now();
    BakeOutcome outcome;
    if (check_outputs(job, outcome.faults)) {
        if (job.if_changed && is_current(job)) {
            outcome.state = BakeOutcome::State::unchanged;
        } else if (bake(job.bake, outcome.asset, outcome.faults, &outcome.timings, progress, hooks)) {
            outcome.state = BakeOutcome::State::baked;
            outcome.files.push_back(write_asset(outcome.asset));
            if (!job.report.empty())
                outcome.files.push_back(to_bytes(report_json(outcome.asset, outcome.faults, outcome.timings)));
        }
    }
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return outcome;
}

void write_outputs(const BakeJob& job, BakeOutcome& outcome) {
    if (outcome.state != BakeOutcome::State::baked) return;
    const std::vector<std::string> paths = job.outputs();
    std::vector<OutputFile> files;
    for (std::size_t i = 0; i < paths.size(); ++i) files.push_back({paths[i], outcome.files[i]});
    if (!write_files(files, outcome.faults)) outcome.state = BakeOutcome::State::failed;
}

} // namespace lr::baker
