# Headers without the library: enough for one instruction set, which is then chosen when compiled.
add_library(hwy::hwy INTERFACE IMPORTED)
if(WASI)
    include("${CMAKE_CURRENT_LIST_DIR}/wasi/host_headers.cmake")
    lr_host_headers(hwy::hwy hwy)
endif()
