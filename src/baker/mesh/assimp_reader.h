// Formats without a reader of our own, through assimp.
#pragma once

#include "baker/mesh/input_files.h"
#include "baker/mesh/obj_reader.h"

#include <string>

namespace lr::baker {

struct SceneFile {
    std::string where;                 // for faults
    const std::string* path = nullptr; // else from memory
    InputFiles* files = nullptr;       // with a path: through which it and what it refers to are read
    const void* bytes = nullptr;
    std::size_t size = 0;
    std::string extension;
    // Collada has ids beside names; assimp hands over one kind of them.
    bool collada_ids = false;
};

// Node transforms are applied, in the unit and the axes of the file.
bool read_with_assimp(const SceneFile& file, PolygonSoup& soup, Faults& faults);

} // namespace lr::baker
