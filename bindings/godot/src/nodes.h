/*
 * The classes: their data, and their functions for each other.
 *
 *   LangevinAsset (Resource)   an .lrb file
 *   LangevinWorld (Node3D)     steps; holds the wind and the colliders found in the scene
 *   LangevinBatch (Node3D)     below a world: all bodies of an asset, drawn by a multimesh
 *
 * Godot has the library's units and axes: metres, right-handed, y up. Only the layout of transforms differs (transform.h).
 * Bodies live in the space of the scene, whatever the transforms of the world's and the batch's nodes.
 *
 * SPDX-License-Identifier: MIT
 */
#ifndef LANGEVIN_NODES_H
#define LANGEVIN_NODES_H

#include "gd/gd_class.h"

extern const gd_class asset_class, asset_loader_class, world_class, batch_class;
extern const gd_class gizmo_class, plugin_class; /* of the editor */

typedef struct asset_node {
    gd_instance base;
    gd_var bytes; /* PackedByteArray: stored in scenes for an asset without a file */
    lr_asset* asset;
    lr_asset_info info;
} asset_node;

/* The library's collider for a shape of a physics body. */
typedef struct shape_link {
    uint64_t body, shape; /* instance ids */
    int64_t owner, index; /* of the shape in the body */
    uint64_t seen;        /* the last scan that found it */
    lr_collider collider; /* id 0: none */
    float pose[12];       /* last global pose given to the library, in the engine's layout */
    float offset[12];     /* of the shape in the body */
    float extra[7];       /* position and quaternion of the collider in the shape: a world boundary's plane */
    uint32_t layers;
    int unsupported;
} shape_link;

typedef struct collider_set {
    shape_link* links;
    uint32_t count, capacity;
    uint32_t cursor; /* scans start here */
    uint64_t scan;
} collider_set;

/* A shape of an Area3D with wind, in plain numbers for the callback; written between steps. */
typedef struct area_shape {
    int32_t kind; /* AREA_* */
    float size[3];
    float to_local[12]; /* rows; from the scene's space into the shape's */
} area_shape;

typedef struct area_wind {
    uint64_t area;         /* instance id */
    uint32_t first, count; /* of shapes */
    float velocity[3];     /* direction times magnitude; 0 without wind */
    float direction[3];
    float source[3];
    float attenuation;
} area_wind;

typedef struct area_set {
    area_wind* areas;
    area_shape* shapes;
    uint32_t count, shape_count, capacity, shape_capacity;
    int active; /* an area has wind */
} area_set;

struct batch_node;

typedef struct world_node {
    gd_instance base;
    /* Properties */
    float gravity[3], wind[3];
    double gust_speed, gust_period, turbulence_speed, turbulence_size;
    int64_t seed, substeps, workers, simd, process_callback;
    int64_t wind_from_areas, sync_colliders, collision_mask;
    int64_t events, event_capacity, preview;
    /* State */
    int selected;    /* in the editor: the node or a batch of it */
    lr_world* world; /* exists while the node is in the tree; in the editor only while it previews */
    struct batch_node** batches;
    uint32_t batch_count, batch_capacity;
    lr_wind_source gusts, turbulence;
    collider_set colliders;
    area_set areas;
    int tree_changed, wind_changed;
    uint64_t tree; /* instance id of the scene tree whose signals are connected */
    lr_status last_status;
    gd_var recording; /* the FileAccess of the recording */
} world_node;

enum { PROCESS_PHYSICS = 0, PROCESS_IDLE = 1, PROCESS_MANUAL = 2 };

void world_scan_colliders(world_node* world);
void world_sync_colliders(world_node* world);
void world_forget_colliders(world_node* world, int destroy);
void world_scan_areas(world_node* world);
void world_sync_areas(world_node* world);
void world_forget_areas(world_node* world);
void world_apply_wind(world_node* world);
void world_step(world_node* world, double dt);
void world_emit_events(world_node* world);
gd_var world_save(const world_node* world); /* PackedByteArray */
lr_status world_restore(world_node* world, const gd_var* bytes);
int world_start_recording(world_node* world, const gd_var* file); /* FileAccess; values of @GlobalScope.Error */
int world_stop_recording(world_node* world);
void world_add_batch(world_node* world, struct batch_node* batch);
void world_remove_batch(world_node* world, struct batch_node* batch);
void world_select(world_node* world, int selected); /* the editor's selection: begins and ends the preview */

typedef struct batch_node {
    gd_instance base;
    /* Properties */
    gd_var asset, mesh, material;
    float mesh_transform[12], custom_aabb[6];
    int64_t cast_shadow, layers;
    int64_t capacity, initial_count;
    int64_t emitting, respawn;
    double rate, lifetime, spread, spin, scale_min, scale_max;
    float extents[3], velocity[3], bounds[6];
    int64_t random_orientation;
    double drag, lift, spin_drag, turbulence, variation;
    int64_t collision_mask, body_contact;
    double friction, bounce;
    int64_t rate_divisor;
    /* State */
    world_node* world; /* while in the tree below one */
    lr_batch batch;    /* id 0 until the first step */
    int rebuild, retune, moved;
    /* Drawing */
    uint64_t multimesh, instance; /* RIDs */
    uint64_t mesh_of;             /* instance id of the mesh in the multimesh */
    gd_var buffer;                /* PackedFloat32Array, 12 a body */
    uint32_t allocated;           /* instances in the multimesh */
    uint32_t drawn, moving;       /* bodies, and those awake, in the buffer */
    uint64_t revision;
    int visible;
    float local[12]; /* from the mesh's frame to the body's: mesh_transform minus the centre of mass */
    int local_is_identity;
    float mesh_radius; /* around the centre of mass, at scale 1 */
} batch_node;

void batch_ensure(batch_node* batch); /* creates the library's batch if possible */
void batch_leave(batch_node* batch);  /* destroys it */
void batch_draw(batch_node* batch);
void batch_draw_nothing(batch_node* batch);
void batch_draw_begin(batch_node* batch); /* the node has entered a 3D world */
void batch_draw_end(batch_node* batch);
void batch_draw_changed(void* batch); /* mesh, material, shadows, layers */
asset_node* batch_asset(const batch_node* batch);
void node_redraw(const gd_instance* node); /* its gizmo, in the editor */
extern const gd_method batch_methods[];

/* The loader of .lrb files, while the extension is loaded. */
void asset_loader_start(void);
void asset_loader_stop(void);

#endif
