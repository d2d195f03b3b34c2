// A storm without end: leaves, discs, petals and seeds spawn, land, float, and end; a few bodies live as long as the storm.
#pragma once

#include "langevin_rigid.h"

#include <cstdint>
#include <vector>

namespace load {

// Ends the program with a message after an error.
void must(lr_status status, const char* what);

inline constexpr uint64_t second = 30, minute = 60 * second; // steps
inline constexpr float frame = 1.0f / 30.0f;                 // s

struct Kind {
    const char* name;
    lr_batch batch{};
    float max_age = 0.0f; // s; 0: its bodies live as long as the storm
};

class Storm {
public:
    Storm(uint64_t seed, uint32_t workers);
    ~Storm();
    Storm(const Storm&) = delete;
    Storm& operator=(const Storm&) = delete;

    void step();
    lr_world* world() const { return world_; }
    const std::vector<Kind>& kinds() const { return kinds_; }
    // Upper bound of a snapshot's size, after a while.
    uint64_t snapshot_bytes() const { return snapshot_.size(); }

private:
    lr_batch add_batch(const char* name, lr_asset* asset, uint32_t capacity, int32_t loads, float max_age);
    void add_wind();
    void add_ground();
    void every_minute();

    lr_world* world_ = nullptr;
    std::vector<lr_asset*> assets_;
    std::vector<Kind> kinds_;
    lr_wind_source vortex_{};
    lr_collider walker_{};
    std::vector<lr_body> visitors_; // created and destroyed by calls
    std::vector<unsigned char> snapshot_;
    uint64_t steps_ = 0;
};

} // namespace load
