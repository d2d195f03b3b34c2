// Draws the baker's wake of a mesh (docs/images/wake.png): speed above, k below, in the plane through the middle of the body
// along the stream and the body's shorter side.
//   wake_picture MESH.obj OUT.png [cells along the stream [intensity]]
#include "baker/fault_text.h"
#include "baker/mesh/mass_properties.h"
#include "baker/mesh/mesh_check.h"
#include "baker/turbulence/k_epsilon.h"
#include "baker/turbulence/mean_flow.h"
#include "baker/turbulence/stream_body.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

using namespace lr;
using namespace lr::baker;

constexpr int pixels_across = 400; // of the domain's height

// Dark blue through teal and yellow to white, for 0 to 1.
void colour(double x, uint8_t* rgb) {
    static const double map[6][3] = {{20, 22, 50},   {35, 75, 125},  {40, 140, 140},
                                     {130, 190, 90}, {245, 205, 70}, {255, 250, 230}};
    const double at = 5.0 * std::clamp(x, 0.0, 1.0);
    const int n = std::min(4, static_cast<int>(at));
    for (int c = 0; c < 3; ++c) rgb[c] = static_cast<uint8_t>(map[n][c] + (at - n) * (map[n + 1][c] - map[n][c]));
}

bool write_png(const char* path, const std::vector<uint8_t>& rgb, int width, int height) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(width);
    image.height = static_cast<png_uint_32>(height);
    image.format = PNG_FORMAT_RGB;
    return png_image_write_to_file(&image, path, 0, rgb.data(), 0, nullptr) != 0;
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 3)
        return std::fprintf(stderr, "wake_picture MESH.obj OUT.png [cells along the stream [intensity]]\n"), 2;
    Mesh mesh;
    Faults faults;
    if (!read_mesh(argv[1], 1.0, mesh, faults) || !check_and_repair(mesh, faults)) {
        for (const Fault& f : faults) std::fprintf(stderr, "%s\n", to_string(f).c_str());
        return 1;
    }
    const MassProperties body = compute_mass_properties(mesh);
    const auto n = static_cast<uint32_t>(argc > 3 ? std::atoi(argv[3]) : 96);
    TurbulenceOptions o;
    o.cells = {n, n / 2, n / 2};
    o.length_d = body.extents.maxCoeff();
    if (!put_in_stream(mesh, body.axes, body.projected_areas, o, faults)) return 1;

    const double intensity = argc > 4 ? std::atof(argv[4]) : 1.0;

    // In units of U0 and d, with l = d/8.
    MacGrid start(o.cells, o.domain_lengths);
    for (double& u : start.velocity[0].values) u = 1.0;
    start.set_solid({}, o.closed_faces);
    KEpsilon turbulence(start, shape::inflow_state(1.0, intensity, 0.125));
    MeanFlow flow(std::move(start), 1e-6);
    constexpr double dt = 0.06;
    std::vector<double> viscosity;
    turbulence.follow(flow.grid, dt);
    for (double t = 0.0; t < 6.0; t += dt) {
        turbulence.eddy_viscosity(viscosity);
        if (!flow.step(dt, &viscosity)) return 1;
        turbulence.follow(flow.grid, dt);
        turbulence.step(dt);
        turbulence.diffuse(dt, 1e-4);
    }

    const GridPoint& lengths = o.domain_lengths;
    const int width = static_cast<int>(pixels_across * lengths[0] / lengths[2]);
    std::vector<uint8_t> rgb(static_cast<size_t>(width) * (2 * pixels_across + 4) * 3, 255);
    const double middle_y = 0.5 * lengths[1] - 0.5 * flow.grid.spacing[1];
    const auto j = static_cast<uint32_t>(middle_y / flow.grid.spacing[1]);
    for (int panel = 0; panel < 2; ++panel)
        for (int row = 0; row < pixels_across; ++row)
            for (int column = 0; column < width; ++column) {
                const GridPoint p = {(column + 0.5) / width * lengths[0], middle_y,
                                     (1.0 - (row + 0.5) / pixels_across) * lengths[2]};
                const size_t at = 3 * static_cast<size_t>((row + panel * (pixels_across + 4)) * width + column);
                const GridPoint v = flow.grid.velocity_at(p);
                const double speed = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
                colour(panel == 0 ? speed / 1.4 : turbulence.at(p).k / std::max(1.5 * intensity * intensity, 0.5),
                       &rgb[at]);
                // The closed faces nearest to the pixel.
                const double gx = p[0] / flow.grid.spacing[0], gz = p[2] / flow.grid.spacing[2];
                const auto i = static_cast<uint32_t>(std::min(gx + 0.5, o.cells[0] - 1.0));
                const auto k = static_cast<uint32_t>(std::min(gz + 0.5, o.cells[2] - 1.0));
                const auto ci = static_cast<uint32_t>(gx), ck = static_cast<uint32_t>(gz);
                const double pixel = 1.5 * o.cells[2] / pixels_across;
                const bool on_x = std::abs(gx - i) < pixel && flow.grid.wall_before(0, i, j, ck);
                const bool on_z = std::abs(gz - k) < pixel && flow.grid.wall_before(2, ci, j, k);
                if (on_x || on_z || flow.grid.solid[flow.grid.cell(ci, j, ck)] != 0)
                    rgb[at] = rgb[at + 1] = rgb[at + 2] = 0;
            }
    return write_png(argv[2], rgb, width, 2 * pixels_across + 4) ? 0 : 1;
}
