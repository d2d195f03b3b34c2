// Colliders of the scenes for tests of determinism.
#pragma once

#include "support/colliders.h"
#include "support/wind.h"

#include <algorithm>

namespace test {

enum class Solids {
    none,
    terrain, // a heightfield and a plane
    ground,  // also a sphere, a moving capsule, a box
    edges,   // a heightfield, hulls (one of them turning), and a mesh
};

class PlayedColliders {
public:
    explicit PlayedColliders(Solids which) : which_(which) {
        if (which == Solids::none) return;
        Random random(7);
        // One slope for all: over several at a time bodies take the narrow phase.
        for (float& h : heights_) h = which == Solids::terrain ? 0.05f : random.real(-0.05, 0.25);
        sheet_ = bumpy_sheet(6, 3);
        corners_.resize(3 * size_t{12});
        for (float& x : corners_) x = random.real(-0.4, 0.4);
    }

    // Creates colliders with data, which a world must have to restore a snapshot.
    void prepare(const World& w) const {
        std::vector<lr_collider_desc> all = descs();
        std::reverse(all.begin(), all.end());
        for (const lr_collider_desc& d : all)
            if (d.heights || d.vertices) add_collider(w, d);
    }
    void place(const World& w) {
        for (const lr_collider_desc& d : descs()) ids_.push_back(add_collider(w, d));
    }
    // Moves colliders to and fro, in all three modes.
    void move(const World& w, int frame) const {
        if (ids_.size() < 3 || frame % 4 != 3) return;
        constexpr int32_t modes[] = {LR_MOVE_VELOCITY, LR_MOVE_TO, LR_MOVE_PLACE};
        const float away = 0.1f * static_cast<float>(frame % 8 - 3);
        lr_collider_motion m = motion_of(ids_[1], modes[frame / 4 % 3]);
        const lr_collider_state s = state_of_collider(w, ids_[1]);
        std::copy_n(s.position, 3, m.position);
        std::copy_n(s.orientation, 4, m.orientation);
        m.position[2] += away;
        set(m.linear_velocity, -0.5f + away, 0.0f, 0.3f);
        m.angular_velocity[1] = 2.0f * away;
        REQUIRE(lr_collider_move(w.get(), &m, 1) == LR_OK);
    }

private:
    std::vector<lr_collider_desc> descs() const {
        std::vector<lr_collider_desc> all;
        const auto add = [&](const lr_collider_desc& d, float x, float y, float z) -> lr_collider_desc& {
            all.push_back(d);
            set(all.back().position, x, y, z);
            return all.back();
        };
        if (which_ == Solids::none) return all;
        add(heightfield_collider(heights_, 9, 0.25f), 0.0f, 0.0f, 0.0f);
        if (which_ == Solids::terrain) {
            add(collider_desc(LR_COLLIDER_PLANE), 0.0f, 0.0f, 0.0f).orientation[0] = 0.05f;
        } else if (which_ == Solids::ground) {
            lr_collider_desc capsule = collider_desc(LR_COLLIDER_CAPSULE);
            capsule.size[0] = 0.2f, capsule.size[1] = 0.4f;
            capsule.orientation[2] = 0.9f; // tilted
            add(capsule, -1.0f, 0.2f, 1.0f);
            add(collider_desc(LR_COLLIDER_PLANE), 0.0f, 0.0f, 0.0f).restitution = 0.5f;
            add(sphere_collider(0.4f), -1.0f, 0.1f, -1.0f).friction = 0.1f;
            lr_collider_desc& box = add(box_collider(0.5f, 0.1f, 0.4f), 1.0f, 0.2f, -1.0f);
            box.orientation[0] = 0.2f, box.orientation[1] = 0.3f;
        } else {
            lr_collider_desc& turning = add(hull_collider(corners_), -1.0f, 0.2f, 0.5f);
            set(turning.angular_velocity, 0.2f, 1.0f, -0.3f);
            const std::vector<float>& corners = corners_;
            lr_collider_desc still = hull_collider(corners);
            still.vertex_count = 8;
            add(still, -1.0f, 0.1f, -1.0f);
            add(mesh_collider(sheet_), 0.5f, 0.1f, -1.5f).friction = 1.0f;
        }
        return all;
    }

    Solids which_;
    std::vector<float> heights_ = std::vector<float>(81), corners_;
    Triangles sheet_;
    std::vector<lr_collider> ids_;
};

} // namespace test
