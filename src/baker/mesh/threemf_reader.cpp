#include "baker/mesh/threemf_reader.h"

#include "baker/mesh/xml_tags.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#define ZLIB_CONST
#include <zlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace lr::baker {
namespace {

constexpr std::size_t max_polygons = 20'000'000; // above the limit that the caller refuses
constexpr int max_depth = 32;                    // of components in components

using Key = std::pair<std::string, std::string>; // file in the archive, id

struct Component {
    Key object;
    Eigen::Affine3d transform = Eigen::Affine3d::Identity();
};

struct Object {
    std::string name;
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::array<uint32_t, 3>> triangles;
    std::vector<Component> components;
};

template <class Number> bool read_number(std::string_view text, Number& value) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n+");
    if (begin == std::string_view::npos) return false;
    text.remove_prefix(begin);
    return std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc();
}

// Twelve numbers: the images of the axes and of the origin.
Eigen::Affine3d transform_of(std::string_view text) {
    Eigen::Affine3d out = Eigen::Affine3d::Identity();
    for (Eigen::Index i = 0; i < 12; ++i) {
        double value = 0.0;
        if (!read_number(text, value)) return Eigen::Affine3d::Identity();
        out.matrix()(i % 3, i / 3) = value;
        text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
        text.remove_prefix(std::min(text.find_first_of(" \t\r\n"), text.size()));
    }
    return out;
}

// A zip archive. lib3mf and Microsoft's programs always write Zip64, whatever the size.
class Archive {
public:
    Archive(const void* bytes, std::size_t size) : bytes_(static_cast<const char*>(bytes), size) {
        const std::size_t end = bytes_.rfind("PK\5\6");
        if (end == std::string_view::npos || bytes_.size() - end < 22) return;
        std::size_t count = number(end + 10, 2), at = number(end + 16, 4);
        if (count == 0xffff || at == elsewhere) {
            const std::size_t large = number(end - std::min<std::size_t>(end, 12), 8); // in the locator before the end
            if (large > bytes_.size() || bytes_.substr(large, 4) != "PK\6\6") return;
            count = number(large + 32, 8);
            at = number(large + 48, 8);
        }
        for (std::size_t i = 0; i < count; ++i) {
            if (at > bytes_.size() || bytes_.size() - at < 46 || bytes_.substr(at, 4) != "PK\1\2") return;
            const std::size_t length = number(at + 28, 2);
            entries_[std::string(bytes_.substr(at + 46, length))] = at;
            at += 46 + length + number(at + 30, 2) + number(at + 32, 2);
        }
    }

    bool is_open() const { return !entries_.empty(); }
    std::vector<std::string> models() const {
        std::vector<std::string> names;
        for (const auto& [name, at] : entries_)
            if (name.size() > 6 && name.substr(name.size() - 6) == ".model") names.push_back(name);
        return names;
    }
    // Empty if the file is missing or cannot be unpacked.
    std::string text(const std::string& name) const {
        constexpr std::size_t most = std::size_t{1} << 30;
        const auto entry = entries_.find(name);
        if (entry == entries_.end()) return {};
        const std::size_t at = entry->second, method = number(at + 10, 2);
        std::size_t size = number(at + 24, 4), packed = number(at + 20, 4), local = number(at + 42, 4);
        // Zip64 keeps numbers that do not fit in an extra field, in this order.
        const std::size_t fields = at + 46 + number(at + 28, 2), past = fields + number(at + 30, 2);
        for (std::size_t field = fields; field + 4 < past; field += 4 + number(field + 2, 2)) {
            if (number(field, 2) != 1) continue;
            std::size_t next = field + 4;
            for (std::size_t* value : {&size, &packed, &local})
                if (*value == elsewhere) *value = number(next, 8), next += 8;
            break;
        }
        if (local > bytes_.size()) return {};
        const std::size_t begin = local + 30 + number(local + 26, 2) + number(local + 28, 2);
        if (begin > bytes_.size() || packed > bytes_.size() - begin || size > most) return {};
        const std::string_view from = bytes_.substr(begin, packed);
        if (method == 0) return std::string(from);
        std::string out(size, '\0');
        z_stream stream{};
        if (method != 8 || inflateInit2(&stream, -MAX_WBITS) != Z_OK) return {};
        stream.next_in = reinterpret_cast<const Bytef*>(from.data());
        stream.avail_in = static_cast<uInt>(from.size());
        stream.next_out = reinterpret_cast<Bytef*>(out.data());
        stream.avail_out = static_cast<uInt>(out.size());
        const bool whole = inflate(&stream, Z_FINISH) == Z_STREAM_END && stream.avail_out == 0;
        inflateEnd(&stream);
        return whole ? out : std::string();
    }

private:
    static constexpr std::size_t elsewhere = 0xffffffff;

    // Little-endian; 0 beyond the end.
    std::size_t number(std::size_t at, std::size_t size) const {
        std::size_t value = 0;
        for (std::size_t i = size; i-- > 0;)
            value = value << 8 | (at + i < bytes_.size() ? static_cast<uint8_t>(bytes_[at + i]) : 0U);
        return value;
    }

    std::string_view bytes_;
    std::map<std::string, std::size_t> entries_; // places in the central directory
};

std::string without_slash(std::string_view path) {
    return std::string(path.substr(path.empty() || path[0] != '/' ? 0 : 1));
}

class Reader {
public:
    Reader(PolygonSoup& soup, const std::string& where, Faults& faults) : soup_(soup), where_(where), faults_(faults) {}

    bool run(const Archive& archive) {
        if (!archive.is_open()) return fail("The file is no 3MF archive, or damaged.");
        std::string root;
        const std::string relations = archive.text("_rels/.rels");
        for_each_tag(relations, [&](const XmlTag& tag) {
            const std::string_view type = attribute(tag, "Type").value_or("");
            if (tag.name == "Relationship" && type.find("3dmodel") != std::string_view::npos && root.empty())
                root = without_slash(attribute(tag, "Target").value_or(""));
            return true;
        });
        for (const std::string& name : archive.models()) {
            const std::string path = without_slash(name);
            if (root.empty()) root = path;
            const std::string text = archive.text(name);
            if (!parse(text, path, path == root)) return false;
        }
        if (items_.empty())
            for (const auto& [key, object] : objects_)
                if (!object.triangles.empty()) items_.push_back({key});
        for (const Component& item : items_) {
            place(item, Eigen::Affine3d::Identity(), 0);
            ++object_;
        }
        return true;
    }

private:
    template <class Visit> static bool for_each_tag(std::string_view text, const Visit& visit) {
        for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at)) {
            XmlTag tag;
            if (!next_tag(text, at, tag)) return false;
            if (!tag.name.empty() && !visit(tag)) return false;
        }
        return true;
    }

    bool parse(std::string_view text, const std::string& path, bool is_root) {
        Object* object = nullptr;
        const auto component = [&](const XmlTag& tag) {
            Component out{{without_slash(attribute(tag, "p:path").value_or(path)),
                           std::string(attribute(tag, "objectid").value_or(""))}};
            if (const auto matrix = attribute(tag, "transform")) out.transform = transform_of(*matrix);
            return out;
        };
        const bool whole = for_each_tag(text, [&](const XmlTag& tag) {
            // Some programs give tags of the core a prefix.
            const std::string_view name = tag.name.substr(tag.name.rfind(':') + 1);
            if (name == "model" && is_root)
                soup_.declared_unit = unit_of(attribute(tag, "unit").value_or("millimeter"));
            if (name == "object") {
                object = &objects_[{path, std::string(attribute(tag, "id").value_or(""))}];
                object->name = attribute(tag, "name").value_or("");
            }
            if (name == "item" && is_root) items_.push_back(component(tag));
            if (!object) return true;
            if (name == "component") object->components.push_back(component(tag));
            if (name == "vertex") {
                Eigen::Vector3d v;
                constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
                for (std::size_t k = 0; k < 3; ++k)
                    if (!read_number(attribute(tag, axes[k]).value_or(""), v[static_cast<Eigen::Index>(k)]))
                        return fail("A vertex of the 3MF file has no three numbers.");
                object->vertices.push_back(v);
            }
            if (name == "triangle") {
                std::array<uint32_t, 3> t{};
                constexpr std::array<std::string_view, 3> corners{"v1", "v2", "v3"};
                for (std::size_t k = 0; k < 3; ++k)
                    if (!read_number(attribute(tag, corners[k]).value_or(""), t[k]))
                        return fail("A triangle of the 3MF file has no three corners.");
                object->triangles.push_back(t);
            }
            return true;
        });
        if (!whole && !failed_) fail("The XML text of the 3MF file ends early.");
        return whole;
    }

    static double unit_of(std::string_view name) {
        constexpr std::array<std::pair<std::string_view, double>, 6> units{{{"micron", 1e-6},
                                                                            {"millimeter", 1e-3},
                                                                            {"centimeter", 1e-2},
                                                                            {"inch", 0.0254},
                                                                            {"foot", 0.3048},
                                                                            {"meter", 1.0}}};
        for (const auto& [unit, metres] : units)
            if (unit == name) return metres;
        return 1e-3;
    }

    void place(const Component& item, const Eigen::Affine3d& outer, int depth) {
        const auto found = objects_.find(item.object);
        if (found == objects_.end() || depth > max_depth || soup_.polygons.size() > max_polygons) return;
        const Object& object = found->second;
        const Eigen::Affine3d transform = outer * item.transform;
        above_.push_back(object.name);
        if (!object.triangles.empty()) {
            const auto base = static_cast<uint32_t>(soup_.vertices.size());
            const auto count = static_cast<uint32_t>(object.vertices.size());
            const bool mirrored = transform.linear().determinant() < 0.0;
            soup_.parts.push_back({soup_.polygons.size(), object_, {object.name}, above_, {}});
            for (const Eigen::Vector3d& v : object.vertices) soup_.vertices.push_back(transform * v);
            for (const auto& t : object.triangles) {
                std::vector<uint32_t> polygon;
                for (const uint32_t v : t) polygon.push_back(v < count ? base + v : UINT32_MAX); // refused later
                if (mirrored) std::swap(polygon[1], polygon[2]);
                soup_.polygons.push_back(std::move(polygon));
            }
        }
        for (const Component& part : object.components) place(part, transform, depth + 1);
        above_.pop_back();
    }

    bool fail(const char* what) {
        failed_ = true;
        faults_.push_back({FaultId::mesh_unreadable, Severity::error, where_, what,
                           "Open it in the program that made it, and export it again, or as STL or OBJ."});
        return false;
    }

    PolygonSoup& soup_;
    const std::string& where_;
    Faults& faults_;
    bool failed_ = false;
    std::map<Key, Object> objects_;
    std::vector<Component> items_;
    std::vector<std::string> above_;
    std::size_t object_ = 0;
};
} // namespace

bool read_3mf(const void* bytes, std::size_t size, const std::string& where, PolygonSoup& out, Faults& faults) {
    out = {};
    return Reader(out, where, faults).run(Archive(bytes, size));
}
} // namespace lr::baker
