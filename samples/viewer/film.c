/* SPDX-License-Identifier: MIT */
#include "film.h"

#include <errno.h>
#include <fcntl.h>
#include <png.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "drawing/failure.h"

static const char* const folder_remedy = "check that the folder exists, has room, and that you may write to it";

FILE* new_file(const char* ending, char* path, size_t size) {
    for (int number = 1; number < 1000; ++number) {
        snprintf(path, size, "viewer_%03d.%s", number, ending);
        FILE* file = fopen(path, "wbx");
        if (file) return file;
        if (errno != EEXIST) fail(folder_remedy, "cannot write %s: %s", path, strerror(errno));
    }
    fail("remove or rename some", "viewer_001.%s to viewer_999.%s are all taken", ending, ending);
}

void film_write_png(const char* path, const unsigned char* rgb, int width, int height) {
    png_image image;
    memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    image.width = (png_uint_32)width;
    image.height = (png_uint_32)height;
    image.format = PNG_FORMAT_RGB;
    char aside[1100];
    struct stat status;
    /* Write directly to a device or through a link. */
    const int plain = lstat(path, &status) != 0 || S_ISREG(status.st_mode);
    snprintf(aside, sizeof aside, plain ? "%s.part-%ld" : "%s", path, (long)getpid());
    FILE* file = fopen(aside, "wb");
    if (!file) fail(folder_remedy, "cannot write %s: %s", path, strerror(errno));
    const int written = png_image_write_to_stdio(&image, file, 0, rgb, 0, NULL);
    const int flushed = fclose(file) == 0;
    if (!written || !flushed || (plain && rename(aside, path) != 0)) {
        const int reason = errno;
        if (plain) remove(aside);
        fail(folder_remedy, "cannot write all of %s: %s", path, written ? strerror(reason) : image.message);
    }
}

int film_is_numbered(const char* path) {
    const char* at = strchr(path, '%');
    if (!at || strchr(at + 1, '%')) return 0;
    ++at;
    while (*at >= '0' && *at <= '9') ++at;
    return *at == 'd';
}

static void start_ffmpeg(film* f, int fps) {
    char size[32], rate[16], output[1100];
    snprintf(size, sizeof size, "%dx%d", f->width, f->height);
    snprintf(rate, sizeof rate, "%d", fps);
    snprintf(output, sizeof output, "file:%s", f->path);
    char* const arguments[] = {"ffmpeg", "-loglevel", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s",
                               size,     "-r",        rate,    "-i", "-",  "-pix_fmt", "yuv420p",  output,  NULL};
    int ends[2], told[2]; /* told: its end is closed when ffmpeg has started, or receives the reason why not */
    if (pipe(ends) != 0 || pipe(told) != 0) fail(NULL, "no pipe to ffmpeg: %s", strerror(errno));
    fflush(NULL);
    f->ffmpeg = fork();
    if (f->ffmpeg < 0) fail(NULL, "cannot start ffmpeg: %s", strerror(errno));
    if (f->ffmpeg == 0) {
        dup2(ends[0], STDIN_FILENO);
        close(ends[0]);
        close(ends[1]);
        close(told[0]);
        fcntl(told[1], F_SETFD, FD_CLOEXEC);
        execvp(arguments[0], arguments);
        const int reason = errno;
        const ssize_t ignored = write(told[1], &reason, sizeof reason);
        _exit(ignored < 0 ? 126 : 127);
    }
    close(ends[0]);
    close(told[1]);
    int reason = 0;
    const ssize_t said = read(told[0], &reason, sizeof reason);
    close(told[0]);
    if (said > 0) {
        waitpid(f->ffmpeg, NULL, 0);
        fail("install ffmpeg, or use a --png name with %04d for numbered pictures", "no film %s: ffmpeg: %s", f->path,
             strerror(reason));
    }
    signal(SIGPIPE, SIG_IGN);
    f->pipe = ends[1];
}

void film_begin(film* f, const char* path, int width, int height, int fps) {
    memset(f, 0, sizeof *f);
    f->path = path, f->width = width, f->height = height;
    f->numbered = film_is_numbered(path);
    if (!f->numbered) start_ffmpeg(f, fps);
}

static void finish_ffmpeg(film* f) {
    int status = 0;
    close(f->pipe);
    waitpid(f->ffmpeg, &status, 0);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        fail("read ffmpeg's message above; width and height must be even", "ffmpeg could not make %s", f->path);
}

void film_add(film* f, const unsigned char* rgb) {
    if (f->numbered) {
        char path[1024];
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
        snprintf(path, sizeof path, f->path, f->number++); /* film_is_numbered has checked it */
#pragma GCC diagnostic pop
        film_write_png(path, rgb, f->width, f->height);
        return;
    }
    size_t left = 3 * (size_t)f->width * (size_t)f->height;
    while (left > 0) {
        const ssize_t done = write(f->pipe, rgb, left);
        if (done < 0 && errno == EINTR) continue;
        if (done <= 0) {
            finish_ffmpeg(f);
            fail(NULL, "ffmpeg ended before the film %s did", f->path);
        }
        rgb += done;
        left -= (size_t)done;
    }
    ++f->number;
}

void film_end(film* f) {
    if (!f->numbered) finish_ffmpeg(f);
}
