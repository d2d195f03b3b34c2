/*
 * SPDX-License-Identifier: MIT
 */
#include "gd_help.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Written twice: first without a buffer, to find the length. */
typedef struct page {
    const gd_class* type;
    const gd_help* help;
    char* xml;
    size_t length, room, used; /* used: texts */
} page;

static void add(page* p, const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    const int count =
        vsnprintf(p->xml ? p->xml + p->length : NULL, p->xml ? p->room - p->length : 0, format, arguments);
    va_end(arguments);
    if (count > 0) p->length += (size_t)count;
}

static void add_text(page* p, const char* name) {
    for (const gd_help* h = p->help; h->name; ++h) {
        if (strcmp(h->name, name) != 0) continue;
        ++p->used;
        add(p, "%s", h->text); /* texts have no character that XML would take for its own */
        return;
    }
    if (p->xml) gd_warning("%s.%s has no help", p->type->name, name);
}

static const char* name_of(gdx_type type, const char* class_name) {
    static const char* const names[GDX_TYPE_COUNT] = {
        [GDX_NIL] = "void",
        [GDX_BOOL] = "bool",
        [GDX_INT] = "int",
        [GDX_FLOAT] = "float",
        [GDX_STRING] = "String",
        [GDX_VECTOR3] = "Vector3",
        [GDX_AABB] = "AABB",
        [GDX_TRANSFORM3D] = "Transform3D",
        [GDX_RID] = "RID",
        [GDX_PACKED_BYTE_ARRAY] = "PackedByteArray",
        [GDX_PACKED_INT64_ARRAY] = "PackedInt64Array",
        [GDX_PACKED_FLOAT32_ARRAY] = "PackedFloat32Array",
        [GDX_PACKED_VECTOR3_ARRAY] = "PackedVector3Array",
    };
    return type == GDX_OBJECT && class_name       ? class_name
           : type < GDX_TYPE_COUNT && names[type] ? names[type]
                                                  : "Variant";
}

static void add_params(page* p, const gd_arg* args, uint32_t count) {
    for (uint32_t i = 0; i < count; ++i)
        add(p, "<param index=\"%u\" name=\"%s\" type=\"%s\" />", i, args[i].name,
            name_of(args[i].type, args[i].class_name));
}

static void write_page(page* p) {
    const gd_class* t = p->type;
    p->length = p->used = 0;
    add(p, "<?xml version=\"1.0\" encoding=\"UTF-8\" ?><class name=\"%s\" inherits=\"%s\"><brief_description>", t->name,
        t->parent);
    add_text(p, t->name);
    add(p, "</brief_description><description></description><tutorials></tutorials><methods>");
    for (const gd_method* m = t->methods; m && m->name; ++m) {
        if (m->name[0] == '_') continue;
        const char* how = m->flags & GDX_METHOD_CONST ? " qualifiers=\"const\"" : "";
        add(p, "<method name=\"%s\"%s><return type=\"%s\" />", m->name, how, name_of(m->ret.type, m->ret.class_name));
        add_params(p, m->args, m->arg_count);
        add(p, "<description>");
        add_text(p, m->name);
        add(p, "</description></method>");
    }
    add(p, "</methods><members>");
    for (const gd_property* m = t->properties; m && m->name; ++m) {
        if (m->type == GDX_NIL || m->usage == GD_USAGE_STORAGE) continue;
        add(p, "<member name=\"%s\" type=\"%s\" setter=\"set_%s\" getter=\"%s_%s\">", m->name,
            name_of(m->type, m->hint_string), m->name, m->type == GDX_BOOL ? "is" : "get", m->name);
        add_text(p, m->name);
        add(p, "</member>");
    }
    add(p, "</members><signals>");
    for (const gd_signal* s = t->signals; s && s->name; ++s) {
        add(p, "<signal name=\"%s\">", s->name);
        add_params(p, s->args, s->arg_count);
        add(p, "<description>");
        add_text(p, s->name);
        add(p, "</description></signal>");
    }
    add(p, "</signals><constants>");
    for (const gd_constant* c = t->constants; c && c->name; ++c) {
        add(p, "<constant name=\"%s\" value=\"%lld\" enum=\"%s\">", c->name, (long long)c->value, c->enumeration);
        add_text(p, c->name);
        add(p, "</constant>");
    }
    add(p, "</constants></class>");
}

void gd_load_help(const gd_class* type, const gd_help* help) {
    if (!gd.load_help) return;
    page p = {.type = type, .help = help};
    write_page(&p);
    p.room = p.length + 1;
    p.xml = malloc(p.room);
    if (!p.xml) return;
    write_page(&p);
    size_t texts = 0;
    while (help[texts].name) ++texts;
    if (texts != p.used)
        gd_warning("%s: %u texts of help for %u members", type->name, (unsigned)texts, (unsigned)p.used);
    gd.load_help(p.xml);
    free(p.xml);
}
