#include "baker/added_mass/surface_basis.h"

#include "baker/mesh/disjoint_sets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

namespace lr::baker {
namespace {

constexpr std::size_t front = 0, back = 1;

// A face at an edge, viewed along the edge from its lower to its higher vertex.
struct Flap {
    uint32_t low, high, face;
    uint32_t low_corner, high_corner;
    double angle;       // about the edge, from an arbitrary direction
    std::size_t rising; // the side that faces larger angles
};

class SheetBasis {
public:
    explicit SheetBasis(const Mesh& mesh)
        : mesh_(mesh), spaces_(6 * mesh.faces.size()), chambers_(6 * mesh.faces.size()) {}

    SurfaceBasis run() {
        join_sides_at_edges();
        number_spaces();
        find_constants();
        return std::move(basis_);
    }

private:
    static std::size_t node(std::size_t face, std::size_t corner, std::size_t side) {
        return 6 * face + 2 * corner + side;
    }

    std::vector<Flap> find_flaps() const {
        std::vector<Flap> flaps;
        flaps.reserve(3 * mesh_.faces.size());
        for (uint32_t t = 0; t < mesh_.faces.size(); ++t)
            for (uint32_t k = 0; k < 3; ++k) {
                const uint32_t next = (k + 1) % 3;
                const bool up = mesh_.faces[t][k] < mesh_.faces[t][next];
                const uint32_t low = up ? k : next, high = up ? next : k;
                // If the face is wound along the edge, its front faces the direction of right-handed rotation about the edge.
                flaps.push_back({mesh_.faces[t][low], mesh_.faces[t][high], t, low, high, 0.0, up ? front : back});
            }
        std::sort(flaps.begin(), flaps.end(), [](const Flap& a, const Flap& b) {
            if (a.low != b.low) return a.low < b.low;
            return a.high != b.high ? a.high < b.high : a.face < b.face;
        });
        return flaps;
    }

    // Between two consecutive faces around an edge the potential has one value at each of the edge's vertices.
    void join_sides_at_edges() {
        std::vector<Flap> flaps = find_flaps();
        for (std::size_t first = 0, last = 0; first < flaps.size(); first = last) {
            while (last < flaps.size() && flaps[last].low == flaps[first].low && flaps[last].high == flaps[first].high)
                ++last;
            if (last - first > 2) sort_around_edge(flaps.data() + first, last - first);
            for (std::size_t i = first; i < last; ++i) {
                const Flap& a = flaps[i];
                const Flap& b = flaps[i + 1 < last ? i + 1 : first];
                const std::size_t falling = 1 - b.rising;
                spaces_.join(node(a.face, a.low_corner, a.rising), node(b.face, b.low_corner, falling));
                spaces_.join(node(a.face, a.high_corner, a.rising), node(b.face, b.high_corner, falling));
            }
        }
        for (std::size_t t = 0; t < mesh_.faces.size(); ++t)
            for (const std::size_t side : {front, back})
                for (std::size_t k = 0; k < 3; ++k) {
                    chambers_.join(node(t, 0, side), node(t, k, side));
                    chambers_.join(node(t, k, side), spaces_.find(node(t, k, side)));
                }
    }

    void sort_around_edge(Flap* flaps, std::size_t count) const {
        const Eigen::Vector3d start = mesh_.vertices[flaps->low];
        const Eigen::Vector3d along = (mesh_.vertices[flaps->high] - start).normalized();
        const auto across = [&](const Flap& flap) -> Eigen::Vector3d {
            const uint32_t apex = mesh_.faces[flap.face][3 - flap.low_corner - flap.high_corner];
            const Eigen::Vector3d to = mesh_.vertices[apex] - start;
            return to - along.dot(to) * along;
        };
        const Eigen::Vector3d x = across(*flaps).normalized(), y = along.cross(x);
        for (std::size_t i = 0; i < count; ++i) {
            const Eigen::Vector3d direction = across(flaps[i]);
            flaps[i].angle = std::atan2(direction.dot(y), direction.dot(x));
        }
        std::sort(flaps, flaps + count, [](const Flap& a, const Flap& b) {
            return a.angle != b.angle ? a.angle < b.angle : a.face < b.face;
        });
    }

    // Around a vertex only differences matter: one potential is zero in each group of spaces separated by faces.
    void number_spaces() {
        DisjointSets groups(6 * mesh_.faces.size());
        for (std::size_t t = 0; t < mesh_.faces.size(); ++t)
            for (std::size_t k = 0; k < 3; ++k)
                groups.join(spaces_.find(node(t, k, front)), spaces_.find(node(t, k, back)));
        constexpr int32_t unseen = -2;
        unknown_.assign(6 * mesh_.faces.size(), unseen);
        int32_t count = 0;
        basis_.sheet = true;
        basis_.corners.resize(mesh_.faces.size());
        for (std::size_t t = 0; t < mesh_.faces.size(); ++t)
            for (std::size_t k = 0; k < 3; ++k) {
                const auto number = [&](std::size_t side) {
                    const std::size_t space = spaces_.find(node(t, k, side));
                    if (unknown_[space] == unseen) unknown_[space] = space == groups.find(space) ? -1 : count++;
                    return unknown_[space];
                };
                const CornerUnknowns corner{number(front), number(back)};
                // At a rim front and back are one space: no jump.
                basis_.corners[t][k] = corner.plus == corner.minus ? CornerUnknowns{} : corner;
            }
        basis_.unknowns = static_cast<std::size_t>(count);
        zero_chamber_.resize(basis_.unknowns);
        chamber_.resize(basis_.unknowns);
        for (std::size_t space = 0; space < unknown_.size(); ++space)
            if (unknown_[space] >= 0) {
                chamber_[static_cast<std::size_t>(unknown_[space])] = chambers_.find(space);
                zero_chamber_[static_cast<std::size_t>(unknown_[space])] = chambers_.find(groups.find(space));
            }
    }

    // The potential of each chamber is free up to a constant: a connected part has one constant for every chamber but one.
    void find_constants() {
        DisjointSets parts(6 * mesh_.faces.size());
        for (std::size_t t = 0; t < mesh_.faces.size(); ++t)
            parts.join(chambers_.find(node(t, 0, front)), chambers_.find(node(t, 0, back)));
        std::map<std::size_t, ConstantPotential> by_chamber;
        const auto add = [&](std::size_t chamber, std::size_t unknown, double sign) {
            if (chamber == parts.find(chamber)) return;
            by_chamber[chamber].unknowns.push_back(static_cast<int32_t>(unknown));
            by_chamber[chamber].signs.push_back(sign);
        };
        for (std::size_t i = 0; i < basis_.unknowns; ++i) {
            if (chamber_[i] == zero_chamber_[i]) continue;
            add(chamber_[i], i, 1.0);
            add(zero_chamber_[i], i, -1.0);
        }
        for (auto& [chamber, constant] : by_chamber) basis_.constants.push_back(std::move(constant));
    }

    const Mesh& mesh_;
    // Sets of corner sides: spaces_ joins sides in one space at their vertex, chambers_ joins sides in one chamber.
    DisjointSets spaces_, chambers_;
    std::vector<int32_t> unknown_;
    std::vector<std::size_t> chamber_, zero_chamber_; // chamber of each unknown, and of the zero space of its group
    SurfaceBasis basis_;
};
} // namespace

SurfaceBasis closed_basis(const Mesh& mesh) {
    SurfaceBasis basis;
    basis.unknowns = mesh.vertices.size();
    basis.corners.resize(mesh.faces.size());
    DisjointSets parts(mesh.vertices.size());
    for (std::size_t t = 0; t < mesh.faces.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            basis.corners[t][k].plus = static_cast<int32_t>(mesh.faces[t][k]);
            parts.join(mesh.faces[t][0], mesh.faces[t][k]);
        }
    std::vector<std::size_t> number(mesh.vertices.size());
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        const std::size_t part = parts.find(v); // the lowest vertex of the part comes first
        if (part == v) {
            number[v] = basis.constants.size();
            basis.constants.emplace_back();
        }
        basis.constants[number[part]].unknowns.push_back(static_cast<int32_t>(v));
        basis.constants[number[part]].signs.push_back(1.0);
    }
    return basis;
}

SurfaceBasis sheet_basis(const Mesh& mesh) {
    return SheetBasis(mesh).run();
}
} // namespace lr::baker
