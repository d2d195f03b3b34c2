/*
 * Classes as tables: properties are fields of the instance's struct, methods are functions on Variants. Calls, pointer
 * calls, argument checks and conversions are the same for all classes.
 *
 * SPDX-License-Identifier: MIT
 */
#ifndef LANGEVIN_GD_CLASS_H
#define LANGEVIN_GD_CLASS_H

#include "gd.h"

/* The first member of each instance. */
typedef struct gd_instance {
    const struct gd_class* type;
    gdx_object object; /* the engine's object, not counted */
    uint64_t id;
} gd_instance;

#define GD_MAX_ARGS 4

typedef struct gd_arg {
    const char* name;
    gdx_type type;
    const char* class_name; /* of objects */
} gd_arg;

/* args: of the declared types. ret: nil, can be set. instance: null in static methods. */
typedef void (*gd_method_fn)(void* instance, const gd_var* args, gd_var* ret);

typedef struct gd_method {
    const char* name;
    gd_method_fn run;
    uint32_t flags; /* GDX_METHOD_*; 0 for normal */
    gd_arg ret;     /* type GDX_NIL: none */
    uint32_t arg_count;
    gd_arg args[GD_MAX_ARGS];
} gd_method;

enum { GD_HINT_NONE = 0, GD_HINT_RANGE = 1, GD_HINT_ENUM = 2, GD_HINT_FLAGS = 6 };
enum { GD_HINT_LAYERS_3D_RENDER = 10, GD_HINT_LAYERS_3D_PHYSICS = 11, GD_HINT_RESOURCE_TYPE = 17 };
enum { GD_USAGE_DEFAULT = 6, GD_USAGE_STORAGE = 2 };

/* The field's type in the struct: GDX_BOOL and GDX_INT int64_t, GDX_FLOAT double, GDX_VECTOR3, GDX_AABB,
 * GDX_TRANSFORM3D floats as in the engine, GDX_OBJECT gd_var (nil or an object of class hint_string). */
typedef struct gd_property {
    const char* name; /* methods are set_NAME and get_NAME, or is_NAME of a GDX_BOOL */
    gdx_type type;    /* GDX_NIL: a group of the inspector begins here; `name` is its title */
    size_t offset;
    uint32_t hint; /* GD_HINT_* */
    const char* hint_string;
    double minimum, maximum;         /* of numbers, and of each component of a Vector3; both 0: no limits */
    void (*changed)(void* instance); /* called after a change of the field; may be null */
    gd_method_fn get, set;           /* replace a field */
    uint32_t usage;                  /* 0: GD_USAGE_DEFAULT */
} gd_property;

typedef struct gd_signal {
    const char* name;
    uint32_t arg_count;
    gd_arg args[GD_MAX_ARGS];
} gd_signal;

typedef struct gd_constant {
    const char* enumeration;
    const char* name;
    int64_t value;
} gd_constant;

typedef struct gd_virtual {
    int name; /* GD_N_* */
    gdx_virtual_call call;
} gd_virtual;

typedef struct gd_class {
    const char* name;
    const char* parent;
    size_t size;
    void (*construct)(void* instance); /* zeroed except gd_instance; the engine's object must not be called yet */
    void (*destruct)(void* instance);
    void (*notification)(void* instance, int32_t what);
    const gd_property* properties; /* ends with a null name, like the tables below */
    const gd_method* methods;
    const gd_signal* signals;
    const gd_constant* constants;
    const gd_virtual* virtuals; /* ends with a null call */
    int internal;               /* hidden in the editor's lists */
} gd_class;

void gd_register(const gd_class* type);
void gd_unregister(const gd_class* type);

/* A new object, as by ClassDB, which makes no internal classes in some versions. */
gdx_object gd_construct(const gd_class* type);

/* The instance of an engine's object; null if the object is of another class. */
void* gd_instance_of(gdx_object object, const gd_class* type);

#endif
