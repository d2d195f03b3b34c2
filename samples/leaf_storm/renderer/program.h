// SPDX-License-Identifier: MIT
#pragma once

#include <string>

// Compiles and links. Throws Failure with the compiler's message.
unsigned make_program(const char* name, const std::string& vertex, const std::string& fragment);
