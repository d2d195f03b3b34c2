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
        for (size_t k = 0; k < 3; ++k) at[k] = cell(middle(box, k), inverse_size_of(level));
        box.cell = hash(level, at[0], at[1], at[2]);
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
        for (size_t k = 0; k < 3; ++k) {
            rows_[k * room_ + at] = box.low[k];
            rows_[(k + 3) * room_ + at] = box.high[k];
        }
    }
    // Ends have become beginnings: one place down.
    for (uint32_t b = 0; b <= mask_; ++b) first_[b] = first_[b + 1];
    placed_ = 0;
    for (uint32_t i = 0; i < count; ++i) placed_ += boxes_[i].cell != nowhere ? 1u : 0u;
    first_[mask_ + 1] = placed_;
}

} // namespace lr
