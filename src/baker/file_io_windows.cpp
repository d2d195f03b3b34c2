// SPDX-License-Identifier: MIT
#include "baker/file_faults.h"
#include "baker/file_io.h"
#include "baker/hold_signals.h"
#include "baker/windows_text.h"

#include <algorithm>
#include <filesystem>
#include <optional>

namespace lr::baker {
namespace {

int reason_of(DWORD error) {
    switch (error) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_INVALID_DRIVE:
    case ERROR_BAD_NETPATH:
    case ERROR_BAD_NET_NAME:
        return ENOENT;
    case ERROR_INVALID_NAME:
    case ERROR_BAD_PATHNAME:
        return EINVAL;
    case ERROR_DIRECTORY:
        return ENOTDIR;
    case ERROR_ACCESS_DENIED:
    case ERROR_SHARING_VIOLATION:
    case ERROR_LOCK_VIOLATION:
        return EACCES;
    case ERROR_WRITE_PROTECT:
        return EROFS;
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL:
        return ENOSPC;
    case ERROR_FILE_EXISTS:
    case ERROR_ALREADY_EXISTS:
        return EEXIST;
    case ERROR_FILENAME_EXCED_RANGE:
        return ENAMETOOLONG;
    case ERROR_NOT_ENOUGH_MEMORY:
    case ERROR_OUTOFMEMORY:
        return ENOMEM;
    default:
        return EIO;
    }
}
int last_reason() {
    return reason_of(GetLastError());
}

class Handle {
public:
    explicit Handle(HANDLE handle) : handle_(handle) {}
    ~Handle() { close(); }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;

    HANDLE get() const { return handle_; }
    bool good() const { return handle_ != INVALID_HANDLE_VALUE; }
    bool close() {
        const HANDLE handle = std::exchange(handle_, INVALID_HANDLE_VALUE);
        return handle == INVALID_HANDLE_VALUE || CloseHandle(handle) != 0;
    }

private:
    HANDLE handle_;
};

constexpr DWORD share_all = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;

HANDLE open_existing(const std::wstring& path, DWORD access) {
    // FILE_FLAG_BACKUP_SEMANTICS also opens folders, which distinguishes them from files without read permission.
    return CreateFileW(path.c_str(), access, share_all, nullptr, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr);
}

bool is_folder(const std::wstring& path) {
    const DWORD attributes = GetFileAttributesW(path.c_str());
    return attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0;
}

bool is_slash(wchar_t c) {
    return c == L'/' || c == L'\\';
}

bool write_all(HANDLE file, std::span<const uint8_t> bytes) {
    while (!bytes.empty()) {
        const auto part = static_cast<DWORD>(std::min<std::size_t>(bytes.size(), std::size_t{1} << 24));
        DWORD written = 0;
        if (WriteFile(file, bytes.data(), part, &written, nullptr) == 0) return false;
        bytes = bytes.subspan(written);
    }
    return true;
}

enum class Target { absent, regular, direct, impossible };

// Follows symbolic links, so that their target is replaced and the links stay. reason: set for invalid links.
Target find_target(std::wstring& path, int& reason) {
    reason = ENOENT;
    if (path.empty()) return Target::impossible;
    const Handle file(open_existing(path, 0));
    if (!file.good()) {
        reason = last_reason();
        return reason == ENOENT && !is_slash(path.back()) ? Target::absent : Target::impossible;
    }
    if (GetFileType(file.get()) != FILE_TYPE_DISK) return Target::direct;
    BY_HANDLE_FILE_INFORMATION info{};
    if (GetFileInformationByHandle(file.get(), &info) != 0) {
        if ((info.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0) {
            reason = EISDIR;
            return Target::impossible;
        }
        if ((info.dwFileAttributes & FILE_ATTRIBUTE_READONLY) != 0) {
            reason = EACCES;
            return Target::impossible;
        }
    }
    const DWORD attributes = GetFileAttributesW(path.c_str());
    if (attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_REPARSE_POINT) != 0) {
        std::wstring real(32768, L'\0');
        const DWORD length =
            GetFinalPathNameByHandleW(file.get(), real.data(), static_cast<DWORD>(real.size()), FILE_NAME_NORMALIZED);
        if (length > 0 && length < real.size()) {
            real.resize(length);
            path = std::move(real);
        }
    }
    return Target::regular;
}

std::wstring folder_of(const std::wstring& path) {
    const std::size_t slash = path.find_last_of(L"/\\:");
    return slash == std::wstring::npos ? L"./" : path.substr(0, slash + 1);
}

// A temporary file in the target's folder, removed unless it is renamed.
class AsideFile {
public:
    AsideFile(std::string shown, std::wstring target) : shown_(std::move(shown)), target_(std::move(target)) {}
    ~AsideFile() {
        if (!name_.empty()) DeleteFileW(name_.c_str());
    }
    AsideFile(AsideFile&& other) noexcept
        : shown_(std::move(other.shown_)), target_(std::move(other.target_)), name_(std::exchange(other.name_, {})) {}
    AsideFile& operator=(AsideFile&&) = delete;

    bool stage(std::span<const uint8_t> bytes, Faults& faults) {
        Handle file(create());
        const bool good =
            file.good() && write_all(file.get(), bytes) && FlushFileBuffers(file.get()) != 0 && file.close();
        return good || cannot_write(faults, shown_, last_reason());
    }
    bool commit(Faults& faults) {
        if (MoveFileExW(name_.c_str(), target_.c_str(), MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH) == 0)
            return cannot_write(faults, shown_, last_reason());
        name_.clear();
        return true;
    }

private:
    HANDLE create() {
        for (int i = 0; i < 1000; ++i) {
            const std::wstring candidate = folder_of(target_) + L".lr_bake-" + std::to_wstring(GetCurrentProcessId()) +
                                           L"-" + std::to_wstring(i) + L".part";
            const HANDLE file =
                CreateFileW(candidate.c_str(), GENERIC_WRITE, 0, nullptr, CREATE_NEW, FILE_ATTRIBUTE_NORMAL, nullptr);
            if (file != INVALID_HANDLE_VALUE) {
                name_ = candidate;
                return file;
            }
            if (GetLastError() != ERROR_FILE_EXISTS) break;
        }
        return INVALID_HANDLE_VALUE;
    }

    std::string shown_;
    std::wstring target_, name_;
};

bool write_directly(const OutputFile& file, Faults& faults) {
    Handle out(open_existing(to_wide(file.path_utf8), GENERIC_WRITE));
    const bool good = out.good() && write_all(out.get(), file.bytes) && out.close();
    return good || cannot_write(faults, file.path_utf8, last_reason());
}

std::optional<BY_HANDLE_FILE_INFORMATION> information(const std::string& path) {
    const Handle file(open_existing(to_wide(path), 0));
    BY_HANDLE_FILE_INFORMATION info{};
    if (!file.good() || GetFileType(file.get()) != FILE_TYPE_DISK || GetFileInformationByHandle(file.get(), &info) == 0)
        return {};
    return info;
}
} // namespace

bool read_file(const std::string& path, std::size_t max_bytes, std::vector<uint8_t>& out, Faults& faults) {
    out.clear();
    const Handle in(open_existing(to_wide(path), GENERIC_READ));
    if (!in.good()) {
        const int reason = last_reason();
        if (reason == ENOENT || reason == ENOTDIR || reason == EINVAL) return no_such_file(faults, path);
        return cannot_read(faults, path, reason, "Check that you have the right to read it.");
    }
    BY_HANDLE_FILE_INFORMATION info{};
    if (GetFileType(in.get()) != FILE_TYPE_DISK || GetFileInformationByHandle(in.get(), &info) == 0 ||
        (info.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0)
        return not_a_file(faults, path);
    // The size is only a hint: it can change.
    const uint64_t hint = uint64_t{info.nFileSizeHigh} << 32 | info.nFileSizeLow;
    std::size_t size = 0;
    out.resize(std::clamp<std::size_t>(hint, 4096, max_bytes) + 1);
    for (;;) {
        const auto room = static_cast<DWORD>(std::min<std::size_t>(out.size() - size, std::size_t{1} << 24));
        DWORD n = 0;
        if (ReadFile(in.get(), out.data() + size, room, &n, nullptr) == 0)
            return cannot_read(faults, path, last_reason(), "Check the disk for errors.");
        if (n == 0) break;
        size += n;
        if (size > max_bytes) return too_large(faults, path, max_bytes);
        if (size == out.size()) out.resize(std::min(2 * size, max_bytes + 1));
    }
    out.resize(size);
    return true;
}

bool check_output(const std::string& path, Faults& faults) {
    std::wstring target = to_wide(path);
    int reason = 0;
    const Target kind = find_target(target, reason);
    if (kind == Target::impossible) return cannot_write(faults, path, reason);
    if (kind == Target::direct) return true;
    const std::wstring folder = folder_of(target);
    const DWORD attributes = GetFileAttributesW(folder.c_str());
    if (attributes == INVALID_FILE_ATTRIBUTES) return cannot_write(faults, path, last_reason());
    return (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0 || cannot_write(faults, path, ENOTDIR);
}

bool make_folder(const std::string& path, Faults& faults, bool* made) {
    const std::wstring wide = to_wide(path);
    const bool fresh = CreateDirectoryW(wide.c_str(), nullptr) != 0;
    const int reason = last_reason();
    if (made) *made = fresh;
    if (fresh || is_folder(wide)) return true;
    return reason == EEXIST ? not_a_folder(faults, path) : cannot_write(faults, path, reason);
}

bool is_same_file(const std::string& a, const std::string& b) {
    const std::optional<BY_HANDLE_FILE_INFORMATION> x = information(a), y = information(b);
    if (x && y)
        return (x->dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) == 0 &&
               x->dwVolumeSerialNumber == y->dwVolumeSerialNumber && x->nFileIndexHigh == y->nFileIndexHigh &&
               x->nFileIndexLow == y->nFileIndexLow;
    if (x || y) return false;
    std::error_code error;
    const auto whole = [&](const std::string& path) {
        return std::filesystem::weakly_canonical(std::filesystem::absolute(to_wide(path), error), error).wstring();
    };
    const std::wstring p = whole(a), q = whole(b);
    return !error && CompareStringOrdinal(p.c_str(), -1, q.c_str(), -1, TRUE) == CSTR_EQUAL;
}

// Keeps files younger than an hour: a writer opens its file exclusively until all are written, but not from then until renaming.
void clear_abandoned(const std::string& path) {
    const std::wstring folder = folder_of(to_wide(path));
    WIN32_FIND_DATAW found{};
    const HANDLE search = FindFirstFileW((folder + L".lr_bake-*.part").c_str(), &found);
    if (search == INVALID_HANDLE_VALUE) return;
    FILETIME now{};
    GetSystemTimeAsFileTime(&now);
    const auto ticks = [](const FILETIME& t) { return uint64_t{t.dwHighDateTime} << 32 | t.dwLowDateTime; };
    constexpr uint64_t hour = uint64_t{3600} * 10000000;
    do {
        if ((found.dwFileAttributes & (FILE_ATTRIBUTE_DIRECTORY | FILE_ATTRIBUTE_REPARSE_POINT)) != 0 ||
            ticks(found.ftLastWriteTime) + hour > ticks(now))
            continue;
        const Handle file(CreateFileW((folder + found.cFileName).c_str(), DELETE, 0, nullptr, OPEN_EXISTING,
                                      FILE_FLAG_DELETE_ON_CLOSE, nullptr));
    } while (FindNextFileW(search, &found) != 0);
    FindClose(search);
}

bool write_files(const std::vector<OutputFile>& files, Faults& faults) {
    const SignalsHeld held; // a signal between creation and renaming would leave a temporary file
    std::vector<AsideFile> staged;
    staged.reserve(files.size());
    for (const OutputFile& file : files) {
        std::wstring target = to_wide(file.path_utf8);
        int reason = 0;
        const Target kind = find_target(target, reason);
        if (kind == Target::impossible) return cannot_write(faults, file.path_utf8, reason);
        if (kind == Target::direct) {
            if (!write_directly(file, faults)) return false;
            continue;
        }
        staged.emplace_back(file.path_utf8, target);
        if (!staged.back().stage(file.bytes, faults)) return false;
    }
    for (AsideFile& file : staged)
        if (!file.commit(faults)) return false;
    return true;
}
} // namespace lr::baker
