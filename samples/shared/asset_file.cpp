// SPDX-License-Identifier: MIT
#include "asset_file.h"

#include <cstdio>
#include <fstream>
#include <iterator>

#include "failure.h"

AssetPointer load_asset(const std::string& path) {
    lr_asset* asset = nullptr;
    const lr_status status = lr_asset_load_file(path.c_str(), &asset);
    if (status == LR_OK) return AssetPointer(asset);
    if (status <= LR_ERROR_ASSET_FORMAT && status >= LR_ERROR_ASSET_INVALID) {
        std::ifstream file(path, std::ios::binary);
        const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
        std::string name = path;
        const auto tell = [](void* user, std::uint32_t number, const char* where, const char* what,
                             const char* remedy) {
            std::fprintf(stderr, "%s: fault %u: %s: %s (%s)\n", static_cast<const char*>(user), number, where, what,
                         remedy);
        };
        lr_asset_check_memory(bytes.data(), bytes.size(), tell, name.data());
    }
    check(status, "asset " + path,
          status == LR_ERROR_ASSET_VERSION ? "update langevin_rigid, or bake it again" : "bake it again with lr_bake");
    return {};
}
