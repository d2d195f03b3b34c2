// Contact with a plane, a heightfield or an even floor of a mesh: the few points of a body that hold it best. docs/maintainers/contact.md, section 3.
#if defined(LR_KERNEL_CONTACT_GROUND_CONTACT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_CONTACT_GROUND_CONTACT_INL_H_
#undef LR_KERNEL_CONTACT_GROUND_CONTACT_INL_H_
#else
#define LR_KERNEL_CONTACT_GROUND_CONTACT_INL_H_
#endif

#include "kernel/contact/body_contact_lanes-inl.h"
#include "kernel/contact/collider_contact.h"
#include "kernel/contact/collider_solver-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::LR_KERNEL_NAMESPACE {

// First sample of the cell at a place along an axis. place: in cells.
HWY_INLINE VF cell_at(const HeightGrid& grid, VF place, int axis) {
    const VF last = constant(static_cast<float>(grid.counts[axis] - 2));
    return hn::Max(hn::Min(hn::Floor(place), last), hn::Zero(DF()));
}
HWY_INLINE VF height_of(const HeightGrid& grid, VF i, VF k) {
    const DI di;
    const VI row = hn::Set(di, static_cast<int32_t>(grid.counts[0]));
    return hn::GatherIndex(DF(), grid.heights, hn::ConvertTo(di, i) + hn::ConvertTo(di, k) * row);
}
// The triangle of a cell below a place: `upper` has the corner (i, k + 1), the other one (i + 1, k).
struct HeightTriangle {
    VF h00, h11, corner;

    template <class Mask> HWY_INLINE VF height(Mask upper, VF fu, VF fw, VF& along_u, VF& along_w) const {
        along_w = hn::IfThenElse(upper, corner - h00, h11 - corner);
        along_u = hn::IfThenElse(upper, h11 - corner, corner - h00);
        return fu * along_u + (fw * along_w + h00);
    }
};
template <class Mask> HWY_INLINE HeightTriangle triangle_of(const HeightGrid& grid, VF i, VF k, Mask upper) {
    const VF one = constant(1.0f), next_i = i + one, next_k = k + one;
    return {height_of(grid, i, k), height_of(grid, next_i, next_k),
            height_of(grid, hn::IfThenElse(upper, i, next_i), hn::IfThenElse(upper, next_k, k))};
}

// Height of the ground below points, in the heightfield's frame; outside, that of its border.
HWY_INLINE VF height_within(const HeightGrid& grid, Vec3 p) {
    const auto within = [&](VF at, int axis) LR_LAMBDA {
        const VF last = constant(static_cast<float>(grid.counts[axis] - 1));
        return hn::Max(hn::Min(at * constant(grid.inverse_spacing[axis]), last), hn::Zero(DF()));
    };
    const VF u = within(p.x, 0), w = within(p.z, 1), i = cell_at(grid, u, 0), k = cell_at(grid, w, 1);
    const VF fu = u - i, fw = w - k;
    const auto upper = fw >= fu;
    VF along_u, along_w;
    return triangle_of(grid, i, k, upper).height(upper, fu, fw, along_u, along_w);
}
// Greatest height above that ground at which a body of this reach can touch it; includes rounding.
HWY_INLINE VF most_above(VF reach, float secant, VF height) {
    return reach * constant(secant) + constant(1e-6f) * hn::Abs(height);
}

// The ground below a point, in its own frame.
struct GroundSample {
    VF gap;               // height above the ground along its normal
    VF slope[2], inverse; // the normal is (slope[0], 1, slope[1]) inverse
};

HWY_INLINE Vec3 columns(const Matrix& m, Vec3 a) {
    return a.z * m.row[2] + a.y * m.row[1] + a.x * m.row[0];
}

// The highest triangle of a floor that a point is over; without any the gap is no_contact.
HWY_NOINLINE GroundSample floor_below(const FloorLanes& floor, size_t lane, Vec3 p) {
    const VF zero = hn::Zero(DF());
    GroundSample s{constant(no_contact), {zero, zero}, constant(1.0f)};
    VF least = constant(no_contact);
    for (uint32_t k = 0; k < floor.count; ++k) {
        const FloorLanes::Face& f = floor.face[k];
        const VF x = load1(f.slope[0], lane), z = load1(f.slope[1], lane), inverse = load1(f.inverse, lane);
        const VF above = p.y + (x * p.x + z * p.z) - load1(f.height, lane);
        auto here = above < least;
        for (uint32_t e = 0; e < 3; ++e) {
            const VF across = load1(f.across[e][0], lane) * p.x + load1(f.across[e][1], lane) * p.z;
            here = hn::And(here, across >= load1(f.edge[e], lane));
        }
        least = hn::IfThenElse(here, above, least);
        s.gap = hn::IfThenElse(here, above * inverse, s.gap);
        s.slope[0] = hn::IfThenElse(here, x, s.slope[0]);
        s.slope[1] = hn::IfThenElse(here, z, s.slope[1]);
        s.inverse = hn::IfThenElse(here, inverse, s.inverse);
    }
    return s;
}

// The ground below a vector's bodies. Bodies below half a cell overlap at most two by two cells, which are fetched once, with equal bits.
class GroundBelow {
public:
    HWY_INLINE GroundBelow(const HeightGrid& g, Vec3 middle, VF radius) : grid_(g) {
        few_ = false;
        if (!g.heights) return;
        const VF most = constant(0.45f);
        const VF greatest = constant(HWY_MAX(g.inverse_spacing[0], g.inverse_spacing[1]));
        few_ = hn::AllTrue(DF(), radius * greatest <= most);
        if (!few_) return;
        VF place[2][3];
        for (int axis = 0; axis < 2; ++axis) {
            const VF first = (axis == 0 ? middle.x : middle.z) - radius;
            first_[axis] = cell_at(g, first * constant(g.inverse_spacing[axis]), axis);
            const VF last = constant(static_cast<float>(g.counts[axis] - 1));
            for (int k = 0; k < 3; ++k) place[axis][k] = hn::Min(first_[axis] + constant(static_cast<float>(k)), last);
        }
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k) height_[i][k] = height_of(g, place[0][i], place[1][k]);
        for (int i = 0; i < 2; ++i)
            for (int k = 0; k < 2; ++k) {
                const VF h00 = height_[i][k], h11 = height_[i + 1][k + 1];
                const VF upper = height_[i][k + 1], lower = height_[i + 1][k];
                inverse_[i][k][0] = inverse_of(slope(h11 - upper, 0), slope(upper - h00, 1));
                inverse_[i][k][1] = inverse_of(slope(lower - h00, 0), slope(h11 - lower, 1));
            }
    }

    HWY_INLINE GroundSample at(Vec3 p) const {
        const VF zero = hn::Zero(DF());
        if (!grid_.heights) return {p.y, {zero, zero}, constant(1.0f)};
        const VF u = p.x * constant(grid_.inverse_spacing[0]);
        const VF w = p.z * constant(grid_.inverse_spacing[1]);
        const VF i = cell_at(grid_, u, 0), k = cell_at(grid_, w, 1), fu = u - i, fw = w - k;
        const auto upper = fw >= fu;
        HeightTriangle t;
        VF inverse;
        if (few_) {
            const auto next_i = i > first_[0], next_k = k > first_[1];
            const auto pick = [&](VF a, VF b, VF c, VF e) LR_LAMBDA { // of cells (0, 0), (1, 0), (0, 1), (1, 1)
                return hn::IfThenElse(next_k, hn::IfThenElse(next_i, e, c), hn::IfThenElse(next_i, b, a));
            };
            const auto& h = height_;
            t.h00 = pick(h[0][0], h[1][0], h[0][1], h[1][1]);
            t.h11 = pick(h[1][1], h[2][1], h[1][2], h[2][2]);
            t.corner = hn::IfThenElse(upper, pick(h[0][1], h[1][1], h[0][2], h[1][2]),
                                      pick(h[1][0], h[2][0], h[1][1], h[2][1]));
            const auto& n = inverse_;
            inverse = hn::IfThenElse(upper, pick(n[0][0][0], n[1][0][0], n[0][1][0], n[1][1][0]),
                                     pick(n[0][0][1], n[1][0][1], n[0][1][1], n[1][1][1]));
        } else {
            t = triangle_of(grid_, i, k, upper);
        }
        VF along_u, along_w;
        const VF surface = t.height(upper, fu, fw, along_u, along_w);
        GroundSample s{zero, {slope(along_u, 0), slope(along_w, 1)}, zero};
        s.inverse = few_ ? inverse : inverse_of(s.slope[0], s.slope[1]);
        const auto outside = [&](VF at_axis, int axis) LR_LAMBDA {
            return hn::Or(at_axis<zero, at_axis> constant(static_cast<float>(grid_.counts[axis] - 1)));
        };
        s.gap = hn::IfThenElse(hn::Or(outside(u, 0), outside(w, 1)), constant(no_contact), (p.y - surface) * s.inverse);
        return s;
    }

private:
    HWY_INLINE VF slope(VF rise, int axis) const { return -(rise * constant(grid_.inverse_spacing[axis])); }
    static HWY_INLINE VF inverse_of(VF x, VF z) {
        const VF one = constant(1.0f);
        return one / hn::Sqrt(x * x + (z * z + one));
    }

    const HeightGrid& grid_;
    bool few_;
    VF first_[2];         // first cell, by axis
    VF height_[3][3];     // by x, then z, from that cell on
    VF inverse_[2][2][2]; // by cell; of its upper and its lower triangle
};

// Thick ellipsoids roll on a single point, but in a valley they rest on several, and those that rock (Rocking) as flat ones do.
inline uint32_t ellipsoid_points(const Rocking& rocking, bool curved) {
    return rocking.most[0] > 0.0f || rocking.most[1] > 0.0f ? 8 : curved ? 5 : 1;
}

// A core point, m from the centre of mass in the surface's frame, and its gap.
struct GroundPoint {
    Vec3 at;
    VF gap;
};

// A body's points, in the frame of the surface.
class GroundPoints {
public:
    HWY_INLINE GroundPoints(const ContactBodies& b, const Rocking& rocking, const GroundSurface& g, size_t at,
                            VF radius)
        : shape_(b.shape), rocking_(rocking), scale_(load1(b.arrays, field_scale, at)), floor_(g.floor), lane_(at),
          axes_(axes_of(g, at)),
          local_(floor_ ? zero3() : axes_ * (load3(b.arrays, field_x, at) - broadcast(g.position))),
          below_(g.grid, local_, radius) {
        const Quaternion q = load4(b.arrays, at);
        for (int k = 0; k < 3; ++k) turned_.row[k] = to_body(q, axes_.row[k]);
        for (int k = 0; k < 3; ++k) scaled_.row[k] = scale_ * turned_.row[k];
        radius_ = scale_ * constant(b.shape.count == 0 ? 0.0f : b.shape.radius);
    }

    // A core point at scale 1.
    HWY_INLINE GroundPoint get(float x, float y, float z, GroundSample& sample) const {
        const Vec3 p{constant(x), constant(y), constant(z)};
        return point(scaled_ * p, sample);
    }
    // Points of an ellipsoid; the first is the nearest. The nearest point of one that rocks jumps from rim to rim at the slightest tilt, so four more
    // are contacts at a small tilt, and three are for mirrored normals. Others have four for slopes around them.
    HWY_INLINE GroundPoint of_ellipsoid(uint32_t k, GroundSample& sample) const {
        const ShapeConstants& s = shape_;
        const Vec3 axes = scale_ * broadcast(s.semi_axes), center = scale_ * broadcast(s.center);
        const auto rocks_first = scale_ < constant(rocking_.most[0]),
                   rocks_second = scale_ < constant(rocking_.most[1]);
        const auto rocks = hn::Or(rocks_first, rocks_second);
        Vec3 from = turned_ * center;
        if (k != 0 && k <= 4) { // within the reach, since no cells beyond are fetched
            const VF beside = scale_ * constant((k & 1) != 0 ? rocking_.longest : -rocking_.longest);
            VF& along = k <= 2 ? from.x : from.z;
            along += hn::IfThenZeroElse(rocks, beside);
        }
        GroundPoint p = point(from, sample);
        const auto support = [&](Vec3 n) LR_LAMBDA {
            const Vec3 stretched = times(axes, n);
            const VF inverse = inverse_length(hn::Sqrt(dot(stretched, stretched)));
            const Vec3 arm = center - inverse * times(axes, stretched);
            return point(turned_ * arm, sample);
        };
        // On a slope another part of the surface is below the support point. One iteration suffices for bodies below a cell's size; planes need none.
        Vec3 n = columns(turned_, normal(sample));
        p = support(n);
        n = columns(turned_, normal(sample));
        p = support(n);
        if (k == 0 || hn::AllFalse(DF(), rocks)) return p;
        const uint32_t shortest = rocking_.shortest;
        VF* const along[3] = {&n.x, &n.y, &n.z};
        VF &first = *along[(shortest + 1) % 3], &second = *along[(shortest + 2) % 3];
        if (k <= 4) {
            const float tilt = k <= 2 ? rocking_.tilt[0] : rocking_.tilt[1];
            VF& tilted = k <= 2 ? first : second;
            tilted += hn::IfThenElseZero(k <= 2 ? rocks_first : rocks_second, constant((k & 1) != 0 ? tilt : -tilt));
        } else {
            if (k != 6) first = hn::IfThenElse(rocks_first, -first, first);
            if (k != 5) second = hn::IfThenElse(rocks_second, -second, second);
        }
        return support(n);
    }
    HWY_NOINLINE GroundSample sample_at(Vec3 at) const {
        return floor_ ? floor_below(*floor_, lane_, at) : below_.at(local_ + at);
    }
    HWY_INLINE VF gap_of(const GroundSample& sample) const { return sample.gap - radius_; }
    HWY_INLINE Vec3 to_world(Vec3 a) const { return transposed_times(axes_, a); }
    // The point on the surface of the body, body frame.
    HWY_INLINE Vec3 arm(Vec3 at, Vec3 n) const { return columns(turned_, at - radius_ * n); }
    // Pushes the body out along n until no point is deeper than a hundredth of `deep`. Impulses act on at most four points: the lowest that remains
    // replaces the one with the least impulse, then Gauss-Seidel solves for the shift and both tilts. Sets the gaps after the push, and loaded to 1
    // for points that hold. Independent of other lanes.
    HWY_INLINE void push_out(const ContactBodies& b, Vec3 n, VF deep, uint32_t count, GroundPoint* points,
                             VF* loaded) const {
        constexpr int rounds = 8, sweeps = 10;
        const VF zero = hn::Zero(DF()), one = constant(1.0f), inverse = one / (scale_ * constant(b.body->length));
        Vec3 first, second;
        tangents(n, first, second);
        const Vec3 none = zero3(), own = columns(turned_, n);
        const Vec3 about[2] = {columns(turned_, first), columns(turned_, second)};
        const auto gain = [&](const Twist& impulse) LR_LAMBDA {
            const Twist t = symmetric6(b.body->full_inverse, impulse);
            return Vec3{dot(own, t.v), dot(about[0], t.u), dot(about[1], t.u)};
        };
        const Vec3 gains[3] = {gain({own, none}), gain({none, about[0]}), gain({none, about[1]})};
        VF seen[most_ground_points][2]; // rise of a point by each unit tilt; by a unit shift it is 1
        for (uint32_t k = 0; k < count; ++k) {
            seen[k][0] = inverse * dot(second, points[k].at);
            seen[k][1] = -(inverse * dot(first, points[k].at));
        }
        struct Pushed {
            VF gap, seen[2], inverse, pressed;
            Vec3 response;
        } held[manifold_slots];
        for (Pushed& h : held) h = {zero, {zero, zero}, zero, zero, none};
        Vec3 moved = none;
        const auto after = [&](VF gap, const VF(&turns)[2])
                               LR_LAMBDA { return gap + (moved.x + (turns[0] * moved.y + turns[1] * moved.z)); };
        const VF dust = constant(0.01f) * deep;
        for (int round = 0; round < rounds; ++round) {
            VF least = zero, gap = zero, turn[2] = {zero, zero};
            for (uint32_t k = 0; k < count; ++k) {
                const VF now = after(points[k].gap, seen[k]);
                const auto lower = now < least;
                least = hn::IfThenElse(lower, now, least);
                gap = hn::IfThenElse(lower, points[k].gap, gap);
                for (int i = 0; i < 2; ++i) turn[i] = hn::IfThenElse(lower, seen[k][i], turn[i]);
            }
            const auto active = least < -dust;
            if (hn::AllFalse(DF(), active)) break;
            VF light = held[0].pressed;
            for (const Pushed& h : held) light = hn::Min(light, h.pressed);
            auto free = active; // where the lowest point is not held yet
            for (const Pushed& h : held)
                free = hn::AndNot(hn::And(hn::And(h.seen[0] == turn[0], h.seen[1] == turn[1]), h.gap == gap), free);
            const Vec3 response = gains[0] + turn[0] * gains[1] + turn[1] * gains[2];
            const VF ratio = inverse_length(response.x + (turn[0] * response.y + turn[1] * response.z));
            for (Pushed& h : held) {
                const auto here = hn::And(free, h.pressed == light);
                free = hn::AndNot(here, free);
                moved = moved - hn::IfThenElseZero(here, h.pressed) * h.response;
                h.gap = hn::IfThenElse(here, gap, h.gap);
                h.inverse = hn::IfThenElse(here, ratio, h.inverse);
                h.pressed = hn::IfThenElse(here, zero, h.pressed);
                h.response = select(here, response, h.response);
                for (int i = 0; i < 2; ++i) h.seen[i] = hn::IfThenElse(here, turn[i], h.seen[i]);
            }
            const int filled = HWY_MIN(round + 1, static_cast<int>(manifold_slots)); // each round holds one more
            for (int sweep = 0; sweep < sweeps; ++sweep)
                for (int k = 0; k < filled; ++k) {
                    Pushed& h = held[k];
                    const VF now = after(h.gap, h.seen), had = h.pressed;
                    h.pressed = hn::IfThenElse(active, hn::Max(had - now * h.inverse, zero), had);
                    moved += (h.pressed - had) * h.response;
                }
        }
        for (uint32_t k = 0; k < count; ++k) {
            const VF gap = points[k].gap;
            points[k].gap = after(gap, seen[k]);
            loaded[k] = hn::IfThenElseZero(points[k].gap < zero, one);
            for (const Pushed& h : held) {
                const auto same = hn::And(hn::And(h.seen[0] == seen[k][0], h.seen[1] == seen[k][1]), h.gap == gap);
                loaded[k] = hn::IfThenElse(hn::And(same, h.pressed > zero), one, loaded[k]);
            }
        }
    }
    static HWY_INLINE Vec3 normal(const GroundSample& s) {
        return {s.slope[0] * s.inverse, s.inverse, s.slope[1] * s.inverse};
    }

private:
    static HWY_INLINE Matrix axes_of(const GroundSurface& g, size_t at) {
        Matrix m;
        for (int k = 0; k < 3; ++k) m.row[k] = g.floor ? load3(g.floor->axes + 3 * k, at) : broadcast(g.axes + 3 * k);
        return m;
    }
    HWY_INLINE GroundPoint point(Vec3 at, GroundSample& sample) const {
        sample = sample_at(at);
        return {at, gap_of(sample)};
    }

    const ShapeConstants& shape_;
    const Rocking& rocking_;
    VF scale_, radius_;
    const FloorLanes* floor_;
    size_t lane_;
    Matrix axes_; // of the frame, in the world
    Vec3 local_;  // of the centre of mass
    Matrix turned_, scaled_;
    GroundBelow below_;
};

// Whether the surface is farther than `radius` from all centres, or there is no floor. Over a heightfield, points within `radius` are at most
// radius * secant lower.
HWY_INLINE bool far_above(const GroundSurface& g, Vec3 x, VF radius, size_t at) {
    if (g.floor) return g.floor->count == 0 || hn::AllTrue(DF(), load1(g.floor->face[0].inverse, at) == hn::Zero(DF()));
    const Vec3 p = rows(g.axes, x - broadcast(g.position));
    if (!g.grid.heights) return hn::AllFalse(DF(), p.y <= radius);
    const VF height = height_within(g.grid, p);
    return hn::AllFalse(DF(), p.y - height <= most_above(radius, g.grid.secant, height));
}

// Margin below which a point is a contact: 0.005 of the reach, the fall in a substep, and the rounding of the position.
HWY_INLINE VF contact_margin(const ContactBodies& b, VF reach, Vec3 x) {
    return constant(0.005f) * reach + (constant(1e-6f) * greatest(x) + constant(b.gravity * (b.h * b.h)));
}

// Normals that differ by more than this (length of the difference) form an edge that the points could miss.
constexpr float sharp = 0.2f;

// The deepest point, and up to three that span about the largest quadrilateral with it, loaded ones first.
bool touch_ground(const ContactBodies& b, const GroundSurface& g, ContactSlots::Slot (&out)[manifold_slots],
                  uint32_t* rough) {
    const DU du;
    const bool ellipsoid = b.shape.count == 0;
    const bool curved = g.grid.heights || g.floor;
    const uint32_t points_there = curved ? b.shape.sample_count : b.shape.count;
    const Rocking rocking(b.shape.semi_axes, ellipsoid ? b.gravity * (b.h * b.h) : 0.0f);
    const uint32_t count = ellipsoid ? ellipsoid_points(rocking, curved) : points_there;
    bool any = false;
    const VF empty = constant(no_contact), zero = hn::Zero(DF()), one = constant(1.0f);
    GroundPoint points[most_ground_points];
    // As in SurfaceMotion::lag_at().
    const float half = 0.5f * b.h;
    const float turned = half * half * (g.spin[0] * g.spin[0] + g.spin[1] * g.spin[1] + g.spin[2] * g.spin[2]);
    const VF less = hn::Sqrt(hn::Max(one - constant(turned), zero)) - one;
    for (size_t at = 0; at < b.count; at += hn::Lanes(DF())) {
        const VF reach = constant(b.shape.reach) * load1(b.arrays, field_scale, at);
        const Vec3 x = load3(b.arrays, field_x, at);
        const VF margin = contact_margin(b, reach, x);
        for (ContactSlots::Slot& s : out) store1(s.gap, at, empty);
        if (far_above(g, x, reach + (margin + margin), at)) continue;

        const GroundPoints all(b, rocking, g, at, reach + margin);
        Vec3 deepest = zero3();
        VF least = empty, alike = one; // least cosine between the first point's normal and another's
        Vec3 first_normal = deepest;
        for (uint32_t k = 0; k < count; ++k) {
            GroundSample sample;
            points[k] =
                ellipsoid ? all.of_ellipsoid(k, sample) : all.get(b.shape.x[k], b.shape.y[k], b.shape.z[k], sample);
            const auto deeper = points[k].gap < least;
            least = hn::IfThenElse(deeper, points[k].gap, least);
            deepest = select(deeper, points[k].at, deepest);
            if (k == 0) first_normal = GroundPoints::normal(sample);
            const VF cosine = (first_normal.x * sample.slope[0] + (first_normal.z * sample.slope[1] + first_normal.y)) *
                              sample.inverse;
            alike = hn::Min(alike, cosine);
        }
        const auto touching = least < margin;
        if (hn::AllFalse(DF(), touching)) continue;
        any = true;
        if (g.grid.heights) {
            const auto uneven = hn::And(touching, alike < constant(1.0f - 0.5f * sharp * sharp));
            store1(rough, at, hn::IfThenElseZero(hn::RebindMask(du, uneven), hn::Set(du, 1)));
        }
        const auto put = [&](uint32_t slot, Vec3 point, hn::Mask<DF> there) LR_LAMBDA {
            const GroundSample sample = all.sample_at(point);
            const Vec3 n = GroundPoints::normal(sample);
            ContactSlots::Slot& s = out[slot];
            const Vec3 p = x + all.to_world(point) - broadcast(g.position);
            store3(s.arm, at, all.arm(point, n));
            store3(s.normal, at, all.to_world(n));
            store1(s.gap, at, hn::IfThenElse(there, all.gap_of(sample), empty));
            const Vec3 spin = broadcast(g.spin), along = cross(spin, p);
            store3(s.surface, at, broadcast(g.velocity) + along);
            store3(s.lag, at, constant(b.h) * (less * along - constant(half) * cross(spin, along)));
            store1(s.friction, at, constant(g.friction));
            store1(s.restitution, at, constant(g.restitution));
            store1(s.collider, at, hn::Set(du, g.collider));
            return n;
        };
        const Vec3 normal = put(0, deepest, touching);
        if (count < 2) continue;

        // Loaded points hold the body once it is pushed out: also beyond a boat's keel, and below the middle of a curved body whose rim is as low
        // within a substep's fall. Others count a fifth at most, as the push is approximate. Points closer than `apart` count as one.
        const VF deep = hn::Max(-least, zero), per_wide = one / (constant(0.1f) * reach + margin + (deep + deep));
        const VF apart = constant(0.02f) * reach;
        VF weight[most_ground_points];
        all.push_out(b, normal, deep, count, points, weight);
        Vec3 second = deepest;
        VF farthest = zero;
        auto found = one < zero;
        for (uint32_t k = 0; k < count; ++k) {
            const VF near = constant(0.2f) * hn::Max(one - points[k].gap * per_wide, zero);
            weight[k] = hn::IfThenElseZero(touching, hn::Max(weight[k], near));
            const Vec3 r = points[k].at - deepest;
            const VF square = dot(r, r), value = weight[k] * square;
            const auto more = hn::And(value > farthest, square > apart * apart);
            second = select(more, points[k].at, second);
            farthest = hn::IfThenElse(more, value, farthest);
            found = hn::Or(found, more);
        }
        put(1, second, found);
        if (count < 3 || hn::AllFalse(DF(), found)) continue;
        // Then the point farthest from that line, and the point that adds most to the triangle.
        Vec3 corner[manifold_slots] = {deepest, second, deepest, deepest};
        VF turn = one; // -1: corners go clockwise
        for (uint32_t next = 2; next < manifold_slots && next < count; ++next) {
            VF most = zero, side = one;
            for (uint32_t edge = 0; edge < (next == 2 ? 1u : 3u); ++edge) {
                const Vec3 from = corner[edge], across = cross(normal, corner[edge == 2 ? 0 : edge + 1] - from);
                const VF least_area = apart * hn::Sqrt(dot(across, across));
                for (uint32_t k = 0; k < count; ++k) {
                    const VF along = dot(across, points[k].at - from),
                             area = next == 2 ? hn::Abs(along) : -(turn * along);
                    const VF value = weight[k] * area;
                    const auto more = hn::And(area > least_area, value > most);
                    corner[next] = select(more, points[k].at, corner[next]);
                    most = hn::IfThenElse(more, value, most);
                    side = hn::IfThenElse(more, along, side);
                }
            }
            if (next == 2) turn = hn::CopySign(one, side);
            found = hn::And(found, most > zero);
            put(next, corner[next], found);
        }
    }
    return any;
}
} // namespace lr::LR_KERNEL_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
