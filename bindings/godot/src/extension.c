/*
 * Entry points: the engine calls them when it loads and unloads the extension.
 *
 * SPDX-License-Identifier: MIT
 */
#include "help.h"
#include "nodes.h"

#include <string.h>

#if defined(_WIN32)
#define EXPORT __declspec(dllexport)
#else
#define EXPORT __attribute__((visibility("default")))
#endif

static const gd_class* const classes[] = {&asset_class, &asset_loader_class, &world_class, &batch_class};
static const gd_class* const editor_classes[] = {&gizmo_class, &plugin_class};
#define COUNT(array) (sizeof array / sizeof *array)

/* The editor may load an extension long after its start, when it finds a new one: then it runs through all levels at once. */
static void initialize(void* userdata, gdx_level level) {
    (void)userdata;
    if (level == GDX_LEVEL_SCENE) {
        gd_load_names();
        for (size_t i = 0; i < COUNT(classes); ++i) gd_register(classes[i]);
        asset_loader_start();
    } else if (level == GDX_LEVEL_EDITOR) {
        load_help();
        for (size_t i = 0; i < COUNT(editor_classes); ++i) gd_register(editor_classes[i]);
        gd.editor_add_plugin(GD_NAME(LangevinEditorPlugin));
    }
}

/* A class that stays registered would crash the editor at its end, when it writes down the help of all classes. */
static void deinitialize(void* userdata, gdx_level level) {
    (void)userdata;
    if (level == GDX_LEVEL_EDITOR) {
        gd.editor_remove_plugin(GD_NAME(LangevinEditorPlugin));
        for (size_t i = COUNT(editor_classes); i > 0; --i) gd_unregister(editor_classes[i - 1]);
    }
    if (level != GDX_LEVEL_SCENE) return;
    asset_loader_stop();
    for (size_t i = COUNT(classes); i > 0; --i) gd_unregister(classes[i - 1]);
    for (int i = 0; i < GD_NAME_COUNT; ++i) gd.destroy[GDX_STRING_NAME](&gd.names[i]);
}

EXPORT uint8_t langevin_rigid_init(gdx_get_proc_address get, gdx_library library, gdx_initialization* out);

EXPORT uint8_t langevin_rigid_init(gdx_get_proc_address get, gdx_library library, gdx_initialization* out) {
    if (!gd_load(get, library)) return 0;
    memset(out, 0, sizeof *out);
    out->minimum_level = GDX_LEVEL_SCENE;
    out->initialize = initialize;
    out->deinitialize = deinitialize;
    return 1;
}
