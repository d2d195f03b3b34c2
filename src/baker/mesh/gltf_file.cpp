#include "baker/mesh/gltf_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <exception>
#include <limits>
#include <set>
#include <stdexcept>
#include <tuple>
#include <vector>

namespace lr::baker {
namespace {

using Json = nlohmann::json;

constexpr std::string_view instancing = "EXT_mesh_gpu_instancing";
constexpr std::size_t most_instances = 1'000'000;
constexpr int deepest = 64; // limit of nesting, since writing the text recurses
constexpr std::size_t most_bytes = std::numeric_limits<uint32_t>::max() / 2;

void demand(bool good) {
    if (!good) throw std::runtime_error("damaged glTF");
}

uint32_t word(std::string_view bytes, std::size_t at) {
    demand(at + 4 <= bytes.size());
    uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, 4);
    return value;
}

std::string word_bytes(std::size_t value) {
    const auto little = static_cast<uint32_t>(value);
    std::string bytes(4, '\0');
    std::memcpy(bytes.data(), &little, 4);
    return bytes;
}

struct Gltf {
    Json json;
    std::string bytes; // all buffers, each starting at a multiple of 4
};

std::string_view json_and_body(std::string_view file, std::string_view& body) {
    if (file.substr(0, 4) != "glTF") return file;
    const std::size_t length = word(file, 12), next = 20 + length;
    demand(next <= file.size());
    if (next + 8 <= file.size()) body = file.substr(next + 8, word(file, next));
    return file.substr(20, length);
}

std::string from_base64(std::string_view text) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    uint32_t bits = 0;
    int waiting = 0;
    for (const char c : text) {
        const std::size_t digit = digits.find(c);
        if (digit == std::string_view::npos) break;
        bits = bits << 6 | static_cast<uint32_t>(digit);
        waiting += 6;
        if (waiting < 8) continue;
        waiting -= 8;
        bytes += static_cast<char>(bits >> waiting & 0xff);
    }
    return bytes;
}

std::size_t number(const Json& object, const char* key) {
    const std::size_t value = object.value(key, std::size_t{0});
    demand(value <= most_bytes);
    return value;
}

Gltf read_all(std::string_view file, const ReadGltfBuffer& read_buffer) {
    std::string_view body;
    const std::string_view text = json_and_body(file, body);
    Gltf gltf;
    gltf.json = Json::parse(text, [](int depth, Json::parse_event_t, const Json&) {
        demand(depth < deepest);
        return true;
    });
    std::vector<std::size_t> begins;
    for (const Json& buffer : gltf.json.at("buffers")) {
        const std::string uri = buffer.value("uri", "");
        const std::size_t comma = uri.find(";base64,");
        const std::string bytes = uri.empty() ? std::string(body)
                                  : uri.substr(0, 5) == "data:" && comma != std::string::npos
                                      ? from_base64(std::string_view(uri).substr(comma + 8))
                                      : read_buffer(uri);
        demand(bytes.size() >= number(buffer, "byteLength"));
        begins.push_back(gltf.bytes.size());
        gltf.bytes += bytes;
        gltf.bytes.resize((gltf.bytes.size() + 3) / 4 * 4);
        demand(gltf.bytes.size() < most_bytes);
    }
    for (Json& view : gltf.json.at("bufferViews")) {
        view["byteOffset"] = number(view, "byteOffset") + begins.at(number(view, "buffer"));
        view["buffer"] = 0;
    }
    return gltf;
}

template <class Number> float as_float(const char* from, bool normalized) {
    Number value{};
    std::memcpy(&value, from, sizeof value);
    if (!normalized) return static_cast<float>(value);
    return std::max(static_cast<float>(value) / static_cast<float>(std::numeric_limits<Number>::max()), -1.0F);
}

float as_float(const char* from, std::size_t type, bool normalized) {
    return type == 5120   ? as_float<int8_t>(from, normalized)
           : type == 5121 ? as_float<uint8_t>(from, normalized)
           : type == 5122 ? as_float<int16_t>(from, normalized)
           : type == 5123 ? as_float<uint16_t>(from, normalized)
                          : as_float<float>(from, false);
}

// Where an accessor's numbers begin, and how far apart they are.
struct Layout {
    std::size_t type = 0, size = 0, count = 0, begin = 0, stride = 0;
};

Layout layout_of(const Gltf& gltf, const Json& accessor, std::size_t components) {
    Layout l;
    l.type = number(accessor, "componentType");
    demand(((l.type >= 5120 && l.type <= 5123) || l.type == 5126) && !accessor.contains("sparse"));
    const Json& view = gltf.json.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
    l.size = l.type < 5122 ? 1 : l.type == 5126 ? 4 : 2;
    l.count = number(accessor, "count");
    l.stride = std::max(number(view, "byteStride"), components * l.size);
    l.begin = number(view, "byteOffset") + number(accessor, "byteOffset");
    demand(l.count > 0 && l.count < most_bytes / l.stride / 12 &&
           l.begin + (l.count - 1) * l.stride + components * l.size <= gltf.bytes.size());
    return l;
}

// Returns the accessor.
Json append_floats(Gltf& gltf, const std::string& floats, std::size_t count, const char* type) {
    const std::size_t view = gltf.json["bufferViews"].size();
    gltf.json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", gltf.bytes.size()}, {"byteLength", floats.size()}});
    gltf.bytes += floats;
    demand(gltf.bytes.size() < most_bytes);
    return {{"bufferView", view}, {"componentType", 5126}, {"count", count}, {"type", type}};
}

void unpack(Gltf& gltf, Json& accessor) {
    const std::size_t type = number(accessor, "componentType");
    if (type < 5120 || type > 5123 || !accessor.contains("bufferView")) return;
    demand(accessor.at("type") == "VEC3");
    const Layout l = layout_of(gltf, accessor, 3);
    const bool normalized = accessor.value("normalized", false);
    std::string floats(12 * l.count, '\0');
    for (std::size_t i = 0; i < 3 * l.count; ++i) {
        const float value = as_float(gltf.bytes.data() + l.begin + i / 3 * l.stride + i % 3 * l.size, type, normalized);
        std::memcpy(floats.data() + 4 * i, &value, 4);
    }
    accessor = append_floats(gltf, floats, l.count, "VEC3");
}

// Makes each copy of a mesh that EXT_mesh_gpu_instancing places a node below the one that has the mesh.
void expand_instances(Gltf& gltf) {
    Json& nodes = gltf.json.at("nodes");
    for (std::size_t n = 0, end = nodes.size(); n < end; ++n) {
        const Json extension = nodes[n].value("extensions", Json::object()).value(std::string(instancing), Json());
        if (extension.is_null() || !nodes[n].contains("mesh")) continue;
        Json copy{{"mesh", nodes[n]["mesh"]}, {"name", nodes[n].value("name", "")}};
        std::vector<Json> copies;
        for (const auto& [attribute, key, components] :
             {std::tuple{"TRANSLATION", "translation", 3U}, {"ROTATION", "rotation", 4U}, {"SCALE", "scale", 3U}}) {
            if (!extension.at("attributes").contains(attribute)) continue;
            const Json& accessor = gltf.json.at("accessors").at(number(extension["attributes"], attribute));
            const Layout l = layout_of(gltf, accessor, components);
            if (copies.empty()) copies.resize(l.count, copy);
            demand(copies.size() == l.count && nodes.size() + l.count < most_instances);
            for (std::size_t i = 0; i < l.count; ++i)
                for (std::size_t k = 0; k < components; ++k)
                    copies[i][key].push_back(
                        as_float(gltf.bytes.data() + l.begin + i * l.stride + k * l.size, l.type, true));
        }
        nodes[n].erase("mesh");
        for (Json& child : copies) {
            nodes[n]["children"].push_back(nodes.size());
            nodes.push_back(std::move(child));
        }
    }
}

bool is_unbound(const Json& skin) {
    return !skin.contains("inverseBindMatrices");
}

void bind(Gltf& gltf, Json& skin) {
    const std::size_t joints = std::max<std::size_t>(1, skin.value("joints", Json::array()).size());
    std::string identities;
    for (std::size_t i = 0; i < 16 * joints; ++i)
        identities += i % 16 % 5 == 0 ? std::string("\0\0\x80\x3f", 4) : std::string(4, '\0');
    skin["inverseBindMatrices"] = gltf.json.at("accessors").size();
    gltf.json["accessors"].push_back(append_floats(gltf, identities, joints, "MAT4"));
}
} // namespace

std::string why_no_gltf(std::string_view file) {
    try {
        std::string_view body;
        const std::string_view text = json_and_body(file, body);
        if (!Json::accept(text)) return "This glTF is cut off or damaged: it is no whole JSON text.";
        const Json json = Json::parse(text);
        const Json version = json.value("asset", Json::object()).value("version", Json());
        if (version.is_string()) return "This is glTF " + version.get<std::string>() + "; glTF 2 is read.";
        const bool old = json.value("meshes", Json()).is_object();
        return std::string("This glTF does not state its version: it has no \"asset\" with a \"version\" in quotes") +
               (old ? ". Its meshes are those of a draft of glTF 1; glTF 2 is read." : ".");
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception&) {
        return {};
    }
}

std::string_view unread_gltf_extension(std::string_view file) {
    const std::size_t begin = file.find("\"extensionsRequired\"");
    if (begin == std::string_view::npos) return {};
    const std::string_view list = file.substr(begin, file.find(']', begin) - begin);
    for (const std::string_view name : {"EXT_meshopt_compression", "KHR_meshopt_compression"})
        if (list.find(name) != std::string_view::npos) return name;
    return {};
}

bool has_gpu_instances(std::string_view file) {
    return file.find(instancing) != std::string_view::npos;
}

bool has_quantized_positions(std::string_view file) {
    return file.find("\"KHR_mesh_quantization\"") != std::string_view::npos;
}

bool has_unbound_skins(std::string_view file) {
    if (file.find("\"skins\"") == std::string_view::npos) return false;
    try {
        std::string_view body;
        const Json json = Json::parse(json_and_body(file, body));
        const Json& skins = json.at("skins");
        return std::any_of(skins.begin(), skins.end(), is_unbound);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception&) {
        return false;
    }
}

std::string plain_glb(std::string_view file, const ReadGltfBuffer& read_buffer) {
    try {
        Gltf gltf = read_all(file, read_buffer);
        std::set<std::size_t> positions;
        for (const Json& mesh : gltf.json.at("meshes"))
            for (const Json& primitive : mesh.at("primitives"))
                if (primitive.at("attributes").contains("POSITION"))
                    positions.insert(number(primitive["attributes"], "POSITION"));
        for (const std::size_t accessor : positions) unpack(gltf, gltf.json.at("accessors").at(accessor));
        expand_instances(gltf);
        if (gltf.json.contains("skins"))
            for (Json& skin : gltf.json["skins"])
                if (is_unbound(skin)) bind(gltf, skin);
        gltf.json["buffers"] = {{{"byteLength", gltf.bytes.size()}}};
        std::string text = gltf.json.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        return "glTF" + word_bytes(2) + word_bytes(28 + text.size() + gltf.bytes.size()) + word_bytes(text.size()) +
               "JSON" + text + word_bytes(gltf.bytes.size()) + std::string("BIN\0", 4) + gltf.bytes;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception&) {
        return {};
    }
}
} // namespace lr::baker
