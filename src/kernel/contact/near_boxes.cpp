// Boxes near a box, compiled once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/contact/near_boxes.cpp"
#include "hwy/foreach_target.h" // IWYU pragma: keep

#include "kernel/contact/near_boxes.h"

#include "hwy/highway.h"
#include "kernel/contact/search_lanes-inl.h"

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {
namespace search {

constexpr size_t fields_of_box = sizeof(PlacedBox) / sizeof(float);
enum : size_t { at_middle = 0, at_q = 3, at_half = 7, at_shift = 10, at_turns = 13, at_margin = 14 };
static_assert(offsetof(PlacedBox, margin) == at_margin * sizeof(float));

struct Boxes {
    Vec middle, half, shift, axis[3]; // columns
    Number turns, margin;

    // number(f): field f of each lane.
    template <class Field> explicit HWY_INLINE Boxes(const Field& number) {
        const auto vector = [&](size_t f) HWY_ATTR { return Vec{number(f), number(f + 1), number(f + 2)}; };
        middle = vector(at_middle), half = vector(at_half), shift = vector(at_shift);
        turns = number(at_turns), margin = number(at_margin);
        const Vec q = vector(at_q), q2 = Lanes::number(2.0f) * q;
        const Number w = number(at_q + 3), one = Lanes::number(1.0f);
        const Number xx = hw::Mul(q2.x, q.x), yy = hw::Mul(q2.y, q.y), zz = hw::Mul(q2.z, q.z);
        const Number xy = hw::Mul(q2.x, q.y), xz = hw::Mul(q2.x, q.z), yz = hw::Mul(q2.y, q.z);
        const Number wx = hw::Mul(q2.x, w), wy = hw::Mul(q2.y, w), wz = hw::Mul(q2.z, w);
        axis[0] = {hw::Sub(one, hw::Add(yy, zz)), hw::Add(xy, wz), hw::Sub(xz, wy)};
        axis[1] = {hw::Sub(xy, wz), hw::Sub(one, hw::Add(xx, zz)), hw::Add(yz, wx)};
        axis[2] = {hw::Add(xz, wy), hw::Sub(yz, wx), hw::Sub(one, hw::Add(xx, yy))};
    }
};

// Boxes are apart if they are along one of fifteen axes (Gottschalk et al. 1996). Cross products are at most 1 long, so these err to the
// near side.
HWY_INLINE hw::Mask<Tag> apart(const Boxes& a, const Boxes& b) {
    const Vec shifted = a.shift - b.shift, way = b.middle - a.middle;
    const Number within =
        hw::Add(hw::Add(hw::Min(a.margin, b.margin), hw::Sqrt(dot(shifted, shifted))), hw::Add(a.turns, b.turns));
    const Number half_a[3] = {a.half.x, a.half.y, a.half.z}, half_b[3] = {b.half.x, b.half.y, b.half.z};
    Number along_a[3], turn[3][3], size[3][3];
    for (size_t i = 0; i < 3; ++i) {
        along_a[i] = dot(a.axis[i], way);
        for (size_t k = 0; k < 3; ++k) turn[i][k] = dot(a.axis[i], b.axis[k]), size[i][k] = hw::Abs(turn[i][k]);
    }
    hw::Mask<Tag> out = Lanes::none();
    const auto test = [&](Number distance, Number reach_a, Number reach_b) HWY_ATTR {
        out = hw::Or(out, hw::Gt(hw::Abs(distance), hw::Add(within, hw::Add(reach_a, reach_b))));
    };
    for (size_t i = 0; i < 3; ++i) {
        const Number of_b = hw::Add(hw::Add(hw::Mul(half_b[0], size[i][0]), hw::Mul(half_b[1], size[i][1])),
                                    hw::Mul(half_b[2], size[i][2]));
        test(along_a[i], half_a[i], of_b);
        const Number of_a = hw::Add(hw::Add(hw::Mul(half_a[0], size[0][i]), hw::Mul(half_a[1], size[1][i])),
                                    hw::Mul(half_a[2], size[2][i]));
        test(dot(b.axis[i], way), of_a, half_b[i]);
    }
    if (hw::AllTrue(Tag(), out)) return out;
    for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3, l = (i + 2) % 3;
        for (size_t k = 0; k < 3; ++k) {
            const size_t m = (k + 1) % 3, n = (k + 2) % 3;
            test(hw::Sub(hw::Mul(along_a[l], turn[j][k]), hw::Mul(along_a[j], turn[l][k])),
                 hw::Add(hw::Mul(half_a[j], size[l][k]), hw::Mul(half_a[l], size[j][k])),
                 hw::Add(hw::Mul(half_b[m], size[i][n]), hw::Mul(half_b[n], size[i][m])));
        }
    }
    return out;
}
} // namespace search

uint32_t near_boxes(const PlacedBox* boxes, uint32_t one, uint32_t* others, uint32_t count) {
    using namespace search;
    const float* const of_one = boxes[one].middle;
    const Boxes a([&](size_t f) HWY_ATTR { return Lanes::number(of_one[f]); });
    alignas(64) float row[fields_of_box][search_lanes];
    uint32_t kept = 0;
    for (uint32_t first = 0; first < count; first += search_lanes) {
        const uint32_t lanes = HWY_MIN(search_lanes, count - first);
        for (uint32_t lane = 0; lane < search_lanes; ++lane) {
            const float* const from = boxes[others[first + (lane < lanes ? lane : 0)]].middle;
            for (size_t f = 0; f < fields_of_box; ++f) row[f][lane] = from[f];
        }
        for (size_t at = 0; at < lanes; at += hw::Lanes(Tag())) {
            const auto away = apart(a, Boxes([&](size_t f) HWY_ATTR { return hw::Load(Tag(), row[f] + at); }));
            uint8_t bits[8] = {};
            hw::StoreMaskBits(Tag(), away, bits);
            for (size_t lane = 0; lane < hw::Lanes(Tag()) && at + lane < lanes; ++lane)
                if ((bits[lane / 8] >> lane % 8 & 1u) == 0) others[kept++] = others[first + at + lane];
        }
    }
    return kept;
}
} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
