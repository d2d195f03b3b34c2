// The body that the camera follows: its state and the loads of the flow, as text and drawn over the picture.    SPDX-License-Identifier: MIT
#ifndef VIEWER_FOLLOWED_H
#define VIEWER_FOLLOWED_H

#include <imgui.h>
#include <langevin_rigid_research.h>

extern "C" {
#include "viewer.h"
}

// Where a point is in the picture.
struct Eye {
    float w, h;
    camera_view view;

    explicit Eye(const viewer& v)
        : w(static_cast<float>(v.picture.width)), h(static_cast<float>(v.picture.height)),
          view(camera_look(&v.camera, w / h)) {}
    bool sees(vec3 at, ImVec2& to) const {
        float x, y;
        if (!camera_project(&view, at, &x, &y)) return false;
        to = ImVec2(0.5f * (1.0f + x) * w, 0.5f * (1.0f - y) * h);
        return true;
    }
    float pixels(vec3 at, float size) const {
        return 0.5f * h * size / (view.tan_half * -dot(sub(at, view.eye), view.back));
    }
};

struct Followed {
    bool there;
    double mass, weight; // kg, N
    lr_body_state state;
    lr_body_loads loads;
};
Followed followed(const viewer& v);

void describe(const viewer& v, const Followed& body);
void frame_body(const viewer& v, const Followed& body);

#endif
