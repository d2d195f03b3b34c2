#include "fuzz/asset/mutate.h"

#include "support/random.h"

#include <cmath>
#include <iterator>
#include <limits>

namespace fuzz {
namespace {

// Every number of an asset, except the samples and the hull, whose positions count too.
std::vector<double*> numbers_of(lr::AssetData& d) {
    std::vector<double*> all = {&d.mass,     &d.volume,   &d.density,  &d.fluid_density,  &d.fluid_viscosity,
                                &d.length_d, &d.length_b, &d.length_l, &d.projected_area, &d.u0};
    const auto each = [&](auto& values) {
        for (double& v : values) all.push_back(&v);
    };
    each(d.center_of_mass), each(d.center_of_buoyancy), each(d.inertia), each(d.added_mass), each(d.added_mass_error);
    lr::AerodynamicData& a = d.aerodynamics;
    each(a.axes);
#define LR_VECTOR(name, ...) each(a.name);
#define LR_NUMBER(name, ...) all.push_back(&a.name);
#define LR_STATION_VECTOR(name, ...) each(s.name);
#define LR_STATION_NUMBER(name, ...) all.push_back(&s.name);
    LR_AERODYNAMIC_VECTORS(LR_VECTOR)
    LR_AERODYNAMIC_NUMBERS(LR_NUMBER)
    for (lr::StationData& s : d.stations) {
        each(s.axes);
        LR_STATION_VECTORS(LR_STATION_VECTOR)
        LR_STATION_NUMBERS(LR_STATION_NUMBER)
    }
#undef LR_VECTOR
#undef LR_NUMBER
#undef LR_STATION_VECTOR
#undef LR_STATION_NUMBER
    for (double* v : {&d.turbulence.dt, &d.turbulence.c0, &d.turbulence.intensity, &d.turbulence.max_divergence})
        all.push_back(v);
    each(d.turbulence.domain);
    return all;
}

double other(double v, test::Random& random) {
    static constexpr double odd[] = {std::numeric_limits<double>::quiet_NaN(),
                                     std::numeric_limits<double>::infinity(),
                                     -std::numeric_limits<double>::infinity(),
                                     0.0,
                                     -0.0,
                                     1.0,
                                     -1.0,
                                     1e-300,
                                     1e300,
                                     5e-324,
                                     1e30,
                                     1e-30,
                                     1e9,
                                     1e-9,
                                     1e6,
                                     10.0,
                                     100.0};
    switch (random.below(8)) {
    case 0:
        return odd[random.below(sizeof odd / sizeof odd[0])];
    case 1:
        return -v;
    case 2:
        return v * std::pow(10.0, random.uniform(-6.0, 6.0));
    case 3:
        return v * (1.0 + random.uniform(-1e-5, 1e-5));
    case 4:
        return std::pow(10.0, random.uniform(-12.0, 12.0));
    default:
        return v * random.uniform(0.1, 10.0);
    }
}

template <class T> void change_values(std::vector<T>& values, test::Random& random) {
    const auto size = static_cast<uint32_t>(values.size());
    switch (random.below(4)) {
    case 0:
        values.resize(random.below(size + 4));
        break;
    case 1:
        if (size != 0) values.push_back(values[random.below(size)]);
        break;
    default:
        for (uint32_t n = random.below(4); size != 0 && n <= 2; ++n) {
            T& v = values[random.below(size)];
            if constexpr (std::is_floating_point_v<T>)
                v = static_cast<T>(other(static_cast<double>(v), random));
            else
                v = random.below(3) ? random.below(size) : static_cast<T>(random.bits());
        }
    }
}

// Another length: all quantities change by their powers of length.
void scale_lengths(lr::AssetData& d, double f) {
    const double f2 = f * f, f3 = f2 * f, f5 = f3 * f2;
    const auto by = [](auto& values, double factor) {
        for (auto& v : values) v = static_cast<std::decay_t<decltype(v)>>(static_cast<double>(v) * factor);
    };
    d.mass *= f3, d.volume *= f3, d.projected_area *= f2;
    d.length_d *= f, d.length_b *= f, d.length_l *= f;
    by(d.center_of_mass, f), by(d.center_of_buoyancy, f), by(d.inertia, f5), by(d.hull.vertices, f);
    for (size_t i = 0; i < 36; ++i) d.added_mass[i] *= f3 * (i / 6 < 3 ? 1.0 : f) * (i % 6 < 3 ? 1.0 : f);
    lr::AerodynamicData& a = d.aerodynamics;
#define LR_VECTOR(name, least, most, power) by(a.name, std::pow(f, power));
#define LR_NUMBER(name, least, most, power) a.name *= std::pow(f, power);
    LR_AERODYNAMIC_VECTORS(LR_VECTOR)
    LR_AERODYNAMIC_NUMBERS(LR_NUMBER)
#undef LR_VECTOR
#undef LR_NUMBER
#define LR_VECTOR(name, least, most, power) by(s.name, std::pow(f, power));
#define LR_NUMBER(name, least, most, power) s.name *= std::pow(f, power);
    for (lr::StationData& s : d.stations) {
        LR_STATION_VECTORS(LR_VECTOR)
        LR_STATION_NUMBERS(LR_NUMBER)
    }
#undef LR_VECTOR
#undef LR_NUMBER
    a.length *= f, a.wake_length *= f; // their limits do not grow with the body
}

void make_denser(lr::AssetData& d, double f) {
    d.mass *= f, d.density *= f;
    for (double& v : d.inertia) v *= f;
}

void change_coefficients(lr::AssetData& d, double f, uint32_t which) {
    lr::AerodynamicData& a = d.aerodynamics;
#define LR_POINTER(name, ...) &a.name,
    std::array<double, 3>* const vectors[] = {LR_AERODYNAMIC_VECTORS(LR_POINTER)};
    double* const numbers[] = {LR_AERODYNAMIC_NUMBERS(LR_POINTER)};
#undef LR_POINTER
    const size_t one = which % (std::size(vectors) + std::size(numbers));
    if (one >= std::size(vectors))
        *numbers[one - std::size(vectors)] *= f;
    else
        for (double& v : *vectors[one]) v *= f;
}

void one_change(lr::AssetData& d, test::Random& random) {
    const std::vector<double*> numbers = numbers_of(d);
    const auto any = [&]() -> double& { return *numbers[random.below(static_cast<uint32_t>(numbers.size()))]; };
    switch (random.below(14)) {
    case 0:
        return scale_lengths(d, random.logarithmic(1e-3, 1e3));
    case 1:
        return make_denser(d, random.logarithmic(1e-4, 1e4));
    case 2:
        d.fluid_density *= random.logarithmic(1e-4, 1e4);
        d.fluid_viscosity *= random.logarithmic(1e-4, 1e4);
        return;
    case 3:
        return change_coefficients(d, random.logarithmic(1e-3, 1e6), random.below(1000));
    case 4:
        std::swap(any(), any());
        return;
    case 5: { // both entries, so that it stays symmetric
        const uint32_t i = random.below(6), j = random.below(6);
        d.added_mass[i * 6 + j] = d.added_mass[j * 6 + i] = other(d.added_mass[i * 6 + j], random);
        return;
    }
    case 6: {
        const uint32_t i = random.below(3), j = random.below(3);
        d.inertia[i * 3 + j] = d.inertia[j * 3 + i] = other(d.inertia[i * 3 + j], random);
        return;
    }
    case 7:
        return change_values(random.below(2) ? d.turbulence.chi : d.turbulence.epsilon, random);
    case 8:
        return random.below(2) ? change_values(d.hull.vertices, random) : change_values(d.hull.triangles, random);
    case 9:
        (random.below(2) ? d.turbulence.stationary : d.turbulence.loop_end) = static_cast<uint32_t>(random.bits());
        return;
    case 10:
        if (random.below(4) == 0 && !d.stations.empty())
            d.stations.resize(random.below(11), d.stations[random.below(static_cast<uint32_t>(d.stations.size()))]);
        if (random.below(4) == 0) d.hull = {};
        d.name.assign(random.below(300), static_cast<char>(random.bits()));
        d.provenance.options.assign(random.below(3), 'x');
        return;
    default: {
        double& v = any();
        v = other(v, random);
    }
    }
}

} // namespace

void mutate_asset(lr::AssetData& data, uint32_t seed) {
    test::Random random(seed);
    for (uint32_t n = 1 + random.below(3); n > 0; --n) one_change(data, random);
}

} // namespace fuzz
