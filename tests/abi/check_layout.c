/*
 * SPDX-License-Identifier: MIT
 *
 * Compiling this is the test, on any target: the header has every struct of a released version, with the same size or larger,
 * and with all its fields at the same offsets.
 *   cc -std=c99 -fsyntax-only -I include '-DLR_LAYOUT="VERSION/layout.txt"' tests/abi/check_layout.c
 */
#include "langevin_rigid_research.h"

#include <stddef.h>

#define HERE(wide, narrow) (sizeof(void*) == 8 ? (size_t)(wide) : (size_t)(narrow))
#define ALIGNMENT(type)                                                                                                \
    offsetof(                                                                                                          \
        struct {                                                                                                       \
            char first;                                                                                                \
            type second;                                                                                               \
        },                                                                                                             \
        second)
/* The compiler's message names the broken field: an array of negative size. */
#define CHECK(name, condition) extern char name[(condition) ? 1 : -1]

#define GROWS(type, size, alignment, narrow, narrow_alignment)                                                         \
    CHECK(size_of_##type, sizeof(type) >= HERE(size, narrow));                                                         \
    CHECK(alignment_of_##type, ALIGNMENT(type) == HERE(alignment, narrow_alignment));
#define OURS GROWS
#define FIXED(type, size, alignment, narrow, narrow_alignment)                                                         \
    CHECK(size_of_##type, sizeof(type) == HERE(size, narrow));                                                         \
    CHECK(alignment_of_##type, ALIGNMENT(type) == HERE(alignment, narrow_alignment));
#define FIELD(type, field, offset, size, narrow_offset, narrow_size)                                                   \
    CHECK(offset_of_##type##_##field, offsetof(type, field) == HERE(offset, narrow_offset));                           \
    CHECK(size_of_##type##_##field, sizeof(((type*)0)->field) == HERE(size, narrow_size));

#include LR_LAYOUT
