/*
 * Compiles only if this extension's declarations have the layout and types of an engine's dumped header. Function types are
 * compared after the engine's structs have replaced ours, so that a missing, additional, wider or misplaced parameter does
 * not compile.
 *
 * SPDX-License-Identifier: MIT
 */
#include <gdextension_interface.h>

#include "../../src/abi/gdextension_abi.h"

#define SAME(condition) _Static_assert(condition, #condition)
#define SIZE(ours, theirs) SAME(sizeof(ours) == sizeof(theirs))
#define FIELD(ours, theirs, field, their_field)                                                                        \
    SAME(offsetof(ours, field) == offsetof(theirs, their_field));                                                      \
    SAME(sizeof(((ours*)0)->field) == sizeof(((theirs*)0)->their_field))

SAME((int)GDX_STRING == (int)GDEXTENSION_VARIANT_TYPE_STRING);
SAME((int)GDX_VECTOR3 == (int)GDEXTENSION_VARIANT_TYPE_VECTOR3);
SAME((int)GDX_PLANE == (int)GDEXTENSION_VARIANT_TYPE_PLANE);
SAME((int)GDX_QUATERNION == (int)GDEXTENSION_VARIANT_TYPE_QUATERNION);
SAME((int)GDX_AABB == (int)GDEXTENSION_VARIANT_TYPE_AABB);
SAME((int)GDX_BASIS == (int)GDEXTENSION_VARIANT_TYPE_BASIS);
SAME((int)GDX_TRANSFORM3D == (int)GDEXTENSION_VARIANT_TYPE_TRANSFORM3D);
SAME((int)GDX_STRING_NAME == (int)GDEXTENSION_VARIANT_TYPE_STRING_NAME);
SAME((int)GDX_NODE_PATH == (int)GDEXTENSION_VARIANT_TYPE_NODE_PATH);
SAME((int)GDX_RID == (int)GDEXTENSION_VARIANT_TYPE_RID);
SAME((int)GDX_OBJECT == (int)GDEXTENSION_VARIANT_TYPE_OBJECT);
SAME((int)GDX_CALLABLE == (int)GDEXTENSION_VARIANT_TYPE_CALLABLE);
SAME((int)GDX_DICTIONARY == (int)GDEXTENSION_VARIANT_TYPE_DICTIONARY);
SAME((int)GDX_ARRAY == (int)GDEXTENSION_VARIANT_TYPE_ARRAY);
SAME((int)GDX_PACKED_BYTE_ARRAY == (int)GDEXTENSION_VARIANT_TYPE_PACKED_BYTE_ARRAY);
SAME((int)GDX_PACKED_INT32_ARRAY == (int)GDEXTENSION_VARIANT_TYPE_PACKED_INT32_ARRAY);
SAME((int)GDX_PACKED_INT64_ARRAY == (int)GDEXTENSION_VARIANT_TYPE_PACKED_INT64_ARRAY);
SAME((int)GDX_PACKED_FLOAT32_ARRAY == (int)GDEXTENSION_VARIANT_TYPE_PACKED_FLOAT32_ARRAY);
SAME((int)GDX_PACKED_STRING_ARRAY == (int)GDEXTENSION_VARIANT_TYPE_PACKED_STRING_ARRAY);
SAME((int)GDX_PACKED_VECTOR3_ARRAY == (int)GDEXTENSION_VARIANT_TYPE_PACKED_VECTOR3_ARRAY);
SAME((int)GDX_TYPE_COUNT == (int)GDEXTENSION_VARIANT_TYPE_VARIANT_MAX);
SAME((int)GDX_LEVEL_SCENE == (int)GDEXTENSION_INITIALIZATION_SCENE);
SAME((int)GDX_LEVEL_EDITOR == (int)GDEXTENSION_INITIALIZATION_EDITOR);
SAME((int)GDX_METHOD_NORMAL == (int)GDEXTENSION_METHOD_FLAG_NORMAL);
SAME((int)GDX_METHOD_CONST == (int)GDEXTENSION_METHOD_FLAG_CONST);
SAME((int)GDX_METHOD_STATIC == (int)GDEXTENSION_METHOD_FLAG_STATIC);
SAME((int)GDX_CALL_INVALID_METHOD == (int)GDEXTENSION_CALL_ERROR_INVALID_METHOD);
SAME((int)GDX_CALL_INVALID_ARGUMENT == (int)GDEXTENSION_CALL_ERROR_INVALID_ARGUMENT);
SAME((int)GDX_CALL_TOO_MANY_ARGUMENTS == (int)GDEXTENSION_CALL_ERROR_TOO_MANY_ARGUMENTS);
SAME((int)GDX_CALL_TOO_FEW_ARGUMENTS == (int)GDEXTENSION_CALL_ERROR_TOO_FEW_ARGUMENTS);
SAME((int)GDX_CALL_INSTANCE_IS_NULL == (int)GDEXTENSION_CALL_ERROR_INSTANCE_IS_NULL);

SIZE(gdx_type, GDExtensionVariantType);
SIZE(gdx_level, GDExtensionInitializationLevel);

SIZE(gdx_call_error, GDExtensionCallError);
FIELD(gdx_call_error, GDExtensionCallError, argument, argument);
FIELD(gdx_call_error, GDExtensionCallError, expected, expected);

SIZE(gdx_property_info, GDExtensionPropertyInfo);
FIELD(gdx_property_info, GDExtensionPropertyInfo, name, name);
FIELD(gdx_property_info, GDExtensionPropertyInfo, class_name, class_name);
FIELD(gdx_property_info, GDExtensionPropertyInfo, hint, hint);
FIELD(gdx_property_info, GDExtensionPropertyInfo, hint_string, hint_string);
FIELD(gdx_property_info, GDExtensionPropertyInfo, usage, usage);

SIZE(gdx_binding_callbacks, GDExtensionInstanceBindingCallbacks);
FIELD(gdx_binding_callbacks, GDExtensionInstanceBindingCallbacks, release, free_callback);
FIELD(gdx_binding_callbacks, GDExtensionInstanceBindingCallbacks, reference, reference_callback);

#define CLASS(field, their_field) FIELD(gdx_class_info, GDExtensionClassCreationInfo4, field, their_field)
SIZE(gdx_class_info, GDExtensionClassCreationInfo4);
CLASS(is_exposed, is_exposed);
CLASS(is_runtime, is_runtime);
CLASS(icon_path, icon_path);
CLASS(set, set_func);
CLASS(get, get_func);
CLASS(get_property_list, get_property_list_func);
CLASS(validate_property, validate_property_func);
CLASS(notification, notification_func);
CLASS(to_string, to_string_func);
CLASS(create, create_instance_func);
CLASS(release, free_instance_func);
CLASS(recreate, recreate_instance_func);
CLASS(get_virtual, get_virtual_func);
CLASS(get_virtual_data, get_virtual_call_data_func);
CLASS(call_virtual_with_data, call_virtual_with_data_func);
CLASS(userdata, class_userdata);

#define METHOD(field, their_field) FIELD(gdx_method_info, GDExtensionClassMethodInfo, field, their_field)
SIZE(gdx_method_info, GDExtensionClassMethodInfo);
METHOD(name, name);
METHOD(userdata, method_userdata);
METHOD(call, call_func);
METHOD(ptrcall, ptrcall_func);
METHOD(flags, method_flags);
METHOD(has_return, has_return_value);
METHOD(return_info, return_value_info);
METHOD(return_metadata, return_value_metadata);
METHOD(argument_count, argument_count);
METHOD(arguments, arguments_info);
METHOD(argument_metadata, arguments_metadata);
METHOD(default_count, default_argument_count);
METHOD(defaults, default_arguments);

SIZE(gdx_initialization, GDExtensionInitialization);
FIELD(gdx_initialization, GDExtensionInitialization, userdata, userdata);
FIELD(gdx_initialization, GDExtensionInitialization, initialize, initialize);
FIELD(gdx_initialization, GDExtensionInitialization, deinitialize, deinitialize);

/* Types of callbacks within structs. */
#define CALLBACK(struct_type, field, their_type)                                                                       \
    SAME(__builtin_types_compatible_p(__typeof__(((struct_type*)0)->field), their_type))
CALLBACK(gdx_class_info, notification, GDExtensionClassNotification2);
CALLBACK(gdx_class_info, create, GDExtensionClassCreateInstance2);
CALLBACK(gdx_class_info, release, GDExtensionClassFreeInstance);
CALLBACK(gdx_class_info, recreate, GDExtensionClassRecreateInstance);
CALLBACK(gdx_class_info, get_virtual, GDExtensionClassGetVirtual2);
CALLBACK(gdx_class_info, get_virtual_data, GDExtensionClassGetVirtualCallData2);
CALLBACK(gdx_class_info, call_virtual_with_data, GDExtensionClassCallVirtualWithData);
CALLBACK(gdx_class_info, to_string, GDExtensionClassToString);
CALLBACK(gdx_method_info, ptrcall, GDExtensionClassMethodPtrCall);
CALLBACK(gdx_initialization, initialize, GDExtensionInitializeCallback);
CALLBACK(gdx_initialization, deinitialize, GDExtensionDeinitializeCallback);
SAME(__builtin_types_compatible_p(gdx_virtual_call, GDExtensionClassCallVirtual));
SAME(__builtin_types_compatible_p(gdx_from_type, GDExtensionVariantFromTypeConstructorFunc));
SAME(__builtin_types_compatible_p(gdx_to_type, GDExtensionTypeFromVariantConstructorFunc));
SAME(__builtin_types_compatible_p(gdx_inner_pointer, GDExtensionVariantGetInternalPtrFunc));
SAME(__builtin_types_compatible_p(gdx_destructor, GDExtensionPtrDestructor));

#define gdx_call_error GDExtensionCallError
#define gdx_property_info GDExtensionPropertyInfo
#define gdx_class_info GDExtensionClassCreationInfo4
#define gdx_method_info GDExtensionClassMethodInfo
#define gdx_binding_callbacks GDExtensionInstanceBindingCallbacks

#define COMPARE(name, engine_type, result, parameters)                                                                 \
    typedef result(*compared_##name) parameters;                                                                       \
    SAME(__builtin_types_compatible_p(compared_##name, GDExtensionInterface##engine_type));
GDX_FUNCTIONS(COMPARE)

typedef void (*compared_call)(void*, void*, const void* const*, int64_t, void*, gdx_call_error*);
SAME(__builtin_types_compatible_p(compared_call, GDExtensionClassMethodCall));
