/*
 * Langevin Rigid for research: bodies from given matrices, coefficients of the loads, turbulence tables.
 * langevin_rigid.h explains units, frames, ownership, errors and threads, and has all that a game needs.
 *
 * SPDX-License-Identifier: MIT
 */
#ifndef LANGEVIN_RIGID_RESEARCH_H
#define LANGEVIN_RIGID_RESEARCH_H

#include "langevin_rigid.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------------------------------------------------------ */
/* Research                                                                                                           */

/* Coefficients of the quasi-steady loads (LR_LOADS_AERODYNAMIC) at scale 1; equations: docs/maintainers/physics.md,
 * AERODYNAMIC. All loads act at `center`, along `axes`, which rotate with the body. Arrays hold one value per axis.
 * Symbols: v is the velocity through the fluid and w the spin, both along the axes; s = |v|; (i, j, k) are cyclic; d is
 * lr_asset_info.length_d; rho and nu are the fluid's density and kinematic viscosity. */
typedef struct lr_aerodynamics {
    uint32_t struct_size;
    uint32_t reserved; /* 0 */
    double axes[9];    /* rows: unit vectors in the body frame, right-handed */
    /* Drag -1/2 rho sum_i (v_i/s)^2 [drag_i + drag_blunt_i Re/(Re + 8710)] s v with Re = s d/nu, and along each axis
     * -rho [drag_layer_i sqrt(nu s) + drag_stokes_i nu] v_i. All >= 0. */
    double drag[3];        /* m^2, drag coefficient times area */
    double drag_blunt[3];  /* m^2, the part of rounded bodies, which grows with the Reynolds number */
    double drag_layer[3];  /* m^(3/2), boundary layer */
    double drag_stokes[3]; /* m, creeping flow */
    /* Lift rho G x v with G_k = spin_lift_k w_k - lift_k v_i v_j/s. */
    double lift[3];        /* m^2, positive where the body is thinner along j than along i */
    double spin_lift[3];   /* m^3 */
    double lift_moment[3]; /* ignored since 0.3 */
    /* Couple -rho (spin_drag_k |w| + spin_drag_stream_k s + spin_drag_layer_k (nu (s + |w| d/2))^(1/2)
     * + spin_drag_stokes_k nu) w_k. All >= 0. In |w| each axis counts by its spin_drag. */
    double spin_drag[3];           /* m^5 */
    double spin_drag_stream[3];    /* m^4 */
    double spin_drag_stokes[3];    /* m^3 */
    double intensity;              /* velocity fluctuations in the body's own wake, per axis, over s. Above 0.4, gains
                                   included, it acts as 0.4: a stronger wake would feed itself */
    double length;                 /* m: the fluctuations are correlated over length/s */
    double wake_reynolds;          /* scales the fluctuations by Re/(Re + wake_reynolds): slow wakes are laminar */
    double broadside[3];           /* 0 to 1: the fluctuations grow with sum_i broadside_i (v_i/s)^2 */
    double lift_stall;             /* ignored since 0.3 */
    double lift_moment_stalled[3]; /* ignored since 0.3 */
    double roll_damping[3];        /* ignored since 0.3 */
    double center[3]; /* m, where the loads act, from the centre of buoyancy, body frame; within 2 d; default 0 */
    /* A plate whose normal n is the axis with the largest broadside, with the part v_n of the stream along it and v_t in
     * the plate. The normal force is -1/2 rho N; attached, N = plate_lift |v_t| v_n + plate_vortex |v_n| v_n; separated,
     * N = plate_drag s v_n (1 + 0.8 v_t^2/s^2); half of each where v_n^2/s^2 is plate_stall. A stream along axis i of the
     * plate has the values with index i. */
    double plate_lift[3];   /* m^2, >= 0 */
    double plate_vortex[3]; /* m^2, >= 0 */
    double plate_stall[3];  /* 0 to 1 */
    /* This share of the added momentum along n, 0 to 1, does not move with the body while the stream is separated and sheds
     * vortices: it reduces the Munk moment. */
    double plate_separated_shedding;
    double plate_drag; /* m^2, >= 0: drag coefficient broadside times area */
    double start_drag; /* >= 0: adds to N start_drag plate_drag |u - v| ((v - u) . v/s^2) v_n */
    /* Memory: u follows v at the rate max(s, |u|)/(wake_lag wake_length). Attached, N takes wake_share of its stream from
     * u. */
    double wake_length; /* m, > 0 */
    double wake_lag;    /* > 0 */
    double wake_share;  /* 0 to 1 */
    /* Vortex shedding above the Reynolds number shedding_reynolds of wake_length: an oscillator q in the plate with the
     * frequency strouhal s/wake_length and the moment rho v_n^2 n x (shedding_moment q + shedding_rate_moment r), r the
     * rate of q over 2 pi times the frequency. It starts from the fluctuations. At shedding_reynolds and below, the wake
     * remembers for 2.5 times as long, and the stream stalls later: 1/plate_stall - 1 counts 0.4 times. */
    double strouhal;
    double shedding_growth;      /* >= 0 */
    double shedding_reynolds;    /* >= 0 */
    double shedding_noise;       /* >= 0: of r by the fluctuations */
    double shedding_moment;      /* m^3 */
    double shedding_rate_moment; /* m^3 */
    double spin_drag_layer[3];   /* m^(7/2), boundary layer: see spin_drag */
} lr_aerodynamics;

/* Sets the axes to the body's, `length`, `wake_length` and `wake_lag` to 1 and everything else to 0: no loads. */
LR_API lr_status lr_aerodynamics_init(lr_aerodynamics* aerodynamics, uint32_t struct_size);

/* Reads an asset's baked coefficients. aerodynamics: initialised by lr_aerodynamics_init, or with struct_size set.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE. Any thread. */
LR_API lr_status lr_asset_get_aerodynamics(const lr_asset* asset, lr_aerodynamics* aerodynamics);

/* Replaces the asset's coefficients of AERODYNAMIC loads for a batch from the next step on. The struct is copied; null
 * restores the asset's. With intensity 0, lr_load_gains.turbulence 1 and lr_batch_desc.variation 0 a fall is the same
 * for any seed. Axes other than the body's, or a center other than 0, put an LR_ASSET_DIAGONAL body on the slower path
 * of contact.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_batch_set_aerodynamics(lr_world* world, lr_batch batch, const lr_aerodynamics* aerodynamics);

/* Reads a batch's current coefficients. aerodynamics: initialised, or with struct_size set.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_batch_get_aerodynamics(const lr_world* world, lr_batch batch, lr_aerodynamics* aerodynamics);

/* A body of known numbers without a mesh or file: from another solver, from measurements, or the cross-section of a
 * card in two dimensions. Matrices are row-major, symmetric, about the centre of mass, in body axes. */
typedef struct lr_rigid_desc {
    uint32_t struct_size;
    uint32_t reserved;
    double mass;                         /* kg, > 0 */
    double volume;                       /* m^3, > 0 */
    double inertia[9];                   /* kg m^2, positive definite */
    double added_mass[36];               /* kg, kg m, kg m^2: order vx vy vz wx wy wz, fluid density included, as in
                                            lr_asset_info; positive semi-definite; default 0 */
    double center_of_buoyancy[3];        /* m, from the centre of mass; default 0 */
    double fluid_density;                /* kg/m^3, > 0; default 1.2, air */
    double fluid_viscosity;              /* m^2/s, kinematic, > 0; default 1.5e-5, air */
    double extents[3];                   /* m, full size along the body axes, > 0 */
    double intensity;                    /* of the turbulence table, as in lr_ellipsoid_desc; default 1 */
    const lr_aerodynamics* aerodynamics; /* copied; default null: an ellipsoid's with these extents */
} lr_rigid_desc;

LR_API lr_status lr_rigid_desc_init(lr_rigid_desc* desc, uint32_t struct_size);

/* Creates an asset from given numbers. out: as for lr_asset_load_file.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT (also for
 * matrices that no body can have), LR_ERROR_OUT_OF_MEMORY. Any thread. */
LR_API lr_status lr_asset_create_rigid(const lr_rigid_desc* desc, lr_asset** out);

/* k-epsilon samples in the units of the bake. Arrays are copied. */
typedef struct lr_turbulence_table {
    uint32_t struct_size;
    uint32_t count;       /* samples, 1 to 65536 */
    const float* chi;     /* 1/s, turbulent frequency epsilon / k, `count` values >= 0 */
    const float* epsilon; /* m^2/s^3, dissipation rate, `count` values >= 0 */
    float dt;             /* s between samples, > 0 */
    float u0;             /* m/s, the speed that the table was made at, > 0; LR_CLOCK_SPEED scales by it */
    float l;              /* m, the length that the table was made with, > 0 */
    float c0;             /* Kolmogorov constant, > 0; default 6.5, its limit at high Reynolds number */
    uint32_t stationary;  /* the sample that LR_CLOCK_SPEED uses, < count; default 0 */
    uint32_t reserved;    /* 0 */
} lr_turbulence_table;

LR_API lr_status lr_turbulence_table_init(lr_turbulence_table* table, uint32_t struct_size);

/* Replaces the turbulence table of a batch; null restores the asset's. With AERODYNAMIC loads the table replaces the
 * intensity of lr_aerodynamics: it sets the velocity of the fluid around the body.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_batch_set_turbulence_table(lr_world* world, lr_batch batch, const lr_turbulence_table* table);

/* Reads a batch's turbulence table: the one that was set, bit for bit, or the asset's, rounded to float.
 * table: initialised, or with struct_size set; its own chi and epsilon receive null.
 * chi, epsilon: receive `table->count` values each, up to `capacity`; either may be null, and capacity is then not read
 * for it.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (world, table), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_BUFFER_TOO_SMALL
 * (table is set, chi and epsilon are not). */
LR_API lr_status lr_batch_get_turbulence_table(const lr_world* world, lr_batch batch, lr_turbulence_table* table,
                                               float* chi, float* epsilon, uint32_t capacity);

/* The loads of the flow on a body and the state of its wake, for inspectors and debug arrows: what AERODYNAMIC loads do
 * to it now. Weight, buoyancy and added mass are not among them, but what turning costs where added momentum is left in
 * the wake is. World frame. */
typedef struct lr_body_loads {
    uint32_t struct_size;
    uint32_t station_count;     /* 1 to 8: 1 where one stream describes the shape; 0: no AERODYNAMIC loads */
    float stream[3];            /* m/s, velocity of the fluid relative to the body, its own fluctuations included */
    float wake[3];              /* m/s, the stream that the wake remembers: it follows `stream` */
    float shedding[3];          /* q of the vortex shedding (lr_aerodynamics), up to 1.4; 0: a steady wake */
    float force[3];             /* N, sum of all stations */
    float torque[3];            /* N m, about the centre of mass, with the couples of spin and shed vortices */
    float station_position[24]; /* m, x y z of each station */
    float station_force[24];    /* N, x y z of each station's force */
} lr_body_loads;

LR_API lr_status lr_body_loads_init(lr_body_loads* loads, uint32_t struct_size);

/* Computes the loads on a body from its present state, wind and water; on a sleeping body as if its wake had ended. At the
 * surface of water those of the fluid that its centre of mass is in; the fluid's own rotation is left out.
 * loads: initialised, or with struct_size set. A microsecond; calls the wind and water callbacks.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_body_get_loads(const lr_world* world, lr_body body, lr_body_loads* loads);

/* Initial values, as in langevin_rigid.h. */
/* clang-format off */
#define LR_AERODYNAMICS_INIT {sizeof(lr_aerodynamics), 0, {1, 0, 0, 0, 1, 0, 0, 0, 1}, {0}, {0}, {0}, {0}, {0}, {0}, \
    {0}, {0}, {0}, {0}, 0, 1, 0, {0}, 0, {0}, {0}, {0}, {0}, {0}, {0}, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, {0}}
#define LR_RIGID_DESC_INIT {sizeof(lr_rigid_desc), 0, 0, 0, {0}, {0}, {0}, 1.2, 1.5e-5, {0}, 1, 0}
#define LR_TURBULENCE_TABLE_INIT {sizeof(lr_turbulence_table), 0, 0, 0, 0, 0, 0, 6.5f, 0, 0}
#define LR_BODY_LOADS_INIT {sizeof(lr_body_loads), 0, {0}, {0}, {0}, {0}, {0}, {0}, {0}}
/* clang-format on */

#ifdef __cplusplus
}
#endif

#endif /* LANGEVIN_RIGID_RESEARCH_H */
