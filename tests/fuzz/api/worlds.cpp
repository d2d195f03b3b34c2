// Worlds, functions without a world, and settings of a whole world.
#include "fuzz/api/model.h"

namespace fuzz {
namespace {

void log(void* user, int32_t level, const char* message) {
    if (level < LR_LOG_ERROR || level > LR_LOG_INFO || !message || message[0] == 0)
        defect("lr_log_fn", "an empty message");
    ++*static_cast<uint32_t*>(user);
}
uint32_t messages = 0;

void end_world(World& w) {
    check_world(w);
    LR_CALL(lr_world_destroy)(w.at);
    if (w.memory->live() != 0) defect("lr_world_destroy", "memory is lost", static_cast<int64_t>(w.memory->live()));
    w = World{};
}

void create(Fuzzer& f) {
    Input& in = f.in;
    World& w = f.world();
    if (w.at) end_world(w);
    lr_world_desc d = initialised(LR_CALL(lr_world_desc_init));
    d.log = in.variant() == 0 ? nullptr : log, d.log_user = &messages;
    d.simd_target = in.handle(0) < 64 ? static_cast<int32_t>(in.handle(0) % 9) : LR_SIMD_AUTO;
    // Threads take time to start, so most worlds have none.
    d.worker_count = in.handle(1) >= 250 ? in.handle(1) % 3u : 0u;
    if (in.handle(1) >= 224 && in.handle(1) < 250)
        d.jobs = hostile_jobs(in.handle(1)), d.worker_count = in.handle(1) % 3;
    in.change(d.seed, d.gravity, d.fluid_density, d.fluid_viscosity, d.simd_target);
    Expected e;
    e.range(d.gravity, -1e4, 1e4);
    e.range(d.fluid_density, 0.0, 1e6);
    e.range(d.fluid_viscosity, 0.0, 1e3);
    e.add_if(d.simd_target < 0 || d.simd_target > LR_SIMD_PLAIN, LR_ERROR_INVALID_ARGUMENT);
    e.may_if(d.simd_target > LR_SIMD_AUTO && d.simd_target <= LR_SIMD_PLAIN, LR_ERROR_UNSUPPORTED);
    d.allocator = w.memory->hooks();
    if (in.handle(0) >= 250) {
        const uint32_t half = in.handle(0) % 4;
        if (half == 0) d.allocator.release = nullptr;
        if (half == 1) d.jobs.finish = hostile_jobs(1).finish, d.jobs.enqueue = nullptr;
        if (half == 2) d.worker_count = in.handle(2) % 2 ? 65 : 0xffffffffu;
        e.add_if(half < 3, LR_ERROR_INVALID_ARGUMENT);
        if (half == 3) w.memory->fail_after(1 + in.handle(2) % 4u), e.may(LR_ERROR_OUT_OF_MEMORY);
    }
    Given<lr_world_desc> given(in, d, 1, e);
    e.add_if(in.null(2), LR_ERROR_NULL_ARGUMENT);
    w.memory->begin();
    lr_world* at = nullptr;
    const lr_status status = LR_CALL(lr_world_create)(given.get(), in.null(2) ? nullptr : &at);
    if (!e.allows(status)) defect("lr_world_create", "status", status);
    if (w.memory->refused() != (status == LR_ERROR_OUT_OF_MEMORY)) defect("lr_world_create", "memory", status);
    if ((at != nullptr) != (status == LR_OK)) defect("lr_world_create", "world and status do not agree", status);
    w.memory->fail_after(0);
    w.at = at;
    w.desc = d;
    w.state.wild = in.hostile();
    if (!at && w.memory->live() != 0) defect("lr_world_create", "memory is lost");
}

void destroy(Fuzzer& f) {
    LR_CALL(lr_world_destroy)(nullptr);
    World& w = f.world();
    if (w.at && f.in.variant() == 3) end_world(w);
}

void info(Fuzzer& f) {
    World& w = f.world();
    Expected e;
    Given<lr_world_info> given(f.in, initialised(LR_CALL(lr_world_info_init)), 1, e);
    Call call(f, w, "lr_world_get_info", e);
    if (call.ended(LR_CALL(lr_world_get_info)(call.world(), given.get()))) check_world(w);
}

void gravity(Fuzzer& f) {
    World& w = f.world();
    float g[3] = {0.0f, -9.81f, 0.0f};
    f.in.change(g);
    Expected e;
    e.range(g, -1e4, 1e4);
    e.add_if(f.in.null(1), LR_ERROR_NULL_ARGUMENT);
    Call call(f, w, "lr_world_set_gravity", e);
    if (call.ended(LR_CALL(lr_world_set_gravity)(call.world(), f.in.null(1) ? nullptr : g)) &&
        std::memcmp(info_of(w).gravity, g, sizeof g) != 0)
        defect("lr_world_get_info", "another gravity");
}

void simd(Fuzzer& f) {
    World& w = f.world();
    auto target = static_cast<int32_t>(f.in.handle(0) % 12) - 2;
    Expected e;
    e.add_if(target < 0 || target > LR_SIMD_PLAIN, LR_ERROR_INVALID_ARGUMENT);
    e.may_if(target > LR_SIMD_AUTO, LR_ERROR_UNSUPPORTED);
    Call call(f, w, "lr_world_set_simd_target", e);
    call.ended(LR_CALL(lr_world_set_simd_target)(call.world(), target));
}

void budget(Fuzzer& f) {
    World& w = f.world();
    uint64_t body_substeps = f.in.handle(1);
    f.in.change(body_substeps);
    if (f.in.variant() == 1) body_substeps = (uint64_t{1} << 48) + f.in.handle(1) % 2;
    Expected e;
    e.add_if(body_substeps > uint64_t{1} << 48, LR_ERROR_INVALID_ARGUMENT);
    Call call(f, w, "lr_world_set_budget", e);
    if (call.ended(LR_CALL(lr_world_set_budget)(call.world(), body_substeps)) && info_of(w).budget != body_substeps)
        defect("lr_world_get_info", "another budget");
}

void report(Fuzzer& f) {
    World& w = f.world();
    Expected e;
    Given<lr_step_report> given(f.in, initialised(LR_CALL(lr_step_report_init)), 1, e);
    Call call(f, w, "lr_world_get_step_report", e);
    if (!call.ended(LR_CALL(lr_world_get_step_report)(call.world(), given.get()))) return;
    const lr_step_report r = given.read();
    uint32_t busy = 0;
    for (const Batch& b : w.state.batches) busy += !b.bodies.empty();
    if (!w.state.loose && r.batches_stepped + r.batches_waiting + r.batches_passed_over > 64 + busy)
        defect("lr_world_get_step_report", "batches", r.batches_stepped);
    if (!(r.behind >= 0.0) || !(r.lost >= 0.0)) defect("lr_world_get_step_report", "a number is negative");
    lr_timings t = initialised(LR_CALL(lr_timings_init));
    if (LR_CALL(lr_world_get_timings)(w.at, &t) != LR_OK) defect("lr_world_get_timings", "failed");
    const double parts = t.colliders + t.wind + t.motion + t.body_contact + t.wake + t.emit_and_rules + t.events;
    if (!(parts >= 0.0) || !(parts <= t.total)) defect("lr_world_get_timings", "the parts are more than the whole");
}

void events(Fuzzer& f) {
    World& w = f.world();
    uint32_t capacity = f.in.handle(0) % 32,
             kinds = f.in.handle(1) < 192 ? f.in.handle(1) * 2 % 256 : 1u << f.in.handle(1) % 32;
    f.in.change(capacity);
    Expected e;
    e.add_if((kinds & ~lr_event_kinds{LR_EVENTS_ALL}) != 0 || (capacity != 0 && kinds == 0), LR_ERROR_INVALID_ARGUMENT);
    Call call(f, w, "lr_world_set_events", e);
    const bool wild = w.state.wild;
    if (call.ended(LR_CALL(lr_world_set_events)(call.world(), capacity, kinds))) w.event_capacity = capacity;
    w.state.wild = wild;
}

void event_list(Fuzzer& f) {
    World& w = f.world();
    Expected e;
    Given<lr_event_list> given(f.in, initialised(LR_CALL(lr_event_list_init)), 1, e);
    Call call(f, w, "lr_world_get_events", e);
    if (!call.ended(LR_CALL(lr_world_get_events)(call.world(), given.get()))) return;
    const lr_event_list list = given.read();
    if (list.capacity != w.event_capacity) defect("lr_world_get_events", "another capacity", list.capacity);
    if (list.count > w.event_capacity) defect("lr_world_get_events", "more events than room", list.count);
    for (uint32_t i = 0; i < list.count; ++i) {
        const lr_event& event = list.events[i];
        const bool contact = event.kind == LR_EVENT_HIT || event.kind == LR_EVENT_LIFTED;
        if (event.kind < LR_EVENT_SPAWNED || event.kind > LR_EVENT_DIVERGED || (event.collider.id != 0) != contact)
            defect("lr_world_get_events", "kind", event.kind);
        if (event.kind == LR_EVENT_HIT && (!(event.speed >= 0.0f) || !std::isfinite(event.normal[0])))
            defect("lr_world_get_events", "speed or normal");
    }
}

template <class T> void init(const char* name, lr_status (*function)(T*, uint32_t), const Input& in) {
    struct {
        T desc;
        unsigned char behind[8];
    } room;
    std::memset(static_cast<void*>(&room), 0x5a, sizeof room);
    const uint32_t sizes[] = {sizeof(T), 0, 4, sizeof(T) + 8, 65537, 0xffffffffu, 7, sizeof(T)};
    const uint32_t size = sizes[in.handle(0) % 8];
    const bool good = size >= sizeof(T) && size <= 65536;
    const lr_status status = function(in.null(1) ? nullptr : &room.desc, size);
    const lr_status expected = in.null(1) ? LR_ERROR_NULL_ARGUMENT : good ? LR_OK : LR_ERROR_STRUCT_SIZE;
    if (status != expected && !(in.null(1) && status == LR_ERROR_STRUCT_SIZE)) defect(name, "status", status);
    if (status == LR_OK && room.desc.struct_size != size) defect(name, "struct_size", room.desc.struct_size);
    if (room.behind[size == sizeof(T) + 8 ? 8 - 1 : 0] != (status == LR_OK && size > sizeof(T) ? 0 : 0x5a))
        defect(name, "wrote another number of bytes");
}
#define INIT(function) init(#function, LR_CALL(function), f.in)

void inits(Fuzzer& f) {
    INIT(lr_aerodynamics_init), INIT(lr_asset_info_init), INIT(lr_batch_contact_init), INIT(lr_batch_desc_init);
    INIT(lr_batch_counts_init), INIT(lr_batch_force_init), INIT(lr_batch_pace_init);
    INIT(lr_batch_rules_init), INIT(lr_batch_view_init), INIT(lr_body_desc_init), INIT(lr_body_force_init);
    INIT(lr_body_state_init), INIT(lr_collider_desc_init), INIT(lr_collider_motion_init);
    INIT(lr_collider_state_init), INIT(lr_material_init), INIT(lr_event_list_init);
    INIT(lr_ellipsoid_desc_init), INIT(lr_emitter_desc_init), INIT(lr_force_arrays_init), INIT(lr_load_gains_init);
    INIT(lr_overlap_desc_init), INIT(lr_recording_desc_init), INIT(lr_ray_init), INIT(lr_rigid_desc_init),
        INIT(lr_step_report_init), INIT(lr_timings_init);
    INIT(lr_water_desc_init), INIT(lr_turbulence_table_init), INIT(lr_gusts_desc_init), INIT(lr_vortex_desc_init);
    INIT(lr_blower_desc_init), INIT(lr_turbulence_desc_init), INIT(lr_wind_grid_desc_init);
    INIT(lr_ground_wind_desc_init);
    INIT(lr_world_desc_init), INIT(lr_world_info_init);
}

void names(Fuzzer& f) {
    const auto any = static_cast<int32_t>(f.in.integer(f.in.value(0)) * (f.in.variant() % 2 ? 1u : 0xffffffffu));
    if (!LR_CALL(lr_status_string)(any) || !LR_CALL(lr_simd_target_name)(any)) defect("lr_status_string", "null");
    if (LR_CALL(lr_version)() != (LR_VERSION_MAJOR << 22 | LR_VERSION_MINOR << 12 | LR_VERSION_PATCH))
        defect("lr_version", "another");
    int32_t targets[8] = {};
    uint32_t count = 0;
    const uint32_t capacity = f.in.handle(0) % 9;
    const lr_status status =
        LR_CALL(lr_simd_targets)(f.in.null(1) ? nullptr : targets, capacity, f.in.null(2) ? nullptr : &count);
    Expected e;
    e.add_if((f.in.null(1) && capacity != 0) || f.in.null(2), LR_ERROR_NULL_ARGUMENT);
    // Without an array it asks for their number.
    e.add_if(!f.in.null(1) && count > capacity, LR_ERROR_BUFFER_TOO_SMALL);
    if (!e.allows(status)) defect("lr_simd_targets", "status", status);
    const std::string text = LR_CALL(lr_last_error)();
    if (text.size() > 255 || (status != LR_OK && text.find("lr_simd_targets: ") != 0))
        defect("lr_last_error", "not of the last failed call");
}

void fail_memory(Fuzzer& f) {
    if (f.world().at) f.world().memory->fail_after(f.in.handle(0) % 8);
}

} // namespace

void begin_scene(Fuzzer& f) {
    World& w = f.worlds[0];
    w.desc = initialised(LR_CALL(lr_world_desc_init));
    w.desc.allocator = w.memory->hooks();
    if (LR_CALL(lr_world_create)(&w.desc, &w.at) != LR_OK) defect("lr_world_create", "a plain world is refused");
    f.assets = common_assets();
    for (lr_asset* asset : f.assets)
        if (LR_CALL(lr_asset_retain)(asset) != LR_OK) defect("lr_asset_retain", "failed");
    Batch b;
    b.desc = initialised(LR_CALL(lr_batch_desc_init));
    b.desc.asset = f.assets[0], b.desc.capacity = 8;
    if (LR_CALL(lr_batch_create)(w.at, &b.desc, &b.id) != LR_OK) defect("lr_batch_create", "a plain batch is refused");
    const lr_body_desc d = initialised(LR_CALL(lr_body_desc_init));
    b.bodies.resize(1);
    if (LR_CALL(lr_body_create)(w.at, b.id, &d, 1, b.bodies.data()) != LR_OK)
        defect("lr_body_create", "a plain body is refused");
    w.state.batches.push_back(b);
    w.past.push_back({b.desc, {}});
}

std::vector<Named> world_operations() {
    return {{"world_create", create},
            {"world_destroy", destroy},
            {"world_info", info},
            {"gravity", gravity},
            {"simd", simd},
            {"budget", budget},
            {"report", report},
            {"events", events},
            {"event_list", event_list},
            {"inits", inits},
            {"names", names},
            {"fail_memory", fail_memory}};
}

} // namespace fuzz
