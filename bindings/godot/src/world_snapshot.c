/*
 * Snapshots of a world: the links of its colliders and winds to the scene, then the library's snapshot. In the next step,
 * shapes that no longer exist lose their colliders and new shapes get theirs; in another process that is all of them.
 *
 * SPDX-License-Identifier: MIT
 */
#include "nodes.h"

#include <stdlib.h>
#include <string.h>

typedef struct header {
    char magic[8];
    uint64_t links;
    lr_wind_source gusts, turbulence;
} header;

static const char magic[8] = {'L', 'R', 'G', 'o', 'd', 'o', 't', '1'};

gd_var world_save(const world_node* self) {
    const uint64_t size = lr_world_snapshot_size(self->world);
    if (size == 0) return gd_empty(GDX_PACKED_BYTE_ARRAY);
    header head = {{0}, self->colliders.count, self->gusts, self->turbulence};
    memcpy(head.magic, magic, sizeof magic);
    const size_t links = self->colliders.count * sizeof(shape_link);
    gd_var bytes = gd_array(GDX_PACKED_BYTE_ARRAY, (int64_t)(sizeof head + links + size));
    char* data = gd_data(&bytes);
    if (!data) return bytes;
    memcpy(data, &head, sizeof head);
    if (links) memcpy(data + sizeof head, self->colliders.links, links);
    if (lr_world_snapshot_save(self->world, data + sizeof head + links, size, NULL) != LR_OK)
        gd_array_resize(&bytes, 0);
    return bytes;
}

lr_status world_restore(world_node* self, const gd_var* bytes) {
    header head;
    const uint64_t size = (uint64_t)gd_array_count(bytes);
    const char* data = gd_read(bytes);
    if (!self->world || !data || size < sizeof head) return LR_ERROR_SNAPSHOT_FORMAT;
    memcpy(&head, data, sizeof head);
    if (memcmp(head.magic, magic, sizeof magic) != 0 || head.links > (size - sizeof head) / sizeof(shape_link))
        return LR_ERROR_SNAPSHOT_FORMAT;
    const size_t links = (size_t)head.links * sizeof(shape_link);
    shape_link* copy = malloc(links ? links : 1);
    if (!copy) return LR_ERROR_OUT_OF_MEMORY;
    memcpy(copy, data + sizeof head, links);
    for (uint32_t i = 0; i < self->batch_count; ++i) batch_ensure(self->batches[i]);
    const lr_status status =
        lr_world_snapshot_restore(self->world, data + sizeof head + links, size - sizeof head - links);
    if (status != LR_OK) {
        free(copy);
        return status;
    }
    free(self->colliders.links);
    for (uint64_t i = 0; i < head.links; ++i) copy[i].seen = 0; /* no scan of this world has found it */
    self->colliders.links = copy;
    self->colliders.count = self->colliders.capacity = (uint32_t)head.links;
    self->gusts = head.gusts;
    self->turbulence = head.turbulence;
    self->tree_changed = 1;
    for (uint32_t i = 0; i < self->batch_count; ++i) batch_draw(self->batches[i]);
    return LR_OK;
}
