#include "tools/lr_scorecard/fall_recording.h"

#include <algorithm>
#include <cmath>

namespace lr::scorecard {
namespace {

double wide(float x) {
    return static_cast<double>(x);
}

Eigen::Vector3d at(const float* const xyz[3], uint32_t i) {
    return {wide(xyz[0][i]), wide(xyz[1][i]), wide(xyz[2][i])};
}

void store(const Eigen::Vector3d& from, float to[3]) {
    for (int i = 0; i < 3; ++i) to[i] = static_cast<float>(from[i]);
}

std::vector<Sample> read(const World& world, lr_batch batch) {
    lr_batch_view view = initialised(lr_batch_view_init);
    require(lr_batch_get_view(world.get(), batch, &view), "lr_batch_get_view");
    std::vector<float> velocities(size_t{6} * view.count);
    require(lr_batch_write_velocities(world.get(), batch, velocities.data(), 0, view.count, nullptr),
            "lr_batch_write_velocities");
    std::vector<Sample> samples(view.count);
    for (uint32_t i = 0; i < view.count; ++i) {
        const float* const* q = view.orientation;
        samples[i].orientation = Eigen::Quaterniond(wide(q[3][i]), wide(q[0][i]), wide(q[1][i]), wide(q[2][i]));
        samples[i].position = at(view.position, i);
        const Eigen::Map<const Eigen::Matrix<float, 6, 1>> both(&velocities[size_t{6} * i]);
        samples[i].velocity = both.head<3>().cast<double>();
        samples[i].spin = both.tail<3>().cast<double>();
    }
    return samples;
}

// Cubic interpolation with the velocities at both ends: chords would shorten the path of long steps by up to 5 %.
Sample between(const Sample& a, const Sample& b, double part, double dt) {
    const auto mix = [part](const Eigen::Vector3d& x, const Eigen::Vector3d& y) -> Eigen::Vector3d {
        return x + part * (y - x);
    };
    const double rest = 1.0 - part;
    const Eigen::Vector3d step = b.position - a.position,
                          bend = rest * (dt * a.velocity - step) - part * (dt * b.velocity - step);
    return {mix(a.position, b.position) + part * rest * bend, mix(a.velocity, b.velocity), mix(a.spin, b.spin),
            a.orientation.slerp(part, b.orientation)};
}

lr_batch add_bodies(const World& world, const Asset& asset, const Loads& loads, const std::vector<Start>& starts) {
    std::vector<lr_body_desc> descs(starts.size(), initialised(lr_body_desc_init));
    for (size_t i = 0; i < starts.size(); ++i) {
        store(starts[i].position, descs[i].position);
        store(starts[i].velocity, descs[i].linear_velocity);
        store(starts[i].spin, descs[i].angular_velocity);
        for (int k = 0; k < 4; ++k) descs[i].orientation[k] = static_cast<float>(starts[i].orientation.coeffs()[k]);
    }
    const auto count = static_cast<uint32_t>(starts.size());
    const lr_batch batch = add_batch(world, asset, loads, count);
    require(lr_body_create(world.get(), batch, descs.data(), count, nullptr), "lr_body_create");
    return batch;
}
} // namespace

std::vector<Track> record(const Asset& asset, const Run& run, const std::vector<Start>& starts) {
    lr_world_desc wd = initialised(lr_world_desc_init);
    wd.worker_count = run.threads > 1 ? run.threads - 1 : 0;
    wd.seed = run.seed;
    wd.simd_target = run.simd_target;
    wd.gravity[1] = static_cast<float>(-run.gravity);
    wd.fluid_viscosity = static_cast<float>(run.viscosity);
    const World world = make_world(wd);
    float wind[3];
    store(run.wind, wind);
    require(lr_world_set_uniform_wind(world.get(), wind[0], wind[1], wind[2]), "lr_world_set_uniform_wind");
    if (run.prepare) run.prepare(world.get());
    const lr_batch batch = add_bodies(world, asset, run.loads, starts);

    const auto frames = static_cast<size_t>(std::floor(run.duration / run.interval + 1e-9)) + 1;
    std::vector<Track> tracks(starts.size());
    for (Track& t : tracks) {
        t.interval = run.interval;
        t.samples.reserve(frames);
    }
    std::vector<Sample> before = read(world, batch), after;
    for (size_t i = 0; i < tracks.size(); ++i) tracks[i].samples.push_back(before[i]);
    size_t frame = 1;
    const double dt = wide(run.dt);
    for (uint64_t step = 0; frame < frames; ++step) {
        const double begin = dt * static_cast<double>(step), end = begin + dt;
        const auto due = [&] { return static_cast<double>(frame) * run.interval <= end && frame < frames; };
        const bool any = due();
        if (any) before = read(world, batch);
        require(lr_world_step(world.get(), run.dt, run.substeps), "lr_world_step");
        if (!any) continue;
        after = read(world, batch);
        for (; due(); ++frame) {
            const double part = (static_cast<double>(frame) * run.interval - begin) / dt;
            for (size_t i = 0; i < tracks.size(); ++i)
                tracks[i].samples.push_back(between(before[i], after[i], part, dt));
        }
        if (std::all_of(after.begin(), after.end(), [&](const Sample& s) { return s.position.y() < run.floor; })) break;
    }
    return tracks;
}
} // namespace lr::scorecard
