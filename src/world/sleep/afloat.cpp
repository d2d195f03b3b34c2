#include "world/sleep/afloat.h"

#include "kernel/divergence.h"
#include "world/world.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

// Times still_speed, as in a heap: a fall sets water in motion, which moves floats on for long, ever slower.
constexpr float afloat_still = 3.0f;

// blur: m, as in the kernel, for bodies thinner than their fall in a substep.
bool cuts(const SurfaceInstant& plane, const WaterBody& water, float scale, const Pose& pose, float blur) {
    const Vector up = vector_of(plane.up), normal = rotate(inverse(pose.rotation), up);
    float squared = 0.0f;
    for (size_t i = 0; i < 3; ++i) {
        const float along = dot(vector_of(water.axes + 3 * i), normal);
        squared += water.semi_axes_squared[i] * (along * along);
    }
    const float height = dot(up, pose.position - vector_of(plane.point)) + scale * dot(normal, vector_of(water.center));
    return height * height < scale * scale * squared + blur * blur;
}
} // namespace

void rest_afloat(const lr_world& world, Batch& batch, uint32_t begin, uint32_t end) {
    if (!world.surface.present() || !batch.columns().has(part_contact)) return;
    const ContactCache book = batch.contact_cache();
    const BatchArrays& a = batch.arrays();
    const BodyShape& shape = batch.asset().shape;
    const WaterBody* const water = batch.step.water;
    const bool still = water && may_sleep(batch.contact()) && !world.surface.callback() &&
                       world.surface.highest() == 0.0f &&
                       (batch.contact().layers != 0 || world.pairs.has_contact(batch.slot()));
    const SurfaceInstant plane = world.surface.at(world.time);
    const float gravity = length(vector_of(world.gravity)), speed = afloat_still * still_speed(gravity);
    const float blur = gravity * batch.step.h * batch.step.h;
    const auto seconds = static_cast<float>(batch.pace.behind());
    for (uint32_t i = begin; i < std::min(end, batch.awake()); ++i) {
        uint32_t& touching = book.touching[0][i];
        if (touching != 0 && touching != touching_water) continue;
        const Vector v = vector_in(a.field, field_vx, i), w = vector_in(a.field, field_wx, i);
        const float scale = a.field[field_scale][i];
        BodyAfter body{};
        body.index = i;
        body.reach = scale * shape.reach;
        body.extent = scale * shape.extent;
        body.still = speed * std::sqrt(body.reach);
        body.place = stay_way * body.reach;
        body.speed = fastest(body.extent, v, w);
        const Pose pose = pose_of(a, i);
        if (!still || body.speed > trembling * body.still || is_held(a.field[field_age_remainder][i]) ||
            !cuts(plane, *water, scale, pose, blur)) {
            if (touching != 0) book.forget(i);
            continue;
        }
        // Floats that move faster than still ones start over: nothing else stops a drift.
        touching = touching_water;
        body.way = seconds * rotate(pose.rotation, v), body.turn = seconds * w;
        float& stillness = book.stillness[i];
        stillness = body.speed <= body.still ? stillness + seconds / time_to_sleep : 0.0f;
        if (stays(book, body, seconds) || stillness >= 1.0f) batch.note_sleep(i);
    }
}

void forget_afloat(Batch& batch) {
    if (!batch.columns().has(part_contact)) return;
    const ContactCache book = batch.contact_cache();
    for (uint32_t i = 0; i < batch.awake(); ++i)
        if (book.touching[0][i] == touching_water) book.forget(i);
}

// A float drifts at sqrt(rho_a/rho_w) times the wind.
bool wakes_afloat(const lr_world& world, const Batch& batch, uint32_t index, Vector wind) {
    const float speed = afloat_still * still_speed(length(vector_of(world.gravity)));
    const float reach = batch.asset().shape.reach * batch.arrays().field[field_scale][index];
    return world.surface.callback() || dot(wind, wind) * static_cast<float>(batch.settings().fluid_density) >
                                           speed * speed * reach * world.surface.desc().density;
}
} // namespace lr
