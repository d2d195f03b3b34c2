#include "format/fault.h"

#include <charconv>

namespace lr {

std::string to_string(const Fault& fault) {
    std::string text = fault.severity == Severity::error ? "error " : "warning ";
    text += std::to_string(static_cast<uint32_t>(fault.id));
    if (!fault.where.empty()) text += " at " + fault.where;
    text += ": " + fault.what;
    if (!fault.remedy.empty()) text += " " + fault.remedy;
    return text;
}

std::string shortest(double value) {
    char buffer[32];
    const std::to_chars_result end = std::to_chars(buffer, buffer + sizeof buffer, value);
    return {buffer, end.ptr};
}

} // namespace lr
