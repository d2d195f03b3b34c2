// Rows for potential flow: the baker's boundary elements against closed forms.
#include "tools/lr_scorecard/measured_bodies.h"
#include "tools/lr_scorecard/row.h"

#include <array>
#include <cmath>
#include <numbers>

namespace lr::scorecard {
namespace {

using std::numbers::pi;

// Carlson's R_D by the duplication theorem.
double carlson_rd(double x, double y, double z) {
    double sum = 0.0, factor = 1.0;
    for (int i = 0; i < 60; ++i) {
        const double sx = std::sqrt(x), sy = std::sqrt(y), sz = std::sqrt(z);
        const double lambda = sx * sy + sx * sz + sy * sz;
        sum += factor / (sz * (z + lambda));
        factor *= 0.25;
        x = 0.25 * (x + lambda), y = 0.25 * (y + lambda), z = 0.25 * (z + lambda);
    }
    // x, y and z have converged to one value.
    return 3.0 * sum + factor / (z * std::sqrt(z));
}

struct Lamb {
    std::array<double, 3> added, added_inertia; // at fluid density 1
};

Lamb lamb(const std::array<double, 3>& a) {
    const double volume = 4.0 / 3.0 * pi * a[0] * a[1] * a[2];
    std::array<double, 3> alpha{};
    for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3, k = (i + 2) % 3;
        alpha[i] = 2.0 / 3.0 * a[0] * a[1] * a[2] * carlson_rd(a[j] * a[j], a[k] * a[k], a[i] * a[i]);
    }
    Lamb out{};
    for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3, k = (i + 2) % 3;
        const double difference = a[j] * a[j] - a[k] * a[k], sum = a[j] * a[j] + a[k] * a[k];
        out.added[i] = volume * alpha[i] / (2.0 - alpha[i]);
        if (difference != 0.0)
            out.added_inertia[i] = volume / 5.0 * difference * difference * (alpha[k] - alpha[j]) /
                                   (2.0 * difference + sum * (alpha[j] - alpha[k]));
    }
    return out;
}

// An icosahedron, subdivided `divisions` times, projected onto the ellipsoid.
Triangles ellipsoid_mesh(const std::array<double, 3>& axes, int divisions) {
    std::vector<std::array<double, 3>> points;
    std::vector<std::array<uint32_t, 3>> faces;
    const double golden = 0.5 * (1.0 + std::sqrt(5.0));
    for (double s : {-1.0, 1.0})
        for (double t : {-golden, golden}) {
            points.push_back({0.0, s, t});
            points.push_back({s, t, 0.0});
            points.push_back({t, 0.0, s});
        }
    const auto square = [&](size_t a, size_t b) {
        double sum = 0.0;
        for (size_t i = 0; i < 3; ++i) sum += (points[a][i] - points[b][i]) * (points[a][i] - points[b][i]);
        return sum;
    };
    // Faces are the triples of vertices at mutual distance 2, the edge length.
    for (uint32_t a = 0; a < 12; ++a)
        for (uint32_t b = a + 1; b < 12; ++b)
            for (uint32_t c = b + 1; c < 12; ++c)
                if (square(a, b) < 4.1 && square(b, c) < 4.1 && square(a, c) < 4.1) {
                    const auto &p = points[a], &q = points[b], &r = points[c];
                    const double triple = p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0]) +
                                          p[2] * (q[0] * r[1] - q[1] * r[0]);
                    if (triple > 0.0)
                        faces.push_back({a, b, c});
                    else
                        faces.push_back({a, c, b});
                }
    for (int n = 0; n < divisions; ++n) {
        std::vector<std::array<uint32_t, 3>> finer;
        // Each face makes its own midpoints; the baker joins coincident vertices.
        const auto middle = [&](uint32_t a, uint32_t b) {
            const uint32_t low = std::min(a, b), high = std::max(a, b);
            std::array<double, 3> m{};
            double norm = 0.0;
            for (size_t i = 0; i < 3; ++i) {
                m[i] = points[low][i] + points[high][i];
                norm += m[i] * m[i];
            }
            for (double& x : m) x *= std::sqrt((1.0 + golden * golden) / norm);
            points.push_back(m);
            return static_cast<uint32_t>(points.size() - 1);
        };
        for (const auto& f : faces) {
            const uint32_t ab = middle(f[0], f[1]), bc = middle(f[1], f[2]), ca = middle(f[2], f[0]);
            finer.insert(finer.end(), {{f[0], ab, ca}, {f[1], bc, ab}, {f[2], ca, bc}, {ab, bc, ca}});
        }
        faces = std::move(finer);
    }
    Triangles mesh;
    const double scale = 1.0 / std::sqrt(1.0 + golden * golden);
    for (const auto& p : points)
        for (size_t i = 0; i < 3; ++i) mesh.positions.push_back(p[i] * scale * axes[i]);
    for (const auto& f : faces) mesh.indices.insert(mesh.indices.end(), f.begin(), f.end());
    return mesh;
}

langevin_rigid::BakeOptions solid_in_water() {
    langevin_rigid::BakeOptions options;
    options.unit = langevin_rigid::Unit::metre;
    options.density = 1100.0;
    options.fluid_density = 1000.0;
    options.fluid_viscosity = 1e-6;
    return options;
}

// Entry i of the diagonal of the added mass, at fluid density 1.
double diagonal(const lr_asset_info& info, size_t i) {
    return info.added_mass[7 * i] / info.fluid_density;
}

void compare(RowResult& result, const lr_asset_info& info, const Lamb& reference, double volume,
             const std::array<double, 3>& axes, const std::string& name, double tolerance) {
    static constexpr const char* names[] = {"x", "y", "z"};
    for (size_t i = 0; i < 3; ++i)
        result.add(name + ": A_" + names[i] + "/V", Rule::relative, diagonal(info, i) / volume,
                   reference.added[i] / volume, tolerance);
    const double length = std::max({axes[0], axes[1], axes[2]});
    for (size_t i = 0; i < 3; ++i) {
        const double unit = volume * length * length;
        if (reference.added_inertia[i] > 0.0)
            result.add(name + ": D_" + names[i] + "/(V a^2)", Rule::relative, diagonal(info, 3 + i) / unit,
                       reference.added_inertia[i] / unit, tolerance);
        else
            result.add(name + ": D_" + names[i] + "/(V a^2)", Rule::absolute, diagonal(info, 3 + i) / unit, 0.0, 1e-3);
    }
}
} // namespace

RowResult run_lamb(const Context& context) {
    RowResult result;
    struct Body {
        const char* name;
        std::array<double, 3> axes;
    };
    const Body bodies[] = {{"4:2:1", {0.04, 0.02, 0.01}}, {"sphere", {0.02, 0.02, 0.02}}};
    // Checks the reference itself against published numbers.
    const Lamb first = lamb({4.0, 2.0, 1.0});
    const double volume = 4.0 / 3.0 * pi * 8.0;
    result.add("Lamb's integrals here: A_x/V of 4:2:1", Rule::absolute, first.added[0] / volume, 0.12657, 5e-6);
    result.add("Lamb's integrals here: A_y/V of 4:2:1", Rule::absolute, first.added[1] / volume, 0.39817, 5e-6);
    result.add("Lamb's integrals here: A_z/V of 4:2:1", Rule::absolute, first.added[2] / volume, 1.51806, 5e-6);

    const int most = context.quick ? 3 : 4;
    for (size_t b = 0; b < std::size(bodies); ++b) {
        const Body& body = bodies[b];
        const double v = 4.0 / 3.0 * pi * body.axes[0] * body.axes[1] * body.axes[2];
        const Lamb reference = lamb(body.axes);
        compare(result, info_of(make_ellipsoid(body.axes, 1100.0, water)), reference, v, body.axes,
                std::string(body.name) + ", closed form", 1e-6);
        for (int divisions = 3; divisions <= most; ++divisions) {
            const Triangles mesh = ellipsoid_mesh(body.axes, divisions);
            const lr_asset_info info = info_of(load(mesh.bake(solid_in_water())));
            // The reference is the ellipsoid, not the polyhedron.
            compare(result, info, reference, v, body.axes,
                    std::string(body.name) + ", " + std::to_string(mesh.indices.size() / 3) + " triangles",
                    divisions == 3 ? 0.01 : 0.005);
            if (context.progress)
                context.progress((static_cast<double>(b) + (divisions - 2.0) / (most - 2.0)) / std::size(bodies));
        }
    }
    return result;
}

RowResult run_thin_disc(const Context& context) {
    RowResult result;
    const double a = 0.02;
    for (uint32_t rings : context.quick ? std::vector<uint32_t>{12} : std::vector<uint32_t>{8, 16, 24}) {
        const lr_asset_info info = info_of(bake_disc(a, 1e-4, 0.07, Fluid{}, rings));
        const std::string name = std::to_string(6 * rings * rings) + " triangles: ";
        const double tolerance = rings < 12 ? 0.01 : 0.005;
        result.add(name + "A_normal/a^3", Rule::relative, diagonal(info, 2) / std::pow(a, 3.0), 8.0 / 3.0, tolerance);
        for (size_t i : {3U, 4U})
            result.add(name + "D_diameter/a^5", Rule::relative, diagonal(info, i) / std::pow(a, 5.0), 16.0 / 45.0,
                       tolerance);
    }
    return result;
}

RowResult run_rectangles(const Context& context) {
    RowResult result;
    struct Rectangle {
        double ratio, added, along_long, along_short;
    };
    // A = C pi/4 a b^2; D = c1 a b^4 about the long side, c2 b a^4 about the short side.
    const Rectangle rectangles[] = {
        {1.0, 0.5790, 0.0201, 0.0201}, {2.0, 0.7569, 0.0223, 0.0162}, {5.0, 0.8967, 0.0236, 0.0096}};
    const double b = 0.02;
    const uint32_t across = context.quick ? 16 : 28;
    std::vector<lr_asset_info> infos(std::size(rectangles));
    context.parallel(infos.size(), [&](size_t i) {
        const auto along = static_cast<uint32_t>(std::lround(across * std::sqrt(rectangles[i].ratio)));
        infos[i] = info_of(
            load(rectangle_mesh(rectangles[i].ratio * b, b, along, across).bake(sheet_options(1e-4, 0.07, Fluid{}))));
    });
    for (size_t i = 0; i < infos.size(); ++i) {
        const Rectangle& r = rectangles[i];
        const double a = r.ratio * b;
        const std::string name = "a/b = " + std::to_string(std::lround(r.ratio)) + ": ";
        // Half a unit of the reference's last digit (two to four digits), plus half a percent for the elements.
        const auto tolerance = [](double reference, double digit) { return 0.005 * reference + 0.5 * digit; };
        result.add(name + "C", Rule::absolute, diagonal(infos[i], 2) / (0.25 * pi * a * b * b), r.added,
                   tolerance(r.added, 1e-4));
        result.add(name + "c1", Rule::absolute, diagonal(infos[i], 3) / (a * std::pow(b, 4.0)), r.along_long,
                   tolerance(r.along_long, 1e-4));
        result.add(name + "c2", Rule::absolute, diagonal(infos[i], 4) / (b * std::pow(a, 4.0)), r.along_short,
                   tolerance(r.along_short, 1e-4));
    }
    return result;
}
} // namespace lr::scorecard
