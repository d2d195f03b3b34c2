#include "baker/printable_text.h"

#include <cstddef>
#include <cstdint>

namespace lr::baker {
namespace {

// Length of the UTF-8 character at the start of `text` in bytes; 0 if invalid, also for overlong forms and surrogates.
std::size_t character_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    const std::size_t length = first < 0x80   ? 1
                               : first < 0xc2 ? 0
                               : first < 0xe0 ? 2
                               : first < 0xf0 ? 3
                               : first < 0xf5 ? 4
                                              : 0;
    if (length == 0 || length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    if ((first == 0xe0 && byte(1) < 0xa0) || (first == 0xed && byte(1) > 0x9f)) return 0;
    if ((first == 0xf0 && byte(1) < 0x90) || (first == 0xf4 && byte(1) > 0x8f)) return 0;
    return length;
}

template <class Keep> std::string filter(std::string_view text, const char* instead, const Keep& keep) {
    std::string result;
    while (!text.empty()) {
        const std::size_t length = character_length(text);
        const std::string_view character = text.substr(0, length == 0 ? 1 : length);
        if (length != 0 && keep(character))
            result += character;
        else
            result += instead;
        text.remove_prefix(character.size());
    }
    return result;
}
} // namespace

std::string valid_utf8(std::string_view text) {
    return filter(text, "\xef\xbf\xbd", [](std::string_view) { return true; });
}

std::string printable(std::string_view text) {
    return filter(text, "?", [](std::string_view character) {
        const auto first = static_cast<unsigned char>(character[0]);
        const bool c1 = first == 0xc2 && static_cast<unsigned char>(character[1]) < 0xa0;
        return first >= 0x20 && first != 0x7f && !c1;
    });
}
} // namespace lr::baker
