// Random numbers from a counter, without state, so that a world repeats its draws after a rollback. Spawns draw from (seed, noise seed, life), gusts
// from (seed, seed of the source). Philox4x32-7 as in kernel/math/gaussian_noise-inl.h, with counters that the noise does not use; only + - x / sqrt.
#pragma once

#include <cstdint>

namespace lr {

// A bijection of 64 bits with good avalanche (Steele, Lea, Flood 2014, the finaliser of SplitMix64).
constexpr uint64_t mix64(uint64_t v) {
    v = (v ^ v >> 30) * 0xbf58476d1ce4e5b9ull;
    v = (v ^ v >> 27) * 0x94d049bb133111ebull;
    return v ^ v >> 31;
}

// Makes the numbers of different uses independent; the noise uses 0.
enum class Draws : uint32_t { births = 0x62697274u, gusts = 0x67757374u };

class CounterRandom {
public:
    CounterRandom(uint64_t seed, uint32_t noise_seed, uint32_t life, Draws use = Draws::births)
        : seed_(seed), noise_seed_(noise_seed), life_(life), use_(use) {}

    uint32_t bits() {
        if (next_ == 4) fill();
        return word_[next_++];
    }
    double uniform() { return (static_cast<double>(bits()) + 0.5) * 0x1p-32; } // (0, 1)
    double between(double low, double high) { return low + (high - low) * uniform(); }

    // Uniform in the unit disc, not at its centre; returns the squared distance from it, which is uniform in (0, 1].
    double disc(double& x, double& y) {
        for (;;) {
            x = between(-1.0, 1.0);
            y = between(-1.0, 1.0);
            const double s = x * x + y * y;
            if (s <= 1.0 && s > 0.0) return s;
        }
    }

private:
    void fill() {
        uint32_t c[4] = {noise_seed_, life_, block_++, static_cast<uint32_t>(use_)};
        auto k0 = static_cast<uint32_t>(seed_), k1 = static_cast<uint32_t>(seed_ >> 32);
        for (int round = 0; round < 7; ++round) {
            const uint64_t a = uint64_t{c[0]} * 0xD2511F53u, b = uint64_t{c[2]} * 0xCD9E8D57u;
            const uint32_t next[4] = {static_cast<uint32_t>(b >> 32) ^ c[1] ^ k0, static_cast<uint32_t>(b),
                                      static_cast<uint32_t>(a >> 32) ^ c[3] ^ k1, static_cast<uint32_t>(a)};
            for (int i = 0; i < 4; ++i) c[i] = next[i];
            k0 += 0x9E3779B9u;
            k1 += 0xBB67AE85u;
        }
        for (int i = 0; i < 4; ++i) word_[i] = c[i];
        next_ = 0;
    }

    uint64_t seed_;
    uint32_t noise_seed_, life_, block_ = 0;
    Draws use_;
    uint32_t word_[4] = {};
    int next_ = 4;
};
} // namespace lr
