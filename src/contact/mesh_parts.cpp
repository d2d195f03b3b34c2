#include "contact/mesh_parts.h"

#include <algorithm>

namespace lr {
namespace {

constexpr float large = 8.0f; // times the mean extent

struct Triangle {
    Box box;
    uint32_t index;
};

Vector doubled_middle(const Triangle& t) {
    return t.box.low + t.box.high;
}

Box around(const Triangle* from, const Triangle* to) {
    Box box = from->box;
    for (; from != to; ++from) box = around(box, from->box);
    return box;
}

// Halves by the middles along their longest side until few are left. Sets alone are taken from the selection, so that
// the order does not depend on how the library selects.
void split(Triangle* from, Triangle* to, uint32_t first, std::vector<MeshPart>& parts) {
    const auto count = static_cast<uint32_t>(to - from);
    if (count <= most_part_triangles) {
        std::sort(from, to, [](const Triangle& a, const Triangle& b) { return a.index < b.index; });
        parts.push_back({around(from, to), {first, count}});
        return;
    }
    Vector low = doubled_middle(*from), high = low;
    for (const Triangle* t = from; t != to; ++t) {
        low = low_of(low, doubled_middle(*t));
        high = high_of(high, doubled_middle(*t));
    }
    const Vector e = high - low;
    const auto key = [&](const Triangle& t) {
        const Vector m = doubled_middle(t);
        return e.x >= e.y && e.x >= e.z ? m.x : e.y >= e.z ? m.y : m.z;
    };
    const uint32_t half = (count / 2 + most_part_triangles - 1) / most_part_triangles * most_part_triangles;
    std::nth_element(from, from + half, to, [&](const Triangle& a, const Triangle& b) {
        return key(a) < key(b) || (!(key(b) < key(a)) && a.index < b.index);
    });
    split(from, from + half, first, parts);
    split(from + half, to, first + half, parts);
}

} // namespace

void make_mesh_parts(const float* vertices, uint32_t* indices, uint32_t triangle_count, std::vector<MeshPart>& parts) {
    std::vector<Triangle> triangles(triangle_count);
    double sum = 0.0;
    for (uint32_t i = 0; i < triangle_count; ++i) {
        Vector p[3];
        for (size_t k = 0; k < 3; ++k) p[k] = vector_of(vertices + size_t{3} * indices[size_t{3} * i + k]);
        triangles[i] = {{low_of(p[0], low_of(p[1], p[2])), high_of(p[0], high_of(p[1], p[2]))}, i};
        sum += static_cast<double>(extent(triangles[i].box));
    }
    const float limit = large * static_cast<float>(sum / triangle_count);
    const auto small = std::stable_partition(triangles.begin(), triangles.end(),
                                             [&](const Triangle& t) { return extent(t.box) <= limit; });
    parts.clear();
    Triangle* const begin = triangles.data();
    const auto small_count = static_cast<uint32_t>(small - triangles.begin());
    if (small_count != 0) split(begin, begin + small_count, 0, parts);
    for (uint32_t i = small_count; i < triangle_count; ++i) parts.push_back({triangles[i].box, {i, 1}});
    std::vector<uint32_t> sorted(size_t{3} * triangle_count);
    for (uint32_t i = 0; i < triangle_count; ++i)
        std::copy_n(indices + size_t{3} * triangles[i].index, 3, sorted.data() + size_t{3} * i);
    std::copy(sorted.begin(), sorted.end(), indices);
}

} // namespace lr
