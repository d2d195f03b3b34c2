// Steps, and the effects of rules and emitters.
#include "fuzz/api/model.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace fuzz {
namespace {

// Bodies after a step: those before, without the ended, with the spawned.
void account(World& w, Batch& b) {
    const lr_batch_view view = view_of(w, b.id);
    lr_batch_counts counts = initialised(LR_CALL(lr_batch_counts_init));
    if (LR_CALL(lr_batch_get_counts)(w.at, b.id, &counts) != LR_OK) defect("lr_batch_get_counts", "failed");
    const std::set<lr_body> before(b.bodies.begin(), b.bodies.end());
    uint64_t causes = uint64_t{counts.by_divergence} + counts.by_age;
    for (uint32_t n : counts.by_volume) causes += n;
    if (causes != uint64_t{counts.destroyed} + counts.respawned) defect("lr_batch_get_counts", "causes");
    if (counts.total_spawned < counts.spawned || counts.total_destroyed < counts.destroyed)
        defect("lr_batch_get_counts", "totals");
    if ((counts.destroyed != 0 && !b.rules) || (counts.spawned != 0 && !b.emitter) ||
        (counts.respawned != 0 && !b.respawns))
        defect("lr_batch_get_counts", "without rules or emitter");
    // A missing body was destroyed, a new body was spawned.
    const std::set<lr_body> now(view.ids, view.ids + view.count);
    std::vector<lr_body> gone, came;
    std::set_difference(before.begin(), before.end(), now.begin(), now.end(), std::back_inserter(gone));
    std::set_difference(now.begin(), now.end(), before.begin(), before.end(), std::back_inserter(came));
    if (now.size() != view.count || gone.size() != counts.destroyed || came.size() != counts.spawned)
        defect("lr_world_step", "bodies came or went unseen");
    for (const lr_body id : gone) remember(w.stale_bodies, id);
    b.bodies.assign(view.ids, view.ids + view.count);
    lr_batch_pace pace = initialised(LR_CALL(lr_batch_pace_init));
    if (LR_CALL(lr_batch_get_pace)(w.at, b.id, &pace) != LR_OK) defect("lr_batch_get_pace", "failed");
    // Rules end every body at a non-finite place.
    for (uint32_t i = 0; b.rules && pace.substeps != 0 && i < view.awake_count; ++i)
        for (size_t k = 0; k < 3; ++k)
            if (!std::isfinite(view.position[k][i])) defect("lr_world_step", "rules left a body that is not finite");
}

void step(Fuzzer& f) {
    World& w = f.world();
    static constexpr float times[] = {1.0f / 60.0f, 1.0f / 60.0f, 1.0f / 30.0f, 0.001f,
                                      0.1f,         0.5f,         1.0f,         1.0f / 240.0f};
    float dt = times[f.in.handle(0) % 8];
    uint32_t substeps = 1 + f.in.handle(1) % 4;
    f.in.change(dt);
    if (f.in.flag(flag_size)) substeps = f.in.handle(1) % 2 ? 0 : LR_MAX_SUBSTEPS + 1 + f.in.handle(2);
    step_world(f, w, dt, substeps);
}

} // namespace

bool step_world(Fuzzer& f, World& w, float dt, uint32_t substeps) {
    Expected e;
    e.add_if(!std::isfinite(dt), LR_ERROR_TIMESTEP_NOT_FINITE);
    e.add_if(dt == 0.0f, LR_ERROR_TIMESTEP_ZERO);
    e.add_if(dt < 0.0f, LR_ERROR_TIMESTEP_NEGATIVE);
    e.add_if(substeps == 0 || substeps > LR_MAX_SUBSTEPS, LR_ERROR_SUBSTEPS);
    e.add_if(std::isfinite(dt) && substeps != 0 &&
                 static_cast<double>(dt) / substeps > static_cast<double>(LR_MAX_SUBSTEP),
             LR_ERROR_TIMESTEP_TOO_LARGE);
    if (!e.fails() && w.at && f.substeps_left < substeps) return false; // enough for one run
    Call call(f, w, "lr_world_step", e);
    const bool wild = w.state.wild;
    lr_status status = LR_CALL(lr_world_step)(call.world(), dt, substeps);
    const bool starved = w.memory->refused();
    if (starved) {
        if (status != LR_ERROR_OUT_OF_MEMORY) defect("lr_world_step", "has no memory, and does not say so", status);
        w.memory->begin(); // the step was taken nevertheless
        status = LR_OK;
    }
    const bool ok = call.ended(status);
    w.state.wild = wild;
    if (!ok) return false;
    f.substeps_left -= substeps;
    w.state.substeps += substeps;
    w.state.time += static_cast<double>(dt);
    for (Batch& b : w.state.batches)
        if (w.state.loose) {
            const lr_batch_view view = view_of(w, b.id);
            b.bodies.assign(view.ids, view.ids + view.count);
        } else {
            account(w, b);
        }
    check_world(w);
    return !starved;
}

std::vector<Named> step_operations() {
    return {{"step", step}, {"step", step}, {"step", step}, {"step", step}};
}

} // namespace fuzz
