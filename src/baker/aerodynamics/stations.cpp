#include "baker/aerodynamics/stations.h"

#include "asset/closed_forms/aerodynamic_coefficients.h"
#include "baker/aerodynamics/camber.h"
#include "baker/aerodynamics/hollow.h"
#include "baker/aerodynamics/local_thickness.h"
#include "baker/aerodynamics/outline_parts.h"
#include "baker/aerodynamics/silhouette.h"
#include "baker/aerodynamics/station_loads.h"
#include "baker/aerodynamics/surface_measures.h"
#include "baker/aerodynamics/surface_parts.h"
#include "baker/eigensystem.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <span>
#include <utility>

namespace lr::baker {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double good_error = 0.08; // below it, no more stations
constexpr double bad_error = 0.2;   // above it, a warning
// Mean squared sine of the tilt, below which a surface is flat: a cap with a rise of 0.04 diameters.
constexpr double flat = 0.015;
// Mean squared slope along the chord, above which the chord is cut too; less is camber.
constexpr double bent_chord = 0.008;
constexpr double off_centre = 0.05; // distance of the centre of mass from the middle of the area, over the extent
constexpr double thick = 0.1;       // volume over the area to the power 3/2, half of a sphere's
constexpr double convex = 0.9;      // volume over that of the hull
constexpr double even = 0.9;        // volume over that of a prism on the outline, as high as the body
constexpr double slender =
    2.999; // ratio of the root mean squares of span and chord; at 3 rounding would judge strips of 3:1
constexpr double long_strip = 2.0; // arms along the span fade from span/chord = 2 to 4
// They fade in parts that reach across the centre of mass: its distance from their middle, over half their length, is at most 0.4; from 0.6 on they
// lie behind it.
constexpr double across_centre = 0.4, behind_centre = 0.6;
// Offset of the weight from the middle of the area, over the extent, above which the wing behind it is cut along the chord too, as that of a winged
// seed. In one strip its pitch is not held, and it dives.
constexpr double weight_aside = 0.15;
constexpr double hiding = 0.36;         // share of the surface in the lee of the rest; a hemispherical bowl has 1/3
constexpr double far_from_convex = 0.5; // volume over that of the hull
// A solid beside sheets is a lump if its faces are tilted by more than this (mean squared sine), and look at each other less.
constexpr double blocky = 0.2, self_facing = 0.005;
// Hollow above which a body is a bowl, whose bottom counts, and not a tube, which falls across its axis.
constexpr double deep = 0.45;
constexpr double reynolds = 1e4;

// Munk's moment puts the lift of a short wing ahead of the quarter chord of a thin wing. Measured falls of discs fit best with Munk's alone, caps and
// curled leaves need more of the quarter chord: a third of the way.
constexpr double quarter = 0.25, aft_share = 1.0 / 3.0;

struct Plan {
    Part part;
    Vector3d chord, span, normal;
    shape::Wing wing;
    bool curved = false; // along the chord
    bool lump = false;   // one station, whatever its shape
    bool trails = false; // behind the body's weight, as the wing of a seed: at least two rows along the chord
    double end_on = 1.0; // of lift_arm along the span
};

// Centre of lift in a stream along the span: near the front edge of a slender wing, at the quarter of a long one.
double slender_arm(const shape::Wing& wing) {
    const double aspect = wing.chord * wing.chord / wing.area;
    return 0.5 - quarter * aspect / (aspect + 0.35);
}

// Distance of the centre of mass, which is the origin, from the middle of the span, over half of it.
double aside_of(const Plan& plan) {
    const auto [low, high] = extent_of(plan.part, plan.span);
    return std::abs(high + low) / (high - low);
}

// End-on a long strip is stalled. An arm would steady it there like an arrow, so that curved ones fell end first while they spun about the span, and
// ash seeds as darts. The wing of a maple's seed, behind its nut, and walls keep theirs. broadside: the body's normal.
double end_on_share(const Plan& plan, const Vector3d& broadside) {
    const double aside = aside_of(plan), facing = plan.normal.dot(broadside);
    const double slenderness = std::clamp(plan.wing.span / (long_strip * plan.wing.chord) - 1.0, 0.0, 1.0);
    const double across = std::clamp((behind_centre - aside) / (behind_centre - across_centre), 0.0, 1.0);
    return 1.0 - slenderness * facing * facing * across;
}

std::array<double, 3> to_array(const Vector3d& v) {
    return {v[0], v[1], v[2]};
}

std::array<double, 9> rows_of(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    return {a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]};
}

Vector3d row(const std::array<double, 9>& axes, std::size_t k) {
    return {axes[3 * k], axes[3 * k + 1], axes[3 * k + 2]};
}

std::size_t broadside_of(const AerodynamicData& loads) {
    return static_cast<std::size_t>(std::max_element(loads.broadside.begin(), loads.broadside.end()) -
                                    loads.broadside.begin());
}

// Faces along the normal, without rims.
Part faces_along(const Part& part, const Vector3d& normal) {
    Part out;
    for (const Facet& f : part)
        if (std::abs(f.normal.dot(normal)) > 0.5) out.push_back(f);
    return out;
}

// Asymmetry of fore and aft: third moment, and offset of the centre of mass (the origin), over the root mean square.
double lopsided(const Part& part, const PartMoments& m, const Vector3d& axis, double size) {
    double third = 0.0;
    for (const Facet& f : refined(part, size / 24.0)) {
        const double x = axis.dot(f.middle() - m.centroid);
        third += f.area * x * x * x;
    }
    const double square = axis.dot(m.second * axis), root = std::sqrt(square);
    return square > 0.0 ? std::abs(third) / (m.area * square * root) + std::abs(axis.dot(m.centroid)) / root : 0.0;
}

// Mean square deviation of the slope along the chord from its mean in the same strip, so that a twist of the wing is no bend.
double bend_along_chord(const Part& faces, const Plan& plan) {
    constexpr std::size_t strips = 16;
    std::array<std::array<double, 3>, strips> sums{};
    const auto [low, high] = extent_of(faces, plan.span);
    for (const Facet& f : refined(faces, plan.wing.span / strips)) {
        const double x = (plan.span.dot(f.middle()) - low) / (high - low) * strips;
        std::array<double, 3>& sum = sums[static_cast<std::size_t>(std::clamp(x, 0.0, strips - 1.0))];
        const double slope = f.normal.dot(plan.chord) / f.normal.dot(plan.normal);
        const std::array<double, 3> terms{1.0, slope, slope * slope};
        for (std::size_t k = 0; k < 3; ++k) sum[k] += f.area * terms[k];
    }
    double area = 0.0, bend = 0.0;
    for (const std::array<double, 3>& sum : sums) {
        area += sum[0];
        if (sum[0] > 0.0) bend += sum[2] - sum[1] * sum[1] / sum[0];
    }
    return area > 0.0 ? bend / area : 0.0;
}

Plan plan_of(Part part, const AerodynamicData& loads, double size) {
    Plan out;
    const std::size_t broad = broadside_of(loads);
    const PartMoments all = moments_of(part);
    out.normal = common_normal(all, row(loads.axes, broad));
    const Part faces = faces_along(part, out.normal);
    const PartMoments m = moments_of(faces);
    const Matrix3d across = Matrix3d::Identity() - out.normal * out.normal.transpose();
    const Eigensystem<Matrix3d> solver = eigensystem(Matrix3d(across * m.second * across));
    const double shortest = std::max(solver.values[1], 0.0), longest = solver.values[2];
    Vector3d length = solver.vectors.col(2);
    length = (length - out.normal.dot(length) * out.normal).normalized();
    // Equal moments define no axes. Then the part is cut along a mirror line, near the body's axis if it has several: across one, the two halves of a
    // blossom would be cut unlike, and all blossoms would spin in one sense.
    if (!(longest >= 1.05 * shortest) || !(length.squaredNorm() > 0.5)) {
        length = out.normal.unitOrthogonal();
        Vector3d best = across * row(loads.axes, (broad + 1) % 3);
        const Vector3d other = across * row(loads.axes, (broad + 2) % 3);
        if (other.squaredNorm() > 1.01 * best.squaredNorm()) best = other;
        if (best.squaredNorm() > 1e-6) length = best.normalized();
        length = mirror_line(faces, out.normal, length);
    }
    const Vector3d width = out.normal.cross(length);
    // A strip's span is its length. Other wings fly along the axis in which fore and aft differ.
    const bool along = longest < slender * slender * shortest &&
                       lopsided(faces, m, length, size) > lopsided(faces, m, width, size) + 0.05;
    out.chord = along ? length : width;
    // The leading edge is on the heavier side, or where the camber line is flatter.
    const auto extent = [](const std::pair<double, double>& e) { return e.second - e.first; };
    out.span = out.normal.cross(out.chord);
    out.wing.chord = extent(extent_of(faces, out.chord));
    out.wing.span = extent(extent_of(faces, out.span));
    for (const Facet& f : part) out.wing.area += f.area * std::abs(f.normal.dot(out.normal));
    const double ahead = -out.chord.dot(m.centroid);
    bool turn = ahead < 0.0;
    if (std::abs(ahead) < 0.02 * out.wing.chord) {
        const double forward = camber_of(part, m.centroid, out.chord, out.normal);
        const double backward = camber_of(part, m.centroid, -out.chord, out.normal);
        turn = std::abs(backward) > std::abs(forward) * (1.0 + 1e-6) + 1e-6;
    }
    if (turn) {
        out.chord = -out.chord;
        out.span = -out.span;
    }
    out.curved = bend_along_chord(faces, out) > bent_chord;
    out.part = std::move(part);
    return out;
}

// Treats adjoining arms in one line as one wing.
void join_arms(std::vector<Plan>& plans) {
    const auto middle = [](const Plan& p) { return moments_of(p.part).centroid; };
    std::vector<shape::Wing> joined;
    for (const Plan& a : plans) {
        joined.push_back(a.wing);
        for (const Plan& b : plans) {
            if (&a == &b || a.lump || b.lump || std::abs(a.span.dot(b.span)) < 0.98 ||
                std::abs(a.normal.dot(b.normal)) < 0.98)
                continue;
            const Vector3d apart = middle(b) - middle(a);
            const double along = std::abs(a.span.dot(apart)), length = 0.5 * (a.wing.span + b.wing.span);
            if (std::abs(along - length) > 0.2 * length ||
                (apart.squaredNorm() - along * along) > 0.0625 * a.wing.chord * a.wing.chord)
                continue;
            joined.back().span += b.wing.span;
            joined.back().area += b.wing.area;
        }
    }
    for (std::size_t i = 0; i < plans.size(); ++i) plans[i].wing = joined[i];
}

struct Body {
    double size, area; // area of all parts
    const StationOptions& options;
    const AerodynamicData& loads;
    Vector3d hollow;
};

struct Grid {
    std::size_t along_span = 1, along_chord = 1;
    bool operator==(const Grid&) const = default;
    std::size_t count() const { return along_span * along_chord; }
};

// Moves a place along the part's own line to this distance along the direction.
void move_to(Vector3d& place, const Matrix3d& second, const Vector3d& direction, double node) {
    const Vector3d along = second * direction;
    const double square = direction.dot(along);
    if (square > 0.0) place += (node - direction.dot(place)) / square * along;
}

StationData station_of(const Part& part, const Plan& plan, const Grid& grid, double span_node, double chord_node,
                       const Body& body) {
    const bool whole_chord = grid.along_chord == 1;
    PartMoments m = moments_of(part);
    if (grid.along_span > 1) move_to(m.centroid, m.second, plan.span, span_node);
    if (!whole_chord) move_to(m.centroid, m.second, plan.chord, chord_node);
    const Vector3d normal = common_normal(m, plan.normal);
    Vector3d span = plan.span - normal.dot(plan.span) * normal;
    if (!(span.squaredNorm() > 1e-6)) span = normal.cross(plan.chord); // a piece across the span
    span.normalize();
    const Vector3d chord = span.cross(normal);
    shape::SurfaceMeasures measures(rows_of(chord, span, normal), to_array(m.centroid), body.size);
    for (const Facet& f : part) measures.add(to_array(f.at[0]), to_array(f.at[1]), to_array(f.at[2]), f.sides);
    shape::AerodynamicGeometry g = measures.geometry();
    g.volume = body.options.volume * m.area / body.area;
    StationData out = shape::default_station(g, plan.wing);
    // Spin: several stations have different velocities in it. Its effect within each is omitted, since it vanishes with their number.
    if (grid.along_span > 1) out.spin_lift[0] = out.spin_drag[0] = out.spin_drag_stream[0] = 0.0;
    if (!whole_chord) out.spin_lift[1] = out.spin_drag[1] = out.spin_drag_stream[1] = 0.0;
    out.place = to_array(m.centroid);
    shape_as_wall(part, body.hollow, out);
    const double width = whole_chord ? g.extent[1] : plan.wing.span;
    const double own_chord =
        width > 0.0 ? std::min((whole_chord ? g.area[2] : plan.wing.area) / width, plan.wing.chord) : 0.0;
    const double aspect = plan.wing.area > 0.0 ? plan.wing.span * plan.wing.span / plan.wing.area : 0.0;
    // Added mass by strips; share_added_mass scales it.
    out.separated_shedding = 0.25 * std::numbers::pi * own_chord * g.area[2] * aspect / (1.0 + aspect);
    out.lift_arm = {-quarter * (whole_chord ? own_chord : g.extent[0]),
                    -plan.end_on * slender_arm(plan.wing) * (whole_chord ? plan.wing.span : g.extent[1]), 0.0};
    if (whole_chord && !plan.lump) out.camber = std::clamp(camber_of(part, m.centroid, chord, normal), -0.5, 0.5);
    // Creeping flow: the body's drag, shared by area, along this part's axes.
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < 3; ++i) {
            const double cosine = row(out.axes, k).dot(row(body.loads.axes, i));
            out.drag_stokes[k] += cosine * cosine * body.loads.drag_stokes[i] * m.area / body.area;
        }
    return out;
}

// Couple in creeping flow: the part of the body's that the drag at the stations does not give.
void share_stokes_couple(std::vector<StationData>& stations, const std::vector<double>& shares,
                         const AerodynamicData& loads) {
    std::array<double, 3> rest = loads.spin_drag_stokes;
    for (const StationData& s : stations)
        for (std::size_t i = 0; i < 3; ++i) {
            const Vector3d moved = row(loads.axes, i).cross(Vector3d(s.place[0], s.place[1], s.place[2]));
            for (std::size_t k = 0; k < 3; ++k) {
                const double along = row(s.axes, k).dot(moved);
                rest[i] -= s.drag_stokes[k] * along * along;
            }
        }
    for (std::size_t n = 0; n < stations.size(); ++n)
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t i = 0; i < 3; ++i) {
                const double cosine = row(stations[n].axes, k).dot(row(loads.axes, i));
                stations[n].spin_drag_stokes[k] += cosine * cosine * std::max(rest[i], 0.0) * shares[n];
            }
}

// A plan and its strips, which grids with as many of them share.
class Cuts {
public:
    struct Strip {
        double node;
        Slicer pieces;
    };
    explicit Cuts(const Plan& p) : plan(p), slicer_(p.part, p.span) {}
    std::vector<Strip>& strips(std::size_t n) {
        std::vector<Strip>& out = strips_[n];
        if (out.empty())
            for (Slice& s : slicer_.sliced(n)) out.push_back({s.node, Slicer(std::move(s.part), plan.chord)});
        return out;
    }
    const Plan& plan;

private:
    Slicer slicer_;
    std::map<std::size_t, std::vector<Strip>> strips_;
};

std::vector<StationData> stations_of(std::span<Cuts> cuts, const std::vector<Grid>& grids, const Body& body) {
    std::vector<StationData> out;
    std::vector<double> shares;
    for (std::size_t p = 0; p < cuts.size(); ++p)
        for (Cuts::Strip& strip : cuts[p].strips(grids[p].along_span))
            for (const Slice& piece : strip.pieces.sliced(grids[p].along_chord)) {
                const double area = moments_of(piece.part).area;
                if (!(area > 1e-6 * body.area)) continue;
                out.push_back(station_of(piece.part, cuts[p].plan, grids[p], strip.node, piece.node, body));
                shares.push_back(area / body.area);
            }
    share_stokes_couple(out, shares, body.loads);
    return out;
}

std::vector<Wrench> sum_of_loads(const std::vector<StationData>& stations, const std::vector<Motion>& motions,
                                 double viscosity, double length) {
    std::vector<Wrench> out;
    for (const Motion& motion : motions) {
        Wrench sum = Wrench::Zero();
        for (const StationData& s : stations) sum += loads_of(s, motion, viscosity, length);
        out.push_back(sum);
    }
    return out;
}

// A plan cut in one way, with its loads.
struct Choice {
    Grid grid;
    std::vector<Wrench> loads;
};

template <class LoadsWith>
std::vector<Choice> choices_of(Cuts& cuts, std::size_t most, const LoadsWith& loads_with, const Body& body) {
    std::vector<Choice> out;
    const std::size_t least = cuts.plan.trails && most > 1 ? 2 : 1;
    for (std::size_t n = 1; n <= (cuts.plan.lump ? 1 : most); ++n)
        for (std::size_t chordwise = least; chordwise <= (cuts.plan.curved || cuts.plan.trails ? n : 1); ++chordwise)
            if (n % chordwise == 0) {
                const Grid grid{n / chordwise, chordwise};
                out.push_back({grid, loads_with(stations_of({&cuts, 1}, {grid}, body))});
            }
    return out;
}

// For each plan the first of about its size. Arms of a cross must be cut alike, or a symmetric body would have a preferred side.
std::vector<std::size_t> first_alike(const std::vector<Plan>& plans) {
    const auto close = [](double a, double b) { return std::abs(a - b) < 0.05 * a; };
    std::vector<std::size_t> out;
    for (const Plan& p : plans)
        out.push_back(static_cast<std::size_t>(std::find_if(plans.begin(), plans.end(),
                                                            [&](const Plan& q) {
                                                                return q.lump == p.lump && q.curved == p.curved &&
                                                                       q.trails == p.trails &&
                                                                       close(p.wing.area, q.wing.area) &&
                                                                       close(p.wing.span, q.wing.span) &&
                                                                       close(p.wing.chord, q.wing.chord);
                                                            }) -
                                               plans.begin()));
    return out;
}

// Of all combinations, the one of fewest stations with a good error, else the one of least error.
std::vector<Grid> best_grids(const std::vector<std::vector<Choice>>& choices, const std::vector<std::size_t>& like,
                             std::size_t most, const std::vector<Wrench>& reference) {
    std::vector<Grid> best, grids(choices.size());
    double least = 0.0;
    std::size_t fewest = 0;
    const auto visit = [&](const auto& self, std::size_t plan, std::size_t count,
                           const std::vector<Wrench>& sum) -> void {
        if (plan == choices.size()) {
            const double error = difference(sum, reference), counted = std::max(error, good_error);
            const bool better =
                counted < least * (1.0 - 1e-9) ||
                (counted <= least * (1.0 + 1e-9) && (count < fewest || (count == fewest && error < least)));
            if (!best.empty() && !better) return;
            best = grids;
            least = counted;
            fewest = count;
            return;
        }
        const std::size_t left = choices.size() - plan - 1;
        for (const Choice& choice : choices[plan]) {
            if (count + choice.grid.count() + left > most) continue;
            if (like[plan] < plan && !(choice.grid == grids[like[plan]])) continue;
            std::vector<Wrench> next = sum;
            for (std::size_t i = 0; i < next.size(); ++i) next[i] += choice.loads[i];
            grids[plan] = choice.grid;
            self(self, plan + 1, count + choice.grid.count(), next);
        }
    };
    visit(visit, 0, 0, std::vector<Wrench>(reference.size(), Wrench::Zero()));
    return best;
}

// One solid without hollows that is no plate: the cork of a shuttlecock, the stick of a toy propeller.
bool is_block(Part solids, double size) {
    find_open_sides(solids, size);
    const PartMoments m = moments_of(solids);
    double facing = 0.0;
    for (const Facet& f : solids) facing += f.area * (1.0 - f.open);
    return facing < self_facing * m.area && 1.0 - eigensystem(m.normals).values[2] > blocky;
}

// The lump, and all other faces: of a closed surface, or of the solids of a body with sheets.
std::pair<Part, Part> split_solids(const Part& all, double size) {
    Part solids, sheets;
    for (const Facet& f : all) (f.sides < 2.0 ? solids : sheets).push_back(f);
    if (solids.empty()) return {{}, std::move(sheets)};
    std::pair<Part, Part> out = split_lump(solids, size);
    if (!sheets.empty() && out.first.empty() && is_block(std::move(solids), size)) std::swap(out.first, out.second);
    out.second.insert(out.second.end(), sheets.begin(), sheets.end());
    return out;
}

// Share of the surface that other parts hide, as seen along the axes of the loads.
double share_hidden(const Part& part, const AerodynamicData& loads) {
    double seen = 0.0, faces = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vector3d n = row(loads.axes, k), x = row(loads.axes, (k + 1) % 3), y = row(loads.axes, (k + 2) % 3);
        std::vector<FlatTriangle> flat_faces;
        for (const Facet& f : part) {
            faces += f.area * std::abs(f.normal.dot(n));
            FlatTriangle t;
            for (std::size_t v = 0; v < 3; ++v) t[v] = {x.dot(f.at[v]), y.dot(f.at[v])};
            flat_faces.push_back(t);
        }
        seen += union_area(std::move(flat_faces));
    }
    return faces > 0.0 ? 1.0 - seen / faces : 0.0;
}
} // namespace

Stations make_stations(const Mesh& mesh, const AerodynamicData& loads, const Vector3d& center,
                       const StationOptions& options) {
    Stations out;
    Part all = part_of(mesh, options.solid_faces);
    const PartMoments m = moments_of(all);
    double size = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] = extent_of(all, row(loads.axes, k));
        size = std::max(size, high - low);
    }
    if (!(m.area > 0.0) || !(size > 0.0)) return out;
    const bool sheet = options.solid_faces == 0;
    if (!sheet && options.volume > thick * m.area * std::sqrt(m.area)) {
        if (options.volume < far_from_convex * options.hull_volume) out.fit = StationFit::hollow;
        return out;
    }
    const Vector3d normal = common_normal(m, row(loads.axes, broadside_of(loads)));
    const Part faces = faces_along(all, normal);
    const PartMoments along = moments_of(faces);
    const double tilt = 1.0 - normal.dot(along.normals * normal);
    const bool is_flat = tilt < flat && along.area > 0.9 * m.area;
    if (!is_flat && !sheet && options.volume > convex * options.hull_volume) return out;
    const Vector3d offset = along.centroid - normal.dot(along.centroid) * normal;
    if (is_flat && compactness(faces, normal) > least_compactness && offset.norm() < off_centre * size) return out;

    const Vector3d hollow = hollow_of(all, size);
    if (share_hidden(all, loads) > hiding && hollow.norm() < deep) {
        out.fit = StationFit::hidden;
        return out;
    }
    find_open_sides(all, size);

    std::vector<Plan> plans;
    // A plate of even thickness has no lump and no walls: long rays from its rim inwards are no thickness, and its rim is no plate.
    const auto [low, high] = extent_of(all, normal);
    const bool plate = !sheet && tilt < flat && options.volume > even * along.area * (high - low);
    auto [lump, rest] = plate ? std::pair{Part{}, std::move(all)} : split_solids(all, size);
    if (!lump.empty()) {
        plans.push_back(plan_of(std::move(lump), loads, size));
        plans.back().lump = true;
        plans.back().curved = false;
    }
    std::vector<Part> groups;
    for (Part& group : split_by_normal(std::move(rest), plate ? 1 : 4))
        for (Part& wall : split_walls(std::move(group))) groups.push_back(std::move(wall));
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const Vector3d n = common_normal(moments_of(groups[i]), normal);
        const std::size_t others = plans.size() + (groups.size() - 1 - i);
        const std::size_t most = options.most > others ? options.most - others : 1;
        for (Part& part : split_by_outline(std::move(groups[i]), n, most))
            plans.push_back(plan_of(std::move(part), loads, size));
    }
    join_arms(plans);
    const bool one_sided = offset.norm() > weight_aside * size;
    for (Plan& plan : plans) {
        plan.end_on = end_on_share(plan, normal);
        plan.trails = one_sided && !plan.lump && plan.wing.span > long_strip * plan.wing.chord &&
                      aside_of(plan) > 0.5 * (across_centre + behind_centre);
    }
    if (plans.size() > options.most) {
        out.fit = StationFit::coarse;
        return out;
    }
    const Body body{size, m.area, options, loads, hollow};
    std::vector<Grid> fine;
    for (const Plan& plan : plans)
        fine.push_back(plan.lump ? Grid{} : plan.curved || plan.trails ? Grid{8, 8} : Grid{32, 1});
    const std::vector<Motion> motions = test_motions(reynolds * options.viscosity / options.length, size);
    const auto loads_with = [&](const std::vector<StationData>& stations) {
        return sum_of_loads(stations, motions, options.viscosity, options.length);
    };
    std::vector<Cuts> cuts(plans.begin(), plans.end());
    const std::vector<Wrench> reference = loads_with(stations_of(cuts, fine, body));
    Vector3d lift;
    const StationData whole = as_station(loads, center, lift);
    std::vector<Wrench> loads_of_whole;
    for (const Motion& motion : motions)
        loads_of_whole.push_back(loads_of(whole, motion, options.viscosity, options.length, &lift));
    out.error_one = difference(loads_of_whole, reference);
    if (out.error_one <= good_error) return out;

    std::vector<std::vector<Choice>> choices;
    for (Cuts& plan : cuts) choices.push_back(choices_of(plan, options.most - plans.size() + 1, loads_with, body));
    const std::vector<Grid> grids = best_grids(choices, first_alike(plans), options.most, reference);
    std::vector<StationData> best = stations_of(cuts, grids, body);
    const double error = difference(loads_with(best), reference);
    if (best.size() < 2) return out;
    out.at = std::move(best);
    out.error = error;
    out.fit = error > bad_error ? StationFit::coarse : StationFit::fits;
    return out;
}

void share_added_mass(const AerodynamicData& loads, const std::array<double, 36>& added_mass,
                      std::vector<StationData>& stations) {
    const Vector3d n = row(loads.axes, broadside_of(loads));
    constexpr double least = 0.05; // least share of the sum, if all stations stand edgewise
    double whole = 0.0, sum = 0.0, all = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            whole += n[static_cast<Eigen::Index>(i)] * added_mass[6 * i + j] * n[static_cast<Eigen::Index>(j)];
    for (const StationData& s : stations) {
        const double cosine = row(s.axes, 2).dot(n);
        sum += s.separated_shedding * cosine * cosine;
        all += s.separated_shedding;
    }
    sum = std::max(sum, least * all);
    for (StationData& s : stations) {
        const double m = sum > 0.0 ? s.separated_shedding * whole / sum : 0.0;
        for (std::size_t k = 0; k < 2; ++k) {
            // Munk's moment m v_n v_t over the lift 1/2 plate_lift v_n v_t.
            const double most = 2.0 * std::abs(s.lift_arm[k]),
                         ahead = s.plate_lift[k] > 0.0 ? 2.0 * m / s.plate_lift[k] : 0.0;
            s.lift_arm[k] = ahead > 0.0 ? aft_share * std::clamp(ahead + s.lift_arm[k], -most, most) : 0.0;
        }
        s.separated_shedding = s.plate_drag > 0.0 ? shape::PlateCoefficients{}.separated_shedding * m : 0.0;
    }
}
} // namespace lr::baker
