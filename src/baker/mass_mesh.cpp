#include "baker/mass_mesh.h"

#include "baker/bake.h"
#include "baker/fault_text.h"
#include "baker/mesh/body_parts.h"
#include "baker/mesh/mesh_check.h"

namespace lr::baker {

bool weigh(Mesh& mesh, const WeighOptions& how, MassProperties& out, Faults& faults) {
    if (how.sheet) {
        if (!how.strict)
            std::erase_if(mesh.faces, [&](const Face& f) { return !(face_shape(mesh, f) > degenerate_shape); });
        if (!check_layers(mesh, faults)) return false;
        out = compute_sheet_mass_properties(mesh, how.thickness);
        return true;
    }
    Mesh checked = mesh;
    Faults found;
    if (check_and_repair(checked, found) || how.strict) {
        faults.insert(faults.end(), found.begin(), found.end());
        if (has_error(found)) return false;
        out = solid_mass_properties(checked, found);
        return true;
    }
    BodyParts parts;
    if (!find_parts(mesh, parts, faults, how.fill ? OpenParts::filled : OpenParts::sheets)) return false;
    const double thickness =
        how.thickness > 0.0 ? how.thickness : default_thickness * sheet_length(parts.mesh, parts.sheets());
    const RegionMoments m = body_moments(parts, thickness, true);
    out = combined_mass_properties(parts.mesh, parts.solid_faces, m.volume, m.first, m.second);
    return true;
}
} // namespace lr::baker
