// The heap of bench_heap by Bullet's rigid bodies, as an engine would use them: no air but a drag that gives the same speed of fall.
#pragma once

#include "bench/heap_scene.h"

#include <memory>
#include <vector>

namespace bench {

class Peer {
public:
    static constexpr double thicker = 10.0; // Bullet pushes plates of 0.4 mm through each other
    struct Seen {
        uint32_t awake, fast; // fast: above 0.3 m/s
    };

    virtual ~Peer() = default;
    virtual void add(const lr_body_desc& start) = 0;
    virtual void step() = 0; // of step_seconds, in `substeps`
    virtual Seen look() const = 0;
    virtual std::vector<test::Pose> poses() const = 0;
};
// Null in a build without Bullet.
std::unique_ptr<Peer> make_bullet_heap();

} // namespace bench
