// Contacts of two plates, many pairs side by side, against the general way, one pair at a time.
#include "collision/found_pair.h"
#include "collision/pair_contacts.h"
#include "collision/random_pairs.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace lr;

namespace {

// Leaves and cards, as plates and once more as hulls that only happen to be flat.
struct Shapes {
    std::vector<PairHull> plates, hulls;
    Shapes() {
        for (const auto& [x, z] : {std::pair{0.035f, 0.02f}, {0.05f, 0.01f}, {0.02f, 0.02f}})
            plates.push_back(make_pair_hull(make_body_shape(test::asset_of(test::box_corners(x, 2e-4f, z)))));
        plates.push_back(make_pair_hull(test::leaf(0.04f, 3e-4f)));
        plates.push_back(make_pair_hull(test::ellipsoid(0.04f, 0.01f, 1e-4f)));
        for (const PairHull& plate : plates) {
            REQUIRE(plate.flat);
            hulls.push_back(plate);
            hulls.back().flat = false;
        }
    }
};

double least_gap(const Manifold& m) {
    float gap = 1.0f;
    for (uint32_t k = 0; k < m.count; ++k) gap = std::min(gap, m.contact[k].gap);
    return wide(gap);
}
// The largest distance of two contacts, and of a third from the line through them.
std::pair<double, double> spread_of(const Manifold& m) {
    double length_of = 0.0, width = 0.0;
    for (uint32_t i = 0; i < m.count; ++i)
        for (uint32_t j = 0; j < i; ++j) {
            const Vector way = m.contact[i].arm_a - m.contact[j].arm_a;
            const float far = length(way);
            if (wide(far) < length_of) continue;
            length_of = wide(far);
            width = 0.0;
            for (uint32_t k = 0; k < m.count; ++k)
                width = std::max(width, wide(length(cross(way, m.contact[k].arm_a - m.contact[j].arm_a)) / far));
        }
    return {length_of, width};
}

} // namespace

TEST_CASE("plates side by side have the contacts of the general search: as deep, and spread as far") {
    const Shapes shapes;
    test::Random random(21);
    uint32_t both = 0, one = 0, narrower = 0, faces = 0;
    double deepest_off = 0.0, point_off = 0.0;
    const uint32_t rounds = test::rounds(20000);
    for (uint32_t i = 0; i < rounds; ++i) {
        const uint32_t m = random.below(5), n = random.below(5);
        const float scale = random.real(0.5, 2.0), tilt = random.below(3) == 0 ? 1.5f : 0.02f;
        const Pose at_a{{0.5f, 0.0f, -0.5f}, test::any_rotation(random)};
        // About the normal of a's plate, y of a card and z of an ellipsoid, with little tilt or any.
        const Rotation own = at_a.rotation * shapes.plates[m].frame;
        const Rotation turn =
            normalised({random.real(-tilt, tilt), random.real(-tilt, tilt), random.real(-1.0, 1.0), 1.0f});
        const Vector off{random.real(-0.03, 0.03), random.real(-0.02, 0.02), random.real(-3e-3, 3e-3)};
        const Pose at_b{at_a.position + rotate(own, off), normalised(own * turn * inverse(shapes.plates[n].frame))};
        const float margin = 1e-3f;
        Manifold lanes{}, general{};
        const auto search = [&](const std::vector<PairHull>& hulls, Manifold& out) {
            test::find_manifold({&hulls[m], 1.0f, at_a, at_a, {}, 0.0f}, {&hulls[n], scale, at_b, at_b, {}, 0.0f},
                                margin, out);
        };
        search(shapes.plates, lanes);
        search(shapes.hulls, general);
        if (lanes.count == 0 && general.count == 0) continue;
        if ((lanes.count == 0) != (general.count == 0)) {
            ++one;
            continue;
        }
        ++both;
        deepest_off = std::max(deepest_off, std::abs(least_gap(lanes) - least_gap(general)));
        for (uint32_t k = 0; k < lanes.count; ++k) {
            const PairContact& c = lanes.contact[k];
            const Vector apart = to_outer(at_a, c.arm_a) - to_outer(at_b, c.arm_b);
            point_off = std::max(point_off, std::abs(wide(dot(c.normal, apart) - c.gap)));
        }
        if (general.count < 3) continue;
        ++faces;
        const auto [length_of, width] = spread_of(lanes);
        const auto [general_length, general_width] = spread_of(general);
        narrower += length_of < 0.95 * general_length || width < 0.8 * general_width;
    }
    MESSAGE(both << " touch, " << one << " only one way; deepest " << deepest_off << " m, points " << point_off
                 << " m; " << narrower << " of " << faces << " narrower");
    CHECK(both > rounds / 4);
    CHECK(one <= both / 1000);
    CHECK(faces > both / 4);
    CHECK(deepest_off < 0.02 * (1e-3 + 6e-4)); // nearest points count if they are deeper by this part of what is left
    CHECK(point_off < 1e-6);
    CHECK(narrower <= faces / 100);
}
