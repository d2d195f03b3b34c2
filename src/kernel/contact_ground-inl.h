// Where bodies touch a plane or a heightfield: few points of each, that hold it best.
#if defined(LR_KERNEL_CONTACT_GROUND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_CONTACT_GROUND_INL_H_
#undef LR_KERNEL_CONTACT_GROUND_INL_H_
#else
#define LR_KERNEL_CONTACT_GROUND_INL_H_
#endif

#include "kernel/contact.h"
#include "kernel/contact_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

// Of the surface below a point, in the surface's own frame.
struct GroundSample {
    VF gap;               // height above it along its normal
    VF slope[2], inverse; // its normal is (slope[0], 1, slope[1]) inverse
};

// Row-major 3x3 matrices of each body.
struct Frame {
    Vec3 row[3];
};
HWY_INLINE Vec3 rows(const Frame& m, Vec3 a) {
    return {dot(m.row[0], a), dot(m.row[1], a), dot(m.row[2], a)};
}
HWY_INLINE Vec3 columns(const Frame& m, Vec3 a) {
    return add_scaled(add_scaled(scale(a.z, m.row[2]), a.y, m.row[1]), a.x, m.row[0]);
}
// A row-major matrix, transposed, times a vector.
HWY_INLINE Vec3 columns(const float* m, Vec3 a) {
    return add(add(scale(a.x, broadcast(m)), scale(a.y, broadcast(m + 3))), scale(a.z, broadcast(m + 6)));
}
HWY_INLINE Vec3 times(Vec3 a, Vec3 b) {
    return {hn::Mul(a.x, b.x), hn::Mul(a.y, b.y), hn::Mul(a.z, b.z)};
}

// What lies below the bodies of a vector. Those smaller than half a cell meet no more than two by two cells, whose heights and normals
// are fetched once; the samples are the same to the bit.
class GroundBelow {
public:
    HWY_INLINE GroundBelow(const GroundSurface& g, Vec3 middle, VF radius) : ground_(g) {
        few_ = false;
        if (!g.heights) return;
        const VF most = constant(0.45f);
        const VF greatest = constant(HWY_MAX(g.inverse_spacing[0], g.inverse_spacing[1]));
        few_ = hn::AllTrue(DF(), hn::Le(hn::Mul(radius, greatest), most));
        if (!few_) return;
        VF place[2][3];
        for (int axis = 0; axis < 2; ++axis) {
            const VF first = hn::Sub(axis == 0 ? middle.x : middle.z, radius);
            first_[axis] = cell(hn::Mul(first, constant(g.inverse_spacing[axis])), axis);
            const VF last = constant(static_cast<float>(g.counts[axis] - 1));
            for (int k = 0; k < 3; ++k)
                place[axis][k] = hn::Min(hn::Add(first_[axis], constant(static_cast<float>(k))), last);
        }
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k) height_[i][k] = height(index(place[0][i], place[1][k]));
        for (int i = 0; i < 2; ++i)
            for (int k = 0; k < 2; ++k) {
                const VF h00 = height_[i][k], h11 = height_[i + 1][k + 1];
                const VF upper = height_[i][k + 1], lower = height_[i + 1][k];
                inverse_[i][k][0] = inverse_of(slope(hn::Sub(h11, upper), 0), slope(hn::Sub(upper, h00), 1));
                inverse_[i][k][1] = inverse_of(slope(hn::Sub(lower, h00), 0), slope(hn::Sub(h11, lower), 1));
            }
    }

    HWY_INLINE GroundSample at(Vec3 p) const {
        const VF zero = hn::Zero(DF());
        if (!ground_.heights) return {p.y, {zero, zero}, constant(1.0f)};
        const VF u = hn::Mul(p.x, constant(ground_.inverse_spacing[0]));
        const VF w = hn::Mul(p.z, constant(ground_.inverse_spacing[1]));
        const VF i = cell(u, 0), k = cell(w, 1), fu = hn::Sub(u, i), fw = hn::Sub(w, k);
        const auto upper = hn::Ge(fw, fu); // the triangle with the corner (i, k + 1)
        VF h00, h11, corner, inverse;
        if (few_) {
            const auto next_i = hn::Gt(i, first_[0]), next_k = hn::Gt(k, first_[1]);
            const auto pick = [&](VF a, VF b, VF c, VF e) LR_LAMBDA { // of the cells (0, 0), (1, 0), (0, 1), (1, 1)
                return hn::IfThenElse(next_k, hn::IfThenElse(next_i, e, c), hn::IfThenElse(next_i, b, a));
            };
            const auto& h = height_;
            h00 = pick(h[0][0], h[1][0], h[0][1], h[1][1]);
            h11 = pick(h[1][1], h[2][1], h[1][2], h[2][2]);
            corner = hn::IfThenElse(upper, pick(h[0][1], h[1][1], h[0][2], h[1][2]),
                                    pick(h[1][0], h[2][0], h[1][1], h[2][1]));
            const auto& n = inverse_;
            inverse = hn::IfThenElse(upper, pick(n[0][0][0], n[1][0][0], n[0][1][0], n[1][1][0]),
                                     pick(n[0][0][1], n[1][0][1], n[0][1][1], n[1][1][1]));
        } else {
            const VF one = constant(1.0f), next_i = hn::Add(i, one), next_k = hn::Add(k, one);
            h00 = height(index(i, k));
            h11 = height(index(next_i, next_k));
            corner = height(index(hn::IfThenElse(upper, i, next_i), hn::IfThenElse(upper, next_k, k)));
        }
        const VF along_w = hn::IfThenElse(upper, hn::Sub(corner, h00), hn::Sub(h11, corner));
        const VF along_u = hn::IfThenElse(upper, hn::Sub(h11, corner), hn::Sub(corner, h00));
        const VF surface = mul_add(fu, along_u, mul_add(fw, along_w, h00));
        GroundSample s{zero, {slope(along_u, 0), slope(along_w, 1)}, zero};
        s.inverse = few_ ? inverse : inverse_of(s.slope[0], s.slope[1]);
        const auto outside = [&](VF at_axis, int axis) LR_LAMBDA {
            return hn::Or(hn::Lt(at_axis, zero),
                          hn::Gt(at_axis, constant(static_cast<float>(ground_.counts[axis] - 1))));
        };
        s.gap = hn::IfThenElse(hn::Or(outside(u, 0), outside(w, 1)), constant(no_contact),
                               hn::Mul(hn::Sub(p.y, surface), s.inverse));
        return s;
    }

private:
    HWY_INLINE VF cell(VF at_axis, int axis) const {
        const VF last = constant(static_cast<float>(ground_.counts[axis] - 2));
        return hn::Max(hn::Min(hn::Floor(at_axis), last), hn::Zero(DF()));
    }
    HWY_INLINE VI index(VF i, VF k) const {
        const DI di;
        const VI row = hn::Set(di, static_cast<int32_t>(ground_.counts[0]));
        return hn::Add(hn::ConvertTo(di, i), hn::Mul(hn::ConvertTo(di, k), row));
    }
    HWY_INLINE VF height(VI at_index) const { return hn::GatherIndex(DF(), ground_.heights, at_index); }
    HWY_INLINE VF slope(VF rise, int axis) const {
        return hn::Neg(hn::Mul(rise, constant(ground_.inverse_spacing[axis])));
    }
    static HWY_INLINE VF inverse_of(VF x, VF z) {
        const VF one = constant(1.0f);
        return hn::Div(one, hn::Sqrt(mul_add(x, x, mul_add(z, z, one))));
    }

    const GroundSurface& ground_;
    bool few_;
    VF first_[2];         // cell, of each axis
    VF height_[3][3];     // along x, along z, from that cell on
    VF inverse_[2][2][2]; // of the upper and the lower triangle of each
};

// Thick ones roll over their only point, and lie in a valley between several.
inline bool is_flat(const ShapeConstants& s) {
    const float(&a)[3] = s.semi_axes;
    const float most = HWY_MAX(a[0], HWY_MAX(a[1], a[2])), least = HWY_MIN(a[0], HWY_MIN(a[1], a[2]));
    return least < 0.2f * most;
}
inline uint32_t ellipsoid_points(const ShapeConstants& s, const GroundSurface& g) {
    return is_flat(s) ? 8 : g.heights ? 5 : 1;
}

// A point of the shape: of its core, m in the surface's frame from the centre of mass, and its gap.
struct GroundPoint {
    Vec3 at;
    VF gap;
};

// In the frame of the surface.
class GroundPoints {
public:
    HWY_INLINE GroundPoints(const ContactBodies& b, const GroundSurface& g, size_t at, VF radius)
        : shape_(b.shape), scale_(hn::Load(DF(), b.arrays.field[field_scale] + at)),
          local_(lr::HWY_NAMESPACE::rows(g.axes, sub(load3(b.arrays, field_x, at), broadcast(g.position)))),
          below_(g, local_, radius) {
        const Quaternion q = load4(b.arrays, at);
        for (int k = 0; k < 3; ++k) turned_.row[k] = to_body(q, broadcast(g.axes + 3 * k));
        for (int k = 0; k < 3; ++k) scaled_.row[k] = scale(scale_, turned_.row[k]);
        radius_ = hn::Mul(scale_, constant(b.shape.count == 0 ? 0.0f : b.shape.radius));
    }

    // Of a core point, at scale 1.
    HWY_INLINE GroundPoint get(float x, float y, float z, GroundSample& sample) const {
        const Vec3 p{constant(x), constant(y), constant(z)};
        return point(lr::HWY_NAMESPACE::rows(scaled_, p), sample);
    }
    // Of an ellipsoid the one nearest to the surface and others. The first is that below which the surface is nearest. A flat one
    // that lies touches at a point that goes from rim to rim with the least tilt: four more are where it would touch if it were tilted
    // a little more, and three at the mirrored normals, at the other rims. A thick one has four for the slopes around it.
    HWY_INLINE GroundPoint of_ellipsoid(uint32_t k, GroundSample& sample) const {
        const ShapeConstants& s = shape_;
        const Vec3 axes = scale(scale_, broadcast(s.semi_axes)), center = scale(scale_, broadcast(s.center));
        const bool flat = is_flat(s);
        const float(&a)[3] = s.semi_axes;
        const float most = HWY_MAX(a[0], HWY_MAX(a[1], a[2])), least = HWY_MIN(a[0], HWY_MIN(a[1], a[2]));
        Vec3 from = lr::HWY_NAMESPACE::rows(turned_, center);
        if (k != 0 && !flat) { // no farther than the reach, which is as far as cells are fetched
            const VF beside = hn::Mul(scale_, constant((k & 1) != 0 ? most : -most));
            VF& along = k <= 2 ? from.x : from.z;
            along = hn::Add(along, beside);
        }
        GroundPoint p = point(from, sample);
        const auto support = [&](Vec3 n) LR_LAMBDA {
            const Vec3 stretched = times(axes, n);
            const VF inverse = inverse_length(hn::Sqrt(dot(stretched, stretched)));
            const Vec3 arm = sub(center, scale(inverse, times(axes, stretched)));
            return point(lr::HWY_NAMESPACE::rows(turned_, arm), sample);
        };
        // On a slope the surface under the point of support is that under another point: a second look is enough for
        // bodies smaller than the cells, and exact on a plane.
        Vec3 n = columns(turned_, normal(sample));
        p = support(n);
        n = columns(turned_, normal(sample));
        p = support(n);
        if (k == 0 || !flat) return p;
        const float tilt = 0.02f * (1.0f - least / most) * (1.0f - least / most);
        const int shortest = a[0] == least ? 0 : a[1] == least ? 1 : 2;
        VF* const along[3] = {&n.x, &n.y, &n.z};
        VF &first = *along[(shortest + 1) % 3], &second = *along[(shortest + 2) % 3];
        if (k <= 4) {
            VF& tilted = k <= 2 ? first : second;
            tilted = hn::Add(tilted, constant((k & 1) != 0 ? tilt : -tilt));
        } else {
            if (k != 6) first = hn::Neg(first);
            if (k != 5) second = hn::Neg(second);
        }
        return support(n);
    }
    HWY_INLINE GroundSample sample_at(Vec3 at) const { return below_.at(add(local_, at)); }
    HWY_INLINE VF gap_of(const GroundSample& sample) const { return hn::Sub(sample.gap, radius_); }
    // On the body's surface, body frame.
    HWY_INLINE Vec3 arm(Vec3 at, Vec3 n) const { return columns(turned_, sub(at, scale(radius_, n))); }
    static HWY_INLINE Vec3 normal(const GroundSample& s) {
        return {hn::Mul(s.slope[0], s.inverse), s.inverse, hn::Mul(s.slope[1], s.inverse)};
    }

private:
    HWY_INLINE GroundPoint point(Vec3 at, GroundSample& sample) const {
        sample = sample_at(at);
        return {at, gap_of(sample)};
    }

    const ShapeConstants& shape_;
    VF scale_, radius_;
    Vec3 local_; // of the centre of mass
    Frame turned_, scaled_;
    GroundBelow below_;
};

// Whether none of the bodies within `radius` about their centres can be near the surface: over a heightfield no steeper than `steepness`
// a point that far away is lower above it by no more than that times the secant.
HWY_INLINE bool far_above(const GroundSurface& g, Vec3 x, VF radius) {
    const Vec3 p = lr::HWY_NAMESPACE::rows(g.axes, sub(x, broadcast(g.position)));
    if (!g.heights) return hn::AllFalse(DF(), hn::Le(p.y, radius));
    const VF height = height_within(g.heights, g.counts, g.inverse_spacing, p);
    return hn::AllFalse(DF(), hn::Le(hn::Sub(p.y, height), most_above(radius, g.secant, height)));
}

// How near a point must be to count: half a hundredth of the body, what it falls in a substep, and what its position is
// rounded to.
HWY_INLINE VF contact_margin(const ContactBodies& b, VF reach, Vec3 x) {
    const VF far = hn::Max(hn::Abs(x.x), hn::Max(hn::Abs(x.y), hn::Abs(x.z)));
    return mul_add(constant(0.005f), reach, mul_add(constant(1e-6f), far, constant(b.gravity * (b.h * b.h))));
}

// Slopes that differ by more than this, as the length of the difference of normals, meet in an edge between the points.
constexpr float sharp = 0.2f;

// The deepest point, the one farthest from it, and the farthest on either side of the line between them, those that touch
// before those that nearly do: of a body that lies
// flat, corners of the largest quadrilateral or nearly so.
bool touch_ground(const ContactBodies& b, const GroundSurface& g, ContactSlots::Slot (&out)[manifold_slots],
                  uint32_t* rough) {
    const DF d;
    const DU du;
    const bool ellipsoid = b.shape.count == 0;
    const uint32_t points_there = g.heights ? b.shape.sample_count : b.shape.count;
    const uint32_t count = ellipsoid ? ellipsoid_points(b.shape, g) : points_there;
    bool any = false;
    const VF empty = constant(no_contact), zero = hn::Zero(d), one = constant(1.0f);
    GroundPoint points[most_ground_points];
    // As SurfaceMotion::lag_at.
    const float half = 0.5f * b.h;
    const float turned = half * half * (g.spin[0] * g.spin[0] + g.spin[1] * g.spin[1] + g.spin[2] * g.spin[2]);
    const VF less = hn::Sub(hn::Sqrt(hn::Max(hn::Sub(one, constant(turned)), zero)), one);
    for (size_t at = 0; at < b.count; at += hn::Lanes(d)) {
        const VF reach = hn::Mul(constant(b.shape.reach), hn::Load(d, b.arrays.field[field_scale] + at));
        const Vec3 x = load3(b.arrays, field_x, at);
        const VF margin = contact_margin(b, reach, x);
        for (ContactSlots::Slot& s : out) hn::Store(empty, d, s.gap + at);
        if (far_above(g, x, hn::Add(reach, hn::Add(margin, margin)))) continue;

        const GroundPoints all(b, g, at, hn::Add(reach, margin));
        Vec3 deepest{zero, zero, zero};
        VF least = empty, alike = one; // the cosine of the greatest angle to the first point's normal
        Vec3 first_normal = deepest;
        for (uint32_t k = 0; k < count; ++k) {
            GroundSample sample;
            points[k] =
                ellipsoid ? all.of_ellipsoid(k, sample) : all.get(b.shape.x[k], b.shape.y[k], b.shape.z[k], sample);
            const auto deeper = hn::Lt(points[k].gap, least);
            least = hn::IfThenElse(deeper, points[k].gap, least);
            deepest = select(deeper, points[k].at, deepest);
            if (k == 0) first_normal = GroundPoints::normal(sample);
            const VF cosine = hn::Mul(
                mul_add(first_normal.x, sample.slope[0], mul_add(first_normal.z, sample.slope[1], first_normal.y)),
                sample.inverse);
            alike = hn::Min(alike, cosine);
        }
        const auto touching = hn::Lt(least, margin);
        if (hn::AllFalse(d, touching)) continue;
        any = true;
        if (g.heights) {
            const auto uneven = hn::And(touching, hn::Lt(alike, constant(1.0f - 0.5f * sharp * sharp)));
            hn::Store(hn::IfThenElseZero(hn::RebindMask(du, uneven), hn::Set(du, 1)), du, rough + at);
        }
        const auto put = [&](uint32_t slot, Vec3 point, hn::Mask<DF> there) LR_LAMBDA {
            const GroundSample sample = all.sample_at(point);
            const Vec3 n = GroundPoints::normal(sample);
            ContactSlots::Slot& s = out[slot];
            const Vec3 p = sub(add(x, columns(g.axes, point)), broadcast(g.position));
            store3(s.arm, at, all.arm(point, n));
            store3(s.normal, at, columns(g.axes, n));
            hn::Store(hn::IfThenElse(there, all.gap_of(sample), empty), d, s.gap + at);
            const Vec3 spin = broadcast(g.spin), along = cross(spin, p);
            store3(s.surface, at, add(broadcast(g.velocity), along));
            store3(s.lag, at, scale(constant(b.h), sub(scale(less, along), scale(constant(half), cross(spin, along)))));
            hn::Store(constant(g.friction), d, s.friction + at);
            hn::Store(constant(g.restitution), d, s.restitution + at);
            hn::Store(hn::Set(du, g.collider), du, s.collider + at);
            return n;
        };
        const Vec3 normal = put(0, deepest, touching);
        if (count < 2) continue;

        // What touches holds the body; of the rest, what pushing the deepest point out may press in. Points nearer to each other than
        // `apart` hold no better than one.
        const VF deep = hn::Max(hn::Neg(least), zero);
        const VF wide_margin = hn::Add(mul_add(constant(0.1f), reach, margin), hn::Add(deep, deep));
        const VF per_margin = hn::Div(one, margin), per_wide = hn::Div(constant(0.05f), wide_margin);
        const VF apart = hn::Mul(constant(0.02f), reach);
        Vec3 second = deepest;
        VF farthest = hn::Mul(apart, apart);
        auto found = hn::Lt(one, zero);
        for (uint32_t k = 0; k < count; ++k) {
            const VF gap = points[k].gap;
            const VF part = neg_mul_add(gap, per_margin, one);
            const VF some = hn::Max(neg_mul_add(gap, per_wide, constant(0.05f)), zero);
            const auto near = hn::And(touching, hn::Lt(gap, wide_margin));
            const VF weight = hn::IfThenElseZero(near, hn::Min(hn::Max(part, some), constant(2.0f)));
            points[k].gap = weight; // from here on
            const Vec3 r = sub(points[k].at, deepest);
            const VF value = hn::Mul(weight, dot(r, r));
            const auto more = hn::Gt(value, farthest);
            second = select(more, points[k].at, second);
            farthest = hn::IfThenElse(more, value, farthest);
            found = hn::Or(found, more);
        }
        put(1, second, found);
        if (count < 3 || hn::AllFalse(d, found)) continue;
        const Vec3 across = cross(normal, sub(second, deepest));
        const VF wide = hn::Mul(apart, hn::Sqrt(dot(across, across)));
        Vec3 side[2] = {deepest, deepest};
        VF most[2] = {wide, wide};
        hn::Mask<DF> there[2] = {hn::Lt(one, zero), hn::Lt(one, zero)};
        for (uint32_t k = 0; k < count; ++k) {
            const VF value = hn::Mul(points[k].gap, dot(across, sub(points[k].at, deepest)));
            for (int i = 0; i < 2; ++i) {
                const VF out_there = i == 0 ? value : hn::Neg(value);
                const auto more = hn::Gt(out_there, most[i]);
                side[i] = select(more, points[k].at, side[i]);
                most[i] = hn::IfThenElse(more, out_there, most[i]);
                there[i] = hn::Or(there[i], more);
            }
        }
        put(2, side[0], hn::And(found, there[0]));
        if (count > 3) put(3, side[1], hn::And(found, there[1]));
    }
    return any;
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
