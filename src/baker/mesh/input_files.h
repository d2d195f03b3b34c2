// The input files of an asset, each read once, so that the hash covers exactly the parsed bytes.
#pragma once

#include "asset/input_faults.h"
#include "base/fnv1a.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace lr::baker {

class InputFiles {
public:
    using Bytes = std::vector<uint8_t>;

    // Null if the file cannot be read; `faults`, if given, gets the reason. A path read again gives the same bytes. The hash includes missing files,
    // because the result can change once they exist.
    std::shared_ptr<const Bytes> read(const std::string& path_utf8, Faults* faults = nullptr);

    // Adds bytes that are not from a file.
    void add(const void* bytes, std::size_t size);

    // FNV-1a over the first file, then over lengths and bytes of the others in the order of their first read. Names are left out, so that an asset
    // does not depend on its folder.
    const Fnv1a& hash() const { return hash_; }

    void forget_bytes() { files_.clear(); }

private:
    std::map<std::string, std::shared_ptr<const Bytes>> files_;
    Fnv1a hash_;
    bool empty_ = true;
};
} // namespace lr::baker
