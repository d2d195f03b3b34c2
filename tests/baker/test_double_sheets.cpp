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

// A leaf of 10 cm folded along its middle by 100 degrees, its sides 0.1 mm apart. `rounded`: that side turns in steps there and is one smooth patch, else at
// one sharp edge. closed: with walls around the rim. The back has its diagonals the other way and, if it is finer, a vertex in each face.
struct FoldedLeaf {
    bool front_rounded, back_rounded, closed, finer_back;
    Mesh mesh;
    std::size_t front = 0, back = 0; // faces

    void make() {
        constexpr int cells = 12;
        constexpr double half = 50.0 / 57.29577951308232, thickness = 1e-4;
        std::vector<Eigen::Vector2d> lines[2]; // y, z
        for (const int side : {0, 1}) {
            const double radius = side == 0 ? 2e-4 : 2e-4 + thickness; // of the bend, about the same axis
            std::vector<Eigen::Vector2d>& line = lines[side];
            const auto add_wing = [&](int sign) {
                const Eigen::Vector2d along(sign * std::cos(half), std::sin(half)),
                    out(sign * std::sin(half), -std::cos(half));
                for (int i = 0; i <= 4; ++i) {
                    const int step = sign < 0 ? 4 - i : i;
                    line.push_back(radius * out + 0.01 * step * along);
                }
            };
            add_wing(-1);
            const bool rounded = side == 0 ? front_rounded : back_rounded;
            if (rounded)
                for (int i = 1; i < 4; ++i)
                    line.push_back(
                        radius * Eigen::Vector2d(std::sin(half * (0.5 * i - 1.0)), -std::cos(half * (0.5 * i - 1.0))));
            else
                line.resize(line.size() - 1), line.emplace_back(0.0, -radius / std::cos(half));
            const std::size_t wing = line.size();
            add_wing(1);
            if (!rounded) line.erase(line.begin() + static_cast<std::ptrdiff_t>(wing));
        }
        const auto m = static_cast<uint32_t>(lines[0].size()), n = static_cast<uint32_t>(lines[1].size());
        for (const std::vector<Eigen::Vector2d>& line : lines)
            for (int i = 0; i <= cells; ++i)
                for (const Eigen::Vector2d& p : line) mesh.vertices.emplace_back(0.1 * i / cells, p.x(), p.y());
        const auto a = [&](uint32_t i, uint32_t j) { return i * m + j; };
        const auto b = [&](uint32_t i, uint32_t j) { return (cells + 1) * m + i * n + j; };
        const auto quad = [&](uint32_t p, uint32_t q, uint32_t r, uint32_t s) {
            mesh.faces.push_back({p, q, r});
            mesh.faces.push_back({p, r, s});
        };
        for (uint32_t i = 0; i < cells; ++i)
            for (uint32_t j = 0; j + 1 < m; ++j) quad(a(i, j), a(i + 1, j), a(i + 1, j + 1), a(i, j + 1));
        front = mesh.faces.size();
        for (uint32_t i = 0; i < cells; ++i)
            for (uint32_t j = 0; j + 1 < n; ++j) quad(b(i + 1, j), b(i, j), b(i, j + 1), b(i + 1, j + 1));
        if (finer_back)
            for (std::size_t t = front, end = mesh.faces.size(); t < end; ++t) {
                const Face f = mesh.faces[t];
                const auto middle = static_cast<uint32_t>(mesh.vertices.size());
                mesh.vertices.push_back((mesh.vertices[f[0]] + mesh.vertices[f[1]] + mesh.vertices[f[2]]) / 3.0);
                mesh.faces[t] = {f[0], f[1], middle};
                mesh.faces.push_back({f[1], f[2], middle});
                mesh.faces.push_back({f[2], f[0], middle});
            }
        back = mesh.faces.size() - front;
        if (!closed) return;
        for (uint32_t i = 0; i < cells; ++i) {
            quad(a(i, 0), b(i, 0), b(i + 1, 0), a(i + 1, 0));
            quad(a(i + 1, m - 1), b(i + 1, n - 1), b(i, n - 1), a(i, m - 1));
        }
        for (const uint32_t i : {0U, static_cast<uint32_t>(cells)})
            for (uint32_t j = 0, k = 0; j + 1 < m || k + 1 < n;) {
                const bool first = k + 1 == n || (j + 1 < m && j * (n - 1) <= k * (m - 1));
                Face f = first ? Face{a(i, j), a(i, j + 1), b(i, k)} : Face{a(i, j), b(i, k + 1), b(i, k)};
                if (i > 0) std::swap(f[0], f[1]);
                mesh.faces.push_back(f);
                ++(first ? j : k);
            }
    }
};
} // namespace

TEST_CASE("double sheets: the back of faces much finer than its distance") {
    // The gap is a hundredth of 10 cm, five faces long.
    Mesh leaf = twice(blade(500, 8, 0.0, false), blade(499, 9, 0.0008, true));
    for (Eigen::Vector3d& v : leaf.vertices) v = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 0.5).normalized()) * v;
    Faults faults;
    CHECK(left_of(leaf, faults) == 8982); // the smaller side is left out
    leaf = twice(blade(500, 8, 0.0, false), blade(500, 8, 0.003, true));
    CHECK(left_of(leaf, faults) == leaf.faces.size());
}

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
    // Each is long, so that most of its rim is folds.
    for (Eigen::Vector3d& v : paper.vertices) v = {v.x(), 5.0 * v.y(), 20.0 * v.z()};
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

TEST_CASE("double sheets: a leaf with a sharp crease in front, at the back or in both counts once") {
    Faults faults;
    for (const bool front_rounded : {false, true})
        for (const bool back_rounded : {false, true})
            for (const bool closed : {false, true})
                for (const bool finer_back : {false, true}) {
                    CAPTURE(front_rounded);
                    CAPTURE(back_rounded);
                    CAPTURE(closed);
                    CAPTURE(finer_back);
                    FoldedLeaf leaf{front_rounded, back_rounded, closed, finer_back, {}};
                    leaf.make();
                    const std::size_t left = left_of(leaf.mesh, faults);
                    CHECK((left == leaf.front || left == leaf.back));
                    CHECK(faults.size() == 1);
                }
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
