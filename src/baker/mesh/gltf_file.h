// For glTF that assimp 5.2 cannot read: why it refuses a file; float positions in place of whole numbers (KHR_mesh_quantization), which it reads as
// if they were floats; and skins without inverse bind matrices, where it reads through a null pointer.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace lr::baker {

// Why a file by the name of glTF, or a GLB, is none: a sentence; empty if nothing is known.
std::string why_no_gltf(std::string_view file);

// An extension that the file requires and that is not read here; empty if there is none.
std::string_view unread_gltf_extension(std::string_view file);

bool has_quantized_positions(std::string_view file);
bool has_unbound_skins(std::string_view file);

// The bytes of a file that the glTF refers to; empty if it cannot be read.
using ReadGltfBuffer = std::function<std::string(const std::string& uri)>;

// The glTF or GLB as a GLB with one buffer, positions in floats and all matrices of skins; empty if it is damaged or a file is missing.
std::string plain_glb(std::string_view file, const ReadGltfBuffer& read_buffer);
} // namespace lr::baker
