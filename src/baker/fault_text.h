// Faults of a bake: search for errors, conversion to text.
#pragma once

#include "asset/input_faults.h"

namespace lr {

inline bool has_error(const Faults& faults) {
    for (const Fault& f : faults)
        if (f.severity == Severity::error) return true;
    return false;
}

// "1 part is open", "2 parts are open"
inline std::string counted(std::size_t number, const char* one, const char* many) {
    return std::to_string(number) + " " + (number == 1 ? one : many);
}

// "error 206 at edge 3-17: The surface has a boundary edge. Close the hole or bake it as a sheet."
inline std::string to_string(const Fault& fault) {
    std::string text = fault.severity == Severity::error ? "error " : "warning ";
    text += std::to_string(static_cast<uint32_t>(fault.id));
    if (!fault.where.empty()) text += " at " + fault.where;
    text += ": " + fault.what;
    if (!fault.remedy.empty()) text += " " + fault.remedy;
    return text;
}
} // namespace lr
