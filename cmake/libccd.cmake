# libccd, compiled with the project's flags from Debian's sources, which scripts/setup.sh fetches: its results move bodies, and a
# prebuilt binary could contain fused multiply-adds. The runtime links mpr.c, support.c and vec3.c; only tests, which use its
# expanding polytope as a reference, link the other two files.
set(LR_CCD_SOURCE "${PROJECT_SOURCE_DIR}/build/sources/libccd" CACHE PATH "Unpacked sources of libccd 2.1")
if(NOT EXISTS "${LR_CCD_SOURCE}/src/mpr.c")
    message(FATAL_ERROR "No sources of libccd in ${LR_CCD_SOURCE}: run scripts/setup.sh, which fetches them once over the network, "
        "or set LR_CCD_SOURCE to the folder of an unpacked libccd 2.1.")
endif()
# On Windows vec3.h defines its own minimum, which treats NaN differently from fmin. Define the same text on all platforms, so
# that both definitions agree.
file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/libccd/ccd/config.h"
    CONTENT "#define CCD_DOUBLE\n# define CCD_FMIN(x, y) ((x) < (y) ? (x) : (y))\n")

set(lr_ccd_files ccd.c mpr.c polytope.c support.c vec3.c)
list(TRANSFORM lr_ccd_files PREPEND "${LR_CCD_SOURCE}/src/")
add_library(lr_ccd STATIC ${lr_ccd_files})
target_include_directories(lr_ccd SYSTEM PUBLIC "${PROJECT_BINARY_DIR}/libccd" "${LR_CCD_SOURCE}/src")
target_compile_definitions(lr_ccd PUBLIC CCD_STATIC_DEFINE) # no exports
target_compile_options(lr_ccd PRIVATE -w) # third-party code
target_link_libraries(lr_ccd PRIVATE lr_flags)
lr_harden(lr_ccd)
