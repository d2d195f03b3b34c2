// Sequences of calls with any arguments, against a model of their results: docs/maintainers/testing.md.
#include "fuzz/api/model.h"

#include <mutex>
#include <set>
#include <string>

namespace fuzz {
namespace {

std::set<std::string>& reached_set() {
    static std::set<std::string> all;
    return all;
}

const std::vector<Named>& operations() {
    static const std::vector<Named> all = [] {
        std::vector<Named> list;
        for (const auto& part :
             {step_operations(), asset_operations(), world_operations(), wind_operations(), batch_operations(),
              load_operations(), body_operations(), force_operations(), collider_operations(), query_operations(),
              lifecycle_operations(), snapshot_operations(), recording_operations()})
            list.insert(list.end(), part.begin(), part.end());
        return list;
    }();
    return all;
}

constexpr size_t most_records = 48;

} // namespace

bool note_reached(const char* function) {
    return reached_set().insert(function).second;
}

// For the replay of the corpus.
const std::set<std::string>& reached() {
    return reached_set();
}

} // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    static const bool verbose = std::getenv("LR_FUZZ_VERBOSE") != nullptr;
    fuzz::Fuzzer fuzzer{fuzz::Input(data, size)};
    fuzz::begin_scene(fuzzer);
    const auto& operations = fuzz::operations();
    for (size_t i = 0; i < fuzz::most_records && fuzzer.in.next(); ++i) {
        const fuzz::Named& operation = operations[fuzzer.in.operation() % operations.size()];
        if (verbose) std::fprintf(stderr, "%zu %s\n", i, operation.name);
        operation.run(fuzzer);
    }
    fuzz::call_plain(fuzzer);
    return 0;
}

#ifdef LR_LIBFUZZER
extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t most);

// Inserts, removes, repeats and exchanges whole calls; and changes bytes as libFuzzer does, within a call or anywhere.
extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t most, unsigned int seed) {
    constexpr size_t n = fuzz::record_bytes;
    uint32_t state = seed * 2654435761u + 12345u;
    const auto random = [&](size_t below) {
        state = state * 1664525u + 1013904223u;
        return below == 0 ? 0 : static_cast<size_t>(state >> 8) % below;
    };
    const size_t records = size / n;
    uint8_t* const one = data + n * random(records);
    const uint32_t what = static_cast<uint32_t>(random(8));
    if (records == 0 || what >= 6) return LLVMFuzzerMutate(data, size, most);
    if (what >= 4) { // the bytes of one call
        LLVMFuzzerMutate(one, n, n);
        return size;
    }
    if (what == 0 && records > 1) { // removes a call
        std::memmove(one, one + n, static_cast<size_t>(data + size - one) - n);
        return size - n;
    }
    if (what == 1) { // exchanges two calls
        uint8_t* const two = data + n * random(records);
        for (size_t i = 0; i < n; ++i) std::swap(one[i], two[i]);
        return size;
    }
    if (size + n > most) return size;
    uint8_t copy[n];
    std::memcpy(copy, data + n * random(records), n);
    if (what == 3) { // inserts a plain call: no override, no null
        for (uint8_t& byte : copy) byte = static_cast<uint8_t>(random(256));
        copy[1] = static_cast<uint8_t>(copy[1] & (random(4) == 0 ? 0xff : 0xc1)),
        copy[2] = static_cast<uint8_t>(copy[2] & 0xf8);
    }
    std::memmove(one + n, one, static_cast<size_t>(data + size - one));
    std::memcpy(one, copy, n);
    return size + n;
}
#endif
