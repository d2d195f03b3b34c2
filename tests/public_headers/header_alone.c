/* Nothing before the header: it must bring all it needs. Twice, for its guard. */
#include "langevin_rigid_research.h"

/* Initialisers, without a warning. */
#define LR_STRUCT(name, initial) const name name##_initial = initial;
#include "../../src/api/structs.inc"

/* Layouts for bindings in other languages: no padding that differs between compilers. */
typedef char status_is_32_bits[sizeof(lr_status) == 4 ? 1 : -1];
typedef char batch_is_32_bits[sizeof(lr_batch) == 4 ? 1 : -1];
typedef char body_is_64_bits[sizeof(lr_body) == 8 ? 1 : -1];
typedef char body_desc_size[sizeof(lr_body_desc) == 80 ? 1 : -1];
typedef char body_state_size[sizeof(lr_body_state) == 80 ? 1 : -1];
typedef char world_desc_size[sizeof(lr_world_desc) == 24 + 24 + 24 + 8 + 24 + 8 ? 1 : -1];
typedef char gusts_desc_size[sizeof(lr_gusts_desc) == 32 ? 1 : -1];
typedef char grid_desc_size[sizeof(lr_wind_grid_desc) == 64 + sizeof(void*) ? 1 : -1];
typedef char batch_desc_size[sizeof(lr_batch_desc) == 48 ? 1 : -1];
typedef char ellipsoid_desc_size[sizeof(lr_ellipsoid_desc) == 88 ? 1 : -1];
typedef char table_size[sizeof(lr_turbulence_table) == 48 ? 1 : -1];
typedef char view_size[sizeof(lr_batch_view) == 8 + 7 * 8 + 5 * 8 + 8 + 16 ? 1 : -1];
