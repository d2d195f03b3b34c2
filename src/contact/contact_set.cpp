#include "contact/contact_set.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lr {
namespace {

// Of the body's reach: contacts nearer together say the same.
constexpr float same = 1e-3f;
// Of the search, side by side: the greatest of many in one chain is slow.
constexpr uint32_t lanes = 4;
static_assert(most_found % lanes == 0);

} // namespace

void ContactSet::add(Vector point, Vector normal, float gap) {
    if (!(dot(normal, normal) > 0.5f) || !(std::abs(gap) < std::numeric_limits<float>::max())) return;
    if (count_ == most_found) {
        Contact kept[most_contacts];
        count_ = choose(kept);
        std::copy_n(kept, count_, found_);
    }
    found_[count_++] = {point, normal, gap};
}

float ContactSet::least_gap(uint32_t from, float otherwise) const {
    float least = otherwise;
    for (uint32_t i = from; i < count_; ++i) least = std::min(least, found_[i].gap);
    return least;
}

uint32_t ContactSet::choose(Contact* out) const {
    if (count_ == 0) return 0;
    const float reach = body_->reach + body_->radius, square = reach * reach;
    // Place and direction of each as one point in six dimensions, the directions times the reach; in columns for the
    // compiler's vectors.
    float columns[6][most_found], apart[most_found];
    uint32_t next = 0;
    for (uint32_t i = 0; i < count_; ++i) {
        const Contact& c = found_[i];
        const float of[6] = {c.arm.x, c.arm.y, c.arm.z, reach * c.normal.x, reach * c.normal.y, reach * c.normal.z};
        for (uint32_t k = 0; k < 6; ++k) columns[k][i] = of[k];
        apart[i] = std::numeric_limits<float>::infinity();
        if (c.gap < found_[next].gap) next = i;
    }
    const uint32_t padded = (count_ + lanes - 1) / lanes * lanes;
    for (uint32_t i = count_; i < padded; ++i) {
        apart[i] = 0.0f;
        for (auto& column : columns) column[i] = 0.0f;
    }
    uint32_t kept = 0;
    while (true) {
        out[kept++] = found_[next];
        if (kept == most_contacts) break;
        float taken[6];
        for (uint32_t k = 0; k < 6; ++k) taken[k] = columns[k][next];
        for (uint32_t i = 0; i < padded; ++i) {
            float sum = 0.0f;
            for (uint32_t k = 0; k < 6; ++k) {
                const float d = columns[k][i] - taken[k];
                sum += d * d;
            }
            apart[i] = sum < apart[i] ? sum : apart[i];
        }
        float most[lanes] = {};
        for (uint32_t i = 0; i < padded; i += lanes)
            for (uint32_t lane = 0; lane < lanes; ++lane)
                most[lane] = most[lane] < apart[i + lane] ? apart[i + lane] : most[lane];
        const float far = std::max({most[0], most[1], most[2], most[3]});
        if (!(far > same * same * square)) break;
        uint32_t farthest = 0;
        while (farthest < count_ && apart[farthest] != far) ++farthest;
        if (farthest == count_) break;
        next = farthest;
    }
    return kept;
}

uint32_t ContactSet::keep(Contact* out) {
    const uint32_t kept = choose(out);
    for (uint32_t i = 0; i < kept; ++i) out[i].arm = rotate(inverse(body_->at.rotation), out[i].arm);
    return kept;
}

} // namespace lr
