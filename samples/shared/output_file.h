// Writes a file under another name and renames it when it is complete: readers see the old file or the new one.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <string>

class OutputFile {
public:
    // Opens at once, so that a wrong path is reported before the work and not after it. Throws Failure.
    explicit OutputFile(std::string path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    const std::string& path() const { return path_; }
    void write(const void* bytes, std::size_t size);
    void write(const std::string& text) { write(text.data(), text.size()); }
    void commit();

private:
    [[noreturn]] void fail(const char* what) const;

    std::string path_, aside_; // aside_ is path_ for irregular files: /dev/stdout must not be replaced
    std::FILE* file_ = nullptr;
};
