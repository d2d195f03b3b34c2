// Views, states and transforms agree.
#include "support/random.h"
#include "support/scene.h"
#include "support/vector.h"

#include <algorithm>
#include <cmath>

using namespace test;

namespace {

struct Crowd {
    Asset asset = curled_leaf();
    World world = make(world_desc());
    lr_batch batch{};
    std::vector<lr_body> ids;

    explicit Crowd(uint32_t count) {
        batch = add_batch(world, asset, count + 5);
        Random random(count);
        for (uint32_t i = 0; i < count; ++i) {
            lr_body_desc d = strewn(random, 50.0);
            for (float& v : d.linear_velocity) v = random.real(-2.0, 2.0);
            for (float& w : d.angular_velocity) w = random.real(-9.0, 9.0);
            d.scale = static_cast<float>(random.logarithmic(0.01, 100.0));
            d.age = random.real(0.0, 3.0);
            ids.push_back(add_body(world, batch, d));
        }
    }
};

double largest_difference(Vec a, Vec b) {
    return length(a - b) / (1e-30 + length(a));
}

} // namespace

TEST_CASE("a view holds what get_state says, in aligned arrays") {
    Crowd crowd(37);
    steps(crowd.world, 3, 0.01f, 4);
    REQUIRE(lr_body_destroy(crowd.world.get(), &crowd.ids[5], 1) == LR_OK);
    const lr_batch_view v = view_of(crowd.world, crowd.batch);
    REQUIRE(v.count == 36);
    CHECK(v.capacity == 42);
    std::vector<const void*> arrays = {v.scale, v.age, v.noise_seed, v.ids};
    arrays.insert(arrays.end(), {v.position[0], v.position[1], v.position[2], v.orientation[0], v.orientation[1],
                                 v.orientation[2], v.orientation[3]});
    for (const void* array : arrays) CHECK(reinterpret_cast<uintptr_t>(array) % 64 == 0);
    for (uint32_t i = 0; i < v.count; ++i) {
        const lr_body_state s = state_of(crowd.world, v.ids[i]);
        Quat q{};
        for (size_t k = 0; k < 3; ++k) CHECK(s.position[k] == v.position[k][i]);
        for (size_t k = 0; k < 4; ++k) {
            CHECK(s.orientation[k] == v.orientation[k][i]);
            q[k] = wide(v.orientation[k][i]);
        }
        CHECK((s.scale == v.scale[i] && s.age == v.age[i] && s.noise_seed == v.noise_seed[i]));
        CHECK(std::abs(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] - 1.0) < 4e-7);
    }
}

TEST_CASE("a body has the values of its desc") {
    Crowd crowd(64);
    Random random(64);
    for (lr_body id : crowd.ids) {
        Vec position{}, velocity{}, spin{};
        Quat q{};
        for (double& x : position) x = wide(random.real(-50.0, 50.0));
        for (double& x : q) x = wide(random.real(-1.0, 1.0));
        for (double& x : velocity) x = wide(random.real(-2.0, 2.0));
        for (double& x : spin) x = wide(random.real(-9.0, 9.0));
        q = normalised(q);
        const lr_body_state s = state_of(crowd.world, id);
        CHECK(vec(s.position) == position);
        for (size_t k = 0; k < 4; ++k) CHECK(std::abs(wide(s.orientation[k]) - q[k]) < 1e-7);
        CHECK(largest_difference(velocity, vec(s.linear_velocity)) < 5e-7);
        CHECK(largest_difference(spin, vec(s.angular_velocity)) < 5e-7);
        CHECK(s.scale == static_cast<float>(random.logarithmic(0.01, 100.0)));
        CHECK(s.age == random.real(0.0, 3.0));
    }
}

TEST_CASE("setting the state that was read changes nothing but rounding, and never the noise seed") {
    Crowd crowd(100);
    steps(crowd.world, 5, 0.01f, 2);
    for (lr_body id : crowd.ids) {
        lr_body_state before = state_of(crowd.world, id);
        lr_body_state given = before;
        given.noise_seed = 123456;
        REQUIRE(lr_body_set_state(crowd.world.get(), id, &given) == LR_OK);
        const lr_body_state after = state_of(crowd.world, id);
        CHECK(after.noise_seed == before.noise_seed);
        CHECK(vec(after.position) == vec(before.position));
        CHECK((after.scale == before.scale && after.age == before.age));
        for (size_t k = 0; k < 4; ++k) CHECK(std::abs(after.orientation[k] - before.orientation[k]) < 1.5e-7f);
        CHECK(largest_difference(vec(before.linear_velocity), vec(after.linear_velocity)) < 1e-6);
        CHECK(largest_difference(vec(before.angular_velocity), vec(after.angular_velocity)) < 1e-6);
    }
}

TEST_CASE("orientations of any length are normalised") {
    Crowd crowd(1);
    lr_body_state s = state_of(crowd.world, crowd.ids[0]);
    for (float size : {1e-5f, 0.5f, 3.0f, 1e5f}) {
        const float q[4] = {0.5f, -0.5f, 0.5f, 0.5f};
        for (size_t k = 0; k < 4; ++k) s.orientation[k] = size * q[k];
        REQUIRE(lr_body_set_state(crowd.world.get(), crowd.ids[0], &s) == LR_OK);
        const lr_body_state got = state_of(crowd.world, crowd.ids[0]);
        for (size_t k = 0; k < 4; ++k) CHECK(std::abs(got.orientation[k] - q[k]) < 1e-7f);
    }
}

TEST_CASE("orientations stay unit over long runs") {
    Crowd crowd(50);
    steps(crowd.world, 500, 0.01f, 4);
    for (lr_body id : crowd.ids) {
        const Quat q = quat(state_of(crowd.world, id).orientation);
        CHECK(std::abs(std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]) - 1.0) < 3e-7);
    }
}

TEST_CASE("transforms in every format, at any stride, and nothing between them touched") {
    Crowd crowd(29);
    steps(crowd.world, 2, 0.01f, 2);
    const lr_batch_view view = view_of(crowd.world, crowd.batch);
    const uint32_t sizes[] = {28, 32, 48, 48, 64, 64};
    for (int32_t format = 0; format < 6; ++format)
        for (uint64_t stride : {uint64_t{0}, uint64_t{sizes[format]}, uint64_t{sizes[format] + 4}, uint64_t{200}}) {
            CAPTURE(format);
            CAPTURE(stride);
            const uint64_t step = stride == 0 ? sizes[format] : stride;
            std::vector<float> memory(step / 4 * 30 + 1, -777.0f);
            uint32_t written = 0;
            REQUIRE(lr_batch_write_transforms(crowd.world.get(), crowd.batch, format, memory.data(), stride, 29,
                                              &written) == LR_OK);
            CHECK(written == 29);
            for (uint32_t i = 0; i < 29; ++i) {
                const lr_body_state s = state_of(crowd.world, view.ids[i]);
                const float* const at = memory.data() + step / 4 * i;
                const Quat q = quat(s.orientation);
                const Matrix3 r = rotation(q);
                const double scale = wide(s.scale);
                double expected[16] = {};
                if (format < 2) {
                    for (size_t k = 0; k < 3; ++k) expected[k] = wide(s.position[k]);
                    for (size_t k = 0; k < 4; ++k) expected[3 + k] = q[k];
                    expected[7] = scale;
                } else {
                    const size_t rows = format < 4 ? 3 : 4;
                    const bool by_row = format == LR_TRANSFORM_3X4_ROW_MAJOR || format == LR_TRANSFORM_4X4_ROW_MAJOR;
                    for (size_t row = 0; row < rows; ++row)
                        for (size_t column = 0; column < 4; ++column) {
                            double value = row == 3      ? 0.0
                                           : column == 3 ? wide(s.position[row])
                                                         : scale * r[row][column];
                            if (row == 3 && column == 3) value = 1.0;
                            expected[by_row ? row * 4 + column : column * rows + row] = value;
                        }
                }
                double worst = 0.0;
                for (size_t k = 0; k < sizes[format] / 4; ++k) {
                    // Position and quaternion are copies; a rotation's entries carry a few roundings.
                    const double bound = format < 2 ? 0.0 : 5e-7 * scale;
                    worst = std::max(worst, std::abs(wide(at[k]) - expected[k]) - bound);
                }
                CHECK(worst <= 0.0);
                uint32_t touched = 0;
                for (size_t k = sizes[format] / 4; k < step / 4; ++k) touched += at[k] != -777.0f;
                CHECK(touched == 0);
            }
            CHECK(memory[step / 4 * 29] == -777.0f);
        }
}

TEST_CASE("transforms are refused whole when stride or format do not fit, and written as far as there is room") {
    Crowd crowd(10);
    std::vector<float> memory(160, -777.0f);
    uint32_t written = 9;
    const auto write = [&](int32_t format, void* to, uint64_t stride, uint32_t capacity) {
        written = 9;
        const lr_status status =
            lr_batch_write_transforms(crowd.world.get(), crowd.batch, format, to, stride, capacity, &written);
        if (status != LR_OK) CHECK(written == 0);
        return status;
    };
    for (int32_t format : {-1, 6, 1000}) CHECK(write(format, memory.data(), 0, 10) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(write(0, memory.data(), 24, 10) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(write(0, memory.data(), 30, 10) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(write(5, memory.data(), 60, 10) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(write(0, memory.data(), UINT64_MAX - 3, 10) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(write(0, reinterpret_cast<unsigned char*>(memory.data()) + 1, 0, 10) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(std::count(memory.begin(), memory.end(), -777.0f) == 160);
    CHECK(write(0, memory.data(), 0, 9) == LR_OK);
    CHECK(written == 9);
    CHECK(std::count(memory.begin() + 9 * 7, memory.end(), -777.0f) == 160 - 9 * 7);
    CHECK(write(5, memory.data(), 0, 10) == LR_OK);
    CHECK(written == 10);
}

TEST_CASE("velocities at any stride are those of get_state, bit for bit, and nothing between them is touched") {
    Crowd crowd(29);
    REQUIRE(lr_batch_set_rate(crowd.world.get(), crowd.batch, 2) == LR_OK);
    steps(crowd.world, 5, 0.01f, 2); // the batch waits
    const std::vector<lr_body> asleep(crowd.ids.begin(), crowd.ids.begin() + 9);
    REQUIRE(lr_body_set_sleep(crowd.world.get(), asleep.data(), 9, LR_SLEEP_ASLEEP) == LR_OK);
    const lr_batch_view view = view_of(crowd.world, crowd.batch);
    REQUIRE(view.awake_count == 20);
    for (uint64_t stride : {uint64_t{0}, uint64_t{24}, uint64_t{28}, uint64_t{200}})
        for (uint32_t count : {29u, 40u, 23u, 0u}) {
            CAPTURE(stride);
            CAPTURE(count);
            const uint64_t step = stride == 0 ? 24 : stride;
            std::vector<float> memory(step / 4 * 30, -777.0f);
            uint32_t written = 77;
            REQUIRE(lr_batch_write_velocities(crowd.world.get(), crowd.batch, memory.data(), stride, count, &written) ==
                    LR_OK);
            REQUIRE(written == std::min(count, 29u));
            for (uint32_t i = 0; i < written; ++i) {
                float* const at = memory.data() + step / 4 * i;
                const lr_body_state s = state_of(crowd.world, view.ids[i]);
                CHECK(std::memcmp(at, s.linear_velocity, 12) == 0);
                CHECK(std::memcmp(at + 3, s.angular_velocity, 12) == 0);
                CHECK((length(vec(at)) == 0.0) == (i >= view.awake_count));
                CHECK((length(vec(at + 3)) == 0.0) == (i >= view.awake_count));
                std::fill_n(at, 6, -777.0f);
            }
            CHECK(std::count(memory.begin(), memory.end(), -777.0f) == static_cast<ptrdiff_t>(memory.size()));
        }
}

TEST_CASE("velocities are refused whole when the stride does not fit") {
    Crowd crowd(10);
    std::vector<float> memory(60, -777.0f);
    const auto write = [&](void* to, uint64_t stride) {
        uint32_t written = 9;
        const lr_status status = lr_batch_write_velocities(crowd.world.get(), crowd.batch, to, stride, 10, &written);
        CHECK(written == (status == LR_OK ? 10 : 0));
        return status;
    };
    for (uint64_t stride : {uint64_t{4}, uint64_t{20}, uint64_t{26}, UINT64_MAX - 3})
        CHECK(write(memory.data(), stride) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(write(reinterpret_cast<unsigned char*>(memory.data()) + 1, 0) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(write(nullptr, 0) == LR_ERROR_NULL_ARGUMENT);
    CHECK(std::count(memory.begin(), memory.end(), -777.0f) == 60);
    CHECK(write(memory.data(), 0) == LR_OK);
}
