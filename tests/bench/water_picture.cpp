// Draws bodies at a surface as they lie, seen along the world's z axis (docs/images/water.png): above, three bodies dropped
// into still water, a silhouette each tenth of a second, times side by side; below, floats on a sea.
//   water_picture OUT.png
#include "langevin_rigid.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <vector>

namespace {

constexpr int width = 1280, row = 170, sea_height = 300, gap = 6; // pixels
constexpr int height = 3 * (row + gap) + sea_height;
constexpr double scale = 160.0; // pixels a metre

struct Colour {
    double r, g, b;
};
constexpr Colour sky{238, 243, 247}, deep{64, 118, 158}, shallow{138, 182, 208}, line{245, 250, 255};

void need(lr_status status) {
    if (status == LR_OK) return;
    std::fprintf(stderr, "%s\n", lr_status_string(status));
    std::exit(1);
}

class Picture {
public:
    void blend(int x, int y, Colour c, double alpha) {
        if (x < 0 || x >= width || y < 0 || y >= height) return;
        const double value[3] = {c.r, c.g, c.b};
        uint8_t* const at = &rgb_[(static_cast<size_t>(y) * width + static_cast<size_t>(x)) * 3];
        for (int k = 0; k < 3; ++k) at[k] = static_cast<uint8_t>(at[k] + alpha * (value[k] - at[k]));
    }
    bool write(const char* path) const {
        png_image image{};
        image.version = PNG_IMAGE_VERSION;
        image.width = width, image.height = height;
        image.format = PNG_FORMAT_RGB;
        return png_image_write_to_file(&image, path, 0, rgb_.data(), 0, nullptr) != 0;
    }

private:
    std::vector<uint8_t> rgb_ = std::vector<uint8_t>(size_t{3} * width * height, 255);
};

// A part of the picture: rows of pixels, and the row of height 0.
struct Strip {
    int top, rows;
    double zero;
};

// surface(pixel column): m.
template <class F> void fill(Picture& picture, const Strip& s, const F& surface) {
    for (int x = 0; x < width; ++x)
        for (int y = s.top; y < s.top + s.rows; ++y) {
            const double under = (y - s.zero) + scale * surface(x); // pixels
            const double wet = std::clamp(under + 0.5, 0.0, 1.0), depth = std::clamp(under / 140.0, 0.0, 1.0);
            const auto mix = [&](double a, double b, double c) { return a + wet * (b + depth * (c - b) - a); };
            picture.blend(x, y,
                          {mix(sky.r, shallow.r, deep.r), mix(sky.g, shallow.g, deep.g), mix(sky.b, shallow.b, deep.b)},
                          1.0);
            picture.blend(x, y, line, std::clamp(1.2 - std::abs(under), 0.0, 1.0));
        }
}

// The silhouette of an ellipsoid: in the picture's plane B = R A^2 R^T, and p.B^-1 p < 1.
void draw(Picture& picture, const Strip& s, const double* semi_axes, const lr_body_state& state, double x, Colour c,
          double alpha) {
    const float* const q = state.orientation;
    const double qx = static_cast<double>(q[0]), qy = static_cast<double>(q[1]), qz = static_cast<double>(q[2]),
                 qw = static_cast<double>(q[3]);
    const double rows[2][3] = {{1 - 2 * (qy * qy + qz * qz), 2 * (qx * qy - qw * qz), 2 * (qx * qz + qw * qy)},
                               {2 * (qx * qy + qw * qz), 1 - 2 * (qx * qx + qz * qz), 2 * (qy * qz - qw * qx)}};
    double b[2][2] = {};
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
            for (int k = 0; k < 3; ++k) {
                const double a = std::max(semi_axes[k] * scale, 0.8); // nothing is thinner than a pixel can show
                b[i][j] += rows[i][k] * rows[j][k] * a * a;
            }
    const double determinant = b[0][0] * b[1][1] - b[0][1] * b[0][1],
                 y = s.zero - scale * static_cast<double>(state.position[1]);
    const double reach_x = std::sqrt(b[0][0]) + 1.0, reach_y = std::sqrt(b[1][1]) + 1.0;
    for (int py = std::max(s.top, static_cast<int>(y - reach_y)); py <= y + reach_y && py < s.top + s.rows; ++py)
        for (int px = static_cast<int>(x - reach_x); px <= x + reach_x; ++px) {
            const double dx = px - x, dy = y - py;
            const double ux = (b[1][1] * dx - b[0][1] * dy) / determinant,
                         uy = (b[0][0] * dy - b[0][1] * dx) / determinant;
            const double root = std::sqrt(dx * ux + dy * uy), slope = std::sqrt(ux * ux + uy * uy);
            // Pixels to the rim.
            const double inside = root > 1e-9 ? (1.0 - root) * root / std::max(slope, 1e-9) : 1e9;
            const double shade = 1.0 - 0.25 * root;
            picture.blend(px, py, {c.r * shade, c.g * shade, c.b * shade}, alpha * std::clamp(inside + 0.5, 0.0, 1.0));
        }
}

struct Kind {
    double semi_axes[3], density, ballast; // m, kg/m^3, m of the centre of mass below the middle
    Colour colour;
};

class Scene {
public:
    explicit Scene(const lr_water_desc& surface) {
        lr_world_desc d;
        need(lr_world_desc_init(&d, sizeof d));
        need(lr_world_create(&d, &world_));
        need(lr_world_set_water(world_, &surface));
    }
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;
    ~Scene() { lr_world_destroy(world_); }

    lr_batch batch(const Kind& kind, uint32_t capacity) {
        lr_ellipsoid_desc e;
        need(lr_ellipsoid_desc_init(&e, sizeof e));
        std::copy_n(kind.semi_axes, 3, e.semi_axes);
        e.density = kind.density;
        e.center_of_mass[1] = -kind.ballast;
        lr_asset* asset = nullptr;
        need(lr_asset_create_ellipsoid(&e, &asset));
        lr_batch_desc d;
        need(lr_batch_desc_init(&d, sizeof d));
        d.asset = asset;
        d.capacity = capacity;
        d.load_model = LR_LOADS_AERODYNAMIC;
        lr_batch out{};
        need(lr_batch_create(world_, &d, &out));
        lr_asset_release(asset); // the batch has its own reference
        return out;
    }
    lr_body add(lr_batch batch, float x, float y, float tilt) {
        lr_body_desc d;
        need(lr_body_desc_init(&d, sizeof d));
        d.position[0] = x, d.position[1] = y;
        d.orientation[2] = std::sin(0.5f * tilt), d.orientation[3] = std::cos(0.5f * tilt);
        lr_body body{};
        need(lr_body_create(world_, batch, &d, 1, &body));
        return body;
    }
    void step(int count) {
        for (int i = 0; i < count; ++i) need(lr_world_step(world_, 1.0f / 120.0f, 4));
    }
    lr_body_state state(lr_body body) const {
        lr_body_state s;
        need(lr_body_state_init(&s, sizeof s));
        need(lr_body_get_state(world_, body, &s));
        return s;
    }

private:
    lr_world* world_ = nullptr;
};

lr_water_desc still() {
    lr_water_desc d;
    need(lr_water_desc_init(&d, sizeof d));
    return d;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) return std::fprintf(stderr, "water_picture OUT.png\n"), 2;
    Picture picture;
    constexpr Colour ball{214, 92, 60}, board{176, 128, 74}, disc{70, 74, 82}, buoy{230, 190, 60}, cork{205, 160, 110};

    const Kind dropped[] = {{{0.08, 0.08, 0.08}, 350.0, 0.0, ball},
                            {{0.13, 0.012, 0.05}, 600.0, 0.0, board},
                            {{0.1, 0.004, 0.1}, 2000.0, 0.0, disc}};
    for (int n = 0; n < 3; ++n) {
        const Strip strip{n * (row + gap), row, n * (row + gap) + (n == 2 ? 0.3 : 0.55) * row};
        fill(picture, strip, [](int) { return 0.0; });
        Scene scene(still());
        const lr_body body = scene.add(scene.batch(dropped[n], 1), 0.0f, n == 2 ? 0.25f : 0.45f, n == 1 ? 0.9f : 0.35f);
        for (int i = 0; i < 36; ++i) {
            draw(picture, strip, dropped[n].semi_axes, scene.state(body), 22.0 + 35.5 * i, dropped[n].colour, 0.95);
            scene.step(12);
        }
    }

    lr_water_desc sea = still();
    sea.wave_count = 2;
    sea.waves[0] = {{1.0f, 0.0f, 0.0f}, 4.0f, 0.2f, 0.0f};
    sea.waves[1] = {{-1.0f, 0.0f, 0.0f}, 1.1f, 0.05f, 1.0f};
    const Strip strip{3 * (row + gap), sea_height, 3 * (row + gap) + 0.45 * sea_height};
    constexpr double seconds = 4.0;
    fill(picture, strip, [&](int x) {
        double sum = 0.0;
        for (const lr_wave& w : {sea.waves[0], sea.waves[1]}) {
            const double k = 2.0 * std::numbers::pi / static_cast<double>(w.length);
            sum += static_cast<double>(w.amplitude) *
                   std::cos(static_cast<double>(w.direction[0]) * k * x / scale - std::sqrt(9.81 * k) * seconds +
                            static_cast<double>(w.phase));
        }
        return sum;
    });
    const Kind afloat[] = {{{0.09, 0.09, 0.09}, 300.0, 0.0, ball},
                           {{0.22, 0.02, 0.1}, 500.0, 0.0, board},
                           {{0.04, 0.22, 0.04}, 600.0, 0.1, buoy},
                           {{0.03, 0.03, 0.03}, 200.0, 0.0, cork}};
    Scene scene(sea);
    std::vector<lr_body> bodies[4];
    for (int k = 0; k < 4; ++k) {
        const lr_batch batch = scene.batch(afloat[k], 16);
        const int count = k == 3 ? 12 : 5;
        for (int i = 0; i < count; ++i)
            bodies[k].push_back(scene.add(batch,
                                          -0.3f + 8.0f / static_cast<float>(count) *
                                                      (static_cast<float>(i) + 0.21f * static_cast<float>(k)),
                                          0.8f, k == 1 ? 0.4f * static_cast<float>(i) : 0.3f));
    }
    scene.step(static_cast<int>(seconds * 120.0));
    for (int k = 0; k < 4; ++k)
        for (lr_body body : bodies[k]) {
            const lr_body_state s = scene.state(body);
            draw(picture, strip, afloat[k].semi_axes, s, scale * static_cast<double>(s.position[0]), afloat[k].colour,
                 1.0);
        }
    return picture.write(argv[1]) ? 0 : 1;
}
