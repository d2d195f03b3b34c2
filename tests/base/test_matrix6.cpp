#include "baker/fault_text.h"
#include "base/matrix6.h"

#include "asset/input_faults.h"
#include "base/fnv1a.h"
#include "support/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace lr;

namespace {

// A A^T + floor: positive definite.
Matrix6 random_spd(test::Random& random) {
    double a[36];
    for (double& x : a) x = random.uniform(-1.0, 1.0);
    Matrix6 m{};
    for (size_t i = 0; i < 6; ++i)
        for (size_t j = 0; j < 6; ++j) {
            for (size_t k = 0; k < 6; ++k) m[i * 6 + j] += a[i * 6 + k] * a[j * 6 + k];
            if (i == j) m[i * 7] += 0.1;
        }
    return m;
}

} // namespace

TEST_CASE("the inverse is the inverse, and only of positive definite matrices") {
    test::Random random(1);
    for (int round = 0; round < 200; ++round) {
        const Matrix6 m = random_spd(random);
        Matrix6 inverse;
        REQUIRE(invert_spd(m, inverse));
        CHECK(is_positive_definite(m, 0.0));
        for (size_t i = 0; i < 6; ++i)
            for (size_t j = 0; j < 6; ++j) {
                double sum = 0.0;
                for (size_t k = 0; k < 6; ++k) sum += m[i * 6 + k] * inverse[k * 6 + j];
                CHECK(std::abs(sum - (i == j ? 1.0 : 0.0)) < 1e-10);
                CHECK(inverse[i * 6 + j] == inverse[j * 6 + i]);
            }
        // Made indefinite along one axis.
        Matrix6 bad = m;
        bad[7 * (static_cast<size_t>(round) % 6)] = -0.01;
        CHECK_FALSE(is_positive_definite(bad, 0.0));
        CHECK_FALSE(invert_spd(bad, inverse));
    }
    Matrix6 nan = random_spd(random);
    nan[7] = std::nan("");
    CHECK_FALSE(is_positive_definite(nan, 0.0));
    CHECK_FALSE(is_positive_definite(Matrix6{}, 0.0));
}

TEST_CASE("shifting a matrix keeps the energy of any motion, and back again is where it was") {
    test::Random random(2);
    for (int round = 0; round < 100; ++round) {
        const Matrix6 m = random_spd(random);
        const std::array<double, 3> c = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        Matrix6 shifted = m;
        shift_added_mass(shifted, c);
        double t[6], moved[6];
        for (double& x : t) x = random.uniform(-1.0, 1.0);
        // v at the new point = v + w x c
        moved[0] = t[0] + t[4] * c[2] - t[5] * c[1];
        moved[1] = t[1] + t[5] * c[0] - t[3] * c[2];
        moved[2] = t[2] + t[3] * c[1] - t[4] * c[0];
        for (size_t i = 3; i < 6; ++i) moved[i] = t[i];
        double before = 0.0, after = 0.0;
        for (size_t i = 0; i < 6; ++i)
            for (size_t j = 0; j < 6; ++j) {
                before += t[i] * m[i * 6 + j] * t[j];
                after += moved[i] * shifted[i * 6 + j] * moved[j];
            }
        CHECK(after == doctest::Approx(before).epsilon(1e-12));
        shift_added_mass(shifted, {-c[0], -c[1], -c[2]});
        for (size_t i = 0; i < 36; ++i) CHECK(std::abs(shifted[i] - m[i]) < 1e-12);
    }
}

TEST_CASE("scaling to units divides each block by its own") {
    Matrix6 m;
    m.fill(24.0);
    scale_to_unit(m, 2.0, 3.0);
    CHECK(m[0] == 12.0);
    CHECK(m[3] == 4.0);
    CHECK(m[18] == 4.0);
    CHECK(m[21] == doctest::Approx(24.0 / 18.0));
    const Matrix6 body = rigid_mass_matrix(5.0, {1, 2, 3, 2, 4, 5, 3, 5, 6});
    CHECK((body[0] == 5.0 && body[7] == 5.0 && body[14] == 5.0 && body[1] == 0.0 && body[3] == 0.0));
    CHECK((body[21] == 1.0 && body[22] == 2.0 && body[28] == 4.0 && body[35] == 6.0));
}

TEST_CASE(
    "the nearest semi-definite matrix is the matrix where it is one, and as near as its least eigenvalue where not") {
    test::Random random(7);
    for (int round = 0; round < 200; ++round) {
        const size_t rank = 3 + static_cast<size_t>(round % 4);
        Matrix6 a{}, rows{};
        for (size_t k = 0; k < rank * 6; ++k) rows[k] = random.real(-1.0, 1.0);
        for (size_t i = 0; i < 6; ++i)
            for (size_t j = 0; j < 6; ++j)
                for (size_t k = 0; k < rank; ++k) a[i * 6 + j] += rows[k * 6 + i] * rows[k * 6 + j];
        Matrix6 sure = a;
        for (size_t i = 0; i < 6; ++i) sure[i * 7] += 1e-9;
        const Matrix6 before = sure;
        make_semi_definite(sure);
        CHECK(sure == before);
        Matrix6 below = a;
        for (size_t i = 0; i < 6; ++i) below[i * 7] -= 1e-6;
        if (rank < 6) CHECK_FALSE(is_positive_definite(below, 0.0));
        make_semi_definite(below);
        double apart = 0.0;
        for (size_t i = 0; i < 36; ++i) {
            apart = std::max(apart, std::abs(below[i] - a[i]));
            CHECK(below[i] == below[i % 6 * 6 + i / 6]);
        }
        CHECK(apart < 1.1e-6);
        for (size_t i = 0; i < 6; ++i) below[i * 7] += 1e-12;
        CHECK(is_positive_definite(below, 0.0));
    }
    Matrix6 needle{};
    for (size_t i = 0; i < 6; ++i) needle[i * 7] = i == 3 ? -1e-8 : 0.1 * static_cast<double>(i + 1);
    Matrix6 expected = needle;
    expected[21] = 0.0;
    make_semi_definite(needle);
    CHECK(needle == expected);
}

TEST_CASE("FNV-1a gives its published values") {
    const auto of = [](const char* text, size_t size) {
        Fnv1a hash;
        hash.add(text, size);
        return hash.value();
    };
    CHECK(of("", 0) == 0xcbf29ce484222325ull);
    CHECK(of("a", 1) == 0xaf63dc4c8601ec8cull);
    CHECK(of("foobar", 6) == 0x85944171f73967e8ull);
}

TEST_CASE("a fault reads as a sentence with number, place and remedy") {
    const Fault f{FaultId::mesh_open_edge, Severity::error, "edge 3-17", "The surface has a boundary edge.",
                  "Close it."};
    CHECK(to_string(f) == "error 206 at edge 3-17: The surface has a boundary edge. Close it.");
    const Fault bare{FaultId::mesh_merged_vertices, Severity::warning, "", "Vertices were merged.", ""};
    CHECK(to_string(bare) == "warning 215: Vertices were merged.");
    CHECK(has_error({bare, f}));
    CHECK_FALSE(has_error({bare}));
}
