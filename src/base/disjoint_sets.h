// Disjoint sets of elements (union-find). parent(i): a reference to the parent of element i, initially i itself.
#pragma once

#include <utility>

namespace lr {

// The lowest element of i's set.
template <class Parent, class Index> Index first_of_set(const Parent& parent, Index i) {
    while (parent(i) != i) i = parent(i) = parent(parent(i));
    return i;
}

// False if they were already in one set.
template <class Parent, class Index> bool join_sets(const Parent& parent, Index a, Index b) {
    a = first_of_set(parent, a);
    b = first_of_set(parent, b);
    if (a == b) return false;
    if (b < a) std::swap(a, b);
    parent(b) = a;
    return true;
}
} // namespace lr
