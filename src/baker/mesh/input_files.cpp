#include "baker/mesh/input_files.h"

#include "baker/file_io.h"

#include <utility>

namespace lr::baker {
namespace {

constexpr std::size_t max_input_bytes = std::size_t{1} << 31;
} // namespace

std::shared_ptr<const InputFiles::Bytes> InputFiles::read(const std::string& path, Faults* faults) {
    const auto known = files_.find(path);
    if (known != files_.end() && (known->second || !faults)) return known->second;
    Bytes bytes;
    Faults reasons;
    if (!read_file(path, max_input_bytes, bytes, reasons)) {
        if (faults) faults->insert(faults->end(), reasons.begin(), reasons.end());
        if (known == files_.end()) {
            if (!empty_) hash_.add_u64(UINT64_MAX);
            files_.emplace(path, nullptr);
        }
        return nullptr;
    }
    add(bytes.data(), bytes.size());
    return files_.insert_or_assign(path, std::make_shared<const Bytes>(std::move(bytes))).first->second;
}

void InputFiles::add(const void* bytes, std::size_t size) {
    if (!empty_) hash_.add_u64(size);
    hash_.add(bytes, size);
    empty_ = false;
}
} // namespace lr::baker
