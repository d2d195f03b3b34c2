// Loading: valid files, every prefix of a file, every byte changed, foreign and newer files.
#include "support/quick.h"
#include "support/random.h"
#include "support/scene.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <tuple>

using namespace test;

namespace {

std::vector<unsigned char> fixture(const char* name) {
    std::ifstream file(std::string(LR_FIXTURES "/") + name, std::ios::binary);
    std::vector<unsigned char> bytes{std::istreambuf_iterator<char>(file), {}};
    REQUIRE(bytes.size() > 1000);
    return bytes;
}

lr_status load(const std::vector<unsigned char>& bytes) {
    lr_asset* asset = nullptr;
    // A copy of exactly this size: a read past the end is a fault under AddressSanitizer.
    const std::unique_ptr<unsigned char[]> exact(new unsigned char[bytes.size() + 1]);
    std::copy(bytes.begin(), bytes.end(), exact.get() + 1); // odd address
    const lr_status status = lr_asset_load_memory(exact.get() + 1, bytes.size(), &asset);
    if ((asset != nullptr) != (status == LR_OK)) FAIL("asset and status do not agree");
    if (lr_asset_check_memory(exact.get() + 1, bytes.size(), nullptr, nullptr) != status)
        FAIL("check and load do not agree");
    lr_asset_release(asset);
    return status;
}

bool refused_as_file(lr_status s) {
    return s == LR_ERROR_ASSET_FORMAT || s == LR_ERROR_ASSET_VERSION || s == LR_ERROR_ASSET_CORRUPT ||
           s == LR_ERROR_ASSET_INVALID;
}

struct Fault {
    uint32_t number;
    std::string where, what, remedy;
};

lr_aerodynamics aerodynamics_of(const Asset& asset) {
    lr_aerodynamics a = initialised(lr_aerodynamics_init);
    REQUIRE(lr_asset_get_aerodynamics(asset.get(), &a) == LR_OK);
    return a;
}

std::vector<Fault> faults_of(const std::vector<unsigned char>& bytes, lr_status expected) {
    std::vector<Fault> faults;
    CHECK(lr_asset_check_memory(
              bytes.data(), bytes.size(),
              [](void* user, uint32_t number, const char* where, const char* what, const char* remedy) {
                  static_cast<std::vector<Fault>*>(user)->push_back({number, where, what, remedy});
              },
              &faults) == expected);
    return faults;
}

} // namespace

TEST_CASE("a file and its bytes at any alignment are the same asset") {
    lr_asset* raw = nullptr;
    REQUIRE(lr_asset_load_file(LR_FIXTURES "/leaf.lrb", &raw) == LR_OK);
    const Asset from_file(raw);
    const lr_asset_info info = info_of(from_file);
    CHECK(std::string(info.name) == "leaf");
    CHECK(info.format_version == 2);
    CHECK(info.density == 800.0);
    CHECK(info.mass == doctest::Approx(800.0 * 4.0 / 3.0 * 3.141592653589793 * 0.04 * 0.01 * 0.0005));
    CHECK(info.center_of_mass[0] == 0.002);
    CHECK(info.center_of_buoyancy[0] == -0.002);
    CHECK((info.flags & LR_ASSET_DIAGONAL) == 0);
    CHECK(info.turbulence_count == 256);
    CHECK((info.hull_vertex_count == 42 && info.hull_triangle_count == 80));
    const std::vector<unsigned char> bytes = fixture("leaf.lrb");
    for (size_t shift = 0; shift < 9; ++shift) {
        std::vector<unsigned char> moved(bytes.size() + shift);
        std::copy(bytes.begin(), bytes.end(), moved.begin() + static_cast<std::ptrdiff_t>(shift));
        REQUIRE(lr_asset_load_memory(moved.data() + shift, bytes.size(), &raw) == LR_OK);
        std::fill(moved.begin(), moved.end(), static_cast<unsigned char>(0)); // the library has copied the bytes
        const Asset again(raw);
        CHECK(info_of(again).content_hash == info.content_hash);
        CHECK(info_of(again).mass == info.mass);
    }
    // The same shape without a file has the same weight and buoyancy.
    lr_ellipsoid_desc d = ellipsoid(0.04, 0.01, 0.0005, 800.0);
    d.center_of_mass[0] = 0.002;
    CHECK(info_of(make(d)).content_hash == info.content_hash);
    CHECK(info_of(make(d)).format_version == 0);
}

TEST_CASE("a refused ellipsoid or rigid body names the field and its range") {
    lr_asset* asset = nullptr;
    lr_ellipsoid_desc e = ellipsoid(0.04, 0.01, 0.0005, 0.0);
    CHECK(lr_asset_create_ellipsoid(&e, &asset) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(std::string(lr_last_error()) == "lr_asset_create_ellipsoid: density: The value 0 is outside its range. "
                                          "Give a value from 0.001 to 1000000.");
    e = ellipsoid(0.04, -1.0, 0.0005, 800.0);
    CHECK(lr_asset_create_ellipsoid(&e, &asset) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(std::strstr(lr_last_error(), "semi-axis B: The value -1 ") != nullptr);
    lr_rigid_desc r = initialised(lr_rigid_desc_init);
    r.mass = 1.0, r.volume = 1.0, r.extents[0] = r.extents[1] = 1.0;
    CHECK(lr_asset_create_rigid(&r, &asset) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(std::strstr(lr_last_error(), "extents: The value 0 ") != nullptr);
    r.volume = 0.0;
    CHECK(lr_asset_create_rigid(&r, &asset) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(std::strstr(lr_last_error(), "volume: The value 0 ") != nullptr);
}

TEST_CASE("paths that lead nowhere") {
    lr_asset* asset = nullptr;
    CHECK(lr_asset_load_file(LR_FIXTURES "/no_such_file.lrb", &asset) == LR_ERROR_FILE_NOT_FOUND);
    CHECK(lr_asset_load_file("", &asset) == LR_ERROR_FILE_NOT_FOUND);
    CHECK(lr_asset_load_file(LR_FIXTURES "/leaf.lrb/below", &asset) == LR_ERROR_FILE_NOT_FOUND);
    CHECK(lr_asset_load_file(LR_FIXTURES, &asset) == LR_ERROR_FILE_READ); // a folder
    CHECK(asset == nullptr);
}

TEST_CASE("every truncation of a file is refused") {
    const std::vector<unsigned char> bytes = fixture("leaf.lrb");
    uint32_t wrong = 0;
    for (size_t size = 0; size < bytes.size(); ++size) {
        const lr_status status = load({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)});
        const bool expected = size < 16 ? status == LR_ERROR_ASSET_FORMAT : status == LR_ERROR_ASSET_CORRUPT;
        if (!expected) ++wrong;
    }
    CHECK(wrong == 0);
    std::vector<unsigned char> longer = bytes;
    longer.push_back(0);
    CHECK(load(longer) == LR_ERROR_ASSET_CORRUPT);
}

TEST_CASE("every changed byte of a file is found" * doctest::test_suite("native")) {
    std::vector<unsigned char> bytes = fixture("leaf.lrb");
    const size_t stride = quick() ? 7 : 1;
    uint32_t accepted = 0, odd = 0;
    for (size_t at = 0; at < bytes.size(); at += stride)
        for (unsigned char change : {static_cast<unsigned char>(1u << (at % 8)), static_cast<unsigned char>(0xff)}) {
            bytes[at] ^= change;
            const lr_status status = load(bytes);
            accepted += status == LR_OK;
            odd += status != LR_OK && !refused_as_file(status);
            bytes[at] ^= change;
        }
    CHECK(accepted == 0);
    CHECK(odd == 0);
    CHECK(load(bytes) == LR_OK);
}

TEST_CASE("many changes at once") {
    const std::vector<unsigned char> good = fixture("leaf.lrb");
    Random random(3);
    uint32_t odd = 0;
    for (int round = 0; round < 3000; ++round) {
        std::vector<unsigned char> bytes = good;
        for (uint32_t n = 1 + random.below(8); n > 0; --n) {
            const size_t at = random.below(static_cast<uint32_t>(bytes.size()));
            const uint32_t word[] = {0, 0xffffffffu, 0x7fffffffu, 0x80000000u, 1, static_cast<uint32_t>(random.bits())};
            std::memcpy(bytes.data() + std::min(at, bytes.size() - 4), &word[random.below(6)], 4);
        }
        if (bytes != good) odd += !refused_as_file(load(bytes));
    }
    CHECK(odd == 0);
}

TEST_CASE("foreign, newer and impossible files say so, with numbered faults") {
    CHECK(load({}) == LR_ERROR_ASSET_FORMAT);
    CHECK(load(std::vector<unsigned char>(4096, 0)) == LR_ERROR_ASSET_FORMAT);
    CHECK(load(std::vector<unsigned char>(4096, 0xff)) == LR_ERROR_ASSET_FORMAT);
    std::vector<unsigned char> foreign = fixture("leaf.lrb");
    foreign[4] = 'G';
    CHECK(load(foreign) == LR_ERROR_ASSET_FORMAT);
    Random random(11);
    std::vector<unsigned char> noise(2000);
    for (int round = 0; round < 200; ++round) {
        for (unsigned char& byte : noise) byte = static_cast<unsigned char>(random.bits());
        if (round % 2) std::memcpy(noise.data() + 4, "LRBA", 4); // past the first gate
        if (!refused_as_file(load(noise))) FAIL("noise was taken for an asset");
    }

    CHECK(load(fixture("newer.lrb")) == LR_ERROR_ASSET_VERSION);
    CHECK(load(fixture("invalid.lrb")) == LR_ERROR_ASSET_INVALID);
    CHECK(faults_of(fixture("leaf.lrb"), LR_OK).empty());
    for (const auto& [name, number, status] :
         {std::tuple{"newer.lrb", 403u, LR_ERROR_ASSET_VERSION}, {"invalid.lrb", 408u, LR_ERROR_ASSET_INVALID}}) {
        const std::vector<Fault> faults = faults_of(fixture(name), status);
        REQUIRE(faults.size() >= 1);
        CHECK(faults[0].number == number);
        CHECK((!faults[0].where.empty() && !faults[0].what.empty() && !faults[0].remedy.empty()));
    }
    lr_asset* asset = nullptr;
    CHECK(lr_asset_load_file(LR_FIXTURES "/newer.lrb", &asset) == LR_ERROR_ASSET_VERSION);
    CHECK(lr_asset_load_file(LR_FIXTURES "/invalid.lrb", &asset) == LR_ERROR_ASSET_INVALID);
    CHECK(asset == nullptr);
}

TEST_CASE("an asset lives as long as anyone holds it") {
    const World world = make(world_desc());
    lr_batch batch{};
    {
        const Asset asset = leaf();
        batch = add_batch(world, asset, 10);
    }
    const lr_body body = add_body(world, batch, body_desc());
    steps(world, 5, 0.01f, 4);
    CHECK(lr_batch_set_turbulence_table(world.get(), batch, nullptr) == LR_OK); // reads the asset
    CHECK(state_of(world, body).position[1] < 0.0f);

    Asset asset = leaf();
    const double mass = info_of(asset).mass;
    for (int i = 0; i < 100; ++i) CHECK(lr_asset_retain(asset.get()) == LR_OK);
    for (int i = 0; i < 100; ++i) lr_asset_release(asset.get());
    CHECK(info_of(asset).mass == mass);
}

TEST_CASE("equal ellipsoids are equal assets, others are not") {
    const lr_ellipsoid_desc d = ellipsoid(0.04, 0.01, 0.0001, 800.0);
    const uint64_t hash = info_of(make(d)).content_hash;
    CHECK(info_of(make(d)).content_hash == hash);
    for (auto change :
         {+[](lr_ellipsoid_desc& e) { e.semi_axes[1] *= 1.0 + 1e-15 * 4; },
          +[](lr_ellipsoid_desc& e) { e.density += 1.0; }, +[](lr_ellipsoid_desc& e) { e.fluid_density += 0.1; },
          +[](lr_ellipsoid_desc& e) { e.fluid_viscosity *= 2.0; }, +[](lr_ellipsoid_desc& e) { e.intensity = 0.5; },
          +[](lr_ellipsoid_desc& e) { e.center_of_mass[2] = 1e-6; }}) {
        lr_ellipsoid_desc other = d;
        change(other);
        CHECK(info_of(make(other)).content_hash != hash);
    }
}

TEST_CASE("info of an ellipsoid asset") {
    const lr_asset_info info = info_of(make(in_water(ellipsoid(0.04, 0.02, 0.01, 1200.0))));
    const double volume = 4.0 / 3.0 * 3.141592653589793 * 8e-6;
    CHECK(info.volume == doctest::Approx(volume));
    CHECK(info.mass == doctest::Approx(1200.0 * volume));
    CHECK(info.inertia[0] == doctest::Approx(info.mass / 5.0 * (4e-4 + 1e-4)));
    CHECK(info.inertia[4] == doctest::Approx(info.mass / 5.0 * (16e-4 + 1e-4)));
    CHECK(info.inertia[8] == doctest::Approx(info.mass / 5.0 * (16e-4 + 4e-4)));
    // Lamb's 4:2:1, with the fluid's density.
    CHECK(info.added_mass[0] == doctest::Approx(0.12657 * volume * 1000.0).epsilon(5e-5));
    CHECK(info.added_mass[7] == doctest::Approx(0.39817 * volume * 1000.0).epsilon(5e-5));
    CHECK(info.added_mass[14] == doctest::Approx(1.51806 * volume * 1000.0).epsilon(5e-5));
    for (size_t i = 0; i < 6; ++i)
        for (size_t j = 0; j < 6; ++j)
            if (i != j) CHECK(info.added_mass[i * 6 + j] == 0.0);
    CHECK(info.flags == (LR_ASSET_DIAGONAL | LR_ASSET_SYMMETRIC));
    CHECK(info.length_d == doctest::Approx(0.08));
    CHECK(info.length_b == doctest::Approx(0.02));
    CHECK(info.u0 == doctest::Approx(std::sqrt(0.2 * 9.80665 * 0.02)));
    CHECK(info.reynolds == doctest::Approx(info.u0 * 0.08 / 1e-6));
    CHECK((info.c0 > 0.0 && info.c0 <= 6.5 && info.turbulence_dt > 0.0 && info.turbulence_count > 1));
}

TEST_CASE("an asset has the coefficients of its loads: a sphere's by hand, a leaf's from file as without one") {
    const double pi = 3.141592653589793, r = 0.01;
    const lr_aerodynamics sphere = aerodynamics_of(make(ellipsoid(r, r, r, 500.0)));
    CHECK((sphere.struct_size == sizeof sphere && sphere.reserved == 0));
    for (size_t k = 0; k < 3; ++k) {
        for (size_t i = 0; i < 3; ++i) CHECK(sphere.axes[k * 3 + i] == (i == k ? 1.0 : 0.0));
        CHECK(sphere.drag_stokes[k] == doctest::Approx(6.0 * pi * r));
        CHECK(sphere.spin_drag_stokes[k] == doctest::Approx(8.0 * pi * r * r * r));
        CHECK(sphere.drag[k] + sphere.drag_blunt[k] == doctest::Approx(0.46 * pi * r * r).epsilon(0.05));
        CHECK((sphere.lift[k] == 0.0 && sphere.plate_lift[k] == 0.0));
    }
    CHECK((sphere.plate_drag == 0.0 && sphere.shedding_moment == 0.0));
    CHECK(sphere.length > 0.1 * r);

    lr_asset* raw = nullptr;
    REQUIRE(lr_asset_load_file(LR_FIXTURES "/leaf.lrb", &raw) == LR_OK);
    const lr_aerodynamics from_file = aerodynamics_of(Asset(raw));
    lr_ellipsoid_desc d = ellipsoid(0.04, 0.01, 0.0005, 800.0);
    d.center_of_mass[0] = 0.002;
    const lr_aerodynamics made = aerodynamics_of(make(d));
    CHECK(std::memcmp(&from_file, &made, sizeof made) == 0);
    // Thin along z: the largest drag along z, and lift perpendicular to it.
    CHECK((made.drag[2] > 5.0 * made.drag[0] && made.lift[0] > 0.0 && made.lift[1] < 0.0));
}

TEST_CASE("a rigid body is what it was said to be, and an ellipsoid's numbers make that ellipsoid") {
    const Asset ellipsoidal = test::make(ellipsoid(0.04, 0.02, 0.01, 300.0));
    const lr_asset_info from = info_of(ellipsoidal);
    lr_rigid_desc d = initialised(lr_rigid_desc_init);
    d.mass = from.mass, d.volume = from.volume;
    std::copy(from.inertia, from.inertia + 9, d.inertia);
    std::copy(from.added_mass, from.added_mass + 36, d.added_mass);
    d.extents[0] = 0.08, d.extents[1] = 0.04, d.extents[2] = 0.02;
    const Asset rigid = make(d);
    const lr_asset_info to = info_of(rigid);
    CHECK((to.mass == from.mass && to.volume == from.volume && to.length_d == from.length_d));
    CHECK(to.u0 == doctest::Approx(from.u0));
    CHECK(to.length_l == doctest::Approx(from.length_l));
    CHECK(to.c0 == doctest::Approx(from.c0));
    for (size_t i = 0; i < 36; ++i) CHECK(to.added_mass[i] == doctest::Approx(from.added_mass[i]));
    for (size_t i = 0; i < 9; ++i) CHECK(to.inertia[i] == from.inertia[i]);
    const lr_aerodynamics a = aerodynamics_of(ellipsoidal);
    lr_aerodynamics b = aerodynamics_of(rigid);
    CHECK(std::memcmp(&a, &b, sizeof a) == 0);
    b.lift[1] *= 3.0;
    d.aerodynamics = &b;
    const lr_aerodynamics c = aerodynamics_of(make(d));
    CHECK(std::memcmp(&c, &b, sizeof b) == 0);
}

TEST_CASE("added mass that a solver's error left below zero is zero, and does not drive a needle in water") {
    lr_rigid_desc d = initialised(lr_rigid_desc_init);
    d.mass = 2.3e-4, d.volume = 2.1e-7;
    d.extents[0] = 0.2, d.extents[1] = 0.001, d.extents[2] = 0.002;
    d.inertia[0] = 5.76e-11, d.inertia[4] = d.inertia[8] = 4.6e-7;
    const double added[6] = {5.8e-11, 5.0e-7, 1.26e-7, -2.8e-14, 2.5e-10, 1.0e-9};
    for (size_t i = 0; i < 6; ++i) d.added_mass[i * 7] = added[i];
    const Asset needle = make(d);
    const lr_asset_info info = info_of(needle);
    for (size_t i = 0; i < 6; ++i)
        CHECK(info.added_mass[i * 7] == doctest::Approx(std::max(added[i], 0.0)).epsilon(1e-9));
    CHECK(info.added_mass[21] == 0.0);
    const World world = make(world_desc());
    lr_batch_desc bd = batch_desc();
    bd.load_model = LR_LOADS_LANGEVIN;
    const lr_body body = add_body(world, add_batch(world, bd, needle, 1), body_desc());
    set_wind(world, 8.0f, 0.0f, 0.0f);
    lr_water_desc sea = initialised(lr_water_desc_init);
    REQUIRE(lr_world_set_water(world.get(), &sea) == LR_OK);
    steps(world, 300, 1.0f / 60.0f, 1);
    const lr_body_state s = state_of(world, body);
    CHECK(s.sleep_state != LR_SLEEP_HELD); // it has not diverged
    for (float w : s.angular_velocity) CHECK(std::abs(w) < 1e5f);
}
