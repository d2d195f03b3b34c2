#include "peers/sketch.h"
#include "peers/peers.h"

#include <array>
#include <cstdlib>

namespace lr_bench {
namespace {

// A leaf in centimetres and grams, as in the first sketch.
SketchConstants constants() {
    SketchConstants p{};
    constexpr float mass[3] = {0.067f, 0.067f, 0.086f}, inertia[3] = {0.0154f, 0.269f, 0.2279f};
    constexpr float added[3] = {5e-8f, 5e-7f, 0.019f}, turned[3] = {0.002f, 0.0547f, 1e-6f};
    for (int k = 0; k < 3; ++k) {
        p.mass[k] = mass[k], p.inverse_mass[k] = 1.0f / mass[k];
        p.inertia[k] = inertia[k], p.inverse_inertia[k] = 1.0f / inertia[k];
        p.carried[k] = added[k] + 1e-4f, p.turned[k] = turned[k];
    }
    p.weight = -0.067f * 981.0f;
    p.damping = 1.0f, p.noise = 0.1f;
    return p;
}

class Sketch final : public Subject {
public:
    Sketch(SketchStep kernel, const Row& row)
        : step_(kernel), count_((row.bodies + 15u) / 16u * 16u), substeps_(static_cast<int>(row.substeps)) {
        for (size_t k = 0; k < state_.size(); ++k) {
            // An odd number of cache lines between arrays: a large power of two would map them to the same cache sets.
            state_[k] = static_cast<float*>(std::aligned_alloc(128, (count_ * sizeof(float) + 127) / 128 * 128 + 128));
            if (!state_[k]) std::abort();
            for (size_t i = 0; i < count_; ++i)
                state_[k][i] = k == 3    ? 1.0f
                               : k == 7  ? 20.0f + static_cast<float>(i % 7)
                               : k == 10 ? static_cast<float>(i % 13)
                                         : 0.0f;
        }
    }
    ~Sketch() override {
        for (float* array : state_) std::free(array);
    }
    bool step() override {
        step_(constants_, state_.data(), count_, substeps_, first_, substep_seconds);
        first_ += static_cast<uint32_t>(substeps_);
        return true;
    }
    Facts facts() const override { return array_facts(13 * sizeof(float)); }

private:
    SketchStep step_;
    size_t count_;
    int substeps_;
    uint32_t first_ = 0;
    SketchConstants constants_ = constants();
    std::array<float*, 13> state_{};
};

} // namespace

std::unique_ptr<Subject> make_sketch([[maybe_unused]] const Row& row, std::string& why_not) {
#ifdef LR_BENCH_SKETCH_NATIVE
    if (row.target == "native") return std::make_unique<Sketch>(&sketch_step_native, row);
    if (row.target == "native-no-fma") return std::make_unique<Sketch>(&sketch_step_native_no_fma, row);
#endif
#ifdef LR_BENCH_SKETCH_AVX2
    if (row.target == "x86-64-v3") {
        if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
            return std::make_unique<Sketch>(&sketch_step_avx2, row);
        why_not = "this processor cannot run it";
        return nullptr;
    }
#endif
    why_not = "not part of this build";
    return nullptr;
}

} // namespace lr_bench
