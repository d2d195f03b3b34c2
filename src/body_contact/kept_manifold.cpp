#include "body_contact/kept_manifold.h"

#include "base/float4.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace lr {
namespace {

// Times the smaller reach: how far bodies may move along the normal and across it. With fewer than three contacts they can be at a corner or
// an edge, which slides away sooner.
constexpr float most_along = 5e-3f, most_across = 2e-2f, most_across_edge = 2.5e-3f;
constexpr uint32_t face_contacts = 3;

// Times the reach: contacts of two manifolds nearer than this are the same.
constexpr float same_place = 0.1f;

float smaller_reach(const PairBody& a, const PairBody& b) {
    return std::min(a.reach(), b.reach());
}

// b as seen from a when the substep begins, as in CachedPair.
struct Placed {
    Vector offset;
    Rotation turn;
    Placed(const PairBody& a, const PairBody& b)
        : offset(rotate(inverse(a.from.rotation), b.from.position - a.from.position)),
          turn(inverse(a.from.rotation) * b.from.rotation) {}
};

// How far points of b have at most moved against a since the manifold was found, m: along the normal, and in all.
struct Slid {
    float along, across;
    Slid(const CachedPair& pair, const Placed& now, float reach_b) {
        const Rotation turned = now.turn * inverse(pair.turn);
        const float twice = turned.w < 0.0f ? -2.0f : 2.0f;
        const Vector n = pair.of_b != 0 ? rotate(now.turn, pair.normal) : pair.normal;
        const Vector way = now.offset - pair.offset, turn = twice * Vector{turned.x, turned.y, turned.z};
        along = std::abs(dot(n, way)) + reach_b * length(cross(n, turn));
        across = length(way) + reach_b * length(turn);
    }
};

// How well a direction in a body's frame fits one of its faces: 1 at best.
float fits_face(const PairHull& hull, Vector normal) {
    const Vector n = rotate(inverse(hull.frame), normal);
    Float4 best = all(-1.0f);
    for (uint32_t f = 0; f < hull.shape.face_count; f += PairHull::lanes)
        best = greater(n.x * load(hull.face_x + f) + n.y * load(hull.face_y + f) + n.z * load(hull.face_z + f), best);
    return greatest(best);
}

// After a change of scale, or from a forged snapshot, contacts could be far off the bodies.
bool arms_fit(const CachedPair& pair, const PairBody& a, const PairBody& b) {
    const float most_a = 2.0f * a.reach() * a.reach(), most_b = 2.0f * b.reach() * b.reach();
    return std::all_of(pair.contact, pair.contact + pair.count, [&](const CachedPair::Contact& c) {
        return dot(c.arm_a, c.arm_a) <= most_a && dot(c.arm_b, c.arm_b) <= most_b;
    });
}

// Each contact takes the impulse of the nearest one of the manifold before; friction lasts with the first of them.
void take_impulses(const CachedPair& from, float reach, CachedPair& to) {
    bool taken[most_pair_contacts] = {};
    for (CachedPair::Contact& c : std::span(to.contact, to.count)) {
        float least = same_place * same_place * reach * reach;
        uint32_t best = most_pair_contacts;
        for (uint32_t k = 0; k < from.count; ++k) {
            const Vector away = from.contact[k].arm_a - c.arm_a;
            if (taken[k] || !(dot(away, away) < least)) continue;
            least = dot(away, away);
            best = k;
        }
        if (best == most_pair_contacts) continue;
        taken[best] = true;
        c.pressed = from.contact[best].pressed;
        to.drag = from.drag;
        to.spin = from.spin;
    }
}
} // namespace

float kept_way(const PairBody& a, const PairBody& b) {
    return most_along * smaller_reach(a, b);
}

bool kept_manifold(const CachedPair& cached, const PairBody& a, const PairBody& b, float within, Manifold& out) {
    const Slid slid(cached, Placed(a, b), b.reach());
    const float across = (cached.count < face_contacts ? most_across_edge : most_across) * smaller_reach(a, b);
    // Also false for NaN.
    if (!(slid.along <= kept_way(a, b) && slid.across <= across && within + slid.along <= cached.within) ||
        !arms_fit(cached, a, b))
        return false;
    out.count = cached.count;
    const Vector normal = rotate((cached.of_b != 0 ? b : a).from.rotation, cached.normal);
    const Vector apart = a.from.position - b.from.position;
    for (uint32_t k = 0; k < cached.count; ++k) {
        const CachedPair::Contact& c = cached.contact[k];
        const Vector on_a = rotate(a.from.rotation, c.arm_a), on_b = rotate(b.from.rotation, c.arm_b);
        out.contact[k] = {c.arm_a, c.arm_b, normal, dot(normal, apart + (on_a - on_b))};
    }
    return true;
}

CachedPair cached_pair(uint64_t key_a, uint64_t key_b, const PairBody& a, const PairBody& b, const Manifold& found,
                       float within, const CachedPair* before) {
    const Placed now(a, b);
    CachedPair out{};
    out.a = key_a;
    out.b = key_b;
    out.offset = now.offset;
    out.turn = now.turn;
    out.within = within;
    out.count = static_cast<uint16_t>(found.count);
    const Vector normal_a = rotate(inverse(a.from.rotation), found.contact[0].normal);
    const Vector normal_b = rotate(inverse(b.from.rotation), found.contact[0].normal);
    out.of_b = fits_face(*a.shape, -normal_a) < fits_face(*b.shape, normal_b) ? 1 : 0;
    out.normal = out.of_b != 0 ? normal_b : normal_a;
    for (uint32_t k = 0; k < found.count; ++k) out.contact[k] = {found.contact[k].arm_a, found.contact[k].arm_b, 0.0f};
    if (before) take_impulses(*before, smaller_reach(a, b), out);
    return out;
}

Manifold other_way_round(Manifold m) {
    for (PairContact& c : std::span(m.contact, m.count)) {
        std::swap(c.arm_a, c.arm_b);
        c.normal = -c.normal;
    }
    return m;
}
} // namespace lr
