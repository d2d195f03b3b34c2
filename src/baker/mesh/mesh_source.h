// Origin of a mesh's faces, so that messages name what a modeller sees: object, material, and position in the file.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace lr::baker {

struct Mesh;

class MeshSource {
public:
    // Faces up to the next part.
    struct Part {
        std::size_t first_face = 0;
        std::string object, material; // can be empty
    };

    // mesh = scale * rotation * file
    MeshSource(const Mesh& mesh, std::vector<Part> parts, double scale, const Eigen::Matrix3d& rotation);

    // Follow the mesh: first its vertices are multiplied, then `centre` is subtracted from them.
    void scale_by(double factor);
    void move_to(const Eigen::Vector3d& centre);

    // "(1.2, 0, 3) of object 'leg', material 'oak'": the position in the file, and the names of the nearest face, since repairs split and renumber
    // faces but do not move them.
    std::string place(const Eigen::Vector3d& point) const;

    // "object 'leaves' with 120000 of 150000 faces", the largest; "150000 faces" without names.
    std::string largest() const;

private:
    const Part* part_of(std::size_t face) const;

    std::vector<Part> parts_;
    std::vector<Eigen::Vector3d> middles_; // of the faces, in the file
    double scale_;
    Eigen::Matrix3d rotation_;
    Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
};

// place() of the mesh's source, or the fallback without one.
std::string place_of(const Mesh& mesh, const Eigen::Vector3d& point, const std::string& fallback);

// "leg, seat", at most `most` different names; empty ones are left out.
std::string list_names(const std::vector<std::string>& names, std::size_t most);
} // namespace lr::baker
