// SPDX-License-Identifier: MIT
#include "options.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>

namespace {

// Like CLI::Range, but refuses NaN and infinity.
CLI::Validator within(double low, double high, const std::string& text) {
    return {[=](std::string& value) -> std::string {
                double x = std::numeric_limits<double>::quiet_NaN();
                if (!CLI::detail::lexical_cast(value, x) || !(x >= low && x <= high)) {
                    return value + " is not " + text;
                }
                return {};
            },
            text};
}

// Names of instruction sets, lower case without punctuation: "AVX-512" is avx512 here.
std::map<std::string, std::int32_t> simd_names() {
    std::map<std::string, std::int32_t> names{{"auto", LR_SIMD_AUTO}};
    for (std::int32_t target = LR_SIMD_SSE4; target <= LR_SIMD_PLAIN; ++target) {
        std::string name;
        for (const char* c = lr_simd_target_name(target); *c; ++c) {
            if (std::isalnum(static_cast<unsigned char>(*c))) {
                name += static_cast<char>(std::tolower(static_cast<unsigned char>(*c)));
            }
        }
        names[name] = target;
    }
    return names;
}

CLI::Validator one_of(std::map<std::string, std::int32_t> names) {
    return {[names = std::move(names)](std::string& value) -> std::string {
                std::string known;
                for (const auto& [name, number] : names) {
                    if (name == value) {
                        value = std::to_string(number);
                        return {};
                    }
                    known += " " + name;
                }
                return value + "  is not one of" + known;
            },
            ""};
}

// A picture under the name of another format would not open everywhere. Names without an ending are taken.
std::string wrong_picture_name(const std::string& name) {
    const std::string ending = std::filesystem::path(name).extension().string();
    return ending.empty() || ending == ".png" || ending == ".PNG"
               ? ""
               : "the picture is a PNG; its name '" + name + "' must end in .png";
}

// Every output needs its own path, different from all inputs.
void check_paths(const Options& options) {
    std::vector<std::string> taken = options.assets;
    taken.insert(taken.end(), options.meshes.begin(), options.meshes.end());
    for (const std::string& path : {options.png, options.tracks, options.csv, options.json}) {
        if (!path.empty() && std::find(taken.begin(), taken.end(), path) != taken.end()) {
            throw CLI::ValidationError(path, "given twice");
        }
        taken.push_back(path);
    }
}

void add_ground_options(CLI::App& app, Options& options) {
    auto* const ground =
        app.add_flag("--ground", options.ground,
                     "leaves start above rolling ground with a bench, a wall and stones, and land on it");
    app.add_flag("--heap", options.heap, "leaves collide with each other and start above one place, where they pile up")
        ->needs(ground);
    app.add_option("--fall", options.fall, "time in which all leaves start, s")
        ->needs(ground)
        ->check(within(0.1, 1e6, "from 0.1 to 1e6 s"));
    app.add_option("--walk", options.walk, "time at which a person walks through the leaves, s; without it: never")
        ->needs(ground)
        ->default_str("")
        ->check(within(0, 1e6, "from 0 to 1e6 s"));
    app.add_option("--gusts", options.gusts, "time of a gust of 4 s that blows the leaves away, s; without it: none")
        ->needs(ground)
        ->default_str("")
        ->check(within(0, 1e6, "from 0 to 1e6 s"));
    app.add_option("--gust-speed", options.gust_speed, "speed of the gust 10 m above the ground, m/s, added to --wind")
        ->needs(ground)
        ->check(within(0, 100, "from 0 to 100 m/s"));
    app.add_flag("--check", options.check,
                 "count bodies on the ground, in it, above it and on edge, at each frame and at the end")
        ->needs(ground);
}

} // namespace

std::uint64_t Options::steps() const {
    return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::llround(seconds / dt)));
}

std::uint64_t Options::frame_step(int frame) const {
    const double time =
        at.empty() ? static_cast<double>(steps()) * (frame + 1.0) / frames * dt : at[static_cast<std::size_t>(frame)];
    return std::clamp<std::uint64_t>(static_cast<std::uint64_t>(time / dt + 0.5), 1, steps());
}

std::optional<Options> parse_options(int argc, char** argv, int& exit_code) {
    Options options;
    std::vector<float> wind;
    CLI::App app{"Simulates a storm of leaves or other baked bodies with Langevin Rigid, measures it and draws it.",
                 "leaf_storm"};
    app.option_defaults()->always_capture_default();
    app.footer("Exit code: 0 success, 1 bad usage, 2 run-time failure, with a message that says what to do.");
    app.add_option("--asset", options.assets, "asset made by lr_bake; several assets share the count")
        ->required()
        ->type_name("F")
        ->default_str("")
        ->check(CLI::ExistingFile);
    app.add_option("--count", options.count, "total number of bodies")->check(within(1, 50e6, "from 1 to 50000000"));
    app.add_option("--seconds", options.seconds, "simulated time, s")->check(within(1e-6, 1e6, "from 1e-6 to 1e6 s"));
    app.add_option("--dt", options.dt, "length of a step, s (1/60)")->check(within(1e-6, 1.0, "from 1e-6 to 1 s"));
    app.add_option("--substeps", options.substeps, "substeps per step")
        ->check(within(1, LR_MAX_SUBSTEPS, "from 1 to 65536"));
    app.add_option("--threads", options.threads, "total number of threads; 0 and 1: only the caller's")
        ->check(within(0, 65, "from 0 to 65"));
    app.add_option("--wind", wind, "wind velocity, m/s; y is up")
        ->expected(3)
        ->delimiter(',')
        ->type_name("X,Y,Z")
        ->default_str("1.5,0,0.5; with --ground 0.4,0,0.1")
        ->check(within(-1000, 1000, "from -1000 to 1000 m/s"));
    app.add_option("--seed", options.seed, "seed of initial poses and of turbulence")
        ->check(within(0, 1e19, "from 0 to 1e19"));
    app.add_option("--variation", options.variation, "spread of drag and lift from body to body")
        ->check(within(0, 0.5, "from 0 to 0.5"));
    app.add_option("--noise", options.noise, "factor on the turbulent noise")->check(within(0, 100, "from 0 to 100"));
    app.add_flag("--same-size", options.same_size, "all bodies at their asset's size, instead of 0.7 to 1.3 times it");
    app.add_option("--loads", options.loads,
                   "aerodynamic: quasi-steady drag and lift; langevin: the paper's turbulent loads; none")
        ->type_name("NAME")
        ->default_str("aerodynamic")
        ->transform(
            one_of({{"aerodynamic", LR_LOADS_AERODYNAMIC}, {"langevin", LR_LOADS_LANGEVIN}, {"none", LR_LOADS_NONE}}));
    app.add_option("--clock", options.clock, "speed: turbulence by present speed; age: by the baked table over time")
        ->type_name("NAME")
        ->default_str("speed")
        ->transform(one_of({{"speed", LR_CLOCK_SPEED}, {"age", LR_CLOCK_AGE}}));
    app.add_option("--integrator", options.integrator, "splitting: stable at any step; rk4: that of the paper")
        ->type_name("NAME")
        ->default_str("splitting")
        ->transform(one_of({{"splitting", LR_INTEGRATOR_SPLITTING}, {"rk4", LR_INTEGRATOR_RK4}}));
    app.add_option("--simd", options.simd,
                   "instruction set, by default the best: sse4, avx2, avx512, neon; same results")
        ->type_name("NAME")
        ->default_str("auto")
        ->transform(one_of(simd_names()));
    app.add_option("--png", options.png, "picture to write: frames of the storm on one sheet")
        ->type_name("F.png")
        ->check(wrong_picture_name);
    app.add_option("--mesh", options.meshes,
                   "OBJ in metres to draw, for each --asset in turn (default: STEM.obj beside the asset or in meshes/, "
                   "else an ellipse)")
        ->type_name("F")
        ->default_str("")
        ->check(CLI::ExistingFile);
    app.add_option("--width", options.width, "width of the picture, px")->check(within(320, 8192, "from 320 to 8192"));
    app.add_option("--height", options.height, "height of the large frame, px")
        ->check(within(180, 8192, "from 180 to 8192"));
    app.add_option("--frames", options.frames, "number of frames in the picture; the last is the large one")
        ->check(within(1, 16, "from 1 to 16"));
    app.add_option("--at", options.at, "times of the frames, s, instead of --frames at equal intervals")
        ->delimiter(',')
        ->type_name("T,T...")
        ->default_str("")
        ->check(within(0, 1e6, "from 0 to 1e6 s"));
    app.add_option("--rate", options.divisor, "level of detail: one substep for this number of ordinary substeps")
        ->check(within(1, 1024, "from 1 to 1024"));
    add_ground_options(app, options);
    app.add_option("--tracks", options.tracks, "picture to write: single falls from rest in still air, side view")
        ->type_name("F.png")
        ->check(wrong_picture_name);
    app.add_option("--tracks-count", options.track_count, "number of falls")->check(within(1, 400, "from 1 to 400"));
    app.add_option("--tracks-seconds", options.track_seconds, "length of a fall, s")
        ->check(within(0.1, 60, "from 0.1 to 60 s"));
    app.add_option("--csv", options.csv, "CSV file to write: averages over time")->type_name("F");
    app.add_option("--json", options.json, "JSON file to write: the report")->type_name("F");
    app.add_flag("--quiet", options.quiet, "no progress");
    try {
        app.parse(argc, argv);
        if (options.meshes.size() > options.assets.size())
            throw CLI::ValidationError("--mesh", "more meshes than assets");
        if (options.count < options.assets.size()) throw CLI::ValidationError("--count", "fewer bodies than assets");
        if (options.dt / options.substeps > LR_MAX_SUBSTEP) throw CLI::ValidationError("--dt", "substeps over 1 s");
        check_paths(options);
        if (options.at.size() > 16) throw CLI::ValidationError("--at", "more than 16 frames");
        if (!std::is_sorted(options.at.begin(), options.at.end()))
            throw CLI::ValidationError("--at", "not in the order of time");
        if (!options.at.empty() && options.at.back() > options.seconds)
            throw CLI::ValidationError("--at", "later than --seconds");
        if (options.seconds / options.dt > 1e9) throw CLI::ValidationError("--seconds", "more than 1e9 steps");
    } catch (const CLI::ParseError& error) {
        exit_code = app.exit(error) == 0 ? 0 : 1;
        return std::nullopt;
    }
    if (wind.empty() && options.ground) wind = {0.4f, 0.0f, 0.1f};
    if (!wind.empty()) std::copy(wind.begin(), wind.end(), options.wind);
    if (!options.at.empty()) options.frames = static_cast<int>(options.at.size());
    return options;
}
