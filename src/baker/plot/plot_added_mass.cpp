#include "baker/eigensystem.h"
#include "baker/plot/plot_axis.h"
#include "baker/plot/plot_mesh.h"
#include "baker/plot/plots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace lr::baker {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double pi = 3.14159265358979323846;
constexpr const char* mass_color = "#1f5fa8";
constexpr const char* inertia_color = "#c2570c";

// Axes of a symmetric block as columns, the longest radius last; radii in m.
struct Ellipsoid {
    Matrix3d axes = Matrix3d::Identity();
    Vector3d principal = Vector3d::Zero(), radii = Vector3d::Zero();

    // Outline in a view: the image of the unit circle under the projected axes.
    std::vector<SvgPoint> outline(const PlotView& view) const {
        Eigen::Matrix<double, 2, 3> seen;
        for (int i = 0; i < 3; ++i) {
            const Vector3d axis = radii[i] * axes.col(i);
            seen.col(i) << view.right.dot(axis), view.up.dot(axis);
        }
        const Eigensystem<Eigen::Matrix2d> solver = eigensystem(Eigen::Matrix2d(seen * seen.transpose()));
        const Eigen::Vector2d size = solver.values.cwiseMax(0.0).cwiseSqrt();
        std::vector<SvgPoint> points;
        for (int i = 0; i < 96; ++i) {
            const double angle = 2.0 * pi * i / 96;
            const Eigen::Vector2d p =
                solver.vectors * Eigen::Vector2d(size[0] * std::cos(angle), size[1] * std::sin(angle));
            points.push_back(view.place(p[0], p[1]));
        }
        return points;
    }
};

// Radii of spheres of fluid of density 1 with the block's masses (or moments of inertia) unit_sphere r^power.
Ellipsoid ellipsoid_of(const AssetData& a, std::size_t first, double unit_sphere, double power) {
    Matrix3d block;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            block(i, j) = a.added_mass[(first + static_cast<std::size_t>(i)) * 6 + first + static_cast<std::size_t>(j)];
    const Eigensystem<Matrix3d> solver = eigensystem(block);
    Ellipsoid e;
    e.axes = solver.vectors;
    e.principal = solver.values.cwiseMax(0.0);
    for (int i = 0; i < 3; ++i) e.radii[i] = std::pow(e.principal[i] / unit_sphere, 1.0 / power);
    return e;
}

// Extends the half-size of a view about the centre of mass.
void include(const PlotView& view, const Vector3d& point, Eigen::AlignedBox2d& box) {
    box.extend(Eigen::Vector2d(view.right.dot(point), view.up.dot(point)));
}

void draw_arrow(Svg& svg, SvgPoint from, SvgPoint to, const std::string& label) {
    const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
    if (length < 6.0) return; // points towards the viewer
    const double ux = dx / length, uy = dy / length;
    svg.line(from, {to.x - 4.0 * ux, to.y - 4.0 * uy}, R"(stroke="#333" stroke-width="1.1")");
    const std::array<SvgPoint, 3> head{{to,
                                        {to.x - 6.0 * ux - 2.6 * uy, to.y - 6.0 * uy + 2.6 * ux},
                                        {to.x - 6.0 * ux + 2.6 * uy, to.y - 6.0 * uy - 2.6 * ux}}};
    svg.polygon(head, R"(fill="#333")");
    svg.text({to.x + 8.0 * ux, to.y + 8.0 * uy + 4.0}, label, R"(text-anchor="middle" font-size="11" fill="#333")");
}

void draw_axes(Svg& svg, const PlotView& view, SvgPoint corner) {
    constexpr const char* names[3] = {"x", "y", "z"};
    for (int i = 0; i < 3; ++i)
        draw_arrow(svg, corner, {corner.x + 26.0 * view.right[i], corner.y - 26.0 * view.up[i]}, names[i]);
}

void draw_ellipsoid(Svg& svg, const PlotView& view, const Ellipsoid& e, const std::string& color, bool dashed) {
    const std::string stroke = "stroke=\"" + color + "\"";
    const std::string dash = dashed ? " stroke-dasharray=\"5 3\"" : "";
    svg.polygon(e.outline(view), "fill=\"" + color + "\" fill-opacity=\"" + (dashed ? "0.04" : "0.1") + "\" " + stroke +
                                     " stroke-width=\"1.5\"" + dash);
    for (int i = 0; i < 3; ++i) {
        const Vector3d tip = e.radii[i] * e.axes.col(i);
        svg.line(view.at(-tip), view.at(tip), stroke + " stroke-width=\"0.9\"" + dash);
    }
}

void draw_scale_bar(Svg& svg, double pixels_per_metre, SvgPoint right_end) {
    const double most = 120.0 / pixels_per_metre;
    const double decade = std::pow(10.0, std::floor(std::log10(most)));
    const double length = decade * (most >= 5.0 * decade ? 5.0 : most >= 2.0 * decade ? 2.0 : 1.0);
    const double left = right_end.x - length * pixels_per_metre;
    svg.line({left, right_end.y}, right_end, R"(stroke="#222" stroke-width="2")");
    for (const double x : {left, right_end.x})
        svg.line({x, right_end.y - 4.0}, {x, right_end.y + 4.0}, R"(stroke="#222" stroke-width="1.2")");
    const std::string text = length < 1e-3  ? paper_number(1e6 * length, 1) + " \xc2\xb5m"
                             : length < 1.0 ? paper_number(1e3 * length, 1) + " mm"
                                            : paper_number(length, 1) + " m";
    svg.text({0.5 * (left + right_end.x), right_end.y - 8.0}, text, R"(text-anchor="middle")");
}

std::string list(const Vector3d& principal, double fluid, const char* unit) {
    std::string text;
    for (int i = 2; i >= 0; --i) text += paper_number(fluid * principal[i], 3) + (i > 0 ? ",  " : " ");
    return text + unit;
}
} // namespace

std::string plot_added_mass(const AssetData& a, const Mesh& body) {
    constexpr double margin = 28.0, panel_w = 400.0, panel_h = 290.0, gap = 14.0, top = 118.0;
    const Ellipsoid mass = ellipsoid_of(a, 0, 4.0 / 3.0 * pi, 3.0), inertia = ellipsoid_of(a, 3, 8.0 / 15.0 * pi, 5.0);
    const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
    const Vector3d oblique = Vector3d(0.55, -0.75, 0.5).normalized();
    const Vector3d oblique_right = z.cross(oblique).normalized();
    struct Panel {
        const char* title;
        PlotView view;
        double column, row;
    };
    // Third-angle projection: plan above the front, side view to its right.
    std::array<Panel, 4> panels{{{"from +z", {x, y}, 0.0, 0.0},
                                 {"oblique", {oblique_right, oblique.cross(oblique_right)}, 1.0, 0.0},
                                 {"from \xe2\x88\x92y", {x, z}, 0.0, 1.0},
                                 {"from +x", {y, z}, 1.0, 1.0}}};
    // One scale for all views.
    double scale = 0.0;
    std::array<Eigen::Vector2d, 4> middle;
    for (std::size_t i = 0; i < panels.size(); ++i) {
        Eigen::AlignedBox2d box(Eigen::Vector2d(0.0, 0.0));
        for (const Vector3d& v : body.vertices) include(panels[i].view, v, box);
        for (const Ellipsoid* e : {&mass, &inertia})
            for (const SvgPoint& p : e->outline(panels[i].view)) box.extend(Eigen::Vector2d(p.x, -p.y));
        middle[i] = box.center();
        const Eigen::Vector2d size = box.sizes().cwiseMax(1e-12);
        const double fits = std::min((panel_w - 90.0) / size[0], (panel_h - 70.0) / size[1]);
        scale = i == 0 ? fits : std::min(scale, fits);
    }
    Svg svg(2.0 * margin + 2.0 * panel_w + gap, top + 2.0 * panel_h + gap + 52.0, "Added mass ellipsoids of " + a.name,
            plot_description(a));
    svg.text({margin, 30.0}, "Added mass of " + shortened(a.name, 56), R"(font-size="17" font-weight="bold")");
    svg.text(
        {margin, 50.0},
        "about the centre of mass, in a fluid of " + paper_number(a.fluid_density, 3) +
            " kg/m\xc2\xb3. Semi-axis: radius of the sphere of fluid that has this mass, or this moment of inertia.",
        R"(fill="#444")");
    const auto legend = [&](double row, const char* color, const char* dash, const std::string& text) {
        svg.line({margin, row - 4.0}, {margin + 26.0, row - 4.0},
                 std::string("stroke-width=\"1.8\" stroke=\"") + color + "\"" + dash);
        svg.text({margin + 34.0, row}, text, "");
    };
    legend(74.0, mass_color, "", "added mass  " + list(mass.principal, a.fluid_density, "kg"));
    legend(94.0, inertia_color, " stroke-dasharray=\"5 3\"",
           "added moment of inertia  " + list(inertia.principal, a.fluid_density, "kg m\xc2\xb2"));

    const DrawnMesh drawn(body);
    svg.style(drawn.style());
    for (std::size_t i = 0; i < panels.size(); ++i) {
        Panel& panel = panels[i];
        const double px = margin + panel.column * (panel_w + gap), py = top + panel.row * (panel_h + gap);
        panel.view.scale = scale;
        panel.view.origin = {px + 0.5 * panel_w - scale * middle[i][0], py + 0.5 * panel_h + scale * middle[i][1]};
        svg.rect(px, py, panel_w, panel_h, R"(fill="none" stroke="#bbb" stroke-width="0.8")");
        drawn.draw(svg, panel.view);
        draw_ellipsoid(svg, panel.view, inertia, inertia_color, true);
        draw_ellipsoid(svg, panel.view, mass, mass_color, false);
        const Vector3d buoyancy(a.center_of_buoyancy[0], a.center_of_buoyancy[1], a.center_of_buoyancy[2]);
        if (buoyancy.norm() > 5e-3 * a.length_d)
            svg.circle(panel.view.at(buoyancy), 3.5, R"(fill="#fff" stroke="#111" stroke-width="1.2")");
        svg.circle(panel.view.origin, 3.0, R"(fill="#111")");
        svg.text({px + 10.0, py + 20.0}, panel.title, R"(fill="#333")");
        draw_axes(svg, panel.view, {px + 22.0, py + panel_h - 26.0});
    }
    const double foot = top + 2.0 * panel_h + gap + 32.0;
    svg.circle({margin + 6.0, foot - 4.0}, 3.0, R"(fill="#111")");
    std::string note = "centre of mass";
    const bool ballasted =
        std::hypot(a.center_of_buoyancy[0], a.center_of_buoyancy[1], a.center_of_buoyancy[2]) > 5e-3 * a.length_d;
    svg.text({margin + 16.0, foot}, note, R"(fill="#333")");
    if (ballasted) {
        svg.circle({margin + 126.0, foot - 4.0}, 3.5, R"(fill="#fff" stroke="#111" stroke-width="1.2")");
        svg.text({margin + 136.0, foot}, "centre of buoyancy", R"(fill="#333")");
    }
    if (drawn.is_thinned())
        svg.text({margin + 290.0, foot}, "mesh drawn coarser than baked", R"(fill="#777" font-style="italic")");
    draw_scale_bar(svg, scale, {margin + 2.0 * panel_w + gap, foot});
    return svg.finish();
}
} // namespace lr::baker
