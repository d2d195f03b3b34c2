/*
 * Entry points: the engine calls them when it loads and unloads the extension.
 *
 * SPDX-License-Identifier: MIT
 */
#include "help.h"
#include "nodes.h"

#include <stdio.h>
#include <string.h>

#if defined(_WIN32)
#define EXPORT __declspec(dllexport)
#else
#define EXPORT __attribute__((visibility("default")))
#endif

static const gd_class* const classes[] = {&asset_class, &asset_loader_class, &world_class, &batch_class};
#define CLASSES (sizeof classes / sizeof *classes)

static void initialize(void* userdata, gdx_level level) {
    (void)userdata;
    if (level == GDX_LEVEL_EDITOR) load_help();
    if (level != GDX_LEVEL_SCENE) return;
    gd_load_names();
    for (size_t i = 0; i < CLASSES; ++i) gd_register(classes[i]);
    asset_loader_start();
}

static void deinitialize(void* userdata, gdx_level level) {
    (void)userdata;
    if (level != GDX_LEVEL_SCENE) return;
    asset_loader_stop();
    for (size_t i = CLASSES; i > 0; --i) gd_unregister(classes[i - 1]);
    for (int i = 0; i < GD_NAME_COUNT; ++i) gd.destroy[GDX_STRING_NAME](&gd.names[i]);
}

EXPORT uint8_t langevin_rigid_init(gdx_get_proc_address get, gdx_library library, gdx_initialization* out);

EXPORT uint8_t langevin_rigid_init(gdx_get_proc_address get, gdx_library library, gdx_initialization* out) {
    const uint32_t version = lr_version();
    if (version >> 22 != LR_VERSION_MAJOR || (LR_VERSION_MAJOR == 0 && (version >> 12 & 1023u) != LR_VERSION_MINOR)) {
        fprintf(stderr, "langevin_rigid: the library beside the extension is %u.%u, but the extension needs %u.%u\n",
                (unsigned)(version >> 22), (unsigned)(version >> 12 & 1023u), (unsigned)LR_VERSION_MAJOR,
                (unsigned)LR_VERSION_MINOR);
        return 0;
    }
    if (!gd_load(get, library)) return 0;
    memset(out, 0, sizeof *out);
    out->minimum_level = GDX_LEVEL_SCENE;
    out->initialize = initialize;
    out->deinitialize = deinitialize;
    return 1;
}
