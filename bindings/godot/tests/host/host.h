/*
 * A stand-in for the engine: Variants, names and strings with reference counts, objects, registered classes, and a scene of a
 * few nodes. It detects uses that would crash the engine, and counts leaks.
 *
 * SPDX-License-Identifier: MIT
 */
#ifndef LANGEVIN_TEST_HOST_H
#define LANGEVIN_TEST_HOST_H

#include "../../src/abi/gdextension_abi.h"

typedef struct host_array { /* a packed array; shared until a write */
    int refs;
    int64_t count;
    int64_t width; /* bytes per element */
    unsigned char* data;
} host_array;

typedef struct host_string {
    int refs;
    char* text;
} host_string;

typedef struct host_variant {
    uint32_t type;
    uint32_t padding;
    union {
        uint8_t flag;
        int64_t integer;
        double number;
        uint64_t rid;
        float floats[4];
        float* many; /* AABB, Transform3D */
        host_string* string;
        struct host_name* name;
        host_array* array;
        struct host_object* object;
        struct host_list* list; /* Array */
    } u;
} host_variant;

typedef struct host_name {
    int refs;
    char* text;
    struct host_name* next;
} host_name;

typedef struct host_list {
    int refs;
    int count;
    host_variant items[16];
} host_list;

typedef struct host_method {
    char name[64];
    gdx_method_info info;
    gdx_type types[8];
    gdx_type ret;
    struct host_method* next;
} host_method;

typedef struct host_class {
    char name[64], parent[64];
    gdx_class_info info;
    host_method* methods;
    int properties, signals, constants;
    struct host_class* next;
} host_class;

typedef struct host_object {
    uint64_t id;
    char class_name[64]; /* of the engine */
    host_class* extension;
    void* instance;
    void* binding;
    int counted, refs;
    struct host_object* parent;
    float transform[12];
    struct host_object* next;
} host_object;

typedef struct host_counts {
    int objects, names, rids, multimeshes, buffers, visible, connections, postinitialize;
    int errors, warnings;
    int signals_touched, signals_landed, landed_before, bodies_landed;
    int64_t shown;                                                       /* instances of the last multimesh */
    int flushes, help, redraws, lines, clicks, gizmo_plugins, materials; /* redraws: asked for */
    int editor;                                                          /* Engine.is_editor_hint() */
    int internal_process;
    int hidden;           /* no node is visible */
    float reach;          /* the largest coordinate of a line */
    host_name* plugin;    /* the editor plugin's class */
    int64_t stored, room; /* bytes in the files, and their remaining room */
    char last_error[512];
} host_counts;

extern host_counts host;
extern host_object *host_tree, *host_root, *host_body; /* the scene; the body has a world boundary */

gdx_function host_get(const char* name);
void host_start(void);
void host_stop(void);
host_class* host_find_class(const char* name);
host_object* host_new(const char* class_name, int counted);
host_object* host_construct(const char* class_name); /* like ClassDB */
void host_free(host_object* object);
void host_notify(host_object* object, int what);

/* Calls a method like a script, and like compiled code. Frees the arguments. */
host_variant host_call(host_object* object, const char* method, gdx_call_error* error, int count, ...);
host_method* host_find_method(const host_object* object, const char* method);
void host_virtual(host_object* object, const char* method, const void* const* args, void* ret);

/* The engine's functions. */
#define HOST_DECLARE(name, engine_type, result, parameters) result host_##name parameters;
GDX_FUNCTIONS(HOST_DECLARE)
#undef HOST_DECLARE

host_variant host_nil(void);
host_variant host_int(int64_t value);
host_variant host_float(double value);
host_variant host_bool(int value);
host_variant host_vector(float x, float y, float z);
host_variant host_text(const char* text);
host_variant host_obj(host_object* object);
int host_is_packed(uint32_t type);
int64_t host_width_of(uint32_t type); /* bytes per element */
host_variant host_value_of(uint32_t type);
host_name* host_name_new(const char* text);
void host_name_free(void* name);
void host_array_free(void* array);
host_array* host_array_own(host_array** slot, int64_t width, int64_t count); /* unshared, with that length */
host_string* host_string_new(const char* text);
void host_string_free(void* string);

#endif
