// From arrays to elements: transposes vectors of bodies into rows of four numbers of one body each.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/write_transforms.cpp"
#include "hwy/foreach_target.h" // IWYU pragma: keep

// One vector at a time.
#ifndef LR_NO_PAIRS
#define LR_NO_PAIRS
#endif

#include "kernel/integrator/step.h"

#include "hwy/cache_control.h"
#include "hwy/highway.h"
#include "kernel/integrator/equations_of_motion-inl.h"
#include "langevin_rigid.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

// An element is successive rows of four numbers; of seven numbers, the second row begins with the last of the first.
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

// Body after body, each whole: an instance buffer can be memory that combines writes of few lines at a time.
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

// One vector of bodies, from `at` on.
template <int32_t kFormat>
HWY_INLINE void write_vector(const BatchArrays& a, size_t at, unsigned char* to, size_t stride) {
    const DF d;
    const Vec3 x = load3(a, field_x, at);
    const Quaternion q = load4(a, at);
    if constexpr (kFormat == LR_TRANSFORM_POSITION_QUATERNION) {
        VF row[2][4];
        turn(x.x, x.y, x.z, q.x, row[0]);
        turn(q.x, q.y, q.z, q.w, row[1]);
        put<2, true>(d, row, to, stride);
        return;
    }
    const VF s = load1(a, field_scale, at);
    if constexpr (kFormat == LR_TRANSFORM_POSITION_QUATERNION_SCALE) {
        VF row[2][4];
        turn(x.x, x.y, x.z, q.x, row[0]);
        turn(q.y, q.z, q.w, s, row[1]);
        put<2, false>(d, row, to, stride);
        return;
    }
    const VF one = constant(1.0f), zero = hn::Zero(d);
    const VF x2 = q.x + q.x, y2 = q.y + q.y, z2 = q.z + q.z;
    const VF xx = q.x * x2, yy = q.y * y2, zz = q.z * z2;
    const VF xy = q.x * y2, xz = q.x * z2, yz = q.y * z2;
    const VF wx = q.w * x2, wy = q.w * y2, wz = q.w * z2;
    const VF r00 = s * (one - (yy + zz)), r11 = s * (one - (xx + zz)), r22 = s * (one - (xx + yy));
    const VF r01 = s * (xy - wz), r10 = s * (xy + wz);
    const VF r02 = s * (xz + wy), r20 = s * (xz - wy);
    const VF r12 = s * (yz - wx), r21 = s * (yz + wx);
    constexpr bool four = kFormat == LR_TRANSFORM_4X4_ROW_MAJOR || kFormat == LR_TRANSFORM_4X4_COLUMN_MAJOR;
    VF row[four ? 4 : 3][4];
    if constexpr (kFormat == LR_TRANSFORM_3X4_ROW_MAJOR || kFormat == LR_TRANSFORM_4X4_ROW_MAJOR) {
        turn(r00, r01, r02, x.x, row[0]);
        turn(r10, r11, r12, x.y, row[1]);
        turn(r20, r21, r22, x.z, row[2]);
        if constexpr (four) turn(zero, zero, zero, one, row[3]);
    } else if constexpr (kFormat == LR_TRANSFORM_3X4_COLUMN_MAJOR) {
        turn(r00, r10, r20, r01, row[0]);
        turn(r11, r21, r02, r12, row[1]);
        turn(r22, x.x, x.y, x.z, row[2]);
    } else {
        turn(r00, r10, r20, zero, row[0]);
        turn(r01, r11, r21, zero, row[1]);
        turn(r02, r12, r22, zero, row[2]);
        turn(x.x, x.y, x.z, one, row[3]);
    }
    put<four ? 4 : 3, false>(d, row, to, stride);
}

template <int32_t kFormat>
HWY_NOINLINE void write_format(const BatchArrays& a, size_t begin, size_t end, unsigned char* to, uint64_t stride) {
    const size_t lanes = hn::Lanes(DF());
    size_t at = begin;
    for (; end - at >= lanes; at += lanes, to += lanes * stride) write_vector<kFormat>(a, at, to, stride);
    if (at == end) return;
    // The last bodies through a buffer of one vector: nothing is written past them.
    alignas(64) unsigned char rest[lane_block * 64];
    const uint32_t bytes = transform_bytes(kFormat);
    write_vector<kFormat>(a, at, rest, bytes);
    for (uint32_t i = 0; at < end; ++i, ++at, to += stride) std::memcpy(to, rest + i * bytes, bytes);
}

// Elements without gaps, past the caches: whole cache lines, one after the other, through a buffer that stays in the first-level cache.
template <int32_t kFormat> HWY_NOINLINE void stream_format(const BatchArrays& a, size_t count, unsigned char* to) {
    constexpr size_t piece = 128, line = 64;
    const DF d;
    const size_t bytes = transform_bytes(kFormat), step = hn::Lanes(d) * sizeof(float);
    alignas(line) unsigned char stage[line + piece * 64];
    // The buffer begins at a line of the output; the first `hole` bytes belong to the caller.
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
HWY_INLINE void move_on(const BatchArrays& a, size_t at, float seconds, Vec3& x, Quaternion& q) {
    const Quaternion from = load4(a, at);
    const Vec3 axis{from.x, from.y, from.z};
    x = load3(a, field_x, at) + to_world(from, constant(seconds) * load3(a, field_vx, at));
    // Cayley's map of a quarter of the turn, squared: ((1 - s) + 2 t)/(1 + s), s = |t|^2, t = w seconds/4. A turn by x is short by x^3/48.
    const Vec3 t = constant(0.25f * seconds) * load3(a, field_wx, at);
    const VF one = constant(1.0f), s = t.x * t.x + t.y * t.y + t.z * t.z;
    const VF unit = one / (one + s), w = (one - s) * unit;
    const Vec3 r = unit * (t + t), turned = from.w * r + w * axis + cross(axis, r);
    q = {turned.x, turned.y, turned.z, from.w * w - (axis.x * r.x + axis.y * r.y + axis.z * r.z)};
}

// Through a buffer of bodies that have been moved on.
template <int32_t kFormat>
HWY_NOINLINE void write_ahead(const BatchArrays& a, uint32_t count, float seconds, unsigned char* to, uint64_t stride) {
    constexpr uint32_t piece = 128;
    static_assert(piece % lane_block == 0);
    alignas(64) float moved[field_scale][piece];
    BatchArrays some{};
    std::copy(std::begin(moved), std::end(moved), some.field);
    for (uint32_t from = 0; from < count; from += piece, to += piece * stride) {
        const uint32_t here = std::min(piece, count - from);
        some.field[field_scale] = a.field[field_scale] + from;
        for (size_t i = 0; i < here; i += hn::Lanes(DF())) {
            Vec3 x;
            Quaternion q;
            move_on(a, from + i, seconds, x, q);
            store3(some, field_x, i, x);
            store4(some.field + field_qx, i, q);
        }
        write_format<kFormat>(some, 0, here, to, stride);
    }
}

// Larger outputs bypass the caches: they would be evicted before drawing, and fetching lines to overwrite them takes as long as writing.
constexpr uint64_t stream_bytes = 8u << 20;

void write_transforms(const BatchArrays& a, uint32_t count, float ahead, int32_t format, void* to, uint64_t stride) {
    auto* const bytes = static_cast<unsigned char*>(to);
    const auto write = [&]<int32_t kFormat>(std::integral_constant<int32_t, kFormat>) {
        if (kFormat != format) return;
        if (ahead > 0.0f)
            write_ahead<kFormat>(a, count, ahead, bytes, stride);
        else if (stride == transform_bytes(kFormat) && uint64_t{count} * stride >= stream_bytes)
            stream_format<kFormat>(a, count, bytes);
        else
            write_format<kFormat>(a, 0, count, bytes, stride);
    };
    [&]<int32_t... kFormats>(std::integer_sequence<int32_t, kFormats...>) {
        (write(std::integral_constant<int32_t, kFormats>{}), ...);
    }
    (std::make_integer_sequence<int32_t, LR_TRANSFORM_4X4_COLUMN_MAJOR + 1>{});
}
} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lr {

uint32_t transform_bytes(int32_t format) {
    constexpr uint32_t bytes[] = {28, 32, 48, 48, 64, 64}; // in the order of LR_TRANSFORM_*
    static_assert(LR_TRANSFORM_POSITION_QUATERNION == 0 && LR_TRANSFORM_4X4_COLUMN_MAJOR == std::size(bytes) - 1);
    return format >= 0 && format <= LR_TRANSFORM_4X4_COLUMN_MAJOR ? bytes[format] : 0;
}
} // namespace lr
#endif
