// Writes the asset files that tests load: write_fixtures FOLDER
#include "support/asset_bytes.h"

#include "format/asset_file.h"
#include "shape/ellipsoid.h"

#include <cstdio>
#include <limits>
#include <string>

namespace {

bool write(const std::string& path, const std::vector<uint8_t>& bytes) {
    std::FILE* const file = std::fopen(path.c_str(), "wb");
    if (!file) return false;
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    return std::fclose(file) == 0 && written;
}

} // namespace

int main(int count, char** arguments) {
    if (count != 2) return 2;
    const std::string folder = arguments[1];
    const lr::AssetData good = test::leaf_data();
    lr::AssetData invalid = good;
    invalid.mass = std::numeric_limits<double>::quiet_NaN();
    std::vector<uint8_t> newer = lr::write_asset(good);
    test::set_format_version(newer, lr::asset_format_version + 1);
    lr::AssetData older = good;
    older.has_aerodynamics = false;
    const bool ok = write(folder + "/leaf.lrb", lr::write_asset(good)) && write(folder + "/newer.lrb", newer) &&
                    write(folder + "/invalid.lrb", lr::write_asset(invalid)) &&
                    write(folder + "/older.lrb", lr::write_asset(older));
    return ok ? 0 : 1;
}
