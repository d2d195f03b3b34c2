// Reads a mesh as artists make it: classifies each connected part as a solid or a sheet, and repairs both.
#pragma once

#include "baker/mesh/mesh.h"
#include "baker/mesh/solid_region.h"

#include <cstddef>
#include <vector>

namespace lr::baker {

struct BodyParts {
    Mesh mesh; // the vertices, and all faces: those of the solids, then those of the sheets
    std::size_t solid_faces = 0;
    std::vector<Face> covered; // what sheets have within solids: without mass or loads
    Mesh cavities;             // wound inward in the file and enclosed in a solid, with vertices of its own
    bool clean = false;        // the solids pass check_and_repair: they neither cross nor touch each other

    bool has_sheets() const { return mesh.faces.size() > solid_faces; }
    std::vector<Face> solids() const {
        return {mesh.faces.begin(), mesh.faces.begin() + static_cast<std::ptrdiff_t>(solid_faces)};
    }
    std::vector<Face> sheets() const {
        return {mesh.faces.begin() + static_cast<std::ptrdiff_t>(solid_faces), mesh.faces.end()};
    }
};

// Whether the mesh passes check_and_repair without faces that cross.
bool is_clean_solid(Mesh& mesh, Faults& found);

// Treatment of parts with larger holes.
enum class OpenParts {
    sheets,
    filled,     // closes holes up to three quarters of a part's area, as of a rock without its base
    all_sheets, // only cleans up; all faces are sheets
};

// A part is connected by edges. Joins cracks, removes faces without area and copies, closes holes (a hundredth of a part's area, or a twentieth if
// all have the corners of a triangle or quad), and winds each solid outward. A part that is then closed is a solid, or a cavity if it lies in another
// solid and the file winds it the other way. Flaps without a back on a solid, and all other parts, are sheets. Each kind of change is one warning
// with its number of faces. False only if nothing is left.
bool find_parts(Mesh& mesh, BodyParts& out, Faults& faults, OpenParts open = OpenParts::sheets);

// Moments of the union of the solids and of the sheets, plates of this thickness. hollow: without the cavities; else they are filled.
RegionMoments body_moments(const BodyParts& parts, double thickness, bool hollow);

// Of one sound solid, or of one that crosses itself, as the faults of its check say: volume covered twice counts once. For density 1.
MassProperties solid_mass_properties(const Mesh& mesh, const Faults& found);

// A typical length of sheets: the mean extent of connected parts, weighted by their area.
double sheet_length(const Mesh& mesh, const std::vector<Face>& sheets);

// Joins vertices in cubes of a grid, the finest that leaves at most `most` faces, and collapses faces. Returns the size of the cubes; 0: the faces
// were few enough. Faces can coincide afterwards.
double cluster(Mesh& mesh, std::size_t most);
double cluster_to(Mesh& mesh, double cube);

// One face for each set of corners.
std::vector<Face> without_copies(const std::vector<Face>& faces);

// Removes vertices that no face uses.
void drop_unused_vertices(Mesh& mesh);
} // namespace lr::baker
