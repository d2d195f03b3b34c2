// From the alpha channel of an image to a flat mesh.
#include "baker/bake.h"
#include "baker/fault_text.h"
#include "baker/json.h"
#include "cards.h"
#include "mesh_shapes.h"
#include "scratch.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>

using namespace lr;
using namespace lr::baker;
using namespace lr::test;

namespace {

constexpr double pi = 3.14159265358979323846;

Opacity maple(std::size_t size) {
    std::vector<std::pair<double, double>> right = {{0, -1},   {.08, -.35}, {.5, -.55}, {.42, -.4}, {.95, -.1},
                                                    {.8, 0},   {.9, .3},    {.55, .22}, {.5, .35},  {.2, .1},
                                                    {.33, .6}, {.15, .55},  {0, .95}};
    for (std::size_t i = 11; i > 0; --i) right.emplace_back(-right[i].first, right[i].second);
    const auto scale = static_cast<double>(size);
    for (auto& [x, y] : right) {
        x = scale * (0.5 + 0.48 * x);
        y = scale * (0.5 - 0.48 * y);
    }
    return test::draw(size, size, [&](double x, double y) { return test::in_polygon(right, x, y); });
}

} // namespace

TEST_CASE("card: a disc keeps its area, outline and place") {
    for (const std::size_t triangles : {200U, 2000U}) {
        const Card card = read(disc(256, 100), triangles);
        CHECK(check_sound(card) == 1);
        CHECK(card.faults.empty());
        CHECK(card.mesh.faces.size() == doctest::Approx(static_cast<double>(triangles)).epsilon(0.1));
        CHECK(area(card.mesh) == doctest::Approx(pi * 1e4).epsilon(5e-4));
        CHECK(card.report.outline == doctest::Approx(2 * pi * 100).epsilon(triangles > 1000 ? 2e-3 : 5e-3));
        CHECK(card.report.smallest_angle > 28.0);
        CHECK(centroid(card.mesh).norm() < 0.02);
        CHECK(card.report.pieces == 1);
        CHECK(card.report.holes == 0);
        double farthest = 0.0;
        for (const Eigen::Vector3d& v : card.mesh.vertices) farthest = std::max(farthest, v.norm());
        CHECK(farthest < 101.5);
    }
}

TEST_CASE("card: the stairs of a mask without grey levels are smoothed") {
    Opacity mask = disc(512, 200);
    for (double& v : mask.value) v = v >= 0.5;
    const Card card = read(mask);
    CHECK(check_sound(card) == 1);
    CHECK(area(card.mesh) == doctest::Approx(pi * 4e4).epsilon(1e-3));
    CHECK(card.report.outline == doctest::Approx(2 * pi * 200).epsilon(3e-3));
    CHECK(card.report.smallest_angle > 28.0);
}

TEST_CASE("card: holes, and islands in them") {
    const Card ring = read(disc(256, 100, 50));
    CHECK(check_sound(ring) == 0);
    CHECK(ring.report.holes == 1);
    CHECK(area(ring.mesh) == doctest::Approx(pi * 7500).epsilon(1e-3));

    Opacity target = disc(256, 110, 90);
    const Opacity inner = disc(256, 60, 30);
    for (std::size_t i = 0; i < target.value.size(); ++i) target.value[i] += inner.value[i];
    CardOptions options = in_pixels(target);
    options.piece = 2;
    const Card island = read(test::png_file(target), options);
    CHECK(check_sound(island) == 0);
    CHECK(area(island.mesh) == doctest::Approx(pi * 2700).epsilon(1e-3));
    options.piece.reset();
    options.all_pieces = true;
    const Card both = read(test::png_file(target), options);
    CHECK(check_sound(both) == 0);
    CHECK(area(both.mesh) == doctest::Approx(pi * (4000 + 2700)).epsilon(1e-3));
}

TEST_CASE("card: a rectangle of whole pixels is exact, in the image and at its border") {
    const auto rectangle = [](std::size_t x0, std::size_t y0, std::size_t x1, std::size_t y1) {
        Opacity mask{64, 40, std::vector<double>(64 * 40, 0.0)};
        for (std::size_t y = y0; y < y1; ++y)
            for (std::size_t x = x0; x < x1; ++x) mask.at(x, y) = 1.0;
        return mask;
    };
    for (const auto& [x0, y0, x1, y1] : {std::array<std::size_t, 4>{10, 7, 41, 33}, {0, 0, 64, 20}, {0, 30, 30, 40}}) {
        const Card card = read(rectangle(x0, y0, x1, y1), 400);
        CHECK(check_sound(card) == 1);
        const auto w = static_cast<double>(x1 - x0), h = static_cast<double>(y1 - y0);
        CHECK(area(card.mesh) == doctest::Approx(w * h).epsilon(1e-12));
        CHECK(card.report.outline == doctest::Approx(2 * (w + h)).epsilon(1e-12));
        Eigen::Vector3d low = card.mesh.vertices[0], high = low;
        for (const Eigen::Vector3d& v : card.mesh.vertices) {
            low = low.cwiseMin(v);
            high = high.cwiseMax(v);
        }
        CHECK(low.x() == static_cast<double>(x0) - 32.0); // y points up, from the centre of the image
        CHECK(high.x() == static_cast<double>(x1) - 32.0);
        CHECK(high.y() == 20.0 - static_cast<double>(y0));
        CHECK(low.y() == 20.0 - static_cast<double>(y1));
    }
}

TEST_CASE("card: a turned square gets its corners back") {
    const double s = std::sin(0.3), c = std::cos(0.3);
    const Opacity mask = test::draw(200, 200, [&](double x, double y) {
        const double u = c * (x - 100) + s * (y - 100), v = c * (y - 100) - s * (x - 100);
        return std::abs(u) < 60 && std::abs(v) < 60;
    });
    const Card card = read(mask, 1000);
    CHECK(check_sound(card) == 1);
    CHECK(area(card.mesh) == doctest::Approx(14400).epsilon(1e-3));
    CHECK(card.report.outline == doctest::Approx(480).epsilon(3e-3));
}

TEST_CASE("card: leaves with teeth, tips and stems of a few pixels") {
    SUBCASE("maple") {
        const Card card = read(maple(512));
        CHECK(check_sound(card) == 1);
        CHECK(card.report.pieces == 1);
        CHECK(card.report.smallest_angle > 20.0);
        CHECK(card.mesh.faces.size() == doctest::Approx(2000).epsilon(0.15));
    }
    SUBCASE("stems") {
        for (const double width : {2.0, 3.0}) {
            const Opacity mask = test::draw(256, 256, [&](double x, double y) {
                const double u = (x - 128) / 60, v = (y - 90) / 80;
                return u * u + v * v < 1 ||
                       (y > 90 && y < 250 && std::abs(x - 128 - 0.002 * (y - 170) * (y - 170)) < width / 2);
            });
            const Card card = read(mask);
            CHECK(check_sound(card) == 1);
            CHECK(card.faults.empty());
            CHECK(card.report.smallest_angle > 20.0);
            CHECK(card.mesh.faces.size() == doctest::Approx(2000).epsilon(0.15));
            double low = 0.0;
            for (const Eigen::Vector3d& v : card.mesh.vertices) low = std::min(low, v.y());
            CHECK(low == doctest::Approx(128.0 - 250.0).epsilon(0.01)); // the stem keeps its length
        }
    }
    SUBCASE("serrated, with a hole") {
        const Opacity mask = test::draw(512, 512, [](double x, double y) {
            const double t = (y - 256) / 240, tooth = std::abs(std::remainder(y, 16.0)) / 8.0;
            return std::abs(t) < 1 && std::abs(x - 256) < 130 * (1 - t * t) * (1 + 0.1 * tooth) &&
                   std::hypot(x - 270, y - 240) > 25;
        });
        const Card card = read(mask, 3000);
        CHECK(check_sound(card) == 0);
        CHECK(card.report.smallest_angle > 15.0);
    }
}

TEST_CASE("card: touching corners are apart unless the pixels between them say otherwise") {
    Opacity board{40, 40, std::vector<double>(1600, 0.0)};
    for (std::size_t y = 0; y < 32; ++y)
        for (std::size_t x = 0; x < 32; ++x) board.at(x + 4, y + 4) = (x / 8 + y / 8) % 2 == 0 ? 1.0 : 0.0;
    CardOptions options = in_pixels(board, 2000);
    options.all_pieces = true;
    const Card apart = read(test::png_file(board), options);
    CHECK(check_sound(apart) == 8);
    CHECK(apart.report.pieces == 8);
    CHECK(count(apart.faults, FaultId::image_several_pieces, Severity::warning) == 1);

    for (double& v : board.value) v = 0.4 + 0.6 * v; // brighter between: the saddle is above the threshold
    const Card joined = read(test::png_file(board), options);
    check_sound(joined);
    CHECK(joined.report.pieces < 8);
}

TEST_CASE("card: of several pieces the largest is taken and the others are named") {
    const Opacity mask = test::draw(200, 100, [](double x, double y) {
        return std::hypot(x - 50, y - 50) < 30 || std::hypot(x - 140, y - 30) < 20 ||
               (std::abs(x - 150) < 12 && std::abs(y - 80) < 12) || std::hypot(x - 194.5, y - 94.5) < 1;
    });
    const std::string png = test::png_file(mask);
    CardOptions options = in_pixels(mask, 500);
    const Card largest = read(png, options);
    CHECK(check_sound(largest) == 1);
    CHECK(area(largest.mesh) == doctest::Approx(pi * 900).epsilon(5e-3));
    CHECK(centroid(largest.mesh).x() == doctest::Approx(-50).epsilon(0.01));
    REQUIRE(largest.faults.size() == 2);
    CHECK(largest.faults[0].id == FaultId::image_specks);
    CHECK(largest.faults[1].id == FaultId::image_several_pieces);
    CHECK(largest.faults[1].what.find("3 separate regions: 1 at 50,50 (60.") != std::string::npos);
    CHECK(largest.faults[1].what.find("2 at 140,30") != std::string::npos);
    CHECK(largest.faults[1].what.find("3 at 150,80") != std::string::npos);

    options.piece = 3;
    const Card third = read(png, options);
    CHECK(area(third.mesh) == doctest::Approx(576).epsilon(1e-9));
    CHECK(count(third.faults, FaultId::image_several_pieces, Severity::warning) == 0);
    options.piece = 4;
    const Card fourth = read(png, options);
    CHECK_FALSE(fourth.good);
    CHECK(count(fourth.faults, FaultId::parameter_unknown, Severity::error) == 1);
    options.piece.reset();
    options.all_pieces = true;
    const Card all = read(png, options);
    CHECK(check_sound(all) == 3);
    CHECK(area(all.mesh) == doctest::Approx(pi * 1300 + 576).epsilon(5e-3));
    options.all_pieces = false;
    options.speck = 0.0;
    CHECK(count(read(png, options).faults, FaultId::image_specks, Severity::warning) == 0);
}

TEST_CASE("card: pinholes are closed and reported") {
    Opacity mask = disc(128, 50);
    mask.at(60, 60) = mask.at(64, 70) = 0.0;
    const Card card = read(mask, 500);
    CHECK(check_sound(card) == 1);
    CHECK(count(card.faults, FaultId::image_specks, Severity::warning) == 1);
    // Each hole of a sieve is a pinhole, and all are a quarter of its area.
    const Opacity sieve = test::draw(192, 192, [](double x, double y) {
        return std::hypot(x - 96, y - 96) < 90 && (std::fmod(x, 8.0) > 4.0 || std::fmod(y, 8.0) > 4.0);
    });
    const double whole = std::accumulate(sieve.value.begin(), sieve.value.end(), 0.0);
    CHECK(read(sieve, 4000).report.area == doctest::Approx(whole).epsilon(0.03));
    CHECK(read(sieve, 2000).report.opaque.area ==
          doctest::Approx(whole).epsilon(0.03)); // frayed, and closed for the flow
    CardOptions closing = in_pixels(sieve, 2000);
    closing.speck = 0.002;
    CHECK(read(test::png_file(sieve), closing).report.area > 1.25 * whole);
    // The meshes of a net too fine for the triangles are closed.
    const Opacity net = test::draw(1000, 1000, [](double x, double y) {
        return std::hypot(x - 500, y - 500) < 480 && (std::fmod(x, 17.0) < 4.0 || std::fmod(y, 17.0) < 4.0);
    });
    const Card closed = read(net, 500);
    CHECK(check_sound(closed) == 1);
    CHECK(closed.report.area == doctest::Approx(pi * 480 * 480).epsilon(0.1));
    CHECK(count(closed.faults, FaultId::image_too_ragged, Severity::warning) == 1);
}

TEST_CASE("card: every kind of PNG gives the same mesh") {
    Opacity mask = disc(61, 24, 9);
    for (double& v : mask.value) v = std::round(v * 255) / 255;
    const Card first = read(mask, 300);
    CHECK(check_sound(first) == 0);
    const auto same = [&](const std::string& png, MaskChannel channel = MaskChannel::alpha) {
        CardOptions options = in_pixels(mask, 300);
        options.channel = channel;
        const Card other = read(png, options);
        REQUIRE(other.good);
        CHECK(other.mesh.vertices == first.mesh.vertices);
        CHECK(other.mesh.faces == first.mesh.faces);
    };
    for (const bool interlaced : {false, true})
        for (const int depth : {8, 16})
            for (const int color : {PNG_COLOR_TYPE_RGB_ALPHA, PNG_COLOR_TYPE_GRAY_ALPHA})
                same(test::png_file(mask, {color, depth, interlaced}));
    same(test::png_file(mask, {PNG_COLOR_TYPE_PALETTE, 8, false}));
    same(test::png_file(mask, {PNG_COLOR_TYPE_PALETTE, 8, true}));
    same(test::png_file(mask, {PNG_COLOR_TYPE_GRAY, 8, false}), MaskChannel::luminance);
    same(test::png_file(mask, {PNG_COLOR_TYPE_GRAY, 16, true}), MaskChannel::luminance);
    same(test::png_file(mask, {PNG_COLOR_TYPE_RGB, 8, false}), MaskChannel::luminance);
}

TEST_CASE("card: an image without an outline is refused, and why is said") {
    const Opacity mask = disc(64, 20);
    for (const int color : {PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_GRAY}) {
        const Card card = read(test::png_file(mask, {color}), in_pixels(mask));
        CHECK(only(card).id == FaultId::image_no_outline);
        CHECK(card.faults[0].what.find("no alpha channel") != std::string::npos);
    }
    const Card palette = read(test::png_file(mask, {PNG_COLOR_TYPE_PALETTE, 8, false, false}), in_pixels(mask));
    CHECK(only(palette).id == FaultId::image_no_outline);

    Opacity nearly{50, 50, std::vector<double>(2500, 1.0)};
    for (std::size_t i = 0; i < 2500; i += 3) nearly.value[i] = 254.0 / 255.0;
    CHECK(only(read(nearly)).what == "Every pixel is opaque: the lowest opacity is 0.996.");
    for (double& v : nearly.value) v = 1.0 - v;
    CHECK(only(read(nearly)).what == "No pixel is opaque: the highest opacity is 0.004.");
    CHECK(only(read(Opacity{1, 1, {1.0}})).id == FaultId::image_no_outline);
    CHECK(only(read(Opacity{1, 1, {0.0}})).id == FaultId::image_no_outline);
    CHECK(only(read(Opacity{1, 9, std::vector<double>(9, 1.0)})).id == FaultId::image_no_outline);
}

TEST_CASE("card: images of one row or column") {
    for (const bool tall : {false, true}) {
        Opacity line{tall ? 1U : 9U, tall ? 9U : 1U, {0, 1, 1, 1, 1, 1, 1, 0, 0}};
        const Card card = read(line, 100);
        CHECK(check_sound(card) == 1);
        CHECK(area(card.mesh) == doctest::Approx(6.0).epsilon(0.1));
        CHECK(card.report.smallest_angle > 20.0);
    }
}

TEST_CASE("card: options out of range") {
    const std::string png = test::png_file(disc(32, 10));
    const auto refused = [&](const std::function<void(CardOptions&)>& change) {
        CardOptions options;
        options.width = 0.1;
        change(options);
        const Card card = read(png, options);
        CHECK_FALSE(card.good);
        CHECK(only(card).id == FaultId::parameter_out_of_range);
    };
    refused([](CardOptions& o) { o.width = 0.0; });
    refused([](CardOptions& o) { o.width = -1.0; });
    refused([](CardOptions& o) { o.width = std::nan(""); });
    refused([](CardOptions& o) { o.alpha = 0.0; });
    refused([](CardOptions& o) { o.alpha = 1.0; });
    refused([](CardOptions& o) { o.triangles = 3; });
    refused([](CardOptions& o) { o.triangles = 10000000; });
    refused([](CardOptions& o) { o.speck = -0.1; });
}

TEST_CASE("card: the width and the threshold arrive") {
    // Opacity falls linearly with the distance from the centre: the outline at `alpha` is a circle of known radius.
    Opacity cone{200, 200, std::vector<double>(40000)};
    for (std::size_t y = 0; y < 200; ++y)
        for (std::size_t x = 0; x < 200; ++x)
            cone.at(x, y) =
                std::max(0.0, 1.0 - std::hypot(static_cast<double>(x) - 99.5, static_cast<double>(y) - 99.5) / 90);
    for (const double alpha : {0.25, 0.5, 0.8}) {
        CardOptions options;
        options.width = 0.05;
        options.alpha = alpha;
        const Card card = read(test::png_file(cone, {PNG_COLOR_TYPE_GRAY_ALPHA, 16}), options);
        CHECK(check_sound(card) == 1);
        const double radius = (1.0 - alpha) * 90 * 0.05 / 200;
        CHECK(area(card.mesh) == doctest::Approx(pi * radius * radius).epsilon(1e-3)); // 18 to 67 pixels
    }
}

TEST_CASE("card: damaged files are refused by number") {
    const std::string png = test::png_file(disc(40, 15));
    const CardOptions options = in_pixels(disc(40, 15), 100);
    for (std::size_t size = 0; size + 1 < png.size(); size += 1 + size / 40) {
        const Card card = read(png.substr(0, size), options);
        CHECK_FALSE(card.good);
        CHECK(only(card).id == FaultId::image_unreadable);
    }
    std::mt19937 random(5);
    for (int i = 0; i < 200; ++i) { // every chunk has a checksum
        std::string damaged = png;
        damaged[8 + random() % (png.size() - 8)] ^= static_cast<char>(1 + random() % 255);
        CHECK_FALSE(read(damaged, options).good);
    }
    std::string huge = png;
    huge[16] = 0x7f;
    CHECK(only(read(huge, options)).id == FaultId::image_unreadable);
    CHECK(only(read("GIF89a and more", options)).id == FaultId::image_unreadable);
    const Card placeholder = read("version https://git-lfs.github.com/spec/v1\noid sha256:0\n", options);
    CHECK(only(placeholder).what.find("Git LFS") != std::string::npos);

    const test::Scratch scratch;
    Card card;
    CHECK_FALSE(read_card(scratch.path("none.png"), options, card.mesh, card.report, card.faults));
    CHECK(only(card).id == FaultId::file_not_found);
    card.faults.clear();
    REQUIRE(read_card(scratch.write("my leaf.png", png), options, card.mesh, card.report, card.faults));
    CHECK(card.mesh.name == "my leaf");
}

TEST_CASE("card: any mask gives a sound mesh") {
    std::mt19937 random(11);
    for (int i = 0; i < 40; ++i) {
        Opacity mask{2 + random() % 60, 2 + random() % 60, {}};
        for (std::size_t k = 0; k < mask.width * mask.height; ++k)
            mask.value.push_back(static_cast<double>(random() % 256) / 255.0);
        for (int pass = 0; pass < i % 5; ++pass) // from noise to blobs
            for (std::size_t k = 0; k + 1 < mask.value.size(); ++k)
                mask.value[k] =
                    (mask.value[k] + mask.value[k + 1] + mask.value[(k + mask.width) % mask.value.size()]) / 3;
        if (i % 3 == 0)
            for (double& v : mask.value) v = v > 0.5;
        CardOptions options = in_pixels(mask, 100 + 40 * static_cast<std::size_t>(i));
        options.all_pieces = i % 2 == 0;
        const Card card = read(test::png_file(mask), options);
        if (!card.good) {
            CHECK(only(card).id == FaultId::image_no_outline);
            continue;
        }
        check_sound(card);
        CHECK(card.report.smallest_angle > 0.1);
    }
}

TEST_CASE("card: the same bytes give the same bits") {
    const std::string png = test::png_file(maple(200));
    CardOptions options;
    options.width = 0.1;
    const Card a = read(png, options), b = read(png, options);
    CHECK(a.mesh.vertices == b.mesh.vertices);
    CHECK(a.mesh.faces == b.mesh.faces);
}

TEST_CASE("lr_bake card: a disc has the added mass of a disc") {
    const test::Scratch scratch;
    const std::string image = scratch.write("disc.png", test::png_file(disc(256, 100)));
    const std::string out = scratch.path("disc.lrb"), report = scratch.path("r.json");
    const auto bake = [&](std::vector<std::string> more) {
        std::vector<std::string> all{"card", image, "-o", out, "--report", report, "--quiet"};
        all.insert(all.end(), more.begin(), more.end());
        return test::run(LR_BAKE_PATH, all);
    };
    const test::Outcome baked =
        bake({"--width", "5.12", "--unit", "cm", "--thickness", "0.01", "--areal-density", "0.07"});
    CHECK(baked.exit_code == 0);
    CHECK(baked.err.empty());
    const test::Json j = test::Json::parse(scratch.read("r.json"));
    const double a = 0.02, rho = j["fluid"]["density"].number();
    CHECK(j["mass"].number() == doctest::Approx(0.07 * pi * a * a).epsilon(1e-3));
    CHECK(j["added_mass"][14].number() == doctest::Approx(rho * 8.0 / 3.0 * a * a * a).epsilon(0.005));
    CHECK(j["added_mass"][21].number() == doctest::Approx(rho * 16.0 / 45.0 * std::pow(a, 5)).epsilon(0.01));
    CHECK(j["diagonal"] == true);
    CHECK(j["provenance"]["source"] == "disc.png");
    CHECK(j["provenance"]["options"].text().starts_with(
        "card --unit cm --width 5.12 --alpha 0.5 --triangles 2000 --speck 0.001 --thickness 0.01 --areal-density "
        "0.07"));
    CHECK(j["faults"].empty());
    const std::string bytes = scratch.read("disc.lrb");
    CHECK(bake({"--width", "5.12", "--unit", "cm", "--thickness", "0.01", "--areal-density", "0.07"}).exit_code == 0);
    CHECK(scratch.read("disc.lrb") == bytes);

    for (const std::vector<std::string>& usage :
         std::vector<std::vector<std::string>>{{"--width", "1"},
                                               {"--thickness", "1e-4"},
                                               {"--width", "wide", "--thickness", "1e-4"},
                                               {"--width", "1", "--thickness", "1e-4", "--unit", "file"},
                                               {"--width", "1", "--thickness", "1e-4", "--key", "red"},
                                               {"--width", "1", "--thickness", "1e-4", "--piece", "two"},
                                               {"--width", "1", "--thickness", "1e-4", "--triangles", "-5"},
                                               {"--width", "1", "--thickness", "1e-4", "--sheet"}})
        CHECK(bake(usage).exit_code == 2);
    const test::Outcome piece = bake({"--width", "0.05", "--thickness", "1e-4", "--piece", "2"});
    CHECK(piece.exit_code == 1);
    CHECK(piece.err.find("error 302 at piece") != std::string::npos);
    CHECK(scratch.read("disc.lrb") == bytes);

    Opacity opaque{8, 8, std::vector<double>(64, 1.0)};
    scratch.write("disc.png", test::png_file(opaque));
    const test::Outcome refused = bake({"--width", "0.05", "--thickness", "1e-4"});
    CHECK(refused.exit_code == 1);
    CHECK(refused.err.find(image + ": error 222") != std::string::npos);
}

TEST_CASE("card: pieces far apart add up") {
    // Distant bodies do not interact: two discs in a card have twice the broadside added mass of one.
    const test::Scratch scratch;
    const auto bake_card = [&](const Opacity& mask, bool all) {
        BakeOptions options;
        options.mesh_path = scratch.write("card.png", test::png_file(mask));
        options.sheet = SheetOptions{1e-4, 0.1};
        options.card = in_pixels(mask, 1000);
        options.card->width *= 0.001;
        options.card->all_pieces = all;
        AssetData asset;
        Faults faults;
        REQUIRE(lr::baker::bake(options, asset, faults));
        return asset;
    };
    const auto discs = [](bool second) {
        return test::draw(400, 60, [=](double x, double y) {
            return std::hypot(x - 25, y - 30) < 20 || (second && std::hypot(x - 375, y - 30) < 20);
        });
    };
    const AssetData one = bake_card(discs(false), false), both = bake_card(discs(true), true);
    CHECK(both.mass == doctest::Approx(2 * one.mass).epsilon(1e-3));
    CHECK(both.added_mass[14] == doctest::Approx(2 * one.added_mass[14]).epsilon(5e-3));
    CHECK(one.center_of_mass[0] == doctest::Approx(-0.175).epsilon(1e-3));
    CHECK(std::abs(both.center_of_mass[0]) < 1e-5);
}

TEST_CASE("card: the colour around a leaf stands in for transparency") {
    // A dark disc on white, without an alpha channel.
    Opacity white = disc(64, 24.0);
    for (double& v : white.value) v = 1.0 - v;
    test::PngKind grey;
    grey.color = PNG_COLOR_TYPE_GRAY;
    const std::string png = test::png_file(white, grey);
    CardOptions options = in_pixels(white, 500);
    const Card refused = read(png, options);
    CHECK_FALSE(refused.good);
    CHECK(only(refused).id == FaultId::image_no_outline);
    CHECK(only(refused).remedy.find("--key white") != std::string::npos);
    options.channel = MaskChannel::key;
    options.key = {255, 255, 255};
    const Card card = read(png, options);
    check_sound(card);
    CHECK(card.report.area == doctest::Approx(pi * 24.0 * 24.0).epsilon(0.03));
}

TEST_CASE("card: regions of an atlas are counted as --piece numbers them") {
    const Opacity two = test::draw(
        64, 32, [](double x, double y) { return std::hypot(x - 16, y - 16) < 10 || std::hypot(x - 46, y - 16) < 12; });
    const std::string png = test::png_file(two);
    Faults faults;
    CHECK(count_card_pieces(png.data(), png.size(), in_pixels(two), "atlas.png", faults) == 2);
    CHECK(faults.empty());
    CHECK(count_card_pieces("no image", 8, in_pixels(two), "atlas.png", faults) == 0);
    CHECK(has_error(faults));
}
