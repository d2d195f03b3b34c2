// SPDX-License-Identifier: MIT
#include "renderer/scenery.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>

#include "failure.h"
#include "renderer/gl.h"
#include "renderer/program.h"
#include "renderer/shaders.h"
#include "renderer/shaders_scenery.h"

namespace {

constexpr std::size_t most_boxes = 12; // in the shader

using Matrix = std::array<float, 16>; // by columns

Quaternion quaternion_of(const float* q) {
    return {static_cast<double>(q[0]), static_cast<double>(q[1]), static_cast<double>(q[2]), static_cast<double>(q[3])};
}
Vector vector_of(const float* v) {
    return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

Matrix to_world(const Park::Piece& piece) {
    const Quaternion q = quaternion_of(piece.orientation);
    Matrix m{};
    for (std::size_t column = 0; column < 3; ++column) {
        Vector axis{};
        axis[column] = 1.0;
        const Vector image = turned(q, axis);
        for (std::size_t row = 0; row < 3; ++row) m[4 * column + row] = static_cast<float>(image[row]);
        m[12 + column] = piece.position[column];
    }
    m[15] = 1.0f;
    return m;
}

Vector half_extents(const Mesh& mesh) {
    Vector half{};
    for (const Vertex& vertex : mesh.vertices)
        for (std::size_t k = 0; k < 3; ++k)
            half[k] = std::max(half[k], std::abs(static_cast<double>(vertex.position[k])));
    return half;
}

// Maps the world to a box from -1 to 1 along each axis.
Matrix to_box(const Park::Piece& piece) {
    const Quaternion back = inverse(quaternion_of(piece.orientation));
    const Vector half = half_extents(piece.mesh), middle = turned(back, vector_of(piece.position));
    Matrix m{};
    for (std::size_t column = 0; column < 3; ++column) {
        Vector axis{};
        axis[column] = 1.0;
        const Vector image = turned(back, axis);
        for (std::size_t row = 0; row < 3; ++row) m[4 * column + row] = static_cast<float>(image[row] / half[row]);
        m[12 + column] = static_cast<float>(-middle[column] / half[column]);
    }
    m[15] = 1.0f;
    return m;
}

} // namespace

Scenery::Scenery(const Park& park) : park_(park) {
    solid_program_ = make_program("solid", std::string(shader_air) + shader_solid_vertex,
                                  std::string(shader_air) + shader_solid_fragment);
    shadow_program_ = make_program("shadow", std::string(shader_air) + shader_shadow_vertex,
                                   std::string(shader_air) + shader_shadow_fragment);
    const auto attribute = [](GLuint place, GLint size, std::size_t stride, std::size_t offset) {
        glEnableVertexAttribArray(place);
        glVertexAttribPointer(place, size, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                              reinterpret_cast<const void*>(offset));
    };
    for (const Park::Piece& from : park.pieces()) {
        Piece piece;
        piece.index_count = static_cast<int>(from.mesh.indices.size());
        glGenVertexArrays(1, &piece.array);
        glBindVertexArray(piece.array);
        glGenBuffers(1, &piece.vertices);
        glBindBuffer(GL_ARRAY_BUFFER, piece.vertices);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(from.mesh.vertices.size() * sizeof(Vertex)),
                     from.mesh.vertices.data(), GL_STATIC_DRAW);
        attribute(0, 3, sizeof(Vertex), offsetof(Vertex, position));
        attribute(1, 3, sizeof(Vertex), offsetof(Vertex, normal));
        glGenBuffers(1, &piece.indices);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, piece.indices);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(from.mesh.indices.size() * sizeof(std::uint32_t)),
                     from.mesh.indices.data(), GL_STATIC_DRAW);
        pieces_.push_back(piece);
    }
    glGenVertexArrays(1, &shadow_array_);
    glBindVertexArray(shadow_array_);
    glGenBuffers(1, &shadow_buffer_);
    glBindBuffer(GL_ARRAY_BUFFER, shadow_buffer_);
    attribute(0, 4, sizeof(Shadow), offsetof(Shadow, middle));
    attribute(1, 3, sizeof(Shadow), offsetof(Shadow, along));
    attribute(2, 3, sizeof(Shadow), offsetof(Shadow, across));
    attribute(3, 1, sizeof(Shadow), offsetof(Shadow, soft));
    for (GLuint place = 0; place < 4; ++place) glVertexAttribDivisor(place, 1);
    glBindVertexArray(0);
}

Scenery::~Scenery() {
    for (Piece& piece : pieces_) {
        glDeleteVertexArrays(1, &piece.array);
        glDeleteBuffers(1, &piece.vertices);
        glDeleteBuffers(1, &piece.indices);
    }
    glDeleteVertexArrays(1, &shadow_array_);
    glDeleteBuffers(1, &shadow_buffer_);
    glDeleteProgram(solid_program_);
    glDeleteProgram(shadow_program_);
}

void Scenery::add_kind(lr_batch batch, const Mesh& mesh) {
    const Vector half = half_extents(mesh);
    std::array<std::size_t, 3> order{};
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return half[a] > half[b]; });
    Kind kind{batch, {}, {}};
    kind.long_axis[order[0]] = half[order[0]];
    kind.wide_axis[order[1]] = half[order[1]];
    kinds_.push_back(kind);
}

// Projects along the sun's rays onto the ground below; the higher the body, the paler and softer the shadow.
void Scenery::collect(const lr_world* world, const Kind& kind, const Frame& frame) {
    lr_batch_view view;
    check(lr_batch_view_init(&view, sizeof view), "lr_batch_view_init");
    check(lr_batch_get_view(world, kind.batch, &view), "lr_batch_get_view");
    const Vector sun = vector_of(frame.view.sun);
    for (std::uint32_t i = 0; i < view.count; ++i) {
        const auto value = [i](const float* field) { return static_cast<double>(field[i]); };
        Vector middle{value(view.position[0]), value(view.position[1]), value(view.position[2])};
        Terrain::Place ground = park_.terrain().at(middle[0], middle[2]);
        double height = middle[1] - ground.height;
        if (height > 1.5 || height < -0.1) continue;
        if (height > 0.05) { // its shadow falls elsewhere
            middle = minus(middle, times(height / sun[1], sun));
            ground = park_.terrain().at(middle[0], middle[2]);
            if (park_.furnished(middle[0], middle[2], 0.0)) continue;
        }
        middle[1] = ground.height + 0.001;
        const double steep = dot(ground.normal, sun);
        const Quaternion q{value(view.orientation[0]), value(view.orientation[1]), value(view.orientation[2]),
                           value(view.orientation[3])};
        const auto cast = [&](const Vector& axis) {
            const Vector a = times(value(view.scale), turned(q, axis));
            return minus(a, times(dot(a, ground.normal) / std::max(0.3, steep), sun));
        };
        const Vector along = cast(kind.long_axis), across = cast(kind.wide_axis);
        const double size = std::sqrt(std::sqrt(dot(along, along) * dot(across, across))), blur = 0.010 + 0.03 * height;
        Shadow shadow{};
        shadow.soft = static_cast<float>(std::clamp(blur / std::max(size, 1e-6), 0.1, 1.0));
        shadow.dark = static_cast<float>(0.72 * (1.0 - height / 1.5) / (1.0 + 1.5 * height));
        for (std::size_t k = 0; k < 3; ++k) {
            shadow.middle[k] = static_cast<float>(middle[k]);
            shadow.along[k] = static_cast<float>(along[k]);
            shadow.across[k] = static_cast<float>(across[k]);
        }
        shadows_.push_back(shadow);
    }
}

void Scenery::draw_pieces(const Frame& frame) const {
    frame.use(solid_program_);
    const auto place = [this](const char* name) { return glGetUniformLocation(solid_program_, name); };
    const float* walker = park_.walker();
    glUniform4f(place("walker"), walker ? walker[0] : 0.0f, walker ? walker[1] : 0.0f, walker ? walker[2] : 0.0f,
                walker ? Park::walker_radius : 0.0f);
    glUniform1f(place("walker_half_length"), Park::walker_half_length);
    std::vector<Matrix> boxes;
    int round_from = 0;
    for (const Park::Piece& piece : park_.pieces()) {
        const bool stands = piece.surface == Park::Surface::wood || piece.surface == Park::Surface::stone;
        if (!stands || boxes.size() == most_boxes) continue;
        boxes.push_back(to_box(piece));
        if (!piece.round) round_from = static_cast<int>(boxes.size());
    }
    glUniform1i(place("round_from"), round_from);
    glUniform1i(place("box_count"), static_cast<int>(boxes.size()));
    glUniformMatrix4fv(place("to_box"), static_cast<GLsizei>(boxes.size()), GL_FALSE, boxes.front().data());
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
        const Park::Piece& piece = park_.pieces()[k];
        if (piece.surface == Park::Surface::cloth && !walker) continue;
        glUniformMatrix4fv(place("to_world"), 1, GL_FALSE, to_world(piece).data());
        glUniform1i(place("surface"), static_cast<int>(piece.surface));
        glBindVertexArray(pieces_[k].array);
        glDrawElements(GL_TRIANGLES, pieces_[k].index_count, GL_UNSIGNED_INT, nullptr);
    }
}

void Scenery::draw(const lr_world* world, const Frame& frame) {
    draw_pieces(frame);
    shadows_.clear();
    for (const Kind& kind : kinds_) collect(world, kind, frame);
    if (shadows_.empty()) return;
    frame.use(shadow_program_);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-1.0f, -4.0f);
    glDepthMask(GL_FALSE);
    glBindVertexArray(shadow_array_);
    glBindBuffer(GL_ARRAY_BUFFER, shadow_buffer_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(shadows_.size() * sizeof(Shadow)), shadows_.data(),
                 GL_STREAM_DRAW);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(shadows_.size()));
    glBindVertexArray(0);
    glDepthMask(GL_TRUE);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_BLEND);
}
