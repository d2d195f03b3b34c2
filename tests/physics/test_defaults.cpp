// The defaults of a world that nobody has tuned: bodies without a pose are not in step with each other, and confetti turns as finer steps say.
#include "support/scene.h"
#include "support/vector.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

using namespace test;

namespace {

constexpr uint32_t count = 400;
constexpr double degree = std::numbers::pi / 180.0;

// The median angle between a body and the next, after `seconds` of a fall from equal states.
double apart(const lr_ellipsoid_desc& shape, uint32_t substeps, double seconds, bool alike) {
    const Asset asset = make(shape);
    const World world = make(world_desc());
    lr_batch_desc bd = LR_BATCH_DESC_INIT;
    if (alike) bd.variation = 0.0f;
    const lr_batch batch = add_batch(world, bd, asset, count);
    if (alike) {
        lr_load_gains gains = LR_LOAD_GAINS_INIT;
        gains.turbulence = 0.0f;
        REQUIRE(lr_batch_set_load_gains(world.get(), batch, &gains) == LR_OK);
    }
    const std::vector<lr_body_desc> bodies(count, lr_body_desc LR_BODY_DESC_INIT);
    std::vector<lr_body> ids(count);
    REQUIRE(lr_body_create(world.get(), batch, bodies.data(), count, ids.data()) == LR_OK);
    steps(world, static_cast<int>(60.0 * seconds), 1.0f / 60.0f, substeps);
    std::vector<double> angles;
    Quat last{};
    for (const lr_body id : ids) {
        const Quat q = quat(state_of(world, id).orientation);
        double cosine = 0.0;
        for (size_t k = 0; k < 4; ++k) cosine += q[k] * last[k];
        if (id.id != ids[0].id) angles.push_back(2.0 * std::acos(std::min(1.0, std::abs(cosine))));
        last = q;
    }
    std::sort(angles.begin(), angles.end());
    return angles[angles.size() / 2];
}

// Turns in a frame of bodies from lr_batch_spawn_box, rad: of every piece, in two seconds.
std::vector<double> turns(const lr_ellipsoid_desc& body, uint32_t substeps) {
    const Asset asset = make(body);
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, LR_BATCH_DESC_INIT, asset, count);
    const float low[3] = {}, high[3] = {1.0f, 1.0f, 1.0f};
    REQUIRE(lr_batch_spawn_box(world.get(), batch, low, high, count, nullptr) == LR_OK);
    steps(world, 120, 1.0f / 60.0f, substeps);
    std::vector<double> out;
    for (int frame = 0; frame < 120; ++frame) {
        steps(world, 1, 1.0f / 60.0f, substeps);
        for (const Velocity& v : velocities_of(world, batch)) out.push_back(length(vec(v.angular)) / 60.0);
    }
    return out;
}
double mean(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double v : values) sum += v;
    return sum / static_cast<double>(values.size());
}

} // namespace

TEST_CASE("defaults: no two bodies of a batch are alike") {
    const lr_batch_desc d = LR_BATCH_DESC_INIT;
    CHECK(d.variation == 0.15f);
    const lr_emitter_desc e = LR_EMITTER_DESC_INIT;
    CHECK(e.pose == LR_POSE_RANDOM);
}

TEST_CASE("defaults: bodies created without a pose are out of step within a second") {
    CHECK(apart(ellipsoid(0.035, 0.02, 0.00015, 350.0), 2, 1.0, false) > 60.0 * degree);  // a leaf
    CHECK(apart(ellipsoid(0.006, 0.005, 0.0001, 700.0), 4, 1.0, false) > 60.0 * degree);  // a petal
    CHECK(apart(ellipsoid(0.006, 0.003, 0.00005, 800.0), 4, 0.5, false) > 60.0 * degree); // confetti
    CHECK(apart(ellipsoid(0.035, 0.02, 0.00015, 350.0), 2, 1.0, true) < 1e-3);
}

TEST_CASE(
    "defaults: small confetti turns as fast as with a quarter of the step, and that of stages by less than a quarter "
    "turn a frame") {
    const lr_ellipsoid_desc paper = ellipsoid(0.006, 0.003, 0.00005, 800.0);
    CHECK(mean(turns(paper, 4)) == doctest::Approx(mean(turns(paper, 16))).epsilon(0.1));
    const std::vector<double> tissue = turns(ellipsoid(0.025, 0.01, 0.0000125, 800.0), 4); // 5 x 2 cm, 20 g/m^2
    const auto flickers = std::count_if(tissue.begin(), tissue.end(), [](double t) { return t > 90.0 * degree; });
    CHECK(static_cast<double>(flickers) < 0.1 * static_cast<double>(tissue.size()));
}
