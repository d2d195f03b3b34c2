#include "baker/bake_input.h"

#include "baker/printable_text.h"

#include <filesystem>
#include <memory>
#include <new>

namespace lr::baker {
namespace {

// Refused before minutes of mesh checks and hull.
constexpr std::size_t max_faces = 1'000'000;

std::string utf8(const std::filesystem::path& path) {
    const std::u8string text = path.u8string();
    return valid_utf8(std::string(text.begin(), text.end()));
}

std::filesystem::path mesh_path(const BakeOptions& o) {
    return to_path(o.mesh_path);
}

MeshReadOptions reading_of(const BakeOptions& o) {
    MeshReadOptions how;
    if (o.unit != Unit::file) how.unit_scale = 1.0 / units_per_metre(o.unit);
    how.up = o.up;
    how.max_faces = max_faces;
    how.repair = !o.strict;
    return how;
}

void add_arrays(const MeshArrays& arrays, InputFiles& input) {
    input.add(arrays.positions.data(), arrays.positions.size_bytes());
    input.add(arrays.indices.data(), arrays.indices.size_bytes());
}

void add_memory(const BakeOptions& o, InputFiles& input) {
    if (o.mesh_arrays) {
        add_arrays(*o.mesh_arrays, input);
    } else if (o.mesh_bytes) {
        input.add(o.mesh_bytes->data(), o.mesh_bytes->size());
    }
}

// Whether readers of this format open no other file.
bool stands_alone(const std::string& path) {
    std::string extension = to_path(path).extension().string();
    for (char& c : extension) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    return extension == ".obj" || extension == ".ply" || extension == ".stl" || extension == ".off" ||
           extension == ".3mf";
}

bool trace_card(const BakeOptions& o, Mesh& mesh, CardReport& card, InputFiles& input, Faults& faults) {
    CardOptions how = *o.card;
    how.width /= units_per_metre(o.unit);
    if (o.mesh_bytes)
        return read_card_memory(o.mesh_bytes->data(), o.mesh_bytes->size(), how, o.mesh_path, mesh, card, faults);
    std::shared_ptr<const InputFiles::Bytes> image = input.read(o.mesh_path, &faults);
    const std::string& traced = how.mask_path.empty() ? o.mesh_path : how.mask_path;
    if (image && &traced != &o.mesh_path) image = input.read(traced, &faults);
    const bool good = image && read_card_memory(image->data(), image->size(), how, traced, mesh, card, faults);
    input.forget_bytes();
    return good;
}
} // namespace

bool read_input(const BakeOptions& o, Mesh& mesh, CardReport& card, InputFiles& input, Faults& faults) {
    MeshReadOptions how = reading_of(o);
    how.mesh = o.mesh;
    add_memory(o, input);
    if (o.card) return trace_card(o, mesh, card, input, faults);
    if (o.mesh_arrays) return read_mesh_arrays(o.mesh_arrays->positions, o.mesh_arrays->indices, how, mesh, faults);
    if (!o.mesh_bytes) return read_mesh(o.mesh_path, how, mesh, faults, &input);
    std::string extension = mesh_path(o).extension().string();
    if (!extension.empty()) extension.erase(0, 1);
    return read_mesh_memory(o.mesh_bytes->data(), o.mesh_bytes->size(), extension, how, mesh, faults);
}

bool read_mass_input(const BakeOptions& o, Mesh& mesh, InputFiles& input, Faults& faults) {
    const MeshReadOptions how = reading_of(o);
    if (!o.mass->arrays) return read_mesh(o.mass->path, how, mesh, faults, &input);
    add_arrays(*o.mass->arrays, input);
    return read_mesh_arrays(o.mass->arrays->positions, o.mass->arrays->indices, how, mesh, faults);
}

std::string mass_name(const BakeOptions& o) {
    return o.mass->arrays ? "mesh" : utf8(to_path(o.mass->path).filename());
}

uint64_t input_hash(const InputFiles& input, const std::string& options) {
    Fnv1a hash = input.hash();
    hash.add(options.data(), options.size());
    return hash.value();
}

std::string source_name(const BakeOptions& options) {
    return options.semi_axes ? "ellipsoid" : utf8(mesh_path(options).filename());
}

std::string asset_name(const BakeOptions& options) {
    if (options.name) return valid_utf8(*options.name);
    return options.semi_axes ? "ellipsoid" : utf8(mesh_path(options).stem());
}

std::optional<uint64_t> find_input_hash(const BakeOptions& options) {
    try {
        InputFiles input;
        Faults ignored;
        if (options.mesh_arrays || options.mesh_bytes) {
            add_memory(options, input);
        } else if (!options.semi_axes) {
            Mesh mesh;
            CardReport card;
            if (options.card && !options.card->mask_path.empty() &&
                (!input.read(options.mesh_path, &ignored) || !input.read(options.card->mask_path, &ignored)))
                return {};
            const bool read = options.card || stands_alone(options.mesh_path)
                                  ? input.read(options.mesh_path, &ignored) != nullptr
                                  : read_input(options, mesh, card, input, ignored);
            if (!read) return {};
        }
        if (options.mass && options.mass->arrays) {
            add_arrays(*options.mass->arrays, input);
        } else if (options.mass) {
            Mesh mesh;
            const bool read = stands_alone(options.mass->path) ? input.read(options.mass->path, &ignored) != nullptr
                                                               : read_mass_input(options, mesh, input, ignored);
            if (!read) return {};
        }
        return input_hash(input, canonical_options(options));
    } catch (const std::bad_alloc&) {
        return {};
    }
}
} // namespace lr::baker
