#include "body_contact/kept_manifold.h"

#include "base/float4.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace lr {
namespace {

// Shares of the smaller reach: how far bodies may move against each other along the normal, and in all. Fewer than three contacts can lie on
// a corner or an edge, which slides away sooner.
constexpr float most_along = 5e-3f, most_across = 2e-2f, most_across_edge = 2.5e-3f;
constexpr uint32_t face_contacts = 3;

// Share of the smaller reach: contacts of two manifolds nearer than this are the same.
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

// A pair as it was searched.
struct Searched {
    Rotation turn;
    Vector normal; // a's frame
    explicit Searched(const CachedPair& pair) : turn(pair.turn.unpacked()) {
        const Vector packed = pair.normal.times(1.0f), n = 1.0f / length(packed) * packed;
        normal = (pair.sides & CachedPair::face_of_b) != 0 ? rotate(turn, n) : n;
    }
};

// Arms are at most sqrt(2) times the reach.
constexpr float longest_arm = 1.5f;

struct Arms {
    Vector a, b; // m
    Arms(const CachedPair& pair, const Searched& then, uint32_t k, const PairBody& of_a, const PairBody& of_b) {
        const Vector apart = pair.offset + pair.gap[k] * then.normal;
        if ((pair.sides & CachedPair::arms_of_b) != 0) {
            b = pair.arm[k].times(longest_arm * of_b.reach());
            a = rotate(then.turn, b) + apart;
        } else {
            a = pair.arm[k].times(longest_arm * of_a.reach());
            b = rotate(inverse(then.turn), a - apart);
        }
    }
};

// Bounds of how far points of b have moved against a since the manifold was found, m: along the normal, and in all.
struct Slid {
    float along, across;
    Slid(const CachedPair& pair, const Searched& then, const Placed& now, float reach_b) {
        const Rotation turned = now.turn * inverse(then.turn);
        const bool of_b = (pair.sides & CachedPair::face_of_b) != 0;
        const Vector n = of_b ? rotate(turned, then.normal) : then.normal;
        const Vector way = now.offset - pair.offset, turn = chord(turned);
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

// A forged snapshot, or a former body with the same noise seed, could give contacts far off the bodies.
bool fits(Vector arm, const PairBody& body) {
    return dot(arm, arm) <= 2.0f * body.reach() * body.reach();
}

// Each contact takes the impulse of the nearest contact of the former manifold. If any does, friction is taken over too.
void take_impulses(const CachedPair& from, const PairBody& a, const PairBody& b, const Manifold& found,
                   CachedPair& to) {
    const Searched then(from);
    const float reach = smaller_reach(a, b);
    Vector arm[most_pair_contacts];
    for (uint32_t k = 0; k < from.count; ++k) arm[k] = Arms(from, then, k, a, b).a;
    bool taken[most_pair_contacts] = {};
    for (uint32_t i = 0; i < to.count; ++i) {
        float least = same_place * same_place * reach * reach;
        uint32_t best = most_pair_contacts;
        for (uint32_t k = 0; k < from.count; ++k) {
            const Vector away = arm[k] - found.contact[i].arm_a;
            if (taken[k] || !(dot(away, away) < least)) continue;
            least = dot(away, away);
            best = k;
        }
        if (best == most_pair_contacts) continue;
        taken[best] = true;
        to.pressed[i] = from.pressed[best];
        to.drag = from.drag;
        to.spin = from.spin;
    }
}

// The contacts of a pair where its bodies are now. False if they are far off the bodies.
bool contacts_of(const CachedPair& pair, const Searched& then, const PairBody& a, const PairBody& b, Manifold& out) {
    const bool of_b = (pair.sides & CachedPair::face_of_b) != 0;
    const Vector normal =
        of_b ? rotate(b.from.rotation, rotate(inverse(then.turn), then.normal)) : rotate(a.from.rotation, then.normal);
    const Vector apart = a.from.position - b.from.position;
    out.count = pair.count;
    for (uint32_t k = 0; k < pair.count; ++k) {
        const Arms arms(pair, then, k, a, b);
        if (!fits(arms.a, a) || !fits(arms.b, b)) return false;
        const Vector on_a = rotate(a.from.rotation, arms.a), on_b = rotate(b.from.rotation, arms.b);
        out.contact[k] = {arms.a, arms.b, normal, dot(normal, apart + (on_a - on_b))};
    }
    return true;
}
} // namespace

float kept_way(const PairBody& a, const PairBody& b) {
    return most_along * smaller_reach(a, b);
}

bool kept_manifold(const CachedPair& cached, const PairBody& a, const PairBody& b, float within, Manifold& out) {
    const Placed now(a, b);
    const float across = (cached.count < face_contacts ? most_across_edge : most_across) * smaller_reach(a, b);
    if (!(length(now.offset - cached.offset) <= across)) return false; // most
    const Searched then(cached);
    const Slid slid(cached, then, now, b.reach());
    // Also false for NaN.
    return slid.along <= kept_way(a, b) && slid.across <= across && within + slid.along <= cached.within &&
           contacts_of(cached, then, a, b, out);
}

CachedPair cached_pair(uint64_t key_a, uint64_t key_b, const PairBody& a, const PairBody& b, const Manifold& found,
                       float within, const CachedPair* before) {
    const Placed now(a, b);
    CachedPair out{};
    out.a = key_a;
    out.b = key_b;
    out.offset = now.offset;
    out.turn = PackedRotation::of(now.turn);
    out.within = within;
    out.count = static_cast<uint8_t>(found.count);
    const Vector normal_a = rotate(inverse(a.from.rotation), found.contact[0].normal);
    const Vector normal_b = rotate(inverse(b.from.rotation), found.contact[0].normal);
    const bool face_of_b = fits_face(*a.shape, -normal_a) < fits_face(*b.shape, normal_b);
    const bool arms_of_b = b.reach() < a.reach();
    out.sides = static_cast<uint8_t>((face_of_b ? CachedPair::face_of_b : 0) | (arms_of_b ? CachedPair::arms_of_b : 0));
    out.normal = PackedVector::of(face_of_b ? normal_b : normal_a, 1.0f);
    for (uint32_t k = 0; k < found.count; ++k) {
        const PairContact& c = found.contact[k];
        out.arm[k] = arms_of_b ? PackedVector::of(c.arm_b, longest_arm * b.reach())
                               : PackedVector::of(c.arm_a, longest_arm * a.reach());
        out.gap[k] = c.gap;
    }
    if (before) take_impulses(*before, a, b, found, out);
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
