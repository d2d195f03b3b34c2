// Checks a Collada file before assimp reads it: version 5.2 reads past the end of arrays that are shorter than their accessors,
// and loops forever on a face list with a character that is not part of a number.
#pragma once

#include "asset/input_faults.h"

#include <string_view>

namespace lr::baker {

bool is_collada(std::string_view text);
bool check_collada(std::string_view text, Faults& faults);
} // namespace lr::baker
