// The pictures: well-formed, complete, inside their frame, reproducible, and of the right size.
#include "baker/bake.h"
#include "baker/mesh/ellipsoid_mesh.h"
#include "baker/plot/plot_axis.h"
#include "baker/plot/plots.h"
#include "baker/plot/svg.h"
#include "mesh_shapes.h"
#include "scratch.h"

#include <doctest/doctest.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>

using namespace lr;
using namespace lr::baker;
using doctest::Approx;
using test::Scratch;

namespace {

struct Element {
    std::string name, text;
    std::map<std::string, std::string> attributes;
};

// A minimal XML check: tags and attributes, nesting, entities, raw control characters.
class XmlReader {
public:
    explicit XmlReader(std::string_view text) : rest_(text) {}

    std::vector<Element> read() {
        skip("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
        std::vector<std::string> open;
        while (!rest_.empty()) {
            if (rest_[0] != '<') {
                const std::string text = take_until('<');
                check_text(text);
                if (!elements_.empty()) elements_.back().text += text;
            } else if (rest_.starts_with("</")) {
                rest_.remove_prefix(2);
                const std::string name = take_until('>');
                skip(">");
                REQUIRE_FALSE(open.empty());
                REQUIRE(open.back() == name);
                open.pop_back();
                if (open.empty()) skip("\n");
                if (open.empty()) break;
            } else {
                open_tag(open);
            }
        }
        CHECK(rest_.empty());
        CHECK(open.empty());
        return std::move(elements_);
    }

private:
    void skip(std::string_view what) {
        REQUIRE(rest_.starts_with(what));
        rest_.remove_prefix(what.size());
    }
    std::string take_until(char end) {
        const std::size_t at = rest_.find(end);
        REQUIRE(at != std::string_view::npos);
        std::string text(rest_.substr(0, at));
        rest_.remove_prefix(at);
        return text;
    }
    static bool is_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == ':'; }
    std::string name() {
        std::string text;
        while (!rest_.empty() && is_name(rest_[0])) {
            text += rest_[0];
            rest_.remove_prefix(1);
        }
        REQUIRE_FALSE(text.empty());
        return text;
    }
    void open_tag(std::vector<std::string>& open) {
        skip("<");
        Element element;
        element.name = name();
        while (rest_.starts_with(" ")) {
            skip(" ");
            if (rest_.starts_with("/") || rest_.starts_with(">")) break;
            const std::string key = name();
            skip("=\"");
            const std::string value = take_until('"');
            skip("\"");
            check_text(value);
            REQUIRE(value.find('<') == std::string::npos);
            REQUIRE(element.attributes.emplace(key, value).second);
        }
        const bool empty = rest_.starts_with("/");
        if (empty) skip("/");
        skip(">");
        if (!empty) open.push_back(element.name);
        elements_.push_back(std::move(element));
    }
    static void check_text(const std::string& text) {
        bool good = true;
        for (std::size_t i = 0; i < text.size(); ++i) {
            good = good && (static_cast<unsigned char>(text[i]) >= 0x20 || text[i] == '\n') && text[i] != '>';
            if (text[i] != '&') continue;
            const std::string entity = text.substr(i, text.find(';', i) + 1 - i);
            good = good && (entity == "&lt;" || entity == "&gt;" || entity == "&amp;" || entity == "&quot;" ||
                            entity == "&#39;");
        }
        REQUIRE(good);
    }

    std::string_view rest_;
    std::vector<Element> elements_;
};

std::vector<double> numbers_in(const std::string& text) {
    std::vector<double> numbers;
    const char* p = text.data();
    const char* end = p + text.size();
    while (p < end) {
        double value = 0.0;
        const std::from_chars_result result = std::from_chars(p, end, value);
        if (result.ec == std::errc{}) {
            if (!std::isfinite(value)) FAIL("not finite");
            numbers.push_back(value);
            p = result.ptr;
        } else {
            ++p;
        }
    }
    return numbers;
}

double number(const Element& e, const char* key) {
    const std::vector<double> n = numbers_in(e.attributes.at(key));
    REQUIRE(n.size() == 1);
    return n[0];
}

// All points of shapes, and where text begins, lie on the sheet.
std::vector<Element> check_svg(const std::string& svg) {
    std::vector<Element> elements = XmlReader(svg).read();
    REQUIRE_FALSE(elements.empty());
    REQUIRE(elements[0].name == "svg");
    const double width = number(elements[0], "width"), height = number(elements[0], "height");
    std::size_t outside = 0;
    const auto inside = [&](double x, double y) {
        outside += !(x >= -1.0 && x <= width + 1.0 && y >= -1.0 && y <= height + 1.0);
    };
    for (const Element& e : elements) {
        if (e.name == "text" || e.name == "rect") inside(number(e, "x"), number(e, "y"));
        if (e.name == "rect") inside(number(e, "x") + number(e, "width"), number(e, "y") + number(e, "height"));
        if (e.name == "circle") inside(number(e, "cx"), number(e, "cy"));
        if (e.name == "line") {
            inside(number(e, "x1"), number(e, "y1"));
            inside(number(e, "x2"), number(e, "y2"));
        }
        for (const char* list : {"points", "d"}) {
            if (!e.attributes.contains(list)) continue;
            const std::vector<double> n = numbers_in(e.attributes.at(list));
            CHECK(n.size() >= 4);
            CHECK(n.size() % 2 == 0);
            for (std::size_t i = 0; i + 1 < n.size(); i += 2) inside(n[i], n[i + 1]);
        }
    }
    CHECK(outside == 0);
    for (const char* bad : {"nan", "inf\"", "inf ", "NaN"}) CHECK(svg.find(bad) == std::string::npos);
    return elements;
}

void check_all(const AssetData& asset, const Mesh& body) {
    for (const std::string& svg : make_plots(asset, body)) {
        check_svg(svg);
        CHECK(is_plot_of(svg, asset.provenance));
        CHECK(svg.size() < 2'000'000);
    }
    CHECK(make_plots(asset, body) == make_plots(asset, body));
}

AssetData ellipsoid(const std::array<double, 3>& axes, Mesh* body, const char* name = "a body") {
    BakeOptions o;
    o.semi_axes = axes;
    o.name = name;
    o.cells = {8, 8, 8};
    AssetData asset;
    Faults faults;
    BakeHooks hooks;
    hooks.body = body;
    REQUIRE(bake(o, asset, faults, nullptr, {}, hooks));
    return asset;
}

// Width and height of the box around points, in px.
Eigen::Vector2d size_of(const std::vector<double>& coordinates) {
    Eigen::AlignedBox2d box;
    for (std::size_t i = 0; i + 1 < coordinates.size(); i += 2)
        box.extend(Eigen::Vector2d(coordinates[i], coordinates[i + 1]));
    return box.sizes();
}

} // namespace

TEST_CASE("plots: of baked bodies and of ellipsoids") {
    const Scratch scratch;
    BakeOptions o;
    o.mesh_path = scratch.write("leaf.obj", test::obj_text(test::leaf(20, 6, 0.02, 0.5), 20.0));
    o.cells = {8, 8, 8};
    AssetData asset;
    Faults faults;
    Mesh body;
    BakeHooks hooks;
    hooks.body = &body;
    REQUIRE(bake(o, asset, faults, nullptr, {}, hooks));
    CHECK(body.faces.size() == asset.provenance.faces);
    check_all(asset, body);
    AssetData other = asset;
    other.provenance.input_hash ^= 1;
    CHECK_FALSE(is_plot_of(plot_entries(asset), other.provenance));

    check_all(ellipsoid({0.04, 0.02, 0.01}, &body), body);
    check_all(ellipsoid({1.0, 1.0, 1.0}, &body), body); // no added inertia at all
    check_all(ellipsoid({900.0, 1.0, 0.1}, &body), body);
    check_all(ellipsoid({1e-6, 2e-6, 3e-6}, &body), body);
}

TEST_CASE("plots: names cannot leave their place") {
    Mesh body;
    const AssetData asset =
        ellipsoid({0.03, 0.02, 0.01}, &body, "</text><script>&\"' \x1b\x01\xff \xef\xbf\xbf caf\xc3\xa9");
    for (const std::string& svg : make_plots(asset, body)) {
        const std::vector<Element> elements = check_svg(svg);
        CHECK(svg.find("<script") == std::string::npos);
        CHECK(svg.find("caf\xc3\xa9") != std::string::npos);
        for (const Element& e : elements) CHECK(e.name != "script");
    }
    const AssetData endless = ellipsoid({0.03, 0.02, 0.01}, &body, std::string(4000, 'W').c_str());
    check_all(endless, body);
    CHECK(shortened("caf\xc3\xa9s", 4) == "caf\xc3\xa9\xe2\x80\xa6");
    CHECK(shortened("caf\xc3\xa9", 4) == "caf\xc3\xa9");
}

TEST_CASE("plots: assets as odd as a file may hold") {
    Mesh body;
    AssetData asset = ellipsoid({0.03, 0.02, 0.01}, &body);
    asset.turbulence.chi = {0.0};
    asset.turbulence.epsilon = {0.0};
    asset.turbulence.stationary = 0;
    check_all(asset, body);
    asset.turbulence.chi.assign(65536, 1e4);
    asset.turbulence.epsilon.assign(65536, 1e-300);
    asset.turbulence.stationary = 65535;
    asset.turbulence.dt = 1e-12;
    check_all(asset, body);
    asset.turbulence.epsilon[7] = 1e6;
    asset.turbulence.dt = 1e9;
    check_all(asset, body);
    asset.turbulence.chi.clear();
    asset.turbulence.epsilon.clear();
    check_all(asset, body);
    asset.added_mass.fill(0.0);
    asset.added_mass_error.fill(1e300);
    check_all(asset, body);
    asset.added_mass_error.fill(1e-300);
    asset.added_mass.fill(1e-300);
    check_all(asset, body);
    asset.center_of_buoyancy = {0.001, -0.002, 0.003};
    check_all(asset, body);
    check_all(asset, Mesh{});
    body.faces.assign(3, Face{0, 0, 0});
    check_all(asset, body);
}

TEST_CASE("plots: a mesh of any size makes a file of readable size, and keeps its outline") {
    for (const int levels : {2, 6}) { // 320 and 81,920 triangles
        Mesh ball = test::ellipsoid(0.04, 0.02, 0.01, levels);
        Mesh ignored;
        const AssetData asset = ellipsoid({0.04, 0.02, 0.01}, &ignored);
        const std::string svg = plot_added_mass(asset, ball);
        CHECK(svg.size() < 2'000'000);
        // Ellipsoids of both kinds over the mesh, from closed forms: the first panel looks along z.
        std::vector<double> mesh;
        std::vector<Eigen::Vector2d> outlines;
        int panel = 0;
        for (const Element& e : check_svg(svg)) {
            if (e.name == "g") ++panel;
            if (panel == 1 && e.name == "path")
                for (const double x : numbers_in(e.attributes.at("d"))) mesh.push_back(x);
            if (panel == 1 && e.name == "polygon" && e.attributes.contains("fill-opacity"))
                outlines.push_back(size_of(numbers_in(e.attributes.at("points"))));
        }
        const Eigen::Vector2d seen = size_of(mesh);
        const double pixels = seen[0] / 0.08;
        CHECK(seen[1] == Approx(0.04 * pixels).epsilon(0.02));
        REQUIRE(outlines.size() == 2); // inertia, then mass
        const double volume = 4.0 / 3.0 * 3.14159265358979 * 0.04 * 0.02 * 0.01;
        const double ball_per_radius = 4.0 / 3.0 * 3.14159265358979;
        CHECK(outlines[1][0] == Approx(2.0 * pixels * std::cbrt(0.12657 * volume / ball_per_radius)).epsilon(0.02));
        CHECK(outlines[1][1] == Approx(2.0 * pixels * std::cbrt(0.39817 * volume / ball_per_radius)).epsilon(0.02));
        const double rotation = asset.added_mass[21];
        CHECK(outlines[0][0] ==
              Approx(2.0 * pixels * std::pow(rotation * 15.0 / (8.0 * 3.14159265358979), 0.2)).epsilon(0.02));
    }
}

TEST_CASE("plots: axes hold their range, and label it") {
    for (const double low : {0.0, 1e-9, 0.3, 5.0, -3.0})
        for (const double span : {1e-12, 1e-3, 0.07, 1.0, 444.0, 1e7}) {
            CAPTURE(low);
            CAPTURE(span);
            for (const Axis& axis : {Axis::linear(low, low + span, 6), Axis::fitting(low, low + span)}) {
                CHECK(axis.low() <= low + 1e-9 * span);
                CHECK(axis.high() >= low + span - 1e-9 * (span + std::abs(low)));
                CHECK(axis.at(axis.low()) == Approx(0.0));
                CHECK(axis.at(axis.high()) == Approx(1.0));
                double last = -1.0;
                std::size_t labels = 0;
                for (const Tick& tick : axis.ticks()) {
                    CHECK(axis.at(tick.value) > last - 1e-6);
                    last = axis.at(tick.value);
                    labels += !tick.label.empty();
                }
                CHECK(labels >= 2);
                CHECK(labels <= 12);
            }
        }
    CHECK(Axis::fitting(1.0, 30.0).is_logarithmic());
    CHECK_FALSE(Axis::fitting(0.0, 30.0).is_logarithmic());
    const Axis axis = Axis::linear(0.0, 0.0004, 4);
    CHECK(axis.factor() == "10\xe2\x81\xbb\xe2\x81\xb4 ");
    CHECK(axis.ticks().back().label == "4");
    CHECK(Axis::up_to(444.0, 8).high() == 444.0);

    CHECK(paper_number(0.0, 3) == "0");
    CHECK(paper_number(0.012345, 3) == "0.0123");
    CHECK(paper_number(-4.5, 2) == "\xe2\x88\x92"
                                   "4.5");
    CHECK(paper_number(4925.3, 3) == "4925");
    CHECK(paper_number(9.996, 3) == "10.0");
    CHECK(paper_number(1.234e-5, 3) == "1.23\xc3\x97"
                                       "10\xe2\x81\xbb\xe2\x81\xb5");
    CHECK(paper_number(std::numeric_limits<double>::quiet_NaN(), 3) == "0");
    CHECK(svg_number(-0.0001) == "0");
    CHECK(svg_number(1.10) == "1.1");
    CHECK(svg_number(std::numeric_limits<double>::infinity()) == "0");
}

TEST_CASE("lr_bake --plots: three files, or none") {
    const Scratch scratch;
    const auto lr_bake = [&](const std::vector<std::string>& arguments) {
        return test::run(LR_BAKE_PATH, arguments).exit_code;
    };
    const std::string mesh = scratch.write("a.obj", test::obj_text(test::ellipsoid(0.03, 0.027, 0.024, 2)));
    const std::string bad = scratch.write("bad.obj", "v 0 0 0\nf 1 2 3\n"), out = scratch.path("a.lrb");
    const std::string plots = scratch.path("plots");
    CHECK(lr_bake({"mesh", bad, "-o", out, "--plots", plots, "--quiet"}) == 1);
    CHECK_FALSE(scratch.has("plots"));
    CHECK(lr_bake({"mesh", mesh, "-o", out, "--plots", scratch.path("none/plots"), "--quiet"}) == 1);
    CHECK(lr_bake({"mesh", mesh, "-o", out, "--plots", mesh, "--quiet"}) == 1);
    CHECK(lr_bake({"mesh", mesh, "-o", out, "--plots", "", "--quiet"}) == 2);
    CHECK_FALSE(scratch.has("a.lrb"));
    CHECK(lr_bake({"mesh", mesh, "-o", out, "--plots", plots + "/", "--quiet"}) == 0);
    std::map<std::string, std::string> first;
    for (const char* name : plot_names) {
        first[name] = scratch.read(std::string("plots/") + name);
        check_svg(first[name]);
    }
    CHECK(lr_bake({"mesh", mesh, "-o", out, "--plots", plots, "--quiet"}) == 0);
    for (const char* name : plot_names) CHECK(scratch.read(std::string("plots/") + name) == first[name]);

    // In a batch each picture has the name of its asset, and a deleted one is written again.
    const std::vector<std::string> batch{"mesh", mesh, "-d", scratch.path("out"), "--plots", plots, "--quiet"};
    CHECK(lr_bake(batch) == 0);
    for (const char* name : plot_names) CHECK(scratch.read(std::string("plots/a.") + name) == first[name]);
    std::filesystem::remove(scratch.path("plots/a.entries.svg"));
    CHECK(lr_bake(batch) == 0);
    CHECK(scratch.read("plots/a.entries.svg") == first["entries.svg"]);
    scratch.write("plots/a.entries.svg", first["entries.svg"].substr(0, 1000));
    CHECK(lr_bake(batch) == 0);
    CHECK(scratch.read("plots/a.entries.svg") == first["entries.svg"]);
    const auto written = std::filesystem::last_write_time(scratch.path("plots/a.entries.svg"));
    CHECK(lr_bake(batch) == 0);
    CHECK(std::filesystem::last_write_time(scratch.path("plots/a.entries.svg")) == written);
}
