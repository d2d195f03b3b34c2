// The _init functions.
#include "api/struct_conversion.h"

namespace lr::api {
namespace {

// The caller's struct is larger or smaller if its header is newer or older.
lr_status init(void* s, uint32_t struct_size, const void* initial, size_t own, size_t first,
               const char* function = __builtin_FUNCTION()) {
    if (!s) return note_refusal(function, LR_ERROR_NULL_ARGUMENT);
    if (!is_struct_size(struct_size, own, first)) return note_refusal(function, LR_ERROR_STRUCT_SIZE);
    std::memset(s, 0, struct_size);
    std::memcpy(s, initial, std::min<size_t>(struct_size, own));
    std::memcpy(s, &struct_size, sizeof struct_size); // the first field
    return LR_OK;
}
} // namespace
} // namespace lr::api

// NOLINTBEGIN(bugprone-macro-parentheses): a type
#define LR_STRUCT(name, initial)                                                                                       \
    lr_status name##_init(name* s, uint32_t struct_size) {                                                             \
        static constexpr name begins = initial; /* static, so that padding is 0 */                                     \
        return lr::api::init(s, struct_size, &begins, sizeof begins, lr::api::first_size<name>);                       \
    }
// NOLINTEND(bugprone-macro-parentheses)
extern "C" {
#include "api/structs.inc"
}
