// All of the shim, and its functions for tests. SPDX-License-Identifier: MIT
#pragma once

#include "editor.h"
#include "niagara.h"

#include <string>
#include <vector>

/** Lines logged since the last call: "Category: Verbosity: text". */
std::vector<std::string> ShimTakeLog();
