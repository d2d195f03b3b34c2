// The _init functions.
#include "api/struct_conversion.h"

namespace lr::api {
namespace {

// The caller's struct is larger or smaller if its header is newer or older.
template <Sized T> lr_status init(T* s, uint32_t struct_size, const T& initial) {
    if (!s) return LR_ERROR_NULL_ARGUMENT;
    if (!is_struct_size<T>(struct_size)) return LR_ERROR_STRUCT_SIZE;
    std::memset(static_cast<void*>(s), 0, struct_size);
    std::memcpy(static_cast<void*>(s), &initial, std::min<size_t>(struct_size, sizeof initial));
    s->struct_size = struct_size;
    return LR_OK;
}
} // namespace
} // namespace lr::api

// NOLINTBEGIN(bugprone-macro-parentheses): a type
#define LR_STRUCT(name, initial)                                                                                       \
    lr_status name##_init(name* s, uint32_t struct_size) {                                                             \
        static constexpr name begins = initial; /* static, so that padding is 0 */                                     \
        return lr::api::note_refusal(#name "_init", lr::api::init(s, struct_size, begins));                            \
    }
// NOLINTEND(bugprone-macro-parentheses)
extern "C" {
#include "api/structs.inc"
}
