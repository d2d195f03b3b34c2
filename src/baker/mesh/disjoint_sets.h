// Disjoint sets of elements (union-find).
#pragma once

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace lr::baker {

class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }

    // The lowest element of the set.
    std::size_t find(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }

    // False if they were already in one set.
    bool join(std::size_t a, std::size_t b) {
        a = find(a);
        b = find(b);
        if (a == b) return false;
        if (b < a) std::swap(a, b);
        parent_[b] = a;
        return true;
    }

private:
    std::vector<std::size_t> parent_;
};
} // namespace lr::baker
