#include "baker/mesh/off_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace lr::baker {
namespace {

class OffParser {
public:
    OffParser(std::string_view text, PolygonSoup& soup, Faults& faults) : rest_(text), soup_(soup), faults_(faults) {}

    bool parse() {
        uint64_t vertices = 0, faces = 0, edges = 0;
        if (!parse_header() || !read_count(vertices) || !read_count(faces)) return false;
        // Some programs omit the number of edges, which no reader needs.
        if (words_left_in_line()) read_count(edges);
        end_line();
        for (uint64_t i = 0; i < vertices; ++i)
            if (!parse_vertex(i)) return false;
        for (uint64_t i = 0; i < faces; ++i)
            if (!parse_face(i)) return false;
        if (!soup_.polygons.empty()) soup_.parts.emplace_back();
        return true;
    }

private:
    static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

    // Skips blanks, and with `lines` also line ends and comments.
    void skip(bool lines) {
        while (!rest_.empty()) {
            if (is_blank(rest_[0])) {
                rest_.remove_prefix(1);
            } else if (lines && rest_[0] == '\n') {
                ++line_;
                rest_.remove_prefix(1);
            } else if (lines && rest_[0] == '#') {
                rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
            } else {
                return;
            }
        }
    }

    std::string_view next_word() {
        skip(true);
        std::size_t end = 0;
        while (end < rest_.size() && !is_blank(rest_[end]) && rest_[end] != '\n' && rest_[end] != '#') ++end;
        const std::string_view word = rest_.substr(0, end);
        rest_.remove_prefix(end);
        return word;
    }

    bool words_left_in_line() {
        skip(false);
        return !rest_.empty() && rest_[0] != '\n' && rest_[0] != '#';
    }

    // Skips colours, normals and texture coordinates after positions and corners.
    void end_line() { rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size())); }

    bool fail(FaultId id, std::string what, std::string remedy = "Export the file again.") {
        faults_.push_back({id, Severity::error, "line " + std::to_string(line_), std::move(what), std::move(remedy)});
        return false;
    }

    // The keyword may be missing; the file then begins with its counts.
    bool parse_header() {
        skip(true);
        if (!rest_.empty() && rest_[0] >= '0' && rest_[0] <= '9' && rest_.substr(0, 4) != "4OFF") return true;
        std::string_view word = next_word();
        for (const std::string_view prefix : {"ST", "C", "N"})
            if (word.substr(0, prefix.size()) == prefix) word.remove_prefix(prefix.size());
        if (word == "4OFF" || word == "nOFF" || word == "4nOFF")
            return fail(FaultId::mesh_unreadable, "The file has points of four or more dimensions.",
                        "Export the surface in three dimensions.");
        if (word != "OFF") return fail(FaultId::mesh_unreadable, "This is not an OFF file: the word OFF is missing.");
        if (!words_left_in_line()) return true;
        if (rest_.substr(0, 6) == "BINARY")
            return fail(FaultId::mesh_unreadable, "This is a binary OFF file.", "Save it as text, or as PLY or STL.");
        return true;
    }

    template <class Number> bool read_number(Number& value) {
        std::string_view word = next_word();
        if (!word.empty() && word.front() == '+') word.remove_prefix(1);
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        return error == std::errc() && end == word.data() + word.size() && !word.empty();
    }

    bool read_count(uint64_t& value) {
        return read_number(value) ||
               fail(FaultId::mesh_unreadable, "The numbers of vertices and faces are missing or not whole numbers.");
    }

    bool parse_vertex(uint64_t number) {
        Eigen::Vector3d position;
        for (int axis = 0; axis < 3; ++axis)
            if (!read_number(position[axis]))
                return fail(FaultId::mesh_unreadable,
                            "Vertex " + std::to_string(number) + " has no three numbers, or the file ends early.");
        end_line();
        soup_.vertices.push_back(position);
        return true;
    }

    bool parse_face(uint64_t number) {
        const auto damaged = [&] {
            return fail(FaultId::mesh_unreadable,
                        "Face " + std::to_string(number) + " is incomplete, or the file ends early.");
        };
        uint64_t corners = 0;
        if (!read_number(corners) || corners > 1'000'000) return damaged();
        std::vector<uint32_t> polygon;
        for (uint64_t k = 0; k < corners; ++k) {
            uint32_t index = 0;
            if (!read_number(index)) return damaged();
            if (index >= soup_.vertices.size())
                return fail(FaultId::mesh_bad_index,
                            "A face refers to vertex " + std::to_string(index) + " of " +
                                std::to_string(soup_.vertices.size()) + " (counted from 0).",
                            "Export the file again, or delete this face.");
            polygon.push_back(index);
        }
        end_line();
        if (corners < 3)
            ++soup_.ignored_points;
        else
            soup_.polygons.push_back(std::move(polygon));
        return true;
    }

    std::string_view rest_;
    PolygonSoup& soup_;
    Faults& faults_;
    std::size_t line_ = 1;
};
} // namespace

bool parse_off(std::string_view text, PolygonSoup& out, Faults& faults) {
    out = {};
    return OffParser(text, out, faults).parse();
}
} // namespace lr::baker
