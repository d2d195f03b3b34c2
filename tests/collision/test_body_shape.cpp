#include "asset/closed_forms/ellipsoid_asset.h"
#include "collision/body_shape.h"
#include "random_pairs.h"

#include <doctest/doctest.h>

using namespace lr;

namespace {

// Faces are wound outward, hold all points, and close: each edge occurs once in each direction.
void check_faces(const BodyShape& shape) {
    uint32_t edges[most_shape_points][most_shape_points]{};
    for (uint32_t f = 0; f < shape.face_count; ++f) {
        const ShapeFace& face = shape.faces[f];
        CHECK(length(face.normal) == doctest::Approx(1.0));
        REQUIRE(face.count >= 3);
        for (uint32_t i = 0; i < shape.count; ++i)
            CHECK(dot(face.normal, Vector{shape.x[i], shape.y[i], shape.z[i]}) - face.offset < 1e-5f * shape.reach);
        for (uint32_t i = 0; i < face.count; ++i) {
            const uint32_t a = shape.corners[face.first + i], b = shape.corners[face.first + (i + 1) % face.count];
            REQUIRE(a < shape.count);
            ++edges[a][b];
        }
    }
    for (uint32_t a = 0; a < shape.count; ++a)
        for (uint32_t b = 0; b < shape.count; ++b) CHECK((edges[a][b] == edges[b][a] && edges[a][b] <= 1));
}

// Distance of a point outside the shape, m.
double outside(const BodyShape& shape, Vector p) {
    double most = -1.0;
    for (uint32_t f = 0; f < shape.face_count; ++f)
        most =
            std::max(most, static_cast<double>(dot(shape.faces[f].normal, p) - shape.faces[f].offset - shape.radius));
    return most;
}

} // namespace

TEST_CASE("boxes keep their eight corners") {
    test::Random random(31);
    for (uint32_t i = 0; i < 200; ++i) {
        const auto size = static_cast<float>(random.logarithmic(1e-3, 10.0));
        const float y = size * random.real(0.06, 1.0), z = size * random.real(0.06, 1.0);
        const BodyShape shape = make_body_shape(test::asset_of(test::box_corners(size, y, z)));
        CHECK(shape.count == 8);
        CHECK(shape.face_count == 6);
        CHECK(shape.radius == 0.0f);
        CHECK(shape.thickness == doctest::Approx(2.0f * std::min(y, z)));
        CHECK(shape.reach == doctest::Approx(std::sqrt(size * size + y * y + z * z)));
        check_faces(shape);
    }
}

TEST_CASE("round hulls of many points are reduced to few") {
    test::Random random(32);
    for (uint32_t i = 0; i < test::rounds(60); ++i) {
        const auto size = static_cast<float>(random.logarithmic(1e-3, 10.0));
        std::vector<float> v = test::cloud(random, 500, size);
        for (size_t k = 0; k < v.size(); k += 3) v[k + 1] *= 0.3f;
        const BodyShape shape = make_body_shape(test::asset_of(v));
        CHECK(shape.count <= most_shape_points);
        CHECK(shape.count >= 20);
        check_faces(shape);
        double worst = 0.0;
        for (size_t k = 0; k < v.size(); k += 3) worst = std::max(worst, outside(shape, {v[k], v[k + 1], v[k + 2]}));
        // An oval 2 `size` large: within 5 % of that, although 32 corners of a ball cannot be within 3 %.
        CHECK(worst < 0.1 * static_cast<double>(size));
        CHECK(shape.reach < size * 1.001f);
    }
}

TEST_CASE("corners that stand out by less than 1 % are left out, all others kept") {
    test::Random random(34);
    for (uint32_t i = 0; i < 100; ++i) {
        const auto size = static_cast<float>(random.logarithmic(1e-3, 10.0));
        std::vector<float> v = test::box_corners(size, 0.7f * size, 0.5f * size);
        for (uint32_t k = 0; k < 100; ++k) { // bumps of half a percent on its faces
            float p[3] = {random.real(-0.9, 0.9), random.real(-0.9, 0.9), random.real(-0.9, 0.9)};
            p[k % 3] = random.below(2) == 0 ? 1.0f : -1.0f;
            const float half[3] = {size, 0.7f * size, 0.5f * size};
            for (uint32_t a = 0; a < 3; ++a) v.push_back(p[a] * half[a] + (a == k % 3 ? p[a] * 0.01f * size : 0.0f));
        }
        const BodyShape shape = make_body_shape(test::asset_of(v));
        CHECK(shape.count == 8);
        check_faces(shape);
    }
}

// For a long and narrow body, 1 % of the length would be its width.
TEST_CASE("rods and strips keep all their corners, and pyramids of any slenderness") {
    for (const float size : {1e-3f, 0.1f, 3.0f})
        for (const float slender : {0.001f, 0.005f, 0.01f, 0.03f, 0.1f, 0.5f}) {
            CAPTURE(slender);
            for (const float flat : {1.0f, 0.7f, 0.05f}) {
                const auto box = test::box_corners(size, slender * size, flat * slender * size);
                const BodyShape shape = make_body_shape(test::asset_of(box));
                CHECK(shape.count * (shape.radius > 0.0f ? 2 : 1) == 8);
                CHECK((shape.radius > 0.0f) == (flat < 0.1f && slender < 0.9f));
                if (shape.radius > 0.0f) continue;
                for (size_t k = 0; k < box.size(); k += 3)
                    CHECK(outside(shape, {box[k], box[k + 1], box[k + 2]}) <= 1e-6 * static_cast<double>(size));
            }
            std::vector<float> v{size, 0.0f, 0.0f};
            for (uint32_t i = 0; i < 5; ++i) {
                const float turn = 1.2566371f * static_cast<float>(i);
                v.insert(v.end(), {-size, slender * size * std::cos(turn), slender * size * std::sin(turn)});
            }
            const BodyShape cone = make_body_shape(test::asset_of(v));
            CHECK(cone.count == 6);
        }
}

TEST_CASE("meshes of balls and eggs are round, and what only looks so from afar is not") {
    const auto mesh = [](float x, float y, float z, float bump) {
        std::vector<float> v;
        for (uint32_t i = 0; i <= 12; ++i)
            for (uint32_t k = 0; k < (i % 12 == 0 ? 1u : 24u); ++k) {
                const float up = 3.1415927f / 12.0f * static_cast<float>(i), round = 0.2617994f * static_cast<float>(k);
                const float out = k == 5 ? 1.0f + bump : 1.0f;
                v.insert(v.end(), {0.2f * x + out * x * std::sin(up) * std::cos(round), out * y * std::cos(up),
                                   out * z * std::sin(up) * std::sin(round)});
            }
        lr::AssetData asset = test::asset_of(v);
        asset.center_of_buoyancy = {static_cast<double>(0.2f * x), 0.0, 0.0};
        return make_body_shape(asset);
    };
    for (const float size : {1e-3f, 0.04f, 2.0f}) {
        const BodyShape egg = mesh(size, 0.7f * size, 0.6f * size, 0.0f);
        CHECK(egg.count == 0);
        CHECK(egg.center.x == doctest::Approx(0.2f * size));
        CHECK(egg.semi_axes.x == doctest::Approx(size).epsilon(0.01));
        CHECK(egg.semi_axes.y == doctest::Approx(0.7f * size).epsilon(0.01));
        CHECK(egg.semi_axes.z == doctest::Approx(0.6f * size).epsilon(0.01));
        CHECK(mesh(size, size, size, 0.1f).count > 0);
        CHECK(mesh(size, 0.1f * size, size, 0.0f).count > 0);
    }
}

TEST_CASE("a leaf is its outline with half of its thickness around it") {
    for (const float size : {1e-3f, 0.04f, 1.0f})
        for (const float part : {1e-3f, 0.01f, 0.04f}) {
            const BodyShape shape = test::leaf(size, part * size);
            CHECK(shape.count <= 24);
            CHECK(shape.face_count == 2);
            CHECK(shape.radius == doctest::Approx(0.5f * part * size));
            CHECK(shape.thickness == doctest::Approx(part * size));
            CHECK(shape.reach == doctest::Approx(0.5f * size).epsilon(0.02));
            for (uint32_t i = 0; i < shape.count; ++i) CHECK(std::abs(shape.y[i]) < 1e-6f * size);
            check_faces(shape);
        }
}

TEST_CASE("a curved thin shell keeps both sides") {
    std::vector<float> v;
    for (int i = -10; i <= 10; ++i)
        for (int k = -10; k <= 10; ++k) {
            const float x = 0.1f * static_cast<float>(i), z = 0.1f * static_cast<float>(k);
            v.insert(v.end(), {x, 0.04f * (1.0f - x * x), z});
            v.insert(v.end(), {x, 0.04f * (1.0f - x * x) + 0.005f, z});
        }
    const BodyShape shape = make_body_shape(test::asset_of(v));
    CHECK(shape.radius == 0.0f);
    CHECK(shape.face_count > 2);
    check_faces(shape);
}

TEST_CASE("an ellipsoid made from closed forms is one, ballasted too") {
    test::Random random(33);
    for (uint32_t i = 0; i < 100; ++i) {
        shape::EllipsoidSpec spec;
        for (double& a : spec.semi_axes) a = random.logarithmic(1e-3, 1e-1);
        spec.density = 500.0;
        for (size_t k = 0; k < 3; ++k) spec.center_of_mass[k] = i % 2 == 0 ? 0.0 : 0.3 * spec.semi_axes[k];
        AssetData data;
        Faults faults;
        REQUIRE(shape::ellipsoid_body(spec, data, faults));
        const BodyShape shape = make_body_shape(data);
        REQUIRE(shape.count == 0);
        const double found[3] = {static_cast<double>(shape.semi_axes.x), static_cast<double>(shape.semi_axes.y),
                                 static_cast<double>(shape.semi_axes.z)};
        for (size_t k = 0; k < 3; ++k) CHECK(found[k] == doctest::Approx(spec.semi_axes[k]).epsilon(1e-4));
        CHECK(shape.center.x == doctest::Approx(-spec.center_of_mass[0]));
        CHECK(static_cast<double>(shape.reach) >=
              *std::max_element(spec.semi_axes.begin(), spec.semi_axes.end()) - 1e-9);
    }
}

TEST_CASE("a rigid is a box where its volume says so, else an ellipsoid") {
    AssetData data;
    data.mass = 1.0;
    data.inertia = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    data.center_of_buoyancy = {0.01, 0.0, 0.0};
    data.volume = 0.95 * 0.1 * 0.2 * 0.3;
    const BodyShape box = make_body_shape(data, {0.1, 0.2, 0.3});
    CHECK(box.count == 8);
    CHECK(box.center.x == doctest::Approx(0.01));
    CHECK(box.thickness == doctest::Approx(0.1));
    data.volume = 0.8 * 0.1 * 0.2 * 0.3;
    const BodyShape round = make_body_shape(data, {0.1, 0.2, 0.3});
    CHECK(round.count == 0);
    CHECK(round.semi_axes.y == doctest::Approx(0.1));
    CHECK(make_body_shape(data).count == 0);
}

TEST_CASE("hulls that bound nothing give a body all the same") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<std::vector<float>> hulls = {std::vector<float>(12, 1.0f),
                                                   {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3},
                                                   {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0},
                                                   {nan, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}};
    for (const auto& v : hulls) {
        const BodyShape shape = make_body_shape(test::asset_of(v));
        CHECK(std::isfinite(shape.reach));
        CHECK(shape.reach > 0.0f);
        CHECK(shape.thickness > 0.0f);
        if (shape.count > 0) check_faces(shape);
    }
}
