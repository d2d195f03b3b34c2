// The effect of the step's length on falls with AERODYNAMIC loads: bodies released at rest at random angles in still air,
// averaged from 2 s to 10 s. Relative to steps of 1 ms, in per cent.
//     fall_statistics [--divisors] [ASSET.lrb ...]
// --divisors: batches of lower rates at 60 Hz x 8, relative to taking all of these substeps (docs/reference/stepping.md).
#include "langevin_rigid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

constexpr uint32_t bodies = 2000;
constexpr double from = 2.0, until = 10.0; // s

enum Measure : size_t { descent, horizontal, spin, flips, drift, measures };
using Means = std::array<double, measures>;

void require(lr_status status) {
    if (status == LR_OK) return;
    std::fprintf(stderr, "%s\n", lr_status_string(status));
    std::exit(1);
}

lr_asset* disc(double a, double b, double c, double density) {
    lr_ellipsoid_desc d;
    require(lr_ellipsoid_desc_init(&d, sizeof d));
    d.semi_axes[0] = a, d.semi_axes[1] = b, d.semi_axes[2] = c;
    d.density = density;
    lr_asset* asset = nullptr;
    require(lr_asset_create_ellipsoid(&d, &asset));
    return asset;
}

class Fall {
public:
    Fall(const lr_asset* asset, float dt, uint32_t substeps, uint32_t divisor = 1) : dt_(dt), substeps_(substeps) {
        lr_world_desc w;
        require(lr_world_desc_init(&w, sizeof w));
        w.seed = 5;
        require(lr_world_create(&w, &world_));
        lr_batch_desc b;
        require(lr_batch_desc_init(&b, sizeof b));
        b.variation = 0.0f; // statistics of one body
        b.asset = asset;
        b.capacity = bodies;
        b.load_model = LR_LOADS_AERODYNAMIC;
        require(lr_batch_create(world_, &b, &batch_));
        lr_emitter_desc e;
        require(lr_emitter_desc_init(&e, sizeof e));
        require(lr_batch_set_emitter(world_, batch_, &e));
        require(lr_batch_spawn(world_, batch_, bodies, nullptr));
        require(lr_batch_set_rate(world_, batch_, divisor));
    }
    ~Fall() { lr_world_destroy(world_); }
    Fall(const Fall&) = delete;
    Fall& operator=(const Fall&) = delete;

    Means run() {
        const auto steps = [&](double t) { return static_cast<uint32_t>(std::lround(t / static_cast<double>(dt_))); };
        for (uint32_t i = 0; i < steps(from); ++i) require(lr_world_step(world_, dt_, substeps_));
        lr_batch_view v;
        require(lr_batch_view_init(&v, sizeof v));
        require(lr_batch_get_view(world_, batch_, &v));
        std::array<std::vector<float>, 3> start;
        for (size_t k = 0; k < 3; ++k) start[k].assign(v.position[k], v.position[k] + bodies);
        std::vector<float> u(size_t{6} * bodies);
        std::vector<bool> up(bodies);
        Means sum{};
        const uint32_t count = steps(until) - steps(from);
        for (uint32_t n = 0; n < count; ++n) {
            require(lr_world_step(world_, dt_, substeps_));
            require(lr_batch_get_view(world_, batch_, &v));
            require(lr_batch_write_velocities(world_, batch_, u.data(), 0, bodies, nullptr));
            for (uint32_t i = 0; i < bodies; ++i) add(v, u.data() + size_t{6} * i, i, n > 0, up, sum);
        }
        const double samples = static_cast<double>(count) * bodies;
        for (size_t k : {horizontal, spin}) sum[k] /= samples;
        sum[flips] /= bodies * (until - from);
        double across = 0.0;
        for (uint32_t i = 0; i < bodies; ++i) {
            sum[descent] += static_cast<double>(start[1][i] - v.position[1][i]);
            across += std::hypot(static_cast<double>(v.position[0][i] - start[0][i]),
                                 static_cast<double>(v.position[2][i] - start[2][i]));
        }
        sum[drift] = across / sum[descent];
        sum[descent] /= bodies * (until - from);
        return sum;
    }

private:
    static void add(const lr_batch_view& v, const float* velocity, uint32_t i, bool counted, std::vector<bool>& up,
                    Means& sum) {
        const auto at = [&](const float* const* field, size_t k) { return static_cast<double>(field[k][i]); };
        const double x = at(v.orientation, 0), y = at(v.orientation, 1), z = at(v.orientation, 2),
                     w = at(v.orientation, 3);
        double of[6];
        std::copy_n(velocity, 6, of);
        sum[horizontal] += std::hypot(of[0], of[2]);
        sum[spin] += std::hypot(of[3], of[4], of[5]);
        const bool now = y * z + w * x > 0.0; // which side is up
        if (counted && now != up[i]) sum[flips] += 1.0;
        up[i] = now;
    }

    float dt_;
    uint32_t substeps_;
    lr_world* world_ = nullptr;
    lr_batch batch_{};
};

void print_relative(const Means& m, const Means& exact) {
    for (size_t k = 0; k < measures; ++k) std::printf(" %+6.1f%%", 100.0 * (m[k] / exact[k] - 1.0));
    std::printf("\n");
    std::fflush(stdout);
}

void print_divisors(const std::string& name, const lr_asset* asset) {
    const float dt = 1.0f / 60.0f;
    const Means exact = Fall(asset, dt, 8).run();
    std::printf("%-22s %-9s %7.3f %7.3f %7.2f %7.2f %7.3f\n", name.c_str(), "1", exact[descent], exact[horizontal],
                exact[spin], exact[flips], exact[drift]);
    for (const uint32_t divisor : {2u, 4u, 8u}) {
        std::printf("%-22s %-9u", "", divisor);
        print_relative(Fall(asset, dt, 8, divisor).run(), exact);
    }
    std::printf("%-22s %-9s", "", "largest");
    print_relative(Fall(asset, dt, 8, 1024).run(), exact);
}

void print(const std::string& name, const lr_asset* asset) {
    const Means exact = Fall(asset, 0.001f, 1).run();
    std::printf("%-22s %-9s %7.3f %7.3f %7.2f %7.2f %7.3f\n", name.c_str(), "1 ms", exact[descent], exact[horizontal],
                exact[spin], exact[flips], exact[drift]);
    for (const uint32_t rate : {120u, 60u})
        for (const uint32_t substeps : {1u, 2u, 4u}) {
            const Means m = Fall(asset, 1.0f / static_cast<float>(rate), substeps).run();
            std::printf("%-22s 1/%-3u x %u", "", rate, substeps);
            print_relative(m, exact);
        }
}

} // namespace

int main(int argc, char** argv) {
    const bool divisors = argc > 1 && std::string(argv[1]) == "--divisors";
    const auto show = divisors ? print_divisors : print;
    std::printf("%-22s %-9s %7s %7s %7s %7s %7s\n", "body", divisors ? "divisor" : "step", "m/s", "across", "rad/s",
                "flips/s", "drift");
    const struct {
        const char* name;
        double axes[3], density; // mm, kg/m^3
    } sheets[] = {{"disc, 2.5 cm", {12.5, 12.5, 0.075}, 700.0},
                  {"disc, 4.5 cm", {22.5, 22.5, 0.075}, 700.0},
                  {"confetti, 12 x 6 mm", {6.0, 3.0, 0.06}, 700.0},
                  {"sheet, 10 x 7 cm", {50.0, 35.0, 0.075}, 700.0}};
    for (const auto& s : sheets) {
        lr_asset* const asset = disc(s.axes[0] * 1e-3, s.axes[1] * 1e-3, s.axes[2] * 1e-3, s.density);
        show(s.name, asset);
        lr_asset_release(asset);
    }
    for (int i = divisors ? 2 : 1; i < argc; ++i) {
        lr_asset* asset = nullptr;
        require(lr_asset_load_file(argv[i], &asset));
        show(std::string(argv[i]).substr(std::string(argv[i]).find_last_of('/') + 1), asset);
        lr_asset_release(asset);
    }
}
