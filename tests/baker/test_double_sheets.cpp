// Sheets that are modelled as a front and a back face.
#include "bake_mesh.h"
#include "baker/mesh/double_sheets.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace lr;
using namespace lr::baker;

namespace {

// A curved blade of 10 cm, this far below its place; turned: it looks down.
Mesh blade(int along, int across, double below, bool turned) {
    Mesh mesh;
    const auto at = [&](int i, int j) { return static_cast<uint32_t>(i * (across + 1) + j); };
    for (int i = 0; i <= along; ++i)
        for (int j = 0; j <= across; ++j) {
            const double x = 2.0 * i / along - 1.0, y = (0.02 + 0.35 * (1.0 - x * x)) * (2.0 * j / across - 1.0);
            mesh.vertices.emplace_back(0.05 * x, 0.05 * y, 0.05 * (0.1 * y * y + 0.03 * x * x) - below);
        }
    for (int i = 0; i < along; ++i)
        for (int j = 0; j < across; ++j)
            for (Face f :
                 {Face{at(i, j), at(i + 1, j), at(i + 1, j + 1)}, Face{at(i, j), at(i + 1, j + 1), at(i, j + 1)}}) {
                if (turned) std::swap(f[1], f[2]);
                mesh.faces.push_back(f);
            }
    return mesh;
}

void add(Mesh& to, const Mesh& from) {
    const auto first = static_cast<uint32_t>(to.vertices.size());
    to.vertices.insert(to.vertices.end(), from.vertices.begin(), from.vertices.end());
    for (const Face& f : from.faces) to.faces.push_back({f[0] + first, f[1] + first, f[2] + first});
}

Mesh twice(Mesh front, const Mesh& back) {
    add(front, back);
    return front;
}

// Faces that stay.
std::size_t left_of(const Mesh& mesh, Faults& faults, bool strict = false) {
    faults.clear();
    std::vector<Face> sheets = mesh.faces;
    const bool good = take_double_sheets_once(mesh, 0.0003, strict, sheets, faults);
    CHECK(good != (strict && !faults.empty()));
    return sheets.size();
}

// Two triangles for each cell of a grid of vertices, row after row.
void fill_grid(Mesh& mesh, uint32_t rows, uint32_t cells) {
    for (uint32_t i = 0; i < rows; ++i)
        for (uint32_t j = 0; j < cells; ++j) {
            const uint32_t a = (cells + 1) * i + j, b = a + cells + 1;
            mesh.faces.push_back({a, b, b + 1});
            mesh.faces.push_back({a, b + 1, a + 1});
        }
}

// 10 x 10 cm, folded in the middle: the layers are `gap` apart at their ends.
Mesh folded(double gap) {
    Mesh mesh;
    for (int i = -6; i <= 6; ++i)
        for (int j = 0; j <= 6; ++j)
            mesh.vertices.emplace_back(0.05 * std::abs(i) / 6.0, 0.1 * j / 6.0, gap * (i > 0) - gap * (i < 0));
    fill_grid(mesh, 12, 6);
    return mesh;
}
} // namespace

TEST_CASE("double sheets: a front and a back face a hair apart are one sheet, however the back is cut into faces") {
    Faults faults;
    const Mesh front = blade(20, 8, 0.0, false);
    const std::size_t faces = front.faces.size();
    CHECK(left_of(front, faults) == faces);
    CHECK(faults.empty());
    for (const double gap : {1e-5, 1e-4, 5e-4}) {
        CAPTURE(gap);
        CHECK(left_of(twice(front, blade(20, 8, gap, true)), faults) == faces);
        REQUIRE(faults.size() == 1);
        CHECK(faults[0].severity == Severity::warning);
        CHECK(faults[0].what.find("320 faces are the back of a sheet") != std::string::npos);
        CHECK(faults[0].what.find("50 % of the area") != std::string::npos);
        left_of(twice(front, blade(20, 8, gap, true)), faults, true);
        REQUIRE(faults.size() == 1);
        CHECK(faults[0].severity == Severity::error);
        CHECK(left_of(twice(front, blade(17, 6, gap, true)), faults) == faces);
    }
}

TEST_CASE("double sheets: layers farther apart, beside each other or that look the same way are two") {
    Faults faults;
    const Mesh front = blade(20, 8, 0.0, false);
    for (const Mesh& back : {blade(20, 8, 0.003, true), blade(20, 8, 1e-4, false)}) {
        CHECK(left_of(twice(front, back), faults) == front.faces.size() + back.faces.size());
        CHECK(faults.empty());
    }
    Mesh beside = blade(20, 8, 1e-4, true);
    for (Eigen::Vector3d& v : beside.vertices) v.x() += 0.04;
    CHECK(left_of(twice(front, beside), faults) == 2 * front.faces.size());
    CHECK(faults.empty());
}

TEST_CASE("double sheets: folded paper keeps both layers, with a warning") {
    Faults faults;
    const Mesh paper = folded(1e-4);
    CHECK(left_of(paper, faults) == paper.faces.size());
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].what.find("100 % of the area lies within") != std::string::npos);
    left_of(folded(0.02), faults);
    CHECK(faults.empty());
}

TEST_CASE("double sheets: narrow pleats that lie on each other all count") {
    Mesh paper;
    for (int i = 0; i <= 20; ++i)
        for (int j = 0; j <= 20; ++j) paper.vertices.emplace_back(i % 2 * 0.004, 0.1 * j / 20.0, 2e-5 * i);
    fill_grid(paper, 20, 20);
    Faults faults;
    CHECK(left_of(paper, faults) == paper.faces.size());
}

TEST_CASE("double sheets: the two sides of a closed leaf that is baked as a sheet count once, and its rim not at all") {
    const int along = 20, across = 8;
    const Mesh single = blade(along, across, 0.0, false);
    Mesh closed = twice(single, blade(along, across, 1e-4, true));
    const auto half = static_cast<uint32_t>(single.vertices.size());
    const auto at = [&](int i, int j) { return static_cast<uint32_t>(i * (across + 1) + j); };
    const auto wall = [&](uint32_t a, uint32_t b) {
        closed.faces.push_back({a, half + b, b});
        closed.faces.push_back({a, half + a, half + b});
    };
    for (int i = 0; i < along; ++i) wall(at(i, 0), at(i + 1, 0)), wall(at(i + 1, across), at(i, across));
    for (int j = 0; j < across; ++j) wall(at(along, j), at(along, j + 1)), wall(at(0, j + 1), at(0, j));
    Faults faults;
    CHECK(left_of(closed, faults) == single.faces.size());
    CHECK(faults.size() == 1);
}

TEST_CASE("bake: open leaves with a back weigh what leaves without one do") {
    BakeOptions plain, strict;
    plain.thickness = 0.0003;
    strict.strict = true;
    strict.sheet = SheetOptions{};
    const Mesh front = blade(20, 8, 0.0, false), both = twice(front, blade(20, 8, 1e-4, true));
    AssetData one, two, refused;
    Faults faults;
    REQUIRE(test::bake_mesh(front, one, plain));
    REQUIRE(test::bake_mesh(both, two, plain, &faults));
    CHECK(two.mass == doctest::Approx(one.mass).epsilon(1e-9));
    for (std::size_t k = 0; k < 6; ++k)
        CHECK(two.added_mass[7 * k] == doctest::Approx(one.added_mass[7 * k]).epsilon(0.01));
    // One part is left.
    CHECK(std::none_of(faults.begin(), faults.end(),
                       [](const Fault& f) { return f.id == FaultId::mesh_several_components; }));
    CHECK(test::bake_mesh(front, refused, strict));
    CHECK_FALSE(test::bake_mesh(both, refused, strict));
    const Mesh apart = twice(both, blade(20, 8, 0.05, false));
    REQUIRE(test::bake_mesh(apart, two, plain, &faults));
    CHECK(std::count_if(faults.begin(), faults.end(), [](const Fault& f) {
              return f.id == FaultId::mesh_several_components &&
                     f.what.find("has 2 separate parts") != std::string::npos;
          }) == 1);
}
