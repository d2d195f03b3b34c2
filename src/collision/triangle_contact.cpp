#include "collision/triangle_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lr {
namespace {

constexpr uint8_t all_front = 7;
// An edge is a ridge if the next triangle falls below this one's plane by more than this share of a cell.
constexpr float ridge = 1e-3f;
// Whether the corner or edge farthest along the normal is hidden (hidden_edges). Corners within 1e-4 of the triangle's size count as equal.
bool is_hidden(const Triangle& t, Vector n) {
    const float side = dot(n, t.normal);
    if (std::abs(side) > 0.9999f) return false;
    const uint32_t bits = side >= 0.0f ? t.hidden & 7u : t.hidden >> 3 & 7u;
    if (bits == 0) return false;
    const Vector a = t.corners[1] - t.corners[0], b = t.corners[2] - t.corners[0], c = b - a;
    const float size = std::sqrt(std::max({dot(a, a), dot(b, b), dot(c, c)}));
    const float along[3] = {0.0f, dot(n, a), dot(n, b)};
    const float most = std::max({along[0], along[1], along[2]});
    uint32_t out = 0, first = 3;
    for (uint32_t i = 0; i < 3; ++i)
        if (most - along[i] <= 1e-4f * size) {
            out |= 1u << i;
            first = std::min(first, i);
        }
    if (out == 7) return false;
    const auto hidden = [&](uint32_t edge) { return (bits >> edge & 1u) != 0; };
    if ((out & (out - 1)) == 0) return hidden(first) && hidden((first + 2) % 3);
    return hidden(out == 3 ? 0 : out == 6 ? 1 : 2);
}

// A centre of mass does not pass through a surface, so it tells on which side of a triangle the body is: of one that it is over, or that is in line
// with another that it is over, as a tile beside its own. A thin body that is pressed in by its own height would otherwise count as on the other side.
Triangle side_of_center(const ContactPoints& set, const Triangle& t) {
    if (!set.before || !(dot(set.face, set.face) > 0.0f)) return t;
    const Vector center = set.before->position;
    const float lean = dot(t.normal, set.face), off = dot(t.normal, center - t.corners[0]);
    if (is_over(t, center)) return off == 0.0f ? t : one_side(t, off > 0.0f);
    const float deep = 0.5f * set.body.scale * set.body.shape->thickness;
    if (std::abs(lean) > facing && (lean > 0.0f ? off : -off) > -deep) return one_side(t, lean > 0.0f);
    return t;
}

// Along the triangle's normal on the given side; if that is 0, on the side of less overlap.
Separation separate_from_side(const ContactPoints& set, const Triangle& t, const PlacedCollider& collider,
                              Double3 side) {
    const Double3 normal = to_double(t.normal);
    const double along = dot(side, normal);
    if (t.one_sided || along == 0.0) return separate_from_plane(set.body, collider, normal, t.one_sided);
    return separate_from_plane(set.body, collider, along < 0.0 ? -normal : normal, true);
}

// Neighbours handle the surroundings of a hidden edge, so only the part of the body over the triangle counts. Beside a ridge the rest reaches below
// the triangle's plane, beyond its end.
void add_over_triangle(ContactPoints& set, const Triangle& t, const PlacedCollider& collider, bool apart,
                       Double3 side) {
    const Separation flat = separate_from_side(set, t, collider, side);
    if (set.body.count > 0) return add_patch(set, collider, flat);
    const Vector lowest = to_float(set.body.support(-flat.normal));
    if (!apart && is_over(t, set.body.at.position + lowest)) add_manifold(set, collider, flat);
}

// alone: the neighbours are not tested, so no edge is left to them.
void add_triangle(ContactPoints& set, const Triangle& t, bool alone = false) {
    const PlacedBody& body = set.body;
    const float reach = body.reach + body.radius, far = reach + set.margin;
    const Vector position = body.at.position;
    const float off = dot(t.normal, position - t.corners[0]);
    if (off > far || (!t.one_sided && off < -far)) return;
    if (!reaches(grown({position, position}, far), t)) return;
    const PlacedCollider collider(t.corners, position);
    const double enough = static_cast<double>(set.margin + body.radius);
    if (body.count > 0 && is_over(t, position, reach)) {
        const Separation flat = separate_from_side(set, t, collider, {});
        if (flat.distance < enough) add_manifold(set, collider, flat);
        return;
    }
    const Double3 normal = to_double(t.normal);
    Nearest nearest = nearest_points(body, collider, enough);
    if (!nearest.overlap && nearest.lower >= enough) {
        // Along a normal that leads to the front side no point of the body is behind the triangle.
        if (!t.one_sided || dot(nearest.normal, normal) > 0.0) return;
        nearest = nearest_points(body, collider, std::numeric_limits<double>::infinity());
    }
    // Behind a side and apart from it, beyond an edge: the neighbours handle that. Parted from this side, thin bodies rose into the air over steps.
    if (t.one_sided && !nearest.overlap && dot(nearest.normal, normal) <= 0.0 &&
        !is_over(t, position + to_float(nearest.on_body)))
        return add_over_triangle(set, t, collider, false, normal);
    const Separation along =
        separate(body, collider, nearest, t.one_sided ? Sides{normal, 0.0, set.up} : Sides{.up = set.up});
    if (along.distance >= enough) return;
    if (!is_hidden(t, to_float(along.normal))) return add_manifold(set, collider, along);
    // A body whose side is not known, as over the upper edge of a wall between two tiles, is up to the neighbours: across the wall the way out is long.
    if (!alone && !t.one_sided && set.before && !along.has_points) return;
    const Double3 side = along.has_points ? along.normal : Double3{};
    if (!alone) return add_over_triangle(set, t, collider, along.has_points, side);
    // Along the plane of its floor if all of the body is above it: an edge within a floor is no obstacle.
    const Separation flat = separate_from_side(set, t, collider, side);
    add_manifold(set, collider, flat.distance > 0.0 ? flat : along);
}

float sample(const HeightfieldGeometry& field, uint32_t i, uint32_t k) {
    return field.heights[size_t{k} * field.counts[0] + i];
}

Vector corner(const HeightfieldGeometry& field, uint32_t i, uint32_t k) {
    return {static_cast<float>(i) * field.spacing[0], sample(field, i, k), static_cast<float>(k) * field.spacing[1]};
}

// Bits of edges that are not ridges; borders of the field are not.
uint8_t hidden_edges(const HeightfieldGeometry& field, uint32_t i, uint32_t k, bool second, const Triangle& t) {
    const uint32_t columns = field.counts[0] - 1, rows = field.counts[1] - 1;
    const float below = -ridge * std::min(field.spacing[0], field.spacing[1]);
    const auto falls = [&](uint32_t ni, uint32_t nk) {
        return dot(t.normal, corner(field, ni, nk) - t.corners[0]) < below;
    };
    bool is_ridge[3];
    if (second) {
        is_ridge[0] = falls(i, k + 1);
        is_ridge[1] = i + 1 < columns && falls(i + 2, k + 1);
        is_ridge[2] = k > 0 && falls(i, k - 1);
    } else {
        is_ridge[0] = i > 0 && falls(i - 1, k);
        is_ridge[1] = k + 1 < rows && falls(i + 1, k + 2);
        is_ridge[2] = falls(i + 1, k);
    }
    uint8_t hidden = 0;
    for (uint32_t e = 0; e < 3; ++e) hidden = static_cast<uint8_t>(hidden | (is_ridge[e] ? 0u : 1u << e));
    return hidden;
}

void add_points(ContactPoints& set, const HeightfieldGeometry& field) {
    const PlacedBody& body = set.body;
    const Vector position = body.at.position;
    const auto add = [&](Vector core) {
        const Vector p = position + core;
        if (!field.covers(p.x, p.z) || p.y - body.radius - set.margin > field.highest) return;
        const HeightPoint below = height_at(field, p.x, p.z);
        const float gap = (p.y - below.height) * below.normal.y;
        if (gap - body.radius >= set.margin) return;
        // Beside a ridge the slope's plane is no surface any more: triangles are tested instead.
        if (gap > 0.0f && below.normal.y < 0.999f) {
            const Vector foot = p - gap * below.normal;
            const float off = foot.y - height_at(field, foot.x, foot.z).height;
            const float rounding = 1e-6f * (std::abs(p.x) + std::abs(p.y) + std::abs(p.z));
            if (off > 1e-3f * gap + rounding) return;
        }
        set.add_core(core, below.normal, gap);
    };
    for (uint32_t i = 0; i < body.count; ++i) add(body.point(i));
    if (body.count > 0) return;
    // Iterates: the ellipsoid's point towards the triangle below, then the triangle below that point.
    Vector normal{0.0f, 1.0f, 0.0f};
    for (uint32_t round = 0; round < 4; ++round) {
        const Vector p = position + to_float(body.support(-to_double(normal)));
        if (!field.covers(p.x, p.z)) return;
        const Vector next = height_at(field, p.x, p.z).normal;
        const Vector change = next - normal;
        if (dot(change, change) < 1e-10f) break;
        normal = next;
    }
    add(to_float(body.support(-to_double(normal))));
}
} // namespace

bool is_over(const Triangle& t, Vector point, float reach) {
    for (uint32_t i = 0; i < 3; ++i) {
        const Vector edge = t.corners[(i + 1) % 3] - t.corners[i];
        const float in = dot(cross(t.normal, edge), point - t.corners[i]);
        if (in < 0.0f || in * in < reach * reach * dot(edge, edge)) return false;
    }
    return true;
}

Vector face_of_center(const MeshGeometry& mesh, ColliderPart part, Vector center, float& least) {
    Vector face{};
    for (uint32_t i = part.first; i < part.first + part.count && i < mesh.triangle_count; ++i) {
        const Triangle t = mesh_triangle(mesh, i);
        const float off = dot(t.normal, center - t.corners[0]);
        if (off == 0.0f || !(std::abs(off) < least) || !(dot(t.normal, t.normal) > 0.5f) || !is_over(t, center))
            continue;
        least = std::abs(off);
        face = off > 0.0f ? t.normal : -t.normal;
    }
    return face;
}

Triangle mesh_triangle(const MeshGeometry& mesh, uint32_t index) {
    Triangle t{};
    for (uint32_t k = 0; k < 3; ++k)
        t.corners[k] = vector_of(mesh.vertices + size_t{3} * mesh.indices[size_t{3} * index + k]);
    t.normal = vector_of(mesh.normals + size_t{3} * index);
    t.hidden = mesh.hidden_edges[index] & 63u;
    t.turned = (mesh.hidden_edges[index] & turned_triangle) != 0;
    return t;
}

Triangle one_side(Triangle t, bool front) {
    if (!front) { // this reverses the order of edges
        std::swap(t.corners[1], t.corners[2]);
        t.normal = -t.normal;
        const auto bit = [&](uint32_t edge) { return static_cast<uint32_t>(t.hidden) >> (3 + edge) & 1u; };
        t.hidden = static_cast<uint8_t>(bit(2) | bit(1) << 1 | bit(0) << 2);
    }
    t.hidden &= all_front;
    t.one_sided = true;
    return t;
}

HeightPoint height_at(const HeightfieldGeometry& field, float x, float z) {
    const auto cell = [](float at, float spacing, uint32_t count, float& fraction) {
        const float most = static_cast<float>(count - 2);
        float number = std::floor(at / spacing);
        number = number > 0.0f ? (number < most ? number : most) : 0.0f;
        fraction = at / spacing - number;
        return static_cast<uint32_t>(number);
    };
    float fx, fz;
    const uint32_t i = cell(x, field.spacing[0], field.counts[0], fx);
    const uint32_t k = cell(z, field.spacing[1], field.counts[1], fz);
    const float h00 = sample(field, i, k), h11 = sample(field, i + 1, k + 1);
    float dx, dz;
    if (fz > fx) {
        const float h01 = sample(field, i, k + 1);
        dx = h11 - h01;
        dz = h01 - h00;
    } else {
        const float h10 = sample(field, i + 1, k);
        dx = h10 - h00;
        dz = h11 - h10;
    }
    const float sx = dx / field.spacing[0], sz = dz / field.spacing[1];
    const float up = 1.0f / std::sqrt(1.0f + sx * sx + sz * sz);
    return {h00 + dx * fx + dz * fz, {-sx * up, up, -sz * up}};
}

bool reaches(const Box& box, const Triangle& t) {
    const Vector(&c)[3] = t.corners;
    const Box own{low_of(c[0], low_of(c[1], c[2])), high_of(c[0], high_of(c[1], c[2]))};
    return overlap(box, own);
}

Cells cells_between(const HeightfieldGeometry& field, const Box& box) {
    Cells out{};
    const float low[2] = {box.low.x, box.low.z}, high[2] = {box.high.x, box.high.z};
    for (uint32_t a = 0; a < 2; ++a) {
        const float cells = static_cast<float>(field.counts[a] - 1);
        const float from = std::floor(low[a] / field.spacing[a]), to = std::floor(high[a] / field.spacing[a]) + 1.0f;
        out.first[a] = static_cast<uint32_t>(from > 0.0f ? (from < cells ? from : cells) : 0.0f);
        out.last[a] = static_cast<uint32_t>(to > 0.0f ? (to < cells ? to : cells) : 0.0f);
    }
    return out;
}

Triangle field_triangle(const HeightfieldGeometry& field, uint32_t i, uint32_t k, bool second) {
    Triangle t{};
    t.corners[0] = corner(field, i, k);
    t.corners[1] = second ? corner(field, i + 1, k + 1) : corner(field, i, k + 1);
    t.corners[2] = second ? corner(field, i + 1, k) : corner(field, i + 1, k + 1);
    const Vector n = cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0]);
    t.normal = 1.0f / length(n) * n;
    t.hidden = all_front;
    t.one_sided = true;
    return t;
}

void add_mesh(ContactPoints& set, const MeshGeometry& mesh, ColliderPart part, bool alone) {
    for (uint32_t i = part.first; i < part.first + part.count && i < mesh.triangle_count; ++i) {
        const Triangle t = mesh_triangle(mesh, i);
        if (!(dot(t.normal, t.normal) > 0.5f)) continue;
        if (set.side == 0) {
            add_triangle(set, side_of_center(set, t), alone);
            continue;
        }
        const Triangle known = one_side(t, (set.side > 0) != t.turned);
        // Nothing leaves through a face that its centre of mass was behind, as the outer face of a wall or the far side of a board.
        if (!(set.before && dot(known.normal, set.before->position - t.corners[0]) < 0.0f))
            add_triangle(set, known, alone);
    }
}

void add_ridges(ContactPoints& set, const Triangle& t) {
    if (t.hidden == all_front) return;
    const Vector n = t.normal;
    const float near = dot(n, set.body.at.position - t.corners[0] + to_float(set.body.support(-to_double(n))));
    if (near <= set.margin + set.body.radius) add_triangle(set, t);
}

void add_heightfield(ContactPoints& set, const HeightfieldGeometry& field) {
    const PlacedBody& body = set.body;
    const Vector p = body.at.position;
    const float far = body.reach + body.radius + set.margin;
    if (p.y - far > field.highest) return;
    add_points(set, field);
    const Cells cells = cells_between(field, grown({p, p}, far));
    for (uint32_t k = cells.first[1]; k < cells.last[1]; ++k)
        for (uint32_t i = cells.first[0]; i < cells.last[0]; ++i) {
            const float highest = std::max(
                {sample(field, i, k), sample(field, i + 1, k), sample(field, i, k + 1), sample(field, i + 1, k + 1)});
            if (p.y - far > highest) continue;
            for (const bool second : {false, true}) {
                Triangle t = field_triangle(field, i, k, second);
                const float off = dot(t.normal, p - t.corners[0]);
                if (off > far) continue;
                t.hidden = hidden_edges(field, i, k, second, t);
                add_ridges(set, t);
            }
        }
}
} // namespace lr
