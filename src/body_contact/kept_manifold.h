// Persistent manifolds: bodies that have hardly moved against each other keep their contacts, which move with them.
#pragma once

#include "body_contact/pair_cache.h"
#include "collision/pair_contacts.h"

namespace lr {

// m: gaps are searched by so much beyond the need of this substep, so that the manifold can be kept.
float kept_way(const PairBody& a, const PairBody& b);

// a, b: in the order of their keys. within: m, contacts with smaller gaps are needed. False: the pair must be searched again.
bool kept_manifold(const CachedPair& cached, const PairBody& a, const PairBody& b, float within, Manifold& out);

// A manifold found now, with the impulses of the former one (`before`, or null). found: of a and b in this order, not empty.
CachedPair cached_pair(uint64_t key_a, uint64_t key_b, const PairBody& a, const PairBody& b, const Manifold& found,
                       float within, const CachedPair* before);

Manifold other_way_round(Manifold m);
} // namespace lr
