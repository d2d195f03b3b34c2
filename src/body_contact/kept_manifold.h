// Manifolds that last: bodies that have hardly moved against each other keep their contacts, which move with them.
#pragma once

#include "body_contact/pair_cache.h"
#include "collision/pair_contacts.h"

namespace lr {

// m: how far beyond the contacts of this substep a manifold is searched, so that it lasts.
float kept_way(const PairBody& a, const PairBody& b);

// a, b: in the order of their keys. within: m, contacts with smaller gaps are needed. False: the pair must be searched again.
bool kept_manifold(const CachedPair& cached, const PairBody& a, const PairBody& b, float within, Manifold& out);

// A manifold found now, with the impulses of the one before, if there was one. found: from a to b, not empty.
CachedPair cached_pair(uint64_t key_a, uint64_t key_b, const PairBody& a, const PairBody& b, const Manifold& found,
                       float within, const CachedPair* before);

Manifold other_way_round(Manifold m);
} // namespace lr
