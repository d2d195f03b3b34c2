/*
 * Objects, classes, and the engine's functions by name.
 *
 * SPDX-License-Identifier: MIT
 */
#include "host.h"

#include <assert.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

host_counts host;
static host_class* classes;
static host_object* objects;
static uint64_t next_id = 1;

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
    return host_new(class_name, strstr(class_name, "Resource") || !strcmp(class_name, "EditorNode3DGizmoPlugin"));
}

gdx_object host_classdb_construct_object2(const void* name) {
    return host_construct((*(host_name* const*)name)->text);
}
gdx_object host_object_get_instance_from_id(uint64_t id) {
    for (host_object* o = objects; o; o = o->next)
        if (o->id == id) return o;
    return NULL;
}
uint64_t host_object_get_instance_id(const void* object) {
    return ((const host_object*)object)->id;
}
void* host_object_get_instance_binding(void* object, void* token, const gdx_binding_callbacks* callbacks) {
    (void)token;
    (void)callbacks;
    return ((host_object*)object)->binding;
}
void host_object_set_instance_binding(void* object, void* token, void* binding,
                                      const gdx_binding_callbacks* callbacks) {
    (void)token;
    (void)callbacks;
    ((host_object*)object)->binding = binding;
}
void host_object_set_instance(void* object, const void* class_name, void* instance) {
    host_object* o = object;
    o->extension = host_find_class((*(host_name* const*)class_name)->text);
    assert(o->extension && strcmp(o->extension->parent, o->class_name) == 0);
    o->instance = instance;
}
void host_ref_set_object(void* ref, void* object) {
    *(void**)ref = object;
    ++((host_object*)object)->refs;
}
void host_classdb_register_extension_class4(void* library, const void* name, const void* parent,
                                            const gdx_class_info* info) {
    host_class* c = calloc(1, sizeof *c);
    (void)library;
    snprintf(c->name, sizeof c->name, "%s", (*(host_name* const*)name)->text);
    snprintf(c->parent, sizeof c->parent, "%s", (*(host_name* const*)parent)->text);
    c->info = *info;
    assert(info->create && info->release);
    c->next = classes;
    classes = c;
}
void host_classdb_register_extension_class_method(void* library, const void* class_name, const gdx_method_info* info) {
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
void host_classdb_register_extension_class_property(void* library, const void* class_name,
                                                    const gdx_property_info* info, const void* setter,
                                                    const void* getter) {
    host_class* c = host_find_class((*(host_name* const*)class_name)->text);
    int found = 0;
    (void)library;
    (void)info;
    for (host_method* m = c->methods; m; m = m->next)
        found +=
            !strcmp(m->name, (*(host_name* const*)setter)->text) + !strcmp(m->name, (*(host_name* const*)getter)->text);
    assert(found == 2); /* the engine refuses properties without methods */
    ++c->properties;
}
void host_classdb_register_extension_class_property_group(void* library, const void* class_name, const void* group,
                                                          const void* prefix) {
    (void)library, (void)class_name, (void)group, (void)prefix;
}
void host_classdb_register_extension_class_signal(void* library, const void* class_name, const void* name,
                                                  const gdx_property_info* args, int64_t count) {
    (void)library, (void)name, (void)args, (void)count;
    ++host_find_class((*(host_name* const*)class_name)->text)->signals;
}
void host_classdb_register_extension_class_integer_constant(void* library, const void* class_name,
                                                            const void* enumeration, const void* name, int64_t value,
                                                            uint8_t is_bitfield) {
    (void)library, (void)enumeration, (void)name, (void)value, (void)is_bitfield;
    ++host_find_class((*(host_name* const*)class_name)->text)->constants;
}
void host_classdb_unregister_extension_class(void* library, const void* name) {
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
void host_print_error_with_message(const char* description, const char* message, const char* function, const char* file,
                                   int32_t line, uint8_t notify) {
    (void)description, (void)function, (void)file, (void)line, (void)notify;
    ++host.errors;
    snprintf(host.last_error, sizeof host.last_error, "%s", message);
}
void host_print_warning_with_message(const char* description, const char* message, const char* function,
                                     const char* file, int32_t line, uint8_t notify) {
    (void)description, (void)message, (void)function, (void)file, (void)line, (void)notify;
    ++host.warnings;
}

void scene_call(host_variant* self, const char* method, const void* const* args, int64_t count, host_variant* ret,
                gdx_call_error* error);
host_object* scene_singleton(const char* name);

void host_variant_call(void* self, const void* method, const void* const* args, int64_t count, void* ret,
                       gdx_call_error* error) {
    host_variant* v = self;
    const char* name = (*(host_name* const*)method)->text;
    error->error = GDX_CALL_OK;
    host_variant_new_nil(ret);
    if (host_is_packed(v->type)) {
        const int64_t width = host_width_of(v->type);
        if (!strcmp(name, "size")) {
            *(host_variant*)ret = host_int(v->u.array ? v->u.array->count : 0);
        } else if (!strcmp(name, "resize")) {
            host_array_own(&v->u.array, width, ((const host_variant*)args[0])->u.integer);
        } else if (!strcmp(name, "append")) {
            host_array_own(&v->u.array, width, (v->u.array ? v->u.array->count : 0) + 1); /* counts only */
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
    for (int i = 0; i < count; ++i) host_variant_destroy(&args[i]);
    return ret;
}

void host_notify(host_object* object, int what) {
    object->extension->info.notification(object->instance, what, 0);
}

void host_virtual(host_object* object, const char* method, const void* const* args, void* ret) {
    host_name* name = host_name_new(method);
    gdx_virtual_call call = object->extension->info.get_virtual(object->extension->info.userdata, &name, 0);
    assert(call);
    call(object->instance, args, ret);
    host_name_free(&name);
}

gdx_object host_global_get_singleton(const void* name) {
    return scene_singleton((*(host_name* const*)name)->text);
}

gdx_object host_ref_get_object(const void* ref) {
    return *(host_object* const*)ref;
}
void host_editor_add_plugin(const void* name) {
    const host_class* c = host_find_class((*(host_name* const*)name)->text);
    assert(c && !strcmp(c->parent, "EditorPlugin") && !host.plugin);
    host.plugin = host_name_new(c->name);
}
void host_editor_remove_plugin(const void* name) {
    assert(host.plugin == *(host_name* const*)name);
    host_name_free(&host.plugin);
}

/* The only two method binds in use. */
static const char bind_notification, bind_file;
const void* host_classdb_get_method_bind(const void* class_name, const void* method, int64_t hash) {
    const char* name = (*(host_name* const*)method)->text;
    (void)class_name;
    if (!strcmp(name, "notification") && hash == 4023243586) return &bind_notification;
    if (!strcmp(name, "get_file_as_bytes") && hash == 659035735) return &bind_file;
    return NULL;
}
void host_object_method_bind_ptrcall(const void* bind, void* object, const void* const* args, void* ret) {
    (void)ret;
    assert(bind == &bind_notification && object && *(const int64_t*)args[0] == 0);
    ++host.postinitialize;
}
void host_object_method_bind_call(const void* bind, void* object, const void* const* args, int64_t count, void* ret,
                                  gdx_call_error* error) {
    assert(bind == &bind_file && !object && count == 1);
    host_variant bytes = host_value_of(GDX_PACKED_BYTE_ARRAY);
    FILE* file = fopen(((const host_variant*)args[0])->u.string->text, "rb");
    if (file) {
        fseek(file, 0, SEEK_END);
        const long size = ftell(file);
        rewind(file);
        host_array_own(&bytes.u.array, 1, size);
        if (fread(bytes.u.array->data, 1, (size_t)size, file) != (size_t)size) abort();
        fclose(file);
    }
    *(host_variant*)ret = bytes;
    error->error = GDX_CALL_OK;
}

/* Help goes into files, for a reader of XML. */
static void load_help(const char* xml) {
    char path[512];
    snprintf(path, sizeof path, "%s/help_%d.xml", getenv("LR_HOST_HELP") ? getenv("LR_HOST_HELP") : ".", ++host.help);
    FILE* file = fopen(path, "w");
    if (!file || fputs(xml, file) < 0 || fclose(file) != 0) ++host.errors;
}

gdx_function host_get(const char* name) {
    if (strcmp(name, "editor_help_load_xml_from_utf8_chars") == 0) return (gdx_function)load_help;
#define GIVE(function, engine_type, result, parameters)                                                                \
    if (strcmp(name, #function) == 0) {                                                                                \
        gdx_fn_##function f = host_##function;                                                                         \
        return (gdx_function)f;                                                                                        \
    }
    GDX_FUNCTIONS(GIVE)
#undef GIVE
    return NULL;
}
