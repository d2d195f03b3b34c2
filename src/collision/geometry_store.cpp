#include "collision/geometry_store.h"

#include "collision/build_collider_geometry.h"

#include <cstring>
#include <new>
#include <vector>

namespace lr {
namespace {

// Each word changes the state by a bijection, so no difference is lost.
struct Hash {
    uint64_t state = 0x9e3779b97f4a7c15ull;
    void add(uint64_t word) {
        state = (state ^ word) * 0xbf58476d1ce4e5b9ull;
        state ^= state >> 29;
    }
    void add(const void* words, uint64_t count) {
        const auto* const bytes = static_cast<const unsigned char*>(words);
        add(count);
        for (uint64_t i = 0; i < count; ++i) {
            uint32_t word;
            std::memcpy(&word, bytes + 4 * i, 4);
            add(word);
        }
    }
    uint64_t value() const {
        uint64_t v = (state ^ state >> 30) * 0x94d049bb133111ebull;
        v ^= v >> 31;
        return v != 0 ? v : 1;
    }
};

uint64_t heights_of(const lr_collider_desc& desc) {
    return uint64_t{desc.counts[0]} * desc.counts[1];
}

uint64_t content_hash(const lr_collider_desc& desc) {
    Hash hash;
    hash.add(static_cast<uint64_t>(desc.kind));
    if (desc.kind == LR_COLLIDER_HEIGHTFIELD) {
        hash.add(desc.counts, 2);
        hash.add(desc.spacing, 2);
        hash.add(desc.heights, heights_of(desc));
    } else {
        hash.add(desc.vertices, uint64_t{3} * desc.vertex_count);
        if (desc.kind == LR_COLLIDER_MESH) hash.add(desc.indices, uint64_t{3} * desc.triangle_count);
    }
    return hash.value();
}

template <class T> bool copy(Allocator& allocator, const T* from, uint64_t count, Buffer<T>& to) {
    if (!to.allocate(allocator, count)) return false;
    std::copy_n(from, count, to.data());
    return true;
}

template <class T> bool copy(Allocator& allocator, const std::vector<T>& from, Buffer<T>& to) {
    return copy(allocator, from.data(), from.size(), to);
}

Box around(const float* points, size_t count) {
    Box box{vector_of(points), vector_of(points)};
    for (size_t i = 0; i < count; ++i) box = around(box, {vector_of(points + 3 * i), vector_of(points + 3 * i)});
    return box;
}

lr_status make_hull(Allocator& allocator, const lr_collider_desc& desc, SharedGeometry& to) {
    BuiltHull hull;
    if (!build_hull(desc.vertices, desc.vertex_count, hull)) return LR_ERROR_INVALID_ARGUMENT;
    if (!copy(allocator, hull.vertices, to.points) || !copy(allocator, hull.faces, to.more) ||
        !copy(allocator, hull.corners, to.indices))
        return LR_ERROR_OUT_OF_MEMORY;
    const uint64_t given = uint64_t{3} * desc.vertex_count;
    // Compares bits, as the hash does: -0 differs from 0.
    const bool same = hull.vertices.size() == given &&
                      std::memcmp(hull.vertices.data(), desc.vertices, static_cast<size_t>(4 * given)) == 0;
    if (!same && !copy(allocator, desc.vertices, given, to.given)) return LR_ERROR_OUT_OF_MEMORY;
    to.hull = hull.geometry();
    to.hull.vertices = to.points.data(), to.hull.faces = to.more.data(), to.hull.corners = to.indices.data();
    to.box = around(to.points.data(), to.hull.vertex_count);
    return LR_OK;
}

lr_status make_heightfield(Allocator& allocator, const lr_collider_desc& desc, SharedGeometry& to) {
    HeightfieldGeometry& field = to.heightfield;
    std::vector<float> coarse;
    build_coarse(desc.counts, desc.heights, coarse, field.coarse_counts, field.lowest, field.highest);
    if (!copy(allocator, desc.heights, heights_of(desc), to.points) || !copy(allocator, coarse, to.more))
        return LR_ERROR_OUT_OF_MEMORY;
    std::copy_n(desc.counts, 2, field.counts);
    std::copy_n(desc.spacing, 2, field.spacing);
    field.secant = steepest_secant(field.counts, field.spacing, desc.heights);
    field.heights = to.points.data();
    field.coarse = to.more.data();
    to.box = {{0.0f, field.lowest, 0.0f}, {field.extent(0), field.highest, field.extent(1)}};
    return LR_OK;
}

lr_status make_mesh(Allocator& allocator, const lr_collider_desc& desc, SharedGeometry& to) {
    if (!copy(allocator, desc.vertices, size_t{3} * desc.vertex_count, to.points) ||
        !copy(allocator, desc.indices, size_t{3} * desc.triangle_count, to.indices))
        return LR_ERROR_OUT_OF_MEMORY;
    std::vector<MeshPart> parts;
    make_mesh_parts(to.points.data(), to.indices.data(), desc.triangle_count, parts);
    std::vector<float> normals;
    std::vector<uint8_t> hidden;
    if (!build_mesh(to.points.data(), desc.vertex_count, to.indices.data(), desc.triangle_count, normals, hidden))
        return LR_ERROR_INVALID_ARGUMENT;
    if (!copy(allocator, parts, to.parts) || !copy(allocator, normals, to.more) ||
        !copy(allocator, hidden, to.hidden_edges))
        return LR_ERROR_OUT_OF_MEMORY;
    to.mesh = {desc.vertex_count, desc.triangle_count, to.points.data(),
               to.indices.data(), to.more.data(),      to.hidden_edges.data()};
    to.box = around(to.points.data(), desc.vertex_count);
    return LR_OK;
}
} // namespace

lr_collider_desc desc_of(const SharedGeometry& geometry) {
    lr_collider_desc d{};
    d.struct_size = sizeof d;
    d.kind = static_cast<int32_t>(geometry.kind);
    d.orientation[3] = 1.0f;
    d.layers = 1;
    d.spacing[0] = d.spacing[1] = 1.0f;
    switch (geometry.kind) {
    case ColliderKind::hull: {
        const Buffer<float>& made_of = geometry.given.size() != 0 ? geometry.given : geometry.points;
        d.vertices = made_of.data();
        d.vertex_count = static_cast<uint32_t>(made_of.size() / 3);
        break;
    }
    case ColliderKind::heightfield:
        std::copy_n(geometry.heightfield.counts, 2, d.counts);
        std::copy_n(geometry.heightfield.spacing, 2, d.spacing);
        d.heights = geometry.heightfield.heights;
        break;
    default:
        d.vertices = geometry.mesh.vertices;
        d.vertex_count = geometry.mesh.vertex_count;
        d.indices = geometry.mesh.indices;
        d.triangle_count = geometry.mesh.triangle_count;
    }
    return d;
}

GeometryStore::~GeometryStore() {
    for (size_t i = 0; i < lists_.size(); ++i)
        while (SharedGeometry* const geometry = lists_[i]) {
            lists_[i] = geometry->next;
            free(geometry);
        }
}

void GeometryStore::free(SharedGeometry* geometry) {
    geometry->~SharedGeometry();
    allocator_->release(geometry, sizeof(SharedGeometry));
}

lr_status GeometryStore::build(const lr_collider_desc& desc, SharedGeometry& to) {
    return unless_out_of_memory([&] {
        switch (to.kind) {
        case ColliderKind::hull:
            return make_hull(*allocator_, desc, to);
        case ColliderKind::heightfield:
            return make_heightfield(*allocator_, desc, to);
        default:
            return make_mesh(*allocator_, desc, to);
        }
    });
}

SharedGeometry* GeometryStore::find(ColliderKind kind, uint64_t hash) const {
    if (count_ == 0) return nullptr;
    SharedGeometry* at = lists_[hash & (lists_.size() - 1)];
    while (at && (at->hash != hash || at->kind != kind)) at = at->next;
    return at;
}

bool GeometryStore::grow() {
    Buffer<SharedGeometry*> old;
    if (!old.allocate(*allocator_, std::max<size_t>(8, 2 * lists_.size()))) return false;
    std::fill_n(old.data(), old.size(), nullptr);
    lists_.swap(old);
    for (size_t i = 0; i < old.size(); ++i)
        while (SharedGeometry* const geometry = old[i]) {
            old[i] = geometry->next;
            insert(geometry);
        }
    return true;
}

void GeometryStore::insert(SharedGeometry* geometry) {
    SharedGeometry*& first = list_of(geometry->hash);
    geometry->next = first;
    first = geometry;
}

lr_status GeometryStore::acquire(const lr_collider_desc& desc, SharedGeometry*& out) {
    const auto kind = static_cast<ColliderKind>(desc.kind);
    const uint64_t hash = content_hash(desc);
    out = find(kind, hash);
    if (out) {
        ++out->users;
        return LR_OK;
    }
    if (count_ == lists_.size() && !grow()) return LR_ERROR_OUT_OF_MEMORY;
    void* const memory = allocator_->allocate(sizeof(SharedGeometry));
    if (!memory) return LR_ERROR_OUT_OF_MEMORY;
    auto* const geometry = new (memory) SharedGeometry{};
    geometry->kind = kind;
    geometry->hash = hash;
    geometry->users = 1;
    const lr_status status = build(desc, *geometry);
    if (status != LR_OK) {
        free(geometry);
        return status;
    }
    insert(geometry);
    ++count_;
    out = geometry;
    return LR_OK;
}

void GeometryStore::take_out(SharedGeometry* geometry) {
    SharedGeometry** at = &list_of(geometry->hash);
    while (*at != geometry) at = &(*at)->next;
    *at = geometry->next;
}

void GeometryStore::rename(SharedGeometry* geometry, uint64_t hash) {
    if (find(geometry->kind, hash)) return;
    take_out(geometry);
    geometry->hash = hash;
    insert(geometry);
}

void GeometryStore::release(SharedGeometry* geometry) {
    if (!geometry || --geometry->users != 0) return;
    take_out(geometry);
    --count_;
    free(geometry);
}
} // namespace lr
