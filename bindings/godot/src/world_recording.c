/*
 * Recordings: every call that changes the world goes into a file, for lr_replay. docs/reference/snapshots.md
 *
 * SPDX-License-Identifier: MIT
 */
#include "nodes.h"

#include <string.h>

/* Called inside the library's functions, by one thread at a time; with wind areas also by workers. */
static int32_t store(void* user, const void* bytes, uint64_t size) {
    world_node* self = user;
    gdx_object file = gd_to_object(&self->recording);
    gd_var array = gd_array(GDX_PACKED_BYTE_ARRAY, (int64_t)size), stored = gd_nil();
    char* data = gd_data(&array);
    if (!file || !data) {
        gd_free(&array);
        return 1;
    }
    memcpy(data, bytes, (size_t)size);
    const int called = gd_call(file, GD_N_store_buffer, &stored, 1, array); /* frees the array */
    const int refused = gd_type(&stored) == GDX_BOOL && !gd_to_bool(&stored);
    gd_free(&stored);
    if (!called || refused) return 1;
    gd_call(file, GD_N_flush, NULL, 0); /* after a crash the last call matters most */
    return 0;
}

int world_start_recording(world_node* self, const gd_var* file) {
    gdx_object object = gd_to_object(file);
    if (!self->world) return GD_ERR_UNCONFIGURED;
    if (!object || !gd_is_class(object, "FileAccess")) {
        gd_error("start_recording: not a FileAccess that is open for writing");
        return GD_ERR_INVALID_PARAMETER;
    }
    lr_recording_desc desc;
    lr_recording_desc_init(&desc, sizeof desc);
    desc.hash_interval = 10; /* hashing every step would be most of the cost of a recording */
    desc.write = store;
    desc.user = self;
    gd_var before = self->recording;
    self->recording = gd_copy(file);
    const lr_status status = lr_world_record_start(self->world, &desc);
    if (status == LR_OK) {
        gd_free(&before); /* a recording that has ended by itself */
        return GD_OK;
    }
    gd_free(&self->recording);
    self->recording = before;
    gd_error("start_recording: %s", lr_status_string(status));
    return gd_error_from_status(status);
}

int world_stop_recording(world_node* self) {
    if (!self->world) return GD_ERR_UNCONFIGURED;
    const lr_status status = lr_world_record_stop(self->world);
    gd_free(&self->recording);
    if (status != LR_OK) gd_error("stop_recording: %s", lr_status_string(status));
    return status == LR_OK ? GD_OK : gd_error_from_status(status);
}
