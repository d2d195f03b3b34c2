/*
 * The part of Godot's extension interface that this extension uses: types with the engine's layout, and functions that
 * are looked up by name. Needs Godot 4.4 or later. tests/abi compares it with the header that an engine dumps
 * (godot --dump-gdextension-interface).
 *
 * SPDX-License-Identifier: MIT
 */
#ifndef LANGEVIN_GDEXTENSION_ABI_H
#define LANGEVIN_GDEXTENSION_ABI_H

#include <stddef.h>
#include <stdint.h>

/* Opaque types are pointers; each function says who owns them. */
typedef void* gdx_object;
typedef void* gdx_library;

enum {
    GDX_NIL = 0,
    GDX_BOOL = 1,
    GDX_INT = 2,
    GDX_FLOAT = 3,
    GDX_STRING = 4,
    GDX_VECTOR3 = 9,
    GDX_PLANE = 14,
    GDX_QUATERNION = 15,
    GDX_AABB = 16,
    GDX_BASIS = 17,
    GDX_TRANSFORM3D = 18,
    GDX_COLOR = 20,
    GDX_STRING_NAME = 21,
    GDX_NODE_PATH = 22,
    GDX_RID = 23,
    GDX_OBJECT = 24,
    GDX_CALLABLE = 25,
    GDX_DICTIONARY = 27,
    GDX_ARRAY = 28,
    GDX_PACKED_BYTE_ARRAY = 29,
    GDX_PACKED_INT32_ARRAY = 30,
    GDX_PACKED_INT64_ARRAY = 31,
    GDX_PACKED_FLOAT32_ARRAY = 32,
    GDX_PACKED_STRING_ARRAY = 34,
    GDX_PACKED_VECTOR3_ARRAY = 36,
    GDX_TYPE_COUNT = 39
};

enum { GDX_LEVEL_CORE = 0, GDX_LEVEL_SERVERS = 1, GDX_LEVEL_SCENE = 2, GDX_LEVEL_EDITOR = 3 };

enum { GDX_METHOD_NORMAL = 1, GDX_METHOD_CONST = 4, GDX_METHOD_STATIC = 32 };

enum {
    GDX_CALL_OK = 0,
    GDX_CALL_INVALID_METHOD = 1,
    GDX_CALL_INVALID_ARGUMENT = 2,
    GDX_CALL_TOO_MANY_ARGUMENTS = 3,
    GDX_CALL_TOO_FEW_ARGUMENTS = 4,
    GDX_CALL_INSTANCE_IS_NULL = 5
};

/* The engine's enumerations are 32 bits wide. */
typedef uint32_t gdx_type;
typedef uint32_t gdx_level;

typedef struct gdx_call_error {
    uint32_t error; /* GDX_CALL_* */
    int32_t argument;
    int32_t expected; /* a type, or a number of arguments */
} gdx_call_error;

typedef struct gdx_binding_callbacks {
    void* (*create)(void* token, void* object);
    void (*release)(void* token, void* object, void* binding);
    uint8_t (*reference)(void* token, void* binding, uint8_t added);
} gdx_binding_callbacks;

typedef struct gdx_property_info {
    gdx_type type;
    void* name;       /* StringName */
    void* class_name; /* StringName */
    uint32_t hint;
    void* hint_string; /* String */
    uint32_t usage;
} gdx_property_info;

typedef void (*gdx_virtual_call)(void* instance, const void* const* args, void* ret);

typedef struct gdx_class_info {
    uint8_t is_virtual;
    uint8_t is_abstract;
    uint8_t is_exposed;
    uint8_t is_runtime;
    const void* icon_path; /* String */
    uint8_t (*set)(void* instance, const void* name, const void* value);
    uint8_t (*get)(void* instance, const void* name, void* value);
    const gdx_property_info* (*get_property_list)(void* instance, uint32_t* count);
    void (*free_property_list)(void* instance, const gdx_property_info* list, uint32_t count);
    uint8_t (*can_revert)(void* instance, const void* name);
    uint8_t (*get_revert)(void* instance, const void* name, void* value);
    uint8_t (*validate_property)(void* instance, gdx_property_info* property);
    void (*notification)(void* instance, int32_t what, uint8_t reversed);
    void (*to_string)(void* instance, uint8_t* valid, void* text);
    void (*reference)(void* instance);
    void (*unreference)(void* instance);
    gdx_object (*create)(void* userdata, uint8_t notify);
    void (*release)(void* userdata, void* instance);
    void* (*recreate)(void* userdata, gdx_object object);
    gdx_virtual_call (*get_virtual)(void* userdata, const void* name, uint32_t hash);
    void* (*get_virtual_data)(void* userdata, const void* name, uint32_t hash);
    void (*call_virtual_with_data)(void* instance, const void* name, void* data, const void* const* args, void* ret);
    void* userdata;
} gdx_class_info;

typedef struct gdx_method_info {
    void* name; /* StringName */
    void* userdata;
    void (*call)(void* userdata, void* instance, const void* const* args, int64_t count, void* ret,
                 gdx_call_error* error);
    void (*ptrcall)(void* userdata, void* instance, const void* const* args, void* ret);
    uint32_t flags; /* GDX_METHOD_* */
    uint8_t has_return;
    gdx_property_info* return_info;
    uint32_t return_metadata;
    uint32_t argument_count;
    gdx_property_info* arguments;
    uint32_t* argument_metadata;
    uint32_t default_count;
    void** defaults; /* Variants */
} gdx_method_info;

typedef struct gdx_initialization {
    gdx_level minimum_level;
    void* userdata;
    void (*initialize)(void* userdata, gdx_level level);
    void (*deinitialize)(void* userdata, gdx_level level);
} gdx_initialization;

typedef void (*gdx_function)(void);
typedef gdx_function (*gdx_get_proc_address)(const char* name);

/* Functions of the engine for a type of Variant. */
typedef void (*gdx_from_type)(void* variant, void* value);
typedef void (*gdx_to_type)(void* value, void* variant);
typedef void* (*gdx_inner_pointer)(void* variant);
typedef void (*gdx_destructor)(void* value);

/* X(name to look up, the engine's name of its type, result, parameters) */
#define GDX_FUNCTIONS(X)                                                                                               \
    X(print_error_with_message, PrintErrorWithMessage, void,                                                           \
      (const char* description, const char* message, const char* function, const char* file, int32_t line,             \
       uint8_t notify))                                                                                                \
    X(print_warning_with_message, PrintWarningWithMessage, void,                                                       \
      (const char* description, const char* message, const char* function, const char* file, int32_t line,             \
       uint8_t notify))                                                                                                \
    X(variant_new_copy, VariantNewCopy, void, (void* to, const void* from))                                            \
    X(variant_new_nil, VariantNewNil, void, (void* variant))                                                           \
    X(variant_destroy, VariantDestroy, void, (void* variant))                                                          \
    X(variant_get_type, VariantGetType, gdx_type, (const void* variant))                                               \
    X(variant_can_convert_strict, VariantCanConvertStrict, uint8_t, (gdx_type from, gdx_type to))                      \
    X(variant_call, VariantCall, void,                                                                                 \
      (void* self, const void* method, const void* const* args, int64_t count, void* ret, gdx_call_error* error))      \
    X(variant_construct, VariantConstruct, void,                                                                       \
      (gdx_type type, void* variant, const void* const* args, int32_t count, gdx_call_error* error))                   \
    X(variant_get_indexed, VariantGetIndexed, void,                                                                    \
      (const void* self, int64_t index, void* ret, uint8_t* valid, uint8_t* out_of_bounds))                            \
    X(get_variant_from_type_constructor, GetVariantFromTypeConstructor, gdx_from_type, (gdx_type type))                \
    X(get_variant_to_type_constructor, GetVariantToTypeConstructor, gdx_to_type, (gdx_type type))                      \
    X(variant_get_ptr_internal_getter, GetVariantGetInternalPtrFunc, gdx_inner_pointer, (gdx_type type))               \
    X(variant_get_ptr_destructor, VariantGetPtrDestructor, gdx_destructor, (gdx_type type))                            \
    X(string_new_with_utf8_chars, StringNewWithUtf8Chars, void, (void* string, const char* text))                      \
    X(string_to_utf8_chars, StringToUtf8Chars, int64_t, (const void* string, char* text, int64_t capacity))            \
    X(string_name_new_with_latin1_chars, StringNameNewWithLatin1Chars, void,                                           \
      (void* name, const char* text, uint8_t is_static))                                                               \
    X(packed_byte_array_operator_index, PackedByteArrayOperatorIndex, uint8_t*, (void* array, int64_t index))          \
    X(packed_byte_array_operator_index_const, PackedByteArrayOperatorIndexConst, const uint8_t*,                       \
      (const void* array, int64_t index))                                                                              \
    X(packed_int32_array_operator_index_const, PackedInt32ArrayOperatorIndexConst, const int32_t*,                     \
      (const void* array, int64_t index))                                                                              \
    X(packed_int64_array_operator_index, PackedInt64ArrayOperatorIndex, int64_t*, (void* array, int64_t index))        \
    X(packed_int64_array_operator_index_const, PackedInt64ArrayOperatorIndexConst, const int64_t*,                     \
      (const void* array, int64_t index))                                                                              \
    X(packed_float32_array_operator_index, PackedFloat32ArrayOperatorIndex, float*, (void* array, int64_t index))      \
    X(packed_float32_array_operator_index_const, PackedFloat32ArrayOperatorIndexConst, const float*,                   \
      (const void* array, int64_t index))                                                                              \
    X(packed_vector3_array_operator_index, PackedVector3ArrayOperatorIndex, void*, (void* array, int64_t index))       \
    X(packed_vector3_array_operator_index_const, PackedVector3ArrayOperatorIndexConst, void*,                          \
      (const void* array, int64_t index))                                                                              \
    X(object_method_bind_call, ObjectMethodBindCall, void,                                                             \
      (const void* method, void* object, const void* const* args, int64_t count, void* ret, gdx_call_error* error))    \
    X(object_method_bind_ptrcall, ObjectMethodBindPtrcall, void,                                                       \
      (const void* method, void* object, const void* const* args, void* ret))                                          \
    X(global_get_singleton, GlobalGetSingleton, gdx_object, (const void* name))                                        \
    X(object_get_instance_binding, ObjectGetInstanceBinding, void*,                                                    \
      (void* object, void* token, const gdx_binding_callbacks* callbacks))                                             \
    X(object_set_instance_binding, ObjectSetInstanceBinding, void,                                                     \
      (void* object, void* token, void* binding, const gdx_binding_callbacks* callbacks))                              \
    X(object_set_instance, ObjectSetInstance, void, (void* object, const void* class_name, void* instance))            \
    X(object_get_instance_from_id, ObjectGetInstanceFromId, gdx_object, (uint64_t id))                                 \
    X(object_get_instance_id, ObjectGetInstanceId, uint64_t, (const void* object))                                     \
    X(ref_set_object, RefSetObject, void, (void* ref, void* object))                                                   \
    X(ref_get_object, RefGetObject, gdx_object, (const void* ref))                                                     \
    X(editor_add_plugin, EditorAddPlugin, void, (const void* class_name))                                              \
    X(editor_remove_plugin, EditorRemovePlugin, void, (const void* class_name))                                        \
    X(classdb_construct_object2, ClassdbConstructObject2, gdx_object, (const void* class_name))                        \
    X(classdb_get_method_bind, ClassdbGetMethodBind, const void*,                                                      \
      (const void* class_name, const void* method, int64_t hash))                                                      \
    X(classdb_register_extension_class4, ClassdbRegisterExtensionClass4, void,                                         \
      (void* library, const void* class_name, const void* parent, const gdx_class_info* info))                         \
    X(classdb_register_extension_class_method, ClassdbRegisterExtensionClassMethod, void,                              \
      (void* library, const void* class_name, const gdx_method_info* info))                                            \
    X(classdb_register_extension_class_integer_constant, ClassdbRegisterExtensionClassIntegerConstant, void,           \
      (void* library, const void* class_name, const void* enumeration, const void* name, int64_t value,                \
       uint8_t is_bitfield))                                                                                           \
    X(classdb_register_extension_class_property, ClassdbRegisterExtensionClassProperty, void,                          \
      (void* library, const void* class_name, const gdx_property_info* info, const void* setter, const void* getter))  \
    X(classdb_register_extension_class_property_group, ClassdbRegisterExtensionClassPropertyGroup, void,               \
      (void* library, const void* class_name, const void* group, const void* prefix))                                  \
    X(classdb_register_extension_class_signal, ClassdbRegisterExtensionClassSignal, void,                              \
      (void* library, const void* class_name, const void* name, const gdx_property_info* args, int64_t count))         \
    X(classdb_unregister_extension_class, ClassdbUnregisterExtensionClass, void,                                       \
      (void* library, const void* class_name))

#define GDX_DECLARE(name, engine_type, result, parameters) typedef result(*gdx_fn_##name) parameters;
GDX_FUNCTIONS(GDX_DECLARE)
#undef GDX_DECLARE

#endif
