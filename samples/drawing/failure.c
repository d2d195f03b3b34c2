/* SPDX-License-Identifier: MIT */
#include "failure.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

void (*fail_hook)(const char* remedy, const char* what);

void fail(const char* remedy, const char* format, ...) {
    char what[3000];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    if (fail_hook) fail_hook(remedy, what);
    fprintf(stderr, "viewer: %s\n", what);
    if (remedy) fprintf(stderr, "viewer: what to do: %s\n", remedy);
    exit(EXIT_FAILED);
}

void fail_usage(const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    fputs("viewer: ", stderr);
    vfprintf(stderr, format, arguments);
    fputs("\nviewer: what to do: viewer --help lists the options\n", stderr);
    va_end(arguments);
    exit(EXIT_USAGE);
}

void check(lr_status status, const char* what, const char* remedy) {
    if (status != LR_OK) fail(remedy, "%s: %s (status %d)", what, lr_status_string(status), status);
}

void* allocate(size_t count, size_t size) {
    void* memory = calloc(count ? count : 1, size);
    if (!memory) fail("try a smaller --count", "out of memory");
    return memory;
}

void* grow(void* memory, size_t count, size_t size) {
    void* larger = count <= SIZE_MAX / size ? realloc(memory, count * size) : NULL;
    if (!larger) fail("try a smaller --count", "out of memory");
    return larger;
}
