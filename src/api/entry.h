// How calls on a world come in: whoever else is inside it is found, where that is asked for.
#pragma once

#include "api/inner.h"
#include "world/world.h"

namespace lr::api {

// The world is the caller's as long as this lives, if `status` is LR_OK.
class Entry {
public:
    Entry(const lr_world& world, const char* function) : use_(world.use), status_(enter(world, function)) {}
    ~Entry() {
        if (status_ == LR_OK) use_.leave();
    }
    Entry(const Entry&) = delete;
    Entry& operator=(const Entry&) = delete;
    lr_status status() const { return status_; }

private:
    Use& use_;
    lr_status status_;
};

// Of a call that changes nothing.
template <class Inner> lr_status query(const lr_world* world, const char* function, Inner&& inner) {
    if (!world || !world->use.checked()) return inner();
    const Entry entry(*world, function);
    return entry.status() == LR_OK ? inner() : entry.status();
}

// Of one that may change the world, also where it is refused.
template <class Inner> lr_status change(const lr_world* world, const char* function, Inner&& inner) {
    return query(world, function, inner);
}

} // namespace lr::api
