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

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR

template <class D, class V> struct Rows { V a, b, c, e; };
template <class D, class V> HWY_INLINE Rows<D, V> rows_of(D, V a, V b, V c, V e) {
    return {a, b, c, e};
}
template <class D, class V> HWY_INLINE void put_row(D d, const Rows<D, V>& r, unsigned char* to, size_t) {
    auto* const at = reinterpret_cast<float*>(to);
    hn::StoreU(r.a, d, at);
    hn::StoreU(r.b, d, at + 1);
    hn::StoreU(r.c, d, at + 2);
    hn::StoreU(r.e, d, at + 3);
}
template <class D, class V>
HWY_INLINE void put_rows(D d, const Rows<D, V>& first, const Rows<D, V>& second, unsigned char* to, size_t stride) {
    put_row(d, first, to, stride);
    put_row(d, second, to + 16, stride);
}

#else

// Four numbers of each body of a vector: v[k] has those of the k-th body of four in each 128-bit block.
template <class D, class V> struct Rows { V v[4]; };
template <class D, class V> HWY_INLINE Rows<D, V> rows_of(D d, V a, V b, V c, V e) {
    const hn::RepartitionToWide<D> wide;
    const auto pair = [&](V x) HWY_ATTR { return hn::BitCast(wide, x); };
    const auto ab = pair(hn::InterleaveLower(d, a, b)), ab_above = pair(hn::InterleaveUpper(d, a, b));
    const auto ce = pair(hn::InterleaveLower(d, c, e)), ce_above = pair(hn::InterleaveUpper(d, c, e));
    return {{hn::BitCast(d, hn::InterleaveLower(wide, ab, ce)), hn::BitCast(d, hn::InterleaveUpper(wide, ab, ce)),
             hn::BitCast(d, hn::InterleaveLower(wide, ab_above, ce_above)),
             hn::BitCast(d, hn::InterleaveUpper(wide, ab_above, ce_above))}};
}

// The blocks of a vector, `step` bytes apart.
template <class D> HWY_INLINE void put_blocks(D d, hn::Vec<D> v, unsigned char* to, size_t step) {
    if constexpr (hn::MaxLanes(D()) <= 4) {
        hn::StoreU(v, d, reinterpret_cast<float*>(to));
    } else {
        const hn::Half<D> half;
        put_blocks(half, hn::LowerHalf(half, v), to, step);
        put_blocks(half, hn::UpperHalf(half, v), to + hn::MaxLanes(D()) / 8 * step, step);
    }
}
// A block of each, one behind the other, `step` bytes apart.
template <class D> HWY_INLINE void put_blocks(D d, hn::Vec<D> v, hn::Vec<D> w, unsigned char* to, size_t step) {
    if constexpr (hn::MaxLanes(D()) <= 4) {
        hn::StoreU(v, d, reinterpret_cast<float*>(to));
        hn::StoreU(w, d, reinterpret_cast<float*>(to) + 4);
    } else if constexpr (hn::MaxLanes(D()) == 8) {
        hn::StoreU(hn::ConcatLowerLower(d, w, v), d, reinterpret_cast<float*>(to));
        hn::StoreU(hn::ConcatUpperUpper(d, w, v), d, reinterpret_cast<float*>(to + step));
    } else {
        const hn::Half<D> half;
        put_blocks(half, hn::LowerHalf(half, v), hn::LowerHalf(half, w), to, step);
        put_blocks(half, hn::UpperHalf(half, v), hn::UpperHalf(half, w), to + hn::MaxLanes(D()) / 8 * step, step);
    }
}

// One row of each body, or two in a row; `stride` bytes from body to body.
template <class D, class V> HWY_INLINE void put_row(D d, const Rows<D, V>& r, unsigned char* to, size_t stride) {
    for (size_t k = 0; k < 4; ++k) put_blocks(d, r.v[k], to + k * stride, 4 * stride);
}
template <class D, class V>
HWY_INLINE void put_rows(D d, const Rows<D, V>& first, const Rows<D, V>& second, unsigned char* to, size_t stride) {
    for (size_t k = 0; k < 4; ++k) put_blocks(d, first.v[k], second.v[k], to + k * stride, 4 * stride);
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
        put_row(d, rows_of(d, x, y, z, qx), to, stride);
        put_row(d, rows_of(d, qx, qy, qz, qw), to + 12, stride); // qx twice: seven numbers in two rows of four
        return;
    }
    const V s = load(field_scale);
    if constexpr (kFormat == LR_TRANSFORM_POSITION_QUATERNION_SCALE) {
        put_rows(d, rows_of(d, x, y, z, qx), rows_of(d, qy, qz, qw, s), to, stride);
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
    if constexpr (kFormat == LR_TRANSFORM_3X4_ROW_MAJOR || kFormat == LR_TRANSFORM_4X4_ROW_MAJOR) {
        put_rows(d, rows_of(d, r00, r01, r02, x), rows_of(d, r10, r11, r12, y), to, stride);
        const auto third = rows_of(d, r20, r21, r22, z);
        if constexpr (kFormat == LR_TRANSFORM_3X4_ROW_MAJOR)
            put_row(d, third, to + 32, stride);
        else
            put_rows(d, third, rows_of(d, zero, zero, zero, one), to + 32, stride);
    } else if constexpr (kFormat == LR_TRANSFORM_3X4_COLUMN_MAJOR) {
        put_rows(d, rows_of(d, r00, r10, r20, r01), rows_of(d, r11, r21, r02, r12), to, stride);
        put_row(d, rows_of(d, r22, x, y, z), to + 32, stride);
    } else {
        put_rows(d, rows_of(d, r00, r10, r20, zero), rows_of(d, r01, r11, r21, zero), to, stride);
        put_rows(d, rows_of(d, r02, r12, r22, zero), rows_of(d, x, y, z, one), to + 32, stride);
    }
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

void write_range(const BatchArrays& a, uint32_t count, int32_t format, unsigned char* to, uint64_t stride,
                 bool stream) {
    const auto write = [&]<int32_t kFormat>() {
        if (stream)
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
#include "hwy/targets.h"

namespace lr {
namespace {

// Elements of more than this are written past the caches: they would not stay there until they are drawn, and to fetch
// the lines that are about to be overwritten would take as long as writing them.
constexpr uint64_t stream_bytes = 8u << 20;

using WriteFunction = void (*)(const BatchArrays&, uint32_t, int32_t, unsigned char*, uint64_t, bool);
struct Target {
    int32_t simd;
    WriteFunction write;
};
constexpr Target targets[] = {
#if HWY_TARGETS & HWY_AVX3
    {LR_SIMD_AVX512, &N_AVX3::write_range},
#endif
#if HWY_TARGETS & HWY_AVX2
    {LR_SIMD_AVX2, &N_AVX2::write_range},
#endif
#if HWY_TARGETS & HWY_SSE4
    {LR_SIMD_SSE4, &N_SSE4::write_range},
#endif
#if HWY_TARGETS & HWY_SSSE3
    {LR_SIMD_SSSE3, &N_SSSE3::write_range},
#endif
#if HWY_TARGETS & HWY_NEON
    {LR_SIMD_NEON, &N_NEON::write_range},
#endif
#if HWY_TARGETS & HWY_WASM
    {LR_SIMD_WASM, &N_WASM::write_range},
#endif
#if HWY_TARGETS & HWY_EMU128
    {LR_SIMD_EMULATED, &N_EMU128::write_range},
#endif
#if HWY_TARGETS & HWY_SCALAR
    {LR_SIMD_EMULATED, &N_SCALAR::write_range},
#endif
};

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

void write_transforms(int32_t simd, const BatchArrays& a, uint32_t count, int32_t format, void* to, uint64_t stride) {
    const bool stream = stride == transform_bytes(format) && uint64_t{count} * stride >= stream_bytes;
    for (const Target& target : targets)
        if (target.simd == simd) return target.write(a, count, format, static_cast<unsigned char*>(to), stride, stream);
}

} // namespace lr
#endif
