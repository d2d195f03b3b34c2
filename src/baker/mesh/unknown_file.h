// Messages for a file that no reader reads: a sentence about its content, and one about a remedy.
#pragma once

#include <string>
#include <string_view>

namespace lr::baker {

struct UnknownFile {
    std::string what, remedy;
};

// bytes: of the file; extension: in small letters, without the dot; reason: in the words of the importer.
UnknownFile explain_unknown_file(std::string_view bytes, const std::string& extension, const std::string& reason);

// Text in UTF-16 (with its byte order mark), as some Windows programs save it, as UTF-8; other text stays, without the mark
// of UTF-8. `storage` keeps the new text.
std::string_view as_utf8(std::string_view bytes, std::string& storage);
} // namespace lr::baker
