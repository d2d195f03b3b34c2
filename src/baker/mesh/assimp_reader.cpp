#include "baker/mesh/assimp_reader.h"

#include "baker/mesh/gltf_file.h"
#include "baker/mesh/unknown_file.h"
#include "baker/printable_text.h"

#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <Eigen/LU>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <exception>
#include <filesystem>
#include <memory>
#include <system_error>

namespace lr::baker {
namespace {

constexpr std::size_t max_polygons = 20'000'000; // above the limit that the caller refuses

Eigen::Vector3d to_eigen(const aiVector3D& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

Eigen::Matrix4d to_eigen(const aiMatrix4x4& m) {
    Eigen::Matrix4d result;
    for (unsigned row = 0; row < 4; ++row)
        for (unsigned column = 0; column < 4; ++column)
            result(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
                static_cast<double>(m[row][column]);
    return result;
}

class SceneWalk {
public:
    SceneWalk(const aiScene& scene, const SceneFile& file, PolygonSoup& soup)
        : scene_(scene), soup_(soup), is_gltf_(file.extension == "gltf" || file.extension == "glb") {}

    void append_node(const aiNode& node, const Eigen::Matrix4d& transform, int depth) {
        if (depth > 200 || soup_.polygons.size() > max_polygons) return;
        const std::string name = node.mName.C_Str();
        // Assimp creates helper nodes for FBX pivots; the author did not name them.
        const bool authored = !name.empty() && name.find("_$AssimpFbx$_") == std::string::npos;
        if (authored) above_.push_back(name);
        for (unsigned i = 0; i < node.mNumMeshes; ++i)
            if (node.mMeshes[i] < scene_.mNumMeshes) append_instance(*scene_.mMeshes[node.mMeshes[i]], name, transform);
        // A node is one object, even if materials split it into several meshes.
        ++object_;
        for (unsigned i = 0; i < node.mNumChildren; ++i)
            append_node(*node.mChildren[i], transform * to_eigen(node.mChildren[i]->mTransformation), depth + 1);
        if (authored) above_.pop_back();
    }

private:
    // A mirroring transform inverts the faces; reversing their corners corrects that.
    void append_instance(const aiMesh& mesh, const std::string& node, const Eigen::Matrix4d& transform) {
        const auto base = static_cast<uint32_t>(soup_.vertices.size());
        bool mirrored = transform.topLeftCorner<3, 3>().determinant() < 0.0;
        SoupPart part;
        part.first_polygon = soup_.polygons.size();
        part.object = object_;
        part.own_names = {node, mesh_name(mesh)};
        part.group_names = above_;
        part.material = material_name(mesh);
        for (unsigned i = 0; i < mesh.mNumVertices; ++i)
            soup_.vertices.emplace_back(transform.topLeftCorner<3, 3>() * to_eigen(mesh.mVertices[i]) +
                                        transform.topRightCorner<3, 1>());
        if (is_gltf_) mirrored = pose(mesh, base, mirrored);
        for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
            const aiFace& face = mesh.mFaces[i];
            if (face.mNumIndices < 3) {
                ++soup_.ignored_points;
                continue;
            }
            std::vector<uint32_t> polygon(face.mIndices, face.mIndices + face.mNumIndices);
            // An index out of range must not become valid by adding `base`.
            for (uint32_t& index : polygon) index = index < mesh.mNumVertices ? base + index : UINT32_MAX;
            if (mirrored) std::reverse(polygon.begin(), polygon.end());
            soup_.polygons.push_back(std::move(polygon));
        }
        if (soup_.polygons.size() > part.first_polygon) soup_.parts.push_back(std::move(part));
    }

    // glTF places a skinned mesh by its joints in their current pose, not by its node. Returns whether that mirrors it.
    bool pose(const aiMesh& mesh, uint32_t base, bool mirrored) {
        std::vector<double> weights(mesh.mNumVertices, 0.0);
        std::vector<Eigen::Vector3d> posed(mesh.mNumVertices, Eigen::Vector3d::Zero());
        for (unsigned i = 0; i < mesh.mNumBones; ++i) {
            const aiBone& bone = *mesh.mBones[i];
            Eigen::Matrix4d joint = to_eigen(bone.mOffsetMatrix);
            for (const aiNode* node = scene_.mRootNode->FindNode(bone.mName); node; node = node->mParent)
                joint = to_eigen(node->mTransformation) * joint;
            if (bone.mNumWeights > 0) mirrored = joint.topLeftCorner<3, 3>().determinant() < 0.0;
            for (unsigned k = 0; k < bone.mNumWeights; ++k) {
                const unsigned v = bone.mWeights[k].mVertexId;
                if (v >= mesh.mNumVertices) continue;
                const auto weight = static_cast<double>(bone.mWeights[k].mWeight);
                posed[v] +=
                    weight * (joint.topLeftCorner<3, 3>() * to_eigen(mesh.mVertices[v]) + joint.topRightCorner<3, 1>());
                weights[v] += weight;
            }
        }
        for (unsigned v = 0; v < mesh.mNumVertices; ++v)
            if (weights[v] > 0.0) soup_.vertices[base + v] = posed[v] / weights[v];
        return mirrored;
    }

    std::string material_name(const aiMesh& mesh) const {
        aiString name;
        if (mesh.mMaterialIndex >= scene_.mNumMaterials ||
            scene_.mMaterials[mesh.mMaterialIndex]->Get(AI_MATKEY_NAME, name) != aiReturn_SUCCESS)
            return {};
        const std::string text = name.C_Str();
        return text == AI_DEFAULT_MATERIAL_NAME ? std::string() : text; // made by assimp
    }

    // assimp numbers the primitives of a glTF mesh: "leaf-0", "leaf-1".
    std::string mesh_name(const aiMesh& mesh) const {
        std::string name = mesh.mName.C_Str();
        if (!is_gltf_) return name;
        const std::size_t dash = name.find_last_not_of("0123456789");
        if (dash == std::string::npos || dash == 0 || dash + 1 == name.size() || name[dash] != '-') return name;
        const std::string stem = name.substr(0, dash + 1);
        std::size_t siblings = 0;
        for (unsigned i = 0; i < scene_.mNumMeshes; ++i) {
            const std::string other = scene_.mMeshes[i]->mName.C_Str();
            siblings += other == stem + "0" || other == stem + "1";
        }
        return siblings == 2 ? name.substr(0, dash) : name;
    }

    const aiScene& scene_;
    PolygonSoup& soup_;
    bool is_gltf_;
    std::size_t object_ = 0;
    std::vector<std::string> above_;
};

// Units in assimp 5.2: Collada's <unit> multiplies the root node's transform, which is otherwise the identity (the rotation by the up axis is
// switched off); FBX has its unit in the metadata, in centimetres. Both become positions in the file's unit, and that unit in metres.
Eigen::Matrix4d take_unit(const aiScene& scene, const std::string& extension, PolygonSoup& soup) {
    Eigen::Matrix4d root = to_eigen(scene.mRootNode->mTransformation);
    double unit = 0.0;
    if (extension == "dae") {
        unit = std::cbrt(std::abs(root.topLeftCorner<3, 3>().determinant()));
        if (std::isfinite(unit) && unit > 0.0) root.topLeftCorner<3, 3>() /= unit;
    } else if (extension == "fbx" && scene.mMetaData) {
        double centimetres = 0.0;
        float single = 0.0F;
        if (scene.mMetaData->Get("UnitScaleFactor", centimetres))
            unit = 0.01 * centimetres;
        else if (scene.mMetaData->Get("UnitScaleFactor", single))
            unit = 0.01 * static_cast<double>(single);
    }
    if (std::isfinite(unit) && unit > 0.0) {
        // Rounds single precision to the intended decimal: 0.0254, not 0.0253999997.
        const double digits = std::pow(10.0, 6.0 - std::floor(std::log10(unit)));
        const double rounded = std::round(unit * digits) / digits;
        soup.declared_unit = rounded > 0.0 && std::isfinite(rounded) ? rounded : unit;
    }
    return root;
}

class ByteStream final : public Assimp::IOStream {
public:
    explicit ByteStream(std::shared_ptr<const InputFiles::Bytes> bytes) : bytes_(std::move(bytes)) {}

    std::size_t Read(void* to, std::size_t size, std::size_t count) override {
        if (size == 0) return 0;
        const std::size_t whole = std::min(count, (bytes_->size() - at_) / size);
        if (whole > 0) std::memcpy(to, bytes_->data() + at_, whole * size);
        at_ += whole * size;
        return whole;
    }
    std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
    aiReturn Seek(std::size_t offset, aiOrigin origin) override {
        // Negative offsets (from the end, or backwards) arrive in an unsigned type.
        const std::size_t base = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? at_ : bytes_->size();
        const std::size_t to = base + offset;
        if (to > bytes_->size()) return aiReturn_FAILURE;
        at_ = to;
        return aiReturn_SUCCESS;
    }
    std::size_t Tell() const override { return at_; }
    std::size_t FileSize() const override { return bytes_->size(); }
    void Flush() override {}

private:
    std::shared_ptr<const InputFiles::Bytes> bytes_;
    std::size_t at_ = 0;
};

// Opens for reading the scene's file and regular files in its folder or below, links followed; none when reading from memory. A downloaded model
// could otherwise name any file of the machine.
class FileAccess final : public Assimp::IOSystem {
public:
    FileAccess(const SceneFile& file, std::string& refused)
        : files_(file.files), own_(file.path ? *file.path : ""), refused_(refused) {
        std::error_code error;
        const std::filesystem::path folder = to_path(own_).parent_path();
        folder_ = std::filesystem::canonical(folder.empty() ? "." : folder, error);
    }

    bool Exists(const char* path) const override { return read(path) != nullptr; }
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* path, const char* mode) override {
        if (!mode || mode[0] != 'r' || std::strchr(mode, '+')) return nullptr;
        std::shared_ptr<const InputFiles::Bytes> bytes = read(path);
        return bytes ? new ByteStream(std::move(bytes)) : nullptr;
    }
    void Close(Assimp::IOStream* stream) override { delete stream; }

    std::shared_ptr<const InputFiles::Bytes> read(const char* path) const {
        if (!files_ || !path) return nullptr;
        auto bytes = open(path);
        const std::string plain = bytes ? path : without_escapes(path);
        return plain == path ? bytes : open(plain);
    }

private:
    std::shared_ptr<const InputFiles::Bytes> open(const std::string& path) const {
        if (path == own_ || may_open(path)) return files_->read(path);
        if (refused_.empty()) refused_ = path;
        return nullptr;
    }

    // Exporters write the spaces of names as %20. The scene's own folder is no URI.
    std::string without_escapes(const std::string& path) const {
        const std::size_t folder = own_.find_last_of("/\\") + 1;
        std::size_t at = path.compare(0, folder, own_, 0, folder) == 0 ? folder : 0;
        std::string plain = path.substr(0, at);
        for (; at < path.size(); ++at) {
            unsigned char byte = 0;
            const char* const digits = path.data() + at + 1;
            const bool escaped = path[at] == '%' && at + 2 < path.size() &&
                                 std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2 && byte != 0;
            plain += escaped ? static_cast<char>(byte) : path[at];
            if (escaped) at += 2;
        }
        return plain;
    }

    bool may_open(const std::string& path) const {
        std::error_code error;
        // weakly_canonical leaves a relative path to a missing file relative, which would seem to lie outside.
        const std::filesystem::path target =
            std::filesystem::weakly_canonical(std::filesystem::absolute(to_path(path), error), error);
        if (error || folder_.empty()) return false;
        return std::mismatch(folder_.begin(), folder_.end(), target.begin(), target.end()).first == folder_.end();
    }

    InputFiles* files_;
    std::string own_;
    std::filesystem::path folder_;
    std::string& refused_; // the first path
};

// Whether assimp needs this file as a plain GLB. Sets `glb` to that or, if it cannot be made, `why` to the reason.
bool needs_plain_glb(const SceneFile& file, const FileAccess& files, std::string& glb, std::string& why) {
    const std::string_view bytes_of_file(static_cast<const char*>(file.bytes), file.size);
    if (file.extension != "gltf" && file.extension != "glb") return false;
    if (has_quantized_positions(bytes_of_file))
        why = "positions in KHR_mesh_quantization";
    else if (has_gpu_instances(bytes_of_file))
        why = "instances by EXT_mesh_gpu_instancing";
    else if (has_unbound_skins(bytes_of_file))
        why = "a skin without inverseBindMatrices";
    else
        return false;
    glb = plain_glb(bytes_of_file, [&](const std::string& uri) {
        const std::string path = file.path ? file.path->substr(0, file.path->find_last_of("/\\") + 1) + uri : "";
        const auto bytes = files.read(path.c_str());
        if (!bytes) why = "could not open referenced file \"" + uri + "\"";
        return bytes ? std::string(bytes->begin(), bytes->end()) : std::string();
    });
    return true;
}
} // namespace

// No post-processing by assimp: its steps drop or reorder faces silently and trust indices.
bool read_with_assimp(const SceneFile& file, PolygonSoup& soup, Faults& faults) {
    std::string refused;
    const auto report_refused = [&](Severity severity) {
        faults.push_back(
            {FaultId::file_outside, severity, file.where,
             "It refers to '" + printable(refused) + "', outside its folder, which was not opened.",
             "Copy that file beside the model and refer to it by its name, or export the model as one file "
             "(.glb)."});
        return false;
    };
    const auto fail = [&](const char* why) {
        if (!refused.empty()) return report_refused(Severity::error);
        UnknownFile explained =
            explain_unknown_file({static_cast<const char*>(file.bytes), file.size}, file.extension, why);
        faults.push_back({FaultId::mesh_unreadable, Severity::error, file.where, std::move(explained.what),
                          std::move(explained.remedy)});
        return false;
    };
    try {
        Assimp::Importer importer;
        importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
        importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
        importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, !file.collada_ids);
        auto* files = new FileAccess(file, refused);
        importer.SetIOHandler(files); // the importer owns it
        std::string glb, why;
        if (needs_plain_glb(file, *files, glb, why) && glb.empty()) return fail(why.c_str());
        const aiScene* scene = !glb.empty() ? importer.ReadFileFromMemory(glb.data(), glb.size(), 0, "glb")
                               : file.path
                                   ? importer.ReadFile(*file.path, 0)
                                   : importer.ReadFileFromMemory(file.bytes, file.size, 0, file.extension.c_str());
        if (!scene || !scene->mRootNode) return fail(importer.GetErrorString());
        soup = {};
        const Eigen::Matrix4d root = take_unit(*scene, file.extension, soup);
        SceneWalk(*scene, file, soup).append_node(*scene->mRootNode, root, 0);
        if (!refused.empty()) report_refused(Severity::warning);
        return true;
    } catch (const std::exception& error) {
        return fail(error.what());
    }
}
} // namespace lr::baker
