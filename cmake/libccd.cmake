# libccd, compiled with the project's own flags from its distribution's sources, which scripts/setup.sh fetches: its answers move
# bodies, and a binary of somebody else may fuse products and sums. The runtime needs mpr.c, support.c and vec3.c; the linker leaves
# the other two to the tests that have its expanding polytope as their reference.
set(LR_CCD_SOURCE "${PROJECT_SOURCE_DIR}/build/sources/libccd" CACHE PATH "Unpacked sources of libccd 2.1")
if(NOT EXISTS "${LR_CCD_SOURCE}/src/mpr.c")
    message(FATAL_ERROR "No sources of libccd in ${LR_CCD_SOURCE}: run scripts/setup.sh, which needs the network for them once, "
        "or set LR_CCD_SOURCE to the folder of an unpacked libccd 2.1.")
endif()
# For Windows vec3.h has a minimum of its own, which answers a NaN otherwise than the C library's. Here it is everywhere, in the same
# words, so that the two definitions agree.
file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/libccd/ccd/config.h"
    CONTENT "#define CCD_DOUBLE\n# define CCD_FMIN(x, y) ((x) < (y) ? (x) : (y))\n")

set(lr_ccd_files ccd.c mpr.c polytope.c support.c vec3.c)
list(TRANSFORM lr_ccd_files PREPEND "${LR_CCD_SOURCE}/src/")
add_library(lr_ccd STATIC ${lr_ccd_files})
target_include_directories(lr_ccd SYSTEM PUBLIC "${PROJECT_BINARY_DIR}/libccd" "${LR_CCD_SOURCE}/src")
target_compile_definitions(lr_ccd PUBLIC CCD_STATIC_DEFINE) # nothing of it is exported
target_compile_options(lr_ccd PRIVATE -w) # not written for our warnings
target_link_libraries(lr_ccd PRIVATE lr_flags)
lr_harden(lr_ccd)
