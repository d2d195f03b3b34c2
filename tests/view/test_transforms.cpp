#include "view/transforms.h"

#include "langevin_rigid.h"
#include "support/random.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace lr;

TEST_CASE("sizes of the formats") {
    CHECK(transform_bytes(LR_TRANSFORM_POSITION_QUATERNION) == 28);
    CHECK(transform_bytes(LR_TRANSFORM_POSITION_QUATERNION_SCALE) == 32);
    CHECK(transform_bytes(LR_TRANSFORM_3X4_ROW_MAJOR) == 48);
    CHECK(transform_bytes(LR_TRANSFORM_3X4_COLUMN_MAJOR) == 48);
    CHECK(transform_bytes(LR_TRANSFORM_4X4_ROW_MAJOR) == 64);
    CHECK(transform_bytes(LR_TRANSFORM_4X4_COLUMN_MAJOR) == 64);
    CHECK((transform_bytes(-1) == 0 && transform_bytes(6) == 0));
}

TEST_CASE("matrices are rotations times scale: orthogonal, right-handed, and rows are columns of the other order") {
    test::Random random(1);
    std::vector<std::vector<float>> fields(field_count, std::vector<float>(16));
    BatchArrays arrays{};
    for (size_t f = 0; f < field_count; ++f) arrays.field[f] = fields[f].data();
    for (size_t i = 0; i < 16; ++i) {
        double q[4], n = 0.0;
        for (double& x : q) x = random.uniform(-1.0, 1.0), n += x * x;
        for (size_t k = 0; k < 4; ++k) fields[field_qx + k][i] = static_cast<float>(q[k] / std::sqrt(n));
        for (size_t k = 0; k < 3; ++k) fields[field_x + k][i] = random.real(-5.0, 5.0);
        fields[field_scale][i] = random.real(0.1, 3.0);
    }
    float row[16][12], column[16][12], row4[16][16], column4[16][16];
    write_transforms(LR_SIMD_EMULATED, arrays, 16, LR_TRANSFORM_3X4_ROW_MAJOR, row, 48);
    write_transforms(LR_SIMD_EMULATED, arrays, 16, LR_TRANSFORM_3X4_COLUMN_MAJOR, column, 48);
    write_transforms(LR_SIMD_EMULATED, arrays, 16, LR_TRANSFORM_4X4_ROW_MAJOR, row4, 64);
    write_transforms(LR_SIMD_EMULATED, arrays, 16, LR_TRANSFORM_4X4_COLUMN_MAJOR, column4, 64);
    for (size_t i = 0; i < 16; ++i) {
        const double s = static_cast<double>(fields[field_scale][i]);
        const auto entry = [&](size_t r, size_t c) { return static_cast<double>(row[i][4 * r + c]) / s; };
        for (size_t a = 0; a < 3; ++a)
            for (size_t b = 0; b < 3; ++b) {
                double dot = 0.0;
                for (size_t k = 0; k < 3; ++k) dot += entry(k, a) * entry(k, b);
                CHECK(std::abs(dot - (a == b ? 1.0 : 0.0)) < 1e-6);
            }
        const double determinant = entry(0, 0) * (entry(1, 1) * entry(2, 2) - entry(1, 2) * entry(2, 1)) -
                                   entry(0, 1) * (entry(1, 0) * entry(2, 2) - entry(1, 2) * entry(2, 0)) +
                                   entry(0, 2) * (entry(1, 0) * entry(2, 1) - entry(1, 1) * entry(2, 0));
        CHECK(determinant == doctest::Approx(1.0).epsilon(1e-6));
        for (size_t r = 0; r < 3; ++r)
            for (size_t c = 0; c < 4; ++c) {
                CHECK(row[i][4 * r + c] == column[i][3 * c + r]);
                CHECK(row[i][4 * r + c] == row4[i][4 * r + c]);
                CHECK(row[i][4 * r + c] == column4[i][4 * c + r]);
            }
        for (size_t c = 0; c < 4; ++c) {
            CHECK(row4[i][12 + c] == (c == 3 ? 1.0f : 0.0f));
            CHECK(column4[i][4 * c + 3] == (c == 3 ? 1.0f : 0.0f));
        }
    }
}

// The quarter turn about z takes x to y: the sign of it all.
TEST_CASE("a known turn") {
    std::vector<std::vector<float>> fields(field_count, std::vector<float>(1));
    BatchArrays arrays{};
    for (size_t f = 0; f < field_count; ++f) arrays.field[f] = fields[f].data();
    fields[field_qz][0] = fields[field_qw][0] = 0x1.6a09e6p-1f;
    fields[field_scale][0] = 2.0f;
    fields[field_x][0] = 7.0f;
    float m[16];
    write_transforms(LR_SIMD_EMULATED, arrays, 1, LR_TRANSFORM_4X4_COLUMN_MAJOR, m, 64);
    const float expected[16] = {0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 7, 0, 0, 1};
    for (size_t i = 0; i < 16; ++i) CHECK(std::abs(m[i] - expected[i]) < 1e-6f);
}
