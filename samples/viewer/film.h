/* Pictures to files, and films: numbered PNGs, or a pipe to ffmpeg.    SPDX-License-Identifier: MIT */
#ifndef VIEWER_FILM_H
#define VIEWER_FILM_H

#include <stddef.h>
#include <stdio.h>
#include <sys/types.h>

/* Opens the first of viewer_001.ENDING to viewer_999.ENDING that does not exist. path: receives its name. */
FILE* new_file(const char* ending, char* path, size_t size);

/* Writes under another name and renames, so that no half-written file stays. Fails with a message. */
void film_write_png(const char* path, const unsigned char* rgb, int width, int height);

typedef struct film {
    const char* path;
    int numbered; /* path has a %d; otherwise ffmpeg writes the file */
    int width, height, pipe;
    unsigned number;
    pid_t ffmpeg;
} film;

/* Whether a path is for numbered pictures: one %d or %0Nd, and no other %. */
int film_is_numbered(const char* path);

/* Begins a film. Fails with a message if ffmpeg is needed and missing. */
void film_begin(film* f, const char* path, int width, int height, int fps);
void film_add(film* f, const unsigned char* rgb);

/* Fails with a message if ffmpeg failed. */
void film_end(film* f);

#endif
