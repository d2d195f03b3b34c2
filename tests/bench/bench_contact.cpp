// The cost of a pair: a leaf of 24 points near and far from each kind of collider.
#include "collision/random_pairs.h"

#include <benchmark/benchmark.h>

using namespace lr;

namespace {

constexpr ColliderKind kinds[] = {ColliderKind::plane, ColliderKind::sphere, ColliderKind::capsule,
                                  ColliderKind::box,   ColliderKind::hull,   ColliderKind::heightfield,
                                  ColliderKind::mesh};
constexpr const char* names[] = {"plane", "sphere", "capsule", "box", "hull", "heightfield", "mesh"};

// Colliders of a metre with their tops at 0, around the origin of the body's places.
void make(test::Solid& solid, ColliderKind kind, test::Random& random, Vector& top) {
    top = {0.1f, 0.0f, 0.1f};
    if (kind == ColliderKind::hull) {
        solid.make_hull(test::cloud(random, 24, 0.05f));
        top = {0.0f, 0.05f, 0.0f};
    } else if (kind == ColliderKind::mesh) {
        solid.make_mesh({0, 0, 0, 0, 0, 1, 1, 0, 1, 1, 0, 0}, {0, 1, 2, 0, 2, 3});
        top = {0.5f, 0.0f, 0.3f};
    } else if (kind == ColliderKind::heightfield) {
        std::vector<float> heights(32 * 32);
        for (float& h : heights) h = random.real(0.0, 0.02);
        solid.make_field(32, 32, 0.1f, heights);
        top = {1.53f, 0.02f, 1.57f};
    } else {
        solid.make(kind, 0.05f, kind == ColliderKind::capsule ? 0.1f : 0.05f, 0.05f);
        if (kind == ColliderKind::box) solid.make(kind, 0.5f, 0.5f, 0.5f);
        if (kind != ColliderKind::plane) top = {0.0f, kind == ColliderKind::box ? 0.5f : 0.05f, 0.0f};
        if (kind == ColliderKind::capsule) top = {0.05f, 0.0f, 0.0f};
    }
}

void run(benchmark::State& state, ColliderKind kind, int what) {
    test::Random random(5);
    test::Solid solid;
    Vector top{};
    make(solid, kind, random, top);
    const BodyShape shape = test::leaf(0.04f, 3e-4f);
    std::vector<Pose> poses, next;
    for (int i = 0; i < 512; ++i) {
        Vector p = top;
        const float up = what == 2 || what == 4 ? 0.1f : what == 1 ? random.real(0.0, 4e-4) : random.real(0.0, 0.02);
        Rotation q = what == 1 ? Rotation{0.0f, 0.0f, 0.0f, 1.0f} : test::any_rotation(random);
        if (kind == ColliderKind::capsule)
            p.x += up;
        else
            p.y += up;
        if (kind == ColliderKind::capsule && what == 1) q = {0.0f, 0.0f, 0.70710678f, 0.70710678f};
        poses.push_back({p, q});
        if (what == 5) // a leaf nearly asleep
            next.push_back({p + Vector{0.0f, -2e-5f, 0.0f}, normalised({q.x + 2e-4f, q.y, q.z, q.w})});
        else
            next.push_back({p + Vector{0.0f, -0.005f, 0.0f}, normalised({q.x + 0.02f, q.y, q.z, q.w})});
    }
    size_t i = 0;
    double found = 0.0;
    Contact out[most_contacts];
    for (auto _ : state) {
        const Pose& pose = poses[i & 511];
        if (what < 3)
            found += find_contacts(shape, 1.0f, pose, solid, 1e-3f, out);
        else
            found += static_cast<double>(free_fraction(shape, 1.0f, pose, next[i & 511], solid));
        benchmark::DoNotOptimize(found);
        ++i;
    }
    state.counters["found"] = found / static_cast<double>(i);
}

} // namespace

int main(int argc, char** argv) {
    const char* const whats[] = {"contacts, any pose", "contacts, flat",     "contacts, far",
                                 "free fraction",      "free fraction, far", "free fraction, slow"};
    for (int what = 0; what < 6; ++what)
        for (size_t k = 0; k < 7; ++k)
            benchmark::RegisterBenchmark((std::string(whats[what]) + "/" + names[k]).c_str(),
                                         [=](benchmark::State& state) { run(state, kinds[k], what); });
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
