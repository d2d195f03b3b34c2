#include "asset/asset.h"

#if defined(LR_NO_OS)
lr_status lr::read_asset_bytes(const char*, std::vector<unsigned char>&) {
    return LR_ERROR_UNSUPPORTED;
}
#else
#include <algorithm>
#include <cerrno>
#include <cstddef>

#include <fcntl.h>
#if defined(_WIN32)
#define WIN32_LEAN_AND_MEAN
#include <io.h>
#include <string>
#include <windows.h>
#define LR_POSIX(function) ::_##function // without the underscore MSVC warns
#else
#include <sys/stat.h>
#include <unistd.h>
#define LR_POSIX(function) ::function
#endif

namespace lr {
namespace {

constexpr size_t max_bytes = size_t{1} << 30;

// reason: errno.
lr_status status_of(int reason) {
    switch (reason) {
    case ENOENT:
    case ENOTDIR:
        return LR_ERROR_FILE_NOT_FOUND;
    case ENOMEM:
        return LR_ERROR_OUT_OF_MEMORY;
    default:
        return LR_ERROR_FILE_READ;
    }
}

struct Descriptor {
    int fd;
    ~Descriptor() {
        if (fd >= 0) LR_POSIX(close)(fd);
    }
};

// Negative with errno set.
int open_file(const char* path_utf8) {
#if defined(_WIN32)
    const int length = MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, path_utf8, -1, nullptr, 0);
    if (length <= 0) return -1;
    std::wstring wide(static_cast<size_t>(length), L'\0');
    MultiByteToWideChar(CP_UTF8, 0, path_utf8, -1, wide.data(), length);
    return ::_wopen(wide.c_str(), _O_RDONLY | _O_BINARY | _O_NOINHERIT);
#else
    for (;;) {
        const int fd = ::open(path_utf8, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
        if (fd >= 0 || errno != EINTR) return fd;
    }
#endif
}
} // namespace

lr_status read_asset_bytes(const char* path_utf8, std::vector<unsigned char>& out) {
    errno = 0;
    const Descriptor file{open_file(path_utf8)};
    if (file.fd < 0) return status_of(errno);
    size_t expected = 0;
#if !defined(_WIN32) && !defined(__wasm__)
    struct stat info {};
    if (::fstat(file.fd, &info) != 0 || !S_ISREG(info.st_mode)) return LR_ERROR_FILE_READ;
    if (info.st_size > static_cast<off_t>(max_bytes)) return LR_ERROR_ASSET_CORRUPT;
    expected = static_cast<size_t>(info.st_size); // a hint: it can be wrong (/proc) or change
#endif
    size_t size = 0;
    out.resize(std::max<size_t>(expected, 4096) + 1);
    for (;;) {
        const auto room = static_cast<unsigned>(out.size() - size); // the type that Windows takes
        const auto got = LR_POSIX(read)(file.fd, out.data() + size, room);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return status_of(errno);
        if (got == 0) break;
        size += static_cast<size_t>(got);
        if (size > max_bytes) return LR_ERROR_ASSET_CORRUPT;
        if (size == out.size()) out.resize(std::min(2 * size, max_bytes + 1));
    }
    out.resize(size);
    return LR_OK;
}
} // namespace lr
#endif
