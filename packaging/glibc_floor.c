/*
 * SPDX-License-Identifier: MIT
 *
 * Redirects symbols that got new versions after glibc 2.30, most in 2.34, which merged libpthread into libc, to their old versions. A
 * linker binds a name to the current version of its own glibc, and older systems refuse the result. --wrap redirects all
 * references to this file, also those of the static C++ runtime (cmake/self_contained.cmake). packaging/glibc_floor.sh measures the
 * result.
 */
#define _GNU_SOURCE
#include <link.h>
#include <math.h>
#include <pthread.h>
#include <signal.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/stat.h>
#include <time.h>

/* The glibc version of each architecture's first port, and its version number of stat(). */
#if defined(__x86_64__)
#define FIRST "GLIBC_2.2.5"
#define WITH_OPENAT "GLIBC_2.4"
#define STAT_VERSION 1
#elif defined(__aarch64__)
#define FIRST "GLIBC_2.17"
#define WITH_OPENAT FIRST
#define STAT_VERSION 0
#else
#error "define FIRST as the first glibc version of this architecture"
#endif

/* Declares old_NAME, bound to the given version. */
#define OLD(version, result, name, parameters)                                                                         \
    __asm__(".symver old_" #name "," #name "@" version);                                                               \
    extern result old_##name parameters

/* Defines the target of every reference to NAME: a call of the old version. */
#define AS_BEFORE(version, result, name, parameters, arguments)                                                        \
    OLD(version, result, name, parameters);                                                                            \
    result __wrap_##name parameters;                                                                                   \
    result __wrap_##name parameters {                                                                                  \
        return old_##name arguments;                                                                                   \
    }

typedef void* (*thread_main)(void*);
typedef void (*release_fn)(void*);
typedef void (*once_fn)(void);

AS_BEFORE(FIRST, int, pthread_create,
          (pthread_t * thread, const pthread_attr_t* attributes, thread_main run, void* argument),
          (thread, attributes, run, argument))
AS_BEFORE(FIRST, int, pthread_join, (pthread_t thread, void** result), (thread, result))
AS_BEFORE(FIRST, int, pthread_once, (pthread_once_t * control, once_fn run), (control, run))
AS_BEFORE(FIRST, int, pthread_detach, (pthread_t thread), (thread))
AS_BEFORE(FIRST, int, pthread_key_create, (pthread_key_t * key, release_fn release), (key, release))
AS_BEFORE(FIRST, int, __pthread_key_create, (pthread_key_t * key, release_fn release), (key, release))
AS_BEFORE(FIRST, int, pthread_key_delete, (pthread_key_t key), (key))
AS_BEFORE(FIRST, void*, pthread_getspecific, (pthread_key_t key), (key))
AS_BEFORE(FIRST, int, pthread_setspecific, (pthread_key_t key, const void* value), (key, value))
AS_BEFORE(FIRST, int, pthread_sigmask, (int how, const sigset_t* set, sigset_t* before), (how, set, before))
AS_BEFORE(FIRST, int, pthread_mutex_trylock, (pthread_mutex_t * mutex), (mutex))
AS_BEFORE(FIRST, double, hypot, (double x, double y), (x, y))
AS_BEFORE("GLIBC_2.30", int, pthread_cond_clockwait,
          (pthread_cond_t * condition, pthread_mutex_t* mutex, clockid_t clock, const struct timespec* until),
          (condition, mutex, clock, until))

/* Before 2.33 these had a version argument, and programs contained the functions that called them. */
OLD(FIRST, int, __xstat, (int version, const char* path, struct stat* info));
OLD(FIRST, int, __lxstat, (int version, const char* path, struct stat* info));
OLD(FIRST, int, __fxstat, (int version, int file, struct stat* info));
OLD(WITH_OPENAT, int, __fxstatat, (int version, int folder, const char* path, struct stat* info, int flags));

int __wrap_stat(const char* path, struct stat* info);
int __wrap_stat(const char* path, struct stat* info) {
    return old___xstat(STAT_VERSION, path, info);
}
int __wrap_lstat(const char* path, struct stat* info);
int __wrap_lstat(const char* path, struct stat* info) {
    return old___lxstat(STAT_VERSION, path, info);
}
int __wrap_fstat(int file, struct stat* info);
int __wrap_fstat(int file, struct stat* info) {
    return old___fxstat(STAT_VERSION, file, info);
}
/* The same under the large file names; on these systems all files are large files. */
int __wrap_stat64(const char* path, struct stat* info);
int __wrap_stat64(const char* path, struct stat* info) {
    return old___xstat(STAT_VERSION, path, info);
}
int __wrap_fstat64(int file, struct stat* info);
int __wrap_fstat64(int file, struct stat* info) {
    return old___fxstat(STAT_VERSION, file, info);
}
int __wrap_fstatat(int folder, const char* path, struct stat* info, int flags);
int __wrap_fstatat(int folder, const char* path, struct stat* info, int flags) {
    return old___fxstatat(STAT_VERSION, folder, path, info, flags);
}

/* With one thread, libstdc++ counts references without atomic operations. This value makes it always use them. */
extern char __wrap___libc_single_threaded;
char __wrap___libc_single_threaded = 0;

/* Before 2.34 a program called its own constructors, in a function that it passed to this one. */
typedef void (*constructor)(int, char**, char**);
typedef int (*program)(int, char**, char**);
extern constructor __preinit_array_start[], __preinit_array_end[], __init_array_start[], __init_array_end[];
OLD(FIRST, int, __libc_start_main,
    (program run, int count, char** arguments, constructor init, once_fn fini, once_fn linker, void* stack));

static void construct(int count, char** arguments, char** environment) {
    for (constructor* each = __preinit_array_start; each != __preinit_array_end; ++each)
        (*each)(count, arguments, environment);
    for (constructor* each = __init_array_start; each != __init_array_end; ++each)
        (*each)(count, arguments, environment);
}

int __wrap___libc_start_main(program run, int count, char** arguments, constructor init, once_fn fini, once_fn linker,
                             void* stack);
int __wrap___libc_start_main(program run, int count, char** arguments, constructor init, once_fn fini, once_fn linker,
                             void* stack) {
    (void)init;
    return old___libc_start_main(run, count, arguments, construct, fini, linker, stack);
}

/* Finds the unwind tables in memory: GCC's unwinder calls it for each exception. */
struct search {
    uintptr_t address;
    struct dl_find_object* result;
};

static int look_in(struct dl_phdr_info* object, size_t size, void* user) {
    const struct search* search = user;
    const ElfW(Phdr)* tables = NULL;
    uintptr_t begin = UINTPTR_MAX, end = 0;
    int holds_it = 0;
    (void)size;
    for (int i = 0; i < object->dlpi_phnum; ++i) {
        const ElfW(Phdr)* segment = &object->dlpi_phdr[i];
        if (segment->p_type == PT_GNU_EH_FRAME) tables = segment;
        if (segment->p_type != PT_LOAD) continue;
        const uintptr_t first = object->dlpi_addr + segment->p_vaddr, last = first + segment->p_memsz;
        if (first < begin) begin = first;
        if (last > end) end = last;
        holds_it |= search->address >= first && search->address < last;
    }
    if (!holds_it || tables == NULL) return 0;
    search->result->dlfo_flags = 0;
    search->result->dlfo_map_start = (void*)begin;
    search->result->dlfo_map_end = (void*)end;
    search->result->dlfo_link_map = NULL;
    search->result->dlfo_eh_frame = (void*)(object->dlpi_addr + tables->p_vaddr);
    return 1;
}

int __wrap__dl_find_object(void* address, struct dl_find_object* result);
int __wrap__dl_find_object(void* address, struct dl_find_object* result) {
    struct search search = {(uintptr_t)address, result};
    return dl_iterate_phdr(look_in, &search) == 1 ? 0 : -1;
}
