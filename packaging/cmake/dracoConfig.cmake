# SPDX-License-Identifier: MIT
#
# Like Debian's: assimp links DRACO_LIBRARIES.
get_filename_component(prefix_of_this "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
if(NOT TARGET draco::draco)
    add_library(draco::draco STATIC IMPORTED)
    set_target_properties(draco::draco PROPERTIES
        IMPORTED_LOCATION "${prefix_of_this}/lib/libdraco.a" INTERFACE_INCLUDE_DIRECTORIES "${prefix_of_this}/include")
endif()
set(DRACO_LIBRARIES draco::draco)
