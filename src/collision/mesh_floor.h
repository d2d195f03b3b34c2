// The part of a mesh under a body as a floor that is solid below, like a heightfield: a body is met wherever it ends, and needs no swept test.
#pragma once

#include "collision/colliders.h"
#include "collision/contact_points.h"

namespace lr {

struct MeshFloor {
    static constexpr uint32_t most = 128;

    uint32_t slot = 0;        // of the collider
    uint32_t count = 0;       // of triangles near the body's way; 0: no floor
    uint32_t triangles[most]; // by index
    Vector up;                // unit, mesh frame: their mean normal, towards the body
    bool even;                // points stand for the body: no edge is sharp
    // Of a mesh that is no floor: the body was on this side of one in the last substep and can be pressed in beyond it, so only this side counts.
    // 1: that of the normals of triangles that are not turned; -1: the other; 0: unknown.
    int8_t side = 0;
};

// A body on a floor stays on it for ways of up to this many times its reach and margin.
inline constexpr float longest_floor = 3.0f;

// Whether the mesh is a floor for a body that goes from one pose to the other in the mesh's frame: near its way one surface without a border, nowhere
// steeper than 57 degrees against its mean normal. parts: `count` of this mesh, near the body. out.up: of the last substep, or zero. A body that is
// pressed in can be beyond the surface: then only this tells its side.
void find_floor(const BodyShape& shape, float scale, const Pose& from, const Pose& to, float margin,
                const MeshGeometry& mesh, const Candidate* parts, uint32_t count, MeshFloor& out);

// For a body at a place in the mesh's frame: the way by which its centre of mass is out of the floor, zero if it is.
Vector way_out(const BodyShape& shape, float scale, Vector position, const MeshGeometry& mesh, const MeshFloor& floor);

void add_floor(ContactPoints& set, const MeshGeometry& mesh, const MeshFloor& floor);
} // namespace lr
