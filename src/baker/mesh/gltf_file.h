// Works around glTF that assimp 5.2 cannot read: quantised positions (KHR_mesh_quantization), which it reads as floats, become floats; skins without
// inverse bind matrices, where it reads through a null pointer, get them; the reason of a refusal becomes a sentence.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace lr::baker {

// Why a file named as glTF or GLB is not valid, as a sentence; empty if unknown.
std::string why_no_gltf(std::string_view file);

// An extension that the file requires and that is not read here; empty if there is none.
std::string_view unread_gltf_extension(std::string_view file);

bool has_quantized_positions(std::string_view file);
bool has_gpu_instances(std::string_view file); // EXT_mesh_gpu_instancing
bool has_unbound_skins(std::string_view file);

// The bytes of a file that the glTF refers to; empty if unreadable.
using ReadGltfBuffer = std::function<std::string(const std::string& uri)>;

// The file as a GLB with one buffer, float positions and all skin matrices; empty if it is damaged or a file is missing.
std::string plain_glb(std::string_view file, const ReadGltfBuffer& read_buffer);
} // namespace lr::baker
