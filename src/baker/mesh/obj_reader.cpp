#include "baker/mesh/obj_reader.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>

namespace lr::baker {
// from_chars does not depend on the locale.
bool is_blank(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

std::string_view next_word(std::string_view& rest) {
    std::size_t begin = 0;
    while (begin < rest.size() && is_blank(rest[begin])) ++begin;
    std::size_t end = begin;
    while (end < rest.size() && !is_blank(rest[end])) ++end;
    const std::string_view word = rest.substr(begin, end - begin);
    rest.remove_prefix(end);
    return word;
}

bool parse_coordinate(std::string_view word, double& value) {
    if (!word.empty() && word.front() == '+') word.remove_prefix(1);
    std::string with_point; // some locales write 0,5
    if (word.find(',') != std::string_view::npos) {
        with_point = word;
        std::replace(with_point.begin(), with_point.end(), ',', '.');
        word = with_point;
    }
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error == std::errc::result_out_of_range) {
        value = 0.0; // underflow, or overflow: by the sign of the exponent
        const std::size_t e = word.find_first_of("eE");
        if (e == std::string_view::npos || e + 1 >= word.size() || word[e + 1] != '-') value = HUGE_VAL;
        return true;
    }
    return error == std::errc() && end == word.data() + word.size() && !word.empty();
}

namespace {

bool parse_index(std::string_view word, int64_t& value) {
    word = word.substr(0, word.find('/'));
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size() && !word.empty();
}

class ObjParser {
public:
    ObjParser(PolygonSoup& soup, Faults& faults) : soup_(soup), faults_(faults) {}

    bool parse(std::string_view text) {
        std::string joined;
        while (!text.empty()) {
            ++line_;
            std::string_view line = take_line(text);
            if (!line.empty() && line.back() == '\\') {
                joined.assign(line.substr(0, line.size() - 1));
                while (!text.empty()) {
                    ++line_;
                    line = take_line(text);
                    const bool more = !line.empty() && line.back() == '\\';
                    joined += ' ';
                    joined += more ? line.substr(0, line.size() - 1) : line;
                    if (!more) break;
                }
                line = joined;
            }
            if (!parse_line(line)) return false;
        }
        if (free_form_ && soup_.polygons.empty())
            return fail(FaultId::mesh_unreadable, "The file has free-form curves or surfaces, and no polygons.",
                        "Convert them to a mesh in the modelling program, and export again.");
        return true;
    }

private:
    // Ends of lines: \n, \r\n, or \r alone.
    static std::string_view take_line(std::string_view& text) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(end);
        text.remove_prefix(text.substr(0, 2) == "\r\n" ? 2 : std::min<std::size_t>(text.size(), 1));
        return line;
    }

    bool parse_line(std::string_view line) {
        const std::string_view keyword = next_word(line);
        if (keyword == "v") return parse_vertex(line);
        if (keyword == "f") return parse_face(line);
        if (keyword == "p" || keyword == "l") ++soup_.ignored_points;
        if (keyword == "o" || keyword == "g") begin_part(keyword == "o", line);
        if (keyword == "usemtl") {
            material_ = trimmed(line);
            part_open_ = false;
        }
        if (keyword == "surf" || keyword == "curv") {
            free_form_ = true;
            ++soup_.ignored_points;
        }
        return true;
    }

    static std::string_view trimmed(std::string_view text) {
        while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
        while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
        return text;
    }

    // Groups belong to an object. They are no objects: many exporters write one for every material.
    void begin_part(bool is_object, std::string_view names) {
        names = trimmed(names);
        part_open_ = false;
        group_names_.clear();
        if (is_object) {
            ++object_;
            object_name_ = names;
            return;
        }
        group_names_.emplace_back(names);
        for (std::string_view word = next_word(names); !word.empty(); word = next_word(names))
            if (word != group_names_.front()) group_names_.emplace_back(word);
    }

    bool parse_vertex(std::string_view line) {
        Eigen::Vector3d position;
        for (int axis = 0; axis < 3; ++axis)
            if (!parse_coordinate(next_word(line), position[axis]))
                return fail(FaultId::mesh_unreadable, "A vertex needs three numbers.", "Export the file again.");
        soup_.vertices.push_back(position);
        return true;
    }

    bool parse_face(std::string_view line) {
        std::vector<uint32_t> polygon;
        const auto count = static_cast<int64_t>(soup_.vertices.size());
        for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
            if (word.front() == '#') break;
            int64_t index = 0;
            if (!parse_index(word, index))
                return fail(FaultId::mesh_unreadable, "A face corner is not a number.", "Export the file again.");
            const int64_t zero_based = index > 0 ? index - 1 : count + index;
            if (index == 0 || zero_based < 0 || zero_based > int64_t{UINT32_MAX} - 1)
                return fail(FaultId::mesh_bad_index, "A face refers to vertex " + std::to_string(index) + ".",
                            "Vertex numbers start at 1; export the file again.");
            polygon.push_back(static_cast<uint32_t>(zero_based));
        }
        if (polygon.size() < 3) {
            ++soup_.ignored_points;
            return true;
        }
        if (!part_open_) {
            const std::string group = group_names_.empty() ? std::string() : group_names_.front();
            soup_.parts.push_back({soup_.polygons.size(), object_, {object_name_, group}, group_names_, material_});
        }
        part_open_ = true;
        soup_.polygons.push_back(std::move(polygon));
        return true;
    }

    bool fail(FaultId id, std::string what, std::string remedy) {
        faults_.push_back({id, Severity::error, "line " + std::to_string(line_), std::move(what), std::move(remedy)});
        return false;
    }

    PolygonSoup& soup_;
    Faults& faults_;
    std::size_t line_ = 0;
    bool part_open_ = false, free_form_ = false;
    std::size_t object_ = 0;
    std::string object_name_, material_;
    std::vector<std::string> group_names_;
};

double cross2(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

bool inside_triangle(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                     const Eigen::Vector2d& c) {
    return cross2(b - a, p - a) >= 0.0 && cross2(c - b, p - b) >= 0.0 && cross2(a - c, p - c) >= 0.0;
}

// Corners in the plane of the polygon, counter-clockwise.
std::vector<Eigen::Vector2d> flatten(const PolygonSoup& soup, const std::vector<uint32_t>& polygon) {
    const Eigen::Vector3d origin = soup.vertices[polygon[0]];
    Eigen::Vector3d normal = Eigen::Vector3d::Zero(); // twice the area vector (Newell)
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        normal += (soup.vertices[polygon[i]] - origin).cross(soup.vertices[polygon[i + 1]] - origin);
    if (normal.norm() == 0.0) normal = Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d u = normal.unitOrthogonal();
    const Eigen::Vector3d v = normal.normalized().cross(u);
    std::vector<Eigen::Vector2d> flat;
    for (const uint32_t i : polygon) {
        const Eigen::Vector3d d = soup.vertices[i] - origin;
        flat.emplace_back(d.dot(u), d.dot(v));
    }
    return flat;
}

void clip_ears(const PolygonSoup& soup, const std::vector<uint32_t>& polygon, std::vector<Face>& faces) {
    const std::vector<Eigen::Vector2d> flat = flatten(soup, polygon);
    std::vector<std::size_t> ring(polygon.size());
    for (std::size_t i = 0; i < ring.size(); ++i) ring[i] = i;
    // Whether an edge at corner k enters the ear between these directions, the second clockwise of the first.
    const auto leads_into = [&](std::size_t k, const Eigen::Vector2d& left, const Eigen::Vector2d& right) {
        const std::size_t n = ring.size();
        for (const std::size_t other : {ring[(k + n - 1) % n], ring[(k + 1) % n]}) {
            const Eigen::Vector2d along = flat[other] - flat[ring[k]];
            if (cross2(right, along) > 0.0 && cross2(along, left) > 0.0) return true;
        }
        return false;
    };
    // Shape of the triangle at a corner, 0 if it is no ear.
    const auto quality_of = [&](std::size_t i) {
        const std::size_t n = ring.size(), before = ring[(i + n - 1) % n], after = ring[(i + 1) % n];
        const Eigen::Vector2d &a = flat[before], &b = flat[ring[i]], &c = flat[after];
        const double area = cross2(b - a, c - b);
        if (!(area > 0.0)) return 0.0;
        for (std::size_t k = 0; k < n; ++k) {
            const Eigen::Vector2d& p = flat[ring[k]];
            if (ring[k] == before || k == i || ring[k] == after || !inside_triangle(p, a, b, c)) continue;
            // The cut that joins a hole to the outline passes its ends twice; such an end blocks the ear only if an edge enters it.
            const bool bars = p == a   ? leads_into(k, c - a, b - a)
                              : p == b ? leads_into(k, a - b, c - b)
                              : p == c ? leads_into(k, b - c, a - c)
                                       : true;
            if (bars) return 0.0;
        }
        return area / ((b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm());
    };
    std::vector<double> quality;
    bool known = false;
    while (ring.size() > 3) {
        if (!known) {
            quality.clear();
            for (std::size_t i = 0; i < ring.size(); ++i) quality.push_back(quality_of(i));
        }
        // Cut the ear with the best-shaped triangle: slivers make the added mass less accurate.
        const std::size_t n = ring.size();
        const auto best = std::max_element(quality.begin(), quality.end());
        // A corner that was no ear can have become one, so all are tried again before the polygon counts as crossing itself or collapsed. It then
        // becomes a fan, and the mesh check decides.
        const bool none = !(*best > 0.0);
        if (none && known) {
            known = false;
            continue;
        }
        const std::size_t ear = none ? 1 : static_cast<std::size_t>(best - quality.begin());
        faces.push_back({polygon[ring[(ear + n - 1) % n]], polygon[ring[ear]], polygon[ring[(ear + 1) % n]]});
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
        quality.erase(quality.begin() + static_cast<std::ptrdiff_t>(ear));
        known = true;
        for (const std::size_t i : {(ear + n - 2) % (n - 1), ear % (n - 1)}) quality[i] = quality_of(i);
    }
    faces.push_back({polygon[ring[0]], polygon[ring[1]], polygon[ring[2]]});
}

// Gives both sides of a sheet that is drawn twice the same triangles. Between equally good ears each side could cut another one, and the mesh check
// would not see that one side is the back of the other.
class EarlierPolygons {
public:
    explicit EarlierPolygons(const PolygonSoup& soup) : soup_(&soup) {}

    // Appends the triangles of an earlier polygon with the same corners in either sense. Otherwise false, and remembers this polygon, whose triangles
    // the caller appends next.
    bool copy(const std::vector<uint32_t>& polygon, std::vector<Face>& faces) {
        std::vector<Place> key;
        for (const uint32_t i : polygon) key.push_back(place(i));
        std::sort(key.begin(), key.end());
        const auto [at, is_new] = known_.try_emplace(std::move(key), Known{&polygon, faces.size()});
        if (is_new) return false;
        const std::vector<uint32_t>& other = *at->second.polygon;
        const std::size_t n = polygon.size();
        const auto same = [&](std::size_t i, std::size_t k) { return place(polygon[i % n]) == place(other[k % n]); };
        for (std::size_t first = 0; first < n; ++first)
            for (const std::size_t step : {std::size_t{1}, n - 1}) {
                std::size_t i = 0;
                while (i < n && same(i, first + step * i)) ++i;
                if (i < n) continue;
                const auto own = [&](uint32_t corner) {
                    std::size_t k = 0;
                    while (other[(first + step * k) % n] != corner) ++k;
                    return polygon[k];
                };
                for (std::size_t f = 0; f + 2 < n; ++f) {
                    const Face& face = faces[at->second.first_face + f];
                    Face copied{own(face[0]), own(face[1]), own(face[2])};
                    if (step != 1) std::swap(copied[1], copied[2]);
                    faces.push_back(copied);
                }
                return true;
            }
        return false;
    }

private:
    using Place = std::array<double, 3>;
    struct Known {
        const std::vector<uint32_t>* polygon;
        std::size_t first_face;
    };
    Place place(uint32_t i) const {
        const Eigen::Vector3d& p = soup_->vertices[i];
        return {p.x(), p.y(), p.z()};
    }

    const PolygonSoup* soup_;
    std::map<std::vector<Place>, Known> known_;
};
} // namespace

bool parse_obj(std::string_view text, PolygonSoup& out, Faults& faults) {
    out = {};
    return ObjParser(out, faults).parse(text);
}

bool triangulate(const PolygonSoup& soup, Mesh& out, std::vector<std::size_t>& first_face, Faults& faults) {
    // Ear clipping takes time with the square of the number of corners; larger polygons occur only in broken files.
    constexpr std::size_t max_corners = 20000;
    out.vertices = soup.vertices;
    out.faces.clear();
    first_face.clear();
    EarlierPolygons earlier(soup);
    for (std::size_t i = 0; i < soup.polygons.size(); ++i) {
        while (first_face.size() < soup.parts.size() && soup.parts[first_face.size()].first_polygon <= i)
            first_face.push_back(out.faces.size());
        const std::vector<uint32_t>& polygon = soup.polygons[i];
        const std::string where = "face " + std::to_string(i);
        for (const uint32_t index : polygon) {
            if (index < soup.vertices.size()) continue;
            faults.push_back({FaultId::mesh_bad_index, Severity::error, where,
                              "A face refers to vertex " + std::to_string(index) + " of " +
                                  std::to_string(soup.vertices.size()) + " (counted from 0).",
                              "Export the file again, or delete this face."});
            return false;
        }
        if (polygon.size() < 3 || polygon.size() > max_corners) {
            faults.push_back({FaultId::mesh_degenerate_face, Severity::error, where,
                              "A face has " + std::to_string(polygon.size()) + " corners.",
                              "Triangulate the mesh before export, or delete this face."});
            return false;
        }
        if (polygon.size() == 3)
            out.faces.push_back({polygon[0], polygon[1], polygon[2]});
        else if (!earlier.copy(polygon, out.faces))
            clip_ears(soup, polygon, out.faces);
    }
    first_face.resize(soup.parts.size(), out.faces.size());
    return true;
}
} // namespace lr::baker
