# Headers without the library: sufficient for one instruction set, chosen at compile time.
add_library(hwy::hwy INTERFACE IMPORTED)
if(WASI)
    include("${CMAKE_CURRENT_LIST_DIR}/wasi/host_headers.cmake")
    lr_host_headers(hwy::hwy hwy)
endif()
