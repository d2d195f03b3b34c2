#include "api/check_arguments.h"
#include "kernel/integrator/step.h"
#include "langevin_rigid.h"

#include "hwy/targets.h"

namespace {

struct Text {
    int32_t of;
    const char* text;
};
constexpr Text texts[] = {
#include "api/status_texts.inc"
};
constexpr Text target_names[] = {
    {LR_SIMD_AUTO, "auto"}, {LR_SIMD_SSE4, "SSE4"},        {LR_SIMD_AVX2, "AVX2"},   {LR_SIMD_AVX512, "AVX-512"},
    {LR_SIMD_NEON, "NEON"}, {LR_SIMD_WASM, "WebAssembly"}, {LR_SIMD_PLAIN, "plain"},
};

template <size_t N> const char* text_of(int32_t which, const Text (&all)[N], const char* unknown) {
    for (const Text& t : all)
        if (t.of == which) return t.text;
    return unknown;
}
} // namespace

using lr::api::note_refusal;

extern "C" {

uint32_t lr_version(void) {
    return static_cast<uint32_t>(LR_VERSION_MAJOR) << 22 | static_cast<uint32_t>(LR_VERSION_MINOR) << 12 |
           static_cast<uint32_t>(LR_VERSION_PATCH);
}

const char* lr_status_string(lr_status status) {
    return text_of(status, texts, "unknown status");
}

const char* lr_last_error(void) {
    return lr::last_error();
}

lr_status lr_simd_targets(int32_t* targets, uint32_t capacity, uint32_t* count) {
    if (!count || (!targets && capacity != 0)) return note_refusal("lr_simd_targets", LR_ERROR_NULL_ARGUMENT);
    size_t built = 0;
    const lr::KernelTarget* const all = lr::built_targets(built);
    uint32_t found = 0;
    for (size_t i = 0; i < built; ++i) {
        if (!lr::find_target(all[i].simd)) continue;
        if (found < capacity) targets[found] = all[i].simd;
        ++found;
    }
    *count = found;
    return note_refusal("lr_simd_targets", targets && found > capacity ? LR_ERROR_BUFFER_TOO_SMALL : LR_OK);
}

const char* lr_simd_target_name(int32_t target) {
    return text_of(target, target_names, "unknown");
}

} // extern "C"
