// Draws wind as lr_world_sample_wind gives it (docs/images/wind.png): speeds of turbulence of one and of three octaves, a
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

lr_wind_source_desc source(int32_t kind) {
    lr_wind_source_desc d;
    need(lr_wind_source_desc_init(&d, sizeof d));
    d.kind = kind;
    return d;
}
void add(lr_world* world, const lr_wind_source_desc& d) {
    lr_wind_source out = 0;
    need(lr_world_add_wind(world, &d, &out));
}

void fill(lr_world* world, uint32_t panel) {
    lr_wind_source_desc turbulence = source(LR_WIND_SOURCE_TURBULENCE);
    turbulence.size = panel == 3 ? 0.5f : 1.0f;
    turbulence.octaves = panel == 0 ? 1 : 3;
    turbulence.speed = panel == 3 ? 0.5f : 1.0f;
    if (panel != 2) add(world, turbulence);
    if (panel == 2) {
        lr_wind_desc wind;
        need(lr_wind_desc_init(&wind, sizeof wind));
        wind.velocity[0] = 1.5f;
        need(lr_world_set_wind(world, &wind));
        lr_wind_source_desc ground = source(LR_WIND_SOURCE_GROUND);
        ground.direction[0] = 0.0f, ground.direction[1] = 1.0f;
        ground.size = 0.03f;
        add(world, ground);
        lr_wind_source_desc vortex = source(LR_WIND_SOURCE_LAMB_OSEEN);
        vortex.position[0] = 4.0f, vortex.position[1] = 4.5f;
        vortex.direction[0] = 0.0f, vortex.direction[2] = 1.0f;
        vortex.circulation = -8.0f, vortex.size = 0.8f;
        add(world, vortex);
    }
    if (panel == 3) {
        lr_wind_source_desc blower = source(LR_WIND_SOURCE_POINT_BLOWER);
        blower.position[0] = 0.7f, blower.position[1] = 3.0f;
        blower.direction[1] = 0.3f;
        blower.speed = 6.0f, blower.size = 0.25f, blower.range = 12.0f, blower.spread = 0.11f;
        add(world, blower);
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
