// Damaged assets through the public API: one for each fault of the loader, refused with its number.
#include "support/scene.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

using namespace test;

namespace {

struct Damaged {
    uint32_t number;
    lr_status status;
};
// docs/reference/asset_format.md, 4xx. 104 needs more than a gibibyte.
const Damaged all[] = {{401, LR_ERROR_ASSET_FORMAT},  {402, LR_ERROR_ASSET_FORMAT},  {403, LR_ERROR_ASSET_VERSION},
                       {404, LR_ERROR_ASSET_CORRUPT}, {405, LR_ERROR_ASSET_CORRUPT}, {406, LR_ERROR_ASSET_INVALID},
                       {407, LR_ERROR_ASSET_INVALID}, {408, LR_ERROR_ASSET_INVALID}, {409, LR_ERROR_ASSET_INVALID},
                       {410, LR_ERROR_ASSET_INVALID}, {411, LR_ERROR_ASSET_INVALID}, {412, LR_ERROR_ASSET_INVALID},
                       {413, LR_ERROR_ASSET_INVALID}, {414, LR_ERROR_ASSET_INVALID}, {415, LR_ERROR_ASSET_INVALID},
                       {416, LR_ERROR_ASSET_INVALID}};

std::vector<char> bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

TEST_CASE("each numbered fault of an asset file is reached, and refuses it") {
    for (const Damaged& d : all) {
        CAPTURE(d.number);
        const std::vector<char> bytes = bytes_of(LR_FIXTURES "/fault_" + std::to_string(d.number) + ".lrb");
        REQUIRE(!bytes.empty());
        std::vector<uint32_t> numbers;
        CHECK(lr_asset_check_memory(
                  bytes.data(), bytes.size(),
                  [](void* user, uint32_t number, const char*, const char*, const char*) {
                      static_cast<std::vector<uint32_t>*>(user)->push_back(number);
                  },
                  &numbers) == d.status);
        CHECK(std::count(numbers.begin(), numbers.end(), d.number) == static_cast<std::ptrdiff_t>(numbers.size()));
        CHECK(!numbers.empty());
        lr_asset* asset = nullptr;
        CHECK(lr_asset_load_memory(bytes.data(), bytes.size(), &asset) == d.status);
        CHECK(asset == nullptr);
    }
}
