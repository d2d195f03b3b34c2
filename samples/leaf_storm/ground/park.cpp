// SPDX-License-Identifier: MIT
#include "ground/park.h"

#include <algorithm>
#include <cmath>

#include "failure.h"
#include "storm_scene.h"

namespace {

constexpr double walker_speed = 1.4, walker_from = -4.6, walker_to = 4.6, walker_z = 0.1; // m/s, m
constexpr double gust_rise = 0.8, gust_hold = 2.2, gust_fall = 1.5;                       // s

ground_solid object(std::int32_t kind, double x, double y, double z, double turn = 0.0) {
    ground_solid s{};
    s.kind = kind;
    s.at[0] = static_cast<float>(x), s.at[1] = static_cast<float>(y), s.at[2] = static_cast<float>(z);
    s.turn = static_cast<float>(turn);
    return s;
}

double smooth(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

} // namespace

Park::Park(const Options& options, lr_world* world) : options_(options), world_(world), terrain_(options.seed) {
    add_ground();
    add_furniture();
    add_boundary_layer();
    set_wind(0.0);
}

void Park::add(ground_solid object, solid_look look, double radius) {
    object.look = look;
    lr_collider_desc desc = LR_COLLIDER_DESC_INIT;
    desc.kind = object.kind;
    std::copy(object.at, object.at + 3, desc.position);
    std::copy(object.size, object.size + 3, desc.size);
    const Quaternion q = rotation({0.0, 1.0, 0.0}, static_cast<double>(object.turn));
    for (std::size_t k = 0; k < 4; ++k) desc.orientation[k] = static_cast<float>(q[k]);
    desc.vertices = object.points;
    desc.vertex_count = object.point_count;
    check(lr_collider_create(world_, &desc, 1, &last_), "cannot create a collider");
    solids_.push_back(object);
    if (look != solid_cloth)
        footprints_.push_back({static_cast<double>(object.at[0]), static_cast<double>(object.at[2]), radius});
}

void Park::add_ground() {
    lr_collider_desc desc = LR_COLLIDER_DESC_INIT;
    desc.kind = LR_COLLIDER_HEIGHTFIELD;
    desc.position[0] = desc.position[2] = -Terrain::half_width;
    desc.counts[0] = desc.counts[1] = Terrain::side;
    desc.spacing[0] = desc.spacing[1] = Terrain::cell;
    desc.heights = terrain_.heights().data();
    desc.friction = 0.7f;
    check(lr_collider_create(world_, &desc, 1, nullptr), "cannot create the ground");
}

void Park::add_furniture() {
    const auto box = [&](double x, double y, double z, const Vector& half, double turn, solid_look look) {
        ground_solid s = object(LR_COLLIDER_BOX, x, y, z, turn);
        for (std::size_t k = 0; k < 3; ++k) s.size[k] = static_cast<float>(half[k]);
        add(s, look, std::hypot(half[0], half[2]));
    };
    const double bench_x = 1.5, bench_z = -1.9, turn = -0.25, floor = terrain_.at(bench_x, bench_z).height;
    const Quaternion turned_by = rotation({0.0, 1.0, 0.0}, turn);
    for (const double along : {-0.6, 0.6}) {
        const Vector leg = turned(turned_by, {along, 0.0, 0.0});
        box(bench_x + leg[0], floor + 0.17, bench_z + leg[2], {0.06, 0.25, 0.18}, turn, solid_stone);
    }
    box(bench_x, floor + 0.45, bench_z, {0.85, 0.03, 0.22}, turn, solid_wood);
    box(-2.6, terrain_.at(-2.6, -3.4).height + 0.15, -3.4, {1.5, 0.35, 0.14}, 0.18, solid_stone);

    struct Stone {
        double x, z, size;
    };
    std::uint64_t index = 0;
    for (const Stone& stone : {Stone{-1.25, 1.15, 0.17}, Stone{-0.85, 0.95, 0.09}, Stone{1.15, 1.35, 0.12},
                               Stone{-3.3, -0.9, 0.32}, Stone{3.2, -0.6, 0.24}}) {
        // A lump: random points on a flattened sphere.
        std::vector<float>& points = stones_.emplace_back();
        for (int k = 0; k < 22; ++k) {
            float q[4];
            storm::random_orientation(77, index++, q);
            const Vector direction = turned({static_cast<double>(q[0]), static_cast<double>(q[1]),
                                             static_cast<double>(q[2]), static_cast<double>(q[3])},
                                            {stone.size, 0.0, 0.0});
            const double point[3] = {direction[0], 0.65 * direction[1], 0.85 * direction[2]};
            for (const double x : point) points.push_back(static_cast<float>(x));
        }
        ground_solid s =
            object(LR_COLLIDER_HULL, stone.x, terrain_.at(stone.x, stone.z).height + 0.25 * stone.size, stone.z);
        s.point_count = static_cast<std::uint32_t>(points.size() / 3);
        s.points = points.data();
        add(s, solid_stone, stone.size);
    }
    if (options_.walk < 0.0) return;
    ground_solid s = object(LR_COLLIDER_CAPSULE, 0.0, -50.0, 0.0); // out of the way until the walk begins
    s.size[0] = walker_radius, s.size[1] = walker_half_length;
    add(s, solid_cloth, 0.0);
}

// Air is slow near the ground: the wind is 0 below the lowest hollow and complete at 10 m.
void Park::add_boundary_layer() {
    lr_ground_wind_desc ground;
    check(lr_ground_wind_desc_init(&ground, sizeof ground), "lr_ground_wind_desc_init");
    ground.position[1] = static_cast<float>(terrain_.lowest()) - 0.05f;
    ground.roughness_length = 0.01f; // short grass
    check(lr_world_add_ground_wind(world_, &ground, nullptr), "the wind over the ground");
    if (options_.gusts < 0.0) return;
    lr_gusts_desc gusts;
    check(lr_gusts_desc_init(&gusts, sizeof gusts), "lr_gusts_desc_init");
    gusts.rms = 0.15f;
    gusts.angle_rms = 0.3f;
    gusts.integral_time = 5.0f;
    std::copy(options_.wind, options_.wind + 3, gusts.direction);
    if (options_.wind[0] == 0.0f && options_.wind[1] == 0.0f && options_.wind[2] == 0.0f) gusts.direction[0] = 1.0f;
    check(lr_world_add_gusts(world_, &gusts, nullptr), "the gusts");
}

void Park::set_wind(double time) {
    double gust = 0.0;
    if (options_.gusts >= 0.0) {
        const double since = time - options_.gusts;
        gust = smooth(since / gust_rise) * smooth((gust_rise + gust_hold + gust_fall - since) / gust_fall);
    }
    double length = 0.0;
    for (const float x : options_.wind) length += static_cast<double>(x) * static_cast<double>(x);
    length = std::sqrt(length);
    const Vector along =
        length > 0.0
            ? times(1.0 / length, {static_cast<double>(options_.wind[0]), static_cast<double>(options_.wind[1]),
                                   static_cast<double>(options_.wind[2])})
            : Vector{1.0, 0.0, 0.0};
    const double speed = length + gust * options_.gust_speed;
    float air[3];
    for (std::size_t k = 0; k < 3; ++k) air[k] = static_cast<float>(speed * along[k]);
    if (std::equal(wind_, wind_ + 3, air)) return;
    std::copy(air, air + 3, wind_);
    check(lr_world_set_uniform_wind(world_, air[0], air[1], air[2]), "wind");
}

void Park::move(double to) {
    set_wind(to);
    if (options_.walk < 0.0) return;
    const double x = walker_from + walker_speed * (to - options_.walk);
    const bool walks = to >= options_.walk && x <= walker_to;
    if (!walks && !walks_) return;
    ground_solid& piece = solids_.back();
    piece.at[0] = static_cast<float>(x);
    piece.at[1] = static_cast<float>(terrain_.at(x, walker_z).height) + walker_radius + walker_half_length;
    piece.at[2] = static_cast<float>(walker_z);
    if (!walks) piece.at[1] = -50.0f;
    lr_collider_motion motion;
    check(lr_collider_motion_init(&motion, sizeof motion), "lr_collider_motion_init");
    motion.mode = walks && walks_ ? LR_MOVE_TO : LR_MOVE_PLACE; // it appears and disappears at once
    motion.collider = last_;
    std::copy(piece.at, piece.at + 3, motion.position);
    check(lr_collider_move(world_, &motion, 1), "the walker");
    walks_ = walks;
}

Park::Place Park::heap() const {
    return {0.1f, static_cast<float>(terrain_.at(0.1, walker_z).height), static_cast<float>(walker_z)};
}

bool Park::furnished(double x, double z, double reach) const {
    return std::any_of(footprints_.begin(), footprints_.end(),
                       [&](const Footprint& at) { return std::hypot(x - at.x, z - at.z) < at.radius + reach; });
}
