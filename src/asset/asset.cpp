#include "asset/asset.h"

#include "format/asset_file.h"
#include "format/coupling.h"

lr_asset::lr_asset(lr::AssetData&& from, uint32_t version, const std::array<double, 3>& size)
    : data(std::move(from)), content_hash(lr::content_hash(data)), diagonal(lr::is_diagonal(data)),
      format_version(version), extents(size) {}

namespace lr {

void retain(const lr_asset& asset) {
    asset.references.fetch_add(1, std::memory_order_relaxed);
}

void release(const lr_asset* asset) {
    if (asset && asset->references.fetch_sub(1, std::memory_order_acq_rel) == 1) delete asset;
}

} // namespace lr
