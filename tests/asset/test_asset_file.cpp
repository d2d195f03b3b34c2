// Writing, reading back, and every invalid number: each with its own fault, named by its field.
#include "asset/asset_file.h"
#include "baker/fault_text.h"

#include "support/asset_bytes.h"
#include "support/quick.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>

using namespace lr;

namespace {

const double not_a_number = std::numeric_limits<double>::quiet_NaN(),
             infinite = std::numeric_limits<double>::infinity();

// Every coefficient, by its name in the file, with its limits: numbers have size 1.
struct Coefficient {
    const char* name;
    std::function<double*(AerodynamicData&)> at;
    size_t size;
    double least, most, power;
};
std::vector<Coefficient> coefficients() {
#define LR_VECTOR(name, least, most, power)                                                                            \
    {#name, [](AerodynamicData& a) { return a.name.data(); }, 3, least, most, power},
#define LR_NUMBER(name, least, most, power) {#name, [](AerodynamicData& a) { return &a.name; }, 1, least, most, power},
    return {LR_AERODYNAMIC_VECTORS(LR_VECTOR) LR_AERODYNAMIC_NUMBERS(LR_NUMBER)};
#undef LR_VECTOR
#undef LR_NUMBER
}

struct StationCoefficient {
    const char* name;
    std::function<double*(StationData&)> at;
    size_t size;
    double least, most, power;
};
std::vector<StationCoefficient> station_coefficients() {
#define LR_VECTOR(name, least, most, power)                                                                            \
    {#name, [](StationData& s) { return s.name.data(); }, 3, least, most, power},
#define LR_NUMBER(name, least, most, power) {#name, [](StationData& s) { return &s.name; }, 1, least, most, power},
    return {LR_STATION_VECTORS(LR_VECTOR) LR_STATION_NUMBERS(LR_NUMBER)};
#undef LR_VECTOR
#undef LR_NUMBER
}

bool same(const StationData& a, const StationData& b) {
#define LR_SAME(name, ...) &&a.name == b.name
    return a.axes == b.axes LR_STATION_VECTORS(LR_SAME) LR_STATION_NUMBERS(LR_SAME);
#undef LR_SAME
}

bool same(const AerodynamicData& a, const AerodynamicData& b) {
#define LR_SAME(name, ...) &&a.name == b.name
    return a.axes == b.axes LR_AERODYNAMIC_VECTORS(LR_SAME) LR_AERODYNAMIC_NUMBERS(LR_SAME);
#undef LR_SAME
}

bool same(const AssetData& a, const AssetData& b) {
    const auto hull = a.hull.vertices == b.hull.vertices && a.hull.triangles == b.hull.triangles;
    const auto& p = a.provenance;
    const auto& q = b.provenance;
    return a.name == b.name && a.mass == b.mass && a.volume == b.volume && a.density == b.density &&
           a.center_of_mass == b.center_of_mass && a.center_of_buoyancy == b.center_of_buoyancy &&
           a.inertia == b.inertia && a.added_mass == b.added_mass && a.added_mass_error == b.added_mass_error &&
           a.fluid_density == b.fluid_density && a.fluid_viscosity == b.fluid_viscosity && a.length_d == b.length_d &&
           a.length_b == b.length_b && a.length_l == b.length_l && a.projected_area == b.projected_area &&
           a.u0 == b.u0 && a.turbulence.dt == b.turbulence.dt && a.turbulence.chi == b.turbulence.chi &&
           a.turbulence.epsilon == b.turbulence.epsilon && a.turbulence.stationary == b.turbulence.stationary &&
           a.turbulence.c0 == b.turbulence.c0 && a.turbulence.intensity == b.turbulence.intensity &&
           a.turbulence.cells == b.turbulence.cells && a.turbulence.loop_begin == b.turbulence.loop_begin &&
           a.turbulence.loop_end == b.turbulence.loop_end && a.turbulence.wake == b.turbulence.wake &&
           a.turbulence.settled == b.turbulence.settled && a.turbulence.domain == b.turbulence.domain &&
           a.turbulence.max_divergence == b.turbulence.max_divergence && hull && p.tool == q.tool &&
           p.tool_version == q.tool_version && p.source == q.source && p.input_hash == q.input_hash &&
           p.options == q.options && p.faces == q.faces && p.vertices == q.vertices &&
           same(a.aerodynamics, b.aerodynamics) &&
           std::equal(a.stations.begin(), a.stations.end(), b.stations.begin(), b.stations.end(),
                      [](const StationData& x, const StationData& y) { return same(x, y); });
}

} // namespace

TEST_CASE("written data is read back, the same bytes for the same data") {
    AssetData d = test::leaf_data();
    d.turbulence.stationary = 3;
    d.turbulence.cells = {32, 32, 16};
    d.turbulence.loop_begin = 2;
    d.turbulence.loop_end = 4;
    d.turbulence.wake = true;
    d.turbulence.settled = false;
    d.turbulence.domain = {5.0, 4.0, 3.0};
    d.turbulence.max_divergence = 1e-7;
    d.added_mass_error[7] = 1e-9;
    d.aerodynamics.axes = {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0};
    double next = 1e-13; // all different, and allowed for a body of this size
    for (const Coefficient& c : coefficients())
        for (size_t k = 0; k < c.size; ++k) c.at(d.aerodynamics)[k] = c.least > 0.0 ? c.least + next : next += 1e-13;
    d.stations = test::winged_data().stations;
    d.stations[1].axes = {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0};
    for (StationData& s : d.stations)
        for (const StationCoefficient& c : station_coefficients())
            for (size_t k = 0; k < c.size; ++k) c.at(s)[k] = c.least > 0.0 ? c.least + next : next += 1e-13;
    const std::vector<uint8_t> bytes = write_asset(d);
    CHECK(write_asset(d) == bytes);
    CHECK(std::memcmp(bytes.data() + 4, "LRBA", 4) == 0);
    AssetData back;
    Faults faults;
    REQUIRE(read_asset(bytes.data(), bytes.size(), back, faults));
    CHECK(faults.empty());
    CHECK(same(d, back));
    CHECK(content_hash(back) == content_hash(d));
    CHECK(write_asset(back) == bytes);
}

TEST_CASE("the content hash sees everything that moves a body, and no names") {
    const AssetData d = test::leaf_data();
    const uint64_t hash = content_hash(d);
    const std::function<void(AssetData&)> matter[] = {
        [](AssetData& a) { a.mass += 1e-9; },
        [](AssetData& a) { a.volume += 1e-12; },
        [](AssetData& a) { a.center_of_mass[1] = 1e-9; },
        [](AssetData& a) { a.center_of_buoyancy[2] = 1e-9; },
        [](AssetData& a) { a.inertia[4] *= 1.001; },
        [](AssetData& a) { a.added_mass[35] += 1e-20; },
        [](AssetData& a) { a.fluid_density = 2.0; },
        [](AssetData& a) { a.fluid_viscosity = 1.0; },
        [](AssetData& a) { a.length_d += 0.1; },
        [](AssetData& a) { a.length_l += 0.1; },
        [](AssetData& a) { a.u0 += 0.1; },
        [](AssetData& a) { a.turbulence.chi[9] += 0.1; },
        [](AssetData& a) { a.turbulence.epsilon[0] += 0.1; },
        [](AssetData& a) { a.turbulence.stationary = 1; },
        [](AssetData& a) { a.turbulence.c0 = 1.0; },
        [](AssetData& a) { a.turbulence.dt *= 2.0; },
        [](AssetData& a) { std::swap(a.aerodynamics.axes[0], a.aerodynamics.axes[1]); },
        [](AssetData& a) { a.hull.vertices[0] += 0.1f; },
        [](AssetData& a) { std::swap(a.hull.triangles[0], a.hull.triangles[1]); }};
    for (const auto& change : matter) {
        AssetData other = d;
        change(other);
        CHECK(content_hash(other) != hash);
    }
    for (const Coefficient& c : coefficients())
        for (size_t k = 0; k < c.size; ++k) {
            AssetData other = d;
            c.at(other.aerodynamics)[k] += 1e-3;
            CAPTURE(c.name);
            CHECK(content_hash(other) != hash);
        }
    const AssetData winged = test::winged_data();
    for (size_t i = 0; i < winged.stations.size(); ++i) {
        const auto changed = [&](const std::function<void(StationData&)>& change) {
            AssetData other = winged;
            change(other.stations[i]);
            return content_hash(other) != content_hash(winged);
        };
        for (const StationCoefficient& c : station_coefficients())
            for (size_t k = 0; k < c.size; ++k) {
                CAPTURE(c.name);
                CHECK(changed([&](StationData& s) { c.at(s)[k] += 1e-3; }));
            }
        for (size_t k = 0; k < 9; ++k) CHECK(changed([&](StationData& s) { s.axes[k] += 1e-3; }));
    }
    AssetData without = winged, swapped = winged;
    without.stations.clear();
    std::swap(swapped.stations[0], swapped.stations[1]);
    CHECK(content_hash(without) != content_hash(winged));
    CHECK(content_hash(swapped) != content_hash(winged));
    AssetData renamed = d;
    renamed.name = "other";
    renamed.provenance.source = "elsewhere.obj";
    CHECK(content_hash(renamed) == hash);
}

TEST_CASE("each impossible number has its fault, at its field") {
    struct Case {
        FaultId id;
        std::string where;
        std::function<void(AssetData&)> change;
    };
    std::vector<Case> cases = {
        {FaultId::asset_not_finite, "mass", [](AssetData& a) { a.mass = not_a_number; }},
        {FaultId::asset_out_of_range, "mass", [](AssetData& a) { a.mass = -1.0; }},
        {FaultId::asset_out_of_range, "volume", [](AssetData& a) { a.volume = 0.0; }},
        {FaultId::asset_not_finite, "density", [](AssetData& a) { a.density = infinite; }},
        {FaultId::asset_out_of_range, "fluid.density", [](AssetData& a) { a.fluid_density = 0.0; }},
        {FaultId::asset_out_of_range, "fluid.viscosity", [](AssetData& a) { a.fluid_viscosity = -1.0; }},
        {FaultId::asset_out_of_range, "lengths.d", [](AssetData& a) { a.length_d = 0.0; }},
        {FaultId::asset_out_of_range, "lengths.b", [](AssetData& a) { a.length_b = 1e9; }},
        {FaultId::asset_not_finite, "lengths.l", [](AssetData& a) { a.length_l = not_a_number; }},
        {FaultId::asset_out_of_range, "projected_area", [](AssetData& a) { a.projected_area = -1.0; }},
        {FaultId::asset_out_of_range, "u0", [](AssetData& a) { a.u0 = 0.0; }},
        {FaultId::asset_not_finite, "center_of_mass[1]", [](AssetData& a) { a.center_of_mass[1] = not_a_number; }},
        {FaultId::asset_not_finite, "center_of_buoyancy[2]", [](AssetData& a) { a.center_of_buoyancy[2] = infinite; }},
        {FaultId::asset_out_of_range, "center_of_buoyancy", [](AssetData& a) { a.center_of_buoyancy[2] = 9.0; }},
        {FaultId::asset_inconsistent, "mass", [](AssetData& a) { a.mass *= 1.1; }},
        {FaultId::asset_not_finite, "inertia[8]", [](AssetData& a) { a.inertia[8] = not_a_number; }},
        {FaultId::asset_not_symmetric, "inertia[1][0]", [](AssetData& a) { a.inertia[1] += 0.1 * a.inertia[0]; }},
        {FaultId::asset_out_of_range, "inertia[0][0]", [](AssetData& a) { a.inertia[0] = 0.0; }},
        {FaultId::asset_out_of_range, "inertia[2][2]", [](AssetData& a) { a.inertia[8] *= 1e6; }},
        {FaultId::asset_not_positive, "inertia",
         [](AssetData& a) { a.inertia[1] = a.inertia[3] = 2.0 * std::sqrt(a.inertia[0] * a.inertia[4]); }},
        {FaultId::asset_inconsistent, "inertia",
         [](AssetData& a) { a.inertia[8] = 1.001 * (a.inertia[0] + a.inertia[4]); }},
        {FaultId::asset_inconsistent, "inertia",
         [](AssetData& a) {
             a.length_b = a.length_d; // a ball with all its mass in a wire
             a.u0 *= 3.0;
             a.inertia[0] = 9e-5 * a.mass * a.length_b * a.length_b;
             a.inertia[8] = a.inertia[4];
         }},
        {FaultId::asset_inconsistent, "volume",
         [](AssetData& a) { a.density = a.mass / (a.volume = 11.0 * std::pow(a.length_d, 3.0)); }},
        {FaultId::asset_inconsistent, "projected_area",
         [](AssetData& a) { a.projected_area = 11.0 * a.length_d * a.length_d; }},
        {FaultId::asset_inconsistent, "lengths.b", [](AssetData& a) { a.length_b = 11.0 * a.length_d; }},
        {FaultId::asset_inconsistent, "lengths.l", [](AssetData& a) { a.length_l = 11.0 * a.length_d; }},
        {FaultId::asset_inconsistent, "u0", [](AssetData& a) { a.u0 *= 11.0; }},
        {FaultId::asset_inconsistent, "u0", [](AssetData& a) { a.u0 /= 11.0; }},
        {FaultId::asset_inconsistent, "hull.vertices",
         [](AssetData& a) {
             for (float& v : a.hull.vertices) v *= 0.4f;
         }},
        {FaultId::asset_not_finite, "added_mass[0]", [](AssetData& a) { a.added_mass[0] = not_a_number; }},
        {FaultId::asset_not_symmetric, "added_mass[3][1]",
         [](AssetData& a) { a.added_mass[9] += a.added_mass[7] * 0.01; }},
        {FaultId::asset_not_positive, "added_mass", [](AssetData& a) { a.added_mass[14] = -a.added_mass[14]; }},
        {FaultId::asset_out_of_range, "added_mass", [](AssetData& a) { a.added_mass[14] *= 1e6; }},
        {FaultId::asset_not_finite, "added_mass_error[3]", [](AssetData& a) { a.added_mass_error[3] = not_a_number; }},
        {FaultId::asset_wrong_length, "turbulence.chi", [](AssetData& a) { a.turbulence.chi.clear(); }},
        {FaultId::asset_wrong_length, "turbulence.chi", [](AssetData& a) { a.turbulence.chi.resize(65537, 1.0); }},
        {FaultId::asset_wrong_length, "turbulence.epsilon", [](AssetData& a) { a.turbulence.epsilon.pop_back(); }},
        {FaultId::asset_not_finite, "turbulence.chi[4]", [](AssetData& a) { a.turbulence.chi[4] = not_a_number; }},
        {FaultId::asset_not_finite, "turbulence.epsilon[0]", [](AssetData& a) { a.turbulence.epsilon[0] = infinite; }},
        {FaultId::asset_out_of_range, "turbulence[7]", [](AssetData& a) { a.turbulence.chi[7] = -1.0; }},
        {FaultId::asset_out_of_range, "turbulence.stationary", [](AssetData& a) { a.turbulence.stationary = 256; }},
        {FaultId::asset_out_of_range, "turbulence.loop", [](AssetData& a) { a.turbulence.loop_begin = 1; }},
        {FaultId::asset_out_of_range, "turbulence.loop", [](AssetData& a) { a.turbulence.loop_end = 257; }},
        {FaultId::asset_out_of_range, "turbulence.domain", [](AssetData& a) { a.turbulence.domain[1] = -1.0; }},
        {FaultId::asset_out_of_range, "turbulence.dt", [](AssetData& a) { a.turbulence.dt = 0.0; }},
        {FaultId::asset_out_of_range, "turbulence.c0", [](AssetData& a) { a.turbulence.c0 = -1.0; }},
        {FaultId::asset_not_finite, "turbulence.intensity",
         [](AssetData& a) { a.turbulence.intensity = not_a_number; }},
        {FaultId::asset_bad_hull, "hull", [](AssetData& a) { a.hull.vertices.resize(6); }},
        {FaultId::asset_bad_hull, "hull", [](AssetData& a) { a.hull.triangles.pop_back(); }},
        {FaultId::asset_not_finite, "hull.vertices[5]",
         [](AssetData& a) { a.hull.vertices[5] = std::numeric_limits<float>::quiet_NaN(); }},
        {FaultId::asset_bad_hull, "hull.vertices[2]", [](AssetData& a) { a.hull.vertices[2] = 99.0f; }},
        {FaultId::asset_bad_hull, "hull.triangles[1]", [](AssetData& a) { a.hull.triangles[1] = 42; }},
        {FaultId::asset_open_hull, "hull.triangles[237]",
         [](AssetData& a) { a.hull.triangles[238] = a.hull.triangles[237]; }},
        {FaultId::asset_hull_not_convex, "hull.triangles[0]",
         [](AssetData& a) {
             for (size_t i = 0; i < a.hull.triangles.size(); i += 3)
                 std::swap(a.hull.triangles[i], a.hull.triangles[i + 1]);
         }},
        {FaultId::asset_not_finite, "aerodynamics.axes[4]",
         [](AssetData& a) { a.aerodynamics.axes[4] = not_a_number; }},
        {FaultId::asset_bad_axes, "aerodynamics.axes", [](AssetData& a) { a.aerodynamics.axes[0] = 1.001; }},
        {FaultId::asset_bad_axes, "aerodynamics.axes", [](AssetData& a) { a.aerodynamics.axes[1] = 0.001; }},
        {FaultId::asset_bad_axes, "aerodynamics.axes", [](AssetData& a) { a.aerodynamics.axes[8] = -1.0; }},
        {FaultId::asset_bad_axes, "aerodynamics.axes", [](AssetData& a) { a.aerodynamics.axes.fill(0.0); }},
        {FaultId::asset_out_of_range, "name", [](AssetData& a) { a.name.assign(5000, 'x'); }}};
    for (const Coefficient& c : coefficients())
        for (size_t k = 0; k < c.size; ++k) {
            const std::string where =
                std::string("aerodynamics.") + c.name + (c.size > 1 ? "[" + std::to_string(k) + "]" : "");
            const double unit = std::pow(test::leaf_data().length_d, c.power);
            const auto becomes = [=](double v) { return [=](AssetData& a) { c.at(a.aerodynamics)[k] = v; }; };
            cases.push_back({FaultId::asset_not_finite, where, becomes(not_a_number)});
            cases.push_back({FaultId::asset_not_finite, where, becomes(-infinite)});
            cases.push_back(
                {FaultId::asset_out_of_range, where, becomes(c.least * unit * (c.least > 0.0 ? 0.9 : 1.1) - 1e-20)});
            cases.push_back({FaultId::asset_out_of_range, where, becomes(c.most * unit * 1.1)});
        }
    const auto station = [](const std::function<void(StationData&)>& change) {
        return [=](AssetData& a) {
            a.stations = test::winged_data().stations;
            change(a.stations[2]);
        };
    };
    cases.insert(cases.end(),
                 {{FaultId::asset_wrong_length, "stations", [](AssetData& a) { a.stations.resize(1); }},
                  {FaultId::asset_wrong_length, "stations", [](AssetData& a) { a.stations.resize(9); }},
                  {FaultId::asset_bad_axes, "stations[2].axes", station([](StationData& s) { s.axes[0] = 1.001; })},
                  {FaultId::asset_bad_axes, "stations[2].axes", station([](StationData& s) { s.axes[8] = -1.0; })},
                  {FaultId::asset_bad_axes, "stations[2].axes", station([](StationData& s) { s.axes.fill(0.0); })},
                  {FaultId::asset_not_finite, "stations[2].axes[5]",
                   station([](StationData& s) { s.axes[5] = not_a_number; })}});
    for (const StationCoefficient& c : station_coefficients())
        for (size_t k = 0; k < c.size; ++k) {
            const std::string where =
                std::string("stations[2].") + c.name + (c.size > 1 ? "[" + std::to_string(k) + "]" : "");
            const double unit = std::pow(test::leaf_data().length_d, c.power);
            const auto becomes = [=](double v) { return station([=](StationData& s) { c.at(s)[k] = v; }); };
            cases.push_back({FaultId::asset_not_finite, where, becomes(not_a_number)});
            cases.push_back({FaultId::asset_not_finite, where, becomes(infinite)});
            cases.push_back({FaultId::asset_out_of_range, where, becomes(c.least * unit * 1.1 - 1e-20)});
            cases.push_back({FaultId::asset_out_of_range, where, becomes(c.most * unit * 1.1)});
        }
    for (const Case& c : cases) {
        CAPTURE(c.where);
        AssetData d = test::leaf_data();
        c.change(d);
        const std::vector<uint8_t> bytes = write_asset(d);
        AssetData back;
        Faults faults;
        CHECK_FALSE(read_asset(bytes.data(), bytes.size(), back, faults));
        bool found = false;
        for (const Fault& f : faults) {
            found = found || (f.id == c.id && f.where == c.where);
            CHECK((f.severity == Severity::error && !f.what.empty() && !f.remedy.empty()));
        }
        CHECK(found);
        if (!found)
            for (const Fault& f : faults) MESSAGE(to_string(f));
    }
}

TEST_CASE("a hull may be empty") {
    AssetData d = test::leaf_data(), back;
    d.hull = {};
    Faults faults;
    const std::vector<uint8_t> bytes = write_asset(d);
    CHECK(read_asset(bytes.data(), bytes.size(), back, faults));
}

TEST_CASE("every field of the root is required") {
    const std::vector<uint8_t> good = write_asset(test::leaf_data());
    // Tables, strings and vectors, and the required numbers.
    for (size_t id : {0u, 1u, 2u, 6u, 7u, 8u, 9u, 10u, 11u, 12u, 15u, 16u, 17u, 18u}) {
        CAPTURE(id);
        std::vector<uint8_t> bytes = good;
        test::drop_root_field(bytes, id);
        AssetData back;
        Faults faults;
        CHECK_FALSE(read_asset(bytes.data(), bytes.size(), back, faults));
        REQUIRE(faults.size() == 1);
        CHECK(faults[0].id == (id < 2 ? FaultId::asset_missing_field : FaultId::asset_corrupt));
    }
}

// Resealed with a correct checksum, so that every change reaches the later checks under AddressSanitizer.
TEST_CASE("a file that was changed and sealed again is refused or holds possible numbers") {
    const std::vector<uint8_t> good = write_asset(test::winged_data());
    const size_t sum = test::root_field(good, 1);
    uint64_t state = 1;
    int read = 0, refused = 0;
    const int rounds = quick() ? 2000 : 20000;
    for (int round = 0; round < rounds; ++round) {
        std::vector<uint8_t> bytes = good;
        const auto random = [&] {
            state = state * 6364136223846793005ull + 1442695040888963407ull;
            return static_cast<uint32_t>(state >> 33);
        };
        for (uint32_t n = 1 + random() % 3; n > 0; --n) bytes[random() % bytes.size()] = static_cast<uint8_t>(random());
        // The root, its table and the path to the checksum stay intact: otherwise it cannot be resealed.
        std::memcpy(bytes.data(), good.data(), 8);
        if (test::root_field(bytes, 1) != sum) continue;
        test::seal(bytes);
        AssetData back;
        Faults faults;
        if (read_asset(bytes.data(), bytes.size(), back, faults)) {
            ++read;
            Faults again;
            if (!check_asset(back, again) || !faults.empty()) FAIL("a read asset does not pass its checks");
        } else {
            ++refused;
            if (faults.empty()) FAIL("refused without a fault");
        }
    }
    CHECK(read > 100);
    CHECK(refused > 100);
}

TEST_CASE("numbers in messages have the fewest digits that read back the same") {
    CHECK(shortest(0.1) == "0.1");
    CHECK(shortest(-0.125) == "-0.125");
    CHECK(shortest(1e-5) == "1e-05");
    CHECK(shortest(2000000.0) == "2000000");
    for (double value : {1.0 / 3.0, 0.1 + 0.2, 1e300 / 7.0, 5e-324, -1e22})
        CHECK(std::strtod(shortest(value).c_str(), nullptr) == value);
}
