// A run-time failure with its remedy: ends the program with exit code 2.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <stdexcept>
#include <string>

#include "langevin_rigid.h"

struct Failure : std::runtime_error {
    Failure(const std::string& what, std::string what_to_do)
        : std::runtime_error(what), remedy(std::move(what_to_do)) {}
    std::string remedy; // may be empty
};

inline void check(lr_status status, const std::string& what, const std::string& remedy = "") {
    if (status != LR_OK) {
        throw Failure(what + ": " + lr_status_string(status) + " (status " + std::to_string(status) + ")", remedy);
    }
}

inline void tell(const char* program, const Failure& failure) {
    std::fprintf(stderr, "%s: %s\n", program, failure.what());
    if (!failure.remedy.empty()) std::fprintf(stderr, "%s: what to do: %s\n", program, failure.remedy.c_str());
}
