// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "contact_sheet.h"
#include "failure.h"
#include "image/png.h"
#include "output_file.h"
#include "progress.h"
#include "report.h"
#include "tracks.h"

namespace {

volatile std::sig_atomic_t interrupted = 0;

Lying check_lying(const Storm& storm, const std::vector<Mesh>& meshes) {
    Lying lying;
    lying.time = storm.info().time;
    for (std::size_t k = 0; k < meshes.size(); ++k) {
        const Storm::Kind& kind = storm.kinds()[k];
        lr_batch_view view;
        check(lr_batch_view_init(&view, sizeof view), "lr_batch_view_init");
        check(lr_batch_get_view(storm.world(), kind.batch, &view), "view");
        lying.add(view, meshes[k], thin_axis(kind.info), *storm.park());
    }
    lying.finish();
    return lying;
}

std::unique_ptr<OutputFile> open_output(const std::string& path) {
    return path.empty() ? nullptr : std::make_unique<OutputFile>(path);
}

void run(const Options& options) {
    const auto start = std::chrono::steady_clock::now();
    const auto png = open_output(options.png), tracks = open_output(options.tracks), csv = open_output(options.csv),
               json = open_output(options.json);
    Measured measured;
    measured.steps = options.steps();
    Progress progress(options.quiet, measured.steps, static_cast<double>(options.count) * options.substeps, options.dt);

    Storm storm(options);
    const auto sheet = png ? std::make_unique<ContactSheet>(options, storm) : nullptr;
    const auto often = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(0.1 / options.dt + 0.5));
    const double half = 0.5 * static_cast<double>(measured.steps) * options.dt;
    Histogram descents;
    std::vector<Mesh> meshes; // with --check
    std::string ignored;
    for (std::size_t k = 0; options.check && k < storm.kinds().size(); ++k)
        meshes.push_back(drawn_mesh(options, storm, k, ignored));
    int checked = 0;
    measured.samples.push_back(storm.sample(nullptr));
    for (std::uint64_t step = 1; step <= measured.steps; ++step) {
        if (interrupted) throw Failure("interrupted", "");
        storm.step();
        if (step % often == 0 || step == measured.steps) {
            const bool counts = static_cast<double>(step) * options.dt >= half - 1e-9;
            measured.samples.push_back(storm.sample(counts ? &descents : nullptr));
        }
        while (sheet && sheet->due(step)) sheet->take(storm);
        if (options.check &&
            (step == measured.steps || (checked < options.frames && step >= options.frame_step(checked)))) {
            measured.lying.push_back(check_lying(storm, meshes));
            ++checked;
        }
        progress.update(step, storm.stepping_seconds());
    }
    measured.summary = summarise(measured.samples, descents, half - 1e-6);
    if (png) write_png(sheet->picture(), *png);
    if (tracks) {
        progress.note("drawing the tracks");
        write_png(draw_tracks(options), *tracks);
    }
    progress.close();
    measured.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (csv) {
        csv->write(csv_report(measured));
        csv->commit();
    }
    if (json) {
        json->write(json_report(options, storm, measured));
        json->commit();
    }
    const std::string table = table_report(options, storm, measured);
    if (std::fwrite(table.data(), 1, table.size(), stdout) != table.size() || std::fflush(stdout) != 0) {
        throw Failure("cannot write the table to stdout", "");
    }
}

} // namespace

int main(int argc, char** argv) {
    try {
        int exit_code = 0;
        const auto options = parse_options(argc, argv, exit_code);
        if (!options) return exit_code;
        // A stopped run must leave no half-written files.
        for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { interrupted = 1; });
        run(*options);
        return 0;
    } catch (const Failure& failure) {
        tell("leaf_storm", failure);
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "leaf_storm: out of memory\nleaf_storm: what to do: try a smaller --count or picture\n");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "leaf_storm: %s\n", error.what());
    }
    return 2;
}
