// A body against many parts of a mesh, in the mesh's frame: the contacts of all of them that hold it best.
#pragma once

#include "contact/contact_set.h"
#include "contact/terrain.h"

namespace lr {

class MeshContacts {
public:
    MeshContacts(const BodyShape& shape, float scale, const Pose& at, const MeshGeometry& mesh, float margin)
        : body_(shape, scale, at), set_(body_), mesh_(&mesh), margin_(margin) {}
    MeshContacts(const MeshContacts&) = delete;
    MeshContacts& operator=(const MeshContacts&) = delete;

    // alone: also at edges that are left to the triangles beside them.
    void add(ColliderPart part, bool alone = false) { add_mesh(body_, *mesh_, part, margin_, set_, alone); }
    // At most most_contacts; as find_contacts.
    uint32_t keep(Contact* out) { return set_.keep(out); }

private:
    PlacedBody body_;
    ContactSet set_;
    const MeshGeometry* mesh_;
    float margin_;
};

} // namespace lr
