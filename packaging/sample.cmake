# SPDX-License-Identifier: MIT
#
#   cmake -B build -DCMAKE_PREFIX_PATH=FOLDER_OF_THE_PACKAGE && cmake --build build
cmake_minimum_required(VERSION 3.16)
project(hello LANGUAGES C CXX)
find_package(langevin_rigid 0.2 CONFIG REQUIRED)
add_executable(hello hello.c)
target_link_libraries(hello PRIVATE langevin_rigid::langevin_rigid)
set_target_properties(hello PROPERTIES C_STANDARD 99)
if(NOT MSVC) # the static library is for GCC and clang
    add_executable(hello_static hello.c) # needs no other file to run
    target_link_libraries(hello_static PRIVATE langevin_rigid::static)
    set_target_properties(hello_static PROPERTIES C_STANDARD 99)
endif()
foreach(name leaves dart confetti coin car fountain) # docs/guide/tutorial.md and recipes.md explain them
    add_executable(${name} ${name}.cpp)
    target_compile_features(${name} PRIVATE cxx_std_17)
    target_link_libraries(${name} PRIVATE langevin_rigid::langevin_rigid)
    if(MINGW)
        target_link_options(${name} PRIVATE -static) # its C++ runtime
    endif()
endforeach()
if(WIN32) # programs find DLLs in their own folder
    add_custom_command(TARGET hello POST_BUILD
        COMMAND ${CMAKE_COMMAND} -E copy_if_different $<TARGET_FILE:langevin_rigid::langevin_rigid> $<TARGET_FILE_DIR:hello>)
endif()
