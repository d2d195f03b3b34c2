#include "tools/lr_bake/options.h"

#include "asset/asset_data.h"
#include "baker/printable_text.h"
#include "tools/command_line.h"
#include "tools/console.h"

#include <CLI/CLI.hpp>

#include <charconv>
#include <cstdio>
#include <filesystem>
#include <system_error>

namespace lr::baker {
namespace {

struct Texts {
    std::string unit, size, up = "z", mesh, density = "800", fluid = "air", grid = "32,32,16", intensity = "1";
    std::string center_of_mass, mass_from, name;
    std::string semi_axis[3];
    std::string output, output_folder, jobs;
    std::string stations = "8";
    bool force = false;
    std::string thickness, areal_density;
    std::string width, alpha = "0.5", triangles = "2000", mask = "alpha", key, piece, speck = "0.001";
};

void add_mesh_options(CLI::App& command, Texts& texts) {
    command
        .add_option(
            "--unit", texts.unit,
            "unit of the mesh and all lengths: m, cm or mm; file: the unit that the file states (Collada, FBX), "
            "else m")
        ->default_str("file")
        ->type_name("UNIT");
    command
        .add_option("--size", texts.size,
                    "true length of the mesh's longest side, as 7cm: scales it from whatever unit it is in")
        ->type_name("LENGTH");
    command.add_option("--up", texts.up, "axis of the mesh that is rotated to +z: x, y, z, -x, -y or -z")
        ->capture_default_str()
        ->type_name("AXIS");
    command.add_option("--mesh", texts.mesh, "bake only the mesh, node or object of this name, not all as one body")
        ->type_name("NAME");
    command
        .add_option(
            "--mass-from", texts.mass_from,
            "a second mesh, in the same unit and frame, that gives the mass: the layers of a folded sheet, or the "
            "solid parts of a hollow or ballasted body")
        ->type_name("MESH");
}

void add_sheet_options(CLI::App& command, Texts& texts, CommandLine& line) {
    command.add_flag("--strict", line.bake.strict,
                     "refuse meshes that are not closed, sound and one body, instead of repairing them");
    const std::string help = "the mesh is the middle surface of a sheet: open or closed, with faces wound in any way";
    CLI::Option* sheet = command.add_flag("--sheet", help);
    command
        .add_flag("--fill", line.bake.fill,
                  "close the holes of open parts, which then are solid: rocks and trunks without a base")
        ->excludes(sheet)
        ->excludes("--strict");
    command.add_option("--thickness", texts.thickness, "of the sheet, or of open parts, in the unit")
        ->default_str("0.3 % of their length")
        ->type_name("T");
    command
        .add_option("--areal-density", texts.areal_density,
                    "mass of the sheet per area, kg/m^2, instead of --density (paper: 0.08)")
        ->needs(sheet)
        ->type_name("KG_M2");
}

void add_card_options(CLI::App& command, Texts& texts, CommandLine& line) {
    const auto add = [&](const char* option, std::string& text, const char* help, const char* type) {
        return command.add_option(option, text, help)->type_name(type);
    };
    add("--width", texts.width, "width of the whole image, in the unit", "W")->required();
    add("--thickness", texts.thickness, "thickness of the leaf, in the unit", "T")->required();
    add("--areal-density", texts.areal_density, "mass of the leaf per area, kg/m^2, instead of --density", "KG_M2");
    add("--unit", texts.unit, "unit of all lengths: m, cm or mm", "UNIT")->default_str("m");
    add("--alpha", texts.alpha, "opacity at the outline, 0.001 to 0.999", "A")->capture_default_str();
    add("--triangles", texts.triangles, "approximate number of triangles", "N")->capture_default_str();
    add("--mask", texts.mask,
        "where the leaf is: alpha, luminance (white on black), or the black-and-white mask in another PNG",
        "alpha|luminance|FILE")
        ->capture_default_str();
    add("--key", texts.key, "the colour around the leaf, where the image has no transparency: white, black, or #rrggbb",
        "COLOUR");
    add("--piece", texts.piece, "which of several separate regions: the N-th by size, or all as one body", "N|all")
        ->default_str("1");
    command.add_flag("--islands", line.islands,
                     "bake every leaf of an atlas by itself: OUT_1.lrb, OUT_2.lrb, ..., by size");
    add("--speck", texts.speck, "ignore regions and holes smaller than this fraction of the largest region", "PART")
        ->capture_default_str();
}

void add_bake_options(CLI::App& command, Texts& texts, CommandLine& line) {
    command.add_option("-o,--output", texts.output, "asset file to write")->type_name("OUT.lrb");
    const auto add = [&](const char* option, std::string& text, const char* help, const char* type) {
        command.add_option(option, text, help)->capture_default_str()->type_name(type);
    };
    add("--density", texts.density, "density of the body, kg/m^3", "KG_M3");
    add("--fluid", texts.fluid, "air (1.2,1.5e-5), water (998,1e-6), or density in kg/m^3 and viscosity in m^2/s",
        "air|water|RHO,NU");
    add("--grid", texts.grid, "cells of the turbulence grid: stream, across, up", "X,Y,Z");
    add("--intensity", texts.intensity, "intensity of the turbulence; 1 is the paper's 100 %", "I");
    command.add_flag("--wake", line.bake.wake,
                     "put the body, broadside, into the stream of the turbulence table: its wake adds turbulence");
    command
        .add_option("--stations", texts.stations,
                    "at most N stations, parts of a bent, pierced or long body that see streams of their own; "
                    "1: loads as one plate, twice as fast")
        ->capture_default_str()
        ->type_name("N");
    command
        .add_option(
            "--center-of-mass", texts.center_of_mass,
            "of a ballasted body, in the unit and frame of the mesh after --up (for an ellipsoid: from its centre)")
        ->type_name("X,Y,Z");
    command.add_option("--name", texts.name, "name in the asset, instead of the file name")->type_name("NAME");
    command.add_option("--report", line.report, "JSON report to write")->type_name("R.json");
    command
        .add_option("--preview", line.preview,
                    "picture of what was understood (PNG): the body with its axes, thin direction, stations, centre of "
                    "mass and hull")
        ->type_name("P.png");
    command
        .add_option("--plots", line.plots, "folder for pictures (SVG): turbulence, added mass, its entries and errors")
        ->type_name("DIR");
    command.add_flag("--if-changed", line.if_changed,
                     "do nothing if this baker made the outputs from this input with these options");
    command.add_flag("--quiet", line.quiet, "print errors only");
}

void add_batch_options(CLI::App& command, Texts& texts, CommandLine& line) {
    command.add_option("IN", line.inputs, "input files; several need --output-dir")->type_name("");
    command.add_option("--list", line.list, "a file with more inputs, one path per line; - for standard input")
        ->type_name("FILE");
    command
        .add_option("-d,--output-dir", texts.output_folder,
                    "folder for the assets, each named after its input; skips up-to-date ones. "
                    "--report and --preview then name folders too")
        ->type_name("DIR");
    command.add_option("-j,--jobs", texts.jobs, "number of bakes at once, as far as memory allows")
        ->default_str("one for each processor")
        ->type_name("N");
    command.add_flag("--force", texts.force, "with --output-dir: bake up-to-date inputs too");
}

bool is_folder(const std::string& path) {
    std::error_code error;
    return std::filesystem::is_directory(std::filesystem::path(std::u8string(path.begin(), path.end())), error);
}

// Accepts one input and -o FILE, or any number of inputs and a folder. An existing folder after -o counts as a folder
// if it ends with a slash or there are several inputs.
void read_outputs(const CLI::App& command, const Texts& texts, CommandLine& line, bool ellipsoid) {
    const bool several = line.inputs.size() > 1 || !line.list.empty();
    if (!ellipsoid && line.inputs.empty() && command.count("--list") == 0) throw CLI::RequiredError("IN");
    if (!ellipsoid && command.count("--list") > 0 && line.list.empty())
        throw CLI::ValidationError("--list", "the file name is empty");
    for (const std::string& input : line.inputs)
        if (several && input.empty()) throw CLI::ValidationError("IN", "a file name is empty");
    if (command.count("--report") > 0 && line.report.empty())
        throw CLI::ValidationError("--report", "the file name is empty");
    if (command.count("--preview") > 0 && line.preview.empty())
        throw CLI::ValidationError("--preview", "the file name is empty");
    if (command.count("--plots") > 0 && line.plots.empty())
        throw CLI::ValidationError("--plots", "the folder name is empty");
    const bool to_folder = !ellipsoid && command.count("--output-dir") > 0;
    if (to_folder == (command.count("--output") > 0))
        throw CLI::ValidationError("--output", to_folder ? "excludes --output-dir"
                                                         : "give an output file, or a folder with --output-dir");
    line.output = with_slashes(to_folder ? texts.output_folder : texts.output);
    line.report = with_slashes(line.report);
    line.preview = with_slashes(line.preview);
    line.plots = with_slashes(line.plots);
    if (line.output.empty()) throw CLI::ValidationError("--output", "the file name is empty");
    line.folders = to_folder || (!ellipsoid && is_folder(line.output) && (several || line.output.back() == '/'));
    if (several && !line.folders)
        throw CLI::ValidationError("--output", "several inputs need a folder: --output-dir DIR");
    if (!line.folders) check_png_name(line.preview, "--preview");
    if (ellipsoid) return;
    if (!line.folders && (texts.force || command.count("--jobs") > 0))
        throw CLI::ValidationError(texts.force ? "--force" : "--jobs", "only with --output-dir");
    if (command.count("--jobs") > 0) line.jobs = parse_number<unsigned>(texts.jobs, "--jobs");
    if (command.count("--jobs") > 0 && (line.jobs < 1 || line.jobs > 1024))
        throw CLI::ValidationError("--jobs", "'" + texts.jobs + "' is not 1 to 1024");
    if (line.folders) {
        if (texts.force && line.if_changed) throw CLI::ValidationError("--force", "excludes --if-changed");
        if (several && command.get_option_no_throw("--mask") && texts.mask != "alpha" && texts.mask != "luminance")
            throw CLI::ValidationError("--mask", "a mask file needs a single image");
        for (const char* const one : {"--name", "--mass-from"})
            if (several && command.get_option_no_throw(one) && command.count(one) > 0)
                throw CLI::ValidationError(one, "needs a single input");
        line.if_changed = !texts.force;
    } else {
        line.bake.mesh_path = line.inputs.front();
    }
}

// A number in the unit, or with a unit of its own: 0.2mm, 7cm, 1.5m.
double parse_length(const std::string& text, const char* option, Unit unit) {
    constexpr const char* length = "a length, as 0.07, 7cm or 70mm";
    std::string_view number = text;
    for (const Unit own : {Unit::mm, Unit::cm, Unit::m}) {
        const std::string_view suffix = unit_name(own);
        if (!number.ends_with(suffix)) continue;
        number.remove_suffix(suffix.size());
        if (number.ends_with(' ')) number.remove_suffix(1);
        const double given = parse_number<double>(number, option, length);
        return own == unit ? given : given / units_per_metre(own) * units_per_metre(unit);
    }
    return parse_number<double>(number, option, length);
}

Unit parse_unit(const CLI::App& command, const Texts& texts, bool mesh) {
    for (const Unit unit : {Unit::m, Unit::cm, Unit::mm})
        if (texts.unit == unit_name(unit)) return unit;
    if ((texts.unit == "file" && mesh) || command.count("--unit") == 0) return Unit::file;
    throw CLI::ValidationError("--unit",
                               "'" + texts.unit + (mesh ? "' is not m, cm, mm or file" : "' is not m, cm or mm"));
}

std::array<uint8_t, 3> parse_colour(const std::string& text) {
    if (text == "white") return {255, 255, 255};
    if (text == "black") return {0, 0, 0};
    const std::size_t at = !text.empty() && text[0] == '#' ? 1 : 0;
    uint32_t value = 0;
    const char* const end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data() + at, end, value, 16);
    if (text.size() != at + 6 || parsed.ec != std::errc{} || parsed.ptr != end)
        throw CLI::ValidationError("--key", "'" + text + "' is not white, black or six hexadecimal digits as #ffffff");
    return {static_cast<uint8_t>(value >> 16), static_cast<uint8_t>(value >> 8), static_cast<uint8_t>(value)};
}

void read_mesh_options(const CLI::App& command, const Texts& texts, BakeOptions& o) {
    bool known = false;
    for (const UpAxis up : {UpAxis::x, UpAxis::y, UpAxis::z, UpAxis::minus_x, UpAxis::minus_y, UpAxis::minus_z})
        if (texts.up == up_name(up)) {
            o.up = up;
            known = true;
        }
    if (!known) throw CLI::ValidationError("--up", "'" + texts.up + "' is not x, y, z, -x, -y or -z");
    if (command.count("--mass-from") > 0) {
        if (texts.mass_from.empty()) throw CLI::ValidationError("--mass-from", "the file name is empty");
        if (command.count("--center-of-mass") > 0)
            throw CLI::ValidationError("--mass-from", "excludes --center-of-mass");
        o.mass.emplace().path = texts.mass_from;
    }
    if (command.count("--size") > 0) o.size = parse_length(texts.size, "--size", o.unit) / units_per_metre(o.unit);
    if (command.count("--mesh") == 0) return;
    if (texts.mesh.empty()) throw CLI::ValidationError("--mesh", "the name is empty");
    o.mesh = texts.mesh;
}

void read_thickness(const CLI::App& command, const Texts& texts, BakeOptions& o) {
    if (command.count("--areal-density") > 0 && command.count("--density") > 0)
        throw CLI::ValidationError("--areal-density", "give either this or --density");
    o.sheet.emplace();
    if (command.count("--thickness") > 0) o.sheet->thickness = parse_length(texts.thickness, "--thickness", o.unit);
    if (command.count("--areal-density") > 0)
        o.sheet->areal_density = parse_number<double>(texts.areal_density, "--areal-density");
}

void read_sheet_options(const CLI::App& command, const Texts& texts, BakeOptions& o) {
    const bool thick = command.count("--thickness") > 0;
    if (command.count("--sheet") == 0) {
        if (thick) o.thickness = parse_length(texts.thickness, "--thickness", o.unit);
        return;
    }
    if (!thick && command.count("--areal-density") == 0) {
        o.sheet.emplace();
        return;
    }
    read_thickness(command, texts, o);
}

void read_card_options(const CLI::App& command, const Texts& texts, BakeOptions& o) {
    CardOptions& card = o.card.emplace();
    card.width = parse_length(texts.width, "--width", o.unit);
    card.alpha = parse_number<double>(texts.alpha, "--alpha");
    card.triangles = parse_number<uint32_t>(texts.triangles, "--triangles");
    card.speck = parse_number<double>(texts.speck, "--speck");
    if (texts.mask == "luminance")
        card.channel = MaskChannel::luminance;
    else if (texts.mask.empty())
        throw CLI::ValidationError("--mask", "the file name is empty");
    else if (texts.mask != "alpha")
        card.mask_path = texts.mask;
    if (command.count("--key") > 0) {
        if (command.count("--mask") > 0) throw CLI::ValidationError("--key", "excludes --mask");
        card.channel = MaskChannel::key;
        card.key = parse_colour(texts.key);
    }
    card.all_pieces = texts.piece == "all";
    if (command.count("--islands") > 0 && command.count("--piece") > 0)
        throw CLI::ValidationError("--islands", "excludes --piece");
    if (command.count("--piece") > 0 && !card.all_pieces) card.piece = parse_number<uint32_t>(texts.piece, "--piece");
    read_thickness(command, texts, o);
}

void read_bake_options(const CLI::App& command, const Texts& texts, BakeOptions& o) {
    o.density = parse_number<double>(texts.density, "--density");
    const auto [density, viscosity] = parse_fluid(texts.fluid);
    o.fluid_density = density;
    o.fluid_viscosity = viscosity;
    o.cells = parse_list<uint32_t, 3>(texts.grid, "--grid");
    o.intensity = parse_number<double>(texts.intensity, "--intensity");
    o.stations = parse_number<uint32_t>(texts.stations, "--stations");
    if (command.count("--center-of-mass") > 0)
        o.center_of_mass = parse_list<double, 3>(texts.center_of_mass, "--center-of-mass");
    if (command.count("--name") > 0) o.name = texts.name;
}
} // namespace

std::optional<CommandLine> parse_command_line(int argc, char** argv, int& exit_code) {
    CommandLine line;
    Texts texts;
    CLI::App app{"Makes Langevin Rigid assets: mass, added mass, turbulence tables and hull of a body in a fluid.",
                 "lr_bake"};
    app.set_version_flag("--version", "lr_bake " + std::string(baker_version()) + ", asset format " +
                                          std::to_string(asset_format_version));
    app.require_subcommand(1);
    app.footer("Exit code: 0 success; 1 a numbered fault (docs/reference/asset_format.md); 2 wrong usage.");

    CLI::App* mesh = app.add_subcommand(
        "mesh", "bake triangle meshes (OBJ, PLY, STL, glTF, GLB, FBX, Collada, ...), closed or sheets");
    add_batch_options(*mesh, texts, line);
    add_mesh_options(*mesh, texts);
    add_sheet_options(*mesh, texts, line);
    add_bake_options(*mesh, texts, line);

    CLI::App* card = app.add_subcommand("card", "bake flat leaves from the alpha channels of PNG images");
    add_batch_options(*card, texts, line);
    add_card_options(*card, texts, line);
    add_bake_options(*card, texts, line);

    CLI::App* ellipsoid = app.add_subcommand("ellipsoid", "bake a solid ellipsoid from closed forms");
    const char* const axis_names[] = {"A", "B", "C"};
    for (std::size_t i = 0; i < 3; ++i)
        ellipsoid->add_option(axis_names[i], texts.semi_axis[i], "semi-axis, in the unit")->required()->type_name("");
    ellipsoid->add_option("--unit", texts.unit, "unit of all lengths: m, cm or mm")
        ->default_str("m")
        ->type_name("UNIT");
    add_bake_options(*ellipsoid, texts, line);

    CLI::App* info = app.add_subcommand("info", "print the contents of an asset");
    info->add_option("F.lrb", line.asset, "asset file")->required()->type_name("");
    info->add_flag("--json", line.json, "as JSON, in SI units");

    CLI::App* check = app.add_subcommand("check", "check an asset: exit code 0, or 1 with numbered faults");
    check->add_option("F.lrb", line.asset, "asset file")->required()->type_name("");

    try {
        app.parse(argc, argv);
        if (info->parsed() || check->parsed()) {
            line.command = info->parsed() ? CommandLine::Command::info : CommandLine::Command::check;
            return line;
        }
        if (ellipsoid->parsed()) {
            std::array<double, 3> axes{};
            for (std::size_t i = 0; i < 3; ++i) axes[i] = parse_number<double>(texts.semi_axis[i], axis_names[i]);
            line.bake.semi_axes = axes;
        }
        const CLI::App& command = mesh->parsed() ? *mesh : card->parsed() ? *card : *ellipsoid;
        read_outputs(command, texts, line, ellipsoid->parsed());
        line.bake.unit = parse_unit(command, texts, mesh->parsed());
        if (mesh->parsed()) {
            read_mesh_options(*mesh, texts, line.bake);
            read_sheet_options(*mesh, texts, line.bake);
        }
        if (card->parsed()) read_card_options(*card, texts, line.bake);
        read_bake_options(command, texts, line.bake);
        return line;
    } catch (const CLI::ParseError& error) {
        exit_code = app.exit(error) == 0 ? 0 : usage_error;
    }
    return std::nullopt;
}

int wrong_usage(const std::string& what) {
    std::fprintf(stderr, "%s\nRun with --help for more information.\n", printable(what).c_str());
    return usage_error;
}
} // namespace lr::baker
