#include "body_contact/pair_cache.h"

#include "base/counter_random.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace lr {
namespace {

constexpr uint32_t most_pairs = 1u << 30; // the table's cells are a power of two

uint64_t hash_of(uint64_t a, uint64_t b) {
    return mix64(a + 0x9e3779b97f4a7c15ull * b);
}
// Components but the largest are at most sqrt(1/2).
constexpr float turn_step = 0.70710678f / 524287.0f, steps_per_turn = 524287.0f / 0.70710678f;
constexpr uint32_t turn_bits = 20;
constexpr int32_t turn_middle = 1 << (turn_bits - 1);
} // namespace

PackedRotation PackedRotation::of(Rotation q) {
    const float parts[4] = {q.x, q.y, q.z, q.w};
    uint32_t largest = 0;
    for (uint32_t k = 1; k < 4; ++k)
        if (std::abs(parts[k]) > std::abs(parts[largest])) largest = k;
    const float scale = parts[largest] < 0.0f ? -steps_per_turn : steps_per_turn;
    uint64_t bits = largest;
    for (uint32_t k = 1; k < 4; ++k) {
        const float steps = std::clamp(scale * parts[(largest + k) & 3u], -524287.0f, 524287.0f);
        const auto whole = static_cast<int32_t>(steps + (steps < 0.0f ? -0.5f : 0.5f));
        bits = bits << turn_bits | static_cast<uint32_t>(whole + turn_middle);
    }
    return {bits};
}

Rotation PackedRotation::unpacked() const {
    constexpr uint32_t mask = (1u << turn_bits) - 1;
    float parts[4], squares = 0.0f;
    const auto largest = static_cast<uint32_t>(bits >> (3 * turn_bits) & 3u);
    for (uint32_t k = 1; k < 4; ++k) {
        const auto steps = static_cast<int32_t>(bits >> ((3 - k) * turn_bits) & mask) - turn_middle;
        const float part = turn_step * static_cast<float>(steps);
        parts[(largest + k) & 3u] = part;
        squares += part * part;
    }
    parts[largest] = std::sqrt(std::max(1.0f - squares, 0.0f));
    return {parts[0], parts[1], parts[2], parts[3]};
}

bool PairCache::reserve(Allocator& allocator, uint32_t count) {
    if (count > most_pairs) return false;
    uint32_t cells = 16;
    while (cells < 2 * count) cells *= 2;
    // The two lists change roles: both get room, so that a later restore of as many pairs allocates nothing.
    if (!grow(allocator, next_, count) || !enlarge(allocator, pairs_, next_.size(), count_)) return false;
    if (table_.size() >= cells) return true;
    Buffer<uint32_t> table;
    if (!table.allocate(allocator, cells)) return false;
    table_.swap(table);
    index();
    return true;
}

// Bodies can share a noise seed. Pairs with equal keys are not found at all: which one is meant would depend on their order.
void PairCache::index() {
    const auto cells = static_cast<uint32_t>(table_.size());
    mask_ = 0;
    if (count_ == 0 || cells == 0) return;
    mask_ = cells - 1;
    std::fill_n(table_.data(), cells, 0u);
    for (uint32_t i = 0; i < count_; ++i) {
        CachedPair& pair = pairs_[i];
        uint32_t at = static_cast<uint32_t>(hash_of(pair.a, pair.b)) & mask_;
        for (; table_[at] != 0; at = (at + 1) & mask_) {
            CachedPair& other = pairs_[table_[at] - 1];
            if (other.a == pair.a && other.b == pair.b) break;
        }
        if (table_[at] == 0)
            table_[at] = i + 1;
        else
            pair.count = pairs_[table_[at] - 1].count = 0;
    }
}

const CachedPair* PairCache::find(uint64_t a, uint64_t b) const {
    if (mask_ == 0) return nullptr;
    for (uint32_t at = static_cast<uint32_t>(hash_of(a, b)) & mask_; table_[at] != 0; at = (at + 1) & mask_) {
        const CachedPair& pair = pairs_[table_[at] - 1];
        if (pair.a == a && pair.b == b) return pair.count != 0 ? &pair : nullptr;
    }
    return nullptr;
}

void PairCache::commit(uint32_t most) {
    CachedPair* const added = next();
    const CachedPair* const end = std::remove_if(added, added + most, [](const CachedPair& p) { return p.count == 0; });
    pairs_.swap(next_);
    count_ = next_count_ + static_cast<uint32_t>(end - added);
    index();
}

void PairCache::forget(uint32_t slot) {
    const auto of_slot = [slot](const CachedPair& p) { return slot_of_key(p.a) == slot || slot_of_key(p.b) == slot; };
    CachedPair* const data = pairs_.data();
    const auto left = static_cast<uint32_t>(std::remove_if(data, data + count_, of_slot) - data);
    if (left == count_) return;
    count_ = left;
    index();
}

uint64_t PairCache::hash() const {
    uint64_t sum = 0;
    for (uint32_t i = 0; i < count_; ++i) {
        uint64_t words[sizeof(CachedPair) / 8], one = 0;
        std::memcpy(words, &pairs_[i], sizeof words);
        for (const uint64_t word : words) one = mix64(one ^ word);
        sum += one;
    }
    return sum;
}

void PairCache::fill(const unsigned char* from, uint32_t count) {
    if (count != 0) std::memcpy(pairs_.data(), from, sizeof(CachedPair) * size_t{count});
    count_ = count;
    index();
}

bool PairCache::consistent(const unsigned char* from, uint32_t count, uint32_t slots) {
    const auto fine = [](Vector v) { return dot(v, v) < 1e30f; }; // false for NaN
    const auto right = [&](const CachedPair& p) {
        if (p.a >= p.b || slot_of_key(p.b) >= slots || p.count > most_pair_contacts || p.sides > 3) return false;
        const Vector normal = p.normal.times(1.0f);
        const Rotation turn = p.turn.unpacked();
        if (!(std::abs(dot(turn, turn) - 1.0f) < 0.01f && std::abs(dot(normal, normal) - 1.0f) < 0.01f)) return false;
        if (!(p.within >= 0.0f) || !fine(p.offset)) return false;
        if (!fine(p.drag) || !(std::abs(p.spin) < 1e15f)) return false;
        for (uint32_t k = 0; k < most_pair_contacts; ++k)
            if (!(std::abs(p.gap[k]) < 1e15f) || !(std::abs(p.pressed[k]) < 1e15f)) return false;
        return true;
    };
    for (uint32_t i = 0; i < count; ++i) {
        CachedPair pair;
        std::memcpy(&pair, from + sizeof pair * size_t{i}, sizeof pair);
        if (!right(pair)) return false;
    }
    return true;
}
} // namespace lr
