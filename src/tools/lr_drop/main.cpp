// lr_drop: drops an asset and measures how it falls. Exit code 0: success, 1: a numbered fault, 2: wrong usage.
#include "baker/fault_text.h"
#include "baker/file_io.h"
#include "baker/printable_text.h"
#include "tools/console.h"
#include "tools/lr_drop/options.h"
#include "tools/lr_drop/paths_picture.h"
#include "tools/lr_drop/report.h"

#include <cerrno>
#include <cstdio>
#include <exception>
#include <memory>
#include <system_error>

namespace {

using namespace lr;
using namespace lr::tools;

constexpr std::size_t max_asset_bytes = std::size_t{1} << 30;

int report_faults(const std::string& file, const Faults& faults) {
    for (Fault fault : faults) {
        const bool whole = static_cast<uint32_t>(fault.id) < 200 && !fault.where.empty(); // names the file itself
        const std::string prefix = whole ? fault.where : file;
        if (whole) fault.where.clear();
        std::fprintf(stderr, "%s: %s\n", baker::printable(prefix).c_str(), baker::printable(to_string(fault)).c_str());
    }
    return 1;
}

using Asset = std::unique_ptr<lr_asset, decltype(&lr_asset_release)>;

Asset load(const std::string& path, Faults& faults) {
    std::vector<uint8_t> bytes;
    lr_asset* asset = nullptr;
    if (baker::read_file(path, max_asset_bytes, bytes, faults) &&
        lr_asset_load_memory(bytes.data(), bytes.size(), &asset) != LR_OK) {
        const auto note = [](void* to, uint32_t number, const char* where, const char* what, const char* remedy) {
            static_cast<Faults*>(to)->push_back({static_cast<FaultId>(number), Severity::error, where, what, remedy});
        };
        if (lr_asset_check_memory(bytes.data(), bytes.size(), note, &faults) == LR_ERROR_OUT_OF_MEMORY)
            throw std::bad_alloc();
    }
    return {asset, lr_asset_release};
}

int run(const DropCommand& command) {
    Faults faults = check(command);
    if (!faults.empty()) return report_faults("lr_drop", faults);
    for (const std::string& path : {command.png, command.json})
        if (!path.empty() && !baker::check_output(path, faults)) return report_faults(path, faults);
    const auto differ = [&](const std::string& output, const std::string& other) {
        if (!output.empty() && !other.empty() && baker::is_same_file(output, other))
            faults.push_back({FaultId::parameter_out_of_range, Severity::error, output,
                              "It would overwrite another file of this command.", "Choose another file name."});
    };
    differ(command.png, command.asset);
    differ(command.json, command.asset);
    differ(command.png, command.json);
    if (!faults.empty()) return report_faults(command.asset, faults);
    const Asset asset = load(command.asset, faults);
    if (!asset) return report_faults(command.asset, faults);

    Results results;
    results.shape = falls::shape_of(asset.get(), command.drop);
    results.step = command.drop.step > 0.0 ? command.drop.step : falls::default_step(results.shape);
    results.falls = falls::drop_and_measure(asset.get(), command.drop, results.each,
                                            command.png.empty() ? 0 : pictured_falls, &results.tracks);
    std::vector<uint8_t> picture;
    const std::string numbers = json(command, results);
    std::vector<baker::OutputFile> files;
    if (!command.png.empty()) {
        picture = draw_paths(command, results);
        files.push_back({command.png, picture});
    }
    if (!command.json.empty())
        files.push_back({command.json, {reinterpret_cast<const uint8_t*>(numbers.data()), numbers.size()}});
    if (!baker::write_files(files, faults)) return report_faults("lr_drop", faults);
    if (!command.quiet) std::fputs(text(command, results).c_str(), stdout);
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return 0;
    return report_faults("standard output", {{FaultId::file_write, Severity::error, "",
                                              "It cannot be written: " + std::generic_category().message(errno) + ".",
                                              "Check its disk and rights."}});
}
} // namespace

int main(int argc, char** argv) {
    lr::baker::set_up_console();
    try {
        std::vector<std::string> arguments = lr::baker::utf8_arguments(argc, argv);
        std::vector<char*> pointers;
        for (std::string& argument : arguments) pointers.push_back(argument.data());
        int exit_code = 0;
        const std::optional<DropCommand> command =
            parse_command_line(static_cast<int>(pointers.size()), pointers.data(), exit_code);
        return command ? run(*command) : exit_code;
    } catch (const std::bad_alloc&) {
        std::fputs("lr_drop: error: Out of memory. Use a smaller --count.\n", stderr);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "lr_drop: error: %s\n", lr::baker::printable(error.what()).c_str());
    }
    return 1;
}
