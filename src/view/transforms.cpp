// From arrays to elements: vectors of bodies are turned into rows of four numbers of one body each.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "view/transforms.cpp"
#include "hwy/foreach_target.h" // IWYU pragma: keep

#include "view/transforms.h"

#include "hwy/cache_control.h"
#include "hwy/highway.h"
#include "langevin_rigid.h"

#include <algorithm>
#include <cstring>
#include <iterator>

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// An element is rows of four numbers, one behind the other; of seven numbers, the second row begins with the last of the
// first.
template <bool kSeven> constexpr size_t row_at(size_t row) {
    return kSeven ? 12 * row : 16 * row;
}

#if HWY_TARGET == HWY_SCALAR

template <class V> HWY_INLINE void turn(V a, V b, V c, V e, V (&row)[4]) {
    row[0] = a, row[1] = b, row[2] = c, row[3] = e;
}
template <size_t kRows, bool kSeven, class D>
HWY_INLINE void put(D d, const hn::Vec<D> (&row)[kRows][4], unsigned char* to, size_t) {
    for (size_t r = 0; r < kRows; ++r)
        for (size_t k = 0; k < 4; ++k) hn::StoreU(row[r][k], d, reinterpret_cast<float*>(to + row_at<kSeven>(r)) + k);
}

#else

// Four numbers of each body of a vector: row[k] has those of the k-th body of four in each 128-bit block.
template <class V> HWY_INLINE void turn(V a, V b, V c, V e, V (&row)[4]) {
    const hn::DFromV<V> d;
    const hn::RepartitionToWide<decltype(d)> wide;
    const auto pair = [&](V x) HWY_ATTR { return hn::BitCast(wide, x); };
    const auto ab = pair(hn::InterleaveLower(d, a, b)), ab_above = pair(hn::InterleaveUpper(d, a, b));
    const auto ce = pair(hn::InterleaveLower(d, c, e)), ce_above = pair(hn::InterleaveUpper(d, c, e));
    row[0] = hn::BitCast(d, hn::InterleaveLower(wide, ab, ce));
    row[1] = hn::BitCast(d, hn::InterleaveUpper(wide, ab, ce));
    row[2] = hn::BitCast(d, hn::InterleaveLower(wide, ab_above, ce_above));
    row[3] = hn::BitCast(d, hn::InterleaveUpper(wide, ab_above, ce_above));
}

// Body after body, each whole: an instance buffer may be memory that combines writes of few lines at a time.
template <size_t kRows, bool kSeven, class D>
HWY_INLINE void put(D d, const hn::Vec<D> (&row)[kRows][4], unsigned char* to, size_t stride) {
    const auto at = [&](size_t body, size_t r)
                        HWY_ATTR { return reinterpret_cast<float*>(to + body * stride + row_at<kSeven>(r)); };
    if constexpr (hn::MaxLanes(D()) <= 4) {
        for (size_t k = 0; k < 4; ++k)
            for (size_t r = 0; r < kRows; ++r) hn::StoreU(row[r][k], d, at(k, r));
    } else if constexpr (hn::MaxLanes(D()) == 8) {
        const hn::Half<D> half;
        constexpr size_t pairs = kSeven ? 0 : kRows / 2;
        for (size_t k = 0; k < 4; ++k) {
            for (size_t r = 0; r < 2 * pairs; r += 2)
                hn::StoreU(hn::ConcatLowerLower(d, row[r + 1][k], row[r][k]), d, at(k, r));
            for (size_t r = 2 * pairs; r < kRows; ++r) hn::StoreU(hn::LowerHalf(half, row[r][k]), half, at(k, r));
        }
        for (size_t k = 0; k < 4; ++k) {
            for (size_t r = 0; r < 2 * pairs; r += 2)
                hn::StoreU(hn::ConcatUpperUpper(d, row[r + 1][k], row[r][k]), d, at(4 + k, r));
            for (size_t r = 2 * pairs; r < kRows; ++r) hn::StoreU(hn::UpperHalf(half, row[r][k]), half, at(4 + k, r));
        }
    } else {
        const hn::Half<D> half;
        hn::Vec<decltype(half)> part[kRows][4];
        for (size_t r = 0; r < kRows; ++r)
            for (size_t k = 0; k < 4; ++k) part[r][k] = hn::LowerHalf(half, row[r][k]);
        put<kRows, kSeven>(half, part, to, stride);
        for (size_t r = 0; r < kRows; ++r)
            for (size_t k = 0; k < 4; ++k) part[r][k] = hn::UpperHalf(half, row[r][k]);
        put<kRows, kSeven>(half, part, to + hn::MaxLanes(D()) / 2 * stride, stride);
    }
}

#endif

// Bodies from `at` on, a vector of them.
template <int32_t kFormat, class D>
HWY_INLINE void write_vector(D d, const BatchArrays& a, size_t at, unsigned char* to, size_t stride) {
    using V = hn::Vec<D>;
    const auto load = [&](size_t field) HWY_ATTR { return hn::Load(d, a.field[field] + at); };
    const V x = load(field_x), y = load(field_y), z = load(field_z);
    const V qx = load(field_qx), qy = load(field_qy), qz = load(field_qz), qw = load(field_qw);
    if constexpr (kFormat == LR_TRANSFORM_POSITION_QUATERNION) {
        V row[2][4];
        turn(x, y, z, qx, row[0]);
        turn(qx, qy, qz, qw, row[1]);
        put<2, true>(d, row, to, stride);
        return;
    }
    const V s = load(field_scale);
    if constexpr (kFormat == LR_TRANSFORM_POSITION_QUATERNION_SCALE) {
        V row[2][4];
        turn(x, y, z, qx, row[0]);
        turn(qy, qz, qw, s, row[1]);
        put<2, false>(d, row, to, stride);
        return;
    }
    const V one = hn::Set(d, 1.0f), zero = hn::Zero(d);
    const V x2 = hn::Add(qx, qx), y2 = hn::Add(qy, qy), z2 = hn::Add(qz, qz);
    const V xx = hn::Mul(qx, x2), yy = hn::Mul(qy, y2), zz = hn::Mul(qz, z2);
    const V xy = hn::Mul(qx, y2), xz = hn::Mul(qx, z2), yz = hn::Mul(qy, z2);
    const V wx = hn::Mul(qw, x2), wy = hn::Mul(qw, y2), wz = hn::Mul(qw, z2);
    const auto diagonal = [&](V p, V q) HWY_ATTR { return hn::Mul(s, hn::Sub(one, hn::Add(p, q))); };
    const V r00 = diagonal(yy, zz), r11 = diagonal(xx, zz), r22 = diagonal(xx, yy);
    const V r01 = hn::Mul(s, hn::Sub(xy, wz)), r10 = hn::Mul(s, hn::Add(xy, wz));
    const V r02 = hn::Mul(s, hn::Add(xz, wy)), r20 = hn::Mul(s, hn::Sub(xz, wy));
    const V r12 = hn::Mul(s, hn::Sub(yz, wx)), r21 = hn::Mul(s, hn::Add(yz, wx));
    constexpr bool four = kFormat == LR_TRANSFORM_4X4_ROW_MAJOR || kFormat == LR_TRANSFORM_4X4_COLUMN_MAJOR;
    V row[four ? 4 : 3][4];
    if constexpr (kFormat == LR_TRANSFORM_3X4_ROW_MAJOR || kFormat == LR_TRANSFORM_4X4_ROW_MAJOR) {
        turn(r00, r01, r02, x, row[0]);
        turn(r10, r11, r12, y, row[1]);
        turn(r20, r21, r22, z, row[2]);
        if constexpr (four) turn(zero, zero, zero, one, row[3]);
    } else if constexpr (kFormat == LR_TRANSFORM_3X4_COLUMN_MAJOR) {
        turn(r00, r10, r20, r01, row[0]);
        turn(r11, r21, r02, r12, row[1]);
        turn(r22, x, y, z, row[2]);
    } else {
        turn(r00, r10, r20, zero, row[0]);
        turn(r01, r11, r21, zero, row[1]);
        turn(r02, r12, r22, zero, row[2]);
        turn(x, y, z, one, row[3]);
    }
    put<four ? 4 : 3, false>(d, row, to, stride);
}

template <int32_t kFormat>
HWY_NOINLINE void write_format(const BatchArrays& a, size_t begin, size_t end, unsigned char* to, uint64_t stride) {
    const hn::CappedTag<float, lane_block> d;
    const size_t lanes = hn::Lanes(d);
    size_t at = begin;
    for (; end - at >= lanes; at += lanes, to += lanes * stride) write_vector<kFormat>(d, a, at, to, stride);
    if (at == end) return;
    // The last bodies by way of a vector's worth of elements: nothing is written behind them.
    alignas(64) unsigned char rest[lane_block * 64];
    const uint32_t bytes = transform_bytes(kFormat);
    write_vector<kFormat>(d, a, at, rest, bytes);
    for (uint32_t i = 0; at < end; ++i, ++at, to += stride) std::memcpy(to, rest + i * bytes, bytes);
}

// Elements without gaps, past the caches: whole cache lines, one after the other, by way of a piece that stays in the
// first-level cache.
template <int32_t kFormat> HWY_NOINLINE void stream_format(const BatchArrays& a, size_t count, unsigned char* to) {
    constexpr size_t piece = 128, line = 64;
    const hn::CappedTag<float, lane_block> d;
    const size_t bytes = transform_bytes(kFormat), step = hn::Lanes(d) * sizeof(float);
    alignas(line) unsigned char stage[line + piece * 64];
    // What is staged begins at a line of the output; of the first of all, `hole` bytes are not ours.
    size_t hole = reinterpret_cast<uintptr_t>(to) % line, staged = hole;
    to -= hole;
    for (size_t at = 0; at < count; at += std::min(piece, count - at)) {
        const size_t here = std::min(piece, count - at);
        write_format<kFormat>(a, at, at + here, stage + staged, bytes);
        staged += here * bytes;
        const size_t whole = staged / line * line;
        size_t from = 0;
        if (hole != 0 && whole != 0) {
            std::memcpy(to + hole, stage + hole, line - hole);
            hole = 0;
            from = line;
        }
        for (; from < whole; from += step)
            hn::Stream(hn::Load(d, reinterpret_cast<const float*>(stage + from)), d,
                       reinterpret_cast<float*>(to + from));
        to += whole;
        staged -= whole;
        std::memmove(stage, stage + whole, staged);
    }
    std::memcpy(to + hole, stage + hole, staged - hole);
    hwy::FlushStream();
}

// Position and orientation of one vector of bodies after `seconds` at their velocities.
template <class D, class Out> HWY_INLINE void move_on(D d, const BatchArrays& a, size_t at, float seconds, Out&& out) {
    using V = hn::Vec<D>;
    const auto load = [&](size_t field) HWY_ATTR { return hn::Load(d, a.field[field] + at); };
    const auto scaled = [&](size_t field, float by) HWY_ATTR { return hn::Mul(load(field), hn::Set(d, by)); };
    const V qx = load(field_qx), qy = load(field_qy), qz = load(field_qz), qw = load(field_qw);
    const V vx = scaled(field_vx, seconds), vy = scaled(field_vy, seconds), vz = scaled(field_vz, seconds);
    // q v q*, by u = 2 q x v: v + w u + q x u.
    const auto cross = [](V ay, V az, V by, V bz) HWY_ATTR { return hn::Sub(hn::Mul(ay, bz), hn::Mul(az, by)); };
    const auto twice = [](V x) HWY_ATTR { return hn::Add(x, x); };
    const V ux = twice(cross(qy, qz, vy, vz)), uy = twice(cross(qz, qx, vz, vx)), uz = twice(cross(qx, qy, vx, vy));
    const auto sum = [](V p, V q, V r) HWY_ATTR { return hn::Add(hn::Add(p, q), r); };
    out(field_x, hn::Add(load(field_x), sum(vx, hn::Mul(qw, ux), cross(qy, qz, uy, uz))));
    out(field_y, hn::Add(load(field_y), sum(vy, hn::Mul(qw, uy), cross(qz, qx, uz, ux))));
    out(field_z, hn::Add(load(field_z), sum(vz, hn::Mul(qw, uz), cross(qx, qy, ux, uy))));
    // Cayley's map of a quarter of the turn, squared: ((1 - s) + 2 t)/(1 + s), s = |t|^2, t = w seconds/4. A turn by x is short by x^3/48.
    const V one = hn::Set(d, 1.0f), quarter = hn::Set(d, 0.25f * seconds);
    const V tx = hn::Mul(load(field_wx), quarter), ty = hn::Mul(load(field_wy), quarter),
            tz = hn::Mul(load(field_wz), quarter);
    const V s = sum(hn::Mul(tx, tx), hn::Mul(ty, ty), hn::Mul(tz, tz));
    const V unit = hn::Div(one, hn::Add(one, s)), rw = hn::Mul(hn::Sub(one, s), unit);
    const V rx = hn::Mul(twice(tx), unit), ry = hn::Mul(twice(ty), unit), rz = hn::Mul(twice(tz), unit);
    out(field_qx, hn::Add(hn::Add(hn::Mul(qw, rx), hn::Mul(qx, rw)), cross(qy, qz, ry, rz)));
    out(field_qy, hn::Add(hn::Add(hn::Mul(qw, ry), hn::Mul(qy, rw)), cross(qz, qx, rz, rx)));
    out(field_qz, hn::Add(hn::Add(hn::Mul(qw, rz), hn::Mul(qz, rw)), cross(qx, qy, rx, ry)));
    out(field_qw, hn::Sub(hn::Mul(qw, rw), sum(hn::Mul(qx, rx), hn::Mul(qy, ry), hn::Mul(qz, rz))));
}

// By way of a piece with bodies that have been moved on.
template <int32_t kFormat>
HWY_NOINLINE void write_ahead(const BatchArrays& a, uint32_t count, float seconds, unsigned char* to, uint64_t stride) {
    constexpr uint32_t piece = 128;
    static_assert(piece % lane_block == 0);
    const hn::CappedTag<float, lane_block> d;
    alignas(64) float moved[field_count][piece];
    for (uint32_t from = 0; from < count; from += piece, to += piece * stride) {
        const uint32_t here = std::min(piece, count - from);
        BatchArrays some{};
        some.field[field_scale] = a.field[field_scale] + from;
        for (uint32_t i = 0; i < here; i += static_cast<uint32_t>(hn::Lanes(d)))
            move_on(d, a, from + i, seconds, [&](size_t field, auto v) HWY_ATTR {
                some.field[field] = moved[field];
                hn::Store(v, d, moved[field] + i);
            });
        write_format<kFormat>(some, 0, here, to, stride);
    }
}

void write_range(const BatchArrays& a, uint32_t count, float ahead, int32_t format, unsigned char* to, uint64_t stride,
                 bool stream) {
    const auto write = [&]<int32_t kFormat>() {
        if (ahead > 0.0f)
            write_ahead<kFormat>(a, count, ahead, to, stride);
        else if (stream)
            stream_format<kFormat>(a, count, to);
        else
            write_format<kFormat>(a, 0, count, to, stride);
    };
    switch (format) {
    case LR_TRANSFORM_POSITION_QUATERNION:
        return write.operator()<LR_TRANSFORM_POSITION_QUATERNION>();
    case LR_TRANSFORM_POSITION_QUATERNION_SCALE:
        return write.operator()<LR_TRANSFORM_POSITION_QUATERNION_SCALE>();
    case LR_TRANSFORM_3X4_ROW_MAJOR:
        return write.operator()<LR_TRANSFORM_3X4_ROW_MAJOR>();
    case LR_TRANSFORM_3X4_COLUMN_MAJOR:
        return write.operator()<LR_TRANSFORM_3X4_COLUMN_MAJOR>();
    case LR_TRANSFORM_4X4_ROW_MAJOR:
        return write.operator()<LR_TRANSFORM_4X4_ROW_MAJOR>();
    default:
        return write.operator()<LR_TRANSFORM_4X4_COLUMN_MAJOR>();
    }
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "kernel/built_targets.h"

namespace lr {
namespace {

// Elements of more than this are written past the caches: they would not stay there until they are drawn, and to fetch
// the lines that are about to be overwritten would take as long as writing them.
constexpr uint64_t stream_bytes = 8u << 20;

using WriteFunction = void (*)(const BatchArrays&, uint32_t, float, int32_t, unsigned char*, uint64_t, bool);
struct Target {
    int32_t simd;
    WriteFunction write;
};
#define LR_TARGET(simd, target) {simd, &N_##target::write_range},
constexpr Target targets[] = {LR_FOR_BUILT_TARGETS(LR_TARGET)};
#undef LR_TARGET

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

void write_transforms(int32_t simd, const BatchArrays& a, uint32_t count, float ahead, int32_t format, void* to,
                      uint64_t stride) {
    const bool stream = stride == transform_bytes(format) && uint64_t{count} * stride >= stream_bytes;
    // The last one runs anywhere.
    const Target* target =
        std::find_if(std::begin(targets), std::end(targets) - 1, [simd](const Target& t) { return t.simd == simd; });
    target->write(a, count, ahead, format, static_cast<unsigned char*>(to), stride, stream);
}

} // namespace lr
#endif
