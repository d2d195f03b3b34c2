/*
 * Variants and their values, as in the engine: shared until a write, and counted.
 *
 * SPDX-License-Identifier: MIT
 */
#include "host.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static host_name* names;

/* ------------------------------------------------------------------------------------------------------------------ */
/* Values                                                                                                             */

int host_is_packed(uint32_t type) {
    return type >= GDX_PACKED_BYTE_ARRAY && type < GDX_TYPE_COUNT;
}

int64_t host_width_of(uint32_t type) {
    switch (type) {
    case GDX_PACKED_BYTE_ARRAY:
        return 1;
    case GDX_PACKED_INT64_ARRAY:
    case GDX_PACKED_STRING_ARRAY:
        return 8;
    case GDX_PACKED_VECTOR3_ARRAY:
        return 12;
    default:
        return 4;
    }
}

static size_t floats_of(uint32_t type) {
    return type == GDX_AABB ? 6 : 12;
}

host_string* host_string_new(const char* text) {
    host_string* s = calloc(1, sizeof *s);
    s->refs = 1;
    s->text = strdup(text);
    return s;
}

void host_string_free(void* string) {
    host_string* s = *(host_string**)string;
    if (s && --s->refs == 0) free(s->text), free(s);
    *(host_string**)string = NULL;
}

host_name* host_name_new(const char* text) {
    for (host_name* n = names; n; n = n->next)
        if (strcmp(n->text, text) == 0) return ++n->refs, n;
    host_name* n = calloc(1, sizeof *n);
    n->refs = 1;
    n->text = strdup(text);
    n->next = names;
    names = n;
    ++host.names;
    return n;
}

void host_name_free(void* name) {
    host_name* n = *(host_name**)name;
    *(host_name**)name = NULL;
    assert(n && n->refs > 0);
    if (--n->refs > 0) return;
    host_name** link = &names;
    while (*link != n) link = &(*link)->next;
    *link = n->next;
    free(n->text);
    free(n);
    --host.names;
}

void host_array_free(void* array) {
    host_array* a = *(host_array**)array;
    *(host_array**)array = NULL;
    if (!a || --a->refs > 0) return;
    if (a->width == 8 && a->count < 0) abort();
    free(a->data);
    free(a);
}

host_array* host_array_own(host_array** slot, int64_t width, int64_t count) {
    host_array* old = *slot;
    if (old && old->refs == 1 && old->count == count) return old;
    host_array* a = calloc(1, sizeof *a);
    a->refs = 1;
    a->width = width;
    a->count = count;
    a->data = calloc((size_t)(count ? count : 1), (size_t)width);
    if (old) memcpy(a->data, old->data, (size_t)((old->count < count ? old->count : count) * width));
    host_array_free(slot);
    *slot = a;
    return a;
}

void host_variant_new_copy(void* to, const void* from) {
    host_variant* v = to;
    const host_variant* f = from;
    *v = *f;
    if (f->type == GDX_STRING && f->u.string) ++f->u.string->refs;
    if (f->type == GDX_STRING_NAME && f->u.name) ++f->u.name->refs;
    if (f->type == GDX_OBJECT && f->u.object && f->u.object->counted) ++f->u.object->refs;
    if (f->type == GDX_ARRAY && f->u.list) ++f->u.list->refs;
    if (host_is_packed(f->type) && f->u.array) ++f->u.array->refs;
    if (f->type == GDX_AABB || f->type == GDX_TRANSFORM3D) {
        v->u.many = malloc(floats_of(f->type) * sizeof(float));
        memcpy(v->u.many, f->u.many, floats_of(f->type) * sizeof(float));
    }
}

void host_variant_destroy(void* variant) {
    host_variant* v = variant;
    assert(v->type < GDX_TYPE_COUNT);
    if (v->type == GDX_STRING) host_string_free(&v->u.string);
    if (v->type == GDX_STRING_NAME) host_name_free(&v->u.name);
    if (v->type == GDX_AABB || v->type == GDX_TRANSFORM3D) free(v->u.many);
    if (host_is_packed(v->type)) host_array_free(&v->u.array);
    if (v->type == GDX_ARRAY && --v->u.list->refs == 0) {
        for (int i = 0; i < v->u.list->count; ++i) host_variant_destroy(&v->u.list->items[i]);
        free(v->u.list);
    }
    if (v->type == GDX_OBJECT && v->u.object && v->u.object->counted) {
        assert(v->u.object->refs > 0);
        if (--v->u.object->refs == 0) host_free(v->u.object);
    }
    /* Overwrites destroyed values, so that later uses fail. */
    memset(v, 0xee, sizeof *v);
}

void host_variant_new_nil(void* variant) {
    memset(variant, 0, sizeof(host_variant));
}

host_variant host_value_of(uint32_t type) {
    host_variant v;
    host_variant_new_nil(&v);
    v.type = type;
    return v;
}

host_variant host_nil(void) {
    return host_value_of(GDX_NIL);
}
host_variant host_int(int64_t value) {
    host_variant v = host_value_of(GDX_INT);
    v.u.integer = value;
    return v;
}
host_variant host_float(double value) {
    host_variant v = host_value_of(GDX_FLOAT);
    v.u.number = value;
    return v;
}
host_variant host_bool(int value) {
    host_variant v = host_value_of(GDX_BOOL);
    v.u.flag = value != 0;
    return v;
}
host_variant host_vector(float x, float y, float z) {
    host_variant v = host_value_of(GDX_VECTOR3);
    v.u.floats[0] = x, v.u.floats[1] = y, v.u.floats[2] = z;
    return v;
}
host_variant host_text(const char* text) {
    host_variant v = host_value_of(GDX_STRING);
    v.u.string = host_string_new(text);
    return v;
}
host_variant host_obj(host_object* object) {
    host_variant v = host_value_of(object ? GDX_OBJECT : GDX_NIL), c;
    v.u.object = object;
    host_variant_new_copy(&c, &v);
    return c;
}

/* Conversions between Variants and values: a pair of functions for each type, like the engine's. */
#define PAIR(suffix, type_id, value_type, field)                                                                       \
    static void from_##suffix(void* variant, void* value) {                                                            \
        host_variant v = host_value_of(type_id);                                                                       \
        v.u.field = *(value_type*)value;                                                                               \
        host_variant_new_copy(variant, &v);                                                                            \
    }
PAIR(bool, GDX_BOOL, uint8_t, flag)
PAIR(int, GDX_INT, int64_t, integer)
PAIR(float, GDX_FLOAT, double, number)
PAIR(rid, GDX_RID, uint64_t, rid)
PAIR(string, GDX_STRING, host_string*, string)
PAIR(name, GDX_STRING_NAME, host_name*, name)
PAIR(bytes, GDX_PACKED_BYTE_ARRAY, host_array*, array)
PAIR(int64s, GDX_PACKED_INT64_ARRAY, host_array*, array)
PAIR(float32s, GDX_PACKED_FLOAT32_ARRAY, host_array*, array)

static void from_object(void* variant, void* value) {
    host_variant v = host_obj(*(host_object**)value);
    *(host_variant*)variant = v;
}
static void from_vector(void* variant, void* value) {
    const float* f = value;
    *(host_variant*)variant = host_vector(f[0], f[1], f[2]);
}
static void from_color(void* variant, void* value) {
    host_variant v = host_value_of(GDX_COLOR);
    memcpy(v.u.floats, value, 16);
    *(host_variant*)variant = v;
}
static void from_many(void* variant, void* value, uint32_t type) {
    host_variant v = host_value_of(type);
    v.u.many = value;
    host_variant_new_copy(variant, &v);
}
static void from_aabb(void* variant, void* value) {
    from_many(variant, value, GDX_AABB);
}
static void from_transform(void* variant, void* value) {
    from_many(variant, value, GDX_TRANSFORM3D);
}

static double number_of(const host_variant* v) {
    return v->type == GDX_FLOAT  ? v->u.number
           : v->type == GDX_INT  ? (double)v->u.integer
           : v->type == GDX_BOOL ? v->u.flag
                                 : 0.0;
}
static void to_bool(void* value, void* variant) {
    *(uint8_t*)value = number_of(variant) != 0.0;
}
static void to_int(void* value, void* variant) {
    const host_variant* v = variant;
    *(int64_t*)value = v->type == GDX_INT ? v->u.integer : (int64_t)number_of(v);
}
static void to_float(void* value, void* variant) {
    *(double*)value = number_of(variant);
}
static void to_object(void* value, void* variant) {
    *(host_object**)value = ((host_variant*)variant)->u.object;
}
static void to_pointer(void* value, void* variant) {
    host_variant c;
    host_variant_new_copy(&c, variant);
    *(void**)value = c.u.string; /* moves the reference */
}
static void to_rid(void* value, void* variant) {
    const host_variant* v = variant;
    *(uint64_t*)value = v->type == GDX_RID ? v->u.rid : 0;
}
static void to_vector(void* value, void* variant) {
    memcpy(value, ((host_variant*)variant)->u.floats, 12);
}
static void to_plane(void* value, void* variant) {
    memcpy(value, ((host_variant*)variant)->u.floats, 16);
}
static void to_aabb(void* value, void* variant) {
    memcpy(value, ((host_variant*)variant)->u.many, 24);
}
static void to_transform(void* value, void* variant) {
    memcpy(value, ((host_variant*)variant)->u.many, 48);
}

gdx_from_type host_get_variant_from_type_constructor(gdx_type type) {
    switch (type) {
    case GDX_BOOL:
        return from_bool;
    case GDX_INT:
        return from_int;
    case GDX_FLOAT:
        return from_float;
    case GDX_STRING:
        return from_string;
    case GDX_STRING_NAME:
        return from_name;
    case GDX_RID:
        return from_rid;
    case GDX_OBJECT:
        return from_object;
    case GDX_VECTOR3:
        return from_vector;
    case GDX_COLOR:
        return from_color;
    case GDX_AABB:
        return from_aabb;
    case GDX_TRANSFORM3D:
        return from_transform;
    case GDX_PACKED_BYTE_ARRAY:
        return from_bytes;
    case GDX_PACKED_INT64_ARRAY:
        return from_int64s;
    case GDX_PACKED_FLOAT32_ARRAY:
        return from_float32s;
    default:
        return NULL;
    }
}

gdx_to_type host_get_variant_to_type_constructor(gdx_type type) {
    switch (type) {
    case GDX_BOOL:
        return to_bool;
    case GDX_INT:
        return to_int;
    case GDX_FLOAT:
        return to_float;
    case GDX_RID:
        return to_rid;
    case GDX_OBJECT:
        return to_object;
    case GDX_VECTOR3:
        return to_vector;
    case GDX_PLANE:
        return to_plane;
    case GDX_AABB:
        return to_aabb;
    case GDX_TRANSFORM3D:
        return to_transform;
    default:
        return to_pointer;
    }
}

static void* inner(void* variant) {
    return &((host_variant*)variant)->u;
}
gdx_inner_pointer host_variant_get_ptr_internal_getter(gdx_type type) {
    (void)type;
    return inner;
}
gdx_destructor host_variant_get_ptr_destructor(gdx_type type) {
    if (type == GDX_STRING) return host_string_free;
    if (type == GDX_STRING_NAME) return host_name_free;
    return host_is_packed(type) ? host_array_free : NULL;
}
gdx_type host_variant_get_type(const void* variant) {
    const host_variant* v = variant;
    assert(v->type < GDX_TYPE_COUNT);
    return v->type;
}
uint8_t host_variant_can_convert_strict(gdx_type from, gdx_type to) {
    const int number_from = from >= GDX_BOOL && from <= GDX_FLOAT, number_to = to >= GDX_BOOL && to <= GDX_FLOAT;
    return from == to || (number_from && number_to) || (from == GDX_NIL && to == GDX_OBJECT);
}
void host_variant_construct(gdx_type type, void* variant, const void* const* args, int32_t count,
                            gdx_call_error* error) {
    (void)args;
    (void)count;
    *(host_variant*)variant = type == GDX_CALLABLE ? host_nil() : host_value_of(type);
    error->error = GDX_CALL_OK;
}
void host_variant_get_indexed(const void* self, int64_t index, void* ret, uint8_t* valid, uint8_t* out) {
    const host_list* list = ((const host_variant*)self)->u.list;
    *valid = 1;
    *out = index < 0 || index >= list->count;
    assert(!*out);
    host_variant_new_copy(ret, &list->items[index]);
}
void host_string_new_with_utf8_chars(void* string, const char* text) {
    *(host_string**)string = host_string_new(text);
}
int64_t host_string_to_utf8_chars(const void* string, char* text, int64_t capacity) {
    const host_string* s = *(host_string* const*)string;
    const int64_t length = s ? (int64_t)strlen(s->text) : 0;
    if (text) memcpy(text, s ? s->text : "", (size_t)(length < capacity ? length : capacity));
    return length;
}
void host_string_name_new_with_latin1_chars(void* name, const char* text, uint8_t is_static) {
    assert(!is_static); /* the engine expects static names to live forever */
    *(host_name**)name = host_name_new(text);
}

/* Writing unshares, reading does not. */
#define INDEX(name, type, bytes)                                                                                       \
    type* name(void* array, int64_t index) {                                                                           \
        host_array** slot = array;                                                                                     \
        assert(*slot&& index >= 0 && index < (*slot)->count && (*slot)->width == bytes);                               \
        return (type*)(void*)(host_array_own(slot, bytes, (*slot)->count)->data + index * bytes);                      \
    }                                                                                                                  \
    const type* name##_const(const void* array, int64_t index) {                                                       \
        host_array* const* slot = array;                                                                               \
        assert(*slot&& index >= 0 && index < (*slot)->count && (*slot)->width == bytes);                               \
        return (const type*)(const void*)((*slot)->data + index * bytes);                                              \
    }
INDEX(host_packed_byte_array_operator_index, uint8_t, 1)
INDEX(host_packed_int64_array_operator_index, int64_t, 8)
INDEX(host_packed_float32_array_operator_index, float, 4)
INDEX(host_packed_int32_array_operator_index, int32_t, 4)
void* host_packed_vector3_array_operator_index(void* array, int64_t index) {
    host_array** slot = array;
    assert(*slot && index >= 0 && index < (*slot)->count && (*slot)->width == 12);
    return host_array_own(slot, 12, (*slot)->count)->data + 12 * index;
}
void* host_packed_vector3_array_operator_index_const(const void* array, int64_t index) {
    host_array* const* slot = array;
    assert(*slot && index >= 0 && index < (*slot)->count && (*slot)->width == 12);
    return (*slot)->data + 12 * index;
}
