/* Run-time failures with their remedy: ends the program.    SPDX-License-Identifier: MIT */
#ifndef DRAWING_FAILURE_H
#define DRAWING_FAILURE_H

#include <langevin_rigid.h>
#include <stddef.h>

#define EXIT_USAGE 1
#define EXIT_FAILED 2

#ifdef __cplusplus
#define NO_RETURN [[noreturn]]
extern "C" {
#else
#define NO_RETURN _Noreturn
#endif

/* If set, gets failures instead of stderr, and does not return: a C++ program throws. remedy: may be null. */
extern void (*fail_hook)(const char* remedy, const char* what);

/* Both print to stderr and exit. remedy: may be null. */
NO_RETURN void fail(const char* remedy, const char* format, ...) __attribute__((format(printf, 2, 3)));
NO_RETURN void fail_usage(const char* format, ...) __attribute__((format(printf, 1, 2)));

/* Fails if the status is an error. */
void check(lr_status status, const char* what, const char* remedy);

/* Allocates zeroed memory, or ends the program. */
void* allocate(size_t count, size_t size);
void* grow(void* memory, size_t count, size_t size);

#ifdef __cplusplus
}
#endif

#endif
