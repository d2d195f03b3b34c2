// Worlds with all features, at the limits of the API.
#pragma once

#include "support/random.h"
#include "support/scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace test {

// Checks the observable state of a batch's bodies for non-finite numbers and values outside the header's ranges. Empty: valid.
std::string beyond_limits(const World& world, lr_batch batch);

class HostileWorld {
public:
    struct How {
        int32_t simd = LR_SIMD_AUTO;
        uint32_t workers = 0;
        int through_snapshot = -1; // before this frame; the rest runs in a new world
    };
    HostileWorld(uint64_t seed, const How& how);

    static constexpr int frames = 10;
    void step(int frame); // changes the world and steps it; every body must stay within limits
    uint64_t faults() const { return faults_; }

    World world;
    std::vector<lr_batch> batches;

private:
    void build();
    void add_batches(Random& random);
    void add_solids(Random& random);
    void add_fluids(Random& random);
    void populate(Random& random, lr_batch batch, uint32_t count);
    void push(Random& random);
    void check();

    uint64_t seed_;
    How how_;
    std::vector<Asset> assets_;
    std::vector<lr_collider> colliders_;
    uint64_t faults_ = 0;
};

} // namespace test
