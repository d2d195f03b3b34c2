/*
 * Names of the engine's methods, signals and classes, made once when the extension is loaded.
 *
 * SPDX-License-Identifier: MIT
 */
#ifndef LANGEVIN_GD_NAMES_H
#define LANGEVIN_GD_NAMES_H

#define GD_NAMES(X)                                                                                                    \
    X(add_resource_format_loader)                                                                                      \
    X(append)                                                                                                          \
    X(connect)                                                                                                         \
    X(disconnect)                                                                                                      \
    X(emit_signal)                                                                                                     \
    X(find_children)                                                                                                   \
    X(flush)                                                                                                           \
    X(free_rid)                                                                                                        \
    X(get_aabb)                                                                                                        \
    X(get_bounce)                                                                                                      \
    X(get_collision_layer)                                                                                             \
    X(get_faces)                                                                                                       \
    X(get_friction)                                                                                                    \
    X(get_global_transform)                                                                                            \
    X(get_height)                                                                                                      \
    X(get_map_data)                                                                                                    \
    X(get_map_depth)                                                                                                   \
    X(get_map_width)                                                                                                   \
    X(get_node_or_null)                                                                                                \
    X(get_parent)                                                                                                      \
    X(get_path)                                                                                                        \
    X(get_physics_material_override)                                                                                   \
    X(get_physics_process_delta_time)                                                                                  \
    X(get_plane)                                                                                                       \
    X(get_points)                                                                                                      \
    X(get_process_delta_time)                                                                                          \
    X(get_radius)                                                                                                      \
    X(get_rid)                                                                                                         \
    X(get_scenario)                                                                                                    \
    X(get_shape_owners)                                                                                                \
    X(get_size)                                                                                                        \
    X(get_tree)                                                                                                        \
    X(get_viewport)                                                                                                    \
    X(get_wind_attenuation_factor)                                                                                     \
    X(get_wind_force_magnitude)                                                                                        \
    X(get_wind_source_path)                                                                                            \
    X(get_world_3d)                                                                                                    \
    X(instance_create2)                                                                                                \
    X(instance_geometry_set_cast_shadows_setting)                                                                      \
    X(instance_geometry_set_material_override)                                                                         \
    X(instance_set_layer_mask)                                                                                         \
    X(instance_set_visible)                                                                                            \
    X(is_class)                                                                                                        \
    X(is_connected)                                                                                                    \
    X(is_editor_hint)                                                                                                  \
    X(is_shape_owner_disabled)                                                                                         \
    X(is_visible_in_tree)                                                                                              \
    X(multimesh_allocate_data)                                                                                         \
    X(multimesh_create)                                                                                                \
    X(multimesh_set_buffer)                                                                                            \
    X(multimesh_set_custom_aabb)                                                                                       \
    X(multimesh_set_mesh)                                                                                              \
    X(multimesh_set_physics_interpolated)                                                                              \
    X(multimesh_set_visible_instances)                                                                                 \
    X(node_added)                                                                                                      \
    X(node_removed)                                                                                                    \
    X(remove_resource_format_loader)                                                                                   \
    X(resize)                                                                                                          \
    X(set_notify_transform)                                                                                            \
    X(set_physics_process_internal)                                                                                    \
    X(set_process_internal)                                                                                            \
    X(shape_owner_get_shape)                                                                                           \
    X(shape_owner_get_shape_count)                                                                                     \
    X(shape_owner_get_transform)                                                                                       \
    X(size)                                                                                                            \
    X(store_buffer)                                                                                                    \
    X(update_configuration_warnings)                                                                                   \
    X(_tree_changed)                                                                                                   \
    X(ended)                                                                                                           \
    X(respawned)                                                                                                       \
    X(spawned)                                                                                                         \
    X(diverged)                                                                                                        \
    X(landed)                                                                                                          \
    X(touched)                                                                                                         \
    X(woke)                                                                                                            \
    X(_get_configuration_warnings)                                                                                     \
    X(_get_recognized_extensions)                                                                                      \
    X(_get_resource_type)                                                                                              \
    X(_handles_type)                                                                                                   \
    X(_load)                                                                                                           \
    X(LangevinAsset)                                                                                                   \
    X(add_collision_segments)                                                                                          \
    X(add_lines)                                                                                                       \
    X(add_node_3d_gizmo_plugin)                                                                                        \
    X(clear)                                                                                                           \
    X(create_material)                                                                                                 \
    X(get_material)                                                                                                    \
    X(get_node_3d)                                                                                                     \
    X(remove_node_3d_gizmo_plugin)                                                                                     \
    X(update_gizmos)                                                                                                   \
    X(_edit)                                                                                                           \
    X(_get_gizmo_name)                                                                                                 \
    X(_handles)                                                                                                        \
    X(_has_gizmo)                                                                                                      \
    X(_redraw)                                                                                                         \
    X(LangevinEditorPlugin)

#define GD_NAME_ID(name) GD_N_##name,
enum { GD_NAMES(GD_NAME_ID) GD_NAME_COUNT };
#undef GD_NAME_ID

#endif
