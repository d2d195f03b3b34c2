// SPDX-License-Identifier: MIT
#include "output_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <unistd.h>

#include "failure.h"

OutputFile::OutputFile(std::string path) : path_(std::move(path)), aside_(path_) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path_, ignored)) {
        errno = EISDIR;
        fail("cannot write");
    }
    // symlink_status: /dev/stdout is a link, to a regular file if stdout is one.
    const auto status = std::filesystem::symlink_status(path_, ignored);
    if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) {
        aside_ += ".part-" + std::to_string(getpid());
    }
    file_ = std::fopen(aside_.c_str(), "wb");
    if (!file_) fail("cannot write");
}

OutputFile::~OutputFile() {
    if (!file_) return;
    std::fclose(file_);
    if (aside_ != path_) std::remove(aside_.c_str());
}

void OutputFile::write(const void* bytes, std::size_t size) {
    if (size != 0 && std::fwrite(bytes, 1, size, file_) != size) fail("cannot write all of");
}

void OutputFile::commit() {
    if (std::fflush(file_) != 0) fail("cannot write all of");
    if (aside_ != path_ && std::rename(aside_.c_str(), path_.c_str()) != 0) fail("cannot put in place");
    std::fclose(file_);
    file_ = nullptr;
}

void OutputFile::fail(const char* what) const {
    const int reason = errno;
    throw Failure(std::string(what) + " " + path_ + ": " + std::strerror(reason),
                  reason == ENOSPC ? "free some space on that disk"
                                   : "check that the folder exists and that you may write to it");
}
