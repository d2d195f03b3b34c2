#include "asset/asset.h"

#include "asset/asset_file.h"
#include "base/matrix6.h"

namespace {

// Raises negative eigenvalues of the added mass to zero. A solver's error can leave some if a thin or round body has almost no added mass, and such
// files pass the checks. In a dense fluid they would reduce the body's own inertia, and turbulent loads along them would drive instead of damp.
lr::AssetData&& settled(lr::AssetData&& d) {
    const double unit = d.volume + d.projected_area * d.length_d;
    lr::Matrix6 scaled = d.added_mass;
    lr::scale_to_unit(scaled, unit, d.length_d);
    lr::Matrix6 nearly = scaled;
    for (size_t i = 0; i < 6; ++i) nearly[i * 7] += 1e-12; // rounding
    if (lr::is_positive_definite(nearly, 0.0)) return std::move(d);
    lr::make_semi_definite(scaled);
    lr::scale_to_unit(scaled, 1.0 / unit, 1.0 / d.length_d); // and back
    d.added_mass = scaled;
    return std::move(d);
}
} // namespace

lr_asset::lr_asset(lr::AssetData&& from, uint32_t version, const std::array<double, 3>& size)
    : data(settled(std::move(from))), content_hash(lr::content_hash(data)), diagonal(lr::is_diagonal(data)),
      format_version(version), extents(size), shape(lr::make_body_shape(data, extents)),
      pair_hull(lr::make_pair_hull(shape)) {}

namespace lr {

void retain(const lr_asset& asset) {
    asset.references.fetch_add(1, std::memory_order_relaxed);
}

void release(const lr_asset* asset) {
    if (asset && asset->references.fetch_sub(1, std::memory_order_acq_rel) == 1) delete asset;
}
} // namespace lr
