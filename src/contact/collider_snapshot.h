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

    // Of bytes that begin with saved colliders: how many of them are theirs; 0 when they are not even that many.
    static uint64_t bytes(const unsigned char* from, uint64_t size);

    explicit ColliderSnapshot(Colliders& colliders) : to_(&colliders) {}

    // used: receives how many of the `size` bytes are the colliders'. `from` is kept for commit().
    lr_status read(const unsigned char* from, uint64_t size, uint64_t& used);
    // After read(): whether there are any.
    bool any() const;
    // After read() alone; cannot fail.
    void commit();

private:
    template <class Write> static bool visit(const Colliders& colliders, Write&& write);
    bool is_there(const unsigned char* from) const;

    Colliders* to_;
    const unsigned char* from_ = nullptr;
    bool same_ = false; // they are what the world has already
};

} // namespace lr
