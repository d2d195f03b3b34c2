// Default values of the API's structs.
#include "api/struct_conversion.h"
#include "asset/closed_forms/ellipsoid_asset.h"
#include "environment/source_desc.h"

namespace lr::api {
namespace {

// Defaults other than zero. An orientation defaults to the identity.
struct Initial {
    template <class T> static void set(T& s) {
        if constexpr (requires { source_type_of(s); }) desc_of(source_type_of(s), SourceDesc{}, &s);
    }
    static void set(lr_aerodynamics& a) { write_struct(to_struct(AerodynamicData{}), &a); }
    static void set(lr_batch_contact& c) { write_struct(initial_contact, &c); }
    static void set(lr_batch_desc& d) { d.damping_gain = d.noise_gain = 1.0f; }
    static void set(lr_body_desc& d) { d.scale = 1.0f; }
    static void set(lr_body_state& s) { s.scale = 1.0f; }
    static void set(lr_collider_desc& d) {
        d.friction = 0.5f;
        d.restitution = 0.2f;
        d.layers = 1;
        d.spacing[0] = d.spacing[1] = 1.0f;
    }
    static void set(lr_collider_motion& m) { m.mode = LR_MOVE_TO; }
    static void set(lr_material& s) {
        s.friction = 0.5f;
        s.restitution = 0.2f;
        s.layers = 1;
    }
    static void set(lr_ellipsoid_desc& d) { set_fluid(d); }
    static void set(lr_emitter_desc& d) {
        d.body_orientation[3] = 1.0f;
        d.direction[1] = -1.0f;
        d.scale_min = d.scale_max = 1.0f;
    }
    static void set(lr_load_gains& g) { g.drag = g.lift = g.spin_drag = g.turbulence = 1.0f; }
    static void set(lr_overlap_desc& d) {
        d.shape = LR_OVERLAP_SPHERE;
        std::fill(d.size, d.size + 3, 1.0f);
    }
    static void set(lr_ray& r) {
        r.flags = LR_RAY_BODIES | LR_RAY_COLLIDERS;
        r.direction[1] = -1.0f;
        r.max_distance = 1e9f;
        r.collider_layers = 0xffffffffu;
    }
    static void set(lr_recording_desc& d) {
        d.flags = LR_RECORD_CALLBACKS;
        d.hash_interval = 1;
    }
    static void set(lr_rigid_desc& d) { set_fluid(d); }
    static void set(lr_water_desc& d) {
        d.normal[1] = 1.0f;
        d.density = 998.0f;
        d.viscosity = 1e-6f;
    }
    static void set(lr_turbulence_table& t) { t.c0 = 6.5f; }
    static void set(lr_vortex_desc& d) { d.axis[1] = d.circulation = d.core_radius = 1.0f; }
    static void set(lr_ground_wind_desc& d) {
        d.normal[1] = 1.0f;
        d.roughness_length = 0.03f;
        d.reference_height = 10.0f;
    }
    static void set(lr_world_desc& d) { d.gravity[1] = -9.81f; }

private:
    template <class T> static void set_fluid(T& d) {
        const shape::EllipsoidSpec spec;
        d.fluid_density = spec.fluid_density;
        d.fluid_viscosity = spec.fluid_viscosity;
        d.intensity = spec.intensity;
    }
};

// Clears all bytes of the caller's struct, which is larger if its header is newer.
template <Sized T> lr_status init(T* s, uint32_t struct_size) {
    if (!s) return LR_ERROR_NULL_ARGUMENT;
    if (!is_struct_size<T>(struct_size)) return LR_ERROR_STRUCT_SIZE;
    std::memset(static_cast<void*>(s), 0, struct_size);
    s->struct_size = struct_size;
    if constexpr (requires(float one) { s->orientation[3] = one; }) s->orientation[3] = 1.0f;
    Initial::set(*s);
    return LR_OK;
}

} // namespace
} // namespace lr::api

// NOLINTBEGIN(bugprone-macro-parentheses): a type
#define LR_STRUCT(name)                                                                                                \
    lr_status name##_init(name* s, uint32_t struct_size) {                                                             \
        return lr::api::told(#name "_init", lr::api::init(s, struct_size));                                            \
    }
// NOLINTEND(bugprone-macro-parentheses)
extern "C" {
#include "api/structs.inc"
}
