#include "collision/body_broad_phase.h"

namespace lr {

bool BodyBroadPhase::reserve(Allocator& allocator, uint32_t count) {
    if (boxes_.size() >= count) return true;
    const size_t room = size_t{count} + count / 2;
    size_t buckets = 16;
    while (buckets < room) buckets *= 2;
    Buffer<BodyBox> boxes;
    Buffer<float> rows;
    Buffer<uint32_t> index, cells, first;
    if (!boxes.allocate(allocator, room) || !rows.allocate(allocator, 6 * (room + lanes)) ||
        !index.allocate(allocator, room) || !cells.allocate(allocator, room) || !first.allocate(allocator, buckets + 1))
        return false;
    room_ = room + lanes;
    std::fill_n(rows.data(), 6 * room_, 0.0f);
    boxes_.swap(boxes);
    rows_.swap(rows);
    index_.swap(index);
    cells_.swap(cells);
    first_.swap(first);
    mask_ = static_cast<uint32_t>(buckets - 1);
    return true;
}

void BodyBroadPhase::build(uint32_t count) {
    populated_ = 0;
    for (uint32_t i = 0; i < count; ++i) {
        BodyBox& box = boxes_[i];
        const Vector low = box.box.low, high = box.box.high;
        const float far = std::max({-low.x, high.x, -low.y, high.y, -low.z, high.z}), size = extent(box.box);
        uint32_t level = 0;
        while (level < levels && width_of(level) < size) ++level;
        box.level = level;
        box.cell = nowhere;
        // False for NaN.
        const bool there = high.x >= low.x && high.y >= low.y && high.z >= low.z;
        if (!(there && far < 1e15f && level < levels)) continue;
        box.cell = hash(level, cell_of(box.box, level));
        populated_ |= 1u << level;
    }
    // Boxes outside the grid go into an extra bucket, the last one.
    const auto bucket_of = [&](uint32_t i) { return boxes_[i].cell == nowhere ? mask_ + 1 : boxes_[i].cell & mask_; };
    sort_into_buckets(count, mask_ + 2, bucket_of, first_.data(), index_.data());
    placed_ = first_[mask_ + 1];
    for (uint32_t at = 0; at < placed_; ++at) {
        const Box& b = boxes_[index_[at]].box;
        cells_[at] = boxes_[index_[at]].cell;
        const float numbers[6] = {b.low.x, b.low.y, b.low.z, b.high.x, b.high.y, b.high.z};
        for (size_t k = 0; k < 6; ++k) rows_[k * room_ + at] = numbers[k];
    }
}
} // namespace lr
