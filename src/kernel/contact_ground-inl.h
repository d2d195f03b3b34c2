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

// The surface below a point: height above it along its normal, in the surface's own frame.
struct GroundSample {
    VF gap;
    Vec3 normal;
};
HWY_INLINE GroundSample sample_ground(const GroundSurface& g, Vec3 p) {
    const VF zero = hn::Zero(DF()), one = constant(1.0f);
    if (!g.heights) return {p.y, {zero, one, zero}};
    const DI di;
    const VF u = hn::Mul(p.x, constant(g.inverse_spacing[0])), w = hn::Mul(p.z, constant(g.inverse_spacing[1]));
    const auto below = [&](VF at, int k) LR_LAMBDA {
        return hn::Max(hn::Min(hn::Floor(at), constant(static_cast<float>(g.counts[k] - 2))), zero);
    };
    const VF i = below(u, 0), k = below(w, 1);
    const VI row = hn::Set(di, static_cast<int32_t>(g.counts[0])), next = hn::Set(di, 1);
    const VI at = hn::Add(hn::ConvertTo(di, i), hn::Mul(hn::ConvertTo(di, k), row));
    const auto height = [&](VI index) LR_LAMBDA { return hn::GatherIndex(DF(), g.heights, index); };
    const VF h00 = height(at), h11 = height(hn::Add(hn::Add(at, row), next));
    const VF fu = hn::Sub(u, i), fw = hn::Sub(w, k);
    const auto upper = hn::Ge(fw, fu); // the triangle with the corner (i, k + 1)
    const VF corner = height(hn::Add(at, hn::IfThenElse(hn::RebindMask(di, upper), row, next)));
    const VF along_w = hn::IfThenElse(upper, hn::Sub(corner, h00), hn::Sub(h11, corner));
    const VF along_u = hn::IfThenElse(upper, hn::Sub(h11, corner), hn::Sub(corner, h00));
    const VF surface = mul_add(fu, along_u, mul_add(fw, along_w, h00));
    const Vec3 slope{hn::Neg(hn::Mul(along_u, constant(g.inverse_spacing[0]))), one,
                     hn::Neg(hn::Mul(along_w, constant(g.inverse_spacing[1])))};
    const VF inverse = hn::Div(one, hn::Sqrt(dot(slope, slope)));
    const auto outside = [&](VF at_axis, int axis) LR_LAMBDA {
        return hn::Or(hn::Lt(at_axis, zero), hn::Gt(at_axis, constant(static_cast<float>(g.counts[axis] - 1))));
    };
    const VF gap = hn::Mul(hn::Sub(p.y, surface), inverse);
    return {hn::IfThenElse(hn::Or(outside(u, 0), outside(w, 1)), constant(no_contact), gap), scale(inverse, slope)};
}

// Thick ones roll over their only point, and lie in a valley between several.
inline bool is_flat(const ShapeConstants& s) {
    const float(&a)[3] = s.semi_axes;
    const float most = HWY_MAX(a[0], HWY_MAX(a[1], a[2])), least = HWY_MIN(a[0], HWY_MIN(a[1], a[2]));
    return least < 0.2f * most;
}
inline uint32_t ellipsoid_points(const ShapeConstants& s, const GroundSurface& g) {
    return is_flat(s) ? 8 : g.heights ? 5 : 1;
}

// A point of the shape, and what is below it.
struct GroundPoint {
    Vec3 arm; // m, body frame, of the point on the body's surface
    Vec3 at;  // m, world, from the centre of mass
    VF gap;
    Vec3 normal; // world
};
template <class M> HWY_INLINE GroundPoint select(M mask, const GroundPoint& yes, const GroundPoint& no) {
    return {select(mask, yes.arm, no.arm), select(mask, yes.at, no.at), hn::IfThenElse(mask, yes.gap, no.gap),
            select(mask, yes.normal, no.normal)};
}

class GroundPoints {
public:
    HWY_INLINE GroundPoints(const ContactBodies& b, const GroundSurface& g, size_t at)
        : bodies_(b), ground_(g), x_(load3(b.arrays, field_x, at)), q_(load4(b.arrays, at)),
          scale_(hn::Load(DF(), b.arrays.field[field_scale] + at)),
          local_(rows(g.axes, sub(x_, broadcast(g.position)))) {}

    // Of point k; of an ellipsoid the one nearest to the surface and others.
    HWY_INLINE GroundPoint get(uint32_t k) const {
        const ShapeConstants& s = bodies_.shape;
        if (s.count == 0) return of_ellipsoid(k);
        const bool high = ground_.heights != nullptr;
        const float x = high ? s.sample_x[k] : s.x[k], y = high ? s.sample_y[k] : s.y[k],
                    z = high ? s.sample_z[k] : s.z[k];
        const Vec3 core = scale(scale_, Vec3{constant(x), constant(y), constant(z)});
        const Vec3 turned = to_world(q_, core);
        const GroundSample below = sample_ground(ground_, add(local_, rows(ground_.axes, turned)));
        GroundPoint p;
        p.normal = columns(ground_.axes, below.normal);
        const VF radius = hn::Mul(scale_, constant(s.radius));
        p.gap = hn::Sub(below.gap, radius);
        p.arm = sub(core, scale(radius, to_body(q_, p.normal)));
        p.at = turned;
        return p;
    }

private:
    // The first is that below which the surface is nearest. A flat one that lies touches at a point that goes from rim to rim
    // with the least tilt: four more are where it would touch if it were tilted a little more, and
    // three at the mirrored normals, at the other rims. A thick one has four for the slopes around it.
    HWY_INLINE GroundPoint of_ellipsoid(uint32_t k) const {
        const ShapeConstants& s = bodies_.shape;
        const Vec3 axes = scale(scale_, broadcast(s.semi_axes)), center = scale(scale_, broadcast(s.center));
        Vec3 from = add(local_, rows(ground_.axes, to_world(q_, center)));
        const bool flat = is_flat(s);
        if (k != 0 && !flat) {
            const VF reach = hn::Mul(scale_, constant(s.reach));
            VF& along = k <= 2 ? from.x : from.z;
            along = (k & 1) != 0 ? hn::Add(along, reach) : hn::Sub(along, reach);
        }
        GroundSample below = sample_ground(ground_, from);
        GroundPoint p;
        // On a slope the surface under the point of support is that under another point: a second look is enough for
        // bodies smaller than the cells, and exact on a plane.
        for (int look = 0; look < 2; ++look) {
            p.normal = columns(ground_.axes, below.normal);
            const Vec3 stretched = times(axes, to_body(q_, p.normal));
            const VF inverse = inverse_length(hn::Sqrt(dot(stretched, stretched)));
            p.arm = sub(center, scale(inverse, times(axes, stretched)));
            p.at = to_world(q_, p.arm);
            below = sample_ground(ground_, add(local_, rows(ground_.axes, p.at)));
        }
        if (k != 0 && flat) {
            const float(&a)[3] = s.semi_axes;
            const float most = HWY_MAX(a[0], HWY_MAX(a[1], a[2])), least = HWY_MIN(a[0], HWY_MIN(a[1], a[2]));
            const float tilt = 0.02f * (1.0f - least / most) * (1.0f - least / most);
            const int shortest = a[0] == least ? 0 : a[1] == least ? 1 : 2;
            Vec3 n = to_body(q_, p.normal);
            VF* const along[3] = {&n.x, &n.y, &n.z};
            VF &first = *along[(shortest + 1) % 3], &second = *along[(shortest + 2) % 3];
            if (k <= 4) {
                VF& tilted = k <= 2 ? first : second;
                tilted = hn::Add(tilted, constant((k & 1) != 0 ? tilt : -tilt));
            } else {
                if (k != 6) first = hn::Neg(first);
                if (k != 5) second = hn::Neg(second);
            }
            const Vec3 stretched = times(axes, n);
            const VF inverse = inverse_length(hn::Sqrt(dot(stretched, stretched)));
            p.arm = sub(center, scale(inverse, times(axes, stretched)));
            p.at = to_world(q_, p.arm);
            below = sample_ground(ground_, add(local_, rows(ground_.axes, p.at)));
        }
        p.normal = columns(ground_.axes, below.normal);
        p.gap = below.gap;
        return p;
    }
    static HWY_INLINE Vec3 times(Vec3 a, Vec3 b) { return {hn::Mul(a.x, b.x), hn::Mul(a.y, b.y), hn::Mul(a.z, b.z)}; }
    // Transpose of a row-major matrix, times a vector.
    static HWY_INLINE Vec3 columns(const float* m, Vec3 a) {
        return add(add(scale(a.x, broadcast(m)), scale(a.y, broadcast(m + 3))), scale(a.z, broadcast(m + 6)));
    }

    const ContactBodies& bodies_;
    const GroundSurface& ground_;
    Vec3 x_;
    Quaternion q_;
    VF scale_;
    Vec3 local_;
};

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
    const uint32_t points_there = g.heights ? b.shape.sample_count : b.shape.count;
    const uint32_t count = b.shape.count == 0 ? ellipsoid_points(b.shape, g) : points_there;
    bool any = false;
    const VF empty = constant(no_contact), zero = hn::Zero(d);
    GroundPoint points[most_ground_points];
    for (size_t at = 0; at < b.count; at += hn::Lanes(d)) {
        const GroundPoints all(b, g, at);
        const VF reach = hn::Mul(constant(b.shape.reach), hn::Load(d, b.arrays.field[field_scale] + at));
        const VF margin = contact_margin(b, reach, load3(b.arrays, field_x, at));
        const Vec3 none{zero, zero, zero};
        GroundPoint best[manifold_slots];
        for (GroundPoint& point : best) point = {none, none, empty, none};
        VF uneven = zero;
        for (uint32_t k = 0; k < count; ++k) {
            points[k] = all.get(k);
            if (k == 0) {
                best[0] = points[0];
                continue;
            }
            best[0] = select(hn::Lt(points[k].gap, best[0].gap), points[k], best[0]);
            const Vec3 turn = sub(points[k].normal, points[0].normal);
            uneven = hn::Max(uneven, dot(turn, turn));
        }
        const auto touching = hn::Lt(best[0].gap, margin);
        if (g.heights) {
            const auto uneven_lane = hn::And(touching, hn::Gt(uneven, constant(sharp * sharp)));
            hn::Store(hn::IfThenElseZero(hn::RebindMask(du, uneven_lane), hn::Set(du, 1)), du, rough + at);
        }
        best[0].gap = hn::IfThenElse(touching, best[0].gap, empty);
        uint32_t found = 1;
        if (!hn::AllFalse(d, touching)) {
            any = true;
            found = count < manifold_slots ? count : manifold_slots;
            // What touches holds the body; of the rest, what pushing the deepest point out may press in.
            const VF deep = hn::Max(hn::Neg(best[0].gap), zero);
            const VF wide_margin = hn::Add(mul_add(constant(0.1f), reach, margin), hn::Add(deep, deep));
            const VF per_margin = hn::Div(constant(1.0f), margin), per_wide = hn::Div(constant(0.05f), wide_margin);
            const auto nearness = [&](const GroundPoint& p) LR_LAMBDA {
                const VF part = neg_mul_add(p.gap, per_margin, constant(1.0f));
                const VF least = hn::Max(neg_mul_add(p.gap, per_wide, constant(0.05f)), zero);
                return hn::Min(hn::Max(part, least), constant(2.0f));
            };
            const auto farthest = [&](GroundPoint& to, VF least, const auto& measure) LR_LAMBDA {
                VF most = least;
                to.gap = empty;
                to.arm = to.at = to.normal = {zero, zero, zero};
                for (uint32_t k = 0; k < count; ++k) {
                    const VF value = hn::Mul(nearness(points[k]), measure(points[k]));
                    const auto near = hn::And(touching, hn::Lt(points[k].gap, wide_margin));
                    const auto more = hn::And(near, hn::Gt(value, most));
                    to = select(more, points[k], to);
                    most = hn::IfThenElse(more, value, most);
                }
            };
            // Points nearer to each other than this hold no better than one.
            const VF apart = hn::Mul(constant(0.02f), reach), apart_squared = hn::Mul(apart, apart);
            if (found > 1)
                farthest(best[1], apart_squared, [&](const GroundPoint& p) LR_LAMBDA {
                    const Vec3 r = sub(p.at, best[0].at);
                    return dot(r, r);
                });
            if (found > 2) {
                const Vec3 across = cross(best[0].normal, sub(best[1].at, best[0].at));
                const VF wide = hn::Mul(apart, hn::Sqrt(dot(across, across)));
                const auto side = [&](const GroundPoint& p) LR_LAMBDA { return dot(across, sub(p.at, best[0].at)); };
                const auto second = hn::Lt(best[1].gap, constant(0.5f * no_contact));
                farthest(best[2], wide, side);
                best[2].gap = hn::IfThenElse(second, best[2].gap, empty);
                if (found > 3) {
                    farthest(best[3], wide, [&](const GroundPoint& p) LR_LAMBDA { return hn::Neg(side(p)); });
                    best[3].gap = hn::IfThenElse(second, best[3].gap, empty);
                }
            }
        }
        const Vec3 x = load3(b.arrays, field_x, at);
        // As SurfaceMotion::lag_at.
        const float half = 0.5f * b.h;
        const float turned = half * half * (g.spin[0] * g.spin[0] + g.spin[1] * g.spin[1] + g.spin[2] * g.spin[2]);
        const VF one = constant(1.0f), less = hn::Sub(hn::Sqrt(hn::Max(hn::Sub(one, constant(turned)), zero)), one);
        for (uint32_t k = 0; k < manifold_slots; ++k) {
            ContactSlots::Slot& s = out[k];
            if (k >= found) {
                hn::Store(empty, d, s.gap + at);
                continue;
            }
            const Vec3 p = sub(add(x, best[k].at), broadcast(g.position));
            store3(s.arm, at, best[k].arm);
            store3(s.normal, at, best[k].normal);
            hn::Store(best[k].gap, d, s.gap + at);
            const Vec3 spin = broadcast(g.spin), along = cross(spin, p);
            store3(s.surface, at, add(broadcast(g.velocity), along));
            store3(s.lag, at, scale(constant(b.h), sub(scale(less, along), scale(constant(half), cross(spin, along)))));
            hn::Store(constant(g.friction), d, s.friction + at);
            hn::Store(constant(g.restitution), d, s.restitution + at);
            hn::Store(hn::Set(du, g.collider), du, s.collider + at);
        }
    }
    return any;
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
