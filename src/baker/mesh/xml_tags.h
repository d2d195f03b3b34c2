// The start tags of an XML text, one after the other: enough to check Collada and to read 3MF.
#pragma once

#include <optional>
#include <string_view>

namespace lr::baker {

struct XmlTag {
    std::string_view name; // of a start tag; empty for other tags
    std::string_view attributes;
    std::string_view content; // up to the next tag
    std::size_t at = 0;
};

// Reads the tag at `at`, which points to its '<', and moves behind it. False if it does not end.
bool next_tag(std::string_view text, std::size_t& at, XmlTag& tag);

std::optional<std::string_view> attribute(const XmlTag& tag, std::string_view name);
} // namespace lr::baker
