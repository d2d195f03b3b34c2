#include "contact/meeting_grid.h"

namespace lr {

bool MeetingGrid::reserve(Allocator& allocator, uint32_t count) {
    if (boxes_.size() >= count) return true;
    const size_t room = size_t{count} + count / 2;
    size_t buckets = 16;
    while (buckets < room) buckets *= 2;
    Buffer<MeetingBox> boxes, sorted;
    Buffer<uint32_t> first;
    if (!boxes.allocate(allocator, room) || !sorted.allocate(allocator, room) ||
        !first.allocate(allocator, buckets + 1))
        return false;
    boxes_.swap(boxes);
    sorted_.swap(sorted);
    first_.swap(first);
    mask_ = static_cast<uint32_t>(buckets - 1);
    return true;
}

void MeetingGrid::build(uint32_t count) {
    std::fill_n(first_.data(), mask_ + 2, 0u);
    populated_ = 0;
    for (uint32_t i = 0; i < count; ++i) {
        MeetingBox& box = boxes_[i];
        float extent = 0.0f, far = 0.0f;
        for (size_t k = 0; k < 3; ++k) {
            extent = std::max(extent, box.high[k] - box.low[k]);
            far = std::max(far, std::max(-box.low[k], box.high[k]));
        }
        uint32_t level = 0;
        while (level < levels && size_of(level) < extent) ++level;
        bool finite = far < 1e15f && level < levels;
        for (size_t k = 0; k < 3; ++k) finite = finite && box.high[k] >= box.low[k]; // false for NaN
        box.level = level;
        box.cell = nowhere;
        if (!finite) continue;
        int32_t at[3];
        for (size_t k = 0; k < 3; ++k) at[k] = cell(0.5f * (box.low[k] + box.high[k]), inverse_size_of(level));
        box.cell = hash(level, at[0], at[1], at[2]);
        populated_ |= 1u << level;
        ++first_[(box.cell & mask_) + 1];
    }
    for (uint32_t b = 0; b <= mask_; ++b) first_[b + 1] += first_[b];
    for (uint32_t i = count; i-- > 0;) {
        const MeetingBox& box = boxes_[i];
        if (box.cell == nowhere) continue;
        // Each bucket is filled from behind: its end moves down to where it begins.
        sorted_[--first_[(box.cell & mask_) + 1]] = box;
    }
    // Ends have become beginnings: one place down.
    for (uint32_t b = 0; b <= mask_; ++b) first_[b] = first_[b + 1];
    first_[mask_ + 1] = 0;
    for (uint32_t i = 0; i < count; ++i) first_[mask_ + 1] += boxes_[i].cell != nowhere ? 1u : 0u;
}

} // namespace lr
