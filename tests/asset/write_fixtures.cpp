// Writes the asset files of the tests: write_fixtures FOLDER
#include "support/asset_bytes.h"

#include "asset/asset_file.h"
#include "asset/closed_forms/ellipsoid_asset.h"

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

// Files with one fault each, named by its number.
bool write_faulty(const std::string& folder, const lr::AssetData& good) {
    struct Case {
        int number;
        void (*change)(lr::AssetData&);
    };
    const Case cases[] = {{408, [](lr::AssetData& a) { a.u0 = std::numeric_limits<double>::infinity(); }},
                          {409, [](lr::AssetData& a) { a.fluid_viscosity = -1.0; }},
                          {410, [](lr::AssetData& a) { a.inertia[1] += 0.1 * a.inertia[0]; }},
                          {411, [](lr::AssetData& a) { a.added_mass[14] = -a.added_mass[14]; }},
                          {412, [](lr::AssetData& a) { a.hull.vertices[0] = 99.0f; }},
                          {413, [](lr::AssetData& a) { a.mass *= 1.1; }},
                          {414, [](lr::AssetData& a) { a.aerodynamics.axes[0] = 1.001; }},
                          {415, [](lr::AssetData& a) { a.hull.triangles.resize(a.hull.triangles.size() - 3); }},
                          {416,
                           [](lr::AssetData& a) {
                               for (size_t k = 0; k < 3; ++k) a.hull.vertices[k] *= 0.2f;
                           }},
                          {407, [](lr::AssetData& a) { a.turbulence.epsilon.pop_back(); }}};
    const auto put = [&](int number, const std::vector<uint8_t>& bytes) {
        return write(folder + "/fault_" + std::to_string(number) + ".lrb", bytes);
    };
    bool ok = true;
    for (const Case& c : cases) {
        lr::AssetData data = good;
        c.change(data);
        ok = put(c.number, lr::write_asset(data)) && ok;
    }
    const std::vector<uint8_t> bytes = lr::write_asset(good);
    std::vector<uint8_t> damaged = bytes;
    ok = put(401, {bytes.begin(), bytes.begin() + 15}) && ok;
    damaged[4] = 'G';
    ok = put(402, damaged) && ok;
    damaged = bytes;
    test::set_format_version(damaged, lr::asset_format_version + 1);
    ok = put(403, damaged) && ok;
    ok = put(404, {bytes.begin(), bytes.end() - 200}) && ok;
    damaged = bytes;
    damaged[test::root_field(damaged, 3)] ^= 1;
    ok = put(405, damaged) && ok;
    damaged = bytes;
    test::set_format_version(damaged, 0);
    return put(406, damaged) && ok;
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
    const bool ok = write(folder + "/leaf.lrb", lr::write_asset(good)) &&
                    write(folder + "/winged.lrb", lr::write_asset(test::winged_data())) &&
                    write(folder + "/newer.lrb", newer) && write(folder + "/invalid.lrb", lr::write_asset(invalid)) &&
                    write_faulty(folder, good);
    return ok ? 0 : 1;
}
