#include "tools/falls/drop.h"

#include "baker/eigensystem.h"
#include "tools/falls/random.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

namespace lr::falls {
namespace {

constexpr size_t most_samples = 16384; // of one track; a longer one keeps every second, fourth, and so on
constexpr double gravity = 9.81;       // m/s^2, the runtime's default

struct DestroyWorld {
    void operator()(lr_world* world) const { lr_world_destroy(world); }
};
using World = std::unique_ptr<lr_world, DestroyWorld>;

void require(lr_status status, const char* call) {
    if (status != LR_OK) throw std::runtime_error(std::string(call) + ": " + lr_last_error());
}

double wide(float x) {
    return static_cast<double>(x);
}

void store(const Eigen::Vector3d& from, float to[3]) {
    for (int i = 0; i < 3; ++i) to[i] = static_cast<float>(from[i]);
}

Eigen::Quaterniond start(const Drop& options, const Eigen::Vector3d& normal, uint32_t index) {
    Random random(options.seed + 0x632be59bd9b4e019u * (index + uint64_t{1}));
    if (options.release == Release::random) return random.orientation();
    const auto turn = [&](const Eigen::Vector3d& axis) {
        return Eigen::AngleAxisd(random.real(0.0, 2.0 * std::numbers::pi), axis);
    };
    const Eigen::Vector3d target = options.release == Release::flat ? up() : Eigen::Vector3d::UnitX();
    const Eigen::Quaterniond heading(turn(up())), rolled(turn(normal));
    return heading * Eigen::Quaterniond::FromTwoVectors(normal, target) * rolled;
}

// In turbulence bodies start far apart, because neighbours would meet the same eddies.
Eigen::Vector3d place(const Drop& options, uint32_t index, float eddy) {
    if (options.turbulence <= 0.0) return Eigen::Vector3d::Zero();
    const auto side = static_cast<uint32_t>(std::ceil(std::sqrt(static_cast<double>(options.count))));
    return 10.0 * wide(eddy) * Eigen::Vector3d(index % side, 0.0, index / side);
}

World make_world(const Drop& options) {
    lr_world_desc desc = LR_WORLD_DESC_INIT;
    desc.seed = options.seed;
    desc.fluid_density = static_cast<float>(options.fluid_density);
    desc.fluid_viscosity = static_cast<float>(options.fluid_viscosity);
    lr_world* made = nullptr;
    require(lr_world_create(&desc, &made), "lr_world_create");
    World world(made);
    float wind[3];
    store(options.wind, wind);
    require(lr_world_set_uniform_wind(made, wind[0], wind[1], wind[2]), "lr_world_set_uniform_wind");
    return world;
}

// Thins the tracks of bodies that still fall.
void keep_every_second(std::vector<Track>& tracks) {
    for (Track& t : tracks) {
        if (t.arrived) continue;
        t.interval *= 2.0;
        size_t kept = 0;
        for (size_t i = 0; i < t.samples.size(); i += 2) t.samples[kept++] = t.samples[i];
        t.samples.resize(kept, t.samples[0]);
    }
}

// Finds bodies by their noise seeds, because a diverged body changes its place in the view.
class Reader {
public:
    Reader(const lr_world* world, lr_batch batch, uint32_t first, std::vector<Eigen::Vector3d> places)
        : world_(world), batch_(batch), first_(first), places_(std::move(places)), velocities_(6 * places_.size()) {}

    void read(std::vector<Sample>& samples) {
        lr_batch_view view = LR_BATCH_VIEW_INIT;
        require(lr_batch_get_view(world_, batch_, &view), "lr_batch_get_view");
        require(lr_batch_write_velocities(world_, batch_, velocities_.data(), 0, view.count, nullptr),
                "lr_batch_write_velocities");
        for (uint32_t i = 0; i < view.count; ++i) {
            const size_t body = view.noise_seed[i] - first_ - 1;
            const float* const* p = view.position;
            const float* const* q = view.orientation;
            samples[body].position = Eigen::Vector3d(wide(p[0][i]), wide(p[1][i]), wide(p[2][i])) - places_[body];
            samples[body].orientation = Eigen::Quaterniond(wide(q[3][i]), wide(q[0][i]), wide(q[1][i]), wide(q[2][i]));
            samples[body].spin = Eigen::Map<const Eigen::Vector3f>(&velocities_[6 * size_t{i} + 3]).cast<double>();
        }
    }

private:
    const lr_world* world_;
    lr_batch batch_;
    uint32_t first_;
    std::vector<Eigen::Vector3d> places_;
    std::vector<float> velocities_;
};
} // namespace

Shape shape_of(const lr_asset* asset, const Drop& options) {
    lr_asset_info info = LR_ASSET_INFO_INIT;
    require(lr_asset_get_info(asset, &info), "lr_asset_get_info");
    Shape shape;
    shape.name = info.name;
    shape.density = info.density;
    shape.fluid_density = options.fluid_density > 0.0 ? options.fluid_density : info.fluid_density;
    shape.length = info.length_d;
    shape.thickness = info.length_b;
    Eigen::Matrix3d added;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) added(i, k) = info.added_mass[6 * i + k];
    shape.normal = baker::eigensystem(added).vectors.col(2);
    Eigen::Index largest = 0;
    shape.normal.cwiseAbs().maxCoeff(&largest);
    if (shape.normal[largest] < 0.0) shape.normal = -shape.normal;
    // The mean of x x^T over the mass, which for an ellipsoid is a fifth of its squared semi-axes. Drawn with the length of the body.
    const Eigen::Matrix3d inertia = Eigen::Map<const Eigen::Matrix3d>(info.inertia);
    const Eigen::Matrix3d spread = 0.5 * inertia.trace() * Eigen::Matrix3d::Identity() - inertia;
    const double longest = baker::eigensystem(spread).values[2];
    shape.ellipsoid = spread * (0.25 * shape.length * shape.length / longest);
    return shape;
}

double default_step(const Shape& shape) {
    const double speed = std::sqrt(std::abs(shape.density / shape.fluid_density - 1.0) * gravity * shape.thickness);
    double step = 1.0 / 120.0;
    while (step * speed > 0.4 * shape.length && step > 1.0 / 960.0) step *= 0.5;
    return step;
}

std::vector<Track> drop(const lr_asset* asset, const Drop& options, uint32_t first, uint32_t count) {
    const Shape shape = shape_of(asset, options);
    const auto dt = static_cast<float>(options.step > 0.0 ? options.step : default_step(shape));
    const double longest = options.longest > 0.0 ? options.longest : 120.0 * std::max(1.0, options.height);
    const World world = make_world(options);
    lr_turbulence_desc eddies = LR_TURBULENCE_DESC_INIT;
    eddies.rms = static_cast<float>(options.turbulence);
    if (options.turbulence > 0.0)
        require(lr_world_add_turbulence(world.get(), &eddies, nullptr), "lr_world_add_turbulence");

    lr_batch_desc batch_desc = LR_BATCH_DESC_INIT;
    batch_desc.asset = asset;
    batch_desc.capacity = count;
    lr_batch batch{};
    require(lr_batch_create(world.get(), &batch_desc, &batch), "lr_batch_create");
    std::vector<lr_body_desc> descs(count, lr_body_desc LR_BODY_DESC_INIT);
    std::vector<Eigen::Vector3d> places;
    for (uint32_t i = 0; i < count; ++i) {
        places.push_back(place(options, first + i, eddies.integral_length));
        store(places[i], descs[i].position);
        const Eigen::Quaterniond q = start(options, shape.normal, first + i);
        for (int k = 0; k < 4; ++k) descs[i].orientation[k] = static_cast<float>(q.coeffs()[k]);
        descs[i].noise_seed = first + i + 1;
    }
    require(lr_body_create(world.get(), batch, descs.data(), count, nullptr), "lr_body_create");

    Reader reader(world.get(), batch, first, std::move(places));
    std::vector<Sample> now(count), before;
    reader.read(now);
    std::vector<Track> tracks(count);
    for (uint32_t i = 0; i < count; ++i) {
        tracks[i].interval = wide(dt);
        tracks[i].samples.push_back(now[i]);
    }
    uint32_t falling = count;
    uint64_t every = 1; // steps between samples
    for (uint64_t step = 1; falling > 0 && wide(dt) * static_cast<double>(step) <= longest; ++step) {
        before = now;
        require(lr_world_step(world.get(), dt, 1), "lr_world_step");
        reader.read(now);
        bool full = false;
        for (uint32_t i = 0; i < count; ++i) {
            Track& t = tracks[i];
            if (t.arrived) continue;
            const double from = std::abs(before[i].position.y()), to = std::abs(now[i].position.y());
            t.arrived = to >= options.height;
            const double part = t.arrived ? (options.height - from) / (to - from) : 1.0;
            t.time = wide(dt) * (static_cast<double>(step - 1) + part);
            t.end = before[i].position + part * (now[i].position - before[i].position);
            falling -= t.arrived;
            if (!t.arrived && step % every == 0) t.samples.push_back(now[i]);
            full = full || t.samples.size() >= most_samples;
        }
        if (full) {
            keep_every_second(tracks);
            every *= 2;
        }
    }
    return tracks;
}
} // namespace lr::falls
