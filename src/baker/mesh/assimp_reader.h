// Reads formats without a reader of our own through assimp.
#pragma once

#include "baker/mesh/input_files.h"
#include "baker/mesh/obj_reader.h"

#include <string>

namespace lr::baker {

struct SceneFile {
    std::string where;                 // for faults
    const std::string* path = nullptr; // null: read from memory
    InputFiles* files = nullptr;       // with a path: reads the file and the files that it refers to
    const void* bytes = nullptr;
    std::size_t size = 0;
    std::string extension;
    // Collada: names objects by id instead of by name, since assimp keeps only one of the two.
    bool collada_ids = false;
};

// Applies node transforms; keeps the unit and axes of the file.
bool read_with_assimp(const SceneFile& file, PolygonSoup& soup, Faults& faults);
} // namespace lr::baker
