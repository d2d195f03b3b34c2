#include "baker/bake.h"
#include "baker/bake_input.h"
#include "baker/printable_text.h"

#include <array>

namespace lr::baker {

std::string canonical_options(const BakeOptions& o) {
    std::string text = o.semi_axes ? "ellipsoid" : o.card ? "card" : "mesh";
    const auto add = [&](const char* before, const auto& numbers) {
        text += before;
        char separator = ' ';
        for (const auto n : numbers) {
            text += separator;
            text += shortest(n);
            separator = ',';
        }
    };
    const auto add_one = [&](const char* before, double number) { add(before, std::array{number}); };
    if (o.semi_axes)
        for (const double a : *o.semi_axes) add_one("", a);
    text += " --unit ";
    const bool same_as_metres = o.unit == Unit::file && (o.semi_axes || !declares_unit(o.mesh_path));
    text += unit_name(same_as_metres ? Unit::m : o.unit);
    if (!o.semi_axes && o.up != UpAxis::z) text += std::string(" --up ") + up_name(o.up);
    if (!o.semi_axes && o.mesh) text += " --mesh " + valid_utf8(*o.mesh);
    if (!o.semi_axes && o.card) {
        add_one(" --width", o.card->width);
        if (!o.card->mask_path.empty())
            text += " --mask FILE";
        else if (o.card->channel == MaskChannel::luminance)
            text += " --mask luminance";
        if (o.card->channel == MaskChannel::key) {
            text += " --key #";
            for (const uint8_t part : o.card->key)
                for (const int digit : {part / 16, part % 16}) text += "0123456789abcdef"[digit];
        }
        add_one(" --alpha", o.card->alpha);
        add_one(" --triangles", static_cast<double>(o.card->triangles));
        if (o.card->all_pieces) text += " --piece all";
        if (o.card->piece) text += " --piece " + std::to_string(*o.card->piece);
        add_one(" --speck", o.card->speck);
    }
    if (!o.semi_axes && o.strict) text += " --strict";
    if (!o.semi_axes && o.fill) text += " --fill";
    if (!o.semi_axes && o.thickness) add_one(" --thickness", *o.thickness);
    if (!o.semi_axes && o.sheet && o.sheet->thickness == choose_thickness)
        text += " --sheet";
    else if (!o.semi_axes && o.sheet)
        add_one(o.card ? " --thickness" : " --sheet --thickness", o.sheet->thickness);
    if (!o.semi_axes && o.sheet && o.sheet->areal_density)
        add_one(" --areal-density", *o.sheet->areal_density);
    else
        add_one(" --density", o.density);
    add(" --fluid", std::array{o.fluid_density, o.fluid_viscosity});
    add(" --grid", o.cells);
    add_one(" --intensity", o.intensity);
    if (o.wake) text += " --wake";
    if (o.stations != most_stations) add_one(" --stations", o.stations);
    if (o.size) text += " --size " + shortest(*o.size) + "m";
    if (o.center_of_mass) add(" --center-of-mass", *o.center_of_mass);
    if (o.mass) text += " --mass-from " + mass_name(o);
    if (o.name) {
        text += " --name ";
        text += valid_utf8(*o.name);
    }
    return text;
}
} // namespace lr::baker
