#include "baker/file_io.h"

#include "baker/file_faults.h"
#include "baker/hold_signals.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>

namespace lr::baker {
namespace {

class Descriptor {
public:
    explicit Descriptor(int fd = -1) : fd_(fd) {}
    ~Descriptor() { close(); }
    Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(fd_, other.fd_);
        return *this;
    }

    int get() const { return fd_; }
    bool close() {
        const int fd = std::exchange(fd_, -1);
        return fd < 0 || ::close(fd) == 0;
    }

private:
    int fd_;
};

bool write_all(int fd, std::span<const uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t n = ::write(fd, bytes.data(), bytes.size());
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) return false;
        if (n == 0) {
            errno = EIO;
            return false;
        }
        bytes = bytes.subspan(static_cast<std::size_t>(n));
    }
    return true;
}

enum class Target { absent, regular, direct, impossible };

// Follows symbolic links, so that their target is replaced and the links stay. Sets errno for invalid links.
Target find_target(std::string& path, mode_t& mode) {
    struct stat info {};
    if (path.empty()) {
        errno = ENOENT;
        return Target::impossible;
    }
    if (::stat(path.c_str(), &info) != 0) {
        if (errno == ENOENT && path.back() != '/') return Target::absent;
        return Target::impossible;
    }
    if (S_ISDIR(info.st_mode)) {
        errno = EISDIR;
        return Target::impossible;
    }
    if (!S_ISREG(info.st_mode)) return Target::direct;
    mode = info.st_mode & 0777;
    std::error_code error;
    const std::filesystem::path real = std::filesystem::canonical(path, error);
    if (!error) path = real.string();
    return Target::regular;
}

std::string folder_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? "." : path.substr(0, slash + 1);
}

constexpr const char* aside_prefix = ".lr_bake-";
constexpr const char* aside_suffix = ".part";

// The lock ends with the process, so a temporary file that can be locked is abandoned. False if the file was removed before it was locked. On file
// systems without locks, a killed process leaves its temporary files.
bool lock(int fd) {
    while (::flock(fd, LOCK_EX) != 0 && errno == EINTR) {
    }
    struct stat info {};
    return ::fstat(fd, &info) == 0 && info.st_nlink != 0;
}

// A temporary file in the target's folder, without a name where the file system allows: a killed process then leaves it behind only between linking
// and renaming.
class AsideFile {
public:
    AsideFile(std::string shown, std::string target, mode_t mode)
        : shown_(std::move(shown)), target_(std::move(target)), folder_(folder_of(target_)), mode_(mode) {}
    ~AsideFile() {
        if (!name_.empty()) ::unlink(name_.c_str());
    }
    AsideFile(AsideFile&& other) noexcept
        : shown_(std::move(other.shown_)), target_(std::move(other.target_)), folder_(std::move(other.folder_)),
          name_(std::exchange(other.name_, {})), mode_(other.mode_), file_(std::move(other.file_)) {}
    AsideFile& operator=(AsideFile&&) = delete;

    bool stage(std::span<const uint8_t> bytes, Faults& faults) {
        const bool good = open() && write_all(file_.get(), bytes) &&
                          (mode_ == 0 || ::fchmod(file_.get(), mode_) == 0) && ::fsync(file_.get()) == 0 && name();
        return good || cannot_write(faults, shown_, errno);
    }
    bool commit(Faults& faults) {
        if (::rename(name_.c_str(), target_.c_str()) != 0) return cannot_write(faults, shown_, errno);
        name_.clear();
        file_.close(); // already flushed, so closing cannot fail
        // Without syncing the folder, a power cut could restore the old file. File systems may refuse to.
        const Descriptor folder(::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
        if (folder.get() >= 0) ::fsync(folder.get());
        return true;
    }

private:
    template <class Try> bool with_free_name(const Try& attempt) {
        for (int i = 0; i < 1000; ++i) {
            const std::string candidate =
                folder_ + "/" + aside_prefix + std::to_string(::getpid()) + "-" + std::to_string(i) + aside_suffix;
            if (attempt(candidate.c_str())) {
                name_ = candidate;
                return true;
            }
            if (errno != EEXIST) return false;
        }
        return false;
    }
    bool open() {
        int fd = -1;
#if defined(O_TMPFILE)
        // An unnamed file is named through /proc.
        if (::access("/proc/self/fd", X_OK) == 0) fd = ::open(folder_.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
#endif
        if (fd >= 0) {
            file_ = Descriptor(fd);
            while (::flock(fd, LOCK_EX) != 0 && errno == EINTR) {
            }
            return true;
        }
        return with_free_name([&](const char* name) {
            file_ = Descriptor(::open(name, O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666));
            if (file_.get() < 0) return false;
            if (lock(file_.get())) return true;
            errno = EEXIST;
            return false;
        });
    }
    bool name() {
        if (!name_.empty()) return true;
        const std::string self = "/proc/self/fd/" + std::to_string(file_.get());
        return with_free_name(
            [&](const char* name) { return ::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, name, AT_SYMLINK_FOLLOW) == 0; });
    }

    std::string shown_, target_, folder_, name_;
    mode_t mode_;
    Descriptor file_;
};

bool write_directly(const OutputFile& file, Faults& faults) {
    // O_NONBLOCK: a pipe without a reader is an error instead of a wait.
    Descriptor out(::open(file.path_utf8.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
    if (out.get() < 0) return cannot_write(faults, file.path_utf8, errno);
    const int flags = ::fcntl(out.get(), F_GETFL);
    const bool good = flags >= 0 && ::fcntl(out.get(), F_SETFL, flags & ~O_NONBLOCK) == 0 &&
                      write_all(out.get(), file.bytes) && out.close();
    return good || cannot_write(faults, file.path_utf8, errno);
}
} // namespace

bool read_file(const std::string& path, std::size_t max_bytes, std::vector<uint8_t>& out, Faults& faults) {
    out.clear();
    // O_NONBLOCK: opening a pipe does not wait for a writer.
    Descriptor in(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
    if (in.get() < 0) {
        if (errno == ENOENT || errno == ENOTDIR) return no_such_file(faults, path);
        return cannot_read(faults, path, errno, "Check that you have the right to read it.");
    }
    struct stat info {};
    if (::fstat(in.get(), &info) != 0 || !S_ISREG(info.st_mode)) return not_a_file(faults, path);
    // The size is only a hint: it can be wrong (/proc) or change.
    std::size_t size = 0;
    out.resize(std::clamp<std::size_t>(static_cast<std::size_t>(info.st_size), 4096, max_bytes) + 1);
    for (;;) {
        const ssize_t n = ::read(in.get(), out.data() + size, out.size() - size);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) return cannot_read(faults, path, errno, "Check the disk for errors.");
        if (n == 0) break;
        size += static_cast<std::size_t>(n);
        if (size > max_bytes) return too_large(faults, path, max_bytes);
        if (size == out.size()) out.resize(std::min(2 * size, max_bytes + 1));
    }
    out.resize(size);
    return true;
}

bool check_output(const std::string& path, Faults& faults) {
    std::string target = path;
    mode_t mode = 0;
    const Target kind = find_target(target, mode);
    if (kind == Target::impossible) return cannot_write(faults, path, errno);
    if (kind == Target::direct) return ::access(path.c_str(), W_OK) == 0 || cannot_write(faults, path, errno);
    const std::string folder = folder_of(target);
    struct stat info {};
    if (::stat(folder.c_str(), &info) != 0) return cannot_write(faults, path, errno);
    if (!S_ISDIR(info.st_mode)) return cannot_write(faults, path, ENOTDIR);
    return ::access(folder.c_str(), W_OK | X_OK) == 0 || cannot_write(faults, path, errno);
}

bool make_folder(const std::string& path, Faults& faults, bool* made) {
    struct stat info {};
    const bool fresh = ::mkdir(path.c_str(), 0777) == 0;
    const int reason = errno;
    if (made) *made = fresh;
    if (fresh) return true;
    if (reason == EEXIST && ::stat(path.c_str(), &info) == 0) {
        if (S_ISDIR(info.st_mode)) return true;
        return not_a_folder(faults, path);
    }
    return cannot_write(faults, path, reason);
}

bool is_same_file(const std::string& a, const std::string& b) {
    struct stat x {
    }, y{};
    const bool has_a = ::stat(a.c_str(), &x) == 0, has_b = ::stat(b.c_str(), &y) == 0;
    if (has_a && has_b) return S_ISREG(x.st_mode) && x.st_dev == y.st_dev && x.st_ino == y.st_ino;
    if (has_a || has_b) return false;
    std::error_code error;
    const std::filesystem::path p = std::filesystem::weakly_canonical(std::filesystem::absolute(a, error), error);
    const std::filesystem::path q = std::filesystem::weakly_canonical(std::filesystem::absolute(b, error), error);
    return !error && p == q;
}

void clear_abandoned(const std::string& path) {
    std::string target = path;
    mode_t mode = 0;
    if (path.empty() || path.back() != '/') {
        const Target kind = find_target(target, mode);
        if (kind == Target::direct || kind == Target::impossible) return;
    }
    const std::string folder = folder_of(target);
    const std::unique_ptr<DIR, int (*)(DIR*)> entries(::opendir(folder.c_str()), &::closedir);
    if (!entries) return;
    const int in = ::dirfd(entries.get());
    while (const dirent* const entry = ::readdir(entries.get())) {
        const std::string_view name = entry->d_name;
        if (!name.starts_with(aside_prefix) || !name.ends_with(aside_suffix)) continue;
        const Descriptor file(::openat(in, entry->d_name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
        struct stat open_one {
        }, named_one{};
        if (file.get() < 0 || ::fstat(file.get(), &open_one) != 0 || !S_ISREG(open_one.st_mode) ||
            ::flock(file.get(), LOCK_EX | LOCK_NB) != 0)
            continue;
        // Since it was opened, the file can have been renamed to its target and another file can have its name.
        if (::fstatat(in, entry->d_name, &named_one, AT_SYMLINK_NOFOLLOW) == 0 && named_one.st_ino == open_one.st_ino)
            ::unlinkat(in, entry->d_name, 0);
    }
}

bool write_files(const std::vector<OutputFile>& files, Faults& faults) {
    std::vector<const OutputFile*> aside;
    for (const OutputFile& file : files) {
        std::string target = file.path_utf8;
        mode_t mode = 0;
        const Target kind = find_target(target, mode);
        if (kind == Target::impossible) return cannot_write(faults, file.path_utf8, errno);
        if (kind != Target::direct)
            aside.push_back(&file);
        else if (!write_directly(file, faults))
            return false;
    }
    const SignalsHeld held; // a signal between creation and renaming would leave a temporary file
    std::vector<AsideFile> staged;
    staged.reserve(aside.size());
    for (const OutputFile* file : aside) {
        std::string target = file->path_utf8;
        mode_t mode = 0;
        find_target(target, mode);
        staged.emplace_back(file->path_utf8, target, mode);
        if (!staged.back().stage(file->bytes, faults)) return false;
    }
    for (AsideFile& file : staged)
        if (!file.commit(faults)) return false;
    return true;
}
} // namespace lr::baker
