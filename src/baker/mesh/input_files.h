// The files that an asset is made from, each read once, so that what is hashed is what was parsed.
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

    // Null if it cannot be read, with the reason in `faults` if given. The same path gives the same bytes again. That a
    // file is missing counts as well: the reader may do something else once it is there.
    std::shared_ptr<const Bytes> read(const std::string& path_utf8, Faults* faults = nullptr);

    // For what does not come from a file.
    void add(const void* bytes, std::size_t size);

    // FNV-1a over the first file and then, with their lengths, the others in the order in which they were first asked
    // for. No names: an asset does not depend on its folder.
    const Fnv1a& hash() const { return hash_; }

    void forget_bytes() { files_.clear(); }

private:
    std::map<std::string, std::shared_ptr<const Bytes>> files_;
    Fnv1a hash_;
    bool empty_ = true;
};

} // namespace lr::baker
