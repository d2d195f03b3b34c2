/*
 * The engine for C code: its functions, Variants by value, and calls of methods by name.
 *
 * Methods are called by name through Variants, not through method binds: binds need a hash of the signature, which
 * changes between engine versions. A frame has about ten calls, and a few for each collider; bulk data goes through
 * pointers into packed arrays.
 *
 * SPDX-License-Identifier: MIT
 */
#ifndef LANGEVIN_GD_H
#define LANGEVIN_GD_H

#include "../abi/gdextension_abi.h"
#include "names.h"

#include <langevin_rigid.h>

/* A Variant of an engine with single precision: 24 bytes. It owns its value: gd_free(). */
typedef struct gd_var {
    uint64_t words[3];
} gd_var;

typedef struct gd_api {
#define GD_FIELD(name, engine_type, result, parameters) gdx_fn_##name name;
    GDX_FUNCTIONS(GD_FIELD)
#undef GD_FIELD
    gdx_from_type from_type[GDX_TYPE_COUNT];
    gdx_to_type to_type[GDX_TYPE_COUNT];
    gdx_inner_pointer inner[GDX_TYPE_COUNT];
    gdx_destructor destroy[GDX_TYPE_COUNT]; /* null for types that own nothing */
    gdx_library library;
    uint64_t names[GD_NAME_COUNT]; /* StringNames */
    gdx_object rendering_server;   /* from the first batch on: extensions are loaded before the server exists */
    uint8_t in_editor;
    void (*load_help)(const char* xml); /* null: the engine takes none */
} gd_api;

extern gd_api gd;

/* Returns 0 if the engine lacks a function, after an error that names it. */
int gd_load(gdx_get_proc_address get, gdx_library library);
void gd_load_names(void);
gdx_object gd_singleton(const char* class_name);

#define GD_NAME(name) ((const void*)&gd.names[GD_N_##name])
int gd_name_is(const void* string_name, int id);

/* New Variants. */
gd_var gd_nil(void);
gd_var gd_bool(int value);
gd_var gd_int(int64_t value);
gd_var gd_float(double value);
gd_var gd_string(const char* utf8);
gd_var gd_string_name(const char* latin1);
gd_var gd_name_var(int id);
gd_var gd_vector3(const float* xyz);
gd_var gd_aabb(const float* position_size);
gd_var gd_color(const float* rgba);
gd_var gd_transform(const float* rows_origin); /* the engine's layout: three rows of the basis, then the origin */
gd_var gd_rid(uint64_t rid);
gd_var gd_object(gdx_object object); /* adds a reference to a counted object; nil for null */
gd_var gd_copy(const gd_var* from);
gd_var gd_empty(gdx_type type); /* a Variant of that type with its initial value, for packed arrays */
gd_var gd_callable(gdx_object object, int method);
void gd_free(gd_var* variant); /* and makes it nil */

gdx_type gd_type(const gd_var* variant);

/* The value of a Variant, with the engine's conversions. */
int64_t gd_to_int(const gd_var* variant);
int gd_to_bool(const gd_var* variant);
double gd_to_float(const gd_var* variant);
void gd_to_floats(const gd_var* variant, gdx_type type, float* out); /* Vector3, Plane, AABB, Transform3D */
uint64_t gd_to_rid(const gd_var* variant);
gdx_object gd_to_object(const gd_var* variant); /* null if it has no object, or the object was freed */
char* gd_to_utf8(const gd_var* string);         /* malloc */
char* gd_string_to_utf8(const void* string);    /* from a String itself; malloc */

/* Packed arrays in Variants. gd_array() makes an array of `count` elements. gd_data() returns writable elements, which the
 * engine copies first if they are shared; null if empty. */
gd_var gd_array(gdx_type type, int64_t count);
int64_t gd_array_count(const gd_var* array);
void gd_array_resize(gd_var* array, int64_t count);
void* gd_data(gd_var* array);
const void* gd_read(const gd_var* array);

/* Calls a method by name. Arguments are gd_var by value, and are freed. ret may be null. Returns 0 after printing an
 * error; ret is then nil. */
int gd_call(gdx_object object, int method, gd_var* ret, int count, ...);
int gd_call_in_place(gd_var* self, int method, gd_var* ret, int count, ...);
int64_t gd_call_int(gdx_object object, int method);
double gd_call_float(gdx_object object, int method);
gdx_object gd_call_object(gdx_object object, int method); /* not for counted objects: keeps no reference */
int gd_call_floats(gdx_object object, int method, gdx_type type, float* out);
gd_var gd_nodes_below_viewport(gdx_object node, const char* class_name); /* Array of nodes in the same World3D */
int gd_is_class(gdx_object object, const char* class_name);

/* Prints to the engine's log and the editor's debugger. */
void gd_message(int warning, const char* function, int line, const char* format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 4, 5)))
#endif
    ;
#define gd_error(...) gd_message(0, __func__, __LINE__, __VA_ARGS__)
#define gd_warning(...) gd_message(1, __func__, __LINE__, __VA_ARGS__)

/* Values of @GlobalScope.Error. */
enum {
    GD_OK = 0,
    GD_FAILED = 1,
    GD_ERR_UNCONFIGURED = 3,
    GD_ERR_OUT_OF_MEMORY = 6,
    GD_ERR_FILE_NOT_FOUND = 7,
    GD_ERR_FILE_CANT_READ = 14,
    GD_ERR_FILE_UNRECOGNIZED = 15,
    GD_ERR_FILE_CORRUPT = 16,
    GD_ERR_INVALID_DATA = 30,
    GD_ERR_INVALID_PARAMETER = 31
};
int gd_error_from_status(lr_status status);

#endif
