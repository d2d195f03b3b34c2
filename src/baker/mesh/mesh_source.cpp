#include "baker/mesh/mesh_source.h"

#include "baker/mesh/mesh.h"
#include "baker/printable_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>

namespace lr::baker {
namespace {

std::string four_digits(double x) {
    char buffer[32];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, x + 0.0, std::chars_format::general, 4).ptr};
}
} // namespace

MeshSource::MeshSource(const Mesh& mesh, std::vector<Part> parts, double scale, const Eigen::Matrix3d& rotation)
    : parts_(std::move(parts)), scale_(scale), rotation_(rotation) {
    middles_.reserve(mesh.faces.size());
    for (const Face& f : mesh.faces)
        middles_.push_back(rotation.transpose() * (mesh.vertices[f[0]] + mesh.vertices[f[1]] + mesh.vertices[f[2]]) /
                           (3.0 * scale));
}

void MeshSource::scale_by(double factor) {
    scale_ *= factor;
}

void MeshSource::move_to(const Eigen::Vector3d& centre) {
    centre_ += centre;
}

const MeshSource::Part* MeshSource::part_of(std::size_t face) const {
    const auto next = std::upper_bound(parts_.begin(), parts_.end(), face,
                                       [](std::size_t f, const Part& part) { return f < part.first_face; });
    return next == parts_.begin() ? nullptr : &*(next - 1);
}

std::string MeshSource::place(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d at = rotation_.transpose() * (point + centre_) / scale_;
    double reach = 0.0, nearest = HUGE_VAL;
    std::size_t face = middles_.size();
    for (std::size_t i = 0; i < middles_.size(); ++i) {
        const double square = (middles_[i] - at).squaredNorm();
        reach = std::max(reach, middles_[i].cwiseAbs().maxCoeff());
        if (square < nearest) nearest = square, face = i;
    }
    std::string text = "(";
    for (Eigen::Index k = 0; k < 3; ++k)
        text += (k > 0 ? ", " : "") + four_digits(std::abs(at[k]) < 1e-6 * reach ? 0.0 : at[k]);
    text += ")";
    const Part* part = face < middles_.size() ? part_of(face) : nullptr;
    if (!part) return text;
    if (!part->object.empty()) text += " of object '" + printable(part->object) + "'";
    if (!part->material.empty())
        text += std::string(part->object.empty() ? " of" : ",") + " material '" + printable(part->material) + "'";
    return text;
}

std::string MeshSource::largest() const {
    std::map<std::string, std::size_t> sizes;
    for (std::size_t i = 0; i < parts_.size(); ++i)
        sizes[parts_[i].object] +=
            (i + 1 < parts_.size() ? parts_[i + 1].first_face : middles_.size()) - parts_[i].first_face;
    const auto most =
        std::max_element(sizes.begin(), sizes.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    const std::string all = std::to_string(middles_.size()) + " faces";
    if (most == sizes.end() || most->first.empty()) return all;
    return "object '" + printable(most->first) + "' with " + std::to_string(most->second) + " of " + all;
}

std::string place_of(const Mesh& mesh, const Eigen::Vector3d& point, const std::string& fallback) {
    return mesh.source && point.allFinite() ? mesh.source->place(point) : fallback;
}

std::string list_names(const std::vector<std::string>& names, std::size_t most) {
    std::vector<std::string> distinct;
    std::set<std::string> seen;
    for (const std::string& name : names)
        if (!name.empty() && seen.insert(name).second) distinct.push_back(name);
    std::string text;
    for (std::size_t i = 0; i < std::min(most, distinct.size()); ++i)
        text += (i > 0 ? ", '" : "'") + printable(distinct[i]) + "'";
    if (distinct.size() > most) text += " and " + std::to_string(distinct.size() - most) + " more";
    return text;
}
} // namespace lr::baker
