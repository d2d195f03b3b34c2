// Any bytes: refused with a status and numbered faults, or an asset whose bodies step and stay finite.
#include "asset/asset_file.h"
#include "fuzz/asset/falls.h"
#include "fuzz/asset/mutate.h"
#include "langevin_rigid.h"
#include "support/asset_bytes.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace {

void load_and_fall(const uint8_t* data, size_t size) {
    lr_asset* asset = nullptr;
    const lr_status status = lr_asset_load_memory(data, size, &asset);
    if ((asset != nullptr) != (status == LR_OK)) std::abort();
    if (lr_asset_check_memory(data, size, nullptr, nullptr) != status) std::abort();
    if (!asset) return;
    lr::Fnv1a hash;
    hash.add(data, size);
    // Each file in two of all variants, always the same ones.
    fuzz::fall(asset, static_cast<uint32_t>(hash.value()) % 1000003u);
    fuzz::fall(asset, static_cast<uint32_t>(hash.value() >> 32) % 1000003u);
    lr_asset_release(asset);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    load_and_fall(data, size);
    // The checksum would refuse changed bytes early: correct it if only it is wrong, so that the later checks run too.
    lr::AssetData unused;
    lr::Faults faults;
    if (lr::read_asset(data, size, unused, faults) || faults.back().id != lr::FaultId::asset_checksum) return 0;
    std::vector<uint8_t> mended(data, data + size);
    test::seal(mended);
    load_and_fall(mended.data(), mended.size());
    return 0;
}

#ifdef LR_LIBFUZZER
extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t most);

// One in eight as bytes, for the verifier; the others as an asset, for the later checks.
extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t most, unsigned int seed) {
    if (seed % 8 == 0) return LLVMFuzzerMutate(data, size, most);
    lr::AssetData asset;
    lr::Faults faults;
    // An asset refused for its numbers can still be read.
    if (!lr::read_asset(data, size, asset, faults) && faults.front().id < lr::FaultId::asset_wrong_length)
        asset = test::leaf_data();
    fuzz::mutate_asset(asset, seed);
    const std::vector<uint8_t> bytes = lr::write_asset(asset);
    if (bytes.size() > most) return LLVMFuzzerMutate(data, size, most);
    std::copy(bytes.begin(), bytes.end(), data);
    return bytes.size();
}
#endif
