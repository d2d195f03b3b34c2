#include "collision/mesh_floor.h"

#include "base/scratch.h"
#include "collision/triangle_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lr {
namespace {

// Cosine between a floor's steepest triangle and its mean normal, 57 degrees. Two such triangles differ by less than 120 degrees, where
// one would count as the other's back: up to two fifths of cards went through a groove of 65 degrees.
constexpr float steepest = 0.55f;
// Cosine between normals that differ by 0.2, as over heightfields. Sharper edges need contacts of their own.
constexpr float sharp = 0.98f;
// Share of the thickness: closer to the surface, rounding decides on which side a centre of mass is.
constexpr float clear = 0.125f;
// Least size of uneven triangles: the margin over this factor. A body could fall through several smaller ones.
constexpr float fine = 1.5f;
// Triangles are enlarged by this share of the reach, so that no point falls between two; those within it of one plane are one face.
constexpr float seam = 1e-4f;
// Share of the reach by which contacts can press a body beyond a surface; leave_floors() undoes overlaps of much more than a tenth.
constexpr float pressed = 0.125f;

bool crosses(const Box& box, const Triangle& t) {
    if (!reaches(box, t)) return false;
    const Vector half = 0.5f * (box.high - box.low);
    const float reach = std::abs(t.normal.x) * half.x + std::abs(t.normal.y) * half.y + std::abs(t.normal.z) * half.z;
    return std::abs(dot(t.normal, middle_of(box) - t.corners[0])) <= reach;
}

// Whether an edge without a neighbour is near.
bool ends_in(const Box& box, const Triangle& t) {
    for (uint32_t k = 0; k < 3; ++k) {
        if ((t.hidden >> k & 1u) != 0 || (t.hidden >> (3 + k) & 1u) != 0) continue;
        const Vector a = t.corners[k], b = t.corners[(k + 1) % 3];
        if (overlap(box, {low_of(a, b), high_of(a, b)})) return true;
    }
    return false;
}

// A triangle seen from above, along `up`. Origin: a place near the body.
struct FloorFace {
    Vector normal; // upwards
    float offset, lean;
    Vector inward[3]; // across the edges
    float edge[3];

    FloorFace() = default;
    FloorFace(const Triangle& t, Vector origin, Vector up)
        : normal(dot(t.normal, up) > 0.0f ? t.normal : -t.normal), offset(dot(normal, t.corners[0] - origin)),
          lean(1.0f / dot(normal, up)) {
        const float turn = dot(t.normal, up) > 0.0f ? 1.0f : -1.0f;
        for (uint32_t k = 0; k < 3; ++k) {
            const Vector across = cross(up, t.corners[(k + 1) % 3] - t.corners[k]);
            const float size = turn * length(across);
            inward[k] = size != 0.0f ? 1.0f / size * across : across;
            edge[k] = dot(inward[k], t.corners[k] - origin);
        }
    }
    // Least distance from the edges, seen along `up`; negative: outside.
    float inside(Vector p) const {
        return std::min({dot(inward[0], p) - edge[0], dot(inward[1], p) - edge[1], dot(inward[2], p) - edge[2]});
    }
    float gap(Vector p) const { return dot(normal, p) - offset; }
    // Height above the triangle along `up`.
    float height(Vector p) const { return lean * gap(p); }
};

// The triangles under a body.
class FloorFaces {
public:
    FloorFaces(const MeshGeometry& mesh, const MeshFloor& floor, Vector origin, float reach) : seam_(-seam * reach) {
        for (uint32_t k = 0; k < floor.count; ++k) {
            face_[count_] = FloorFace(mesh_triangle(mesh, floor.triangles[k]), origin, floor.up);
            if (face_[count_].inside({0.0f, 0.0f, 0.0f}) >= -reach) ++count_;
        }
        const auto apart = [&](const FloorFace& a, const FloorFace& b) {
            return std::abs(a.offset - b.offset) + reach * length(a.normal - b.normal);
        };
        uint32_t level = 1;
        while (level < count_ && apart(face_[0], face_[level]) < seam * reach) ++level;
        if (level < count_ || count_ < 2) return;
        count_ = 1; // a floor has no border near the body
        for (uint32_t e = 0; e < 3; ++e) face_[0].inward[e] = {}, face_[0].edge[e] = -1.0f;
    }
    uint32_t count() const { return count_; }
    const FloorFace& face(uint32_t k) const { return face_[k]; }
    // The highest surface under a place, and the height above it; null outside.
    const FloorFace* under(Vector p, float& height) const {
        const FloorFace* best = nullptr;
        height = std::numeric_limits<float>::infinity();
        for (const FloorFace* f = face_; f != face_ + count_; ++f)
            if (const float h = f->height(p); h < height && f->inside(p) >= seam_) height = h, best = f;
        return best;
    }

private:
    FloorFace face_[MeshFloor::most];
    uint32_t count_ = 0;
    float seam_; // m
};

static_assert(InScratch<FloorFaces>::size <= floor_scratch);

void add_points(ContactPoints& set, const FloorFaces& faces, bool even) {
    const PlacedBody& body = set.body;
    const BodyShape& shape = *body.shape;
    const uint32_t count = even ? shape.sample_count : shape.count;
    for (uint32_t i = 0; i < count; ++i) {
        const Vector core = i < shape.count ? body.point(i) : rotate(body.at.rotation, body.scale * shape.point(i));
        float height;
        const FloorFace* const face = faces.under(core, height);
        if (!face) continue;
        const float gap = face->gap(core);
        if (gap - body.radius >= set.margin) continue;
        // Beside a ridge the slope's plane is no surface any more: triangles are tested instead.
        if (!even && gap > 0.0f) {
            float off;
            if (!faces.under(core - gap * face->normal, off) || off > 1e-3f * gap + seam * body.reach) continue;
        }
        set.add_core(core, face->normal, gap);
    }
}

// In a valley an ellipsoid touches each triangle. On a ridge its nearest points to each triangle may lie outside them; the point towards the triangle
// below that point is on one.
void add_ellipsoid(ContactPoints& set, const FloorFaces& faces, Vector up) {
    const PlacedBody& body = set.body;
    const auto add = [&](Vector core, const FloorFace& face) {
        const float gap = face.gap(core);
        if (gap >= set.margin) return;
        set.add(core, face.normal, gap);
        add_rims(set, to_double(face.normal), gap, [&](Vector point, Vector& direction) {
            float height;
            const FloorFace* const below = faces.under(point, height);
            if (!below) return std::numeric_limits<double>::infinity();
            direction = below->normal;
            return static_cast<double>(below->gap(point));
        });
    };
    const auto towards = [&](Vector normal) { return to_float(body.support(-to_double(normal))); };
    for (uint32_t k = 0; k < faces.count(); ++k)
        if (const Vector p = towards(faces.face(k).normal); faces.face(k).inside(p) >= 0.0f) add(p, faces.face(k));
    if (set.count() > 0) return;
    Vector normal = up, p{};
    const FloorFace* below = nullptr;
    for (uint32_t round = 0; round < 4; ++round) {
        float height;
        p = towards(normal);
        below = faces.under(p, height);
        if (!below) return;
        normal = below->normal;
    }
    add(p, *below);
}

float height_over(const MeshGeometry& mesh, const MeshFloor& floor, Vector place, float if_none) {
    float height;
    const InScratch<FloorFaces> faces(mesh, floor, place, 0.0f);
    return faces->under({}, height) ? height : if_none;
}

// Whether a body on the `known` side of a surface can be on that side of these triangles, pressed in by at most `deep`. If not, they are another
// sheet, such as the ceiling above its floor.
bool can_be_on(const MeshGeometry& mesh, const uint32_t* triangles, uint32_t count, Vector known, Vector place,
               float deep) {
    bool near = false;
    for (uint32_t k = 0; k < count; ++k) {
        const Triangle t = mesh_triangle(mesh, triangles[k]);
        const float lean = dot(t.normal, known), off = dot(t.normal, place - t.corners[0]);
        if (std::abs(lean) <= facing) continue;
        if ((lean > 0.0f ? off : -off) > -deep)
            near = true;
        else if (FloorFace(t, place, known).inside({}) >= 0.0f)
            return false;
    }
    return near;
}
} // namespace

Vector way_out(const BodyShape& shape, float scale, Vector position, const MeshGeometry& mesh, const MeshFloor& floor) {
    const float least = clear * scale * shape.thickness;
    return std::max(2.0f * least - height_over(mesh, floor, position, 2.0f * least), 0.0f) * floor.up;
}

void find_floor(const BodyShape& shape, float scale, const Pose& from, const Pose& to, float margin,
                const MeshGeometry& mesh, const Candidate* parts, uint32_t count, MeshFloor& out) {
    const Vector a = from.position, b = to.position, known = out.up;
    const bool was_there = dot(known, known) > 0.0f;
    const float reach = scale * shape.reach;
    const Box around = grown({low_of(a, b), high_of(a, b)}, reach + margin);
    Vector normals[MeshFloor::most], face{};
    float above[MeshFloor::most], lowest = std::numeric_limits<float>::infinity(); // m, of the centre above triangles
    float area[MeshFloor::most];                                                   // m^2, twice
    uint32_t found = 0;
    bool all = true;
    out.count = 0;
    out.side = 0;
    for (uint32_t n = 0; n < count && all; ++n)
        for (uint32_t i = parts[n].part.first; i < parts[n].part.first + parts[n].part.count; ++i) {
            const Triangle t = mesh_triangle(mesh, i);
            if (!(dot(t.normal, t.normal) > 0.5f) || !crosses(around, t)) continue;
            if (ends_in(around, t)) return;
            all = found < MeshFloor::most;
            if (!all) break; // enough to tell the side
            normals[found] = t.turned ? -t.normal : t.normal;
            above[found] = dot(normals[found], a - t.corners[0]);
            area[found] = length(cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0]));
            if (above[found] > 0.0f && above[found] < lowest && is_over(t, a))
                lowest = above[found], face = normals[found];
            out.triangles[found++] = i;
        }
    // The far side of a board that the body lies on is behind its floor.
    Vector sum{};
    uint32_t used = 0;
    float small = std::numeric_limits<float>::infinity();
    for (uint32_t k = 0; k < found; ++k) {
        if (above[k] < 0.0f && dot(normals[k], face) < -facing) continue;
        sum = sum + normals[k];
        small = std::min(small, area[k]);
        normals[used] = normals[k];
        out.triangles[used++] = out.triangles[k];
    }
    const float size = length(sum);
    if (!(size > 0.0f)) return;
    out.up = 1.0f / size * sum;
    bool flat = all, front = false, back = false;
    out.even = true;
    for (uint32_t k = 0; k < used; ++k) {
        flat = flat && dot(normals[k], out.up) > steepest;
        out.even = out.even && dot(normals[k], normals[0]) > sharp;
        front = front || dot(normals[k], known) > facing;
        back = back || dot(normals[k], known) < -facing;
    }
    // A body that falls through several slopes within a substep would be pushed from one to the next, so fine uneven meshes are swept.
    if (!out.even && margin * margin > fine * fine * small) return;
    const bool is_other = front != back && !can_be_on(mesh, out.triangles, used, known, a, pressed * reach);
    if (front != back && !is_other) out.side = front ? 1 : -1;
    if (out.side < 0) out.up = -out.up;
    // Contacts undo a deep overlap over several substeps, so fast bodies are swept instead. At rest the path is the fall in a substep, which the
    // margin includes.
    const float far = (!out.even ? 0.5f : was_there && !is_other ? longest_floor : 1.0f) * (reach + margin);
    if (!flat || !(length(b - a) < far)) return;
    out.count = used;
    if (out.side != 0) return;
    const auto height = [&] { return height_over(mesh, out, a, 0.0f); };
    const float least = clear * scale * shape.thickness;
    if (height() > least) return;
    out.up = -out.up;
    if (!(height() > least)) out.count = 0;
}

bool lay_below(const MeshGeometry& mesh, const MeshFloor& floor, Vector center, float reach, Rotation turn,
               uint32_t lane, FloorLanes& out) {
    const InScratch<FloorFaces> faces(mesh, floor, center, reach);
    if (faces->count() > most_floor_faces) return false;
    for (; out.count < faces->count(); ++out.count) {
        out.face[out.count] = {};
        std::fill_n(out.face[out.count].edge[0], contact_lanes, no_contact);
    }
    const Vector y = floor.up,
                 beside = cross(y, std::abs(y.x) < 0.5f ? Vector{1.0f, 0.0f, 0.0f} : Vector{0.0f, 1.0f, 0.0f});
    const Vector x = 1.0f / length(beside) * beside, z = cross(x, y);
    put_in(out.axes, 0, lane, rotate(turn, x));
    put_in(out.axes, 3, lane, rotate(turn, y));
    put_in(out.axes, 6, lane, rotate(turn, z));
    for (uint32_t k = 0; k < faces->count(); ++k) {
        const FloorFace& f = faces->face(k);
        FloorLanes::Face& to = out.face[k];
        to.slope[0][lane] = f.lean * dot(f.normal, x);
        to.slope[1][lane] = f.lean * dot(f.normal, z);
        to.height[lane] = f.lean * f.offset;
        to.inverse[lane] = dot(f.normal, y);
        for (uint32_t e = 0; e < 3; ++e) {
            to.across[e][0][lane] = dot(f.inward[e], x);
            to.across[e][1][lane] = dot(f.inward[e], z);
            to.edge[e][lane] = f.edge[e] - seam * reach;
        }
    }
    return true;
}

void add_floor(ContactPoints& set, const MeshGeometry& mesh, const MeshFloor& floor) {
    const InScratch<FloorFaces> faces(mesh, floor, set.body.at.position, set.body.reach + set.body.radius);
    if (set.body.count > 0)
        add_points(set, *faces, floor.even);
    else
        add_ellipsoid(set, *faces, floor.up);
    if (floor.even) return;
    for (uint32_t k = 0; k < floor.count; ++k) {
        const Triangle t = mesh_triangle(mesh, floor.triangles[k]);
        add_ridges(set, one_side(t, dot(t.normal, floor.up) > 0.0f));
    }
}
} // namespace lr
