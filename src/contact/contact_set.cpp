#include "contact/contact_set.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lr {
namespace {

// Of the body's reach: contacts nearer together say the same.
constexpr float same = 1e-3f;

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
    float apart[most_found];
    std::fill_n(apart, count_, std::numeric_limits<float>::infinity());
    uint32_t next = 0;
    for (uint32_t i = 1; i < count_; ++i)
        if (found_[i].gap < found_[next].gap) next = i;
    const float reach = body_->reach + body_->radius, square = reach * reach;
    uint32_t kept = 0;
    while (true) {
        const Contact& taken = out[kept++] = found_[next];
        if (kept == most_contacts) break;
        float most = same * same * square;
        uint32_t farthest = count_;
        for (uint32_t i = 0; i < count_; ++i) {
            const Vector a = found_[i].arm - taken.arm, n = found_[i].normal - taken.normal;
            apart[i] = std::min(apart[i], dot(a, a) + square * dot(n, n));
            if (apart[i] > most) {
                most = apart[i];
                farthest = i;
            }
        }
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
