#include "baker/mesh/ply_reader.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

namespace lr::baker {
namespace {

enum class Type { i8, u8, i16, u16, i32, u32, f32, f64, unknown };

struct Property {
    std::string name;
    Type type = Type::unknown;
    Type count = Type::unknown; // of a list
    bool is_list = false;
};

struct Element {
    std::string name;
    uint64_t size = 0;
    std::vector<Property> properties;
};

Type type_of(std::string_view name) {
    if (name == "char" || name == "int8") return Type::i8;
    if (name == "uchar" || name == "uint8") return Type::u8;
    if (name == "short" || name == "int16") return Type::i16;
    if (name == "ushort" || name == "uint16") return Type::u16;
    if (name == "int" || name == "int32") return Type::i32;
    if (name == "uint" || name == "uint32") return Type::u32;
    if (name == "float" || name == "float32") return Type::f32;
    if (name == "double" || name == "float64") return Type::f64;
    return Type::unknown;
}

bool is_separator(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

class PlyParser {
public:
    PlyParser(std::string_view bytes, PolygonSoup& soup, Faults& faults) : rest_(bytes), soup_(soup), faults_(faults) {}

    bool parse() {
        if (!parse_header()) return false;
        for (const Element& element : elements_)
            for (uint64_t i = 0; i < element.size; ++i)
                if (!parse_item(element, i)) return false;
        if (!soup_.polygons.empty()) soup_.parts.emplace_back();
        if (!strips_.empty()) append_strips();
        return true;
    }

private:
    // Triangle strips, as in Stanford's models: each number continues the strip, -1 ends it, every second triangle is wound the other way, and
    // triangles without area are seams.
    void append_strips() {
        if (soup_.polygons.empty()) soup_.parts.emplace_back();
        std::size_t begin = 0;
        for (std::size_t i = 0; i < strips_.size(); ++i) {
            if (strips_[i] == strip_end) {
                begin = i + 1;
                continue;
            }
            if (i < begin + 2) continue;
            uint32_t a = strips_[i - 2], b = strips_[i - 1];
            const uint32_t c = strips_[i];
            if ((i - begin) % 2 != 0) std::swap(a, b);
            if (a != b && b != c && c != a) soup_.polygons.push_back({a, b, c});
        }
        if (soup_.polygons.empty()) soup_.parts.clear();
    }

    bool fail(FaultId id, std::string where, std::string what) {
        faults_.push_back({id, Severity::error, std::move(where), std::move(what), "Export the file again."});
        return false;
    }

    std::string_view next_word(std::string_view& text) const {
        std::size_t begin = 0;
        while (begin < text.size() && is_separator(text[begin])) ++begin;
        std::size_t end = begin;
        while (end < text.size() && !is_separator(text[end])) ++end;
        const std::string_view word = text.substr(begin, end - begin);
        text.remove_prefix(end);
        return word;
    }

    bool parse_header() {
        for (int line_number = 1; !rest_.empty(); ++line_number) {
            const std::size_t end = std::min(rest_.find('\n'), rest_.size());
            std::string_view line = rest_.substr(0, end);
            rest_.remove_prefix(std::min(end + 1, rest_.size()));
            const std::string where = "line " + std::to_string(line_number);
            const std::string_view keyword = next_word(line);
            if (line_number == 1 && keyword != "ply")
                return fail(FaultId::mesh_unreadable, where, "This is not a PLY file.");
            if (keyword == "end_header")
                return has_format_ || fail(FaultId::mesh_unreadable, where, "The format is missing.");
            if (keyword == "format" && !parse_format(next_word(line)))
                return fail(FaultId::mesh_unreadable, where, "The format is unknown.");
            if (keyword == "element") {
                Element element;
                element.name = next_word(line);
                const std::string_view count = next_word(line);
                const auto [stop, error] = std::from_chars(count.data(), count.data() + count.size(), element.size);
                if (error != std::errc() || stop != count.data() + count.size() || count.empty())
                    return fail(FaultId::mesh_unreadable, where, "An element has no count.");
                elements_.push_back(std::move(element));
            }
            if (keyword == "property" && !parse_property(line))
                return fail(FaultId::mesh_unreadable, where, "A property has an unknown type.");
        }
        return fail(FaultId::mesh_unreadable, "header", "The header does not end.");
    }

    bool parse_format(std::string_view name) {
        has_format_ = true;
        ascii_ = name == "ascii";
        big_endian_ = name == "binary_big_endian";
        return ascii_ || big_endian_ || name == "binary_little_endian";
    }

    bool parse_property(std::string_view line) {
        if (elements_.empty()) return false;
        Property property;
        std::string_view word = next_word(line);
        property.is_list = word == "list";
        if (property.is_list) {
            property.count = type_of(next_word(line));
            word = next_word(line);
            if (property.count == Type::unknown) return false;
        }
        property.type = type_of(word);
        property.name = next_word(line);
        if (property.type == Type::unknown || property.name.empty()) return false;
        elements_.back().properties.push_back(std::move(property));
        return true;
    }

    template <typename T> bool read_binary(double& value) {
        if (rest_.size() < sizeof(T)) return false;
        std::array<char, sizeof(T)> raw;
        std::memcpy(raw.data(), rest_.data(), sizeof(T));
        if (big_endian_ != (std::endian::native == std::endian::big)) std::reverse(raw.begin(), raw.end());
        value = static_cast<double>(std::bit_cast<T>(raw));
        rest_.remove_prefix(sizeof(T));
        return true;
    }

    bool read_number(Type type, double& value) {
        if (ascii_) {
            std::string_view word = next_word(rest_);
            if (!word.empty() && word.front() == '+') word.remove_prefix(1);
            const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
            if (error == std::errc::result_out_of_range) value = HUGE_VAL; // infinite, refused below
            return !word.empty() && end == word.data() + word.size() && error != std::errc::invalid_argument;
        }
        switch (type) {
        case Type::i8:
            return read_binary<int8_t>(value);
        case Type::u8:
            return read_binary<uint8_t>(value);
        case Type::i16:
            return read_binary<int16_t>(value);
        case Type::u16:
            return read_binary<uint16_t>(value);
        case Type::i32:
            return read_binary<int32_t>(value);
        case Type::u32:
            return read_binary<uint32_t>(value);
        case Type::f32:
            return read_binary<float>(value);
        case Type::f64:
            return read_binary<double>(value);
        case Type::unknown:
            break;
        }
        return false;
    }

    // Stops at the first missing number, so that a wrong count in the header cannot cause a long loop.
    bool parse_item(const Element& element, uint64_t number) {
        const std::string where = element.name + " " + std::to_string(number);
        if (element.properties.empty()) return fail(FaultId::mesh_unreadable, where, "The element has no properties.");
        Eigen::Vector3d position = Eigen::Vector3d::Zero();
        std::vector<uint32_t> polygon;
        for (const Property& property : element.properties) {
            double count = 1.0, value = 0.0;
            if (property.is_list && (!read_number(property.count, count) || !(count >= 0.0)))
                return fail(FaultId::mesh_unreadable, where, "The file ends early, or a count is not a number.");
            const bool strip = element.name == "tristrips";
            const bool corners = (element.name == "face" || strip) && property.is_list &&
                                 (property.name == "vertex_indices" || property.name == "vertex_index");
            const double most = strip ? 4294967295.0 : 1e6;
            if (!(count <= most)) return fail(FaultId::mesh_unreadable, where, "A face has over a million corners.");
            for (double k = 0.0; k < count; k += 1.0) {
                if (!read_number(property.type, value))
                    return fail(FaultId::mesh_unreadable, where, "The file ends early, or a value is not a number.");
                if (element.name == "vertex" && property.name == "x") position[0] = value;
                if (element.name == "vertex" && property.name == "y") position[1] = value;
                if (element.name == "vertex" && property.name == "z") position[2] = value;
                if (!corners) continue;
                if (strip && value == -1.0) {
                    strips_.push_back(strip_end);
                    continue;
                }
                if (!(value >= 0.0 && value < 4294967295.0) || value != std::floor(value))
                    return fail(FaultId::mesh_bad_index, where, "A vertex number is negative or not whole.");
                (strip ? strips_ : polygon).push_back(static_cast<uint32_t>(value));
            }
        }
        if (element.name == "vertex") soup_.vertices.push_back(position);
        if (element.name == "tristrips") strips_.push_back(strip_end);
        if (element.name == "face") soup_.polygons.push_back(std::move(polygon));
        return true;
    }

    std::string_view rest_;
    PolygonSoup& soup_;
    Faults& faults_;
    static constexpr uint32_t strip_end = UINT32_MAX;
    std::vector<uint32_t> strips_;
    std::vector<Element> elements_;
    bool has_format_ = false, ascii_ = false, big_endian_ = false;
};
} // namespace

bool parse_ply(std::string_view bytes, PolygonSoup& out, Faults& faults) {
    out = {};
    return PlyParser(bytes, out, faults).parse();
}
} // namespace lr::baker
