/*
 * SPDX-License-Identifier: MIT
 */
#include "gd_class.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Object::notification(int, bool). Called by pointer: a Variant of an object under construction would count as its first
 * reference. All versions of Godot 4 have had this hash. */
#define NOTIFICATION_HASH 4023243586
#define NOTIFICATION_POSTINITIALIZE 0

/* A registered method: userdata of the engine's method. Setters and getters of fields have a property. */
typedef struct bound {
    const gd_method* method;
    const gd_property* property;
    int is_setter;
    gd_method own; /* of setters and getters */
    char name[64];
    struct bound* next;
} bound;

static bound* all_bound; /* of all classes; freed with the last class */
static int registered;

static void name_of(uint64_t* name, const char* text) {
    gd.string_name_new_with_latin1_chars(name, text ? text : "", 0);
}

static void free_name(uint64_t* name) {
    gd.destroy[GDX_STRING_NAME](name);
}

/* ------------------------------------------------------------------------------------------------------------------ */
/* Fields                                                                                                             */

static void get_field(const gd_instance* instance, const gd_property* p, gd_var* ret) {
    const char* field = (const char*)instance + p->offset;
    switch (p->type) {
    case GDX_BOOL:
        *ret = gd_bool(*(const int64_t*)field != 0);
        break;
    case GDX_INT:
        *ret = gd_int(*(const int64_t*)field);
        break;
    case GDX_FLOAT:
        *ret = gd_float(*(const double*)field);
        break;
    case GDX_VECTOR3:
        *ret = gd_vector3((const float*)field);
        break;
    case GDX_AABB:
        *ret = gd_aabb((const float*)field);
        break;
    case GDX_TRANSFORM3D:
        *ret = gd_transform((const float*)field);
        break;
    default:
        *ret = gd_copy((const gd_var*)field);
        break;
    }
}

static int in_range(const gd_property* p, double value) {
    if (p->minimum == 0.0 && p->maximum == 0.0) return isfinite(value);
    return value >= p->minimum && value <= p->maximum;
}

static void set_field(gd_instance* instance, const gd_property* p, const gd_var* value) {
    char* field = (char*)instance + p->offset;
    const char* class_name = instance->type->name;
    if (p->type == GDX_OBJECT) {
        gdx_object object = gd_to_object(value);
        if (object && !gd_is_class(object, p->hint_string)) {
            gd_error("%s.%s must be a %s", class_name, p->name, p->hint_string);
            return;
        }
        gd_free((gd_var*)field);
        if (object) *(gd_var*)field = gd_copy(value);
    } else if (p->type == GDX_BOOL) {
        *(int64_t*)field = gd_to_bool(value);
    } else if (p->type == GDX_INT) {
        const int64_t number = gd_to_int(value);
        if ((p->minimum != 0.0 || p->maximum != 0.0) && !in_range(p, (double)number)) {
            gd_error("%s.%s is %lld, must be from %g to %g", class_name, p->name, (long long)number, p->minimum,
                     p->maximum);
            return;
        }
        *(int64_t*)field = number;
    } else if (p->type == GDX_FLOAT) {
        const double number = gd_to_float(value);
        if (!in_range(p, number)) {
            gd_error("%s.%s is %g, must be from %g to %g", class_name, p->name, number, p->minimum, p->maximum);
            return;
        }
        *(double*)field = number;
    } else {
        const int count = p->type == GDX_VECTOR3 ? 3 : p->type == GDX_AABB ? 6 : 12;
        float numbers[12];
        gd_to_floats(value, p->type, numbers);
        for (int i = 0; i < count; ++i)
            if (!in_range(p, numbers[i])) {
                gd_error("%s.%s: component %d is %g, out of range", class_name, p->name, i, (double)numbers[i]);
                return;
            }
        memcpy(field, numbers, (size_t)count * sizeof(float));
    }
    if (p->changed) p->changed(instance);
}

/* ------------------------------------------------------------------------------------------------------------------ */
/* Calls                                                                                                              */

static void run(const bound* b, void* instance, const gd_var* args, gd_var* ret) {
    if (b->method->run)
        b->method->run(instance, args, ret);
    else if (b->is_setter)
        set_field(instance, b->property, &args[0]);
    else
        get_field(instance, b->property, ret);
}

static void on_call(void* userdata, void* instance, const void* const* args, int64_t count, void* ret,
                    gdx_call_error* error) {
    const bound* b = userdata;
    const gd_method* method = b->method;
    if (count != (int64_t)method->arg_count) {
        error->error = count < (int64_t)method->arg_count ? GDX_CALL_TOO_FEW_ARGUMENTS : GDX_CALL_TOO_MANY_ARGUMENTS;
        error->expected = (int32_t)method->arg_count;
        return;
    }
    gd_var values[GD_MAX_ARGS];
    for (uint32_t i = 0; i < method->arg_count; ++i) {
        const gdx_type want = method->args[i].type, have = gd.variant_get_type(args[i]);
        if (have != want && !gd.variant_can_convert_strict(have, want)) {
            error->error = GDX_CALL_INVALID_ARGUMENT;
            error->argument = (int32_t)i;
            error->expected = (int32_t)want;
            for (uint32_t k = 0; k < i; ++k) gd_free(&values[k]);
            return;
        }
        if (have == want || want == GDX_OBJECT) {
            values[i] = gd_copy(args[i]);
        } else {
            uint64_t storage[6] = {0}; /* the largest value, a Transform3D */
            gd.to_type[want](storage, (void*)args[i]);
            gd.from_type[want](&values[i], storage);
            if (gd.destroy[want]) gd.destroy[want](storage);
        }
    }
    gd_var result = gd_nil();
    run(b, instance, values, &result);
    for (uint32_t i = 0; i < method->arg_count; ++i) gd_free(&values[i]);
    if (ret) {
        gd.variant_destroy(ret);
        *(gd_var*)ret = result;
    } else {
        gd_free(&result);
    }
    error->error = GDX_CALL_OK;
}

static int is_counted(gdx_object object) {
    return gd_is_class(object, "RefCounted");
}

static void on_pointer_call(void* userdata, void* instance, const void* const* args, void* ret) {
    const bound* b = userdata;
    const gd_method* method = b->method;
    gd_var values[GD_MAX_ARGS];
    for (uint32_t i = 0; i < method->arg_count; ++i) {
        if (method->args[i].type == GDX_OBJECT)
            values[i] = gd_object(args[i] ? *(gdx_object const*)args[i] : NULL);
        else
            gd.from_type[method->args[i].type](&values[i], (void*)args[i]);
    }
    gd_var result = gd_nil();
    run(b, instance, values, &result);
    for (uint32_t i = 0; i < method->arg_count; ++i) gd_free(&values[i]);
    const gdx_type type = method->ret.type;
    if (ret && type == GDX_OBJECT) {
        gdx_object object = gd_to_object(&result);
        if (object && is_counted(object))
            gd.ref_set_object(ret, object);
        else
            *(gdx_object*)ret = object;
    } else if (ret && type != GDX_NIL) {
        if (gd_type(&result) != type) {
            gd_free(&result);
            result = gd_empty(type);
        }
        if (gd.destroy[type]) gd.destroy[type](ret);
        gd.to_type[type](ret, &result);
    }
    gd_free(&result);
}

/* ------------------------------------------------------------------------------------------------------------------ */
/* Registration                                                                                                       */

typedef struct info_text {
    uint64_t name, class_name, hint;
} info_text;

static gdx_property_info info_of(const gd_arg* arg, uint32_t hint, const char* hint_string, uint32_t usage,
                                 info_text* text) {
    name_of(&text->name, arg->name);
    name_of(&text->class_name, arg->class_name);
    gd.string_new_with_utf8_chars(&text->hint, hint_string ? hint_string : "");
    const gdx_property_info info = {arg->type, &text->name, &text->class_name, hint, &text->hint, usage};
    return info;
}

static void free_text(info_text* text) {
    free_name(&text->name);
    free_name(&text->class_name);
    gd.destroy[GDX_STRING](&text->hint);
}

static void register_method(const uint64_t* class_name, bound* b) {
    const gd_method* method = b->method;
    info_text texts[GD_MAX_ARGS], return_text;
    gdx_property_info args[GD_MAX_ARGS];
    uint32_t metadata[GD_MAX_ARGS] = {0};
    for (uint32_t i = 0; i < method->arg_count; ++i)
        args[i] = info_of(&method->args[i], 0, NULL, GD_USAGE_DEFAULT, &texts[i]);
    gdx_property_info result = info_of(&method->ret, 0, NULL, GD_USAGE_DEFAULT, &return_text);
    uint64_t name;
    name_of(&name, method->name);
    gdx_method_info info;
    memset(&info, 0, sizeof info);
    info.name = &name;
    info.userdata = b;
    info.call = on_call;
    info.ptrcall = on_pointer_call;
    info.flags = method->flags ? method->flags : GDX_METHOD_NORMAL;
    info.has_return = method->ret.type != GDX_NIL;
    info.return_info = &result;
    info.argument_count = method->arg_count;
    info.arguments = args;
    info.argument_metadata = metadata;
    gd.classdb_register_extension_class_method(gd.library, class_name, &info);
    for (uint32_t i = 0; i < method->arg_count; ++i) free_text(&texts[i]);
    free_text(&return_text);
    free_name(&name);
}

static bound* new_bound(void) {
    bound* b = calloc(1, sizeof *b);
    if (!b) abort(); /* a few hundred bytes at start-up: the engine itself aborts there */
    b->next = all_bound;
    all_bound = b;
    return b;
}

static void register_property(const uint64_t* class_name, const gd_property* p) {
    uint64_t names[2];
    for (int setter = 0; setter < 2; ++setter) {
        bound* b = new_bound();
        b->property = p;
        b->is_setter = setter;
        snprintf(b->name, sizeof b->name, "%s_%s", setter ? "set" : p->type == GDX_BOOL ? "is" : "get", p->name);
        b->own.name = b->name;
        b->own.run = setter ? p->set : p->get;
        b->own.flags = setter ? GDX_METHOD_NORMAL : GDX_METHOD_NORMAL | GDX_METHOD_CONST;
        const gd_arg value = {setter ? "value" : "", p->type, p->type == GDX_OBJECT ? p->hint_string : NULL};
        if (setter) {
            b->own.arg_count = 1;
            b->own.args[0] = value;
        } else {
            b->own.ret = value;
        }
        b->method = &b->own;
        register_method(class_name, b);
        name_of(&names[setter], b->name);
    }
    info_text text;
    const gd_arg arg = {p->name, p->type, p->type == GDX_OBJECT ? p->hint_string : NULL};
    const gdx_property_info info =
        info_of(&arg, p->hint, p->hint_string, p->usage ? p->usage : GD_USAGE_DEFAULT, &text);
    gd.classdb_register_extension_class_property(gd.library, class_name, &info, &names[1], &names[0]);
    free_text(&text);
    free_name(&names[0]);
    free_name(&names[1]);
}

static gdx_object create(void* userdata, uint8_t notify) {
    const gd_class* type = userdata;
    gd_instance* instance = calloc(1, type->size);
    if (!instance) return NULL;
    uint64_t parent, name;
    name_of(&parent, type->parent);
    name_of(&name, type->name);
    gdx_object object = gd.classdb_construct_object2(&parent);
    if (object) {
        instance->type = type;
        instance->object = object;
        instance->id = gd.object_get_instance_id(object);
        if (type->construct) type->construct(instance);
        static const gdx_binding_callbacks none = {NULL, NULL, NULL};
        gd.object_set_instance(object, &name, instance);
        gd.object_set_instance_binding(object, gd.library, instance, &none);
        if (notify) {
            uint64_t base, method;
            name_of(&base, "Object");
            name_of(&method, "notification");
            const void* bind = gd.classdb_get_method_bind(&base, &method, NOTIFICATION_HASH);
            const int64_t what = NOTIFICATION_POSTINITIALIZE;
            const uint8_t reversed = 0;
            const void* args[2] = {&what, &reversed};
            if (bind) gd.object_method_bind_ptrcall(bind, object, args, NULL);
            free_name(&base);
            free_name(&method);
        }
    } else {
        free(instance);
    }
    free_name(&parent);
    free_name(&name);
    return object;
}

static void release(void* userdata, void* instance) {
    const gd_class* type = userdata;
    if (!instance) return;
    if (type->destruct) type->destruct(instance);
    free(instance);
}

static void on_notification(void* instance, int32_t what, uint8_t reversed) {
    const gd_class* type = ((gd_instance*)instance)->type;
    (void)reversed;
    if (type->notification) type->notification(instance, what);
}

static gdx_virtual_call get_virtual(void* userdata, const void* name, uint32_t hash) {
    const gd_class* type = userdata;
    (void)hash;
    for (const gd_virtual* v = type->virtuals; v && v->call; ++v)
        if (gd_name_is(name, v->name)) return v->call;
    return NULL;
}

void gd_register(const gd_class* type) {
    uint64_t name, parent;
    name_of(&name, type->name);
    name_of(&parent, type->parent);
    gdx_class_info info;
    memset(&info, 0, sizeof info);
    info.is_exposed = (uint8_t)!type->internal;
    info.notification = on_notification;
    info.create = create;
    info.release = release;
    info.get_virtual = get_virtual;
    info.userdata = (void*)type;
    gd.classdb_register_extension_class4(gd.library, &name, &parent, &info);
    ++registered;
    for (const gd_constant* c = type->constants; c && c->name; ++c) {
        uint64_t enumeration, constant;
        name_of(&enumeration, c->enumeration);
        name_of(&constant, c->name);
        gd.classdb_register_extension_class_integer_constant(gd.library, &name, &enumeration, &constant, c->value, 0);
        free_name(&enumeration);
        free_name(&constant);
    }
    for (const gd_method* m = type->methods; m && m->name; ++m) {
        bound* b = new_bound();
        b->method = m;
        register_method(&name, b);
    }
    for (const gd_property* p = type->properties; p && p->name; ++p) {
        if (p->type != GDX_NIL) {
            register_property(&name, p);
        } else {
            uint64_t title, prefix;
            gd.string_new_with_utf8_chars(&title, p->name);
            gd.string_new_with_utf8_chars(&prefix, "");
            gd.classdb_register_extension_class_property_group(gd.library, &name, &title, &prefix);
            gd.destroy[GDX_STRING](&title);
            gd.destroy[GDX_STRING](&prefix);
        }
    }
    for (const gd_signal* s = type->signals; s && s->name; ++s) {
        info_text texts[GD_MAX_ARGS];
        gdx_property_info args[GD_MAX_ARGS];
        for (uint32_t i = 0; i < s->arg_count; ++i)
            args[i] = info_of(&s->args[i], 0, NULL, GD_USAGE_DEFAULT, &texts[i]);
        uint64_t signal;
        name_of(&signal, s->name);
        gd.classdb_register_extension_class_signal(gd.library, &name, &signal, args, s->arg_count);
        for (uint32_t i = 0; i < s->arg_count; ++i) free_text(&texts[i]);
        free_name(&signal);
    }
    free_name(&name);
    free_name(&parent);
}

gdx_object gd_construct(const gd_class* type) {
    return create((void*)type, 1);
}

void gd_unregister(const gd_class* type) {
    uint64_t name;
    name_of(&name, type->name);
    gd.classdb_unregister_extension_class(gd.library, &name);
    free_name(&name);
    if (--registered > 0) return;
    while (all_bound) {
        bound* next = all_bound->next;
        free(all_bound);
        all_bound = next;
    }
}

void* gd_instance_of(gdx_object object, const gd_class* type) {
    static const gdx_binding_callbacks none = {NULL, NULL, NULL};
    if (!object || !gd_is_class(object, type->name)) return NULL;
    gd_instance* instance = gd.object_get_instance_binding(object, gd.library, &none);
    return instance && instance->type == type ? instance : NULL;
}
