#include "baker/mesh/xml_tags.h"

#include <algorithm>
#include <array>

namespace lr::baker {

std::optional<std::string_view> attribute(const XmlTag& tag, std::string_view name) {
    std::string_view rest = tag.attributes;
    while (true) {
        const std::size_t begin = rest.find_first_not_of(" \t\r\n");
        if (begin == std::string_view::npos) return std::nullopt;
        rest.remove_prefix(begin);
        const std::size_t quote = rest.find_first_of("\"'");
        if (quote == std::string_view::npos) return std::nullopt;
        const std::size_t end = rest.find(rest[quote], quote + 1);
        if (end == std::string_view::npos) return std::nullopt;
        const std::string_view key = rest.substr(0, rest.find_first_of("= \t\r\n"));
        if (key == name) return rest.substr(quote + 1, end - quote - 1);
        rest.remove_prefix(end + 1);
    }
}

bool next_tag(std::string_view text, std::size_t& at, XmlTag& tag) {
    constexpr std::array<std::array<std::string_view, 2>, 3> special = {
        {{"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}}};
    for (const auto& [open, close] : special)
        if (text.substr(at, open.size()) == open) {
            const std::size_t end = text.find(close, at + open.size());
            if (end == std::string_view::npos) return false;
            at = end + close.size();
            return true;
        }
    std::size_t end = at + 1;
    char quote = 0;
    for (; end < text.size() && (quote != 0 || text[end] != '>'); ++end) {
        const char c = text[end];
        if (quote != 0)
            quote = c == quote ? '\0' : quote;
        else if (c == '"' || c == '\'')
            quote = c;
    }
    if (end >= text.size()) return false;
    const std::string_view inside = text.substr(at + 1, end - at - 1);
    tag.at = at;
    if (!inside.empty() && inside.front() != '/' && inside.front() != '!') {
        const std::size_t name_end = std::min(inside.find_first_of(" \t\r\n/"), inside.size());
        tag.name = inside.substr(0, name_end);
        tag.attributes = inside.substr(name_end);
        if (inside.back() != '/') tag.content = text.substr(end + 1, text.find('<', end) - end - 1);
    }
    at = end + 1;
    return true;
}
} // namespace lr::baker
