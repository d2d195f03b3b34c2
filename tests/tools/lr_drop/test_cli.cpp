// lr_drop for users: exit codes, streams, files.
#include "baker/json.h"
#include "baker/scratch.h"

#include <doctest/doctest.h>

#include <png.h>

using namespace lr;
using test::Outcome;
using test::Scratch;

namespace {

Outcome lr_drop(const std::vector<std::string>& arguments, const test::RunOptions& options = {}) {
    return test::run(LR_DROP_PATH, arguments, options);
}

std::string bake(const Scratch& scratch, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"ellipsoid", "4",   "2",      "0.02",  "--unit", "cm",
                                       "--density", "400", "--name", "blade", "-o",     scratch.path("blade.lrb"),
                                       "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    REQUIRE(test::run(LR_BAKE_PATH, arguments).exit_code == 0);
    return scratch.path("blade.lrb");
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

uint32_t big_endian(const std::string& bytes, size_t at) {
    uint32_t value = 0;
    for (size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
}
} // namespace

TEST_CASE("lr_drop: text, JSON and picture of a drop") {
    const Scratch scratch;
    const std::string asset = bake(scratch);
    const std::vector<std::string> arguments{asset,
                                             "--release",
                                             "flat",
                                             "--height",
                                             "2",
                                             "--count",
                                             "80",
                                             "--wind",
                                             "1,0,0",
                                             "--json",
                                             scratch.path("out.json"),
                                             "--png",
                                             scratch.path("paths.png")};
    const Outcome outcome = lr_drop(arguments);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err.empty());
    CHECK(contains(outcome.out, "80 falls of blade from 2 m, released flat, wind 1,0,0 m/s\n"));
    for (const char* row :
         {"summary ", "terminal speed ", "regime ", "spin ", "horizontal ", "drift ", "landings ", "time of fall "})
        CHECK_MESSAGE(contains(outcome.out, std::string("\n  ") + row), row);

    const test::Json j = test::Json::parse(scratch.read("out.json"));
    CHECK(j["asset"] == "blade");
    CHECK(j["release"] == "flat");
    CHECK(j["count"] == 80);
    CHECK(j["arrived"] == 80);
    CHECK(j["fluid_density"] == 1.2);
    CHECK(contains(outcome.out, std::string("summary         falls ")));
    const double speed = j["terminal_speed"]["mean"].number(), time = j["time_of_fall"]["mean"].number();
    CHECK(speed > 0.0);
    CHECK(j["terminal_speed"]["p5"].number() < speed);
    CHECK(j["terminal_speed"]["p95"].number() > speed);
    CHECK(time > 2.0 / (2.0 * speed));
    CHECK(time < 2.0 * 2.0 / speed);
    CHECK(j["drift"]["x"].number() > 0.5 * time);
    double shares = 0.0;
    for (const char* motion : {"steady", "fluttering", "tumbling", "spinning", "gliding", "chaotic"})
        shares += j["regime"]["shares"][motion].number();
    CHECK(shares == doctest::Approx(1.0));

    const std::string png = scratch.read("paths.png");
    REQUIRE(png.size() > 5000);
    CHECK(png.substr(0, 8) == "\x89PNG\r\n\x1a\n");
    CHECK(big_endian(png, 16) == 2000);
    CHECK(png.substr(png.size() - 8, 4) == "IEND");
    const Outcome again = lr_drop(arguments);
    CHECK(again.out == outcome.out);
    CHECK(scratch.read("paths.png") == png);
    std::vector<std::string> quiet = arguments;
    quiet.push_back("--quiet");
    quiet.push_back("--seed");
    quiet.push_back("5");
    const Outcome other = lr_drop(quiet);
    CHECK(other.out.empty());
    CHECK(other.err.empty());
    CHECK(scratch.read("paths.png") != png);
}

TEST_CASE("lr_drop: pictures of one body, of one that floats, and of one that rises") {
    const Scratch scratch;
    const std::string png = scratch.path("p.png");
    const std::string asset = bake(scratch);
    for (const char* fluid : {"air", "400,1e-6", "water"}) {
        std::filesystem::remove(png);
        const Outcome outcome =
            lr_drop({asset, "--count", "1", "--height", "0.2", "--fluid", fluid, "--turbulence", "0.1", "--png", png});
        CAPTURE(fluid);
        CHECK(outcome.exit_code == 0);
        CHECK(contains(outcome.out, "1 fall of blade"));
        CHECK(scratch.has("p.png"));
    }
    CHECK(contains(lr_drop({asset, "--fluid", "water", "--count", "8"}).out, "m/s upward"));
    CHECK(contains(lr_drop({asset, "--fluid", "400,1e-6", "--count", "2"}).out, "2 did not arrive"));
    CHECK(contains(lr_drop({asset, "--height", "0.1", "--count", "20"}).out, "not settled: half of the bodies at "));
    CHECK(contains(lr_drop({asset, "--height", "0.001", "--count", "20"}).out, "not settled: the fall lasts only"));
}

TEST_CASE("lr_drop: falls stay out of the picture's right column, and the heading within the picture") {
    const Scratch scratch;
    const std::string asset = bake(scratch);
    const std::vector<std::string> arguments{asset,
                                             "--height",
                                             "0.5",
                                             "--wind",
                                             "12.3456789,-0.5123456,3.3123456",
                                             "--turbulence",
                                             "2.5",
                                             "--fluid",
                                             "1.23456789,1.5e-5",
                                             "--png",
                                             scratch.path("p.png")};
    REQUIRE(lr_drop(arguments).exit_code == 0);
    const std::string png = scratch.read("p.png");
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    REQUIRE(png_image_begin_read_from_memory(&image, png.data(), png.size()));
    image.format = PNG_FORMAT_GRAY;
    std::vector<uint8_t> grey(PNG_IMAGE_SIZE(image));
    REQUIRE(png_image_finish_read(&image, nullptr, grey.data(), 0, nullptr));
    const auto marks = [&](uint32_t left, uint32_t right, uint32_t top, uint32_t bottom) {
        int count = 0;
        for (uint32_t y = top; y < bottom; ++y)
            for (uint32_t x = left; x < right; ++x) count += grey[size_t{y} * image.width + x] < 230;
        return count;
    };
    CHECK(marks(100, 1400, 120, 1150) > 1000);
    CHECK(marks(1459, 1463, 90, 1200) == 0); // before the column
    CHECK(marks(1970, 2000, 0, 60) == 0);    // behind the heading
}

TEST_CASE("lr_drop: help and version are no errors, wrong usage is 2") {
    CHECK(lr_drop({"--help"}).exit_code == 0);
    CHECK(contains(lr_drop({"--version"}).out, "lr_drop "));
    const Scratch scratch;
    const std::string asset = bake(scratch);
    for (const std::vector<std::string>& bad : std::vector<std::vector<std::string>>{{},
                                                                                     {asset, asset},
                                                                                     {asset, "--release", "sideways"},
                                                                                     {asset, "--height", "tall"},
                                                                                     {asset, "--height", "1m"},
                                                                                     {asset, "--height", ""},
                                                                                     {asset, "--count", "1.5"},
                                                                                     {asset, "--count", "-3"},
                                                                                     {asset, "--wind", "1,2"},
                                                                                     {asset, "--wind", "1"},
                                                                                     {asset, "--turbulence", "some"},
                                                                                     {asset, "--fluid", "oil"},
                                                                                     {asset, "--seed", "-1"},
                                                                                     {asset, "--step", "1/x"},
                                                                                     {asset, "--step", ""},
                                                                                     {asset, "--png", ""},
                                                                                     {asset, "--png"},
                                                                                     {asset, "--png", "x.jpg"},
                                                                                     {asset, "--unknown"}}) {
        const Outcome outcome = lr_drop(bad);
        CAPTURE(outcome.err);
        CHECK(outcome.exit_code == 2);
        CHECK(outcome.out.empty());
        CHECK_FALSE(outcome.err.empty());
    }
}

TEST_CASE("lr_drop: bad files and numbers are numbered faults") {
    const Scratch scratch;
    const std::string asset = bake(scratch);
    const auto fault = [](const std::vector<std::string>& arguments, const std::string& at, int number) {
        const Outcome outcome = lr_drop(arguments);
        INFO(outcome.err);
        CHECK(outcome.exit_code == 1);
        CHECK(outcome.out.empty());
        CHECK(contains(outcome.err, at + ": error " + std::to_string(number)));
    };
    fault({scratch.path("none.lrb")}, scratch.path("none.lrb"), 101);
    fault({scratch.path("")}, scratch.path(""), 102);
    fault({scratch.write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n")}, scratch.path("mesh.obj"), 402);
    std::string bytes = scratch.read("blade.lrb");
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    fault({scratch.write("damaged.lrb", bytes)}, scratch.path("damaged.lrb"), 405);
    for (const char* number : {"0", "-1", "nan", "inf", "1e9"}) fault({asset, "--height", number}, "lr_drop", 301);
    for (const char* number : {"0", "4000000000"}) fault({asset, "--count", number}, "lr_drop", 301);
    for (const char* number : {"0", "-1/60", "1/0", "1", "nan"}) fault({asset, "--step", number}, "lr_drop", 301);
    for (const char* numbers : {"0,0", "0,1e-5", "1.2,0", "nan,nan"})
        fault({asset, "--fluid", numbers}, "lr_drop", 301);
    fault({asset, "--wind", "0,2000,0"}, "lr_drop", 301);
    fault({asset, "--turbulence", "-1"}, "lr_drop", 301);

    const std::vector<std::string> before = scratch.names();
    for (const char* option : {"--png", "--json"}) {
        fault({asset, option, scratch.path("none/out")}, scratch.path("none/out"), 103);
        fault({asset, "--count", "1", option, "/dev/full"}, "/dev/full", 103);
    }
    fault({asset, "--json", asset}, asset, 301);
    fault({asset, "--png", scratch.path("x"), "--json", scratch.path("x")}, asset, 301);
    test::RunOptions full;
    full.standard_output = "/dev/full";
    CHECK(lr_drop({asset, "--count", "1"}, full).exit_code == 1);
    CHECK(scratch.names() == before);
    CHECK(lr_drop({asset, "--count", "1", "--png", "/dev/null", "--json", "/dev/null", "--quiet"}).exit_code == 0);
}
