// Cards with gaps too narrow for the mesh: closed for the flow, and no weight is added.
#include "baker/bake.h"
#include "cards.h"
#include "scratch.h"

#include <tuple>

using namespace lr;
using namespace lr::baker;
using namespace lr::test;

TEST_CASE("card: gaps of an outline that the triangles cannot follow are closed") {
    // A comb of teeth of one pixel, around a square.
    Opacity comb{160, 160, std::vector<double>(160 * 160, 0.0)};
    for (std::size_t y = 20; y < 140; ++y)
        for (std::size_t x = 20; x < 140; ++x)
            comb.at(x, y) = (x >= 60 && x < 100 && y >= 60 && y < 100) || (y % 3 == 0 && y >= 60 && y < 100) ||
                            (x % 3 == 0 && x >= 60 && x < 100);
    const Card card = read(comb, 100);
    check_sound(card);
    CHECK(count(card.faults, FaultId::image_too_ragged, Severity::warning) >= 1);
    CHECK(card.mesh.faces.size() < 400);
    CHECK(card.report.area == doctest::Approx(120 * 40 + 2 * 40 * 40).epsilon(0.05));
    // Half of a square is full, the other has stripes with gaps that are closed: it is known how far the surface of the flow is off.
    const Opacity half = test::draw(400, 400, [](double x, double y) {
        return x > 100 && x < 300 && y > 100 && y < 300 && (x < 200 || x > 298 || std::fmod(y, 4.0) < 1.0);
    });
    const Card uneven = read(half, 60);
    check_sound(uneven);
    CHECK(count(uneven.faults, FaultId::image_too_ragged, Severity::warning) >= 1);
    const Eigen::Vector2d off = uneven.report.off_centre;
    CHECK(off.norm() > 20.0); // of 200
    CHECK((centroid(uneven.mesh).head<2>() + off - pixel_sums(half).centre.head<2>()).norm() < 0.1);
}

// A stem, and barbs that rise from it, shorter towards the tip. With width = pitch: their envelope.
Opacity fern(std::size_t size, double pitch, double width) {
    const auto side = static_cast<double>(size);
    return test::draw(
        size, size,
        [=](double x, double y) {
            const double reach = std::abs(x - 0.5 * side), root = y + 0.5 * reach, t = root / side;
            return t > 0.1 && t < 0.97 &&
                   (reach < 0.01 * side || (reach < 0.45 * side * t && std::fmod(root, pitch) < width));
        },
        4);
}

TEST_CASE("card: a fern with closed gaps keeps the extent of its barbs") {
    for (const auto& [size, pitch, width, triangles] :
         {std::tuple{600U, 24.0, 9.0, 300U}, {600U, 6.0, 2.0, 1000U}, {1000U, 5.0, 2.5, 2000U}}) {
        const Card card = read(fern(size, pitch, width), triangles);
        check_sound(card);
        CHECK(count(card.faults, FaultId::image_too_ragged, Severity::warning) == 1);
        const PixelSums envelope = pixel_sums(fern(size, 1.0, 1.0));
        PixelSums flow;
        Eigen::AlignedBox3d box;
        for (const Face& f : card.mesh.faces) {
            const Eigen::Vector3d &a = card.mesh.vertices[f[0]], &b = card.mesh.vertices[f[1]],
                                  &c = card.mesh.vertices[f[2]], sum = a + b + c;
            const double part = 0.5 * (b - a).cross(c - a).z();
            flow.area += part;
            flow.centre += part / 3.0 * sum;
            flow.spread += part / 12.0 * (a.cwiseAbs2() + b.cwiseAbs2() + c.cwiseAbs2() + sum.cwiseAbs2());
            for (const Eigen::Vector3d& p : {a, b, c}) box.extend(p);
        }
        flow.centre /= flow.area;
        flow.spread -= flow.area * flow.centre.cwiseAbs2();
        CHECK(std::abs(flow.area / envelope.area - 1.0) < 0.1);
        for (Eigen::Index k = 0; k < 2; ++k) CHECK(std::abs(flow.spread[k] / envelope.spread[k] - 1.0) < 0.15);
        CHECK(box.sizes().x() > 0.84 * static_cast<double>(size)); // of 0.87
        CHECK(box.sizes().y() > 0.82 * static_cast<double>(size));
    }
}

TEST_CASE("card: the error of the added mass covers closed gaps") {
    // A coarse fern as it is, and with its gaps closed.
    const Opacity image = fern(256, 24.0, 8.0);
    const test::Scratch scratch;
    BakeOptions options;
    options.mesh_path = scratch.write("card.png", test::png_file(image));
    options.sheet = SheetOptions{1e-4, 0.1};
    options.stations = 1;
    AssetData open, closed;
    for (const bool finely : {true, false}) {
        options.card = in_pixels(image, finely ? 1500 : 60);
        options.card->width = 0.07;
        Faults faults;
        REQUIRE(lr::baker::bake(options, finely ? open : closed, faults));
        CHECK(count(faults, FaultId::image_too_ragged, Severity::warning) == (finely ? 0 : 1));
    }
    for (const std::size_t i : {14U, 21U, 28U}) {
        CHECK(closed.added_mass[i] > 5.0 * open.added_mass[i]);
        CHECK(closed.added_mass[i] - open.added_mass[i] < closed.added_mass_error[i]);
    }
    // The hull stays where the barbs are.
    Eigen::AlignedBox3d hull;
    const std::vector<float>& v = closed.hull.vertices;
    for (std::size_t i = 0; i + 2 < v.size(); i += 3) hull.extend(Eigen::Vector3d(v[i], v[i + 1], v[i + 2]));
    CHECK(std::abs(hull.center().x() + closed.center_of_mass[0]) < 5e-4);
    CHECK(hull.sizes().x() > 0.057);
    CHECK(std::abs(hull.max().y() + closed.center_of_mass[1] - (0.5 - 0.0775) * 0.07) < 5e-4);
}

TEST_CASE("card: weight lies where the image is opaque, whatever the mesh leaves out") {
    // A net whose meshes are closed for the flow.
    const Opacity net = test::draw(
        1000, 900,
        [](double x, double y) {
            return std::hypot(x - 480, y - 440) < 430 && (std::fmod(x, 17.0) < 4.0 || std::fmod(y, 17.0) < 4.0);
        },
        2);
    // A second region, and a speck, are no part of the first.
    Opacity two = fern(500, 5.0, 2.0);
    for (std::size_t y = 20; y < 60; ++y)
        for (std::size_t x = 20; x < 60; ++x) two.at(x, y) = 1.0;
    two.at(480, 10) = 1.0;
    Opacity alone = two;
    for (std::size_t y = 0; y < 60; ++y)
        for (std::size_t x = 0; x < 60; ++x) alone.at(x, y) = 0.0;
    alone.at(480, 10) = 0.0;
    const test::Scratch scratch;
    for (const auto& [image, region] : {std::pair{fern(600, 6.0, 3.0), fern(600, 6.0, 3.0)},
                                        {fern(1200, 5.0, 2.5), fern(1200, 5.0, 2.5)},
                                        {net, net},
                                        {two, alone}}) {
        const PixelSums pixels = pixel_sums(region);
        BakeOptions options;
        options.mesh_path = scratch.write("card.png", test::png_file(image));
        options.sheet = SheetOptions{1e-4, 0.1};
        options.card = in_pixels(image, 300);
        options.card->width = 0.07;
        options.stations = 1;
        const double pixel = 0.07 / static_cast<double>(image.width);
        AssetData asset;
        Faults faults;
        REQUIRE(lr::baker::bake(options, asset, faults));
        CHECK(std::abs(asset.mass / (0.1 * pixels.area * pixel * pixel) - 1.0) < 0.005);
        CHECK(std::abs(asset.volume * asset.density / asset.mass - 1.0) < 1e-12);
        for (Eigen::Index k = 0; k < 2; ++k) {
            const auto i = static_cast<std::size_t>(k);
            CHECK(std::abs(asset.center_of_mass[i] - pixel * pixels.centre[k]) < 5e-5);
            CHECK(std::abs(asset.center_of_buoyancy[i]) < 1e-12);
            CHECK(std::abs(asset.inertia[4 - 4 * i] / (0.1 * pixels.spread[k] * std::pow(pixel, 4)) - 1.0) < 0.01);
            // No load acts beside the centre of mass for want of the details.
            CHECK(std::abs(asset.aerodynamics.center[i]) < 2e-4);
        }
    }
    // Who asks for holes to be closed has a closed leaf.
    CardOptions closing = in_pixels(net, 300);
    closing.speck = 0.002;
    CHECK(read(test::png_file(net), closing).report.opaque.area > 1.5 * pixel_sums(net).area);
}
