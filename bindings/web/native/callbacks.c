/*
 * Callbacks of the library as calls into JavaScript. In WebAssembly a function pointer to a JavaScript function needs features
 * that some browsers lack. Instead, `user` is a number that selects the host's function.
 *
 * SPDX-License-Identifier: MIT
 */
#include <langevin_rigid.h>

#define LR_HOST(name) __attribute__((import_module("langevin_rigid"), import_name(#name)))

LR_HOST(log) void host_log(void* user, int32_t level, const char* message);
LR_HOST(fault) void host_fault(void* user, uint32_t number, const char* where, const char* what, const char* remedy);
LR_HOST(wind) void host_wind(void* user, const lr_wind_query* query);
LR_HOST(surface) void host_surface(void* user, const lr_water_query* query);
LR_HOST(record) int32_t host_record(void* user, const void* bytes, uint64_t size);

/* Function pointers for the library; the host writes them into structs and arguments. */
lr_log_fn lr_web_log(void);
lr_fault_fn lr_web_fault(void);
lr_wind_fn lr_web_wind(void);
lr_water_fn lr_web_surface(void);
lr_record_fn lr_web_record(void);

lr_log_fn lr_web_log(void) {
    return host_log;
}
lr_fault_fn lr_web_fault(void) {
    return host_fault;
}
lr_wind_fn lr_web_wind(void) {
    return host_wind;
}
lr_water_fn lr_web_surface(void) {
    return host_surface;
}
lr_record_fn lr_web_record(void) {
    return host_record;
}
