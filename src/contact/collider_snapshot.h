// The colliders in a snapshot: written, and read back in two steps, so that nothing changes before all of it is good.
#pragma once

#include "contact/colliders.h"

namespace lr {

class ColliderSnapshot {
public:
    // A multiple of 8.
    static uint64_t bytes(const Colliders& colliders);
    // Writes bytes(colliders) of them.
    static void save(const Colliders& colliders, unsigned char* to);

    explicit ColliderSnapshot(Colliders& colliders) : to_(&colliders) {}

    // used: receives how many of the `size` bytes are the colliders'. `from` is kept for commit().
    lr_status read(const unsigned char* from, uint64_t size, uint64_t& used);
    // After read(): whether there are any.
    bool any() const;
    // After read() alone; cannot fail.
    void commit();

private:
    Colliders* to_;
    const unsigned char* from_ = nullptr;
};

} // namespace lr
