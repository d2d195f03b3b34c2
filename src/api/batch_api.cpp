#include "api/refuse.h"
#include "view/transforms.h"
#include "world/world.h"

#include <algorithm>

namespace {

using namespace lr::api;

bool one_of(int32_t value, int32_t last) {
    return value >= 0 && value <= last;
}

// Null when fine, else what is wrong.
const char* wrong_in(const lr_batch_desc& d) {
    if (d.capacity == 0 || d.capacity > lr::max_capacity) return "capacity is not 1 to 2^26";
    if (!one_of(d.load_model, LR_LOADS_AERODYNAMIC)) return "unknown load_model";
    if (!one_of(d.clock, LR_CLOCK_AGE)) return "unknown clock";
    if (!one_of(d.table_end, LR_TABLE_LOOP)) return "unknown table_end";
    if (!one_of(d.integrator, LR_INTEGRATOR_SPLITTING)) return "unknown integrator";
    lr::Gains gains;
    gains.damping = static_cast<double>(d.damping_gain);
    gains.noise = static_cast<double>(d.noise_gain);
    if (const char* why = lr::wrong_in(gains)) return why;
    return nullptr;
}

lr::TurbulenceSample sample(const lr_turbulence_table& t, float chi, float epsilon) {
    return {static_cast<double>(chi), static_cast<double>(epsilon), static_cast<double>(t.u0), static_cast<double>(t.l),
            static_cast<double>(t.c0)};
}

const char* wrong_in(const lr_turbulence_table& t) {
    if (t.count == 0 || t.count > 65536) return "count is not 1 to 65536";
    if (!in_range(t.dt, lr::least_interval, lr::most_interval)) return "dt is not positive";
    if (const char* why = lr::wrong_in(sample(t, 0.0f, 0.0f))) return why;
    if (t.stationary >= t.count) return "stationary lies behind the table";
    if (t.reserved != 0) return "reserved is not 0";
    return nullptr;
}

} // namespace

extern "C" {

lr_status lr_batch_desc_init(lr_batch_desc* desc, uint32_t struct_size) {
    const lr_status status = begin_init(desc, struct_size);
    if (status != LR_OK) return status;
    desc->damping_gain = 1.0f;
    desc->noise_gain = 1.0f;
    return LR_OK;
}

lr_status lr_inner_batch_create(lr_world* world, const lr_batch_desc* desc, lr_batch* out) {
    const lr::FloatMode mode;
    if (!out) return LR_ERROR_NULL_ARGUMENT;
    *out = 0;
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    lr_batch_desc d;
    lr_status status = read_struct(desc, d);
    if (status != LR_OK) return refuse(world, "lr_batch_create", status);
    if (!d.asset) return refuse(world, "lr_batch_create", LR_ERROR_NULL_ARGUMENT, "desc->asset is null");
    if (!std::isfinite(d.damping_gain) || !std::isfinite(d.noise_gain))
        return refuse(world, "lr_batch_create", LR_ERROR_NOT_FINITE);
    if (const char* why = wrong_in(d)) return refuse(world, "lr_batch_create", LR_ERROR_INVALID_ARGUMENT, why);

    if (!accepted(world)) return refuse(world, "lr_batch_create", LR_ERROR_OUT_OF_MEMORY);

    lr::BatchSettings settings;
    settings.loads = d.load_model == LR_LOADS_NONE       ? lr::Loads::none
                     : d.load_model == LR_LOADS_LANGEVIN ? lr::Loads::langevin
                                                         : lr::Loads::aerodynamic;
    settings.clock = d.clock == LR_CLOCK_AGE ? lr::Clock::age : lr::Clock::speed;
    settings.integrator = d.integrator == LR_INTEGRATOR_RK4 ? lr::Integrator::rk4 : lr::Integrator::splitting;
    settings.loop = d.table_end == LR_TABLE_LOOP;
    settings.gains.damping = static_cast<double>(d.damping_gain);
    settings.gains.noise = static_cast<double>(d.noise_gain);
    settings.viscosity =
        world->fluid_viscosity > 0.0f ? static_cast<double>(world->fluid_viscosity) : d.asset->data.fluid_viscosity;
    settings.fluid_density =
        world->fluid_density > 0.0f ? static_cast<double>(world->fluid_density) : d.asset->data.fluid_density;
    status = guarded([&] { return world->create_batch(*d.asset, d.capacity, settings, *out); });
    return status == LR_OK ? status : refuse(world, "lr_batch_create", status);
}

lr_status lr_inner_batch_destroy(lr_world* world, lr_batch batch) {
    const lr::FloatMode mode;
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    if (!world->find(batch)) return refuse(world, "lr_batch_destroy", LR_ERROR_STALE_BATCH);
    world->destroy_batch(batch);
    return LR_OK;
}

lr_status lr_turbulence_table_init(lr_turbulence_table* table, uint32_t struct_size) {
    const lr_status status = begin_init(table, struct_size);
    if (status == LR_OK) table->c0 = 6.5f;
    return status;
}

lr_status lr_inner_batch_set_turbulence_table(lr_world* world, lr_batch batch, const lr_turbulence_table* table) {
    const lr::FloatMode mode;
    constexpr const char* name = "lr_batch_set_turbulence_table";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    lr::Batch* const b = world->find(batch);
    if (!b) return refuse(world, name, LR_ERROR_STALE_BATCH);
    if (!table) return b->set_asset_table() ? LR_OK : refuse(world, name, LR_ERROR_OUT_OF_MEMORY);
    lr_turbulence_table t;
    const lr_status status = read_struct(table, t);
    if (status != LR_OK) return refuse(world, name, status);
    const float scalars[] = {t.dt, t.u0, t.l, t.c0};
    if (!finite(scalars)) return refuse(world, name, LR_ERROR_NOT_FINITE);
    if (const char* why = wrong_in(t)) return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, why);
    if (!t.chi || !t.epsilon) return refuse(world, name, LR_ERROR_NULL_ARGUMENT);
    for (uint32_t i = 0; i < t.count; ++i) {
        if (!std::isfinite(t.chi[i]) || !std::isfinite(t.epsilon[i])) return refuse(world, name, LR_ERROR_NOT_FINITE);
        if (const char* why = lr::wrong_in(sample(t, t.chi[i], t.epsilon[i])))
            return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, why);
    }
    if (!accepted(world)) return refuse(world, name, LR_ERROR_OUT_OF_MEMORY);
    const lr::TableView view{t.chi,
                             t.epsilon,
                             t.count,
                             t.stationary,
                             static_cast<double>(t.dt),
                             static_cast<double>(t.u0),
                             static_cast<double>(t.l),
                             static_cast<double>(t.c0)};
    return b->set_table(view) ? LR_OK : refuse(world, name, LR_ERROR_OUT_OF_MEMORY);
}

lr_status lr_batch_view_init(lr_batch_view* view, uint32_t struct_size) {
    return begin_init(view, struct_size);
}

lr_status lr_inner_batch_get_view(const lr_world* world, lr_batch batch, lr_batch_view* view) {
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    const lr::Batch* const b = world->find(batch);
    if (!b) return refuse(world, "lr_batch_get_view", LR_ERROR_STALE_BATCH);
    const lr_status status = check_size(view);
    if (status != LR_OK) return refuse(world, "lr_batch_get_view", status);
    lr_batch_view out{};
    const lr::BatchArrays& a = b->arrays();
    out.count = b->count();
    out.capacity = b->capacity();
    for (size_t i = 0; i < 3; ++i) {
        out.position[i] = a.field[lr::field_x + i];
        out.velocity[i] = a.field[lr::field_vx + i];
        out.spin[i] = a.field[lr::field_wx + i];
    }
    for (size_t i = 0; i < 4; ++i) out.orientation[i] = a.field[lr::field_qx + i];
    out.scale = a.field[lr::field_scale];
    out.age = a.field[lr::field_age];
    out.key = a.key;
    out.ids = b->ids();
    out.revision = b->revision();
    out.awake_count = b->awake();
    write_struct(out, view);
    return LR_OK;
}

lr_status lr_inner_batch_write_transforms(const lr_world* world, lr_batch batch, int32_t format, void* dst,
                                          uint64_t stride, uint32_t count, uint32_t* written) {
    constexpr const char* name = "lr_batch_write_transforms";
    if (written) *written = 0;
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    const lr::Batch* const b = world->find(batch);
    if (!b) return refuse(world, name, LR_ERROR_STALE_BATCH);
    const lr::FloatMode mode;
    const uint32_t bytes = lr::transform_bytes(format);
    if (bytes == 0) return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, "unknown format");
    if (stride == 0) stride = bytes;
    if (stride < bytes || stride % 4 != 0 || stride > (uint64_t{1} << 32) || reinterpret_cast<uintptr_t>(dst) % 4 != 0)
        return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, "stride or alignment does not fit the format");
    count = std::min(count, b->count());
    if (count == 0) return LR_OK;
    if (!dst) return refuse(world, name, LR_ERROR_NULL_ARGUMENT);
    lr::write_transforms(world->target->simd, b->arrays(), count, static_cast<float>(b->pace.behind()), format, dst,
                         stride);
    if (written) *written = count;
    return LR_OK;
}

} // extern "C"
