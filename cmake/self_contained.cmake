# SPDX-License-Identifier: MIT
#
# LR_SELF_CONTAINED, for packages: programs and libraries that need only the system's C library, with static libraries from
# CMAKE_PREFIX_PATH.

# Symbols with versions newer than glibc 2.30; packaging/glibc_floor.c redirects them to older versions.
set(lr_new_in_glibc
    __libc_single_threaded __libc_start_main __pthread_key_create _dl_find_object fstat fstat64 fstatat hypot lstat
    pthread_cond_clockwait pthread_create pthread_detach pthread_getspecific pthread_join pthread_key_create pthread_key_delete
    pthread_mutex_trylock pthread_once pthread_setspecific pthread_sigmask stat stat64)

if(LR_SELF_CONTAINED AND CMAKE_SYSTEM_NAME STREQUAL "Linux")
    add_library(lr_glibc_floor OBJECT "${CMAKE_CURRENT_LIST_DIR}/../packaging/glibc_floor.c")
    target_compile_options(lr_glibc_floor PRIVATE -ffunction-sections -fdata-sections)
    target_link_libraries(lr_glibc_floor PRIVATE lr_flags)
endif()

function(lr_self_contained target)
    if(NOT LR_SELF_CONTAINED)
        return()
    endif()
    if(WIN32)
        # No link time in the file, so that equal sources give equal bytes.
        target_link_options(${target} PRIVATE -static LINKER:--no-insert-timestamp)
        return()
    endif()
    target_link_options(${target} PRIVATE -static-libgcc -static-libstdc++ LINKER:--exclude-libs,ALL LINKER:--gc-sections)
    if(TARGET lr_glibc_floor)
        target_sources(${target} PRIVATE $<TARGET_OBJECTS:lr_glibc_floor>)
        list(TRANSFORM lr_new_in_glibc PREPEND LINKER:--wrap= OUTPUT_VARIABLE wraps)
        # Before 2.34 threads were in libpthread, which newer systems still have, empty.
        target_link_options(${target} PRIVATE ${wraps}
            LINKER:--push-state,--no-as-needed -l:libpthread.so.0 LINKER:--pop-state)
    endif()
endfunction()
