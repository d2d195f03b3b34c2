// Each function writes figure_N.png into the output folder and adds its numbers. Throws Failure.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "figure_numbers.h"
#include "options.h"

void figure_2(const Options& options, Numbers& numbers);
void figure_3(const Options& options, const std::string& part, Numbers& numbers); // "3a" or "3b"
void figure_4(const Options& options, Numbers& numbers);
void figure_5(const Options& options, Numbers& numbers);
void table_2(const Options& options, Numbers& numbers); // no picture
