// Draws the wind of lr_world_sample_wind (docs/images/wind.png): speeds of turbulence of one and of three octaves, a
// Lamb-Oseen vortex in a wind over the ground, and a blower with turbulence.
//   wind_picture OUT.png
#include "langevin_rigid.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

constexpr uint32_t side = 320, gap = 8; // pixels
constexpr float metres = 8.0f;          // of a panel's side
constexpr uint32_t panels = 4;

void need(lr_status status) {
    if (status == LR_OK) return;
    std::fprintf(stderr, "%s\n", lr_status_string(status));
    std::exit(1);
}

template <class D> D initialised(lr_status (*init)(D*, uint32_t)) {
    D d;
    need(init(&d, sizeof d));
    return d;
}

void fill(lr_world* world, uint32_t panel) {
    lr_turbulence_desc turbulence = initialised(lr_turbulence_desc_init);
    turbulence.integral_length = panel == 3 ? 0.5f : 1.0f;
    turbulence.octaves = panel == 0 ? 1 : 3;
    turbulence.rms = panel == 3 ? 0.5f : 1.0f;
    if (panel != 2) need(lr_world_add_turbulence(world, &turbulence, nullptr));
    if (panel == 2) {
        need(lr_world_set_uniform_wind(world, 1.5f, 0.0f, 0.0f));
        const lr_ground_wind_desc ground = initialised(lr_ground_wind_desc_init);
        need(lr_world_add_ground_wind(world, &ground, nullptr));
        lr_vortex_desc vortex = initialised(lr_vortex_desc_init);
        vortex.position[0] = 4.0f, vortex.position[1] = 4.5f;
        vortex.axis[1] = 0.0f, vortex.axis[2] = 1.0f;
        vortex.circulation = -8.0f, vortex.core_radius = 0.8f;
        need(lr_world_add_vortex(world, &vortex, nullptr));
    }
    if (panel == 3) {
        lr_blower_desc blower = initialised(lr_blower_desc_init);
        blower.position[0] = 0.7f, blower.position[1] = 3.0f;
        blower.direction[1] = 0.3f;
        blower.speed = 6.0f, blower.nozzle_radius = 0.25f, blower.range = 12.0f, blower.spread = 0.11f;
        need(lr_world_add_blower(world, &blower, nullptr));
    }
}

// Dark blue through teal and yellow to white, for 0 to 1.
void colour(double x, uint8_t* rgb) {
    static const double map[6][3] = {{20, 22, 50},   {35, 75, 125},  {40, 140, 140},
                                     {130, 190, 90}, {245, 205, 70}, {255, 250, 230}};
    const double at = 5.0 * std::clamp(x, 0.0, 1.0);
    const int n = std::min(4, static_cast<int>(at));
    for (int c = 0; c < 3; ++c) rgb[c] = static_cast<uint8_t>(map[n][c] + (at - n) * (map[n + 1][c] - map[n][c]));
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) return std::fprintf(stderr, "wind_picture OUT.png\n"), 2;
    const uint32_t width = panels * side + (panels - 1) * gap;
    std::vector<uint8_t> rgb(size_t{3} * width * side, 255);
    for (uint32_t panel = 0; panel < panels; ++panel) {
        lr_world_desc wd;
        need(lr_world_desc_init(&wd, sizeof wd));
        lr_world* world = nullptr;
        need(lr_world_create(&wd, &world));
        fill(world, panel);
        std::vector<float> points;
        for (uint32_t y = 0; y < side; ++y)
            for (uint32_t x = 0; x < side; ++x) {
                const float scale = metres / static_cast<float>(side);
                points.insert(points.end(),
                              {static_cast<float>(x) * scale, static_cast<float>(side - y) * scale, 0.0f});
            }
        need(lr_world_sample_wind(world, points.data(), side * side, points.data()));
        lr_world_destroy(world);
        for (uint32_t y = 0; y < side; ++y)
            for (uint32_t x = 0; x < side; ++x) {
                const float* const u = &points[size_t{3} * (y * side + x)];
                const auto speed = static_cast<double>(std::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]));
                colour(speed / 3.5, &rgb[3 * (size_t{y} * width + panel * (side + gap) + x)]);
            }
    }
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = width;
    image.height = side;
    image.format = PNG_FORMAT_RGB;
    return png_image_write_to_file(&image, argv[1], 0, rgb.data(), 0, nullptr) != 0 ? 0 : 1;
}
