// The sweeps of body contact: Gauss-Seidel over units, the step along the former direction, rolling (docs/maintainers/contact.md, 13).
#if defined(LR_KERNEL_CONTACT_BODY_CONTACT_SWEEPS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_CONTACT_BODY_CONTACT_SWEEPS_INL_H_
#undef LR_KERNEL_CONTACT_BODY_CONTACT_SWEEPS_INL_H_
#else
#define LR_KERNEL_CONTACT_BODY_CONTACT_SWEEPS_INL_H_
#endif

#include "kernel/contact/body_contact_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::LR_KERNEL_NAMESPACE {

// Squares of impulses over a mass, m^2 or m^2/s^2. A unit with larger changes, or NaN, does not act on its bodies and is dropped for the
// substep.
constexpr float most_change = 1e30f;

HWY_INLINE void let_go(PairBlock& block, size_t at, hn::Mask<DF> fine) {
    const auto keep = [&](LaneRow& row) LR_LAMBDA { store1(row, at, hn::IfThenElseZero(fine, load1(row, at))); };
    for (uint32_t k = 0; k < block.used; ++k) {
        PairBlock::Row& row = block.row[k];
        for (LaneRow* of : {&row.inverse, &row.pressed, &row.change, &row.search}) keep(*of);
    }
    for (LaneRow* three : {block.friction.dragged, block.friction.change, block.friction.search})
        for (int i = 0; i < 3; ++i) keep(three[i]);
}

// Moves an impulse by `part` of its search direction. The next direction is that step plus the impulse's last change.
HWY_INLINE VF followed(float* impulse, float* search, const float* change, size_t at, VF part) {
    const VF more = part * load1(search, at);
    store1(search, at, more + load1(change, at));
    return load1(impulse, at) + more;
}

// Friction of a unit against the slip. The forces come first; the couple then sees the spin that they leave.
HWY_INLINE Vec3 drag_unit(PairBlock& block, size_t at, Vec3 slip, Vec3 dragged, VF load, VF dust) {
    PairBlock::Friction& f = block.friction;
    Row r;
    for (int i = 0; i < 3; ++i) r.hold[i] = load1(f.hold[i], at);
    r.least = load1(f.least, at);
    r.friction = load1(f.most, at);
    r.pressed = load;
    r.dragged[0] = dragged.x, r.dragged[1] = dragged.y;
    Vec3 step;
    drag(r, slip.x - load1(f.drift[0], at), slip.y - load1(f.drift[1], at), dust, step.x, step.y);
    const VF spin = load1(block.drag_drag[2], at) * step.x + load1(block.drag_drag[4], at) * step.y +
                    (slip.z - load1(f.drift[2], at));
    const VF most = load1(f.radius, at) * (r.friction * load);
    const VF wanted = dragged.z - load1(f.hold_spin, at) * spin;
    const VF couple = hn::Max(hn::Min(hn::IfThenElse(hn::Abs(spin) > dust, wanted, dragged.z), most), -most);
    step.z = couple - dragged.z;
    store3(f.dragged, at, {r.dragged[0], r.dragged[1], couple});
    return step;
}

template <bool kFull, bool kPair> HWY_INLINE bool sweep(const BodyContactInput& in, PairBlock& block, VF part) {
    const VF zero = hn::Zero(DF());
    GatheredTwists twists(in, block);
    bool changed = false;
    for (size_t at = 0; at < block.lanes; at += hn::Lanes(DF())) {
        const Side a = side_a(in, block, at), b = side_b(in, block, at);
        const VF dust = load1(block.dust, at);
        Twist ta = load6(twists.a, at), tb = load6(twists.b, at);
        Reduced seen = reduced(kPair ? motion_of(a, ta) - motion_of(b, tb) : motion_of(a, ta)),
                impulse{zero3(), zero3()};
        VF change = zero, load = zero, squares = zero;
        for (uint32_t k = 0; k < block.used; ++k) {
            PairBlock::Row& row = block.row[k];
            const Vec3 direction = press_direction(row, at);
            Row r;
            r.inverse = load1(row.inverse, at);
            r.target = load1(row.target, at);
            if constexpr (!kPair) r.push = load1(row.push, at);
            r.pressed = followed(row.pressed, row.search, row.change, at, part);
            const VF more = press<!kPair>(r, dot(direction, seen.press), dust, constant(1.0f));
            const Vec3 along = more * direction;
            seen.press += symmetric(block.press_press, at, along);
            impulse.press += along;
            store1(row.pressed, at, r.pressed);
            store1(row.change, at, more);
            squares += more * more;
            load += r.pressed;
            change = hn::Max(change, hn::Abs(more));
        }
        PairBlock::Friction& f = block.friction;
        Vec3 dragged;
        dragged.x = followed(f.dragged[0], f.search[0], f.change[0], at, part);
        dragged.y = followed(f.dragged[1], f.search[1], f.change[1], at, part);
        dragged.z = followed(f.dragged[2], f.search[2], f.change[2], at, part);
        const Vec3 slip = transposed_times(load_matrix(block.press_drag, at), impulse.press) + seen.drag;
        impulse.drag = drag_unit(block, at, slip, dragged, load, dust);
        store3(f.change, at, impulse.drag);
        squares += dot(impulse.drag, impulse.drag);
        change = hn::Max(change, greatest(impulse.drag));
        push<kFull, kPair>(a, b, impulse, ta, tb);
        VF more = load1(block.solid, at) * impulse.press.x;
        const auto fine = squares <= constant(most_change);
        if (HWY_UNLIKELY(!hn::AllTrue(DF(), fine))) {
            let_go(block, at, fine);
            ta = select(fine, ta, load6(twists.a, at));
            tb = select(fine, tb, load6(twists.b, at));
            squares = hn::IfThenElseZero(fine, squares);
            more = hn::IfThenElseZero(fine, more);
            change = hn::IfThenElseZero(fine, change);
        }
        store6(twists.a, at, ta);
        if constexpr (kPair) store6(twists.b, at, tb);
        store1(block.changed, at, squares);
        store1(twists.a[6], at, load1(twists.a[6], at) + more);
        changed = changed || !hn::AllTrue(DF(), hn::Eq(change, zero));
    }
    if (changed) twists.put_back(in, block);
    return changed;
}

bool body_contact_sweep(const BodyContactInput& in, PairBlock& block, float part) {
    const bool full = full_mass(in, block);
    if (between_bodies(block))
        return full ? sweep<true, true>(in, block, constant(part)) : sweep<false, true>(in, block, constant(part));
    return full ? sweep<true, false>(in, block, constant(part)) : sweep<false, false>(in, block, constant(part));
}

// Moves each body by `part` of its search direction. The next direction is that step plus the last sweep's change.
void body_contact_follow(const BodyContactInput& in, const SolverSearch& search, uint32_t begin, uint32_t end,
                         float part) {
    // Not beyond a body: its neighbours can be another thread's.
    const hn::CappedTag<float, twist_floats> d;
    float *const twist = in.twists[0].v, *const before = search.before[0].v, *const direction = search.direction[0].v;
    const auto share = hn::Set(d, part);
    for (size_t at = begin * twist_floats; at < end * twist_floats; at += hn::Lanes(d)) {
        const auto now = hn::LoadU(d, twist + at), more = hn::Mul(share, hn::LoadU(d, direction + at)),
                   on = hn::Add(now, more);
        hn::StoreU(hn::Add(more, hn::Sub(now, hn::LoadU(d, before + at))), d, direction + at);
        hn::StoreU(on, d, before + at);
        hn::StoreU(on, d, twist + at);
    }
}

// The couple against rolling and spinning, bounded by the normal impulses.
bool body_contact_roll(const BodyContactInput& in, uint32_t kind, uint32_t begin) {
    const SolverBodyKind& k = in.kinds[kind];
    if (k.rolling == 0.0f) return false;
    bool loaded = false;
    for (size_t lane = 0; lane < contact_lanes; ++lane) loaded = loaded || in.twists[begin + lane].load > 0.0f;
    if (!loaded) return false;
    GatheredBodies bodies(in, begin);
    auto& row = bodies.row;
    auto& twist = bodies.twist;
    const VF zero = hn::Zero(DF()), spin_hold = constant(1.0f / most_turned<true>(*k.body));
    bool changed = false;
    for (size_t at = 0; at < contact_lanes; at += hn::Lanes(DF())) {
        const VF load = hn::Max(load1(twist[6], at), zero);
        const Size size = size_of(k, row, at);
        const VF most = constant(k.rolling) * (size.reach * size.inverse) * load;
        const Twist t = load6(twist, at);
        Vec3 rolled = load3(row + at_rolled, at);
        const Vec3 step = hold_spin(rolled, t.u, spin_hold, most, load1(row[at_dust], at));
        store3(row + at_rolled, at, rolled);
        store6(twist, at, t + turned_by<true>(*k.body, step));
        changed = changed || !hn::AllTrue(DF(), hn::Eq(greatest(step), zero));
    }
    if (!changed) return false;
    bodies.put_back(in, begin);
    return true;
}
} // namespace lr::LR_KERNEL_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
