# Headers, and flatc of the build machine.
find_program(LR_FLATC flatc REQUIRED)
add_library(flatbuffers::flatbuffers INTERFACE IMPORTED)
add_executable(flatbuffers::flatc IMPORTED)
set_target_properties(flatbuffers::flatc PROPERTIES IMPORTED_LOCATION "${LR_FLATC}")
if(WASI)
    include("${CMAKE_CURRENT_LIST_DIR}/wasi/host_headers.cmake")
    lr_host_headers(flatbuffers::flatbuffers flatbuffers)
endif()
