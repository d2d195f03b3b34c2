// Worlds: creation, steps, snapshots, recordings and queries.
#include "api/checked_call.h"

namespace lr::api {
namespace {

static_assert(sizeof(lr_ray_hit) == 56);

// Null if valid, else the reason. The numbers are finite.
const char* wrong_in(const lr_ray& r) {
    if (r.flags == 0 || (r.flags & ~uint32_t{LR_RAY_BODIES | LR_RAY_COLLIDERS}) != 0)
        return "flags are not bits LR_RAY_*";
    if (!within(r.origin, most_place)) return "origin is over 1e9 m";
    double square = 0.0;
    for (float x : r.direction) square += wide(x) * wide(x);
    if (!in_range(square, 0.999e-12, 1.001e12)) return "direction is not 1e-6 to 1e6 long";
    if (!in_range(r.max_distance, 0.0, most_place)) return "max_distance is not 0 to 1e9 m";
    return nullptr;
}

const char* wrong_in(const lr_overlap_desc& d) {
    if (d.shape != LR_OVERLAP_SPHERE && d.shape != LR_OVERLAP_BOX) return "unknown shape";
    if (!within(d.position, most_place)) return "position is over 1e9 m";
    if (!normalisable(d.orientation)) return "orientation cannot be normalised";
    for (int k = 0; k < (d.shape == LR_OVERLAP_SPHERE ? 1 : 3); ++k)
        if (!(d.size[k] > 0.0f) || !in_range(d.size[k], 0.0, most_size)) return "size is not above 0 and up to 1e6 m";
    return nullptr;
}

bool known_simd(int32_t target) {
    return target >= LR_SIMD_AUTO && target <= LR_SIMD_PLAIN;
}

// The numbers are finite.
const char* wrong_in(const lr_world_desc& d) {
    if (d.worker_count > WorkerPool::max_workers) return "worker_count is over 64";
    if (!in_range(d.fluid_density, 0.0, 1e6)) return "fluid_density is not 0 to 1e6 kg/m^3";
    if (!in_range(d.fluid_viscosity, 0.0, 1e3)) return "fluid_viscosity is not 0 to 1e3 m^2/s";
    if (!known_simd(d.simd_target)) return "unknown simd_target";
    if (!d.allocator.allocate != !d.allocator.release) return "`allocator` needs both functions or none";
    if (!d.jobs.enqueue != !d.jobs.finish) return "`jobs` needs both functions or none";
    if ((d.checks & ~uint32_t{LR_CHECK_THREADS}) != 0) return "unknown checks";
    return wrong_gravity(d.gravity);
}

// Records a call that recreates a part of the world. False when out of memory.
template <class... A> bool set_up(recording::Recorder& recorder, const char* function, const A&... given) {
    Call call(recorder, function, recording::Kind::setup);
    return call.arguments([&](Call& c) { (record_argument(c, given), ...); });
}

// Samples of wind grids, and arrays of hulls, heightfields and meshes, of which snapshots contain only hashes.
bool set_up_geometry(recording::Recorder& recorder, const lr_world& world) {
    bool enough = true;
    world.wind.visit_grids([&](SourceDesc desc, uint64_t hash, const float* samples) {
        if (recorder.seen(hash)) return;
        desc.samples = samples;
        lr_wind_grid_desc grid;
        desc_of(source_type::wind_grid, desc, &grid);
        enough = set_up(recorder, "lr_world_add_wind_grid", SourceOf{source_type::wind_grid, &grid}) && enough;
    });
    world.colliders.visit_shared([&](uint64_t hash, const lr_collider_desc& desc) {
        if (recorder.seen(hash)) return;
        enough = set_up(recorder, "lr_collider_create", Structs{&desc, 1}) && enough;
        recorder.whole(recording::Kind::geometry, hash);
    });
    return enough;
}

// Records the present state: batches with their assets, geometry, and a snapshot of all else.
lr_status begin_recording(recording::Recorder& recorder, lr_world& world) {
    recorder.begin(world);
    for (uint32_t i = 0; i < world.batch_slots; ++i) {
        const Batch* const batch = world.batches[i].batch;
        if (!batch)
            recorder.whole(recording::Kind::hole);
        else if (!set_up(recorder, "lr_batch_create", &batch->settings().desc))
            return LR_ERROR_OUT_OF_MEMORY;
    }
    Buffer<unsigned char> snapshot;
    const uint64_t size = snapshot_size(world);
    if (!set_up_geometry(recorder, world) || !snapshot.allocate(world.allocator, size)) return LR_ERROR_OUT_OF_MEMORY;
    const lr_status status = snapshot_save(world, snapshot.data(), size, nullptr);
    if (status != LR_OK) return status;
    set_up(recorder, "lr_world_snapshot_restore", Snapshot{snapshot.data(), size});
    if (world.events.on())
        set_up(recorder, "lr_world_set_events", static_cast<uint32_t>(world.events.items.size()), world.events.kinds);
    if (world.wind.callback()) set_up(recorder, "lr_world_set_wind_callback", 1u);
    if (world.surface.callback()) set_up(recorder, "lr_world_set_water_callback", 1u);
    recorder.whole(recording::Kind::begun, world.hash());
    if (recorder.failed()) return LR_ERROR_INVALID_ARGUMENT;
    recorder.listen(world);
    return LR_OK;
}
} // namespace

void end_recording(lr_world& world, const char* why) {
    world.recorder->end(world);
    recording::Recorder::destroy(world.recorder);
    world.recorder = nullptr;
    if (why) world.log(LR_LOG_WARNING, "lr_world_record_start", why);
}
} // namespace lr::api

using namespace lr;
using namespace lr::api;

extern "C" {

lr_status lr_world_create(const lr_world_desc* desc, lr_world** out) {
    if (out) *out = nullptr;
    const auto create = [&]() -> Outcome {
        lr_world_desc d{};
        if (!out) return LR_ERROR_NULL_ARGUMENT;
        if (const Outcome outcome = read_struct(desc, d); outcome.refused()) return outcome;
        if (!finite(d.gravity, d.fluid_density, d.fluid_viscosity)) return LR_ERROR_NOT_FINITE;
        if (const char* why = wrong_in(d)) return invalid(why);
        return guarded([&] {
            lr_status status = LR_OK;
            *out = lr_world::create(d, status);
            return status;
        });
    };
    return note_refusal("lr_world_create", create());
}

void lr_world_destroy(lr_world* world) {
    if (!world) return;
    // Never leaves the guard, so that calls from other threads or from the allocator are refused until the world is gone.
    if (world->call_guard.checked() && enter(*world, "lr_world_destroy") != LR_OK) return;
    if (world->recorder) end_recording(*world, nullptr);
    lr_world::destroy(world);
}

lr_status lr_world_get_info(const lr_world* world, lr_world_info* info) {
    return query(world, args(info), [](const lr_world& w, lr_world_info& out) {
        out.simd_target = w.target->simd;
        out.worker_count = w.step_workers.helpers();
        w.each_batch([&out](const Batch& batch, uint32_t) {
            ++out.batch_count;
            out.body_count += batch.count();
            out.awake_count += batch.awake();
        });
        out.substep_count = w.substep_count;
        out.time = w.time;
        out.memory_bytes = w.allocator.bytes();
        out.collider_count = w.colliders.count();
        out.budget = w.pacing.record().budget;
        std::copy(w.gravity, w.gravity + 3, out.gravity);
    });
}

lr_status lr_world_set_gravity(lr_world* world, const float* gravity) {
    return change(world, args(gravity), [](lr_world& w, Triple to) -> Outcome {
        if (const char* why = wrong_gravity(to)) return invalid(why);
        if (std::equal(to, to + 3, w.gravity)) return {};
        std::copy(to, to + 3, w.gravity);
        w.each_batch([](Batch& batch, uint32_t) { batch.wake_all(); });
        return {};
    });
}

lr_status lr_world_set_simd_target(lr_world* world, int32_t target) {
    return change(world, args(target), [](lr_world& w, int32_t to) -> Outcome {
        if (!known_simd(to)) return invalid("unknown target");
        const KernelTarget* const found = find_target(to);
        if (!found) return LR_ERROR_UNSUPPORTED;
        w.target = found;
        return {};
    });
}

lr_status lr_world_step(lr_world* world, float dt, uint32_t substeps) {
    const FloatMode mode; // saves the caller's float mode and restores it while the caller's job system runs
    return change(world, args(dt, substeps), [&mode](lr_world& w, float t, uint32_t n) -> Outcome {
        if (!std::isfinite(t)) return LR_ERROR_TIMESTEP_NOT_FINITE;
        if (t == 0.0f) return LR_ERROR_TIMESTEP_ZERO;
        if (t < 0.0f) return LR_ERROR_TIMESTEP_NEGATIVE;
        if (n == 0 || n > LR_MAX_SUBSTEPS) return LR_ERROR_SUBSTEPS;
        if (wide(t) / n > wide(LR_MAX_SUBSTEP)) return LR_ERROR_TIMESTEP_TOO_LARGE;
        if (w.step(t, n, mode)) return {};
        return {LR_ERROR_OUT_OF_MEMORY, "out of memory: the step was taken, but bodies can pass through each other"};
    });
}

lr_status lr_world_set_budget(lr_world* world, uint64_t body_substeps) {
    return change(world, args(body_substeps), [](lr_world& w, uint64_t most) -> Outcome {
        if (most > StepScheduler::largest_budget) return invalid("body_substeps is over 2^48");
        w.pacing.set_budget(most);
        return {};
    });
}

lr_status lr_world_get_step_report(const lr_world* world, lr_step_report* report) {
    return query(world, args(report), [](const lr_world& w, lr_step_report& out) { out = w.pacing.report(); });
}

lr_status lr_world_get_timings(const lr_world* world, lr_timings* timings) {
    return query(world, args(timings), [](const lr_world& w, lr_timings& out) { out = w.timings; });
}

lr_status lr_world_hash(const lr_world* world, uint64_t* out) {
    return query(world, args(Required(out)), [](const lr_world& w, uint64_t& hash) { hash = w.hash(); });
}

uint64_t lr_world_snapshot_size(const lr_world* world) {
    uint64_t size = 0;
    const auto get = [](const lr_world& w, uint64_t& out) { out = snapshot_size(w); };
    query(world, args(Required(&size)), get);
    return size;
}

lr_status lr_world_snapshot_save(const lr_world* world, void* memory, uint64_t size, uint64_t* written) {
    if (written) *written = 0;
    return query(world, args(), [&](const lr_world& w) -> Outcome {
        return memory ? snapshot_save(w, memory, size, written) : LR_ERROR_NULL_ARGUMENT;
    });
}

lr_status lr_world_snapshot_restore(lr_world* world, const void* memory, uint64_t size) {
    return change(world, args(Snapshot{memory, size}), [](lr_world& w, Snapshot from) -> Outcome {
        if (!from.memory) return LR_ERROR_NULL_ARGUMENT;
        if (!snapshot_is_whole(from.memory, from.size)) return LR_ERROR_SNAPSHOT_FORMAT;
        return accepted(w) ? snapshot_restore(w, from.memory) : LR_ERROR_OUT_OF_MEMORY;
    });
}

lr_status lr_world_record_start(lr_world* world, const lr_recording_desc* desc) {
    return query(world, args(desc), [world](const lr_world&, const lr_recording_desc& d) -> Outcome {
        if (!d.write) return {LR_ERROR_NULL_ARGUMENT, "desc->write is null"};
        if ((d.flags & ~uint32_t{LR_RECORD_CALLBACKS}) != 0) return invalid("unknown flags");
        if (world->recorder) return invalid("the world is already being recorded");
        recording::Recorder* const recorder = recording::Recorder::create(world->allocator, d);
        if (!recorder) return LR_ERROR_OUT_OF_MEMORY;
        const lr_status status = guarded([&] { return begin_recording(*recorder, *world); });
        if (status == LR_OK) {
            world->recorder = recorder;
            return {};
        }
        recording::Recorder::destroy(recorder);
        return {status, status == LR_ERROR_INVALID_ARGUMENT ? "`write` returned an error" : nullptr};
    });
}

lr_status lr_world_record_stop(lr_world* world) {
    return query(world, args(), [world](const lr_world&) -> Outcome {
        if (!world->recorder) return invalid("the world is not being recorded");
        end_recording(*world, nullptr);
        return {};
    });
}

lr_status lr_world_ray_cast(const lr_world* world, const lr_ray* rays, uint32_t count, lr_ray_hit* hits) {
    const auto cast = [](const lr_world& w, const Structs<lr_ray>& all, lr_ray_hit* out) -> Outcome {
        if (all.count != 0 && !out) return LR_ERROR_NULL_ARGUMENT;
        const Outcome outcome = all.check([&](const lr_ray& r) -> Outcome {
            if (!finite(r.origin, r.direction, r.max_distance)) return LR_ERROR_NOT_FINITE;
            if (const char* why = wrong_in(r)) return invalid(why);
            return r.batch.id != 0 && !w.find(r.batch) ? LR_ERROR_STALE_BATCH : LR_OK;
        });
        if (outcome.refused()) return outcome;
        all.visit([&](const lr_ray& r) { *out++ = cast_ray(w, r, r.batch.id != 0 ? w.find(r.batch) : nullptr); });
        return {};
    };
    return query(world, args(Structs{rays, count}, hits), cast);
}

lr_status lr_world_overlap(const lr_world* world, const lr_overlap_desc* desc, lr_body* bodies, uint32_t capacity,
                           uint32_t* count) {
    if (count) *count = 0;
    const auto find = [&](const lr_world& w, uint32_t& found, const lr_overlap_desc& d) -> Outcome {
        if (!bodies && capacity != 0) return LR_ERROR_NULL_ARGUMENT;
        if (!finite(d.position, d.orientation, d.size)) return LR_ERROR_NOT_FINITE;
        if (const char* why = wrong_in(d)) return invalid(why);
        const Batch* const only = d.batch.id != 0 ? w.find(d.batch) : nullptr;
        if (d.batch.id != 0 && !only) return LR_ERROR_STALE_BATCH;
        found = find_overlaps(w, d, only, bodies, capacity);
        return found <= capacity ? LR_OK : LR_ERROR_BUFFER_TOO_SMALL;
    };
    return query(world, args(Required(count), desc), find);
}

} // extern "C"
