# SPDX-License-Identifier: MIT
#
# 64-bit Windows, cross-compiled with Debian's MinGW and run by Wine (scripts/setup.sh windows). Dependencies are searched only in
# CMAKE_FIND_ROOT_PATH, which packaging/build_dependencies.sh windows-x64 builds.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR AMD64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
find_program(LR_WINE NAMES wine64 wine PATHS /usr/lib/wine)
if(LR_WINE)
    set(CMAKE_CROSSCOMPILING_EMULATOR "${LR_WINE}")
endif()
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
