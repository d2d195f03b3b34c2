/*
 * SPDX-License-Identifier: MIT
 */
#include "gd.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

gd_api gd;

int gd_load(gdx_get_proc_address get, gdx_library library) {
    const char* missing = NULL;
    memset(&gd, 0, sizeof gd);
    gd.library = library;
#define GD_LOAD(name, engine_type, result, parameters)                                                                 \
    gd.name = (gdx_fn_##name)get(#name);                                                                               \
    if (!gd.name && !missing) missing = #name;
    GDX_FUNCTIONS(GD_LOAD)
#undef GD_LOAD
    gd.load_help = (void (*)(const char*))get("editor_help_load_xml_from_utf8_chars");
    if (missing) {
        fprintf(stderr, "langevin_rigid: this engine has no %s: Godot 4.4 or later is required\n", missing);
        return 0;
    }
    static const gdx_type used[] = {GDX_BOOL,
                                    GDX_INT,
                                    GDX_FLOAT,
                                    GDX_STRING,
                                    GDX_VECTOR3,
                                    GDX_PLANE,
                                    GDX_AABB,
                                    GDX_TRANSFORM3D,
                                    GDX_COLOR,
                                    GDX_STRING_NAME,
                                    GDX_NODE_PATH,
                                    GDX_RID,
                                    GDX_OBJECT,
                                    GDX_CALLABLE,
                                    GDX_DICTIONARY,
                                    GDX_ARRAY,
                                    GDX_PACKED_BYTE_ARRAY,
                                    GDX_PACKED_INT32_ARRAY,
                                    GDX_PACKED_INT64_ARRAY,
                                    GDX_PACKED_FLOAT32_ARRAY,
                                    GDX_PACKED_STRING_ARRAY,
                                    GDX_PACKED_VECTOR3_ARRAY};
    for (size_t i = 0; i < sizeof used / sizeof *used; ++i) {
        const gdx_type type = used[i];
        gd.from_type[type] = gd.get_variant_from_type_constructor(type);
        gd.to_type[type] = gd.get_variant_to_type_constructor(type);
        gd.inner[type] = gd.variant_get_ptr_internal_getter(type);
        gd.destroy[type] = gd.variant_get_ptr_destructor(type);
    }
    return 1;
}

void gd_load_names(void) {
#define GD_MAKE(name) gd.string_name_new_with_latin1_chars(&gd.names[GD_N_##name], #name, 0);
    GD_NAMES(GD_MAKE)
#undef GD_MAKE
    gd.in_editor = (uint8_t)gd_call_int(gd_singleton("Engine"), GD_N_is_editor_hint);
}

gdx_object gd_singleton(const char* class_name) {
    uint64_t name = 0;
    gd.string_name_new_with_latin1_chars(&name, class_name, 0);
    gdx_object singleton = gd.global_get_singleton(&name);
    gd.destroy[GDX_STRING_NAME](&name);
    return singleton;
}

/* StringNames are interned: equal names are equal pointers. */
int gd_name_is(const void* string_name, int id) {
    return *(const uint64_t*)string_name == gd.names[id];
}

/* ------------------------------------------------------------------------------------------------------------------ */

static gd_var from(gdx_type type, const void* value) {
    gd_var variant;
    gd.from_type[type](&variant, (void*)value);
    return variant;
}

gd_var gd_nil(void) {
    gd_var variant;
    gd.variant_new_nil(&variant);
    return variant;
}

gd_var gd_bool(int value) {
    const uint8_t flag = value != 0;
    return from(GDX_BOOL, &flag);
}

gd_var gd_int(int64_t value) {
    return from(GDX_INT, &value);
}

gd_var gd_float(double value) {
    return from(GDX_FLOAT, &value);
}

gd_var gd_string(const char* utf8) {
    uint64_t string = 0;
    gd.string_new_with_utf8_chars(&string, utf8);
    const gd_var variant = from(GDX_STRING, &string);
    gd.destroy[GDX_STRING](&string);
    return variant;
}

gd_var gd_string_name(const char* latin1) {
    uint64_t name = 0;
    gd.string_name_new_with_latin1_chars(&name, latin1, 0);
    const gd_var variant = from(GDX_STRING_NAME, &name);
    gd.destroy[GDX_STRING_NAME](&name);
    return variant;
}

gd_var gd_name_var(int id) {
    return from(GDX_STRING_NAME, &gd.names[id]);
}

gd_var gd_vector3(const float* xyz) {
    return from(GDX_VECTOR3, xyz);
}

gd_var gd_aabb(const float* position_size) {
    return from(GDX_AABB, position_size);
}

gd_var gd_color(const float* rgba) {
    return from(GDX_COLOR, rgba);
}

gd_var gd_transform(const float* rows_origin) {
    return from(GDX_TRANSFORM3D, rows_origin);
}

gd_var gd_rid(uint64_t rid) {
    return from(GDX_RID, &rid);
}

gd_var gd_object(gdx_object object) {
    return object ? from(GDX_OBJECT, &object) : gd_nil();
}

gd_var gd_copy(const gd_var* source) {
    gd_var variant;
    gd.variant_new_copy(&variant, source);
    return variant;
}

gd_var gd_empty(gdx_type type) {
    gd_var variant;
    gdx_call_error error = {0};
    gd.variant_construct(type, &variant, NULL, 0, &error);
    return variant;
}

gd_var gd_callable(gdx_object object, int method) {
    gd_var args[2] = {gd_object(object), gd_name_var(method)}, variant;
    const void* pointers[2] = {&args[0], &args[1]};
    gdx_call_error error = {0};
    gd.variant_construct(GDX_CALLABLE, &variant, pointers, 2, &error);
    gd_free(&args[0]);
    gd_free(&args[1]);
    return variant;
}

void gd_free(gd_var* variant) {
    gd.variant_destroy(variant);
    gd.variant_new_nil(variant);
}

gdx_type gd_type(const gd_var* variant) {
    return gd.variant_get_type(variant);
}

int64_t gd_to_int(const gd_var* variant) {
    int64_t value = 0;
    gd.to_type[GDX_INT](&value, (void*)variant);
    return value;
}

int gd_to_bool(const gd_var* variant) {
    uint8_t value = 0;
    gd.to_type[GDX_BOOL](&value, (void*)variant);
    return value;
}

double gd_to_float(const gd_var* variant) {
    double value = 0.0;
    gd.to_type[GDX_FLOAT](&value, (void*)variant);
    return value;
}

void gd_to_floats(const gd_var* variant, gdx_type type, float* out) {
    gd.to_type[type](out, (void*)variant);
}

uint64_t gd_to_rid(const gd_var* variant) {
    uint64_t value = 0;
    gd.to_type[GDX_RID](&value, (void*)variant);
    return value;
}

gdx_object gd_to_object(const gd_var* variant) {
    gdx_object object = NULL;
    if (gd_type(variant) == GDX_OBJECT) gd.to_type[GDX_OBJECT](&object, (void*)variant);
    return object;
}

char* gd_string_to_utf8(const void* string) {
    const int64_t length = gd.string_to_utf8_chars(string, NULL, 0);
    char* text = malloc((size_t)length + 1u);
    if (!text) return NULL;
    gd.string_to_utf8_chars(string, text, length);
    text[length] = 0;
    return text;
}

char* gd_to_utf8(const gd_var* variant) {
    uint64_t string = 0;
    gd.to_type[GDX_STRING](&string, (void*)variant);
    char* text = gd_string_to_utf8(&string);
    gd.destroy[GDX_STRING](&string);
    return text;
}

/* ------------------------------------------------------------------------------------------------------------------ */

gd_var gd_array(gdx_type type, int64_t count) {
    gd_var array = gd_empty(type);
    gd_array_resize(&array, count);
    return array;
}

int64_t gd_array_count(const gd_var* array) {
    gd_var ret;
    if (!gd_call_in_place((gd_var*)array, GD_N_size, &ret, 0)) return 0;
    const int64_t count = gd_to_int(&ret);
    gd_free(&ret);
    return count;
}

void gd_array_resize(gd_var* array, int64_t count) {
    gd_call_in_place(array, GD_N_resize, NULL, 1, gd_int(count));
}

void* gd_data(gd_var* array) {
    if (gd_array_count(array) == 0) return NULL;
    const gdx_type type = gd_type(array);
    void* inner = gd.inner[type](array);
    switch (type) {
    case GDX_PACKED_BYTE_ARRAY:
        return gd.packed_byte_array_operator_index(inner, 0);
    case GDX_PACKED_INT64_ARRAY:
        return gd.packed_int64_array_operator_index(inner, 0);
    case GDX_PACKED_FLOAT32_ARRAY:
        return gd.packed_float32_array_operator_index(inner, 0);
    case GDX_PACKED_VECTOR3_ARRAY:
        return gd.packed_vector3_array_operator_index(inner, 0);
    default:
        return NULL;
    }
}

const void* gd_read(const gd_var* array) {
    if (gd_array_count(array) == 0) return NULL;
    const gdx_type type = gd_type(array);
    const void* inner = gd.inner[type]((void*)array);
    switch (type) {
    case GDX_PACKED_BYTE_ARRAY:
        return gd.packed_byte_array_operator_index_const(inner, 0);
    case GDX_PACKED_INT32_ARRAY:
        return gd.packed_int32_array_operator_index_const(inner, 0);
    case GDX_PACKED_INT64_ARRAY:
        return gd.packed_int64_array_operator_index_const(inner, 0);
    case GDX_PACKED_FLOAT32_ARRAY:
        return gd.packed_float32_array_operator_index_const(inner, 0);
    case GDX_PACKED_VECTOR3_ARRAY:
        return gd.packed_vector3_array_operator_index_const(inner, 0);
    default:
        return NULL;
    }
}

/* ------------------------------------------------------------------------------------------------------------------ */

#define MAX_ARGS 8

static int call(gd_var* self, int method, gd_var* ret, int count, va_list list) {
    gd_var args[MAX_ARGS], result;
    const void* pointers[MAX_ARGS];
    gdx_call_error error = {0};
    for (int i = 0; i < count && i < MAX_ARGS; ++i) {
        args[i] = va_arg(list, gd_var);
        pointers[i] = &args[i];
    }
    gd.variant_new_nil(&result);
    gd.variant_call(self, &gd.names[method], pointers, count, &result, &error);
    for (int i = 0; i < count && i < MAX_ARGS; ++i) gd.variant_destroy(&args[i]);
    if (error.error != GDX_CALL_OK) {
        static const char* const texts[GD_NAME_COUNT] = {
#define GD_TEXT(name) #name,
            GD_NAMES(GD_TEXT)
#undef GD_TEXT
        };
        gd_error("calling %s: error %u at argument %d", texts[method], (unsigned)error.error, (int)error.argument);
        gd.variant_destroy(&result);
        if (ret) *ret = gd_nil();
        return 0;
    }
    if (ret)
        *ret = result;
    else
        gd.variant_destroy(&result);
    return 1;
}

int gd_call(gdx_object object, int method, gd_var* ret, int count, ...) {
    gd_var self = gd_object(object);
    va_list list;
    va_start(list, count);
    const int ok = call(&self, method, ret, count, list);
    va_end(list);
    gd.variant_destroy(&self);
    return ok;
}

int gd_call_in_place(gd_var* self, int method, gd_var* ret, int count, ...) {
    va_list list;
    va_start(list, count);
    const int ok = call(self, method, ret, count, list);
    va_end(list);
    return ok;
}

int64_t gd_call_int(gdx_object object, int method) {
    gd_var ret;
    if (!gd_call(object, method, &ret, 0)) return 0;
    const int64_t value = gd_to_int(&ret);
    gd_free(&ret);
    return value;
}

double gd_call_float(gdx_object object, int method) {
    gd_var ret;
    if (!gd_call(object, method, &ret, 0)) return 0.0;
    const double value = gd_to_float(&ret);
    gd_free(&ret);
    return value;
}

gdx_object gd_call_object(gdx_object object, int method) {
    gd_var ret;
    if (!gd_call(object, method, &ret, 0)) return NULL;
    gdx_object result = gd_to_object(&ret);
    gd_free(&ret);
    return result;
}

gd_var gd_nodes_below_viewport(gdx_object node, const char* class_name) {
    gd_var nodes = gd_nil();
    gdx_object viewport = gd_call_object(node, GD_N_get_viewport);
    if (viewport)
        gd_call(viewport, GD_N_find_children, &nodes, 4, gd_string("*"), gd_string(class_name), gd_bool(1), gd_bool(0));
    return nodes;
}

int gd_call_floats(gdx_object object, int method, gdx_type type, float* out) {
    gd_var ret;
    if (!gd_call(object, method, &ret, 0)) return 0;
    const int ok = gd_type(&ret) == type;
    if (ok) gd_to_floats(&ret, type, out);
    gd_free(&ret);
    return ok;
}

int gd_is_class(gdx_object object, const char* class_name) {
    gd_var ret;
    if (!object || !gd_call(object, GD_N_is_class, &ret, 1, gd_string(class_name))) return 0;
    const int is = gd_to_bool(&ret);
    gd_free(&ret);
    return is;
}

/* ------------------------------------------------------------------------------------------------------------------ */

void gd_message(int warning, const char* function, int line, const char* format, ...) {
    char text[1024];
    const size_t prefix = strlen(strcpy(text, "Langevin Rigid: "));
    va_list list;
    va_start(list, format);
    vsnprintf(text + prefix, sizeof text - prefix, format, list);
    va_end(list);
    if (warning)
        gd.print_warning_with_message(text, text, function, "langevin_rigid_godot", line, 0);
    else
        gd.print_error_with_message(text, text, function, "langevin_rigid_godot", line, 0);
}

int gd_error_from_status(lr_status status) {
    switch (status) {
    case LR_OK:
        return GD_OK;
    case LR_ERROR_OUT_OF_MEMORY:
    case LR_ERROR_CAPACITY:
        return GD_ERR_OUT_OF_MEMORY;
    case LR_ERROR_FILE_NOT_FOUND:
        return GD_ERR_FILE_NOT_FOUND;
    case LR_ERROR_FILE_READ:
        return GD_ERR_FILE_CANT_READ;
    case LR_ERROR_ASSET_FORMAT:
    case LR_ERROR_ASSET_VERSION:
        return GD_ERR_FILE_UNRECOGNIZED;
    case LR_ERROR_ASSET_CORRUPT:
        return GD_ERR_FILE_CORRUPT;
    case LR_ERROR_ASSET_INVALID:
    case LR_ERROR_SNAPSHOT_FORMAT:
    case LR_ERROR_SNAPSHOT_MISMATCH:
        return GD_ERR_INVALID_DATA;
    case LR_ERROR_INTERNAL:
        return GD_FAILED;
    default:
        return GD_ERR_INVALID_PARAMETER;
    }
}
