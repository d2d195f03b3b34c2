/*
 * LangevinAsset: a resource with a shape baked by lr_bake.
 *
 * SPDX-License-Identifier: MIT
 */
#include "nodes.h"

#include <stdlib.h>
#include <string.h>

/* FileAccess.get_file_as_bytes(String) -> PackedByteArray. It is static, so there is no object to call it on by name. */
#define GET_FILE_AS_BYTES_HASH 659035735

static void report_fault(void* user, uint32_t number, const char* where, const char* what, const char* remedy) {
    gd_error("%s: fault %u at %s: %s; %s", (const char*)user, (unsigned)number, where, what, remedy);
}

static void drop(asset_node* self) {
    lr_asset_release(self->asset);
    self->asset = NULL;
    memset(&self->info, 0, sizeof self->info);
    gd_free(&self->bytes);
}

static void take(asset_node* self, lr_asset* asset) {
    self->asset = asset;
    lr_asset_info_init(&self->info, sizeof self->info);
    lr_asset_get_info(asset, &self->info);
}

/* bytes: a PackedByteArray. If it is refused, the old asset stays. */
static int load_bytes(asset_node* self, const gd_var* bytes, const char* name) {
    lr_asset* asset = NULL;
    const int64_t count = gd_array_count(bytes);
    const void* data = gd_read(bytes);
    if (!data) {
        gd_error("%s: no data", name);
        return GD_ERR_FILE_UNRECOGNIZED;
    }
    const lr_status status = lr_asset_load_memory(data, (uint64_t)count, &asset);
    if (status != LR_OK) {
        gd_error("%s: %s", name, lr_status_string(status));
        lr_asset_check_memory(data, (uint64_t)count, report_fault, (void*)name);
        return gd_error_from_status(status);
    }
    drop(self);
    take(self, asset);
    self->bytes = gd_copy(bytes);
    return GD_OK;
}

static gd_var file_as_bytes(const gd_var* path) {
    uint64_t class_name, method;
    gd.string_name_new_with_latin1_chars(&class_name, "FileAccess", 0);
    gd.string_name_new_with_latin1_chars(&method, "get_file_as_bytes", 0);
    const void* bind = gd.classdb_get_method_bind(&class_name, &method, GET_FILE_AS_BYTES_HASH);
    gd.destroy[GDX_STRING_NAME](&class_name);
    gd.destroy[GDX_STRING_NAME](&method);
    gd_var bytes = gd_nil();
    gdx_call_error error = {0};
    const void* args[1] = {path};
    if (bind) gd.object_method_bind_call(bind, NULL, args, 1, &bytes, &error);
    if (!bind || error.error != GDX_CALL_OK || gd_type(&bytes) != GDX_PACKED_BYTE_ARRAY) {
        gd_free(&bytes);
        bytes = gd_empty(GDX_PACKED_BYTE_ARRAY);
    }
    return bytes;
}

static int load_file(asset_node* self, const gd_var* path) {
    char* text = gd_to_utf8(path);
    gd_var bytes = file_as_bytes(path);
    int error;
    if (gd_array_count(&bytes) == 0) {
        gd_error("%s: no such file, or it is empty", text ? text : "");
        error = GD_ERR_FILE_NOT_FOUND;
    } else {
        error = load_bytes(self, &bytes, text ? text : "asset");
    }
    gd_free(&bytes);
    free(text);
    return error;
}

/* ------------------------------------------------------------------------------------------------------------------ */
/* Class                                                                                                              */

static void destruct(void* instance) {
    drop(instance);
}

static void m_load_file(void* self, const gd_var* args, gd_var* ret) {
    *ret = gd_int(load_file(self, &args[0]));
}

static void m_load_bytes(void* self, const gd_var* args, gd_var* ret) {
    *ret = gd_int(load_bytes(self, &args[0], "LangevinAsset.load_bytes"));
}

static void m_make_ellipsoid(void* instance, const gd_var* args, gd_var* ret) {
    asset_node* self = instance;
    lr_ellipsoid_desc desc;
    lr_asset* asset = NULL;
    float axes[3];
    lr_ellipsoid_desc_init(&desc, sizeof desc);
    gd_to_floats(&args[0], GDX_VECTOR3, axes);
    for (int i = 0; i < 3; ++i) desc.semi_axes[i] = (double)axes[i];
    desc.density = gd_to_float(&args[1]);
    const lr_status status = lr_asset_create_ellipsoid(&desc, &asset);
    if (status != LR_OK) {
        gd_error("semi-axes %g, %g, %g m, density %g kg/m^3: %s", (double)axes[0], (double)axes[1], (double)axes[2],
                 desc.density, lr_status_string(status));
    } else {
        drop(self);
        take(self, asset);
    }
    *ret = gd_int(gd_error_from_status(status));
}

static void m_is_valid(void* self, const gd_var* args, gd_var* ret) {
    (void)args;
    *ret = gd_bool(((asset_node*)self)->asset != NULL);
}

static void m_mesh_name(void* self, const gd_var* args, gd_var* ret) {
    (void)args;
    *ret = gd_string(((asset_node*)self)->info.name);
}

static void m_content_hash(void* self, const gd_var* args, gd_var* ret) {
    (void)args;
    *ret = gd_int((int64_t)((asset_node*)self)->info.content_hash);
}

static void m_center_of_mass(void* self, const gd_var* args, gd_var* ret) {
    const double* c = ((asset_node*)self)->info.center_of_mass;
    const float center[3] = {(float)c[0], (float)c[1], (float)c[2]};
    (void)args;
    *ret = gd_vector3(center);
}

#define NUMBER(field)                                                                                                  \
    static void m_##field(void* self, const gd_var* args, gd_var* ret) {                                               \
        (void)args;                                                                                                    \
        *ret = gd_float(((asset_node*)self)->info.field);                                                              \
    }
NUMBER(mass)
NUMBER(volume)
NUMBER(density)
NUMBER(length_d)
NUMBER(u0)

static void get_data(void* self, const gd_var* args, gd_var* ret) {
    const asset_node* asset = self;
    (void)args;
    *ret = gd_type(&asset->bytes) == GDX_NIL ? gd_empty(GDX_PACKED_BYTE_ARRAY) : gd_copy(&asset->bytes);
}

static void set_data(void* self, const gd_var* args, gd_var* ret) {
    (void)ret;
    if (gd_array_count(&args[0]) == 0)
        drop(self);
    else
        load_bytes(self, &args[0], "LangevinAsset.data");
}

static const gd_property properties[] = {
    {.name = "data", .type = GDX_PACKED_BYTE_ARRAY, .get = get_data, .set = set_data, .usage = GD_USAGE_STORAGE},
    {.name = NULL},
};

static const gd_method methods[] = {
    {"load_file", m_load_file, 0, {"", GDX_INT, NULL}, 1, {{"path", GDX_STRING, NULL}}},
    {"load_bytes", m_load_bytes, 0, {"", GDX_INT, NULL}, 1, {{"bytes", GDX_PACKED_BYTE_ARRAY, NULL}}},
    {"make_ellipsoid",
     m_make_ellipsoid,
     0,
     {"", GDX_INT, NULL},
     2,
     {{"semi_axes", GDX_VECTOR3, NULL}, {"density", GDX_FLOAT, NULL}}},
    {"is_valid", m_is_valid, 5, {"", GDX_BOOL, NULL}, 0, {{0}}},
    {"get_mesh_name", m_mesh_name, 5, {"", GDX_STRING, NULL}, 0, {{0}}},
    {"get_mass", m_mass, 5, {"", GDX_FLOAT, NULL}, 0, {{0}}},
    {"get_volume", m_volume, 5, {"", GDX_FLOAT, NULL}, 0, {{0}}},
    {"get_density", m_density, 5, {"", GDX_FLOAT, NULL}, 0, {{0}}},
    {"get_length", m_length_d, 5, {"", GDX_FLOAT, NULL}, 0, {{0}}},
    {"get_fall_speed_scale", m_u0, 5, {"", GDX_FLOAT, NULL}, 0, {{0}}},
    {"get_center_of_mass", m_center_of_mass, 5, {"", GDX_VECTOR3, NULL}, 0, {{0}}},
    {"get_content_hash", m_content_hash, 5, {"", GDX_INT, NULL}, 0, {{0}}},
    {.name = NULL},
};

const gd_class asset_class = {.name = "LangevinAsset",
                              .parent = "Resource",
                              .size = sizeof(asset_node),
                              .destruct = destruct,
                              .properties = properties,
                              .methods = methods};

/* ------------------------------------------------------------------------------------------------------------------ */
/* Loader                                                                                                             */

/* Writes a result of a virtual method, whose storage already holds a value. */
static void give(gdx_type type, gd_var* value, void* ret) {
    if (gd.destroy[type]) gd.destroy[type](ret);
    gd.to_type[type](ret, value);
    gd_free(value);
}

static int ends_with_lrb(const void* string) {
    char* path = gd_string_to_utf8(string);
    const size_t length = path ? strlen(path) : 0;
    const int is = length > 4 && path[length - 4] == '.' && (path[length - 3] | 32) == 'l' &&
                   (path[length - 2] | 32) == 'r' && (path[length - 1] | 32) == 'b';
    free(path);
    return is;
}

static void v_extensions(void* instance, const void* const* args, void* ret) {
    gd_var list = gd_empty(GDX_PACKED_STRING_ARRAY);
    (void)instance;
    (void)args;
    gd_call_in_place(&list, GD_N_append, NULL, 1, gd_string("lrb"));
    give(GDX_PACKED_STRING_ARRAY, &list, ret);
}

static void v_handles_type(void* instance, const void* const* args, void* ret) {
    uint64_t resource;
    gd.string_name_new_with_latin1_chars(&resource, "Resource", 0);
    (void)instance;
    *(uint8_t*)ret = gd_name_is(args[0], GD_N_LangevinAsset) || *(const uint64_t*)args[0] == resource;
    gd.destroy[GDX_STRING_NAME](&resource);
}

static void v_resource_type(void* instance, const void* const* args, void* ret) {
    gd_var type = gd_string(ends_with_lrb(args[0]) ? "LangevinAsset" : "");
    (void)instance;
    give(GDX_STRING, &type, ret);
}

static void v_load(void* instance, const void* const* args, void* ret) {
    gd_var path;
    (void)instance;
    gd.from_type[GDX_STRING](&path, (void*)args[0]);
    gdx_object object = gd.classdb_construct_object2(GD_NAME(LangevinAsset));
    gd_var result = gd_object(object);
    asset_node* asset = gd_instance_of(object, &asset_class);
    const int error = asset ? load_file(asset, &path) : GD_FAILED;
    gd_free(&path);
    if (error != GD_OK) {
        gd_free(&result);
        result = gd_int(error);
    }
    gd.variant_destroy(ret);
    *(gd_var*)ret = result;
}

static const gd_virtual loader_virtuals[] = {{GD_N__get_recognized_extensions, v_extensions},
                                             {GD_N__handles_type, v_handles_type},
                                             {GD_N__get_resource_type, v_resource_type},
                                             {GD_N__load, v_load},
                                             {0, NULL}};

const gd_class asset_loader_class = {.name = "LangevinAssetLoader",
                                     .parent = "ResourceFormatLoader",
                                     .size = sizeof(gd_instance),
                                     .virtuals = loader_virtuals,
                                     .internal = 1};

static gd_var loader;

void asset_loader_start(void) {
    loader = gd_object(gd_construct(&asset_loader_class));
    gd_call(gd_singleton("ResourceLoader"), GD_N_add_resource_format_loader, NULL, 1, gd_copy(&loader));
}

void asset_loader_stop(void) {
    gd_call(gd_singleton("ResourceLoader"), GD_N_remove_resource_format_loader, NULL, 1, gd_copy(&loader));
    gd_free(&loader);
}

asset_node* batch_asset(const batch_node* self) {
    return gd_instance_of(gd_to_object(&self->asset), &asset_class);
}
