#include "view/transforms.h"

#include "langevin_rigid.h"

namespace lr {
namespace {

struct Pose {
    float x, y, z, qx, qy, qz, qw, scale;
};

struct Matrix {
    float r[3][3]; // rotation times scale, r[row][column]
};

Matrix matrix(const Pose& p) {
    const float x2 = p.qx + p.qx, y2 = p.qy + p.qy, z2 = p.qz + p.qz;
    const float xx = p.qx * x2, yy = p.qy * y2, zz = p.qz * z2;
    const float xy = p.qx * y2, xz = p.qx * z2, yz = p.qy * z2;
    const float wx = p.qw * x2, wy = p.qw * y2, wz = p.qw * z2;
    const float s = p.scale;
    return {{{s * (1.0f - (yy + zz)), s * (xy - wz), s * (xz + wy)},
             {s * (xy + wz), s * (1.0f - (xx + zz)), s * (yz - wx)},
             {s * (xz - wy), s * (yz + wx), s * (1.0f - (xx + yy))}}};
}

template <int32_t kFormat> void write_pose(const Pose& p, float* out) {
    if constexpr (kFormat == LR_TRANSFORM_POSITION_QUATERNION || kFormat == LR_TRANSFORM_POSITION_QUATERNION_SCALE) {
        out[0] = p.x, out[1] = p.y, out[2] = p.z;
        out[3] = p.qx, out[4] = p.qy, out[5] = p.qz, out[6] = p.qw;
        if constexpr (kFormat == LR_TRANSFORM_POSITION_QUATERNION_SCALE) out[7] = p.scale;
    } else {
        const Matrix m = matrix(p);
        const float t[3] = {p.x, p.y, p.z};
        constexpr bool four = kFormat == LR_TRANSFORM_4X4_ROW_MAJOR || kFormat == LR_TRANSFORM_4X4_COLUMN_MAJOR;
        if constexpr (kFormat == LR_TRANSFORM_3X4_ROW_MAJOR || kFormat == LR_TRANSFORM_4X4_ROW_MAJOR) {
            for (int i = 0; i < 3; ++i) {
                for (int j = 0; j < 3; ++j) out[4 * i + j] = m.r[i][j];
                out[4 * i + 3] = t[i];
            }
            if constexpr (four) out[12] = out[13] = out[14] = 0.0f, out[15] = 1.0f;
        } else {
            constexpr int rows = four ? 4 : 3;
            for (int j = 0; j < 3; ++j)
                for (int i = 0; i < 3; ++i) out[rows * j + i] = m.r[i][j];
            for (int i = 0; i < 3; ++i) out[3 * rows + i] = t[i];
            if constexpr (four) out[3] = out[7] = out[11] = 0.0f, out[15] = 1.0f;
        }
    }
}

template <int32_t kFormat> void write_all(const BatchArrays& a, uint32_t count, void* to, uint64_t stride) {
    auto* at = static_cast<unsigned char*>(to);
    for (uint32_t i = 0; i < count; ++i, at += stride) {
        const Pose p{a.field[field_x][i],  a.field[field_y][i],  a.field[field_z][i],  a.field[field_qx][i],
                     a.field[field_qy][i], a.field[field_qz][i], a.field[field_qw][i], a.field[field_scale][i]};
        write_pose<kFormat>(p, reinterpret_cast<float*>(at));
    }
}

} // namespace

uint32_t transform_bytes(int32_t format) {
    switch (format) {
    case LR_TRANSFORM_POSITION_QUATERNION:
        return 28;
    case LR_TRANSFORM_POSITION_QUATERNION_SCALE:
        return 32;
    case LR_TRANSFORM_3X4_ROW_MAJOR:
    case LR_TRANSFORM_3X4_COLUMN_MAJOR:
        return 48;
    case LR_TRANSFORM_4X4_ROW_MAJOR:
    case LR_TRANSFORM_4X4_COLUMN_MAJOR:
        return 64;
    default:
        return 0;
    }
}

void write_transforms(const BatchArrays& a, uint32_t count, int32_t format, void* to, uint64_t stride) {
    switch (format) {
    case LR_TRANSFORM_POSITION_QUATERNION:
        return write_all<LR_TRANSFORM_POSITION_QUATERNION>(a, count, to, stride);
    case LR_TRANSFORM_POSITION_QUATERNION_SCALE:
        return write_all<LR_TRANSFORM_POSITION_QUATERNION_SCALE>(a, count, to, stride);
    case LR_TRANSFORM_3X4_ROW_MAJOR:
        return write_all<LR_TRANSFORM_3X4_ROW_MAJOR>(a, count, to, stride);
    case LR_TRANSFORM_3X4_COLUMN_MAJOR:
        return write_all<LR_TRANSFORM_3X4_COLUMN_MAJOR>(a, count, to, stride);
    case LR_TRANSFORM_4X4_ROW_MAJOR:
        return write_all<LR_TRANSFORM_4X4_ROW_MAJOR>(a, count, to, stride);
    default:
        return write_all<LR_TRANSFORM_4X4_COLUMN_MAJOR>(a, count, to, stride);
    }
}

} // namespace lr
