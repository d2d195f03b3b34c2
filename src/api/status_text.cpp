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
    {LR_OK, "success"},
    {LR_ERROR_NULL_ARGUMENT, "a required pointer is null"},
    {LR_ERROR_STRUCT_SIZE, "struct_size is wrong: call the struct's _init function first"},
    {LR_ERROR_INVALID_ARGUMENT, "a value is out of range"},
    {LR_ERROR_NOT_FINITE, "a number is NaN or infinite"},
    {LR_ERROR_OUT_OF_MEMORY, "out of memory"},
    {LR_ERROR_STALE_BODY, "the body was destroyed, or never existed"},
    {LR_ERROR_STALE_BATCH, "the batch was destroyed, or never existed"},
    {LR_ERROR_CAPACITY, "the batch, or the world's table of batches, is full"},
    {LR_ERROR_BUFFER_TOO_SMALL, "the buffer is too small for the result"},
    {LR_ERROR_FILE_NOT_FOUND, "no file at that path"},
    {LR_ERROR_FILE_READ, "the file exists but cannot be read"},
    {LR_ERROR_ASSET_FORMAT, "not an asset file"},
    {LR_ERROR_ASSET_VERSION, "the asset was made for a newer library"},
    {LR_ERROR_ASSET_CORRUPT, "the asset file is damaged"},
    {LR_ERROR_ASSET_INVALID, "the asset has numbers that no body can have"},
    {LR_ERROR_SNAPSHOT_FORMAT, "not a snapshot, damaged, or of another version"},
    {LR_ERROR_SNAPSHOT_MISMATCH, "the snapshot's world has other batches or assets"},
    {LR_ERROR_UNSUPPORTED, "not available on this processor or in this build"},
    {LR_ERROR_THREADS, "the worker threads could not be started"},
    {LR_ERROR_TIMESTEP_ZERO, "dt is zero"},
    {LR_ERROR_TIMESTEP_NEGATIVE, "dt is negative"},
    {LR_ERROR_TIMESTEP_NOT_FINITE, "dt is NaN or infinite"},
    {LR_ERROR_TIMESTEP_TOO_LARGE, "dt / substeps is over one second"},
    {LR_ERROR_SUBSTEPS, "substeps is zero or too large"},
    {LR_ERROR_STALE_WIND_SOURCE, "the wind source was removed, or never existed"},
    {LR_ERROR_STALE_COLLIDER, "the collider was destroyed, or never existed"},
    {LR_ERROR_CONCURRENT_USE, "another thread is inside a call on the same world"},
    {LR_ERROR_REENTRANT, "called from one of the world's callbacks"},
    {LR_ERROR_INTERNAL, "a bug in the library"},
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

using lr::api::told;

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
    if (!count || (!targets && capacity != 0)) return told("lr_simd_targets", LR_ERROR_NULL_ARGUMENT);
    size_t built = 0;
    const lr::KernelTarget* const all = lr::built_targets(built);
    uint32_t found = 0;
    for (size_t i = 0; i < built; ++i) {
        if (!lr::find_target(all[i].simd)) continue;
        if (found < capacity) targets[found] = all[i].simd;
        ++found;
    }
    *count = found;
    return told("lr_simd_targets", targets && found > capacity ? LR_ERROR_BUFFER_TOO_SMALL : LR_OK);
}

const char* lr_simd_target_name(int32_t target) {
    return text_of(target, target_names, "unknown");
}

} // extern "C"
