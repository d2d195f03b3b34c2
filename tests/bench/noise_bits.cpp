// Writes the noise's bits to standard output, endlessly, in the orders that a battery of tests should see.
//   noise_bits bodies|substeps|seeds|gaussians [seed]
// bodies, substeps, seeds: the generator's words as the kernel gets them; neighbours differ in the named quantity.
// gaussians: body by body, the words of the three Gaussian pairs.
#include "kernel/math/lanes.h"

#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <string_view>

using namespace test;

namespace {

constexpr size_t block = 4096;        // draws at a time
constexpr uint32_t bodies = 1u << 20; // of a scene

class Writer {
public:
    explicit Writer(uint64_t seed) : seed_(seed) {}

    bool bodies_in_turn(uint64_t n) {
        draw_bodies(n);
        for (size_t i = 0; i < block; ++i)
            for (size_t k = 0; k < 4; ++k) out_.push_back(words_[k * block + i]);
        return written();
    }
    // Sixteen bodies, each with the numbers of `length` consecutive substeps or seeds.
    bool runs(uint64_t n, bool seeds) {
        constexpr size_t length = block / 16;
        const uint64_t start = n * 16 / bodies * length;
        std::iota(keys_.begin(), keys_.begin() + 16, 1 + static_cast<uint32_t>(n * 16 % bodies));
        out_.resize(4 * block);
        for (uint64_t i = 0; i < length; ++i) {
            target_.words(keys_.data(), seeds ? 0 : start + i, seeds ? seed_ + start + i : seed_, words_.data(), 16);
            for (size_t body = 0; body < 16; ++body)
                for (size_t k = 0; k < 4; ++k) out_[4 * (body * length + i) + k] = words_[k * 16 + body];
        }
        return written();
    }
    // Sign and 21 bits of the radius, 20 bits of the angle (kernel/math/gaussian_noise-inl.h).
    bool gaussians(uint64_t n) {
        draw_bodies(n);
        target_.angles(words_.data(), angles_.data(), block);
        for (size_t i = 0; i < block; ++i)
            for (size_t pair = 0; pair < 3; ++pair) {
                pack(words_[pair * block + i] >> 10, 22);
                pack(angles_[pair * block + i] >> 12, 20);
            }
        return written();
    }

private:
    void draw_bodies(uint64_t n) {
        std::iota(keys_.begin(), keys_.end(), 1 + static_cast<uint32_t>(block * n % bodies));
        target_.words(keys_.data(), block * n / bodies, seed_, words_.data(), block);
    }
    void pack(uint64_t bits, uint32_t count) {
        held_ |= bits << held_count_;
        held_count_ += count;
        if (held_count_ < 32) return;
        out_.push_back(static_cast<uint32_t>(held_));
        held_ >>= 32;
        held_count_ -= 32;
    }
    bool written() {
        const bool whole = std::fwrite(out_.data(), 4, out_.size(), stdout) == out_.size();
        out_.clear();
        return whole;
    }

    uint64_t seed_;
    Lanes target_ = lanes().front();
    Aligned<uint32_t> keys_ = Aligned<uint32_t>(block), words_ = Aligned<uint32_t>(4 * block);
    Aligned<uint32_t> angles_ = Aligned<uint32_t>(3 * block);
    std::vector<uint32_t> out_;
    uint64_t held_ = 0;
    uint32_t held_count_ = 0;
};

} // namespace

int main(int argc, char** argv) {
    const std::string_view order = argc > 1 ? argv[1] : "";
    if (order != "bodies" && order != "substeps" && order != "seeds" && order != "gaussians") {
        std::fputs("usage: noise_bits bodies|substeps|seeds|gaussians [seed]\n", stderr);
        return 2;
    }
    Writer writer(argc > 2 ? std::strtoull(argv[2], nullptr, 0) : 1);
    const auto step = [&](uint64_t n) {
        if (order == "bodies") return writer.bodies_in_turn(n);
        if (order == "gaussians") return writer.gaussians(n);
        return writer.runs(n, order == "seeds");
    };
    for (uint64_t n = 0; step(n); ++n) {
    }
    return 0; // the reader has ended
}
