// Hulls, heightfields and meshes of a world; equal ones are stored once.
#pragma once

#include "base/allocator.h"
#include "collision/collider_geometry.h"
#include "langevin_rigid.h"

#include <algorithm>
#include <cstdint>

namespace lr {

struct SharedGeometry {
    ColliderKind kind;
    uint64_t hash; // of kind and data, as the caller gave them
    uint64_t users;
    SharedGeometry* next; // in the store
    HullGeometry hull;
    HeightfieldGeometry heightfield;
    MeshGeometry mesh;
    Box box;
    Buffer<float> points, more; // vertices or heights; faces, coarse heights or normals
    Buffer<uint32_t> indices;
    Buffer<uint8_t> hidden_edges;
    Buffer<MeshPart> parts; // of a mesh
    Buffer<float> given;    // the source points of a hull, if there are more than its corners
};

inline bool same_arrays(const lr_collider_desc& a, const lr_collider_desc& b) {
    return a.kind == b.kind && a.vertices == b.vertices && a.indices == b.indices && a.heights == b.heights &&
           a.vertex_count == b.vertex_count && a.triangle_count == b.triangle_count &&
           std::equal(a.counts, a.counts + 2, b.counts) && std::equal(a.spacing, a.spacing + 2, b.spacing);
}

// A desc, at the origin, that recreates the geometry. A mesh keeps the order of its triangles, sorted into parts, so its hash differs.
lr_collider_desc desc_of(const SharedGeometry& geometry);

class GeometryStore {
public:
    explicit GeometryStore(Allocator& allocator) : allocator_(&allocator) {}
    ~GeometryStore();
    GeometryStore(const GeometryStore&) = delete;
    GeometryStore& operator=(const GeometryStore&) = delete;

    // Finds or builds the geometry of a desc and adds a user. The API has checked the arrays, not that they form a solid.
    lr_status acquire(const lr_collider_desc& desc, SharedGeometry*& out);
    SharedGeometry* find(ColliderKind kind, uint64_t hash) const; // null for none
    // Removes a user; the last removal frees it.
    void release(SharedGeometry* geometry);
    // Changes the hash by which it is found, unless that is taken. lr_replay needs this for meshes recorded with reordered triangles.
    void rename(SharedGeometry* geometry, uint64_t hash);

private:
    lr_status build(const lr_collider_desc& desc, SharedGeometry& to);
    bool grow();
    void insert(SharedGeometry* geometry);
    void take_out(SharedGeometry* geometry);
    SharedGeometry*& list_of(uint64_t hash) { return lists_[hash & (lists_.size() - 1)]; }
    void free(SharedGeometry* geometry);

    Allocator* allocator_;
    Buffer<SharedGeometry*> lists_; // by hash: a power of two, at least one per geometry
    size_t count_ = 0;
};
} // namespace lr
