/*
 * SPDX-License-Identifier: MIT
 */
#include "host.h"

#include <assert.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

host_counts host;
static host_name* names;
static host_class* classes;
static host_object* objects;
static uint64_t next_id = 1;

/* ------------------------------------------------------------------------------------------------------------------ */
/* Values                                                                                                             */

static int is_packed(uint32_t type) {
    return type >= GDX_PACKED_BYTE_ARRAY && type < GDX_TYPE_COUNT;
}

static int64_t width_of(uint32_t type) {
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

static host_name* name_new(const char* text) {
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

static void name_free(void* name) {
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

static void array_free(void* array) {
    host_array* a = *(host_array**)array;
    *(host_array**)array = NULL;
    if (!a || --a->refs > 0) return;
    if (a->width == 8 && a->count < 0) abort();
    free(a->data);
    free(a);
}

static host_array* array_own(host_array** slot, int64_t width, int64_t count) {
    host_array* old = *slot;
    if (old && old->refs == 1 && old->count == count) return old;
    host_array* a = calloc(1, sizeof *a);
    a->refs = 1;
    a->width = width;
    a->count = count;
    a->data = calloc((size_t)(count ? count : 1), (size_t)width);
    if (old) memcpy(a->data, old->data, (size_t)((old->count < count ? old->count : count) * width));
    array_free(slot);
    *slot = a;
    return a;
}

static void copy(void* to, const void* from) {
    host_variant* v = to;
    const host_variant* f = from;
    *v = *f;
    if (f->type == GDX_STRING && f->u.string) ++f->u.string->refs;
    if (f->type == GDX_STRING_NAME && f->u.name) ++f->u.name->refs;
    if (f->type == GDX_OBJECT && f->u.object && f->u.object->counted) ++f->u.object->refs;
    if (f->type == GDX_ARRAY && f->u.list) ++f->u.list->refs;
    if (is_packed(f->type) && f->u.array) ++f->u.array->refs;
    if (f->type == GDX_AABB || f->type == GDX_TRANSFORM3D) {
        v->u.many = malloc(floats_of(f->type) * sizeof(float));
        memcpy(v->u.many, f->u.many, floats_of(f->type) * sizeof(float));
    }
}

void host_destroy(void* variant) {
    host_variant* v = variant;
    assert(v->type < GDX_TYPE_COUNT);
    if (v->type == GDX_STRING) host_string_free(&v->u.string);
    if (v->type == GDX_STRING_NAME) name_free(&v->u.name);
    if (v->type == GDX_AABB || v->type == GDX_TRANSFORM3D) free(v->u.many);
    if (is_packed(v->type)) array_free(&v->u.array);
    if (v->type == GDX_ARRAY && --v->u.list->refs == 0) {
        for (int i = 0; i < v->u.list->count; ++i) host_destroy(&v->u.list->items[i]);
        free(v->u.list);
    }
    if (v->type == GDX_OBJECT && v->u.object && v->u.object->counted) {
        assert(v->u.object->refs > 0);
        if (--v->u.object->refs == 0) host_free(v->u.object);
    }
    /* What is used after it was destroyed shall be noticed. */
    memset(v, 0xee, sizeof *v);
}

static void new_nil(void* variant) {
    memset(variant, 0, sizeof(host_variant));
}

static host_variant of(uint32_t type) {
    host_variant v;
    new_nil(&v);
    v.type = type;
    return v;
}

host_variant host_nil(void) {
    return of(GDX_NIL);
}
host_variant host_int(int64_t value) {
    host_variant v = of(GDX_INT);
    v.u.integer = value;
    return v;
}
host_variant host_float(double value) {
    host_variant v = of(GDX_FLOAT);
    v.u.number = value;
    return v;
}
host_variant host_bool(int value) {
    host_variant v = of(GDX_BOOL);
    v.u.flag = value != 0;
    return v;
}
host_variant host_vector(float x, float y, float z) {
    host_variant v = of(GDX_VECTOR3);
    v.u.floats[0] = x, v.u.floats[1] = y, v.u.floats[2] = z;
    return v;
}
host_variant host_text(const char* text) {
    host_variant v = of(GDX_STRING);
    v.u.string = host_string_new(text);
    return v;
}
host_variant host_obj(host_object* object) {
    host_variant v = of(object ? GDX_OBJECT : GDX_NIL), c;
    v.u.object = object;
    copy(&c, &v);
    return c;
}

/* Conversions between Variants and values: one pair of functions for each type, as the engine gives out. */
#define PAIR(suffix, type_id, value_type, field)                                                                       \
    static void from_##suffix(void* variant, void* value) {                                                            \
        host_variant v = of(type_id);                                                                                  \
        v.u.field = *(value_type*)value;                                                                               \
        copy(variant, &v);                                                                                             \
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
static void from_many(void* variant, void* value, uint32_t type) {
    host_variant v = of(type);
    v.u.many = value;
    copy(variant, &v);
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
    copy(&c, variant);
    *(void**)value = c.u.string; /* the reference goes along */
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

static gdx_from_type get_from(gdx_type type) {
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

static gdx_to_type get_to(gdx_type type) {
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
static gdx_inner_pointer get_inner(gdx_type type) {
    (void)type;
    return inner;
}
static gdx_destructor get_destructor(gdx_type type) {
    if (type == GDX_STRING) return host_string_free;
    if (type == GDX_STRING_NAME) return name_free;
    return is_packed(type) ? array_free : NULL;
}
static gdx_type get_type(const void* variant) {
    const host_variant* v = variant;
    assert(v->type < GDX_TYPE_COUNT);
    return v->type;
}
static uint8_t can_convert(gdx_type from, gdx_type to) {
    const int number_from = from >= GDX_BOOL && from <= GDX_FLOAT, number_to = to >= GDX_BOOL && to <= GDX_FLOAT;
    return from == to || (number_from && number_to) || (from == GDX_NIL && to == GDX_OBJECT);
}
static void construct(gdx_type type, void* variant, const void* const* args, int32_t count, gdx_call_error* error) {
    (void)args;
    (void)count;
    *(host_variant*)variant = type == GDX_CALLABLE ? host_nil() : of(type);
    error->error = GDX_CALL_OK;
}
static void get_indexed(const void* self, int64_t index, void* ret, uint8_t* valid, uint8_t* out) {
    const host_list* list = ((const host_variant*)self)->u.list;
    *valid = 1;
    *out = index < 0 || index >= list->count;
    assert(!*out);
    copy(ret, &list->items[index]);
}
static void string_new(void* string, const char* text) {
    *(host_string**)string = host_string_new(text);
}
static int64_t string_to(const void* string, char* text, int64_t capacity) {
    const host_string* s = *(host_string* const*)string;
    const int64_t length = s ? (int64_t)strlen(s->text) : 0;
    if (text) memcpy(text, s ? s->text : "", (size_t)(length < capacity ? length : capacity));
    return length;
}
static void name_make(void* name, const char* text, uint8_t is_static) {
    assert(!is_static); /* the engine expects those to live for ever */
    *(host_name**)name = name_new(text);
}

/* Writing unshares, reading does not. */
#define INDEX(name, type, bytes)                                                                                       \
    static type* name(void* array, int64_t index) {                                                                    \
        host_array** slot = array;                                                                                     \
        assert(*slot&& index >= 0 && index < (*slot)->count && (*slot)->width == bytes);                               \
        return (type*)(void*)(array_own(slot, bytes, (*slot)->count)->data + index * bytes);                           \
    }                                                                                                                  \
    static const type* name##_const(const void* array, int64_t index) {                                                \
        host_array* const* slot = array;                                                                               \
        assert(*slot&& index >= 0 && index < (*slot)->count && (*slot)->width == bytes);                               \
        return (const type*)(const void*)((*slot)->data + index * bytes);                                              \
    }
INDEX(index_bytes, uint8_t, 1)
INDEX(index_int64, int64_t, 8)
INDEX(index_float, float, 4)
INDEX(index_int32, int32_t, 4)
static void* index_vector(void* array, int64_t index) {
    host_array** slot = array;
    assert(*slot && index >= 0 && index < (*slot)->count && (*slot)->width == 12);
    return array_own(slot, 12, (*slot)->count)->data + 12 * index;
}
static void* index_vector_const(const void* array, int64_t index) {
    host_array* const* slot = array;
    assert(*slot && index >= 0 && index < (*slot)->count && (*slot)->width == 12);
    return (*slot)->data + 12 * index;
}

/* ------------------------------------------------------------------------------------------------------------------ */
/* Objects and classes                                                                                                */

host_class* host_find_class(const char* name) {
    for (host_class* c = classes; c; c = c->next)
        if (strcmp(c->name, name) == 0) return c;
    return NULL;
}

host_object* host_new(const char* class_name, int counted) {
    host_object* o = calloc(1, sizeof *o);
    static const float identity[12] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    o->id = next_id++;
    snprintf(o->class_name, sizeof o->class_name, "%s", class_name);
    o->counted = counted;
    memcpy(o->transform, identity, sizeof identity);
    o->next = objects;
    objects = o;
    ++host.objects;
    return o;
}

void host_free(host_object* o) {
    host_object** link = &objects;
    while (*link && *link != o) link = &(*link)->next;
    assert(*link == o);
    if (o->instance) o->extension->info.release(o->extension->info.userdata, o->instance);
    *link = o->next;
    free(o);
    --host.objects;
}

host_object* host_construct(const char* class_name) {
    host_class* c = host_find_class(class_name);
    if (c) return c->info.create(c->info.userdata, 1);
    return host_new(class_name, strstr(class_name, "Resource") != NULL);
}

static gdx_object construct_object(const void* name) {
    return host_construct((*(host_name* const*)name)->text);
}
static void object_destroy(void* object) {
    host_free(object);
}
static gdx_object from_id(uint64_t id) {
    for (host_object* o = objects; o; o = o->next)
        if (o->id == id) return o;
    return NULL;
}
static uint64_t id_of(const void* object) {
    return ((const host_object*)object)->id;
}
static void* get_binding(void* object, void* token, const gdx_binding_callbacks* callbacks) {
    (void)token;
    (void)callbacks;
    return ((host_object*)object)->binding;
}
static void set_binding(void* object, void* token, void* binding, const gdx_binding_callbacks* callbacks) {
    (void)token;
    (void)callbacks;
    ((host_object*)object)->binding = binding;
}
static void set_instance(void* object, const void* class_name, void* instance) {
    host_object* o = object;
    o->extension = host_find_class((*(host_name* const*)class_name)->text);
    assert(o->extension && strcmp(o->extension->parent, o->class_name) == 0);
    o->instance = instance;
}
static void ref_set(void* ref, void* object) {
    *(void**)ref = object;
    ++((host_object*)object)->refs;
}
static void register_class(void* library, const void* name, const void* parent, const gdx_class_info* info) {
    host_class* c = calloc(1, sizeof *c);
    (void)library;
    snprintf(c->name, sizeof c->name, "%s", (*(host_name* const*)name)->text);
    snprintf(c->parent, sizeof c->parent, "%s", (*(host_name* const*)parent)->text);
    c->info = *info;
    assert(info->create && info->release);
    c->next = classes;
    classes = c;
}
static void register_method(void* library, const void* class_name, const gdx_method_info* info) {
    host_class* c = host_find_class((*(host_name* const*)class_name)->text);
    host_method* m = calloc(1, sizeof *m);
    (void)library;
    assert(c && info->call && info->ptrcall && info->argument_count <= 8);
    snprintf(m->name, sizeof m->name, "%s", (*(host_name**)info->name)->text);
    m->info = *info;
    m->ret = info->has_return ? info->return_info->type : GDX_NIL;
    for (uint32_t i = 0; i < info->argument_count; ++i) m->types[i] = info->arguments[i].type;
    m->next = c->methods;
    c->methods = m;
}
static void register_property(void* library, const void* class_name, const gdx_property_info* info, const void* setter,
                              const void* getter) {
    host_class* c = host_find_class((*(host_name* const*)class_name)->text);
    int found = 0;
    (void)library;
    (void)info;
    for (host_method* m = c->methods; m; m = m->next)
        found +=
            !strcmp(m->name, (*(host_name* const*)setter)->text) + !strcmp(m->name, (*(host_name* const*)getter)->text);
    assert(found == 2); /* the engine refuses properties without their methods */
    ++c->properties;
}
static void register_group(void* library, const void* class_name, const void* group, const void* prefix) {
    (void)library, (void)class_name, (void)group, (void)prefix;
}
static void register_signal(void* library, const void* class_name, const void* name, const gdx_property_info* args,
                            int64_t count) {
    (void)library, (void)name, (void)args, (void)count;
    ++host_find_class((*(host_name* const*)class_name)->text)->signals;
}
static void register_constant(void* library, const void* class_name, const void* enumeration, const void* name,
                              int64_t value, uint8_t is_bitfield) {
    (void)library, (void)enumeration, (void)name, (void)value, (void)is_bitfield;
    ++host_find_class((*(host_name* const*)class_name)->text)->constants;
}
static void unregister_class(void* library, const void* name) {
    host_class** link = &classes;
    (void)library;
    while (*link && strcmp((*link)->name, (*(host_name* const*)name)->text) != 0) link = &(*link)->next;
    host_class* c = *link;
    assert(c);
    *link = c->next;
    while (c->methods) {
        host_method* m = c->methods;
        c->methods = m->next;
        free(m);
    }
    free(c);
}
static void print_error(const char* description, const char* message, const char* function, const char* file,
                        int32_t line, uint8_t notify) {
    (void)description, (void)function, (void)file, (void)line, (void)notify;
    ++host.errors;
    snprintf(host.last_error, sizeof host.last_error, "%s", message);
}
static void print_warning(const char* description, const char* message, const char* function, const char* file,
                          int32_t line, uint8_t notify) {
    (void)description, (void)message, (void)function, (void)file, (void)line, (void)notify;
    ++host.warnings;
}

void scene_call(host_variant* self, const char* method, const void* const* args, int64_t count, host_variant* ret,
                gdx_call_error* error);
host_object* scene_singleton(const char* name);

static void variant_call(void* self, const void* method, const void* const* args, int64_t count, void* ret,
                         gdx_call_error* error) {
    host_variant* v = self;
    const char* name = (*(host_name* const*)method)->text;
    error->error = GDX_CALL_OK;
    new_nil(ret);
    if (is_packed(v->type)) {
        const int64_t width = width_of(v->type);
        if (!strcmp(name, "size")) {
            *(host_variant*)ret = host_int(v->u.array ? v->u.array->count : 0);
        } else if (!strcmp(name, "resize")) {
            array_own(&v->u.array, width, ((const host_variant*)args[0])->u.integer);
        } else if (!strcmp(name, "append")) {
            array_own(&v->u.array, width, (v->u.array ? v->u.array->count : 0) + 1); /* counts only */
        } else {
            error->error = GDX_CALL_INVALID_METHOD;
        }
    } else if (v->type == GDX_ARRAY && !strcmp(name, "size")) {
        *(host_variant*)ret = host_int(v->u.list->count);
    } else if (v->type == GDX_OBJECT && v->u.object) {
        host_method* m = host_find_method(v->u.object, name);
        if (m)
            m->info.call(m->info.userdata, v->u.object->instance, args, count, ret, error);
        else
            scene_call(v, name, args, count, ret, error);
    } else {
        error->error = GDX_CALL_INSTANCE_IS_NULL;
    }
}

host_method* host_find_method(const host_object* object, const char* method) {
    for (host_method* m = object->extension ? object->extension->methods : NULL; m; m = m->next)
        if (strcmp(m->name, method) == 0) return m;
    return NULL;
}

host_variant host_call(host_object* object, const char* method, gdx_call_error* error, int count, ...) {
    host_variant args[8], ret = host_nil();
    const void* pointers[8];
    gdx_call_error ignored;
    va_list list;
    va_start(list, count);
    for (int i = 0; i < count; ++i) args[i] = va_arg(list, host_variant), pointers[i] = &args[i];
    va_end(list);
    host_method* m = host_find_method(object, method);
    if (!m) fprintf(stderr, "no method %s\n", method), abort();
    if (!error) error = &ignored;
    m->info.call(m->info.userdata, object->instance, pointers, count, &ret, error);
    for (int i = 0; i < count; ++i) host_destroy(&args[i]);
    return ret;
}

void host_notify(host_object* object, int what) {
    object->extension->info.notification(object->instance, what, 0);
}

void host_virtual(host_object* object, const char* method, const void* const* args, void* ret) {
    host_name* name = name_new(method);
    gdx_virtual_call call = object->extension->info.get_virtual(object->extension->info.userdata, &name, 0);
    assert(call);
    call(object->instance, args, ret);
    name_free(&name);
}

static gdx_object singleton(const void* name) {
    return scene_singleton((*(host_name* const*)name)->text);
}

/* The two binds that are asked for. */
static const char bind_notification, bind_file;
static const void* method_bind(const void* class_name, const void* method, int64_t hash) {
    const char* name = (*(host_name* const*)method)->text;
    (void)class_name;
    if (!strcmp(name, "notification") && hash == 4023243586) return &bind_notification;
    if (!strcmp(name, "get_file_as_bytes") && hash == 659035735) return &bind_file;
    return NULL;
}
static void bind_ptrcall(const void* bind, void* object, const void* const* args, void* ret) {
    (void)ret;
    assert(bind == &bind_notification && object && *(const int64_t*)args[0] == 0);
    ++host.postinitialize;
}
static void bind_call(const void* bind, void* object, const void* const* args, int64_t count, void* ret,
                      gdx_call_error* error) {
    assert(bind == &bind_file && !object && count == 1);
    host_variant bytes = of(GDX_PACKED_BYTE_ARRAY);
    FILE* file = fopen(((const host_variant*)args[0])->u.string->text, "rb");
    if (file) {
        fseek(file, 0, SEEK_END);
        const long size = ftell(file);
        rewind(file);
        array_own(&bytes.u.array, 1, size);
        if (fread(bytes.u.array->data, 1, (size_t)size, file) != (size_t)size) abort();
        fclose(file);
    }
    *(host_variant*)ret = bytes;
    error->error = GDX_CALL_OK;
}

#define host_print_error_with_message print_error
#define host_print_warning_with_message print_warning
#define host_variant_new_copy copy
#define host_variant_new_nil new_nil
#define host_variant_destroy host_destroy
#define host_variant_get_type get_type
#define host_variant_can_convert_strict can_convert
#define host_variant_call variant_call
#define host_variant_construct construct
#define host_variant_get_indexed get_indexed
#define host_get_variant_from_type_constructor get_from
#define host_get_variant_to_type_constructor get_to
#define host_variant_get_ptr_internal_getter get_inner
#define host_variant_get_ptr_destructor get_destructor
#define host_string_new_with_utf8_chars string_new
#define host_string_to_utf8_chars string_to
#define host_string_name_new_with_latin1_chars name_make
#define host_packed_byte_array_operator_index index_bytes
#define host_packed_byte_array_operator_index_const index_bytes_const
#define host_packed_int32_array_operator_index_const index_int32_const
#define host_packed_int64_array_operator_index index_int64
#define host_packed_int64_array_operator_index_const index_int64_const
#define host_packed_float32_array_operator_index index_float
#define host_packed_float32_array_operator_index_const index_float_const
#define host_packed_vector3_array_operator_index index_vector
#define host_packed_vector3_array_operator_index_const index_vector_const
#define host_object_destroy object_destroy
#define host_object_method_bind_call bind_call
#define host_object_method_bind_ptrcall bind_ptrcall
#define host_global_get_singleton singleton
#define host_object_get_instance_binding get_binding
#define host_object_set_instance_binding set_binding
#define host_object_set_instance set_instance
#define host_object_get_instance_from_id from_id
#define host_object_get_instance_id id_of
#define host_ref_set_object ref_set
#define host_classdb_construct_object2 construct_object
#define host_classdb_get_method_bind method_bind
#define host_classdb_register_extension_class4 register_class
#define host_classdb_register_extension_class_method register_method
#define host_classdb_register_extension_class_integer_constant register_constant
#define host_classdb_register_extension_class_property register_property
#define host_classdb_register_extension_class_property_group register_group
#define host_classdb_register_extension_class_signal register_signal
#define host_classdb_unregister_extension_class unregister_class

gdx_function host_get(const char* name) {
    (void)index_int32;
#define GIVE(function, engine_type, result, parameters)                                                                \
    if (strcmp(name, #function) == 0) {                                                                                \
        gdx_fn_##function f = host_##function;                                                                         \
        return (gdx_function)f;                                                                                        \
    }
    GDX_FUNCTIONS(GIVE)
#undef GIVE
    return NULL;
}
