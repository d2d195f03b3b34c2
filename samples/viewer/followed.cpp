// SPDX-License-Identifier: MIT
#include "followed.h"

#include <algorithm>
#include <cmath>

#include "drawing/failure.h"

namespace {

double wide(float x) {
    return static_cast<double>(x);
}
double size_of(const float* a) {
    return std::hypot(wide(a[0]), wide(a[1]), wide(a[2]));
}
} // namespace

Followed followed(const viewer& v) {
    Followed body;
    check(lr_body_state_init(&body.state, sizeof body.state), "lr_body_state_init", nullptr);
    check(lr_body_loads_init(&body.loads, sizeof body.loads), "lr_body_loads_init", nullptr);
    body.there = lr_body_get_state(v.scene->world, v.followed, &body.state) == LR_OK;
    if (body.there) check(lr_body_get_loads(v.scene->world, v.followed, &body.loads), "loads", nullptr);
    body.mass = v.scene->batches[v.followed_batch].info.mass * std::pow(wide(body.state.scale), 3);
    body.weight = 9.81 * body.mass;
    return body;
}

void describe(const viewer& v, const Followed& body) {
    const lr_body_state& s = body.state;
    const lr_body_loads& flow = body.loads;
    const double spin = size_of(s.angular_velocity);
    ImGui::Text("%s, %.3g g, %.1f s old", v.scene->batches[v.followed_batch].info.name, 1e3 * body.mass, wide(s.age));
    ImGui::Text("at %.2f %.2f %.2f m", wide(s.position[0]), wide(s.position[1]), wide(s.position[2]));
    ImGui::Text("falls %.2f m/s, drifts %.2f m/s", -wide(s.linear_velocity[1]),
                std::hypot(wide(s.linear_velocity[0]), wide(s.linear_velocity[2])));
    ImGui::Text("%.2f m/s, in the flow %.2f m/s", size_of(s.linear_velocity), size_of(flow.stream));
    ImGui::Text("turns %.1f rad/s (%.0f a minute)", spin, spin * 60.0 / 6.283185307);
    ImGui::Text("wake %.2f m/s, its vortices %.2f", size_of(flow.wake), size_of(flow.shedding));
    ImGui::Text("lift %.2f, push %.2f of its weight", wide(flow.force[1]) / body.weight,
                std::hypot(wide(flow.force[0]), wide(flow.force[2])) / body.weight);
    for (uint32_t i = 0; i < flow.station_count && flow.station_count > 1; ++i)
        ImGui::Text("  station %u: %.2f", i + 1, size_of(flow.station_force + 3 * i) / body.weight);
}

// Corners around the followed body, and the force of the flow at each of its stations: three radii long for a force of its weight.
void frame_body(const viewer& v, const Followed& body) {
    const Eye eye(v);
    ImVec2 middle;
    if (!eye.sees(v.followed_at, middle)) return;
    const float letter = ImGui::GetFontSize(), thick = 0.12f * letter;
    const float radius = v.bodies.batches[v.followed_batch].radius;
    const float reach = std::max(eye.pixels(v.followed_at, radius) + 0.4f * letter, 0.7f * letter);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    for (int i = 0; i < 4; ++i) {
        const float sx = i & 1 ? 1.0f : -1.0f, sy = i & 2 ? 1.0f : -1.0f;
        const ImVec2 corner(middle.x + sx * reach, middle.y + sy * reach);
        const ImU32 colour = IM_COL32(250, 184, 56, 220);
        list.AddLine(corner, ImVec2(corner.x - 0.5f * sx * reach, corner.y), colour, thick);
        list.AddLine(corner, ImVec2(corner.x, corner.y - 0.5f * sy * reach), colour, thick);
    }
    for (uint32_t i = 0; i < body.loads.station_count; ++i) {
        const vec3 at = from_array(body.loads.station_position + 3 * i);
        const vec3 by = from_array(body.loads.station_force + 3 * i);
        ImVec2 foot, tip;
        const float length = 3.0f * radius / static_cast<float>(body.weight);
        if (!eye.sees(at, foot) || !eye.sees(add(at, scaled(by, length)), tip)) continue;
        const ImU32 colour = IM_COL32(90, 220, 255, 230);
        list.AddCircleFilled(foot, 1.5f * thick, colour);
        list.AddLine(foot, tip, colour, thick);
    }
}
