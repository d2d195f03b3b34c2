#include "asset/asset_file.h"
#include "asset/closed_forms/ellipsoid_asset.h"
#include "base/bit_cast.h"
#include "base/fnv1a.h"
#include "base/matrix6.h"
#include "base/pose.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <type_traits>

namespace lr {
namespace {

class Checker {
public:
    explicit Checker(Faults& faults) : faults_(faults) {}

    void range(double value, const std::string& field, double low, double high) {
        if (!std::isfinite(value)) {
            fail(FaultId::asset_not_finite, field, "The value is not a finite number.");
        } else if (value < low || value > high) {
            fail(FaultId::asset_out_of_range, field,
                 "The value " + shortest(value) + " is outside " + shortest(low) + " to " + shortest(high) + ".");
        }
    }
    template <class Values> bool finite(const Values& values, const char* field) {
        for (size_t i = 0; i < values.size(); ++i)
            if (!std::isfinite(values[i])) {
                fail(FaultId::asset_not_finite, std::string(field) + "[" + std::to_string(i) + "]",
                     "The value is not a finite number.");
                return false;
            }
        return true;
    }
    // `n` rows, row-major; relative to the geometric mean of the diagonal entries.
    template <size_t N> void symmetric(const std::array<double, N>& m, size_t n, const char* field) {
        for (size_t i = 0; i < n; ++i)
            for (size_t j = 0; j < i; ++j) {
                const double a = m[i * n + j], b = m[j * n + i];
                const double size = std::sqrt(std::abs(m[i * n + i] * m[j * n + j])) + std::abs(a) + std::abs(b);
                if (std::abs(a - b) > 1e-6 * size)
                    return fail(FaultId::asset_not_symmetric, entry(field, i, j), "The matrix is not symmetric.");
            }
    }
    void fail(FaultId id, std::string where, std::string what) {
        ok_ = lr::fail(faults_, id, std::move(where), std::move(what));
    }
    static std::string entry(const char* field, size_t i, size_t j) {
        return std::string(field) + "[" + std::to_string(i) + "][" + std::to_string(j) + "]";
    }
    bool ok() const { return ok_; }

private:
    Faults& faults_;
    bool ok_ = true;
};

void check_matrices(const AssetData& d, Checker& check) {
    if (!check.finite(d.inertia, "inertia") || !check.finite(d.added_mass, "added_mass") ||
        !check.finite(d.added_mass_error, "added_mass_error"))
        return;
    check.symmetric(d.inertia, 3, "inertia");
    check.symmetric(d.added_mass, 6, "added_mass");
    if (!check.ok()) return;

    // In units of the body: 1e-10 is far above rounding, and below the thinnest needle that an ellipsoid can be.
    Matrix6 body = rigid_mass_matrix(d.mass, d.inertia);
    scale_to_unit(body, d.mass, d.length_d);
    for (size_t i = 3; i < 6; ++i)
        if (!(body[i * 6 + i] > 1e-10 && body[i * 6 + i] < 10.0))
            return check.fail(FaultId::asset_out_of_range, Checker::entry("inertia", i - 3, i - 3),
                              "The moment of inertia does not fit the mass and the length d.");
    if (!is_positive_definite(body, 1e-10))
        return check.fail(FaultId::asset_not_positive, "inertia", "The inertia is not positive definite.");
    Matrix6 added = d.added_mass;
    const double unit = d.volume + d.projected_area * d.length_d;
    scale_to_unit(added, unit, d.length_d);
    for (double v : added)
        if (std::abs(v) > 100.0)
            return check.fail(FaultId::asset_out_of_range, "added_mass",
                              "An entry is far too large for a body of this size.");
    // Semi-definite: about an axis of revolution the added inertia is zero, and a solver's error can make it slightly negative.
    for (size_t i = 0; i < 6; ++i) added[i * 6 + i] += 1e-5;
    if (!is_positive_definite(added, 0.0))
        check.fail(FaultId::asset_not_positive, "added_mass", "The added mass is not positive semi-definite.");
}

void check_table(const TurbulenceData& t, Checker& check) {
    if (t.chi.empty() || t.chi.size() > 65536)
        return check.fail(FaultId::asset_wrong_length, "turbulence.chi",
                          "A table has 1 to 65536 samples, not " + std::to_string(t.chi.size()) + ".");
    if (t.epsilon.size() != t.chi.size())
        return check.fail(FaultId::asset_wrong_length, "turbulence.epsilon",
                          "It has " + std::to_string(t.epsilon.size()) + " samples, chi has " +
                              std::to_string(t.chi.size()) + ".");
    if (!check.finite(t.chi, "turbulence.chi") || !check.finite(t.epsilon, "turbulence.epsilon")) return;
    for (size_t i = 0; i < t.chi.size(); ++i)
        if (t.chi[i] < 0.0 || t.chi[i] > 1e4 || t.epsilon[i] < 0.0 || t.epsilon[i] > 1e6)
            return check.fail(FaultId::asset_out_of_range, "turbulence[" + std::to_string(i) + "]",
                              "chi* lies within 0 to 1e4 and epsilon* within 0 to 1e6.");
    if (t.stationary >= t.chi.size())
        check.fail(FaultId::asset_out_of_range, "turbulence.stationary", "It points past the end of the table.");
    if (t.loop_begin > t.loop_end || t.loop_end > t.chi.size())
        check.fail(FaultId::asset_out_of_range, "turbulence.loop", "It ends before it begins, or past the table.");
    for (double side : t.domain) check.range(side, "turbulence.domain", 0.0, 1e9);
#define LR_NUMBER(name, least, most) check.range(static_cast<double>(t.name), "turbulence." #name, least, most);
    LR_TURBULENCE_NUMBERS(LR_NUMBER)
#undef LR_NUMBER
}

// A directed edge of a triangle, with its third vertex.
struct Edge {
    uint32_t from, to, opposite;
    size_t triangle;
};
bool before(const Edge& a, const Edge& b) {
    return a.from != b.from ? a.from < b.from : a.to < b.to;
}

} // namespace

std::optional<HullFlaw> find_hull_flaw(const HullData& hull, double length) {
    using Result = std::optional<HullFlaw>;
    const auto flaw = [&](size_t triangle, FaultId id, const char* what) { return Result({triangle, id, what}); };
    const auto open = [&](size_t triangle) {
        return flaw(triangle, FaultId::asset_open_hull,
                    "An edge does not have exactly two triangles, one on each side.");
    };
    const auto vertex = [&](uint32_t i) { return to_double(vector_of(hull.vertices.data() + 3 * size_t{i})); };
    std::vector<Edge> edges;
    edges.reserve(hull.triangles.size());
    double volume = 0.0; // six times
    for (size_t t = 0; t + 2 < hull.triangles.size(); t += 3) {
        const uint32_t* const corner = hull.triangles.data() + t;
        if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) return open(t / 3);
        for (size_t k = 0; k < 3; ++k) edges.push_back({corner[k], corner[(k + 1) % 3], corner[(k + 2) % 3], t / 3});
        volume += dot(vertex(corner[0]), cross(vertex(corner[1]), vertex(corner[2])));
    }
    std::sort(edges.begin(), edges.end(), before);
    for (size_t i = 0; i < edges.size(); ++i) {
        const Edge& edge = edges[i];
        if (i + 1 < edges.size() && !before(edge, edges[i + 1])) return open(edge.triangle);
        const Edge back{edge.to, edge.from, 0, 0};
        const auto found = std::lower_bound(edges.begin(), edges.end(), back, before);
        if (found == edges.end() || before(back, *found)) return open(edge.triangle);
    }
    if (volume < -1e-9 * length * length * length)
        return flaw(0, FaultId::asset_hull_not_convex, "The triangles face inward.");
    for (const Edge& edge : edges) {
        const auto found = std::lower_bound(edges.begin(), edges.end(), Edge{edge.to, edge.from, 0, 0}, before);
        // Slivers have no meaningful normal.
        const Double3 a = vertex(edge.from), normal = cross(vertex(edge.to) - a, vertex(edge.opposite) - a);
        const double size = lr::length(normal);
        if (size > 1e-6 * length * length && dot(normal, vertex(found->opposite) - a) > 1e-4 * length * size)
            return flaw(edge.triangle, FaultId::asset_hull_not_convex, "The hull is not convex here.");
    }
    return {};
}

namespace {
void check_hull(const AssetData& d, Checker& check) {
    const HullData& h = d.hull;
    if (h.vertices.empty() && h.triangles.empty()) return;
    if (h.vertices.size() % 3 != 0 || h.triangles.size() % 3 != 0 || h.vertices.size() < 12 || h.triangles.size() < 12)
        return check.fail(FaultId::asset_bad_hull, "hull", "A hull has at least four vertices and four triangles.");
    if (!check.finite(h.vertices, "hull.vertices")) return;
    const double reach = 2.0 * d.length_d + 1e-12;
    for (size_t i = 0; i < h.vertices.size(); ++i)
        if (std::abs(static_cast<double>(h.vertices[i])) > reach)
            return check.fail(FaultId::asset_bad_hull, "hull.vertices[" + std::to_string(i) + "]",
                              "The vertex lies far outside the body's largest extent.");
    for (size_t i = 0; i < h.triangles.size(); ++i)
        if (h.triangles[i] >= h.vertices.size() / 3)
            return check.fail(FaultId::asset_bad_hull, "hull.triangles[" + std::to_string(i) + "]",
                              "The index is past the last vertex.");
    if (const auto flaw = find_hull_flaw(h, d.length_d))
        check.fail(flaw->id, "hull.triangles[" + std::to_string(3 * flaw->triangle) + "]", flaw->what);
}

template <class Loads> struct Coefficient {
    double Loads::*number;
    std::array<double, 3> Loads::*vector;
    const char* name;
    double least, most, power;
};
#define LR_VECTOR(name, least, most, power) {nullptr, &Loads::name, "." #name, least, most, power},
#define LR_NUMBER(name, least, most, power) {&Loads::name, nullptr, "." #name, least, most, power},
template <class Loads> constexpr auto coefficients_of() {
    if constexpr (std::is_same_v<Loads, StationData>)
        return std::to_array<Coefficient<Loads>>({LR_STATION_VECTORS(LR_VECTOR) LR_STATION_NUMBERS(LR_NUMBER)});
    else
        return std::to_array<Coefficient<Loads>>({LR_AERODYNAMIC_VECTORS(LR_VECTOR) LR_AERODYNAMIC_NUMBERS(LR_NUMBER)});
}
#undef LR_VECTOR
#undef LR_NUMBER
template <class Loads> constexpr auto coefficients = coefficients_of<Loads>();

template <class Loads> void check_loads(const Loads& loads, const std::string& where, double d, Checker& check) {
    if (!check.finite(loads.axes, (where + ".axes").c_str())) return;
    if (!is_rotation(loads.axes, 1e-9))
        check.fail(FaultId::asset_bad_axes, where + ".axes",
                   "The axes are not three orthogonal unit vectors, right-handed.");
    for (const auto& c : coefficients<Loads>) {
        double unit = 1.0;
        for (int halves = static_cast<int>(2.0 * c.power); halves > 0; halves -= 2)
            unit *= halves == 1 ? std::sqrt(d) : d;
        if (c.number) check.range(loads.*c.number, where + c.name, c.least * unit, c.most * unit);
        for (size_t k = 0; c.vector && k < 3; ++k)
            check.range((loads.*c.vector)[k], where + c.name + "[" + std::to_string(k) + "]", c.least * unit,
                        c.most * unit);
    }
}

void check_stations(const AssetData& d, Checker& check) {
    const size_t count = d.stations.size();
    if (count == 1 || count > most_stations)
        check.fail(FaultId::asset_wrong_length, "stations",
                   "A body has no stations or 2 to " + std::to_string(most_stations) + ".");
    for (size_t i = 0; i < count && check.ok(); ++i)
        check_loads(d.stations[i], "stations[" + std::to_string(i) + "]", d.length_d, check);
}

template <class Loads, class Number, class Vector>
void each_coefficient(const Loads& loads, const Number& number, const Vector& vector) {
    vector(loads.axes);
    for (const auto& c : coefficients<Loads>)
        if (c.number)
            number(loads.*c.number);
        else
            vector(loads.*c.vector);
}

struct Number {
    double AssetData::*value;
    const char* name;
    double least, most;
};
constexpr Number numbers[] = {{&AssetData::mass, "mass", 1e-18, 1e12},
                              {&AssetData::volume, "volume", 1e-21, 1e12},
                              {&AssetData::density, "density", 1e-6, 1e6},
                              {&AssetData::fluid_density, "fluid.density", 1e-6, 1e6},
                              {&AssetData::fluid_viscosity, "fluid.viscosity", 1e-12, 1e6},
                              {&AssetData::length_d, "lengths.d", 1e-7, 1e4},
                              {&AssetData::length_b, "lengths.b", 1e-9, 1e4},
                              {&AssetData::length_l, "lengths.l", 1e-9, 1e4},
                              {&AssetData::projected_area, "projected_area", 1e-15, 1e9},
                              {&AssetData::u0, "u0", 1e-9, 1e6}};
} // namespace

const char* wrong_in(const AerodynamicData& a) {
    // The size limit of 1000 m bounds lengths to the fifth power. 1e-6: callers can have single precision.
    if (!is_rotation(a.axes, 1e-6)) return "axes are no right-handed, orthogonal unit vectors";
    for (const auto& c : coefficients<AerodynamicData>) {
        const double unit = c.power == 0.0 ? 1.0 : 1e10;
        const auto within = [&](double v) { return v >= c.least * unit && v <= c.most * unit; }; // false for NaN
        if (c.number ? within(a.*c.number) : std::all_of((a.*c.vector).begin(), (a.*c.vector).end(), within)) continue;
        static thread_local char why[64];
        std::snprintf(why, sizeof why, "%s is out of range", c.name + 1);
        return why;
    }
    return nullptr;
}

bool check_asset(const AssetData& d, Faults& faults) {
    Checker check(faults);
    for (const Number& n : numbers) check.range(d.*n.value, n.name, n.least, n.most);
    check.finite(d.center_of_mass, "center_of_mass");
    check.finite(d.center_of_buoyancy, "center_of_buoyancy");
    if (!check.ok()) return false;

    if (std::abs(d.mass - d.density * d.volume) > 1e-6 * d.mass)
        check.fail(FaultId::asset_inconsistent, "mass", "Mass is not density times volume.");
    for (double c : d.center_of_buoyancy)
        if (std::abs(c) > 2.0 * d.length_d)
            check.fail(FaultId::asset_out_of_range, "center_of_buoyancy", "It lies far outside the body.");
    if (d.name.size() > 4096) check.fail(FaultId::asset_out_of_range, "name", "The name is longer than 4096 bytes.");
    check_matrices(d, check);
    check_table(d.turbulence, check);
    check_hull(d, check);
    check_loads(d.aerodynamics, "aerodynamics", d.length_d, check);
    check_stations(d, check);
    return check.ok();
}

// Refuses combinations that no body has, though each number alone is possible.
namespace {

// The second moments of mass, trace/2 - I, are sums of squares. Those across a flat body are zero, and rounding can make them slightly negative.
bool has_moments_of_mass(const AssetData& d) {
    const double half_trace = 0.5 * (d.inertia[0] + d.inertia[4] + d.inertia[8]);
    std::array<double, 9> moments{};
    for (size_t i = 0; i < 9; ++i) moments[i] = (i % 4 == 0 ? 1.0 + 1e-6 : 0.0) - d.inertia[i] / half_trace;
    return is_positive_definite(rigid_mass_matrix(1.0, moments), 0.0);
}

// Mass must not lie on a line: about any axis its radius of gyration is at least a hundredth of the thickness.
bool has_spread(const AssetData& d) {
    const double least = 1e-4 * d.mass * d.length_b * d.length_b, size = d.inertia[0] + d.inertia[4] + d.inertia[8];
    std::array<double, 9> beyond{};
    for (size_t i = 0; i < 9; ++i) beyond[i] = (d.inertia[i] - (i % 4 == 0 ? least : 0.0)) / size;
    return is_positive_definite(rigid_mass_matrix(1.0, beyond), 0.0);
}

// Along the body axes; d itself can lie across them.
double extent(const HullData& hull) {
    double largest = 0.0;
    for (size_t axis = 0; axis < 3; ++axis) {
        float low = hull.vertices[axis], high = low;
        for (size_t i = axis; i < hull.vertices.size(); i += 3)
            low = std::min(low, hull.vertices[i]), high = std::max(high, hull.vertices[i]);
        largest = std::max(largest, static_cast<double>(high) - static_cast<double>(low));
    }
    return largest;
}
} // namespace

bool check_plausible(const AssetData& d, Faults& faults) {
    const size_t before = faults.size();
    const auto unfit = [&](const char* where, const char* what) {
        fail(faults, FaultId::asset_inconsistent, where, what);
    };
    const double d1 = d.length_d, d2 = d1 * d1;
    // Ten cubes of side d: layers of a folded sheet can displace more than their hull contains.
    if (d.volume > 10.0 * d2 * d1) unfit("volume", "The volume is far too large for the length d.");
    if (d.projected_area > 10.0 * d2) unfit("projected_area", "The area is far too large for the length d.");
    if (d.length_b > 10.0 * d1) unfit("lengths.b", "The thickness is far larger than the length d.");
    if (d.length_l > 10.0 * d1) unfit("lengths.l", "The turbulence length is far larger than the length d.");
    // Paper Eq. 1: the scale of the body's turbulence.
    const double u0 = shape::speed_scale(d.density, d.fluid_density, d.length_b);
    if (d.u0 > 10.0 * u0 || d.u0 < 0.1 * u0) unfit("u0", "The speed does not fit the densities and the thickness.");
    if (!has_moments_of_mass(d))
        unfit("inertia",
              "A principal moment of inertia is larger than the other two together: no mass distribution has that.");
    if (!has_spread(d)) unfit("inertia", "A moment of inertia is far too small for the thickness.");
    if (!d.hull.vertices.empty() && extent(d.hull) < 0.5 * d1)
        unfit("hull.vertices", "The hull is far smaller than the length d.");
    return faults.size() == before;
}

uint64_t content_hash(const AssetData& d) {
    Fnv1a hash;
    const auto number = [&](double v) { hash.add_u64(bit_cast<uint64_t>(v)); };
    const auto all = [&](const auto& values) {
        hash.add_u64(values.size());
        for (auto v : values) number(static_cast<double>(v));
    };
    for (const Number& n : numbers) number(d.*n.value);
    number(d.turbulence.dt);
    number(d.turbulence.c0);
    all(d.center_of_mass);
    all(d.center_of_buoyancy);
    all(d.inertia);
    all(d.added_mass);
    all(d.turbulence.chi);
    all(d.turbulence.epsilon);
    hash.add_u64(d.turbulence.stationary);
    all(d.hull.vertices);
    hash.add_u64(d.hull.triangles.size());
    for (uint32_t i : d.hull.triangles) hash.add_u64(i);
    each_coefficient(d.aerodynamics, number, all);
    for (const StationData& station : d.stations) each_coefficient(station, number, all);
    return hash.value();
}

double largest_coupling(const AssetData& a) {
    double largest = 0.0;
    for (const double c : a.center_of_buoyancy) largest = std::max(largest, std::abs(c) / a.length_d);
    for (const double c : a.aerodynamics.center) largest = std::max(largest, std::abs(c) / a.length_d);
    const auto relative = [](double off, double x, double y) { return std::abs(off) / std::sqrt(std::abs(x * y)); };
    // About an axis of revolution the added inertia vanishes, so the scale includes the body's own inertia.
    const auto size = [&](std::size_t n) {
        return a.added_mass[n * 7] + (n < 3 ? a.volume : a.inertia[(n - 3) * 4] / a.density);
    };
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < i; ++j) {
            largest = std::max(largest, relative(a.added_mass[i * 6 + j], size(i), size(j)));
            if (j >= 3)
                largest = std::max(
                    largest, relative(a.inertia[(i - 3) * 3 + j - 3], a.inertia[(i - 3) * 4], a.inertia[(j - 3) * 4]));
        }
    return largest;
}

size_t widest_axis(const AerodynamicData& loads) {
    size_t widest = 2;
    for (size_t i : {size_t{1}, size_t{0}})
        if (loads.broadside[i] > loads.broadside[widest]) widest = i;
    return widest;
}

std::array<double, 36> mirror_odd(const std::array<double, 36>& matrix, const AerodynamicData& loads) {
    const double* const n = loads.axes.data() + 3 * widest_axis(loads);
    // Half of M - S M S, where S reflects velocities, 1 - 2 n n^T, and spins with the opposite sign.
    Matrix6 s{}, odd;
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) {
            s[i * 6 + j] = (i == j ? 1.0 : 0.0) - 2.0 * n[i] * n[j];
            s[(i + 3) * 6 + j + 3] = -s[i * 6 + j];
        }
    const Matrix6 mirrored = product(product(s, matrix), s);
    for (size_t i = 0; i < 36; ++i) odd[i] = 0.5 * (matrix[i] - mirrored[i]);
    return odd;
}

double mirror_coupling(const AssetData& a, const AerodynamicData& loads) {
    Matrix6 mass = rigid_mass_matrix(a.mass, a.inertia);
    for (size_t i = 0; i < 36; ++i) mass[i] += a.fluid_density * a.added_mass[i];
    const std::array<double, 36> odd = mirror_odd(mass, loads);
    double largest = 0.0, buoyancy = 0.0, center = 0.0;
    for (size_t i = 0; i < 36; ++i)
        largest = std::max(largest, std::abs(odd[i]) / std::sqrt(mass[i / 6 * 7] * mass[i % 6 * 7]));
    for (size_t k = 0; k < 3; ++k) {
        const double n = loads.axes[3 * widest_axis(loads) + k];
        buoyancy += n * a.center_of_buoyancy[k];
        center += n * loads.center[k];
    }
    return std::max({largest, std::abs(buoyancy) / a.length_d, std::abs(center) / a.length_d});
}
} // namespace lr
