#include "baker/mesh/body_parts.h"

#include "baker/fault_text.h"
#include "baker/mesh/crack_repair.h"
#include "baker/mesh/disjoint_sets.h"
#include "baker/mesh/half_edges.h"
#include "baker/mesh/mass_properties.h"
#include "baker/mesh/mesh_check.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace lr::baker {
namespace {

// Distance over the largest extent below which vertices are joined: seams of files with few digits.
constexpr double weld = 1e-5;
constexpr double crack = 1e-6;
// Share of a part's area up to which its holes are closed: a seam that does not meet, a missing cap of a stem.
constexpr double small_holes = 0.01;
constexpr double missing_faces = 0.05; // the same, if each hole has the corners of a triangle or quad
constexpr double any_holes = 0.75; // the same, for OpenParts::filled: half a ball has 0.5, a curved leaf 0.9 and more
constexpr double no_volume = 1e-6; // over area^(3/2)

std::array<uint32_t, 3> sorted(Face f) {
    std::sort(f.begin(), f.end());
    return f;
}

class Parts {
public:
    Parts(Mesh& mesh, Faults& faults, OpenParts open) : mesh_(mesh), faults_(faults), open_(open) {}

    bool run(BodyParts& out) {
        clean_up();
        if (mesh_.faces.empty()) {
            faults_.push_back(
                {FaultId::mesh_empty, Severity::error, "mesh",
                 "No face has an area: all " + std::to_string(without_area_.number) + " are points or lines.",
                 "Check the object's scale, and export again."});
            return false;
        }
        std::vector<Face> sheets;
        if (open_ == OpenParts::all_sheets)
            sheets = mesh_.faces;
        else
            for (const std::vector<uint32_t>& part : connected()) classify(part, sheets);
        out.mesh = mesh_;
        out.mesh.faces.clear();
        find_cavities(out.cavities);
        for (const Solid& solid : solids_) {
            out.mesh.faces.insert(out.mesh.faces.end(), solid.faces.begin(), solid.faces.end());
            turned_ += solid.turned;
        }
        out.solid_faces = out.mesh.faces.size();
        out.mesh.faces.insert(out.mesh.faces.end(), sheets.begin(), sheets.end());
        report();
        return true;
    }

private:
    struct Solid {
        std::vector<Face> faces; // wound outward
        bool inward = false;     // in the file
        std::size_t turned = 0;
    };
    // How often a repair was made, and where first.
    struct Count {
        std::size_t number = 0;
        Eigen::Vector3d first = Eigen::Vector3d::Zero();
        void add(const Eigen::Vector3d& where, std::size_t more = 1) {
            if (number == 0) first = where;
            number += more;
        }
    };

    const Eigen::Vector3d& at(uint32_t v) const { return mesh_.vertices[v]; }
    Eigen::Vector3d twice_area(const Face& f) const { return (at(f[1]) - at(f[0])).cross(at(f[2]) - at(f[0])); }
    double area(const Face& f) const { return 0.5 * twice_area(f).norm(); }

    Eigen::Vector3d middle(const Face& f) const { return (at(f[0]) + at(f[1]) + at(f[2])) / 3.0; }

    bool is_flat(const Face& f) const { return !(face_shape(mesh_, f) > degenerate_shape); }

    void drop_flat(bool counted = true) {
        std::size_t kept = 0;
        for (const Face& f : mesh_.faces)
            if (!is_flat(f))
                mesh_.faces[kept++] = f;
            else if (counted)
                without_area_.add(middle(f));
        mesh_.faces.resize(kept);
    }

    void clean_up() {
        drop_flat();
        joined_ = join_near_vertices(mesh_, weld);
        if (joined_ > 0) drop_flat();
        // Vertices inside an edge: T-junctions, also where a face without area was dropped.
        joined_ += close_cracks(mesh_, crack);
        drop_flat(false);
        find_copies();
    }

    // Keeps one face of each set of corners. Where as many face one way as the other, it is a wall between two solids or a sheet drawn from both
    // sides, marked in `wall_`.
    void find_copies() {
        std::map<std::array<uint32_t, 3>, std::pair<std::size_t, int>> seen; // place among the kept, balance
        std::vector<Face> kept;
        for (const Face& f : mesh_.faces) {
            const auto key = sorted(f);
            const bool even = (f[0] < f[1]) + (f[1] < f[2]) + (f[2] < f[0]) == 2;
            const auto [place, first] = seen.try_emplace(key, kept.size(), 0);
            place->second.second += even ? 1 : -1;
            if (first)
                kept.push_back(f);
            else
                copies_.add(middle(f));
        }
        mesh_.faces = std::move(kept);
        wall_.assign(mesh_.faces.size(), 0);
        for (const auto& [key, entry] : seen) wall_[entry.first] = entry.second == 0;
    }

    std::vector<std::vector<uint32_t>> connected() {
        const std::vector<HalfEdge> halves = sorted_half_edges(mesh_);
        DisjointSets sets(mesh_.faces.size());
        for (std::size_t i = 1; i < halves.size(); ++i)
            if (same_edge(halves[i - 1], halves[i])) sets.join(halves[i - 1].face, halves[i].face);
        std::vector<std::size_t> number(mesh_.faces.size());
        std::vector<std::vector<uint32_t>> parts;
        for (uint32_t i = 0; i < mesh_.faces.size(); ++i) {
            const std::size_t root = sets.find(i);
            if (root == i) {
                number[i] = parts.size();
                parts.emplace_back();
            }
            parts[number[root]].push_back(i);
        }
        return parts;
    }

    double area_of(const std::vector<Face>& faces) const {
        double sum = 0.0;
        for (const Face& f : faces) sum += area(f);
        return sum;
    }

    // Looks for a closed surface in a part, once with its walls and once without. The larger one is its solid.
    void classify(const std::vector<uint32_t>& part, std::vector<Face>& sheets) {
        std::vector<Face> all, bare, walls;
        for (const uint32_t i : part) {
            all.push_back(mesh_.faces[i]);
            (wall_[i] ? walls : bare).push_back(mesh_.faces[i]);
        }
        std::vector<Face> flaps;
        Solid closed = close(all, flaps);
        if (!walls.empty() && !bare.empty()) {
            std::vector<Face> other_flaps;
            Solid other = close(bare, other_flaps);
            if (area_of(other.faces) > area_of(closed.faces)) {
                closed = std::move(other);
                flaps = std::move(other_flaps);
                const SolidRegion region(mesh_, closed.faces);
                for (const Face& f : walls)
                    if (!region.contains(middle(f))) flaps.push_back(f);
            }
        }
        if (!flaps.empty()) sheet_parts_.add(middle(flaps.front()));
        if (!closed.faces.empty()) solids_.push_back(std::move(closed));
        sheets.insert(sheets.end(), flaps.begin(), flaps.end());
    }

    // A solid wound opposite to the one around it, as the walls of a hollow are.
    void find_cavities(Mesh& out) {
        constexpr std::size_t samples = 64;
        Mesh as_wound{mesh_.vertices, {}, {}}; // as in the file, where all faces may be inside out
        for (const Solid& s : solids_)
            for (const Face& f : s.faces) as_wound.faces.push_back(s.inward ? Face{f[0], f[2], f[1]} : f);
        const double sum = as_wound.faces.empty() ? 0.0 : compute_mass_properties(as_wound).volume;
        std::vector<Face> outer;
        for (Solid& s : solids_) {
            s.inward = s.inward == (sum >= 0.0);
            if (!s.inward) outer.insert(outer.end(), s.faces.begin(), s.faces.end());
        }
        std::vector<Solid> kept;
        const SolidRegion region(mesh_, outer);
        for (Solid& s : solids_) {
            bool enclosed = s.inward;
            for (std::size_t i = 0; enclosed && i < s.faces.size(); i += 1 + s.faces.size() / samples)
                enclosed = region.contains(middle(s.faces[i]));
            if (!enclosed) {
                kept.push_back(std::move(s));
                continue;
            }
            cavities_.add(middle(s.faces[0]));
            turned_ += s.faces.size() - s.turned;
            for (const Face& f : s.faces) out.faces.push_back({f[0], f[2], f[1]});
        }
        solids_ = std::move(kept);
        if (out.faces.empty()) return;
        out.vertices = mesh_.vertices;
        drop_unused_vertices(out);
    }

    static std::vector<HalfEdge> half_edges(const std::vector<Face>& faces) {
        Mesh part;
        part.faces = faces;
        return sorted_half_edges(part);
    }

    // Returns the faces of a closed surface, wound outward, and appends the others to `flaps`.
    Solid close(std::vector<Face> faces, std::vector<Face>& flaps) {
        const std::vector<Face> before = faces;
        const Count filled = fill_small_holes(faces);
        Solid whole;
        if (filled.number > 0) {
            std::vector<Face> rest;
            whole.faces = peel(faces, rest);
            if (rest.empty() && wind(whole)) {
                filled_.add(filled.first, filled.number);
                return whole;
            }
            faces = before;
        }
        std::vector<Face> rest;
        whole.faces = peel(std::move(faces), rest);
        if (whole.faces.empty() || !wind(whole)) {
            flaps.insert(flaps.end(), before.begin(), before.end());
            return {};
        }
        flaps.insert(flaps.end(), rest.begin(), rest.end());
        return whole;
    }

    // Removes patches with a free edge until none is left. A patch is connected across edges of two faces.
    std::vector<Face> peel(std::vector<Face> faces, std::vector<Face>& rest) const {
        while (!faces.empty()) {
            const std::vector<HalfEdge> halves = half_edges(faces);
            DisjointSets sets(faces.size());
            std::vector<uint32_t> free;
            for (std::size_t i = 0, end = 0; i < halves.size(); i = end) {
                while (end < halves.size() && same_edge(halves[i], halves[end])) ++end;
                if (end - i == 1) free.push_back(halves[i].face);
                if (end - i == 2) sets.join(halves[i].face, halves[i + 1].face);
            }
            if (free.empty()) break;
            std::vector<char> off(faces.size(), 0);
            for (const uint32_t f : free) off[sets.find(f)] = 1;
            std::vector<Face> kept;
            for (std::size_t i = 0; i < faces.size(); ++i) (off[sets.find(i)] ? rest : kept).push_back(faces[i]);
            faces = std::move(kept);
        }
        return faces;
    }

    // Closes each loop of free edges by a fan, if the loops of the part are small.
    Count fill_small_holes(std::vector<Face>& faces) {
        Count filled;
        std::map<uint32_t, std::vector<uint32_t>> next;
        std::set<std::pair<uint32_t, uint32_t>> backward; // the direction of a cap along a face
        const std::vector<HalfEdge> halves = half_edges(faces);
        for (std::size_t i = 0, end = 0; i < halves.size(); i = end) {
            while (end < halves.size() && same_edge(halves[i], halves[end])) ++end;
            if (end - i != 1) continue;
            next[halves[i].low].push_back(halves[i].high);
            next[halves[i].high].push_back(halves[i].low);
            const Face& f = faces[halves[i].face];
            backward.emplace(f[(halves[i].side + 1) % 3], f[halves[i].side]);
        }
        if (next.empty()) return filled;
        for (const auto& [v, others] : next)
            if (others.size() != 2) return filled; // loops touch
        std::vector<std::vector<uint32_t>> loops;
        while (!next.empty()) {
            std::vector<uint32_t> loop{next.begin()->first};
            for (uint32_t to = next.begin()->second[0]; to != loop[0];) {
                const uint32_t from = loop.back();
                loop.push_back(to);
                const auto& ends = next.at(to);
                to = ends[0] == from ? ends[1] : ends[0];
            }
            for (const uint32_t v : loop) next.erase(v);
            if (!backward.contains({loop[0], loop[1]})) std::reverse(loop.begin(), loop.end());
            loops.push_back(std::move(loop));
        }
        double holes = 0.0;
        std::vector<Face> caps;
        std::vector<Eigen::Vector3d> centres;
        for (const std::vector<uint32_t>& loop : loops) {
            Eigen::Vector3d centre = Eigen::Vector3d::Zero();
            for (const uint32_t v : loop) centre += at(v) / static_cast<double>(loop.size());
            if (loop.size() == 3) {
                caps.push_back({loop[0], loop[1], loop[2]});
                holes += area(caps.back());
                continue;
            }
            const auto tip = static_cast<uint32_t>(mesh_.vertices.size() + centres.size());
            centres.push_back(centre);
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
                caps.push_back({a, b, tip});
                holes += 0.5 * (at(a) - centre).cross(at(b) - centre).norm();
            }
        }
        const bool few_corners =
            std::all_of(loops.begin(), loops.end(), [](const std::vector<uint32_t>& loop) { return loop.size() <= 4; });
        const double most = open_ == OpenParts::filled ? any_holes : few_corners ? missing_faces : small_holes;
        if (!(holes <= most * area_of(faces))) return filled;
        mesh_.vertices.insert(mesh_.vertices.end(), centres.begin(), centres.end());
        for (const Face& cap : caps)
            if (!is_flat(cap)) faces.push_back(cap);
        filled.add(at(loops[0][0]), loops.size());
        return filled;
    }

    // Winds a surface without free edges so that it encloses volume. False if it has no inside.
    bool wind(Solid& solid) const {
        std::vector<Face>& faces = solid.faces;
        const std::vector<HalfEdge> halves = half_edges(faces);
        std::vector<std::array<std::pair<uint32_t, bool>, 3>> neighbours(faces.size());
        std::vector<std::size_t> count(faces.size(), 0);
        const auto forward = [&](const HalfEdge& h) { return faces[h.face][h.side] == h.low; };
        for (std::size_t i = 0, end = 0; i < halves.size(); i = end) {
            while (end < halves.size() && same_edge(halves[i], halves[end])) ++end;
            if (end - i != 2) continue;
            const bool same = forward(halves[i]) == forward(halves[i + 1]);
            neighbours[halves[i].face][count[halves[i].face]++] = {halves[i + 1].face, same};
            neighbours[halves[i + 1].face][count[halves[i + 1].face]++] = {halves[i].face, same};
        }
        Eigen::Vector3d origin = Eigen::Vector3d::Zero();
        for (const Face& f : faces) origin += at(f[0]) / static_cast<double>(faces.size());
        const auto volume = [&](const Face& f) {
            return (at(f[0]) - origin).dot((at(f[1]) - origin).cross(at(f[2]) - origin)) / 6.0;
        };
        // Patches between edges of more than two faces: each is wound by its own majority, then by the sign of its volume.
        std::vector<char> seen(faces.size(), 0), flip(faces.size(), 0);
        std::vector<std::vector<uint32_t>> patches;
        for (uint32_t seed = 0; seed < faces.size(); ++seed) {
            if (seen[seed]) continue;
            std::vector<uint32_t> patch{seed};
            seen[seed] = 1;
            for (std::size_t n = 0; n < patch.size(); ++n)
                for (std::size_t k = 0; k < count[patch[n]]; ++k) {
                    const auto [other, same] = neighbours[patch[n]][k];
                    const char wanted = same ? !flip[patch[n]] : flip[patch[n]];
                    if (!seen[other]) {
                        seen[other] = 1;
                        flip[other] = wanted;
                        patch.push_back(other);
                    } else if (flip[other] != wanted) {
                        return false; // one-sided, like a Klein bottle
                    }
                }
            double as_filed = 0.0, flipped = 0.0;
            for (const uint32_t i : patch) (flip[i] ? flipped : as_filed) += area(faces[i]);
            if (flipped > as_filed)
                for (const uint32_t i : patch) flip[i] = !flip[i];
            patches.push_back(std::move(patch));
        }
        const auto signed_volume = [&](const std::vector<uint32_t>& patch) {
            double sum = 0.0;
            for (const uint32_t i : patch) sum += flip[i] ? -volume(faces[i]) : volume(faces[i]);
            return sum;
        };
        const auto balanced = [&] {
            for (std::size_t i = 0, end = 0; i < halves.size(); i = end) {
                int sum = 0;
                for (; end < halves.size() && same_edge(halves[i], halves[end]); ++end)
                    sum += forward(halves[end]) != (flip[halves[end].face] != 0) ? 1 : -1;
                if (sum != 0) return false;
            }
            return true;
        };
        if (!balanced()) {
            for (const std::vector<uint32_t>& patch : patches)
                if (signed_volume(patch) < 0.0)
                    for (const uint32_t i : patch) flip[i] = !flip[i];
            if (!balanced()) return false;
        }
        double total = 0.0;
        for (const std::vector<uint32_t>& patch : patches) total += signed_volume(patch);
        if (total < 0.0)
            for (char& f : flip) f = !f;
        if (!(std::abs(total) > no_volume * std::pow(area_of(faces), 1.5))) return false;
        solid.turned = 0;
        for (std::size_t i = 0; i < faces.size(); ++i)
            if (flip[i]) {
                std::swap(faces[i][1], faces[i][2]);
                ++solid.turned;
            }
        solid.inward = 2 * solid.turned > faces.size();
        return true;
    }

    void report() {
        const auto warn = [&](FaultId id, const Count& count, const char* one, const std::string& many,
                              const char* remedy) {
            if (count.number > 0)
                faults_.push_back(
                    {id, Severity::warning, place_of(mesh_, count.first, "mesh"),
                     count.number > 1 ? std::to_string(count.number) + many + "; this is the first." : one, remedy});
        };
        const char* none = "None needed; --strict refuses such a mesh.";
        warn(FaultId::mesh_degenerate_face, without_area_, "1 face without area was left out.",
             " faces without area were left out", none);
        if (joined_ > 0)
            faults_.push_back({FaultId::mesh_merged_vertices, Severity::warning, "mesh",
                               counted(joined_, "vertex was joined: it is", "vertices were joined: they are") +
                                   " closer than 1e-5 of the size to another, or on an edge.",
                               none});
        warn(FaultId::mesh_duplicate_face, copies_, "1 face lies on another face and was left out.",
             " faces lie on another face and were left out", none);
        warn(FaultId::mesh_open_edge, filled_, "1 hole was closed.", " holes were closed", none);
        if (turned_ > 0)
            faults_.push_back({FaultId::mesh_inconsistent_winding, Severity::warning, "mesh",
                               counted(turned_, "face was", "faces were") + " turned so that all look outward.", none});
        warn(FaultId::mesh_several_components, cavities_, "1 enclosed cavity displaces fluid and holds no mass.",
             " enclosed cavities displace fluid and hold no mass",
             "None needed. To fill a cavity, delete its faces; --strict refuses it.");
        const std::string solid =
            solids_.empty() ? "" : ", and " + counted(solids_.size(), "is", "are") + " closed and solid";
        warn(FaultId::mesh_open_edge, sheet_parts_, ("1 part is open and was taken as a sheet" + solid + ".").c_str(),
             " parts are open and were taken as sheets" + solid,
             open_ == OpenParts::filled
                 ? "None needed; what is left open is flat, or not bounded by plain loops of edges."
                 : "To make parts solid, give --fill, or close their holes in the modelling program (fill, cap, "
                   "solidify); --strict refuses open parts.");
    }

    Mesh& mesh_;
    Faults& faults_;
    OpenParts open_;
    std::vector<char> wall_;
    std::vector<Solid> solids_;
    std::size_t joined_ = 0, turned_ = 0;
    Count without_area_, copies_, filled_, cavities_, sheet_parts_;
};

bool crosses_itself(const Faults& found) {
    return std::any_of(found.begin(), found.end(),
                       [](const Fault& f) { return f.id == FaultId::mesh_self_intersection; });
}
} // namespace

bool is_clean_solid(Mesh& mesh, Faults& found) {
    return check_and_repair(mesh, found) && !crosses_itself(found);
}

bool find_parts(Mesh& mesh, BodyParts& out, Faults& faults, OpenParts open) {
    if (!Parts(mesh, faults, open).run(out)) return false;
    if (out.solid_faces == 0) return true;
    Mesh solids = out.mesh;
    solids.faces.resize(out.solid_faces);
    Faults found;
    out.clean = is_clean_solid(solids, found);
    if (out.clean && !out.has_sheets()) {
        out.mesh = std::move(solids);
        out.solid_faces = out.mesh.faces.size();
        for (const Fault& f : found)
            if (f.id == FaultId::mesh_several_components) faults.push_back(f);
    }
    return true;
}

RegionMoments body_moments(const BodyParts& parts, double thickness, bool hollow) {
    RegionMoments m;
    Mesh part;
    part.vertices = parts.mesh.vertices;
    part.faces = parts.solids();
    if (hollow) {
        const auto first = static_cast<uint32_t>(part.vertices.size());
        part.vertices.insert(part.vertices.end(), parts.cavities.vertices.begin(), parts.cavities.vertices.end());
        for (const Face& f : parts.cavities.faces) part.faces.push_back({first + f[0], first + f[1], first + f[2]});
    }
    if (!part.faces.empty()) m = SolidRegion(part, part.faces).moments(compute_mass_properties(part));
    part.faces = parts.sheets();
    if (part.faces.empty()) return m;
    const MassProperties s = compute_sheet_mass_properties(part, thickness);
    m.volume += s.volume;
    m.counted += s.volume;
    m.first += s.volume * s.centroid;
    m.second += 0.5 * s.inertia.trace() * Eigen::Matrix3d::Identity() - s.inertia +
                s.volume * s.centroid * s.centroid.transpose();
    return m;
}

MassProperties solid_mass_properties(const Mesh& mesh, const Faults& found) {
    const MassProperties sum = compute_mass_properties(mesh);
    if (!crosses_itself(found)) return sum;
    const RegionMoments m = SolidRegion(mesh, mesh.faces).moments(sum);
    if (m.counted - m.volume <= 1e-4 * m.counted) return sum;
    return combined_mass_properties(mesh, mesh.faces.size(), m.volume, m.first, m.second);
}

double sheet_length(const Mesh& mesh, const std::vector<Face>& sheets) {
    struct Part {
        Eigen::AlignedBox3d box;
        double area = 0.0;
    };
    DisjointSets sets(mesh.vertices.size());
    for (const Face& f : sheets)
        for (const uint32_t v : f) sets.join(f[0], v);
    std::map<std::size_t, Part> parts;
    double sum = 0.0, weight = 0.0;
    for (const Face& f : sheets) {
        Part& part = parts[sets.find(f[0])];
        for (const uint32_t v : f) part.box.extend(mesh.vertices[v]);
        const Eigen::Vector3d& a = mesh.vertices[f[0]];
        part.area += 0.5 * (mesh.vertices[f[1]] - a).cross(mesh.vertices[f[2]] - a).norm();
    }
    for (const auto& [root, part] : parts) {
        sum += part.area * part.box.sizes().maxCoeff();
        weight += part.area;
    }
    return weight > 0.0 ? sum / weight : 0.0;
}

double cluster_to(Mesh& mesh, double cube) {
    std::map<std::array<int64_t, 3>, std::pair<uint32_t, uint32_t>> cells; // new vertex, number of old ones
    std::vector<Eigen::Vector3d> vertices;
    std::vector<uint32_t> renumbered(mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        std::array<int64_t, 3> key{};
        for (std::size_t k = 0; k < 3; ++k)
            key[k] = static_cast<int64_t>(std::floor(mesh.vertices[i][static_cast<Eigen::Index>(k)] / cube + 0.37));
        const auto [cell, first] = cells.try_emplace(key, static_cast<uint32_t>(vertices.size()), 0U);
        if (first) vertices.emplace_back(Eigen::Vector3d::Zero());
        vertices[cell->second.first] += mesh.vertices[i];
        ++cell->second.second;
        renumbered[i] = cell->second.first;
    }
    for (const auto& [key, entry] : cells) vertices[entry.first] /= entry.second;
    mesh.vertices = std::move(vertices);
    for (Face& f : mesh.faces)
        for (uint32_t& v : f) v = renumbered[v];
    return cube;
}

double cluster(Mesh& mesh, std::size_t most) {
    if (mesh.faces.size() <= most) return 0.0;
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& v : mesh.vertices) box.extend(v);
    double fine = box.sizes().maxCoeff() / 512.0;
    for (;; fine *= 1.2) {
        Mesh coarse = mesh;
        cluster_to(coarse, fine);
        std::size_t left = 0;
        for (const Face& f : without_copies(coarse.faces)) left += f[0] != f[1] && f[1] != f[2] && f[2] != f[0];
        if (left > most) continue;
        mesh = std::move(coarse);
        return fine;
    }
}

std::vector<Face> without_copies(const std::vector<Face>& faces) {
    std::vector<std::pair<std::array<uint32_t, 3>, std::size_t>> order;
    for (std::size_t i = 0; i < faces.size(); ++i) order.emplace_back(sorted(faces[i]), i);
    std::sort(order.begin(), order.end());
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < order.size(); ++i)
        if (i == 0 || order[i].first != order[i - 1].first) kept.push_back(order[i].second);
    std::sort(kept.begin(), kept.end());
    std::vector<Face> out;
    for (const std::size_t i : kept) out.push_back(faces[i]);
    return out;
}

void drop_unused_vertices(Mesh& mesh) {
    std::vector<uint32_t> renumbered(mesh.vertices.size(), UINT32_MAX);
    std::vector<Eigen::Vector3d> kept;
    for (Face& f : mesh.faces)
        for (uint32_t& v : f) {
            if (renumbered[v] == UINT32_MAX) {
                renumbered[v] = static_cast<uint32_t>(kept.size());
                kept.push_back(mesh.vertices[v]);
            }
            v = renumbered[v];
        }
    mesh.vertices = std::move(kept);
}
} // namespace lr::baker
