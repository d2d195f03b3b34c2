#include "support/system_faults.h"

#if defined(__linux__)

#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdarg>
#include <cstdio>

namespace test {
SystemFaults* system_faults = nullptr;
}

namespace {

using test::system_faults;

template <class F> F next(const char* name) {
    return reinterpret_cast<F>(dlsym(RTLD_NEXT, name));
}

// Whether this call fails, with errno set.
bool fails() {
    test::SystemFaults* const f = system_faults;
    if (!f) return false;
    const int call = f->calls++;
    if (call != f->fail_at && !(f->fail_after && f->fail_at >= 0 && call > f->fail_at)) return false;
    if (f->reason == 0) raise(SIGKILL);
    errno = f->reason;
    return true;
}

} // namespace

// Visible to the shared library.
#pragma GCC visibility push(default)
extern "C" {

int open(const char* path, int flags, ...) {
    mode_t mode = 0;
    const bool makes = (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE;
    if (makes) {
        va_list arguments;
        va_start(arguments, flags);
        mode = va_arg(arguments, mode_t);
        va_end(arguments);
        if (fails()) return -1;
        if ((flags & O_TMPFILE) == O_TMPFILE && system_faults && system_faults->without_nameless) {
            errno = EOPNOTSUPP;
            return -1;
        }
    }
    return next<int (*)(const char*, int, mode_t)>("open")(path, flags, mode);
}

ssize_t read(int fd, void* to, size_t size) {
    test::SystemFaults* const f = system_faults;
    if (f && f->most != SIZE_MAX) {
        if (f->interrupted && f->reads++ % 2 == 0) {
            errno = EINTR;
            return -1;
        }
        if (f->ends_after == 0) {
            errno = f->broken_by;
            return f->broken_by == 0 ? 0 : -1;
        }
        size = std::min({size, f->most, f->ends_after});
        if (f->ends_after != SIZE_MAX) f->ends_after -= size;
    }
    return next<ssize_t (*)(int, void*, size_t)>("read")(fd, to, size);
}

ssize_t write(int fd, const void* from, size_t size) {
    if (fails()) return -1;
    if (system_faults && system_faults->short_writes) {
        if (system_faults->calls % 2 == 0) {
            errno = EINTR;
            return -1;
        }
        size = (size + 1) / 2;
    }
    return next<ssize_t (*)(int, const void*, size_t)>("write")(fd, from, size);
}

int fchmod(int fd, mode_t mode) noexcept {
    return fails() ? -1 : next<int (*)(int, mode_t)>("fchmod")(fd, mode);
}
int fsync(int fd) {
    return fails() ? -1 : next<int (*)(int)>("fsync")(fd);
}
int linkat(int from_in, const char* from, int to_in, const char* to, int flags) noexcept {
    return fails() ? -1
                   : next<int (*)(int, const char*, int, const char*, int)>("linkat")(from_in, from, to_in, to, flags);
}
int rename(const char* from, const char* to) noexcept {
    return fails() ? -1 : next<int (*)(const char*, const char*)>("rename")(from, to);
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*), void* argument) noexcept {
    if (system_faults && system_faults->threads_allowed >= 0 && system_faults->threads_allowed-- == 0) {
        system_faults->threads_allowed = 0;
        return EAGAIN;
    }
    return next<int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*)>("pthread_create")(
        thread, attributes, run, argument);
}

} // extern "C"
#pragma GCC visibility pop

#endif
