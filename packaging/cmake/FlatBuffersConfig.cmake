# SPDX-License-Identifier: MIT
#
# Headers in this prefix, and the compiler of the machine that builds.
get_filename_component(prefix_of_this "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
find_program(LR_FLATC flatc REQUIRED)
if(NOT TARGET flatbuffers::flatbuffers)
    add_library(flatbuffers::flatbuffers INTERFACE IMPORTED)
    set_target_properties(flatbuffers::flatbuffers PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${prefix_of_this}/include")
    add_executable(flatbuffers::flatc IMPORTED)
    set_target_properties(flatbuffers::flatc PROPERTIES IMPORTED_LOCATION "${LR_FLATC}")
endif()
