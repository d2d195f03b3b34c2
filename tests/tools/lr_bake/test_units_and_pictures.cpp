// --size, --islands, --mask FILE and --preview.
#include "baker/json.h"
#include "baker/mesh_shapes.h"
#include "baker/png_files.h"
#include "baker/scratch.h"

#include <doctest/doctest.h>

#include <filesystem>

using namespace lr;
using test::Outcome;
using test::Scratch;

namespace {

Outcome lr_bake(std::vector<std::string> arguments) {
    return test::run(LR_BAKE_PATH, arguments);
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

double mass_of(const std::string& asset) {
    return test::Json::parse(lr_bake({"info", asset, "--json"}).out)["mass"].number();
}

} // namespace

TEST_CASE("lr_bake: open parts take --thickness with a unit of its own") {
    const Scratch scratch;
    const std::string mesh = scratch.write("open.obj", "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nf 1 2 3\n");
    const std::string a = scratch.path("a.lrb"), b = scratch.path("b.lrb");
    REQUIRE(lr_bake({"mesh", mesh, "-o", a, "--thickness", "0.2mm"}).exit_code == 0);
    REQUIRE(lr_bake({"mesh", mesh, "-o", b, "--thickness", "0.0002"}).exit_code == 0);
    CHECK(mass_of(a) == doctest::Approx(mass_of(b)));
}

TEST_CASE("lr_bake: --size gives a mesh its length, whatever its unit") {
    const Scratch scratch;
    const std::string mesh = scratch.write("body.obj", test::obj_text(test::ellipsoid(30.0, 24.0, 18.0, 2)));
    const std::string a = scratch.path("a.lrb"), b = scratch.path("b.lrb"), c = scratch.path("c.lrb");
    const Outcome plain = lr_bake({"mesh", mesh, "-o", a});
    REQUIRE(plain.exit_code == 0);
    CHECK(contains(plain.err, "warning 304"));
    CHECK(contains(plain.err, "--size 60cm if it was modelled in centimetres"));
    const Outcome sized = lr_bake({"mesh", mesh, "-o", b, "--size", "6cm"});
    REQUIRE(sized.exit_code == 0);
    CHECK_FALSE(contains(sized.err, "304"));
    REQUIRE(lr_bake({"mesh", mesh, "-o", c, "--unit", "mm"}).exit_code == 0);
    CHECK(mass_of(b) == doctest::Approx(mass_of(c)).epsilon(1e-6));
    CHECK(mass_of(a) == doctest::Approx(1e9 * mass_of(c)).epsilon(1e-6));
    for (const char* wrong : {"7 inches", "cm", "", "7,5cm"})
        CHECK(lr_bake({"mesh", mesh, "-o", b, "--size", wrong}).exit_code == 2);
    CHECK(lr_bake({"mesh", mesh, "-o", b, "--size", "0cm"}).exit_code == 1);
}

TEST_CASE("lr_bake: --fill takes a body without its base as solid") {
    const Scratch scratch;
    const std::string mesh =
        scratch.write("rock.obj", "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\nf 1 4 3\nf 1 2 4\nf 2 3 4\n");
    const std::string out = scratch.path("rock.lrb");
    REQUIRE(contains(lr_bake({"mesh", mesh, "-o", out}).err, "give --fill"));
    REQUIRE(lr_bake({"mesh", mesh, "-o", out, "--fill"}).exit_code == 0);
    CHECK(mass_of(out) == doctest::Approx(800.0 * 0.001 / 6.0));
    CHECK(contains(lr_bake({"info", out, "--json"}).out, " --fill"));
    CHECK(lr_bake({"mesh", mesh, "-o", out, "--fill", "--sheet"}).exit_code == 2);
}

TEST_CASE("lr_bake: the speed of fall in warning 304 is near that of the drop") {
    const Scratch scratch;
    std::string stack; // of twelve sheets: they weigh twelve times as much as one, and have its drag
    for (int i = 0; i < 12; ++i)
        for (const char* corner : {"0 0 ", "3 0 ", "3 3 ", "0 3 "})
            stack += "v " + (corner + std::to_string(0.2 * i)) + "\n";
    for (int i = 0; i < 12; ++i)
        stack += "f -" + std::to_string(4 * i + 4) + " -" + std::to_string(4 * i + 3) + " -" +
                 std::to_string(4 * i + 2) + " -" + std::to_string(4 * i + 1) + "\n";
    const Outcome baked =
        lr_bake({"mesh", scratch.write("stack.obj", stack), "-o", scratch.path("s.lrb"), "--stations", "1"});
    REQUIRE(baked.exit_code == 0);
    const auto speed = [](const std::string& text) {
        return std::stod(text.substr(text.find("falls at about ") + 15));
    };
    REQUIRE(contains(baked.err, "falls at about "));
    REQUIRE(contains(baked.out, "falls at about "));
    CHECK(speed(baked.err) > 0.6 * speed(baked.out));
    CHECK(speed(baked.err) < 1.6 * speed(baked.out));
}

TEST_CASE("lr_bake: every leaf of an atlas by itself, from a mask in a file of its own") {
    const Scratch scratch;
    const test::Opacity two = test::draw(
        64, 32, [](double x, double y) { return std::hypot(x - 16, y - 16) < 10 || std::hypot(x - 46, y - 16) < 12; });
    test::PngKind grey;
    grey.color = PNG_COLOR_TYPE_GRAY;
    const std::string image = scratch.write("atlas.png", test::png_file(two, grey));
    const std::string mask = scratch.write("mask.png", test::png_file(two, grey));
    const std::string out = scratch.path("leaf.lrb");
    const Outcome baked = lr_bake({"card", image, "--mask", mask, "--width", "8cm", "--thickness", "0.2mm", "--islands",
                                   "-o", out, "--triangles", "100", "--stations", "1"});
    INFO(baked.err);
    CHECK(baked.exit_code == 0);
    CHECK(contains(baked.out, "2 baked"));
    const double large = mass_of(scratch.path("leaf_1.lrb")), small = mass_of(scratch.path("leaf_2.lrb"));
    CHECK(large / small == doctest::Approx(1.44).epsilon(0.02));
    CHECK_FALSE(std::filesystem::exists(out));
}

TEST_CASE(
    "lr_bake: cards and ellipsoids too are asked whether their unit is right, and messages name file and option") {
    const Scratch scratch;
    const std::string out = scratch.path("leaf.lrb");
    const auto error = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"-o", out, "--stations", "1"});
        return lr_bake(arguments).err;
    };
    const test::Opacity disc = test::draw(64, 64, [](double x, double y) { return std::hypot(x - 32, y - 32) < 30; });
    test::PngKind grey;
    grey.color = PNG_COLOR_TYPE_GRAY;
    const std::string image = scratch.write("leaf.png", test::png_file(disc));
    const std::string mask = scratch.write("mask.png", test::png_file({8, 8, std::vector<double>(64, 0.0)}, grey));
    CHECK(contains(error({"card", image, "--thickness", "0.2mm", "--width", "8"}), "Give --width 8cm if"));
    CHECK_FALSE(contains(error({"card", image, "--thickness", "0.2mm", "--width", "8cm"}), "304"));
    CHECK(contains(error({"card", image, "--thickness", "0.2mm", "--width", "8in"}), "'8in' is not a length, as "));
    CHECK(
        contains(error({"card", image, "--thickness", "1mm", "--width", "8cm", "--mask", mask}), "mask.png: No pixel"));
    CHECK(contains(error({"ellipsoid", "4", "1", "0.005"}), "Give --unit cm if"));
    CHECK(contains(error({"mesh", image, "--unit", "inch"}), "--unit: 'inch' is not m, cm, mm or file"));
}

TEST_CASE("lr_bake: --preview draws a picture") {
    const Scratch scratch;
    const std::string mesh = scratch.write("body.obj", test::obj_text(test::ellipsoid(0.03, 0.024, 0.004, 2)));
    const Outcome baked =
        lr_bake({"mesh", mesh, "-o", scratch.path("a.lrb"), "--preview", scratch.path("a.png"), "--stations", "1"});
    INFO(baked.err);
    REQUIRE(baked.exit_code == 0);
    const std::string png = scratch.read("a.png");
    CHECK(png.size() > 20000); // a blank picture has less
    CHECK(png.substr(1, 3) == "PNG");
    const std::string picture = scratch.path("a.png");
    const Outcome over = lr_bake(
        {"card", picture, "-o", scratch.path("b.lrb"), "--width", "8cm", "--thickness", "0.2mm", "--preview", picture});
    CHECK((over.exit_code == 1 && contains(over.err, "overwrite")));
    const Outcome jpg = lr_bake({"mesh", mesh, "-o", scratch.path("a.lrb"), "--preview", scratch.path("a.jpg")});
    CHECK((jpg.exit_code == 2 && contains(jpg.err, "must end in .png")));
}
