#include "contact/ccd_pair.h"

#include <ccd/ccd.h>

namespace lr {

namespace {

static_assert(sizeof(ccd_real_t) == sizeof(double), "libccd has to be built for double precision");

// Refinement stops at libccd's own limit; the loops before it that look for a portal have none. Past this many supports all
// points are one, which ends them.
constexpr uint32_t most_supports = 400;

struct Side {
    const PlacedBody* body;
    const PlacedCollider* collider;
    Double3 middle;
    double inverse_size; // libccd's tolerances are absolute: the pair is made about as large as 1
    uint32_t* calls;
};

void set(ccd_vec3_t* to, const Side& side, Double3 p) {
    const Double3 q = side.inverse_size * p;
    ccdVec3Set(to, q.x, q.y, q.z);
}

void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* out) {
    const Side& side = *static_cast<const Side*>(object);
    if (++*side.calls > most_supports) return set(out, side, side.middle);
    const Double3 d{ccdVec3X(direction), ccdVec3Y(direction), ccdVec3Z(direction)};
    const double square = dot(d, d);
    if (!(square > 0.0)) return set(out, side, side.middle);
    set(out, side, side.body ? side.body->support(1.0 / std::sqrt(square) * d) : side.collider->support(d));
}

void middle(const void* object, ccd_vec3_t* out) {
    const Side& side = *static_cast<const Side*>(object);
    set(out, side, side.middle);
}

} // namespace

bool ccd_direction(const PlacedBody& body, const PlacedCollider& collider, Double3& direction) {
    uint32_t calls = 0;
    const double size = static_cast<double>(body.reach > 0.0f ? body.reach : 1.0f);
    const Side one{&body, nullptr, to_double(body.center), 1.0 / size, &calls};
    const Side other{nullptr, &collider, collider.middle(), 1.0 / size, &calls};
    ccd_t ccd{}; // CCD_INIT would have its other algorithm linked in
    ccd.support1 = ccd.support2 = support;
    ccd.center1 = ccd.center2 = middle;
    ccd.max_iterations = 50;
    ccd.mpr_tolerance = 1e-5;
    ccd_real_t depth = 0.0;
    ccd_vec3_t out, at;
    ccdVec3Set(&out, 0.0, 0.0, 0.0);
    ccdVec3Set(&at, 0.0, 0.0, 0.0);
    // The second is moved out of the first, along `out`.
    if (ccdMPRPenetration(&other, &one, &ccd, &depth, &out, &at) != 0 || calls > most_supports) return false;
    const Double3 d{ccdVec3X(&out), ccdVec3Y(&out), ccdVec3Z(&out)};
    const double square = dot(d, d);
    if (!(square > 0.25 && square < 4.0)) return false;
    direction = 1.0 / std::sqrt(square) * d;
    return true;
}

} // namespace lr
