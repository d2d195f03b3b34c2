#include "baker/mesh/mesh_check.h"

#include "baker/mesh/crack_repair.h"
#include "baker/mesh/disjoint_sets.h"
#include "baker/mesh/self_intersection.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lr::baker {
namespace {

// Volume over area^(3/2) below which the volume of a closed surface is rounding error.
constexpr double zero_volume_shape = 1e-9;
// Largest distance of a vertex from an edge that it splits, over the largest extent. Positions in single precision have errors
// up to 1e-7.
constexpr double crack_tolerance = 1e-6;
constexpr std::size_t listed = 5;
constexpr std::size_t most_crossings = 1000; // reported pairs of faces
constexpr std::size_t most_searched = 2'000'000;

struct Edge {
    uint32_t low, high; // vertices
    uint32_t face;
    bool forward; // the face runs from low to high
};

// "3-17, 4-8, ... (120 in all)"
template <typename Name> std::string list(std::size_t count, const Name& name) {
    std::string text;
    for (std::size_t i = 0; i < std::min(count, listed); ++i) text += (i ? ", " : "") + name(i);
    if (count > listed) text += ", ... (" + std::to_string(count) + " in all)";
    return text;
}

class Checker {
public:
    Checker(Mesh& mesh, Faults& faults) : mesh_(mesh), faults_(faults) {}

    bool run() {
        return check_values() && remove_collapsed_and_duplicate_faces() && remove_isolated_vertices() &&
               check_shapes() && join_cracks() && check_edges() && orient() && split_touching_fans() &&
               check_volumes() && name_crossings();
    }

    bool run_layers() { return check_values() && check_shapes(); }

    bool run_sheet() {
        sheet_ = true;
        return check_values() && remove_collapsed_and_duplicate_faces() && remove_isolated_vertices() &&
               check_shapes() && join_cracks() && count_parts() && name_crossings();
    }

private:
    bool error(FaultId id, std::string where, std::string what, std::string remedy) {
        faults_.push_back({id, Severity::error, std::move(where), std::move(what), std::move(remedy)});
        return false;
    }
    void warn(FaultId id, std::string where, std::string what, std::string remedy) {
        faults_.push_back({id, Severity::warning, std::move(where), std::move(what), std::move(remedy)});
    }
    // Numbers of faces, and the place of the first.
    std::string name_faces(const std::vector<uint32_t>& faces) const {
        return "face " + list(faces.size(), [&](std::size_t i) { return std::to_string(faces[i]); }) +
               at_face(faces.front());
    }
    std::string name_edges(const std::vector<Edge>& edges) const {
        return "edge " +
               list(edges.size(),
                    [&](std::size_t i) { return std::to_string(edges[i].low) + "-" + std::to_string(edges[i].high); }) +
               at(0.5 * (mesh_.vertices[edges[0].low] + mesh_.vertices[edges[0].high]));
    }
    std::string at(const Eigen::Vector3d& point) const {
        const std::string place = place_of(mesh_, point, "");
        return place.empty() ? place : " at " + place;
    }
    std::string at_face(std::size_t i) const {
        const Face& f = mesh_.faces[i];
        if (std::max({f[0], f[1], f[2]}) >= mesh_.vertices.size()) return {};
        return at((corner(f, 0) + corner(f, 1) + corner(f, 2)) / 3.0);
    }
    const Eigen::Vector3d& corner(const Face& face, std::size_t i) const { return mesh_.vertices[face[i]]; }

    bool check_values() {
        if (mesh_.faces.empty() || mesh_.vertices.empty())
            return error(FaultId::mesh_empty, "mesh", "The mesh has no faces.", "Export the surface as triangles.");
        std::vector<uint32_t> bad;
        for (std::size_t i = 0; i < mesh_.vertices.size(); ++i)
            if (!mesh_.vertices[i].allFinite()) bad.push_back(static_cast<uint32_t>(i));
        if (!bad.empty())
            return error(FaultId::mesh_not_finite,
                         "vertex " + list(bad.size(), [&](std::size_t i) { return std::to_string(bad[i]); }),
                         "A vertex position is not a finite number.", "Correct or delete these vertices.");
        for (std::size_t i = 0; i < mesh_.faces.size(); ++i)
            for (const uint32_t index : mesh_.faces[i])
                if (index >= mesh_.vertices.size()) bad.push_back(static_cast<uint32_t>(i));
        bad.erase(std::unique(bad.begin(), bad.end()), bad.end());
        if (!bad.empty())
            return error(FaultId::mesh_bad_index, name_faces(bad), "A face refers to a vertex that does not exist.",
                         "Export the file again, or delete these faces.");
        return true;
    }

    // Faces with a repeated corner have no area, and removing them makes their neighbours adjacent. A second copy of a face is removed too. A face
    // and its reverse are a sheet without thickness, drawn from both sides.
    bool remove_collapsed_and_duplicate_faces() {
        std::vector<uint32_t> collapsed, duplicate, reversed;
        std::vector<std::pair<Face, uint32_t>> order; // corners turned so that the smallest is first
        for (std::size_t i = 0; i < mesh_.faces.size(); ++i) {
            Face face = mesh_.faces[i];
            if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) {
                collapsed.push_back(static_cast<uint32_t>(i));
                continue;
            }
            std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
            order.emplace_back(face, static_cast<uint32_t>(i));
        }
        const auto sorted = [](const Face& face) { // same key for a face and its reverse
            return Face{face[0], std::min(face[1], face[2]), std::max(face[1], face[2])};
        };
        std::sort(order.begin(), order.end(), [&](const auto& a, const auto& b) {
            const Face p = sorted(a.first), q = sorted(b.first);
            return p != q ? p < q : a.second < b.second;
        });
        std::vector<char> drop(mesh_.faces.size(), 0);
        for (std::size_t i = 1, head = 0; i < order.size(); ++i) {
            if (sorted(order[i].first) != sorted(order[head].first)) {
                head = i;
                continue;
            }
            (order[i].first == order[head].first ? duplicate : reversed).push_back(order[i].second);
            drop[order[i].second] = 1;
        }
        std::sort(duplicate.begin(), duplicate.end());
        std::sort(reversed.begin(), reversed.end());
        if (!reversed.empty() && !sheet_)
            return error(FaultId::mesh_duplicate_face, name_faces(reversed),
                         "A face coincides with the back of another face: a sheet without thickness.",
                         "Bake it with --sheet, or give it a thickness (solidify).");
        if (!reversed.empty())
            warn(FaultId::mesh_duplicate_face, name_faces(reversed),
                 "Faces that coincide with the back of another face were removed.",
                 "None needed: a sheet has both sides anyway.");
        if (!duplicate.empty())
            warn(FaultId::mesh_duplicate_face, name_faces(duplicate), "Second copies of a face were removed.",
                 "Remove doubled faces before export to silence this.");
        if (!collapsed.empty())
            warn(FaultId::mesh_degenerate_face, name_faces(collapsed), "Faces that use one vertex twice were removed.",
                 "Dissolve them before export to silence this.");
        for (const uint32_t i : collapsed) drop[i] = 1;
        std::size_t kept = 0;
        for (std::size_t i = 0; i < mesh_.faces.size(); ++i)
            if (!drop[i]) mesh_.faces[kept++] = mesh_.faces[i];
        mesh_.faces.resize(kept);
        if (kept == 0) return error(FaultId::mesh_empty, "mesh", "All faces have zero area.", "Export the mesh again.");
        return true;
    }

    bool remove_isolated_vertices() {
        std::vector<uint32_t> renumbered(mesh_.vertices.size(), 0);
        for (const Face& face : mesh_.faces)
            for (const uint32_t index : face) renumbered[index] = 1;
        std::vector<uint32_t> isolated;
        std::vector<Eigen::Vector3d> kept;
        for (std::size_t i = 0; i < mesh_.vertices.size(); ++i) {
            const bool used = renumbered[i] != 0;
            renumbered[i] = static_cast<uint32_t>(kept.size());
            if (used)
                kept.push_back(mesh_.vertices[i]);
            else
                isolated.push_back(static_cast<uint32_t>(i));
        }
        if (isolated.empty()) return true;
        warn(FaultId::mesh_isolated_vertex,
             "vertex " + list(isolated.size(), [&](std::size_t i) { return std::to_string(isolated[i]); }),
             "Vertices that no face uses were removed.", "Delete loose vertices before export to silence this.");
        mesh_.vertices = std::move(kept);
        for (Face& face : mesh_.faces)
            for (uint32_t& index : face) index = renumbered[index];
        return true;
    }

    bool check_shapes() {
        std::vector<uint32_t> bad;
        for (std::size_t i = 0; i < mesh_.faces.size(); ++i) {
            if (!(face_shape(mesh_, mesh_.faces[i]) > degenerate_shape)) bad.push_back(static_cast<uint32_t>(i));
        }
        if (bad.empty()) return true;
        return error(FaultId::mesh_degenerate_face, name_faces(bad), "A face has no area: its corners are on one line.",
                     "Dissolve degenerate faces (merge by distance), then export again.");
    }

    bool join_cracks() {
        const std::size_t joined = close_cracks(mesh_, crack_tolerance);
        if (joined > 0)
            warn(FaultId::mesh_merged_vertices, "mesh",
                 std::to_string(joined) + " vertices on a boundary edge of another face were joined with it.",
                 "None needed; remove T-junctions before export to silence this.");
        return joined == 0 || remove_collapsed_and_duplicate_faces(); // parts of split faces can coincide
    }

    void collect_edges() {
        edges_.clear();
        for (std::size_t i = 0; i < mesh_.faces.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const uint32_t a = mesh_.faces[i][k], b = mesh_.faces[i][(k + 1) % 3];
                edges_.push_back({std::min(a, b), std::max(a, b), static_cast<uint32_t>(i), a < b});
            }
        std::sort(edges_.begin(), edges_.end(), [](const Edge& a, const Edge& b) {
            if (a.low != b.low) return a.low < b.low;
            return a.high != b.high ? a.high < b.high : a.face < b.face;
        });
    }

    bool check_edges() {
        collect_edges();
        std::vector<Edge> open, crowded;
        for (std::size_t i = 0; i < edges_.size();) {
            std::size_t end = i + 1;
            while (end < edges_.size() && edges_[end].low == edges_[i].low && edges_[end].high == edges_[i].high) ++end;
            if (end - i == 1) open.push_back(edges_[i]);
            if (end - i > 2) crowded.push_back(edges_[i]);
            i = end;
        }
        bool good = true;
        if (!crowded.empty())
            good = error(FaultId::mesh_non_manifold_edge, name_edges(crowded), "More than two faces meet at an edge.",
                         "Remove inner faces, or separate the parts that touch along this edge.");
        if (!open.empty())
            good = error(FaultId::mesh_open_edge, name_edges(open), "The surface has a boundary edge.",
                         "Close the hole; bake a sheet with --sheet, or give it a thickness (solidify).");
        return good;
    }

    // Visits each component from its first face. edges_ has each edge exactly twice here.
    bool orient() {
        const std::size_t n = mesh_.faces.size();
        std::vector<std::array<std::pair<uint32_t, bool>, 3>> neighbours(n); // face, runs the same way
        std::vector<std::size_t> filled(n, 0);
        for (std::size_t i = 0; i + 1 < edges_.size(); i += 2) {
            const Edge &a = edges_[i], &b = edges_[i + 1];
            const bool same = a.forward == b.forward;
            neighbours[a.face][filled[a.face]++] = {b.face, same};
            neighbours[b.face][filled[b.face]++] = {a.face, same};
        }
        component_.assign(n, UINT32_MAX);
        component_count_ = 0;
        std::vector<char> flip(n, 0);
        std::vector<uint32_t> flipped, inside_out, stack, members;
        for (std::size_t seed = 0; seed < n; ++seed) {
            if (component_[seed] != UINT32_MAX) continue;
            stack.assign(1, static_cast<uint32_t>(seed));
            members.assign(1, static_cast<uint32_t>(seed));
            component_[seed] = component_count_;
            while (!stack.empty()) {
                const uint32_t face = stack.back();
                stack.pop_back();
                for (const auto& [other, same] : neighbours[face]) {
                    const char wanted = same ? !flip[face] : flip[face];
                    if (component_[other] == UINT32_MAX) {
                        component_[other] = component_count_;
                        flip[other] = wanted;
                        members.push_back(other);
                        stack.push_back(other);
                    } else if (flip[other] != wanted) {
                        return error(FaultId::mesh_inconsistent_winding, name_faces({face, other}),
                                     "The surface has no inside (like a Klein bottle).",
                                     "Rebuild the surface around these faces.");
                    }
                }
            }
            settle_component(members, flip, flipped, inside_out);
            ++component_count_;
        }
        for (std::size_t i = 0; i < n; ++i)
            if (flip[i]) std::swap(mesh_.faces[i][1], mesh_.faces[i][2]);
        std::sort(flipped.begin(), flipped.end());
        if (!flipped.empty())
            warn(FaultId::mesh_inconsistent_winding, name_faces(flipped),
                 "Faces wound against their neighbours were flipped.", "Make normals consistent before export.");
        if (!inside_out.empty())
            warn(FaultId::mesh_inside_out, name_faces(inside_out), "The surface was inside out and was flipped.",
                 "Recalculate normals outside before export.");
        return true;
    }

    // Winds one component so that its volume is positive, and lists the change for the warning.
    void settle_component(const std::vector<uint32_t>& members, std::vector<char>& flip, std::vector<uint32_t>& flipped,
                          std::vector<uint32_t>& inside_out) const {
        double volume = 0.0;
        std::size_t turned = 0;
        const Eigen::Vector3d origin = corner(mesh_.faces[members[0]], 0);
        for (const uint32_t i : members) {
            const Face& face = mesh_.faces[i];
            const double six_volume =
                (corner(face, 0) - origin).dot((corner(face, 1) - origin).cross(corner(face, 2) - origin));
            volume += flip[i] ? -six_volume : six_volume;
            if (flip[i]) ++turned;
        }
        if (volume < 0.0) {
            for (const uint32_t i : members) flip[i] = !flip[i];
            turned = members.size() - turned;
        }
        if (turned == members.size()) {
            inside_out.push_back(members[0]);
        } else if (turned > 0) {
            for (const uint32_t i : members)
                if (flip[i]) flipped.push_back(i);
        }
    }

    // Where two parts of the surface touch in a vertex the potential has two values, so each part gets its own vertex.
    bool split_touching_fans() {
        const std::size_t old_count = mesh_.vertices.size();
        std::vector<uint32_t> start(old_count + 1, 0), incident(3 * mesh_.faces.size());
        for (const Face& face : mesh_.faces)
            for (const uint32_t index : face) ++start[index + 1];
        for (std::size_t i = 0; i < old_count; ++i) start[i + 1] += start[i];
        std::vector<uint32_t> next(start.begin(), start.end() - 1);
        for (std::size_t i = 0; i < mesh_.faces.size(); ++i)
            for (const uint32_t index : mesh_.faces[i]) incident[next[index]++] = static_cast<uint32_t>(i);
        std::vector<uint32_t> split;
        for (uint32_t vertex = 0; vertex < old_count; ++vertex) {
            std::vector<uint32_t> left(incident.begin() + start[vertex], incident.begin() + start[vertex + 1]);
            for (bool first = true; !left.empty(); first = false) {
                const uint32_t name = first ? vertex : static_cast<uint32_t>(mesh_.vertices.size());
                if (!first) {
                    mesh_.vertices.push_back(Eigen::Vector3d(mesh_.vertices[vertex]));
                    split.push_back(vertex);
                }
                take_fan(vertex, name, left);
            }
        }
        split.erase(std::unique(split.begin(), split.end()), split.end());
        if (!split.empty())
            warn(FaultId::mesh_non_manifold_edge,
                 "vertex " + list(split.size(), [&](std::size_t i) { return std::to_string(split[i]); }),
                 "Parts of the surface that touch in one vertex were separated there.",
                 "Separate them, or join them properly, before export.");
        return true;
    }

    // Moves the fan of faces around `vertex` that contains left[0] from `left` to the vertex `name`.
    void take_fan(uint32_t vertex, uint32_t name, std::vector<uint32_t>& left) {
        std::vector<uint32_t> fan{left[0]};
        left.erase(left.begin());
        for (std::size_t k = 0; k < fan.size(); ++k) {
            const Face here = mesh_.faces[fan[k]];
            for (std::size_t i = 0; i < left.size();) {
                const Face& other = mesh_.faces[left[i]];
                std::size_t shared = 0;
                for (const uint32_t a : here)
                    for (const uint32_t b : other) shared += a == b && a != vertex && a != name;
                if (shared == 0) {
                    ++i;
                    continue;
                }
                fan.push_back(left[i]);
                left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
            }
        }
        for (const uint32_t i : fan)
            for (uint32_t& index : mesh_.faces[i])
                if (index == vertex) index = name;
    }

    bool count_parts() {
        DisjointSets sets(mesh_.vertices.size());
        for (const Face& face : mesh_.faces)
            for (const uint32_t index : face) sets.join(face[0], index);
        std::vector<uint32_t> first;
        std::vector<char> seen(mesh_.vertices.size(), 0);
        for (std::size_t i = 0; i < mesh_.faces.size(); ++i) {
            char& known = seen[sets.find(mesh_.faces[i][0])];
            if (known == 0) first.push_back(static_cast<uint32_t>(i));
            known = 1;
        }
        if (first.size() > 1)
            warn(FaultId::mesh_several_components, name_faces(first),
                 "The sheet has " + std::to_string(first.size()) + " separate parts, baked as one rigid body.",
                 "Merge vertices by distance if parts belong together; bake separate bodies one by one.");
        return true;
    }

    bool check_volumes() {
        std::vector<double> volume(component_count_, 0.0), area(component_count_, 0.0);
        std::vector<uint32_t> first(component_count_, UINT32_MAX);
        for (std::size_t i = 0; i < mesh_.faces.size(); ++i) {
            const Face& face = mesh_.faces[i];
            const uint32_t c = component_[i];
            if (first[c] == UINT32_MAX) first[c] = static_cast<uint32_t>(i);
            const Eigen::Vector3d& origin = corner(mesh_.faces[first[c]], 0);
            const Eigen::Vector3d a = corner(face, 0) - origin, b = corner(face, 1) - origin,
                                  d = corner(face, 2) - origin;
            volume[c] += a.dot(b.cross(d)) / 6.0;
            area[c] += 0.5 * (b - a).cross(d - a).norm();
        }
        std::vector<uint32_t> flat;
        for (uint32_t c = 0; c < component_count_; ++c)
            if (!(volume[c] > zero_volume_shape * std::pow(area[c], 1.5))) flat.push_back(first[c]);
        if (!flat.empty())
            return error(FaultId::mesh_zero_volume, name_faces(flat),
                         "The part of the surface that contains this face encloses no volume.",
                         "Bake a sheet with --sheet, or give it a thickness (solidify).");
        if (component_count_ == 1) return true;
        warn(FaultId::mesh_several_components, name_faces(first),
             "The mesh has " + std::to_string(component_count_) + " separate parts, baked as one rigid body.",
             "Join parts that belong together (boolean union); bake separate bodies one by one.");
        return check_nesting(first);
    }

    bool name_crossings() {
        if (mesh_.faces.size() > most_searched) return true; // far above the baker's limit, which is reported later
        const SelfIntersections found = find_self_intersections(mesh_, most_crossings);
        const auto& pairs = found.pairs;
        if (pairs.empty()) return true;
        std::string where = "face " + list(pairs.size(), [&](std::size_t i) {
                                return std::to_string(pairs[i].first) + " and " + std::to_string(pairs[i].second);
                            });
        if (!found.complete) where += " at least";
        where += at_face(pairs.front().first);
        // An error: overlapping solids gave errors of tens of percent in mass and added mass.
        if (!sheet_ && std::any_of(pairs.begin(), pairs.end(),
                                   [&](const auto& pair) { return component_[pair.first] != component_[pair.second]; }))
            return error(FaultId::mesh_several_components, std::move(where), "Parts cross or touch each other.",
                         "Unite the parts (boolean union), or pull them apart.");
        warn(FaultId::mesh_self_intersection, std::move(where), "Faces cross, touch or cover each other.",
             sheet_
                 ? "None needed: a little fluid slips through there. Let them share vertices to close the gap."
                 : "Unite the parts (boolean union) or remesh: volume covered twice counts once, but the added mass is "
                   "uncertain.");
        return true;
    }

    // Winding number of faces around a point, by signed solid angles (van Oosterom and Strackee 1983).
    double winding_number(const std::vector<uint32_t>& faces, const Eigen::Vector3d& point) const {
        double sum = 0.0;
        for (const uint32_t i : faces) {
            const Eigen::Vector3d a = corner(mesh_.faces[i], 0) - point, b = corner(mesh_.faces[i], 1) - point,
                                  c = corner(mesh_.faces[i], 2) - point;
            const double na = a.norm(), nb = b.norm(), nc = c.norm();
            sum += 2.0 * std::atan2(a.dot(b.cross(c)), na * nb * nc + a.dot(b) * nc + b.dot(c) * na + c.dot(a) * nb);
        }
        return sum / (4.0 * std::numbers::pi);
    }

    // A part inside another is a cavity or a mistake; the common volume of overlapping parts would count twice.
    bool check_nesting(const std::vector<uint32_t>& first) {
        constexpr uint32_t max_components = 5000; // limits the quadratic cost of this diagnosis
        if (component_count_ > max_components) return true;
        std::vector<Eigen::AlignedBox3d> box(component_count_);
        std::vector<std::vector<uint32_t>> faces(component_count_);
        for (uint32_t i = 0; i < mesh_.faces.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) box[component_[i]].extend(corner(mesh_.faces[i], k));
            faces[component_[i]].push_back(i);
        }
        for (uint32_t inner = 0; inner < component_count_; ++inner)
            for (uint32_t outer = 0; outer < component_count_; ++outer) {
                if (inner == outer) continue;
                const Face& face = mesh_.faces[first[inner]];
                const Eigen::Vector3d centre = (corner(face, 0) + corner(face, 1) + corner(face, 2)) / 3.0;
                if (!box[outer].contains(centre) || std::abs(winding_number(faces[outer], centre)) < 0.75) continue;
                return error(FaultId::mesh_several_components, name_faces({first[inner], first[outer]}),
                             "A part is inside another part or crosses it.",
                             "Delete the inner part, or unite the parts (boolean union).");
            }
        return true;
    }

    Mesh& mesh_;
    Faults& faults_;
    bool sheet_ = false;
    std::vector<Edge> edges_;
    std::vector<uint32_t> component_; // of each face
    uint32_t component_count_ = 0;
};
} // namespace

double face_shape(const Mesh& mesh, const Face& face) {
    const Eigen::Vector3d& corner = mesh.vertices[face[0]];
    const Eigen::Vector3d a = mesh.vertices[face[1]] - corner, b = mesh.vertices[face[2]] - corner;
    const double side = std::sqrt(std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()}));
    return side > 0.0 ? (a / side).cross(b / side).norm() : 0.0;
}

bool check_and_repair(Mesh& mesh, Faults& faults) {
    return Checker(mesh, faults).run();
}

bool check_sheet(Mesh& mesh, Faults& faults) {
    return Checker(mesh, faults).run_sheet();
}

bool check_layers(Mesh& mesh, Faults& faults) {
    return Checker(mesh, faults).run_layers();
}
} // namespace lr::baker
