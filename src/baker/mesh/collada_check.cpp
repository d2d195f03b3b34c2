#include "baker/mesh/collada_check.h"

#include "baker/mesh/xml_tags.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lr::baker {
namespace {

constexpr std::string_view blanks = " \t\r\n";

struct Accessor {
    std::string source;
    uint64_t count = 0, stride = 1, offset = 0, params = 0;
    std::size_t at = 0, end = 0;
};

// False if the attribute exists but is not a number of at most nine digits. Without it `value` stays unchanged.
bool read_count(const XmlTag& tag, std::string_view name, uint64_t& value) {
    const std::optional<std::string_view> text = attribute(tag, name);
    if (!text) return true;
    const char* const end = text->data() + text->size();
    const std::from_chars_result result = std::from_chars(text->data(), end, value);
    return result.ec == std::errc{} && result.ptr == end && value < 1'000'000'000;
}

uint64_t count_words(std::string_view text) {
    uint64_t words = 0;
    bool inside = false;
    for (const char c : text) {
        const bool blank = blanks.find(c) != std::string_view::npos;
        words += !blank && !inside;
        inside = !blank;
    }
    return words;
}

bool among(std::string_view name, std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

class ColladaCheck {
public:
    ColladaCheck(std::string_view text, Faults& faults) : text_(text), faults_(faults) {}

    bool run() {
        std::size_t at = 0;
        while ((at = text_.find('<', at)) != std::string_view::npos) {
            XmlTag tag;
            if (!next_tag(text_, at, tag)) return fail(at, "A tag does not end.");
            if (!tag.name.empty() && !check(tag)) return false;
        }
        for (const Accessor& a : accessors_) {
            const auto array = arrays_.find(a.source);
            if (array == arrays_.end()) return fail(a.at, "An accessor refers to a missing array.");
            if (array->second == not_floats) continue;
            if (a.params > a.stride || (a.count > 0 && a.offset + a.count * a.stride > array->second))
                return fail(a.at, "An accessor reaches beyond the end of its array.");
        }
        return true;
    }

private:
    static constexpr uint64_t not_floats = UINT64_MAX;

    // Moves `at` from the beginning of a tag to its end.
    bool check(const XmlTag& tag) {
        const std::string_view n = tag.name;
        if (among(n, {"p", "h", "vcount", "v"}) &&
            tag.content.find_first_not_of("0123456789+- \t\r\n") != std::string_view::npos)
            return fail(tag.at, "A list of indices contains something other than whole numbers.");
        const bool floats = n == "float_array";
        if (floats || among(n, {"Name_array", "IDREF_array", "int_array", "bool_array"})) {
            uint64_t size = 0;
            if (floats && (!read_count(tag, "count", size) || count_words(tag.content) < size))
                return fail(tag.at, "An array has fewer numbers than its count.");
            uint64_t& known =
                arrays_.try_emplace(std::string(attribute(tag, "id").value_or("")), not_floats).first->second;
            if (floats) known = std::min(known, size);
        } else if (n == "accessor") {
            Accessor a;
            a.at = tag.at;
            a.end = text_.find("</accessor", tag.at);
            std::string_view source = attribute(tag, "source").value_or("");
            if (!source.empty() && source.front() == '#') source.remove_prefix(1);
            a.source = source;
            if (!read_count(tag, "count", a.count) || !read_count(tag, "stride", a.stride) ||
                !read_count(tag, "offset", a.offset))
                return fail(tag.at, "An accessor has a count, stride or offset that is not a number.");
            accessors_.push_back(a);
        } else if (n == "param" && !accessors_.empty()) {
            // Effects also have elements of this name.
            if (tag.at < accessors_.back().end) ++accessors_.back().params;
        }
        return true;
    }

    bool fail(std::size_t at, const char* what) {
        const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at), '\n');
        faults_.push_back({FaultId::mesh_unreadable, Severity::error, "line " + std::to_string(line), what,
                           "Export it again as Collada, or as OBJ, STL, PLY or glTF."});
        return false;
    }

    std::string_view text_;
    Faults& faults_;
    std::map<std::string, uint64_t> arrays_; // number of floats
    std::vector<Accessor> accessors_;
};
} // namespace

bool is_collada(std::string_view text) {
    return text.substr(0, 4096).find("<COLLADA") != std::string_view::npos;
}

bool check_collada(std::string_view text, Faults& faults) {
    return ColladaCheck(text, faults).run();
}
} // namespace lr::baker
