// Disjoint sets of elements (union-find), with memory of their own.
#pragma once

#include "base/disjoint_sets.h"

#include <cstddef>
#include <numeric>
#include <vector>

namespace lr::baker {

class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }

    // The lowest element of the set.
    std::size_t find(std::size_t i) { return first_of_set(parent_of(), i); }

    // False if they were already in one set.
    bool join(std::size_t a, std::size_t b) { return join_sets(parent_of(), a, b); }

private:
    struct Parent {
        std::vector<std::size_t>& of;
        std::size_t& operator()(std::size_t i) const { return of[i]; }
    };
    Parent parent_of() { return {parent_}; }

    std::vector<std::size_t> parent_;
};
} // namespace lr::baker
