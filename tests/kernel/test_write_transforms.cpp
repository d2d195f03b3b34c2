#include "kernel/integrator/step.h"
#include "langevin_rigid.h"
#include "support/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
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
    alignas(64) float fields[field_count][lane_block] = {};
    BatchArrays arrays{};
    for (size_t f = 0; f < field_count; ++f) arrays.field[f] = fields[f];
    for (size_t i = 0; i < 16; ++i) {
        double q[4], n = 0.0;
        for (double& x : q) x = random.uniform(-1.0, 1.0), n += x * x;
        for (size_t k = 0; k < 4; ++k) fields[field_qx + k][i] = static_cast<float>(q[k] / std::sqrt(n));
        for (size_t k = 0; k < 3; ++k) fields[field_x + k][i] = random.real(-5.0, 5.0);
        fields[field_scale][i] = random.real(0.1, 3.0);
    }
    float row[16][12], column[16][12], row4[16][16], column4[16][16];
    find_target(LR_SIMD_AUTO)->write_transforms(arrays, 16, 0.0f, LR_TRANSFORM_3X4_ROW_MAJOR, row, 48);
    find_target(LR_SIMD_AUTO)->write_transforms(arrays, 16, 0.0f, LR_TRANSFORM_3X4_COLUMN_MAJOR, column, 48);
    find_target(LR_SIMD_AUTO)->write_transforms(arrays, 16, 0.0f, LR_TRANSFORM_4X4_ROW_MAJOR, row4, 64);
    find_target(LR_SIMD_AUTO)->write_transforms(arrays, 16, 0.0f, LR_TRANSFORM_4X4_COLUMN_MAJOR, column4, 64);
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

// The quarter turn about z maps x to y, which fixes the sign.
TEST_CASE("a known turn") {
    alignas(64) float fields[field_count][lane_block] = {};
    BatchArrays arrays{};
    for (size_t f = 0; f < field_count; ++f) arrays.field[f] = fields[f];
    fields[field_qz][0] = fields[field_qw][0] = 0x1.6a09e6p-1f;
    fields[field_scale][0] = 2.0f;
    fields[field_x][0] = 7.0f;
    float m[16];
    find_target(LR_SIMD_AUTO)->write_transforms(arrays, 1, 0.0f, LR_TRANSFORM_4X4_COLUMN_MAJOR, m, 64);
    const float expected[16] = {0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 7, 0, 0, 1};
    for (size_t i = 0; i < 16; ++i) CHECK(std::abs(m[i] - expected[i]) < 1e-6f);
}

namespace {

// Arrays as batches have them: aligned, whole lane blocks.
struct Crowd {
    BatchArrays arrays{};
    explicit Crowd(size_t count) : lanes_((count + lane_block - 1) / lane_block * lane_block) {
        memory_.resize(field_count * lanes_ + lane_block);
        auto address = reinterpret_cast<uintptr_t>(memory_.data());
        float* const first = memory_.data() + ((64 - address % 64) % 64) / 4;
        for (size_t f = 0; f < field_count; ++f) arrays.field[f] = first + f * lanes_;
        test::Random random(7);
        for (size_t i = 0; i < field_count * lanes_; ++i) first[i] = random.real(-1.0, 1.0);
    }

private:
    size_t lanes_;
    std::vector<float> memory_;
};

// The element of body i, computed by scalar operations.
void element(const BatchArrays& a, size_t i, int32_t format, float* out) {
    const auto at = [&](size_t field) { return a.field[field][i]; };
    const float x = at(field_qx), y = at(field_qy), z = at(field_qz), w = at(field_qw), s = at(field_scale);
    if (format <= LR_TRANSFORM_POSITION_QUATERNION_SCALE) {
        const float all[8] = {at(field_x), at(field_y), at(field_z), x, y, z, w, s};
        std::copy(all, all + (format == LR_TRANSFORM_POSITION_QUATERNION ? 7 : 8), out);
        return;
    }
    const float x2 = x + x, y2 = y + y, z2 = z + z;
    const float r[3][4] = {{s * (1.0f - (y * y2 + z * z2)), s * (x * y2 - w * z2), s * (x * z2 + w * y2), at(field_x)},
                           {s * (x * y2 + w * z2), s * (1.0f - (x * x2 + z * z2)), s * (y * z2 - w * x2), at(field_y)},
                           {s * (x * z2 - w * y2), s * (y * z2 + w * x2), s * (1.0f - (x * x2 + y * y2)), at(field_z)}};
    for (size_t row = 0; row < 4; ++row)
        for (size_t column = 0; column < 4; ++column) {
            const float value = row < 3 ? r[row][column] : (column == 3 ? 1.0f : 0.0f);
            if (format == LR_TRANSFORM_4X4_COLUMN_MAJOR) out[4 * column + row] = value;
            if (format == LR_TRANSFORM_4X4_ROW_MAJOR) out[4 * row + column] = value;
            if (format == LR_TRANSFORM_3X4_ROW_MAJOR && row < 3) out[4 * row + column] = value;
            if (format == LR_TRANSFORM_3X4_COLUMN_MAJOR && row < 3) out[3 * column + row] = value;
        }
}

// Expects all elements, and no other byte changed. shift: bytes beyond an alignment of 64.
void check_bits(int32_t simd, const Crowd& crowd, size_t count, int32_t format, size_t gap, size_t shift) {
    const size_t bytes = transform_bytes(format), stride = bytes + gap, front = 64;
    std::vector<unsigned char> memory(front + 64 + 128 + stride * count, 0xa5);
    const size_t align = (64 - reinterpret_cast<uintptr_t>(memory.data()) % 64) % 64;
    std::vector<unsigned char> expected = memory;
    unsigned char* const to = memory.data() + align + front + shift;
    for (size_t i = 0; i < count; ++i) {
        float out[16];
        element(crowd.arrays, i, format, out);
        std::memcpy(expected.data() + (to - memory.data()) + static_cast<std::ptrdiff_t>(i * stride), out, bytes);
    }
    find_target(simd)->write_transforms(crowd.arrays, static_cast<uint32_t>(count), 0.0f, format, to, stride);
    if (memory != expected) {
        CAPTURE(simd);
        CAPTURE(count);
        CAPTURE(format);
        CAPTURE(gap);
        CAPTURE(shift);
        FAIL_CHECK("transforms differ");
    }
}

} // namespace

TEST_CASE("every instruction set writes the same bits, for any count, stride and alignment, and nothing besides") {
    size_t targets = 0;
    const KernelTarget* const target = built_targets(targets);
    const Crowd crowd(300);
    for (size_t t = 0; t < targets; ++t) {
        if (find_target(target[t].simd) == nullptr) continue;
        for (int32_t format = 0; format < 6; ++format)
            for (size_t count : {1u, 2u, 3u, 4u, 7u, 8u, 15u, 16u, 17u, 33u, 300u})
                for (size_t gap : {0u, 4u, 16u, 36u})
                    for (size_t shift : {0u, 4u, 16u, 60u})
                        check_bits(target[t].simd, crowd, count, format, gap, shift);
    }
}

// Past the caches, in whole lines: the first and the last are not whole.
TEST_CASE("large outputs have the same bits, wherever they begin and end") {
    size_t targets = 0;
    const KernelTarget* const target = built_targets(targets);
    const Crowd crowd(300100);
    for (size_t t = 0; t < targets; ++t) {
        if (find_target(target[t].simd) == nullptr) continue;
        for (int32_t format = 0; format < 6; ++format)
            for (size_t shift : {0u, 4u, 60u}) {
                // Counts whose elements end at a cache line, and elsewhere.
                check_bits(target[t].simd, crowd, 300032, format, 0, shift);
                check_bits(target[t].simd, crowd, 300001 + shift, format, 0, shift);
            }
    }
}
