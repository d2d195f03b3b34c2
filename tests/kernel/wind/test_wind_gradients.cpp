// Gradients and rates of every source against differences of its velocity, and their combination; lr_world_sample_wind does not
// show them. On every instruction set.
#include "environment/wind_field.h"
#include "support/random.h"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

using namespace lr;

namespace {

SourceDesc source(int32_t kind) {
    SourceDesc d;
    d.kind = kind;
    d.direction[0] = 0.3f, d.direction[1] = 1.0f, d.direction[2] = -0.4f;
    d.velocity[0] = 0.7f, d.velocity[1] = -0.2f, d.velocity[2] = 0.4f;
    d.speed = 3.0f, d.circulation = 4.0f, d.size = 0.5f, d.range = 6.0f, d.spread = 0.2f;
    d.half_length = 1.5f, d.radius = 3.0f;
    return d;
}

struct Values {
    double wind[3], rate[3], gradient[9];
};

// At one point, in every lane.
Values at(const KernelTarget& target, WindField& field, const double x[3], double time) {
    auto block = std::make_unique<FieldBlock>();
    for (size_t k = 0; k < 3; ++k)
        for (size_t i = 0; i < lane_block; ++i) block->position[k][i] = static_cast<float>(x[k]);
    field.prepare_now(time, 5);
    target.evaluate(field.instant(0), lane_block, block.get());
    Values v{};
    const size_t lane = lane_block - 1;
    for (size_t k = 0; k < 3; ++k) {
        v.wind[k] = static_cast<double>(block->wind[k][lane]);
        v.rate[k] = static_cast<double>(block->rate[k][lane]);
    }
    for (size_t k = 0; k < 9; ++k) v.gradient[k] = static_cast<double>(block->gradient[k][lane]);
    return v;
}

} // namespace

TEST_CASE("gradients and rates of every source are those of its velocity") {
    test::Random numbers(1);
    const auto random = [&](double low, double high) { return numbers.uniform(low, high); };
    std::vector<float> samples(3 * 6 * 6 * 6 * 2);
    for (float& v : samples) v = static_cast<float>(random(-2.0, 2.0));
    size_t count = 0;
    const KernelTarget* const targets = built_targets(count);
    for (size_t t = 0; t < count; ++t) {
        const KernelTarget* const target = find_target(targets[t].simd);
        if (!target) continue;
        for (int32_t kind = SourceDesc::rankine; kind <= SourceDesc::ground; ++kind) {
            Allocator allocator;
            WindField field(allocator);
            SourceDesc d = source(kind);
            if (kind == SourceDesc::turbulence) d.size = 2.0f, d.period = 0.5f;
            if (kind == SourceDesc::grid) {
                for (size_t k = 0; k < 3; ++k) d.position[k] = -2.5f, d.spacing[k] = 1.0f, d.counts[k] = 6;
                d.frames = 2, d.period = 1.0f, d.samples = samples.data();
            }
            if (kind == SourceDesc::ground) {
                field.uniform.wind[0] = 3.0f, field.uniform.wind[2] = -1.0f;
            }
            lr_wind_source handle{};
            REQUIRE(field.add(d, 0.0, 5, handle) == LR_OK);
            int seen = 0;
            double worst = 0.0, worst_rate = 0.0, largest = 0.0;
            for (int n = 0; n < 200; ++n) {
                double x[3];
                for (double& v : x) v = random(-2.0, 2.0);
                const double time = 0.3;
                const Values v = at(*target, field, x, time);
                double size = 0.0;
                for (double g : v.gradient) size = std::max(size, std::abs(g));
                if (size == 0.0) continue;
                // At the kinks of a core's edge, a cell's side or the start of a jet the derivative does not exist.
                const double e = 1.0 / 512.0;
                const auto both_sides = [&](size_t j, double out[3], double ahead[3], double behind[3]) {
                    double up[3] = {x[0], x[1], x[2]}, down[3] = {x[0], x[1], x[2]};
                    up[j] = static_cast<double>(static_cast<float>(x[j] + e));
                    down[j] = static_cast<double>(static_cast<float>(x[j] - e));
                    const Values a = at(*target, field, up, time), b = at(*target, field, down, time);
                    for (size_t i = 0; i < 3; ++i) {
                        out[i] = (a.wind[i] - b.wind[i]) / (up[j] - down[j]);
                        ahead[i] = (a.wind[i] - v.wind[i]) / (up[j] - x[j]);
                        behind[i] = (v.wind[i] - b.wind[i]) / (x[j] - down[j]);
                    }
                };
                for (double& c : x) c = static_cast<double>(static_cast<float>(c));
                bool kink = false;
                double slope[9];
                for (size_t j = 0; j < 3; ++j) {
                    double out[3], ahead[3], behind[3];
                    both_sides(j, out, ahead, behind);
                    for (size_t i = 0; i < 3; ++i) {
                        slope[3 * i + j] = out[i];
                        kink = kink || std::abs(ahead[i] - behind[i]) > 0.04 * size + 2e-3;
                    }
                }
                if (kink) continue;
                ++seen;
                largest = std::max(largest, size);
                for (size_t k = 0; k < 9; ++k)
                    worst = std::max(worst, std::abs(v.gradient[k] - slope[k]) / (size + 0.1));
                const Values later = at(*target, field, x, time + e), before = at(*target, field, x, time - e);
                for (size_t k = 0; k < 3; ++k) {
                    const double rate = (later.wind[k] - before.wind[k]) / (2.0 * e);
                    worst_rate = std::max(worst_rate, std::abs(v.rate[k] - rate) / (size + 1.0));
                }
            }
            CAPTURE(kind);
            CAPTURE(target->simd);
            CHECK(seen > 20);
            CHECK(largest > 0.1);
            CHECK(worst < 0.02);
            CHECK(worst_rate < 0.03);
        }
    }
}

TEST_CASE("turbulence's gradient has no trace, to rounding") {
    Allocator allocator;
    WindField field(allocator);
    SourceDesc d = source(SourceDesc::turbulence);
    d.octaves = 4;
    lr_wind_source handle{};
    REQUIRE(field.add(d, 0.0, 5, handle) == LR_OK);
    double trace = 0.0, size = 0.0;
    for (int n = 0; n < 500; ++n) {
        const double x[3] = {0.37 * n, 1.1 * n, -0.73 * n};
        const Values v = at(*find_target(LR_SIMD_AUTO), field, x, 2.0);
        trace = std::max(trace, std::abs(v.gradient[0] + v.gradient[4] + v.gradient[8]));
        for (double g : v.gradient) size = std::max(size, std::abs(g));
    }
    CHECK(trace < 1e-5 * size);
}
