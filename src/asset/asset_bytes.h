// The bytes of an asset file: the only file that the runtime ever opens.
#pragma once

#include "langevin_rigid.h"

#include <vector>

namespace lr {

// Of a regular file, whole. It does not wait for a pipe nor read a device, and a child process does not inherit it.
// LR_OK, LR_ERROR_FILE_NOT_FOUND, LR_ERROR_FILE_READ, LR_ERROR_ASSET_CORRUPT (over 1 GiB), LR_ERROR_OUT_OF_MEMORY; throws
// std::bad_alloc.
lr_status read_asset_bytes(const char* path_utf8, std::vector<unsigned char>& out);

} // namespace lr
