#include "baker/mesh/stl_reader.h"

#include <algorithm>
#include <cstring>

namespace lr::baker {
namespace {

// keyword: in lower case.
bool is(std::string_view word, std::string_view keyword) {
    return word.size() == keyword.size() &&
           std::equal(word.begin(), word.end(), keyword.begin(), [](char c, char k) { return (c | 0x20) == k; });
}

std::string rest_of_line(std::string_view& rest) {
    std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(line.size());
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
    return std::string(line);
}
} // namespace

bool is_text_stl(std::string_view bytes) {
    uint32_t faces = 0;
    if (bytes.size() >= 84) std::memcpy(&faces, bytes.data() + 80, 4);
    if (bytes.size() == 84 + 50 * uint64_t{faces} || bytes.find('\0') != std::string_view::npos) return false;
    return is(next_word(bytes), "solid");
}

bool parse_stl(std::string_view text, PolygonSoup& out, Faults& faults) {
    out = {};
    std::string_view rest = text;
    std::vector<uint32_t> corners;
    const auto end_face = [&] {
        if (corners.size() >= 3)
            out.polygons.push_back(corners);
        else
            out.ignored_points += !corners.empty();
        corners.clear();
    };
    const auto end_solid = [&] {
        end_face();
        if (!out.parts.empty() && out.parts.back().first_polygon == out.polygons.size()) out.parts.pop_back();
    };
    for (std::size_t solids = 0;;) {
        const std::string_view word = next_word(rest);
        if (word.empty()) break;
        if (is(word, "solid")) {
            end_solid();
            out.parts.push_back({out.polygons.size(), solids++, {rest_of_line(rest)}, {}, {}});
        } else if (is(word, "endsolid")) {
            rest_of_line(rest);
        } else if (is(word, "facet") || is(word, "endloop")) {
            end_face();
        } else if (is(word, "vertex")) {
            Eigen::Vector3d position;
            for (double& x : position)
                if (!parse_coordinate(next_word(rest), x)) {
                    const auto line =
                        1 + std::count(text.begin(), text.end() - static_cast<std::ptrdiff_t>(rest.size()), '\n');
                    faults.push_back({FaultId::mesh_unreadable, Severity::error, "line " + std::to_string(line),
                                      "A vertex has no three numbers, or the file ends early.",
                                      "Export the file again."});
                    return false;
                }
            corners.push_back(static_cast<uint32_t>(out.vertices.size()));
            out.vertices.push_back(position);
        }
    }
    end_solid();
    return true;
}
} // namespace lr::baker
