#include "contact/meeting_grid.h"

namespace lr {

bool MeetingGrid::reserve(Allocator& allocator, uint32_t count) {
    if (boxes_.size() >= count) return true;
    const size_t room = size_t{count} + count / 2;
    size_t buckets = 16;
    while (buckets < room) buckets *= 2;
    Buffer<MeetingBox> boxes;
    Buffer<float> rows;
    Buffer<uint32_t> index, first;
    if (!boxes.allocate(allocator, room) || !rows.allocate(allocator, 6 * (room + lanes)) ||
        !index.allocate(allocator, room) || !first.allocate(allocator, buckets + 1))
        return false;
    room_ = room + lanes;
    std::fill_n(rows.data(), 6 * room_, 0.0f);
    boxes_.swap(boxes);
    rows_.swap(rows);
    index_.swap(index);
    first_.swap(first);
    mask_ = static_cast<uint32_t>(buckets - 1);
    return true;
}

void MeetingGrid::build(uint32_t count) {
    std::fill_n(first_.data(), mask_ + 2, 0u);
    populated_ = 0;
    for (uint32_t i = 0; i < count; ++i) {
        MeetingBox& box = boxes_[i];
        const Vector low = box.box.low, high = box.box.high;
        const float far = std::max({-low.x, high.x, -low.y, high.y, -low.z, high.z}), size = extent(box.box);
        uint32_t level = 0;
        while (level < levels && width_of(level) < size) ++level;
        box.level = level;
        box.cell = nowhere;
        // False for NaN.
        const bool there = high.x >= low.x && high.y >= low.y && high.z >= low.z;
        if (!(there && far < 1e15f && level < levels)) continue;
        box.cell = hash(level, cell_of(box, level));
        populated_ |= 1u << level;
        ++first_[(box.cell & mask_) + 1];
    }
    for (uint32_t b = 0; b <= mask_; ++b) first_[b + 1] += first_[b];
    for (uint32_t i = count; i-- > 0;) {
        const MeetingBox& box = boxes_[i];
        if (box.cell == nowhere) continue;
        // Each bucket is filled from behind: its end moves down to where it begins.
        const uint32_t at = --first_[(box.cell & mask_) + 1];
        index_[at] = i;
        const Box& b = box.box;
        const float numbers[6] = {b.low.x, b.low.y, b.low.z, b.high.x, b.high.y, b.high.z};
        for (size_t k = 0; k < 6; ++k) rows_[k * room_ + at] = numbers[k];
    }
    // Ends have become beginnings: one place down.
    for (uint32_t b = 0; b <= mask_; ++b) first_[b] = first_[b + 1];
    placed_ = 0;
    for (uint32_t i = 0; i < count; ++i) placed_ += boxes_[i].cell != nowhere ? 1u : 0u;
    first_[mask_ + 1] = placed_;
}

} // namespace lr
