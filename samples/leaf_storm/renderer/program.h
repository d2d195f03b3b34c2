// SPDX-License-Identifier: MIT
#pragma once

#include <string>

// Compiles and links; throws Failure with the compiler's words.
unsigned make_program(const char* name, const std::string& vertex, const std::string& fragment);
