// Rays and overlaps through the API: closed forms of spheres, brute force over bodies, order, arguments.
#include "support/contact.h"

#include <algorithm>
#include <cmath>

using namespace test;

namespace {

struct Ball {
    Vec at;
    double radius;
    lr_body body;
    uint32_t noise_seed;
};

lr_ray ray_of(Vec from, Vec along) {
    lr_ray r = initialised(lr_ray_init);
    for (size_t k = 0; k < 3; ++k) {
        r.origin[k] = narrow(from[k]);
        r.direction[k] = narrow(along[k]);
    }
    return r;
}
Vec random_vec(Random& random, double size) {
    return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}
lr_ray_hit cast(const World& world, const lr_ray& r) {
    lr_ray_hit hit;
    REQUIRE(lr_world_ray_cast(world.get(), &r, 1, &hit) == LR_OK);
    return hit;
}
std::vector<lr_body> overlaps(const World& world, const lr_overlap_desc& d) {
    std::vector<lr_body> ids(5000);
    uint32_t count = 0;
    REQUIRE(lr_world_overlap(world.get(), &d, ids.data(), 5000, &count) == LR_OK);
    ids.resize(count);
    return ids;
}

// Balls of two batches, from millimetres to a metre, some asleep.
struct Balls {
    Asset asset = make(ellipsoid(0.1, 0.1, 0.1, 100.0));
    World world = make(world_desc());
    lr_batch batches[2] = {add_batch(world, asset, 1000), add_batch(world, asset, 1000)};
    std::vector<Ball> all;

    explicit Balls(bool reversed = false) {
        Random random(1);
        std::vector<lr_body_desc> descs[2];
        for (uint32_t i = 0; i < 1200; ++i) {
            lr_body_desc d = body_desc();
            const Vec at = random_vec(random, 5.0);
            for (size_t k = 0; k < 3; ++k) d.position[k] = narrow(at[k]);
            d.scale = narrow(random.logarithmic(0.01, 5.0));
            d.noise_seed = 5000 - i;
            descs[i % 2].push_back(d);
        }
        for (size_t b = 0; b < 2; ++b) {
            if (reversed) std::reverse(descs[b].begin(), descs[b].end());
            std::vector<lr_body> ids(600);
            REQUIRE(lr_body_create(world.get(), batches[b], descs[b].data(), 600, ids.data()) == LR_OK);
            for (size_t i = 0; i < 600; ++i)
                all.push_back(
                    {vec(descs[b][i].position), 0.1 * wide(descs[b][i].scale), ids[i], descs[b][i].noise_seed});
            REQUIRE(lr_body_set_sleep(world.get(), ids.data(), 200, LR_SLEEP_ASLEEP) == LR_OK);
        }
    }
};

} // namespace

TEST_CASE("a ray meets the nearest of many balls, where the sphere begins") {
    const Balls balls;
    Random random(2);
    int met = 0;
    for (int round = 0; round < 2000; ++round) {
        lr_ray r = ray_of(random_vec(random, 7.0), random_vec(random, 1.0));
        r.max_distance = random.real(0.5, 20.0);
        const Vec from = vec(r.origin), d = 1.0 / length(vec(r.direction)) * vec(r.direction);
        double least = wide(r.max_distance);
        const Ball* nearest = nullptr;
        for (const Ball& b : balls.all) {
            const Vec a = b.at - from;
            const double along = dot(a, d), room = b.radius * b.radius - dot(cross(a, d), cross(a, d));
            if (room < 0.0) continue;
            const double t = length(a) <= b.radius ? 0.0 : along - std::sqrt(room);
            if (t < 0.0 || t >= least) continue;
            least = t;
            nearest = &b;
        }
        const lr_ray_hit hit = cast(balls.world, r);
        CHECK(hit.collider.id == 0);
        REQUIRE(hit.body == (nearest ? nearest->body : lr_body{}));
        if (!nearest) continue;
        ++met;
        CHECK(wide(hit.distance) == doctest::Approx(least).epsilon(1e-5));
        const Vec at = vec(hit.position), n = vec(hit.normal);
        CHECK(length(at - (from + least * d)) < 1e-5);
        if (least == 0.0) {
            CHECK(length(n + d) < 1e-6);
            continue;
        }
        CHECK(length(nearest->radius * n - (at - nearest->at)) < 1e-5);
    }
    CHECK(met > 200);
    CHECK(met < 1900);
}

TEST_CASE("rays are told the same whatever order bodies lie in") {
    const Balls one, other(true);
    Random random(3);
    std::vector<lr_ray> rays;
    for (int i = 0; i < 500; ++i) rays.push_back(ray_of(random_vec(random, 7.0), random_vec(random, 1.0)));
    std::vector<lr_ray_hit> a(500), b(500);
    REQUIRE(lr_world_ray_cast(one.world.get(), rays.data(), 500, a.data()) == LR_OK);
    REQUIRE(lr_world_ray_cast(other.world.get(), rays.data(), 500, b.data()) == LR_OK);
    for (size_t i = 0; i < 500; ++i) {
        if (a[i].body.id != 0) {
            REQUIRE(b[i].body.id != 0);
            CHECK(state_of(one.world, a[i].body).noise_seed == state_of(other.world, b[i].body).noise_seed);
        }
        a[i].body = b[i].body = {};
        CHECK(std::memcmp(&a[i], &b[i], sizeof a[i]) == 0);
    }
}

TEST_CASE("a ray through sheets of paper meets their upper side, to a fraction of their thickness") {
    const Asset asset = leaf(); // 0.1 mm
    const World world = weightless();
    const lr_batch batch = add_batch(world, asset, 100);
    std::vector<lr_body> ids;
    for (int i = 0; i < 100; ++i) {
        lr_body_desc d = body_desc();
        d.position[2] = 0.0005f * static_cast<float>(i);
        ids.push_back(add_body(world, batch, d));
    }
    lr_ray r = ray_of({0.01, 0.002, 1.0}, {0.0, 0.0, -1.0});
    CHECK(cast(world, r).body == ids[99]);
    r.origin[2] = 0.02025f;
    const lr_ray_hit hit = cast(world, r);
    CHECK(hit.body == ids[40]);
    // An ellipsoid: half its thickness times sqrt(1 - x^2/a^2 - y^2/b^2).
    const double height = 0.00005 * std::sqrt(1.0 - 0.0625 - 0.04);
    CHECK(std::abs(wide(hit.position[2]) - (0.02 + height)) < 1e-8);
    CHECK(hit.normal[2] > 0.99f);
    r.origin[0] = 0.0401f;
    CHECK(cast(world, r).body.id == 0);
}

TEST_CASE("rays meet colliders where these stand, moved and turned, by their layers") {
    const World world = make(world_desc());
    lr_collider ids[4];
    lr_collider_desc plane = collider_desc(LR_COLLIDER_PLANE);
    plane.position[1] = -2.0f;
    lr_collider_desc box = box_collider(1.0f, 0.5f, 0.25f);
    box.position[0] = 3.0f;
    // A quarter turn about y: the box is 0.25 thick along x.
    box.orientation[1] = box.orientation[3] = std::sqrt(0.5f);
    box.layers = 2;
    lr_collider_desc ball = sphere_collider(0.5f);
    ball.position[0] = 6.0f;
    const Triangles sheet = bumpy_sheet(8, 1);
    lr_collider_desc mesh = mesh_collider(sheet);
    mesh.position[0] = 20.0f;
    int at = 0;
    for (const lr_collider_desc* d : {&plane, &box, &ball, &mesh})
        REQUIRE(lr_collider_create(world.get(), d, 1, &ids[at++]) == LR_OK);
    lr_ray r = ray_of({0.0, 0.0, 0.1}, {1.0, 0.0, 0.0});
    lr_ray_hit hit = cast(world, r);
    CHECK((hit.collider == ids[1] && hit.body.id == 0));
    CHECK(wide(hit.distance) == doctest::Approx(2.75));
    CHECK(wide(hit.normal[0]) == doctest::Approx(-1.0));
    r.collider_layers = 1;
    hit = cast(world, r);
    CHECK(hit.collider == ids[2]);
    CHECK(wide(hit.distance) == doctest::Approx(6.0 - std::sqrt(0.25 - 0.01)));
    r.flags = LR_RAY_BODIES;
    CHECK(cast(world, r).collider.id == 0);
    hit = cast(world, ray_of({-50.0, 1.0, 0.0}, {0.0, -2.0, 0.0}));
    CHECK(hit.collider == ids[0]);
    CHECK((hit.distance == 3.0f && hit.normal[1] == 1.0f && hit.position[1] == -2.0f));
    hit = cast(world, ray_of({20.5, 5.0, 0.5}, {0.0, -1.0, 0.0}));
    CHECK(hit.collider == ids[3]);
    // At equal distance, bodies come first.
    const Asset asset = make(ellipsoid(0.5, 0.5, 0.5, 100.0));
    const lr_batch batch = add_batch(world, asset, 2);
    lr_body_desc d = body_desc();
    d.position[0] = 6.0f;
    const lr_body body = add_body(world, batch, d);
    hit = cast(world, ray_of({6.0, 9.0, 0.0}, {0.0, -1.0, 0.0}));
    CHECK((hit.body == body && hit.collider.id == 0));
    // After a move they are at the new place.
    lr_collider_motion m = initialised(lr_collider_motion_init);
    m.mode = LR_MOVE_PLACE;
    m.collider = ids[0];
    m.position[1] = -1.0f;
    REQUIRE(lr_collider_move(world.get(), &m, 1) == LR_OK);
    CHECK(cast(world, ray_of({-50.0, 1.0, 0.0}, {0.0, -1.0, 0.0})).distance == 2.0f);
}

TEST_CASE("overlaps of balls with spheres and boxes are those of closed forms, in order of batches and noise seeds") {
    const Balls balls;
    Random random(4);
    size_t most = 0;
    for (int round = 0; round < 300; ++round) {
        lr_overlap_desc d = initialised(lr_overlap_desc_init);
        const Vec at = random_vec(random, 5.0);
        const Quat q = any_turn(random);
        put(d.position, at);
        put(d.orientation, q);
        for (float& s : d.size) s = narrow(random.logarithmic(0.01, 5.0));
        d.shape = round % 2 ? LR_OVERLAP_BOX : LR_OVERLAP_SPHERE;
        d.batch = round % 3 ? lr_batch{} : balls.batches[1];
        std::vector<const Ball*> expected;
        for (size_t i = 0; i < balls.all.size(); ++i) {
            const Ball& b = balls.all[i];
            if (d.batch.id != 0 && i < 600) continue;
            const Vec p = to_body(quat(d.orientation), b.at - vec(d.position));
            double square = 0.0;
            for (size_t k = 0; k < 3; ++k) {
                const double out = std::max(std::abs(p[k]) - wide(d.size[k]), 0.0);
                square += out * out;
            }
            const double gap = (round % 2 ? std::sqrt(square) : length(p) - wide(d.size[0])) - b.radius;
            REQUIRE(std::abs(gap) > 1e-6); // far from rounding
            if (gap < 0.0) expected.push_back(&b);
        }
        std::stable_sort(expected.begin(), expected.end(), [&](const Ball* a, const Ball* b) {
            const bool first_a = a < &balls.all[600], first_b = b < &balls.all[600];
            return first_a != first_b ? first_a : a->noise_seed < b->noise_seed;
        });
        const std::vector<lr_body> got = overlaps(balls.world, d);
        REQUIRE(got.size() == expected.size());
        for (size_t i = 0; i < got.size(); ++i) CHECK(got[i] == expected[i]->body);
        most = std::max(most, got.size());
        if (got.empty()) continue;
        uint32_t count = 0;
        std::vector<lr_body> few(got.size() - 1);
        CHECK(lr_world_overlap(balls.world.get(), &d, few.data(), static_cast<uint32_t>(few.size()), &count) ==
              LR_ERROR_BUFFER_TOO_SMALL);
        CHECK(count == got.size());
    }
    CHECK(most > 300);
}

TEST_CASE("overlaps of flat bodies with boxes are those that points of them say") {
    const Asset asset = make(ellipsoid(0.2, 0.1, 0.01, 300.0));
    const World world = weightless();
    const lr_batch batch = add_batch(world, asset, 400);
    Random random(5);
    std::vector<lr_body> ids;
    for (int i = 0; i < 400; ++i) {
        lr_body_desc d = body_desc();
        const Vec at = random_vec(random, 0.6);
        const Vec q = random_vec(random, 1.0);
        for (size_t k = 0; k < 3; ++k) d.position[k] = narrow(at[k]), d.orientation[k] = narrow(q[k]);
        d.orientation[3] = random.real(-1, 1);
        ids.push_back(add_body(world, batch, d));
    }
    lr_overlap_desc box = initialised(lr_overlap_desc_init);
    box.shape = LR_OVERLAP_BOX;
    box.size[0] = 0.3f, box.size[1] = 0.1f, box.size[2] = 0.2f;
    const std::vector<lr_body> got = overlaps(world, box);
    int undecided = 0;
    for (const lr_body body : ids) {
        const lr_body_state s = state_of(world, body);
        bool in = false;
        for (int n = 0; n < 4000 && !in; ++n) {
            Vec u = random_vec(random, 1.0);
            u = 1.0 / std::max(length(u), 1.0) * u;
            const Vec p = vec(s.position) + to_world(quat(s.orientation), {0.2 * u[0], 0.1 * u[1], 0.01 * u[2]});
            in = std::abs(p[0]) <= 0.3 && std::abs(p[1]) <= 0.1 && std::abs(p[2]) <= 0.2;
        }
        const bool told = std::find(got.begin(), got.end(), body) != got.end();
        if (in) CHECK(told);
        undecided += told && !in ? 1 : 0;
    }
    CHECK(undecided <= 8); // closer than the distance of the sample points
    CHECK(got.size() > 40);
    CHECK(got.size() < 360);
}

TEST_CASE("queries refuse wrong arguments, change nothing, and do nothing in part") {
    const Balls balls;
    const World& world = balls.world;
    const uint64_t before = hash_of(world);
    lr_ray rays[2] = {ray_of({9.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}), ray_of({9.0, 0.0, 0.0}, {-1.0, 0.0, 0.0})};
    const lr_ray good = rays[1];
    lr_ray_hit hits[2];
    const auto refused = [&](lr_status status) {
        std::memset(hits, 0x5a, sizeof hits);
        CHECK(lr_world_ray_cast(world.get(), rays, 2, hits) == status);
        bool untouched = true;
        for (const unsigned char* byte = reinterpret_cast<unsigned char*>(hits);
             byte < reinterpret_cast<unsigned char*>(hits + 2); ++byte)
            untouched = untouched && *byte == 0x5a;
        CHECK(untouched);
        rays[1] = good;
    };
    rays[1].flags = 0, refused(LR_ERROR_INVALID_ARGUMENT);
    rays[1].flags = 4, refused(LR_ERROR_INVALID_ARGUMENT);
    rays[1].direction[0] = 0.0f, refused(LR_ERROR_INVALID_ARGUMENT);
    rays[1].direction[1] = NAN, refused(LR_ERROR_NOT_FINITE);
    rays[1].origin[1] = INFINITY, refused(LR_ERROR_NOT_FINITE);
    rays[1].origin[1] = 2e9f, refused(LR_ERROR_INVALID_ARGUMENT);
    rays[1].max_distance = -1.0f, refused(LR_ERROR_INVALID_ARGUMENT);
    rays[1].max_distance = INFINITY, refused(LR_ERROR_NOT_FINITE);
    rays[1].batch = {77}, refused(LR_ERROR_STALE_BATCH);
    rays[1].reserved = 1, refused(LR_ERROR_INVALID_ARGUMENT);
    rays[1].struct_size += 4, refused(LR_ERROR_STRUCT_SIZE);
    CHECK(lr_world_ray_cast(world.get(), nullptr, 0, nullptr) == LR_OK);
    uint32_t count = 9;
    lr_body id{};
    const lr_overlap_desc fine = initialised(lr_overlap_desc_init);
    lr_overlap_desc d = fine;
    const auto overlap_refused = [&](lr_status status) {
        CHECK(lr_world_overlap(world.get(), &d, &id, 1, &count) == status);
        CHECK(count == 0);
        d = fine;
    };
    d.shape = 3, overlap_refused(LR_ERROR_INVALID_ARGUMENT);
    d.size[0] = 0.0f, overlap_refused(LR_ERROR_INVALID_ARGUMENT);
    d.size[2] = NAN, overlap_refused(LR_ERROR_NOT_FINITE);
    d.orientation[3] = 0.0f, overlap_refused(LR_ERROR_INVALID_ARGUMENT);
    d.position[0] = -2e9f, overlap_refused(LR_ERROR_INVALID_ARGUMENT);
    d.batch = {77}, overlap_refused(LR_ERROR_STALE_BATCH);
    d.reserved = 1, overlap_refused(LR_ERROR_INVALID_ARGUMENT);
    CHECK(lr_world_overlap(world.get(), &d, nullptr, 0, &count) == LR_ERROR_BUFFER_TOO_SMALL);
    CHECK(count > 0);
    CHECK(hash_of(world) == before);
}
