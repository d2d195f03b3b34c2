// Mesh floors: the part of a mesh under a body acts as a heightfield, solid on the far side, and needs no swept test. contact.md, section 3.
#pragma once

#include "collision/colliders.h"
#include "collision/contact_points.h"

namespace lr {

struct MeshFloor {
    static constexpr uint32_t most = 960;

    uint32_t slot = 0;        // of the collider
    uint32_t count = 0;       // of triangles near the body's path; 0: no floor
    uint32_t triangles[most]; // by index
    Vector up;                // unit, mesh frame: their mean normal, towards the body
    bool even;                // no sharp edges: the body's points suffice
    // If the mesh is no floor but the body was on one side of it in the last substep: only this side collides, since the body can be pressed in
    // beyond it. 1: the side of the normals of triangles that are not turned; -1: the other; 0: unknown.
    int8_t side = 0;
};

// Scratch that one of these functions takes at a time.
inline constexpr size_t floor_scratch = size_t{72} * MeshFloor::most;

// On a known side a mesh stays a floor for paths up to this many times reach and margin; on others up to one.
inline constexpr float longest_floor = 3.0f;

// Makes the mesh a floor if near the body's path (poses in the mesh's frame) it is one surface without a border, nowhere over 57 degrees from its
// mean normal. parts: `count` of this mesh near the body. out.up: that of the last substep, or zero; of a body pressed in beyond the surface only
// this tells the side.
void find_floor(const BodyShape& shape, float scale, const Pose& from, const Pose& to, float margin,
                const MeshGeometry& mesh, const Candidate* parts, uint32_t count, MeshFloor& out);

// The displacement that takes the centre of mass at `position` (mesh's frame) out of the floor, zero if it is outside.
Vector way_out(const BodyShape& shape, float scale, Vector position, const MeshGeometry& mesh, const MeshFloor& floor);

// Puts the triangles of an even floor around a body (center, mesh's frame; reach: m) into a lane. turn: of the mesh. Returns false if there are too many.
bool lay_below(const MeshGeometry& mesh, const MeshFloor& floor, Vector center, float reach, Rotation turn,
               uint32_t lane, FloorLanes& out);
// Other floors, and even ones of very many triangles.
void add_floor(ContactPoints& set, const MeshGeometry& mesh, const MeshFloor& floor);
} // namespace lr
