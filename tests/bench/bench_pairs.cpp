// The cost of the narrow phase for two bodies.
#include "collision/found_pair.h"
#include "collision/pair_contacts.h"
#include "collision/random_pairs.h"
#include "kernel/integrator/step.h"
#include "langevin_rigid.h"

#include <benchmark/benchmark.h>

using namespace lr;

namespace {

struct Scene {
    const char* name;
    BodyShape a, b;
    int lie; // 0: b lies on a, turned and tilted a little; 1: any touching poses; 2: separated by an axis; 3: cores overlap; 4: near misses
};

void run(benchmark::State& state, const Scene& scene) {
    test::Random random(7);
    const PairHull a = make_pair_hull(scene.a), b = make_pair_hull(scene.b);
    const float size = std::min(a.shape.reach, b.shape.reach),
                margin = scene.lie == 1 || scene.lie == 4 ? 0.05f * size : 0.02f * size;
    struct Pair {
        Pose a, b;
    };
    std::vector<Pair> pairs;
    PairContact out[most_pair_contacts];
    while (pairs.size() < 1024) {
        Pair p{{{0.0f, 0.0f, 0.0f}, test::any_rotation(random)}, {{}, test::any_rotation(random)}};
        const Vector up = rotate(p.a.rotation * a.frame, {0.0f, 0.0f, 1.0f});
        if (scene.lie == 0) {
            const float turn = random.real(-3.0, 3.0);
            const Rotation about =
                normalised({random.real(-0.02, 0.02), random.real(-0.02, 0.02), std::sin(turn), std::cos(turn)});
            p.b.rotation = p.a.rotation * a.frame * about * inverse(b.frame);
            const Vector side = rotate(p.a.rotation, random.real(0.0, 0.8) * size * test::any_direction(random));
            p.b.position =
                (random.real(1.0, 1.02) * (a.core_half.z + b.core_half.z + a.shape.radius + b.shape.radius)) * up +
                (side - dot(side, up) * up);
        } else {
            p.b.position = random.real(0.0, scene.lie == 2 ? 1.6 : 1.2) * size * test::any_direction(random);
        }
        const uint32_t found = test::find_pair_contacts(a, 1.0f, p.a, b, 1.0f, p.b, margin, out);
        float least = 1.0f;
        for (uint32_t i = 0; i < found; ++i) least = std::min(least, out[i].gap);
        const bool overlap = found > 0 && least < -(a.shape.radius + b.shape.radius);
        if (scene.lie >= 2 && scene.lie != 3 ? found > 0 : found == 0 || overlap != (scene.lie == 3)) continue;
        pairs.push_back(p);
    }
    std::vector<PairBody> bodies;
    for (const Pair& p : pairs) {
        bodies.push_back({&a, 1.0f, p.a, p.a, {}, 0.0f});
        bodies.push_back({&b, 1.0f, p.b, p.b, {}, 0.0f});
    }
    size_t i = 0;
    double found = 0.0;
    const auto take = [&](uint32_t, const WayContact*, uint32_t count, const Manifold&) { found += count; };
    PairBatch batch(find_target(LR_SIMD_AUTO)->search_pairs);
    for (auto _ : state) {
        const size_t at = 2 * (i & 1023);
        batch.find(bodies[at], bodies[at + 1], margin, 0.0f, 0, take);
        benchmark::DoNotOptimize(found);
        ++i;
    }
    batch.finish(take);
    state.counters["found"] = found / static_cast<double>(i);
}

} // namespace

int main(int argc, char** argv) {
    const BodyShape leaf = test::leaf(0.04f, 3e-4f);
    const BodyShape card = make_body_shape(test::asset_of(test::box_corners(0.04f, 0.03f, 1.5e-4f)));
    const BodyShape box = make_body_shape(test::asset_of(test::box_corners(0.04f, 0.03f, 0.02f)));
    const BodyShape flat = test::ellipsoid(0.04f, 0.01f, 5e-5f), ball = test::ellipsoid(0.02f, 0.02f, 0.02f);
    const Scene scenes[] = {{"leaf lies on leaf", leaf, leaf, 0},       {"leaf touches leaf, any pose", leaf, leaf, 1},
                            {"leaf apart from leaf", leaf, leaf, 2},    {"leaf, leaf overlap", leaf, leaf, 3},
                            {"card lies on card", card, card, 0},       {"flat ellipsoid on leaf", leaf, flat, 0},
                            {"ball touches leaf", leaf, ball, 1},       {"box lies on box", box, box, 0},
                            {"box touches box, any pose", box, box, 1}, {"box, box overlap", box, box, 3},
                            {"box apart from box", box, box, 2},        {"leaf on box", box, leaf, 0},
                            {"ball touches ball", ball, ball, 1}};
    for (const Scene& scene : scenes)
        benchmark::RegisterBenchmark(scene.name, [&scene](benchmark::State& state) { run(state, scene); });
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
