#include "tools/lr_drop/options.h"

#include "tools/command_line.h"
#include "tools/console.h"

namespace lr::tools {
namespace {

using baker::parse_list;
using baker::parse_number;

// "1/120" or "0.01".
double parse_step(const std::string& text) {
    const std::size_t slash = text.find('/');
    const std::string_view whole(text);
    if (slash == std::string::npos) return parse_number<double>(whole, "--step");
    return parse_number<double>(whole.substr(0, slash), "--step") /
           parse_number<double>(whole.substr(slash + 1), "--step");
}

falls::Release parse_release(const std::string& text) {
    if (text == "flat") return falls::Release::flat;
    if (text == "edge") return falls::Release::edge;
    if (text == "random") return falls::Release::random;
    throw CLI::ValidationError("--release", "'" + text + "' is not flat, edge or random");
}
} // namespace

std::optional<DropCommand> parse_command_line(int argc, char** argv, int& exit_code) {
    DropCommand command;
    std::string release = "random", height = "1", count = "500", wind = "0,0,0", turbulence = "0", fluid, seed = "0",
                step;
    CLI::App app{"Drops bodies of an asset from rest and measures how they fall: speed, manner, spin, drift, landings.",
                 "lr_drop"};
    app.set_version_flag("--version", "lr_drop " LR_VERSION_STRING);
    app.footer("Each body falls by itself, until its centre is at the floor or has risen as far. Up is y.\n"
               "Exit code: 0 success; 1 a numbered fault (docs/reference/asset_format.md); 2 wrong usage.");
    const auto add = [&](const char* option, std::string& text, const char* help, const char* type) {
        return app.add_option(option, text, help)->type_name(type);
    };
    app.add_option("ASSET", command.asset, "asset file, made by lr_bake")->required()->type_name("");
    add("--release", release, "attitude at rest: flat, edge (the broad side upright) or random", "HOW")
        ->capture_default_str();
    add("--height", height, "of the centre above the floor, m", "M")->capture_default_str();
    add("--count", count, "bodies, 1 to 50000", "N")->capture_default_str();
    add("--wind", wind, "uniform wind, m/s", "X,Y,Z")->capture_default_str();
    add("--turbulence", turbulence,
        "root mean square of each component of turbulent wind, m/s, with eddies of 1 m. In it each body starts at a "
        "place "
        "of its own",
        "M_S")
        ->capture_default_str();
    add("--fluid", fluid, "air (1.2,1.5e-5), water (998,1e-6), or density in kg/m^3 and viscosity in m^2/s",
        "air|water|RHO,NU")
        ->default_str("the fluid of the bake");
    add("--seed", seed, "another seed gives other attitudes and other noise", "N")->capture_default_str();
    add("--step", step, "time step, s, as a number or as 1/240", "S")->default_str("1/120, less for small fast bodies");
    add("--png", command.png, "picture of falls from the side and of landings from above", "FILE");
    add("--json", command.json, "all numbers, in SI units", "FILE");
    app.add_flag("--quiet", command.quiet, "print errors only");
    try {
        app.parse(argc, argv);
        for (const auto& [option, file] : {std::pair{"--png", &command.png}, {"--json", &command.json}}) {
            if (app.count(option) > 0 && file->empty()) throw CLI::ValidationError(option, "the file name is empty");
            *file = baker::with_slashes(*file);
        }
        baker::check_png_name(command.png, "--png");
        falls::Drop& drop = command.drop;
        drop.release = parse_release(release);
        drop.height = parse_number<double>(height, "--height");
        drop.count = parse_number<uint32_t>(count, "--count");
        const auto xyz = parse_list<double, 3>(wind, "--wind");
        drop.wind = {xyz[0], xyz[1], xyz[2]};
        drop.turbulence = parse_number<double>(turbulence, "--turbulence");
        drop.seed = parse_number<uint64_t>(seed, "--seed");
        command.step_given = app.count("--step") > 0;
        if (command.step_given) drop.step = parse_step(step);
        command.fluid_given = app.count("--fluid") > 0;
        if (command.fluid_given) {
            const auto [density, viscosity] = baker::parse_fluid(fluid);
            drop.fluid_density = density;
            drop.fluid_viscosity = viscosity;
        }
        return command;
    } catch (const CLI::ParseError& error) {
        exit_code = app.exit(error) == 0 ? 0 : baker::usage_error;
    }
    return std::nullopt;
}

Faults check(const DropCommand& command) {
    Faults faults;
    const falls::Drop& d = command.drop;
    const auto within = [&](const char* option, double value, double low, double high) {
        if (value >= low && value <= high) return;
        faults.push_back({FaultId::parameter_out_of_range, Severity::error, option, "It is " + shortest(value) + ".",
                          "Give " + shortest(low) + " to " + shortest(high) + "."});
    };
    within("--height", d.height, 1e-3, 1e4);
    within("--count", d.count, 1, 50000);
    for (int i = 0; i < 3; ++i) within("--wind", d.wind[i], -1000.0, 1000.0);
    within("--turbulence", d.turbulence, 0.0, 1000.0);
    if (command.step_given) within("--step", d.step, 1e-5, 0.1);
    if (command.fluid_given) {
        within("--fluid", d.fluid_density, 1e-3, 1e6);
        within("--fluid", d.fluid_viscosity, 1e-12, 1e3);
    }
    return faults;
}
} // namespace lr::tools
