// Looks a Collada file over before assimp does: version 5.2 reads past the end of arrays that are shorter than what
// refers to them, and never ends on a face list with a character that is not a number's.
#pragma once

#include "asset/input_faults.h"

#include <string_view>

namespace lr::baker {

bool is_collada(std::string_view text);
bool check_collada(std::string_view text, Faults& faults);

} // namespace lr::baker
