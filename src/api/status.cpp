#include "kernel/step.h"
#include "langevin_rigid.h"

#include "hwy/targets.h"

extern "C" {

uint32_t lr_version(void) {
    return static_cast<uint32_t>(LR_VERSION_MAJOR) << 22 | static_cast<uint32_t>(LR_VERSION_MINOR) << 12 |
           static_cast<uint32_t>(LR_VERSION_PATCH);
}

const char* lr_status_string(lr_status status) {
    switch (status) {
    case LR_OK:
        return "success";
    case LR_ERROR_NULL_ARGUMENT:
        return "a pointer that must be given is null";
    case LR_ERROR_STRUCT_SIZE:
        return "struct_size is wrong: call the struct's _init function first";
    case LR_ERROR_INVALID_ARGUMENT:
        return "a value is out of its range";
    case LR_ERROR_NOT_FINITE:
        return "a number is NaN or infinite";
    case LR_ERROR_OUT_OF_MEMORY:
        return "out of memory";
    case LR_ERROR_STALE_BODY:
        return "the body was destroyed, or never was";
    case LR_ERROR_STALE_BATCH:
        return "the batch was destroyed, or never was";
    case LR_ERROR_CAPACITY:
        return "the batch, or the world's table of batches, is full";
    case LR_ERROR_BUFFER_TOO_SMALL:
        return "the buffer is too small for the result";
    case LR_ERROR_FILE_NOT_FOUND:
        return "no file at that path";
    case LR_ERROR_FILE_READ:
        return "the file exists but cannot be read";
    case LR_ERROR_ASSET_FORMAT:
        return "not an asset file";
    case LR_ERROR_ASSET_VERSION:
        return "the asset was made for a newer library";
    case LR_ERROR_ASSET_CORRUPT:
        return "the asset file is damaged";
    case LR_ERROR_ASSET_INVALID:
        return "the asset's numbers cannot be those of a body";
    case LR_ERROR_SNAPSHOT_FORMAT:
        return "not a snapshot, damaged, or of another version";
    case LR_ERROR_SNAPSHOT_MISMATCH:
        return "the snapshot is of a world with other batches or assets";
    case LR_ERROR_UNSUPPORTED:
        return "not available on this processor or in this build";
    case LR_ERROR_THREADS:
        return "the worker threads could not be started";
    case LR_ERROR_TIMESTEP_ZERO:
        return "dt is zero";
    case LR_ERROR_TIMESTEP_NEGATIVE:
        return "dt is negative";
    case LR_ERROR_TIMESTEP_NOT_FINITE:
        return "dt is NaN or infinite";
    case LR_ERROR_TIMESTEP_TOO_LARGE:
        return "dt / substeps is over one second";
    case LR_ERROR_SUBSTEPS:
        return "substeps is zero or too large";
    case LR_ERROR_STALE_WIND_SOURCE:
        return "the wind source was removed";
    case LR_ERROR_STALE_COLLIDER:
        return "the collider was destroyed, or never was";
    case LR_ERROR_CONCURRENT_USE:
        return "another thread is inside a call on the same world";
    case LR_ERROR_REENTRANT:
        return "a callback of the world called the library on it";
    case LR_ERROR_INTERNAL:
        return "a defect of the library";
    default:
        return "unknown status";
    }
}

lr_status lr_simd_targets(int32_t* targets, uint32_t capacity, uint32_t* count) {
    if (!count || (!targets && capacity != 0)) return LR_ERROR_NULL_ARGUMENT;
    size_t built = 0;
    const lr::KernelTarget* const all = lr::built_targets(built);
    uint32_t found = 0;
    for (size_t i = 0; i < built; ++i) {
        if (!lr::find_target(all[i].simd)) continue;
        if (found < capacity) targets[found] = all[i].simd;
        ++found;
    }
    *count = found;
    return targets && found > capacity ? LR_ERROR_BUFFER_TOO_SMALL : LR_OK;
}

const char* lr_simd_target_name(int32_t target) {
    switch (target) {
    case LR_SIMD_AUTO:
        return "auto";
    case LR_SIMD_SSE4:
        return "SSE4";
    case LR_SIMD_AVX2:
        return "AVX2";
    case LR_SIMD_AVX512:
        return "AVX-512";
    case LR_SIMD_NEON:
        return "NEON";
    case LR_SIMD_WASM:
        return "WebAssembly";
    case LR_SIMD_PLAIN:
        return "plain";
    default:
        return "unknown";
    }
}

} // extern "C"
