#include "baker/mesh/double_sheets.h"

#include "baker/fault_text.h"
#include "baker/length_text.h"
#include "baker/mesh/body_parts.h"
#include "baker/mesh/disjoint_sets.h"
#include "baker/mesh/half_edges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace lr::baker {
namespace {

constexpr double same_patch = 0.3; // cosine between neighbours: walls and the other side turn by more
constexpr double opposed = -0.9;   // cosine between the faces of a pair
constexpr double covered = 0.9;    // share of the area of a side that other sides cover
// Largest area of the rim between the two sides of a closed surface, over the area of a side.
constexpr double wall = 0.1;
constexpr double touch = 0.1; // covered area over that of the smaller patch; less is an edge that overlaps
// Largest free share of the rim of a side. It is not zero where coinciding tips of both sides were removed before.
constexpr double mostly_closed = 0.1;
// Of the grid. Needles much longer than the gap exceed it, and are not searched.
constexpr std::size_t most_entries = 4000000;

struct DoubleSheets {
    std::vector<Face> kept;                          // one face of each double sheet, and all other faces
    std::size_t removed = 0;                         // number of faces
    double area = 0.0, total = 0.0;                  // of removed faces, and of all
    double gap = 0.0;                                // mean distance between the faces
    Eigen::Vector3d first = Eigen::Vector3d::Zero(); // a point of the first removed face
    // Area, over that of all, of equally close layers that are joined at a fold: folded paper looks like a leaf with a back.
    double folded = 0.0;
};

class Search {
public:
    Search(const Mesh& mesh, const std::vector<Face>& faces, double gap) : mesh_(mesh), faces_(faces), gap_(gap) {
        for (const Face& f : faces_) {
            const Eigen::Vector3d twice = (at(f[1]) - at(f[0])).cross(at(f[2]) - at(f[0]));
            area_.push_back(0.5 * twice.norm());
            normal_.push_back(twice.normalized());
        }
    }

    DoubleSheets run() {
        DoubleSheets out;
        out.kept = faces_;
        find_patches();
        if (patch_area_.size() < 2 || !make_grid()) return out;
        match();
        out.total = std::accumulate(area_.begin(), area_.end(), 0.0);
        find_sides();
        std::vector<double> both(part_area_.size(), 0.0); // area of a part's sides that have no free rim
        for (uint32_t p = 0; p < patch_area_.size(); ++p)
            if (is_side_[p] && closed_[p] && is_in_two_pieces(p)) both[part_[p]] += patch_area_[p];
        // Different parts, or a closed surface that is nothing but two sides and a rim.
        const auto counts_twice = [&](uint32_t a, uint32_t b) {
            return part_[a] != part_[b] || both[part_[a]] > (1.0 - wall) * part_area_[part_[a]];
        };
        std::vector<char> doubled(2 * patch_area_.size(), 0), halved(part_area_.size(), 0); // bodies, parts
        std::vector<std::array<double, 2>> side_area(2 * patch_area_.size(), {0.0, 0.0});   // of bodies
        double weight = 0.0;
        for (const auto& [pair, cover] : covers_) {
            const auto [a, b] = pair;
            if (!are_opposite(a, b)) continue;
            if (!counts_twice(a, b)) out.folded += cover.area / out.total;
            if (a > b || !counts_twice(a, b)) continue;
            doubled[body_of(a)] = 1;
            if (part_[a] == part_[b]) halved[part_[a]] = 1;
            out.gap += cover.distance;
            weight += cover.area;
        }
        if (weight == 0.0) return out;
        out.gap /= weight;
        for (uint32_t p = 0; p < patch_area_.size(); ++p)
            if (is_side_[p]) side_area[body_of(p)][side_of(p)] += patch_area_[p];
        out.kept.clear();
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            const uint32_t p = patch_[i];
            const std::size_t body = body_of(p);
            const std::array<double, 2>& areas = side_area[body];
            const bool gone = is_side_[p] ? doubled[body] && side_of(p) == (areas[1] > areas[0] ? 0U : 1U)
                                          : halved[part_[p]] != 0; // the rim between two sides
            if (!gone) {
                out.kept.push_back(faces_[i]);
                continue;
            }
            if (out.removed++ == 0) out.first = middle(i);
            out.area += area_[i];
        }
        return out;
    }

private:
    struct Cover {
        double area = 0.0, distance = 0.0; // distance times area
    };

    // A patch is a side if other sides cover it. Sides that cover each other are opposite; sides that meet at a crease are the same side, so that the
    // front of a leaf is removed as a whole or not at all.
    void find_sides() {
        is_side_.assign(patch_area_.size(), 1);
        for (bool stable = false; !stable;) {
            std::vector<double> area(patch_area_.size(), 0.0);
            for (const auto& [pair, cover] : covers_)
                if (is_side_[pair.second]) area[pair.first] += cover.area;
            stable = true;
            for (uint32_t p = 0; p < patch_area_.size(); ++p)
                if (is_side_[p] && area[p] < covered * patch_area_[p]) stable = false, is_side_[p] = 0;
        }
        struct Link {
            double size;
            std::array<uint32_t, 2> patches;
        };
        std::vector<Link> covering, meeting;
        for (const auto& [pair, cover] : covers_)
            if (cover.area > touch * std::min(patch_area_[pair.first], patch_area_[pair.second]))
                covering.push_back({cover.area, {pair.first, pair.second}});
        for (const auto& [pair, length] : meets_) meeting.push_back({length, {pair.first, pair.second}});
        const auto join = [&](std::vector<Link>& links, uint32_t turn) {
            std::stable_sort(links.begin(), links.end(), [](const Link& a, const Link& b) { return a.size > b.size; });
            for (const auto& [size, p] : links) {
                if (!is_side_[p[0]] || !is_side_[p[1]] || sides_.find(2 * p[0]) == sides_.find(2 * p[1] + (1 - turn)))
                    continue;
                sides_.join(2 * p[0], 2 * p[1] + turn);
                sides_.join(2 * p[0] + 1, 2 * p[1] + (1 - turn));
            }
        };
        join(covering, 1);
        join(meeting, 0);
    }
    // Whether nearly all of each side of the body is one connected piece. Layers of pleats alternate between the sides, so theirs are not.
    bool is_in_two_pieces(uint32_t p) {
        if (piece_area_.empty()) {
            DisjointSets pieces(patch_area_.size());
            for (const auto& [pair, length] : meets_) {
                const auto [a, b] = pair;
                if (is_side_[a] && is_side_[b] && sides_.find(2 * a) == sides_.find(2 * b)) pieces.join(a, b);
            }
            std::vector<double> area(patch_area_.size(), 0.0);
            for (uint32_t q = 0; q < patch_area_.size(); ++q) area[pieces.find(q)] += patch_area_[q];
            piece_area_.assign(2 * patch_area_.size(), {0.0, 0.0, 0.0});
            for (uint32_t q = 0; q < patch_area_.size(); ++q) {
                if (!is_side_[q] || area[q] == 0.0) continue;
                std::array<double, 3>& of = piece_area_[body_of(q)]; // largest piece of each side, then all pieces
                of[side_of(q)] = std::max(of[side_of(q)], area[q]);
                of[2] += area[q];
            }
        }
        const std::array<double, 3>& of = piece_area_[body_of(p)];
        return of[0] + of[1] > (1.0 - wall) * of[2];
    }
    std::size_t body_of(uint32_t p) { return std::min(sides_.find(2 * p), sides_.find(2 * p + 1)); }
    std::size_t side_of(uint32_t p) { return sides_.find(2 * p) < sides_.find(2 * p + 1) ? 0 : 1; }
    bool are_opposite(uint32_t a, uint32_t b) {
        return is_side_[a] && is_side_[b] && sides_.find(2 * a) == sides_.find(2 * b + 1);
    }

    const Eigen::Vector3d& at(uint32_t v) const { return mesh_.vertices[v]; }
    Eigen::Vector3d middle(std::size_t i) const {
        return (at(faces_[i][0]) + at(faces_[i][1]) + at(faces_[i][2])) / 3.0;
    }

    // Patches of faces that turn little from one to the next, and the connected parts that they belong to.
    void find_patches() {
        Mesh sheets;
        sheets.faces = faces_;
        const std::vector<HalfEdge> halves = sorted_half_edges(sheets);
        DisjointSets patches(faces_.size()), parts(faces_.size());
        for (std::size_t i = 0, end = 0; i < halves.size(); i = end) {
            while (end < halves.size() && same_edge(halves[i], halves[end])) ++end;
            for (std::size_t k = i; k < end; ++k) parts.join(halves[i].face, halves[k].face);
            if (end - i == 2 && normal_[halves[i].face].dot(normal_[halves[i + 1].face]) > same_patch)
                patches.join(halves[i].face, halves[i + 1].face);
        }
        std::map<std::size_t, uint32_t> patch_number, part_number;
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            const auto part = part_number.try_emplace(parts.find(i), static_cast<uint32_t>(part_number.size())).first;
            const auto [patch, new_patch] =
                patch_number.try_emplace(patches.find(i), static_cast<uint32_t>(patch_number.size()));
            if (new_patch) {
                patch_area_.push_back(0.0);
                part_.push_back(part->second);
            }
            patch_.push_back(patch->second);
            patch_area_[patch->second] += area_[i];
            part_area_.resize(part_number.size(), 0.0);
            part_area_[part->second] += area_[i];
        }
        closed_.assign(patch_area_.size(), 0);
        sides_ = DisjointSets(2 * patch_area_.size());
        std::vector<std::array<double, 2>> rim(patch_area_.size(), {0.0, 0.0}); // lengths: free, all
        for (std::size_t i = 0, end = 0; i < halves.size(); i = end) {
            while (end < halves.size() && same_edge(halves[i], halves[end])) ++end;
            const double length = (at(halves[i].low) - at(halves[i].high)).norm();
            const uint32_t a = patch_[halves[i].face], b = patch_[halves[end - 1].face];
            if (end - i == 1) rim[a][0] += length;
            if (end - i == 2 && a == b) continue;
            if (end - i == 2) meets_[std::minmax(a, b)] += length;
            for (std::size_t k = i; k < end; ++k) rim[patch_[halves[k].face]][1] += length;
        }
        for (std::size_t p = 0; p < rim.size(); ++p) closed_[p] = rim[p][0] <= mostly_closed * rim[p][1];
    }

    using Cell = std::array<int64_t, 3>;
    Cell cell_of(const Eigen::Vector3d& p) const {
        Cell c{};
        for (std::size_t k = 0; k < 3; ++k)
            c[k] = static_cast<int64_t>(std::floor(p[static_cast<Eigen::Index>(k)] / cell_));
        return c;
    }

    bool make_grid() {
        Eigen::AlignedBox3d box;
        double sum = 0.0;
        std::vector<Eigen::AlignedBox3d> boxes(faces_.size());
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            for (const uint32_t v : faces_[i]) boxes[i].extend(at(v));
            box.extend(boxes[i]);
            sum += boxes[i].sizes().maxCoeff();
        }
        // Cells of the size of the faces, for otherwise a million faces have hundreds in each.
        const double face = sum / static_cast<double>(faces_.size()), least = 1e-6 * box.sizes().maxCoeff();
        const double coarse = std::max({gap_, 0.5 * face, least});
        return fill_grid(boxes, std::min(coarse, std::max({0.25 * gap_, face, least}))) || fill_grid(boxes, coarse);
    }

    bool fill_grid(const std::vector<Eigen::AlignedBox3d>& boxes, double cell) {
        cell_ = cell;
        entries_.clear();
        for (uint32_t i = 0; i < faces_.size(); ++i) {
            const Cell low = cell_of(boxes[i].min()), high = cell_of(boxes[i].max());
            for (int64_t x = low[0]; x <= high[0]; ++x)
                for (int64_t y = low[1]; y <= high[1]; ++y)
                    for (int64_t z = low[2]; z <= high[2]; ++z) {
                        if (entries_.size() == most_entries) return false;
                        entries_.push_back({{x, y, z}, i});
                    }
        }
        std::sort(entries_.begin(), entries_.end());
        return true;
    }

    // For seven points of each face: the nearest face in front of or behind it that faces the other way.
    void match() {
        constexpr std::array<std::array<double, 3>, 7> points{{{1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0},
                                                               {0.8, 0.1, 0.1},
                                                               {0.1, 0.8, 0.1},
                                                               {0.1, 0.1, 0.8},
                                                               {0.45, 0.45, 0.1},
                                                               {0.1, 0.45, 0.45},
                                                               {0.45, 0.1, 0.45}}};
        for (std::size_t i = 0; i < faces_.size(); ++i)
            for (const auto& w : points) {
                const Face& f = faces_[i];
                const Eigen::Vector3d point = w[0] * at(f[0]) + w[1] * at(f[1]) + w[2] * at(f[2]);
                double nearest = gap_;
                uint32_t found = UINT32_MAX;
                const Eigen::Vector3d& along = normal_[i];
                const double slack = 1e-3 * cell_;
                using Part = std::array<double, 2>; // of the line from the point along the normal, in m
                const auto layers = [&](Eigen::Index k, const Part& part) {
                    const auto [low, high] =
                        std::minmax({point[k] + part[0] * along[k], point[k] + part[1] * along[k]});
                    return std::array{static_cast<int64_t>(std::floor((low - slack) / cell_)),
                                      static_cast<int64_t>(std::floor((high + slack) / cell_))};
                };
                const auto within = [&](Eigen::Index k, int64_t layer, const Part& part) {
                    if (std::abs(along[k]) < 1e-9) return part;
                    const double low = static_cast<double>(layer) * cell_ - slack - point[k];
                    const double a = low / along[k], b = (low + cell_ + 2.0 * slack) / along[k];
                    return Part{std::max(part[0], std::min(a, b)), std::min(part[1], std::max(a, b))};
                };
                const Part all{-gap_, gap_};
                const auto xs = layers(0, all);
                for (int64_t x = xs[0]; x <= xs[1]; ++x) {
                    const Part in_x = within(0, x, all);
                    const auto ys = layers(1, in_x);
                    for (int64_t y = ys[0]; y <= ys[1]; ++y) {
                        const auto zs = layers(2, within(1, y, in_x));
                        const Cell last{x, y, zs[1]};
                        for (auto e =
                                 std::lower_bound(entries_.begin(), entries_.end(), std::pair(Cell{x, y, zs[0]}, 0U));
                             e != entries_.end() && e->first <= last; ++e)
                            if (const double d = distance(point, i, e->second); d < nearest) {
                                nearest = d;
                                found = e->second;
                            }
                    }
                }
                if (found == UINT32_MAX) continue;
                Cover& cover = covers_[{patch_[i], patch_[found]}];
                cover.area += area_[i] / static_cast<double>(points.size());
                cover.distance += nearest * area_[i] / static_cast<double>(points.size());
            }
    }

    // Along the normal of face `from`; infinite if `to` is not hit or does not face the other way.
    double distance(const Eigen::Vector3d& point, std::size_t from, std::size_t to) const {
        if (patch_[to] == patch_[from] || normal_[from].dot(normal_[to]) > opposed) return HUGE_VAL;
        const Face& f = faces_[to];
        const double along =
            normal_[to].dot(at(f[0]) - point) / normal_[to].dot(normal_[from]); // of the line through the point
        const Eigen::Vector3d hit = point + along * normal_[from];
        for (std::size_t k = 0; k < 3; ++k) {
            const Eigen::Vector3d &a = at(f[k]), &b = at(f[(k + 1) % 3]);
            if ((b - a).cross(hit - a).dot(normal_[to]) < -1e-9 * area_[to]) return HUGE_VAL;
        }
        return std::abs(along);
    }

    const Mesh& mesh_;
    const std::vector<Face>& faces_;
    double gap_, cell_ = 0.0;
    std::vector<double> area_, patch_area_, part_area_;
    std::vector<Eigen::Vector3d> normal_;
    std::vector<uint32_t> patch_, part_; // of each face; of each patch
    std::vector<char> closed_, is_side_; // of each patch: its rim is joined to others; others cover it
    std::map<std::pair<uint32_t, uint32_t>, double> meets_; // length of the edges between two patches
    std::vector<std::array<double, 3>> piece_area_;         // of bodies
    DisjointSets sides_{0};                                 // of patches, as they are and as the other side
    std::vector<std::pair<Cell, uint32_t>> entries_;
    std::map<std::pair<uint32_t, uint32_t>, Cover> covers_; // of the first patch by the second
};

double hair_of(const Mesh& mesh, const std::vector<Face>& sheets) {
    return 0.01 * sheet_length(mesh, sheets);
}
} // namespace

bool take_double_sheets_once(const Mesh& mesh, double thickness, bool strict, std::vector<Face>& sheets,
                             Faults& faults) {
    const double gap = std::max(thickness, hair_of(mesh, sheets));
    DoubleSheets found = Search(mesh, sheets, gap).run();
    const auto percent = [](double share) {
        return std::to_string(static_cast<int>(std::lround(100.0 * share))) + " % of the area";
    };
    if (found.removed > 0) {
        const std::string where = place_of(mesh, found.first, "mesh");
        const std::string what = counted(found.removed, "face is", "faces are") + " the back of a sheet, " +
                                 length_text(found.gap, 2) + " from its front: " + percent(found.area / found.total);
        if (strict) {
            faults.push_back({FaultId::mesh_duplicate_face, Severity::error, where, what + " would count twice.",
                              "Delete the back faces, or bake without --strict."});
            return false;
        }
        faults.push_back({FaultId::mesh_duplicate_face, Severity::warning, where,
                          what + ", left out so that the sheet counts once.",
                          "None needed; --strict refuses such a mesh."});
    }
    if (found.folded > 0.0)
        faults.push_back({FaultId::mesh_duplicate_face, Severity::warning, "mesh",
                          percent(found.folded) + " lies within " + length_text(gap, 2) +
                              " of a layer that looks the other way and joins it at a fold: both count.",
                          "None needed for folded paper. If one layer is the back of the other, delete it."});
    sheets = std::move(found.kept);
    return true;
}

bool find_one_side(const Mesh& solid, Mesh& side) {
    side = solid;
    DoubleSheets found = Search(solid, solid.faces, hair_of(solid, solid.faces)).run();
    side.faces = std::move(found.kept);
    drop_unused_vertices(side);
    return found.removed > 0 && found.area > (1.0 - wall) * (found.total - found.area);
}
} // namespace lr::baker
