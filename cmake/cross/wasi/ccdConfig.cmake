# libccd from its Debian source package: scripts/setup.sh test leaves it at LR_CCD_SOURCE. Its headers, with the precision that
# they were configured for, are those of libccd-dev.
include("${CMAKE_CURRENT_LIST_DIR}/host_headers.cmake")
set(LR_CCD_SOURCE "${PROJECT_SOURCE_DIR}/build/sources/libccd" CACHE PATH "Unpacked sources of libccd")
if(NOT EXISTS "${LR_CCD_SOURCE}/src/ccd.c")
    message(FATAL_ERROR "No sources of libccd in ${LR_CCD_SOURCE}: run scripts/setup.sh test, set LR_CCD_SOURCE, or build with -DLR_WITH_CCD=OFF.")
endif()
add_library(ccd STATIC "${LR_CCD_SOURCE}/src/ccd.c" "${LR_CCD_SOURCE}/src/mpr.c" "${LR_CCD_SOURCE}/src/polytope.c"
    "${LR_CCD_SOURCE}/src/support.c" "${LR_CCD_SOURCE}/src/vec3.c")
set_target_properties(ccd PROPERTIES C_VISIBILITY_PRESET hidden)
target_compile_options(ccd PRIVATE -ffp-contract=off -w)
target_compile_definitions(ccd PUBLIC CCD_STATIC_DEFINE)
lr_host_headers(ccd ccd)
target_include_directories(ccd PRIVATE $<TARGET_PROPERTY:ccd,INTERFACE_INCLUDE_DIRECTORIES>)
