#include "baker/mesh/unknown_file.h"

#include "baker/mesh/gltf_file.h"
#include "baker/printable_text.h"

#include <array>
#include <cstdint>

namespace lr::baker {
namespace {

struct Kind {
    std::string_view begins, extensions, name, program;
};

// Formats that modellers have and no reader here reads, by their first bytes or else by extension.
constexpr std::array kinds{
    Kind{"BLENDER", " blend ", "a Blender file", "Blender"},
    Kind{"\x28\xb5\x2f\xfd", " blend ", "a compressed Blender file", "Blender"},
    Kind{"PXR-USDC", " usd usdc ", "a USD scene", "Blender, or the program that made it,"},
    Kind{"#usda", " usd usda ", "a USD scene", "Blender, or the program that made it,"},
    Kind{"Ogawa", " abc ", "an Alembic cache", "Blender, or the program that made it,"},
    Kind{"ISO-10303-21", " step stp ", "a STEP file (exact surfaces, not polygons)", "FreeCAD or your CAD program"},
    Kind{"", " iges igs sldprt sldasm ipt x_t x_b prt f3d 3dm ", "a CAD file (exact surfaces, not polygons)",
         "your CAD program"},
    Kind{"", " max ma mb c4d skp hip lxo ztl zpr spp ", "a modelling program's own file", "that program"},
    Kind{"\x89PNG", " png ", "an image", ""},
    Kind{"\xff\xd8\xff", " jpg jpeg ", "an image", ""},
    Kind{"PK\x03\x04", " zip usdz kmz ", "a zip archive", ""},
    Kind{"\x1f\x8b", " gz ", "a compressed file", ""},
    Kind{"LRBA", " lrb ", "an asset that is baked already", ""},
};

bool matches(const Kind& kind, std::string_view bytes, const std::string& extension) {
    if (kind.begins == "LRBA") return bytes.size() > 8 && bytes.substr(4, 4) == "LRBA";
    if (!kind.begins.empty()) return bytes.substr(0, kind.begins.size()) == kind.begins;
    return !extension.empty() && kind.extensions.find(" " + extension + " ") != std::string_view::npos;
}

UnknownFile advice(const Kind& kind) {
    const std::string what = "This is " + std::string(kind.name) + ", which is not read here.";
    if (!kind.program.empty())
        return {what,
                "Open it in " + std::string(kind.program) + " and export the model as glTF (.glb), OBJ, STL or PLY."};
    if (kind.name == "an image")
        return {what, "Bake a leaf texture with lr_bake card; export a model as glTF, OBJ, STL or PLY."};
    if (kind.begins == "LRBA") return {what, "Give the mesh that it was baked from; lr_bake info shows this file."};
    return {what, "Unpack it and give the mesh inside."};
}

// Drops "glTF", "GLTF: " and quoted file names: the message already names the file.
std::string without_prefix(const std::string& reason) {
    const std::size_t colon = reason.find(": ");
    return colon != std::string::npos && colon < 16 ? reason.substr(colon + 2) : reason;
}
} // namespace

UnknownFile explain_unknown_file(std::string_view bytes, const std::string& extension, const std::string& reason) {
    if (bytes.substr(0, 4) == "glTF" && bytes.size() >= 8 && bytes[4] == 1)
        return {"This is glTF 1, the version of 2015; glTF 2 is read.",
                "Convert it with gltf-pipeline or COLLADA2GLTF 2, or export the model again as glTF 2 (.glb)."};
    for (const Kind& kind : kinds)
        if (matches(kind, bytes, extension)) return advice(kind);
    const bool unknown = reason.find("No suitable reader") != std::string::npos;
    if (const std::string why = unknown && (extension == "gltf" || extension == "glb") ? why_no_gltf(bytes) : "";
        !why.empty())
        return {printable(why), "Export the model again as glTF 2 (.glb), or convert it with gltf-pipeline."};
    const std::string ending = extension.empty() ? "no extension" : "the extension ." + printable(extension);
    if (unknown)
        return {"No reader knows this kind of file (it has " + ending + ").",
                "Export the model as glTF (.glb), OBJ, STL or PLY, and keep the extension that the program gives."};
    const std::string_view missing = "could not open referenced file";
    if (const std::size_t at = reason.find(missing); at != std::string::npos)
        return {"A file that belongs to it is missing:" + printable(reason.substr(at + missing.size())) + ".",
                "Copy that file beside the model, or export the model as one file (.glb)."};
    return {
        "The file is damaged, or its content does not fit " + ending + " (" + printable(without_prefix(reason)) + ").",
        "Open it in your modelling program to see whether it is whole, and export it again as glTF (.glb), OBJ, STL or "
        "PLY."};
}

std::string_view as_utf8(std::string_view bytes, std::string& storage) {
    if (bytes.substr(0, 3) == "\xef\xbb\xbf") return bytes.substr(3);
    const bool little = bytes.substr(0, 2) == "\xff\xfe", big = bytes.substr(0, 2) == "\xfe\xff";
    if (!little && !big) return bytes;
    storage.clear();
    storage.reserve(bytes.size() / 2);
    const auto unit = [&](std::size_t i) {
        const auto first = static_cast<uint8_t>(bytes[i]), second = static_cast<uint8_t>(bytes[i + 1]);
        return static_cast<uint32_t>(little ? first | second << 8 : first << 8 | second);
    };
    const auto put = [&](uint32_t byte) { storage += static_cast<char>(byte); };
    for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
        uint32_t c = unit(i);
        if (c >= 0xd800 && c < 0xdc00 && i + 3 < bytes.size() && unit(i + 2) >= 0xdc00 && unit(i + 2) < 0xe000) {
            c = 0x10000 + ((c - 0xd800) << 10) + (unit(i + 2) - 0xdc00);
            i += 2;
        } else if (c >= 0xd800 && c < 0xe000) {
            c = 0xfffd; // half a pair
        }
        if (c < 0x80) {
            put(c);
        } else if (c < 0x800) {
            put(0xc0 | c >> 6), put(0x80 | (c & 0x3f));
        } else if (c < 0x10000) {
            put(0xe0 | c >> 12), put(0x80 | (c >> 6 & 0x3f)), put(0x80 | (c & 0x3f));
        } else {
            put(0xf0 | c >> 18), put(0x80 | (c >> 12 & 0x3f)), put(0x80 | (c >> 6 & 0x3f)), put(0x80 | (c & 0x3f));
        }
    }
    return storage;
}
} // namespace lr::baker
