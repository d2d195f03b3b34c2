// The state that a recording begins with, as calls that make it again.
#include "asset/asset.h"
#include "record/recorder.h"
#include "world/snapshot.h"
#include "world/world.h"

#include <algorithm>

namespace lr::record {
namespace {

void open_setup(Recorder& to, Op op) {
    to.open(Kind::setup);
    to.value(static_cast<uint16_t>(op));
    to.value(uint16_t{0});
}

// As the player's reader takes them: api/recorded_call.h.
template <class T> void structure(Recorder& to, const T& s) {
    to.value(Where::here);
    to.value(recorded_bytes<T>);
    to.put(&s, recorded_bytes<T>);
}
void array(Recorder& to, const void* bytes, uint64_t size) {
    to.value(bytes ? Where::here : Where::null);
    if (!bytes) return;
    to.value(size);
    to.put(bytes, size);
}

BatchRecord record_of(const Batch& batch, uint32_t asset) {
    const BatchSettings& s = batch.settings();
    BatchRecord r{};
    r.asset = asset;
    r.capacity = batch.capacity();
    r.load_model = s.loads == Loads::none       ? LR_LOADS_NONE
                   : s.loads == Loads::langevin ? LR_LOADS_LANGEVIN
                                                : LR_LOADS_AERODYNAMIC;
    r.clock = s.clock == Clock::age ? LR_CLOCK_AGE : LR_CLOCK_SPEED;
    r.table_end = s.loop ? LR_TABLE_LOOP : LR_TABLE_CLAMP;
    r.integrator = s.integrator == Integrator::rk4 ? LR_INTEGRATOR_RK4 : LR_INTEGRATOR_SPLITTING;
    r.damping_gain = static_cast<float>(s.gains.damping);
    r.noise_gain = static_cast<float>(s.gains.noise);
    return r;
}

} // namespace

lr_status Recorder::batches(lr_world& world) {
    for (uint32_t i = 0; i < world.batch_slots; ++i) {
        const Batch* const batch = world.batches[i].batch;
        if (!batch) {
            open(Kind::hole);
            close();
            continue;
        }
        uint32_t id = 0;
        if (!asset(batch->asset(), id)) return LR_ERROR_OUT_OF_MEMORY;
        open_setup(*this, Op::batch_create);
        value(Where::here);
        value(record_of(*batch, id));
        close();
    }
    return LR_OK;
}

// Samples of grids, and what hulls, heightfields and meshes are made of: snapshots name them by their hash alone.
void Recorder::geometry(lr_world& world) {
    world.wind.visit_grids([&](const lr_wind_source_desc& desc, uint64_t hash, const float* samples, uint64_t count) {
        if (seen(hash)) return;
        open_setup(*this, Op::world_add_wind);
        structure(*this, desc);
        array(*this, samples, count * sizeof(float));
        close();
    });
    world.colliders.visit_shared([&](uint64_t hash, const lr_collider_desc& desc) {
        if (seen(hash)) return;
        open_setup(*this, Op::collider_create);
        value(uint32_t{1});
        value(Where::here);
        value(recorded_bytes<lr_collider_desc>);
        put(&desc, recorded_bytes<lr_collider_desc>);
        array(*this, desc.vertices, 12 * uint64_t{desc.vertex_count});
        array(*this, desc.indices, 12 * uint64_t{desc.triangle_count});
        array(*this, desc.heights, 4 * uint64_t{desc.counts[0]} * desc.counts[1]);
        close();
        open(Kind::geometry);
        value(hash);
        close();
    });
}

lr_status Recorder::state(const lr_world& world) {
    Buffer<unsigned char> snapshot;
    const uint64_t size = snapshot_size(world);
    uint64_t written = 0;
    if (!snapshot.allocate(*allocator_, size)) return LR_ERROR_OUT_OF_MEMORY;
    const lr_status status = snapshot_save(world, snapshot.data(), size, &written);
    if (status != LR_OK) return status;
    open_setup(*this, Op::world_snapshot_restore);
    array(*this, snapshot.data(), written);
    close();
    return LR_OK;
}

lr_status Recorder::begin(lr_world& world) {
    FileHeader header{{}, format_version, lr_version()};
    std::copy(std::begin(magic), std::end(magic), header.magic);
    failed_ = desc_.write(desc_.user, &header, sizeof header) != 0;
    WorldRecord record{};
    record.seed = world.seed;
    record.step_count = world.step_count;
    std::copy(world.gravity, world.gravity + 3, record.gravity);
    record.fluid_density = world.fluid_density;
    record.fluid_viscosity = world.fluid_viscosity;
    record.simd = world.target->simd;
    record.workers = world.crew.helpers();
    record.flags = desc_.flags;
    record.hash_interval = desc_.hash_interval;
    open(Kind::world);
    value(record);
    close();
    lr_status status = batches(world);
    if (status != LR_OK) return status;
    geometry(world);
    status = state(world);
    if (status != LR_OK) return status;
    if (world.contact_events.on()) {
        open_setup(*this, Op::world_set_contact_events);
        value(static_cast<uint32_t>(world.contact_events.events.size()));
        value(world.contact_events.kinds);
        close();
    }
    const bool called[2] = {world.wind.callback() != nullptr, world.surface.callback() != nullptr};
    for (int k = 0; k < 2; ++k) {
        if (!called[k]) continue;
        open_setup(*this, k == 0 ? Op::world_set_wind_callback : Op::world_set_surface_callback);
        value(uint32_t{1});
        close();
    }
    open(Kind::begun);
    value(world.hash());
    close();
    if (failed_) return LR_ERROR_INVALID_ARGUMENT;
    listen(world);
    return LR_OK;
}

} // namespace lr::record
