// SPDX-License-Identifier: MIT
#include "renderer/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "failure.h"
#include "renderer/gl.h"
#include "renderer/program.h"
#include "renderer/shaders.h"

namespace {

using Matrix = std::array<float, 16>; // column-major, as in OpenGL

constexpr float tan_half_view = 0.404f; // vertical: 44 degrees

struct Picked {
    std::uint32_t index, noise_seed;
};

} // namespace

struct Renderer::Camera {
    float eye[3], right[3], up[3], back[3]; // m; unit vectors
    float aspect, near, far, pixels;        // pixels: height of the frame

    // Distance ahead; negative if the sphere cannot be in the picture.
    float ahead(float x, float y, float z, float radius) const {
        const float d[3] = {x - eye[0], y - eye[1], z - eye[2]};
        const auto along = [&d](const float* axis) { return d[0] * axis[0] + d[1] * axis[1] + d[2] * axis[2]; };
        const float depth = -along(back);
        const float reach_y = tan_half_view * depth + 1.1f * radius,
                    reach_x = aspect * tan_half_view * depth + 1.3f * radius;
        const bool seen = depth > near - radius && std::abs(along(right)) < reach_x && std::abs(along(up)) < reach_y;
        return seen ? std::max(depth, near) : -1.0f;
    }

    // The view's rotation, with or without its translation.
    Matrix to_clip(bool moved) const {
        Matrix m{};
        const float* rows[3] = {right, up, back};
        float view[3][4];
        for (int i = 0; i < 3; ++i) {
            view[i][3] = 0.0f;
            for (int k = 0; k < 3; ++k) {
                view[i][k] = rows[i][k];
                if (moved) view[i][3] -= rows[i][k] * eye[k];
            }
        }
        for (std::size_t k = 0; k < 4; ++k) {
            m[4 * k + 0] = view[0][k] / (tan_half_view * aspect);
            m[4 * k + 1] = view[1][k] / tan_half_view;
            m[4 * k + 2] =
                view[2][k] * (far + near) / (near - far) + (k == 3 ? 2.0f * far * near / (near - far) : 0.0f);
            m[4 * k + 3] = -view[2][k];
        }
        return m;
    }

    // From clip space to directions: corners of the picture at depth 1.
    Matrix from_clip() const {
        Matrix m{};
        for (std::size_t k = 0; k < 3; ++k) {
            m[k] = right[k] * tan_half_view * aspect;
            m[4 + k] = up[k] * tan_half_view;
            m[12 + k] = -back[k];
        }
        m[15] = 1.0f;
        return m;
    }
};

Renderer::Renderer(int width, int height) : width_(width), height_(height) {
    body_program_ = make_program("body", std::string(shader_air) + shader_body_vertex,
                                 std::string(shader_air) + shader_body_fragment);
    sky_program_ =
        make_program("sky", std::string(shader_air) + shader_sky_vertex, std::string(shader_air) + shader_sky_fragment);
    glGenVertexArrays(1, &sky_array_);
    glGenBuffers(1, &picked_);

    GLint samples = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &samples);
    glGenFramebuffers(2, target_);
    glGenRenderbuffers(2, colour_);
    glGenRenderbuffers(1, &depth_);
    for (int i = 0; i < 2; ++i) {
        const GLsizei wanted = i == 0 ? std::min(4, samples) : 0;
        glBindRenderbuffer(GL_RENDERBUFFER, colour_[i]);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, wanted, GL_SRGB8_ALPHA8, width, height);
        glBindFramebuffer(GL_FRAMEBUFFER, target_[i]);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_[i]);
        if (i == 0) {
            glBindRenderbuffer(GL_RENDERBUFFER, depth_);
            glRenderbufferStorageMultisample(GL_RENDERBUFFER, wanted, GL_DEPTH_COMPONENT24, width, height);
            glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
        }
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
            throw Failure("OpenGL (" + name() + ") cannot make a frame of this size",
                          "try a smaller --width and --height");
        }
    }
}

Renderer::~Renderer() {
    for (Kind& kind : kinds_) {
        for (Level& level : kind.level) {
            glDeleteVertexArrays(1, &level.array);
            glDeleteBuffers(1, &level.vertices);
            glDeleteBuffers(1, &level.indices);
        }
        glDeleteTextures(1, &kind.texture);
        glDeleteBuffers(1, &kind.transforms);
    }
    glDeleteBuffers(1, &picked_);
    glDeleteVertexArrays(1, &sky_array_);
    glDeleteFramebuffers(2, target_);
    glDeleteRenderbuffers(2, colour_);
    glDeleteRenderbuffers(1, &depth_);
    glDeleteProgram(body_program_);
    glDeleteProgram(sky_program_);
}

std::size_t Renderer::add_kind(const Mesh& mesh, Look look, std::uint32_t capacity) {
    GLint texels = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
    if (capacity > static_cast<std::uint32_t>(texels) / 3) {
        throw Failure("OpenGL (" + name() + ") can draw " + std::to_string(texels / 3) + " bodies of one asset at most",
                      "try a smaller --count, or leave --png out");
    }
    Kind kind{};
    kind.look = look;
    kind.radius = mesh.radius();
    if (!(kind.radius > 0.0f)) throw Failure("a mesh to draw has no size", "give another --mesh");
    kind.capacity = capacity;
    for (int k = 0; k < levels; ++k) {
        const Mesh coarse = k == 0 ? mesh : coarser(mesh, kind.radius * (k == 1 ? 0.2f : 0.5f));
        Level& level = kind.level[k];
        level.index_count = static_cast<int>(coarse.indices.size());
        glGenVertexArrays(1, &level.array);
        glBindVertexArray(level.array);
        glGenBuffers(1, &level.vertices);
        glBindBuffer(GL_ARRAY_BUFFER, level.vertices);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(coarse.vertices.size() * sizeof(Vertex)),
                     coarse.vertices.data(), GL_STATIC_DRAW);
        const auto attribute = [](GLuint place, GLint size, std::size_t offset) {
            glEnableVertexAttribArray(place);
            glVertexAttribPointer(place, size, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                                  reinterpret_cast<const void*>(offset));
        };
        attribute(0, 3, offsetof(Vertex, position));
        attribute(1, 3, offsetof(Vertex, normal));
        attribute(2, 2, offsetof(Vertex, uv));
        glBindBuffer(GL_ARRAY_BUFFER, picked_);
        glEnableVertexAttribArray(3);
        glVertexAttribIPointer(3, 2, GL_UNSIGNED_INT, sizeof(Picked), nullptr);
        glVertexAttribDivisor(3, 1);
        glGenBuffers(1, &level.indices);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, level.indices);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(coarse.indices.size() * sizeof(std::uint32_t)),
                     coarse.indices.data(), GL_STATIC_DRAW);
    }
    glBindVertexArray(0);
    glGenBuffers(1, &kind.transforms);
    glBindBuffer(GL_TEXTURE_BUFFER, kind.transforms);
    glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(capacity) * 48, nullptr, GL_STREAM_DRAW);
    glGenTextures(1, &kind.texture);
    glBindTexture(GL_TEXTURE_BUFFER, kind.texture);
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, kind.transforms);
    kinds_.push_back(kind);
    return kinds_.size() - 1;
}

void Renderer::draw_kind(const lr_world* world, const Bodies& bodies, const Camera& camera) {
    const Kind& kind = kinds_.at(bodies.kind);
    // The library writes into the mapped buffer; the shader reads the matrices' rows from it.
    glBindBuffer(GL_TEXTURE_BUFFER, kind.transforms);
    void* mapped = glMapBufferRange(GL_TEXTURE_BUFFER, 0, static_cast<GLsizeiptr>(kind.capacity) * 48,
                                    GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
    if (!mapped) throw Failure("OpenGL (" + name() + ") cannot map the buffer of transforms", "try a smaller --count");
    const lr_status status =
        lr_batch_write_transforms(world, bodies.batch, LR_TRANSFORM_3X4_ROW_MAJOR, mapped, 0, kind.capacity, nullptr);
    glUnmapBuffer(GL_TEXTURE_BUFFER);
    check(status, "lr_batch_write_transforms");

    lr_batch_view view;
    check(lr_batch_view_init(&view, sizeof view), "lr_batch_view_init");
    check(lr_batch_get_view(world, bodies.batch, &view), "lr_batch_get_view");
    std::vector<Picked> picked[levels];
    for (std::uint32_t i = 0; i < view.count; ++i) {
        const float radius = kind.radius * view.scale[i];
        const float depth = camera.ahead(view.position[0][i], view.position[1][i], view.position[2][i], radius);
        if (depth < 0.0f) continue;
        const float seen = radius * camera.pixels / (tan_half_view * depth); // px, its diameter
        picked[seen > 32.0f ? 0 : seen > 9.0f ? 1 : 2].push_back({i, view.noise_seed[i]});
    }
    glUniform1i(glGetUniformLocation(body_program_, "look"), static_cast<int>(kind.look));
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_BUFFER, kind.texture);
    for (int k = 0; k < levels; ++k) {
        if (picked[k].empty()) continue;
        glBindVertexArray(kind.level[k].array);
        glBindBuffer(GL_ARRAY_BUFFER, picked_);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(picked[k].size() * sizeof(Picked)), picked[k].data(),
                     GL_STREAM_DRAW);
        glDrawElementsInstanced(GL_TRIANGLES, kind.level[k].index_count, GL_UNSIGNED_INT, nullptr,
                                static_cast<GLsizei>(picked[k].size()));
    }
}

View view_of(const storm::Box& box) {
    const float h = box.size(1);
    return {{0.5f * (box.low[0] + box.high[0]), box.low[1] + 0.16f * h, box.low[2] + 0.88f * box.size(2)},
            0.13f,
            0.014f * h,
            10.0f * h,
            2.4f * h,
            {0.38f, 0.27f, -0.8847f}};
}

void Frame::use(unsigned program) const {
    glUseProgram(program);
    glUniform3fv(glGetUniformLocation(program, "eye"), 1, view.eye);
    glUniform3fv(glGetUniformLocation(program, "sun"), 1, view.sun);
    glUniform1f(glGetUniformLocation(program, "haze"), view.haze);
    glUniformMatrix4fv(glGetUniformLocation(program, "to_clip"), 1, GL_FALSE, to_clip);
}

std::vector<std::uint8_t> Renderer::draw(const lr_world* world, const std::vector<Bodies>& all, const View& view,
                                         int width, int height, const std::function<void(const Frame&)>& first) {
    if (width > width_ || height > height_)
        throw Failure("a frame is larger than the renderer's largest size", "report it");
    Camera camera{};
    const float s = std::sin(view.pitch), c = std::cos(view.pitch);
    const float right[3] = {1.0f, 0.0f, 0.0f}, up[3] = {0.0f, c, s}, back[3] = {0.0f, -s, c};
    std::copy(view.eye, view.eye + 3, camera.eye);
    std::copy(right, right + 3, camera.right);
    std::copy(up, up + 3, camera.up);
    std::copy(back, back + 3, camera.back);
    camera.aspect = static_cast<float>(width) / static_cast<float>(height);
    camera.near = view.near;
    camera.far = view.far;
    camera.pixels = static_cast<float>(height);
    const Matrix to_clip = camera.to_clip(true);
    const Frame frame{view, to_clip.data()};

    glBindFramebuffer(GL_FRAMEBUFFER, target_[0]);
    glViewport(0, 0, width, height);
    glEnable(GL_FRAMEBUFFER_SRGB);
    glEnable(GL_MULTISAMPLE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (first) first(frame);
    frame.use(body_program_);
    glUniform1i(glGetUniformLocation(body_program_, "transforms"), 0);
    for (const Bodies& bodies : all) draw_kind(world, bodies, camera);
    // The sky last, only where nothing covers it.
    frame.use(sky_program_);
    glUniformMatrix4fv(glGetUniformLocation(sky_program_, "from_clip"), 1, GL_FALSE, camera.from_clip().data());
    glBindVertexArray(sky_array_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);

    glBindFramebuffer(GL_READ_FRAMEBUFFER, target_[0]);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target_[1]);
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, target_[1]);
    const std::size_t row = static_cast<std::size_t>(width) * 4, rows = static_cast<std::size_t>(height);
    std::vector<std::uint8_t> pixels(row * rows);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
        throw Failure("OpenGL (" + name() + ") failed with error " + std::to_string(error),
                      "report it, or leave --png out");
    }
    for (std::size_t y = 0; y < rows / 2; ++y) { // OpenGL's rows begin at the bottom
        std::swap_ranges(pixels.begin() + static_cast<std::ptrdiff_t>(y * row),
                         pixels.begin() + static_cast<std::ptrdiff_t>((y + 1) * row),
                         pixels.begin() + static_cast<std::ptrdiff_t>((rows - 1 - y) * row));
    }
    return pixels;
}
