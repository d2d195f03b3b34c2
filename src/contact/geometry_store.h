// Hulls, heightfields and meshes of a world: equal ones are kept once.
#pragma once

#include "contact/geometry.h"
#include "contact/narrow.h"
#include "langevin_rigid.h"
#include "world/allocator.h"

#include <cstdint>

namespace lr {

// Triangles that lie close together.
struct MeshPart {
    Box box;
    ColliderPart part;
};

struct SharedGeometry {
    ColliderKind kind;
    uint64_t hash; // of kind and content, as the caller gave it
    uint64_t users;
    HullGeometry hull;
    HeightfieldGeometry heightfield;
    MeshGeometry mesh;
    Box box;
    Buffer<float> points, more; // vertices or heights; faces, coarse heights or normals
    Buffer<uint32_t> indices;
    Buffer<uint8_t> hidden_edges;
    Buffer<MeshPart> parts; // of a mesh
    Buffer<float> given;    // what a hull was made of, where that is more than its corners
};

// What makes it again: a collider at the origin. A mesh's triangles are in the order of its parts, which stays as it is when
// they are made of it once more; but its hash is another.
lr_collider_desc desc_of(const SharedGeometry& geometry);

class GeometryStore {
public:
    explicit GeometryStore(Allocator& allocator) : allocator_(&allocator) {}
    ~GeometryStore();
    GeometryStore(const GeometryStore&) = delete;
    GeometryStore& operator=(const GeometryStore&) = delete;

    // What the desc describes, with one more user. Arrays have been checked, but for being a body's.
    lr_status acquire(const lr_collider_desc& desc, SharedGeometry*& out);
    SharedGeometry* find(ColliderKind kind, uint64_t hash) const; // null for none
    // The last user frees it.
    void release(SharedGeometry* geometry);
    // It is found by another hash from now on, unless that is taken: that of a mesh whose triangles came in another order.
    void rename(SharedGeometry* geometry, uint64_t hash);

private:
    lr_status build(const lr_collider_desc& desc, SharedGeometry& to);
    bool grow();
    void insert(SharedGeometry* geometry);
    void take_out(SharedGeometry* geometry);
    size_t home(uint64_t hash) const { return hash & (table_.size() - 1); }
    void free(SharedGeometry* geometry);

    Allocator* allocator_;
    struct Entry {
        SharedGeometry* geometry; // null: free
    };
    Buffer<Entry> table_; // open addressing, at most half full
    size_t count_ = 0;
};

} // namespace lr
