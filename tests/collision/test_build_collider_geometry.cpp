#include "collision/build_collider_geometry.h"
#include "collision/collider_geometry.h"
#include "random_pairs.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

using namespace lr;

namespace {

double along(const float* face, const float* v) {
    return static_cast<double>(face[0]) * static_cast<double>(v[0]) +
           static_cast<double>(face[1]) * static_cast<double>(v[1]) +
           static_cast<double>(face[2]) * static_cast<double>(v[2]) - static_cast<double>(face[3]);
}

} // namespace

TEST_CASE("a hull's faces hold its points and each has corners") {
    test::Random random(21);
    for (uint32_t i = 0; i < test::rounds(500); ++i) {
        const auto size = static_cast<float>(random.logarithmic(1e-3, 1e3));
        const std::vector<float> points = test::cloud(random, 4 + random.below(253), size);
        BuiltHull hull;
        REQUIRE(build_hull(points.data(), static_cast<uint32_t>(points.size() / 3), hull));
        const std::vector<float>&vertices = hull.vertices, &faces = hull.faces;
        for (size_t f = 0; f < faces.size(); f += 4) {
            CHECK(faces[f] * faces[f] + faces[f + 1] * faces[f + 1] + faces[f + 2] * faces[f + 2] ==
                  doctest::Approx(1.0));
            uint32_t on = 0;
            for (size_t v = 0; v < points.size(); v += 3) {
                const double out = along(&faces[f], &points[v]) / static_cast<double>(size);
                REQUIRE(out < 5e-6);
                on += out > -1e-5;
            }
            CHECK(on >= 3);
        }
        // Euler: with triangles alone F = 2 V - 4; flat faces reduce their number.
        CHECK(faces.size() / 4 <= 2 * (vertices.size() / 3) - 4);
    }
}

TEST_CASE("a box has six faces and eight corners, with points on its faces and turned") {
    test::Random random(22);
    for (uint32_t i = 0; i < 300; ++i) {
        const Rotation q = i < 10 ? Rotation{0, 0, 0, 1} : test::any_rotation(random);
        const auto size = static_cast<float>(random.logarithmic(1e-3, 1e2));
        const float half[3] = {size, size * random.real(0.1, 1.0), size * random.real(0.01, 1.0)};
        std::vector<float> points;
        for (uint32_t k = 0; k < 40; ++k) {
            float p[3];
            for (uint32_t a = 0; a < 3; ++a)
                p[a] = k < 8 ? ((k >> a & 1u) != 0 ? half[a] : -half[a]) : half[a] * random.real(-1, 1);
            if (k >= 8) p[k % 3] = k % 2 == 0 ? half[k % 3] : -half[k % 3];
            const Vector turned = rotate(q, {p[0], p[1], p[2]});
            points.insert(points.end(), {turned.x, turned.y, turned.z});
        }
        BuiltHull hull;
        REQUIRE(build_hull(points.data(), 40, hull));
        CHECK(hull.vertices.size() == 24);
        CHECK(hull.faces.size() == 24);
        const HullGeometry box = hull.geometry();
        for (uint32_t f = 0; f < box.face_count; ++f) {
            REQUIRE(box.corner_count(f) == 4);
            for (uint32_t k = 0; k < 4; ++k) {
                const Vector side = box.corner(f, (k + 1) % 4) - box.corner(f, k);
                const Vector next = box.corner(f, (k + 2) % 4) - box.corner(f, (k + 1) % 4);
                CHECK(dot(box.normal(f), cross(side, next)) > 0.99f * length(side) * length(next));
            }
        }
    }
}

TEST_CASE("hulls without an inside are refused") {
    BuiltHull hull;
    const std::vector<float> flat{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5f, 0.5f, 1e-5f};
    CHECK_FALSE(build_hull(flat.data(), 4, hull));
    CHECK_FALSE(build_hull(flat.data(), 5, hull));
    const std::vector<float> line{0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3}, one(12, 1.0f);
    CHECK_FALSE(build_hull(line.data(), 4, hull));
    CHECK_FALSE(build_hull(one.data(), 4, hull));
    const std::vector<float> box = test::box_corners(1, 1, 1);
    REQUIRE(build_hull(box.data(), 8, hull));
}

TEST_CASE("edges of a mesh are hidden where the surface is flat or hollow") {
    // Two triangles that share an edge; the second's last corner is lifted. With and without shared vertices, wound either way.
    for (const float lift : {-0.5f, 0.0f, 0.5f})
        for (const bool shared : {true, false})
            for (const bool turned : {false, true}) {
                std::vector<float> v{0, 0, 0, 1, 0, 0, 0.5f, 0, -1, 0.5f, lift, 1, 0, 0, 0, 1, 0, 0};
                const uint32_t a = shared ? 0 : 4, b = shared ? 1 : 5;
                std::vector<uint32_t> t{0, 1, 2, a, 3, b};
                if (turned) std::swap(t[3], t[4]);
                std::vector<float> normals;
                std::vector<uint8_t> hidden;
                REQUIRE(build_mesh(v.data(), 6, t.data(), 2, normals, hidden));
                CHECK(normals[1] == 1.0f);
                // Edge 0 of the first is the shared one.
                const unsigned expected = lift > 0.0f ? 1u : lift < 0.0f ? 8u : 9u;
                CHECK(unsigned{hidden[0]} == expected);
            }
}

TEST_CASE("meshes without an area are refused, lines among triangles are not") {
    const std::vector<float> v{0, 0, 0, 1, 0, 0, 0, 1, 0, 2, 0, 0};
    std::vector<float> normals;
    std::vector<uint8_t> hidden;
    const std::vector<uint32_t> good{0, 1, 2, 0, 1, 3}, line{0, 1, 3};
    REQUIRE(build_mesh(v.data(), 4, good.data(), 2, normals, hidden));
    CHECK(normals == std::vector<float>{0, 0, 1, 0, 0, 0});
    CHECK_FALSE(build_mesh(v.data(), 4, line.data(), 1, normals, hidden));
}

TEST_CASE("the steepest secant is that of the plane of all samples, and no way along a surface rises faster") {
    test::Random random(24);
    for (uint32_t round = 0; round < 200; ++round) {
        const uint32_t counts[2] = {2 + random.below(20), 2 + random.below(20)};
        const float spacing[2] = {random.real(0.01, 2), random.real(0.01, 2)};
        const double slope[2] = {static_cast<double>(random.real(-3, 3)), static_cast<double>(random.real(-3, 3))};
        std::vector<float> heights;
        for (uint32_t k = 0; k < counts[1]; ++k)
            for (uint32_t i = 0; i < counts[0]; ++i)
                heights.push_back(static_cast<float>(slope[0] * i * static_cast<double>(spacing[0]) +
                                                     slope[1] * k * static_cast<double>(spacing[1])));
        const double even = std::sqrt(1.0 + slope[0] * slope[0] + slope[1] * slope[1]);
        CHECK(static_cast<double>(steepest_secant(counts, spacing, heights.data())) ==
              doctest::Approx(even).epsilon(1e-4));

        for (float& h : heights) h = random.real(-1, 1);
        const double most = static_cast<double>(steepest_secant(counts, spacing, heights.data()));
        // Between neighbours, and across cells along the edge that their triangles share.
        for (uint32_t k = 0; k + 1 < counts[1]; ++k)
            for (uint32_t i = 0; i + 1 < counts[0]; ++i) {
                const auto rise = [&](uint32_t x, uint32_t z) {
                    const size_t at = i + size_t{counts[0]} * k;
                    const double way =
                        std::hypot(static_cast<double>(spacing[0]) * x, static_cast<double>(spacing[1]) * z);
                    return (static_cast<double>(heights[at + x + size_t{counts[0]} * z]) -
                            static_cast<double>(heights[at])) /
                           way;
                };
                for (const double r : {rise(1, 0), rise(0, 1), rise(1, 1)}) CHECK(std::sqrt(1.0 + r * r) <= most);
            }
    }
}

TEST_CASE("coarse heights are over all samples in a square and around it") {
    test::Random random(23);
    for (uint32_t round = 0; round < 200; ++round) {
        const uint32_t counts[2] = {2 + random.below(30), 2 + random.below(30)};
        std::vector<float> heights(size_t{counts[0]} * counts[1]);
        for (float& h : heights) h = random.real(-1, 1);
        std::vector<float> coarse;
        uint32_t coarse_counts[2];
        float lowest = 0, highest = 0;
        build_coarse(counts, heights.data(), coarse, coarse_counts, lowest, highest);
        CHECK(lowest == *std::min_element(heights.begin(), heights.end()));
        CHECK(highest == *std::max_element(heights.begin(), heights.end()));
        const auto square = [](int at, int cells) { return std::min(at, cells - 1) / 4; };
        for (int sz = 0; sz < static_cast<int>(coarse_counts[1]); ++sz)
            for (int sx = 0; sx < static_cast<int>(coarse_counts[0]); ++sx) {
                float expected = -2.0f;
                for (int k = 0; k < static_cast<int>(counts[1]); ++k)
                    for (int i = 0; i < static_cast<int>(counts[0]); ++i)
                        // Samples on a border belong to the squares on both sides.
                        if (i >= 4 * (sx - 1) && i <= 4 * (sx + 2) && k >= 4 * (sz - 1) && k <= 4 * (sz + 2))
                            expected = std::max(expected,
                                                heights[static_cast<size_t>(k) * counts[0] + static_cast<size_t>(i)]);
                CHECK(coarse[static_cast<size_t>(sz) * coarse_counts[0] + static_cast<size_t>(sx)] == expected);
            }
        CHECK(square(static_cast<int>(counts[0]) - 1, static_cast<int>(counts[0]) - 1) ==
              static_cast<int>(coarse_counts[0]) - 1);
    }
}

TEST_CASE("of closed surfaces that are wound differently the rarer ones are turned, but no room around them") {
    struct Box {
        float at, half;
        bool mirrored;
    };
    const auto turned = [](const std::vector<Box>& boxes) {
        std::vector<float> vertices, normals;
        std::vector<uint32_t> indices;
        std::vector<uint8_t> hidden;
        for (const Box& b : boxes) {
            const auto base = static_cast<uint32_t>(vertices.size() / 3);
            for (uint32_t c = 0; c < 8; ++c)
                vertices.insert(vertices.end(), {b.at + (c & 4u ? b.half : -b.half), c & 2u ? b.half : -b.half,
                                                 c & 1u ? b.half : -b.half});
            for (const uint32_t c : {0u, 1u, 3u, 0u, 3u, 2u, 4u, 6u, 7u, 4u, 7u, 5u, 0u, 4u, 5u, 0u, 5u, 1u,
                                     2u, 3u, 7u, 2u, 7u, 6u, 0u, 2u, 6u, 0u, 6u, 4u, 1u, 5u, 7u, 1u, 7u, 3u})
                indices.push_back(base + c);
            for (size_t i = indices.size() - 36; i < indices.size() && b.mirrored; i += 3)
                std::swap(indices[i + 1], indices[i + 2]);
        }
        REQUIRE(lr::build_mesh(vertices.data(), static_cast<uint32_t>(vertices.size() / 3), indices.data(),
                               static_cast<uint32_t>(indices.size() / 3), normals, hidden));
        std::string out;
        for (size_t b = 0; b < boxes.size(); ++b) {
            const auto from = hidden.begin() + static_cast<ptrdiff_t>(12 * b);
            const auto count = std::count_if(from, from + 12, [](uint8_t h) { return (h & lr::turned_triangle) != 0; });
            out += count == 0 ? '.' : count == 12 ? 'x' : '?';
        }
        return out;
    };
    CHECK(turned({{0, 1, false}, {3, 1, true}, {6, 1, false}}) == ".x.");
    CHECK(turned({{0, 1, true}, {3, 1, true}, {6, 1, false}}) == "..x");
    CHECK(turned({{0, 1, true}, {3, 1, true}, {6, 1, true}}) == "...");
    CHECK(turned({{0, 9, true}, {3, 1, false}, {6, 1, false}}) == "...");
    CHECK(turned({{0, 9, true}, {3, 1, false}, {6, 1, true}, {-3, 1, false}}) == "..x.");
}
