#include "asset/asset.h"

#if defined(LR_NO_OS)
lr_status lr::read_asset_bytes(const char*, std::vector<unsigned char>&) {
    return LR_ERROR_UNSUPPORTED;
}
#else
#include <algorithm>
#include <cerrno>
#include <cstddef>

#if defined(_WIN32) || defined(__wasm__)
#include <cstdio>
#include <memory>
#else
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#endif
#if defined(_WIN32)
#define WIN32_LEAN_AND_MEAN
#include <windows.h>
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

// read(to, room): bytes, 0 at the end, negative with errno set.
template <class Read> lr_status read_all(std::vector<unsigned char>& out, size_t expected, const Read& read) {
    size_t size = 0;
    out.resize(std::clamp<size_t>(expected, 4096, max_bytes) + 1);
    for (;;) {
        const auto got = read(out.data() + size, out.size() - size);
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

#if defined(_WIN32) || defined(__wasm__)
std::FILE* open_utf8(const char* path) {
#if defined(_WIN32)
    const int length = MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, path, -1, nullptr, 0);
    if (length <= 0) return nullptr;
    std::wstring wide(static_cast<size_t>(length), L'\0');
    MultiByteToWideChar(CP_UTF8, 0, path, -1, wide.data(), length);
    return _wfopen(wide.c_str(), L"rb");
#else
    return std::fopen(path, "rb");
#endif
}
#else
struct Descriptor {
    int fd;
    ~Descriptor() {
        if (fd >= 0) ::close(fd);
    }
};

int open_file(const char* path) {
    for (;;) {
        const int fd = ::open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
        if (fd >= 0 || errno != EINTR) return fd;
    }
}
#endif
} // namespace

#if defined(_WIN32) || defined(__wasm__)
lr_status read_asset_bytes(const char* path_utf8, std::vector<unsigned char>& out) {
    errno = 0;
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(open_utf8(path_utf8), &std::fclose);
    if (!file) return status_of(errno);
    return read_all(out, 0, [&](unsigned char* to, size_t room) -> ptrdiff_t {
        const size_t got = std::fread(to, 1, room, file.get());
        if (got != 0 || !std::ferror(file.get())) return static_cast<ptrdiff_t>(got);
        errno = EIO;
        return -1;
    });
}
#else
lr_status read_asset_bytes(const char* path_utf8, std::vector<unsigned char>& out) {
    const Descriptor file{open_file(path_utf8)};
    if (file.fd < 0) return status_of(errno);
    struct stat info {};
    if (::fstat(file.fd, &info) != 0 || !S_ISREG(info.st_mode)) return LR_ERROR_FILE_READ;
    if (info.st_size > static_cast<off_t>(max_bytes)) return LR_ERROR_ASSET_CORRUPT;
    // A smaller size is only a hint: it can be wrong (/proc) or change.
    return read_all(out, static_cast<size_t>(std::clamp<off_t>(info.st_size, 0, max_bytes)),
                    [&](unsigned char* to, size_t room) { return ::read(file.fd, to, room); });
}
#endif
} // namespace lr
#endif
