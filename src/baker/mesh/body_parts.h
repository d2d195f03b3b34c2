// Takes a mesh as artists make it: decides for each connected part whether it is a solid or a sheet, and repairs both.
#pragma once

#include "baker/mesh/mesh.h"
#include "baker/mesh/solid_region.h"

#include <cstddef>
#include <vector>

namespace lr::baker {

// The faces of `mesh` come in two kinds; corners are shared.
struct BodyParts {
    Mesh mesh; // the vertices, and all faces: those of the solids, then those of the sheets
    std::size_t solid_faces = 0;
    Mesh cavities;      // wound inward in the file and enclosed in a solid, with vertices of its own
    bool clean = false; // the solids pass check_and_repair: they neither cross nor touch each other

    bool has_sheets() const { return mesh.faces.size() > solid_faces; }
    std::vector<Face> solids() const {
        return {mesh.faces.begin(), mesh.faces.begin() + static_cast<std::ptrdiff_t>(solid_faces)};
    }
    std::vector<Face> sheets() const {
        return {mesh.faces.begin() + static_cast<std::ptrdiff_t>(solid_faces), mesh.faces.end()};
    }
};

// Whether it passes check_and_repair, and does not cross itself.
bool is_clean_solid(Mesh& mesh, Faults& found);

// Of parts with larger holes.
enum class OpenParts {
    sheets,
    filled,     // closes holes up to three quarters of a part's area: a rock without its base
    all_sheets, // only cleans up, and takes all faces as sheets
};

// A part is connected by edges. Joins cracks, removes faces without area and second copies, closes holes (a hundredth of a part's area, or a twentieth
// if all have the corners of a triangle or quad), and winds each solid outward. A part that is closed then is a solid; one in another solid, wound
// the other way in the file, is a cavity; flaps without a back that hang on a solid, and all else, are sheets. Each change is one warning with its
// number of faces. False only if nothing is left.
bool find_parts(Mesh& mesh, BodyParts& out, Faults& faults, OpenParts open = OpenParts::sheets);

// Of the union of the solids and of the sheets, plates of this thickness. hollow: less the cavities; else they count as filled.
RegionMoments body_moments(const BodyParts& parts, double thickness, bool hollow);

// A typical length of sheets: the mean extent of connected parts, weighted by their area.
double sheet_length(const Mesh& mesh, const std::vector<Face>& sheets);

// Joins vertices in cubes of a grid, and removes faces that collapse. The finest grid that leaves no more than `most` faces. Returns the size
// of the cubes; 0: the faces were few enough. Faces can coincide afterwards.
double cluster(Mesh& mesh, std::size_t most);
double cluster_to(Mesh& mesh, double cube);

// The faces with each set of corners once.
std::vector<Face> without_copies(const std::vector<Face>& faces);

// Renumbers, without vertices that no face uses.
void drop_unused_vertices(Mesh& mesh);
} // namespace lr::baker
