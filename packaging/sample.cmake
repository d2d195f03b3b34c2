# SPDX-License-Identifier: MIT
#
#   cmake -B build -DCMAKE_PREFIX_PATH=FOLDER_OF_THE_PACKAGE && cmake --build build
cmake_minimum_required(VERSION 3.16)
project(hello LANGUAGES C)
find_package(langevin_rigid 0.2 CONFIG REQUIRED)
add_executable(hello hello.c)
target_link_libraries(hello PRIVATE langevin_rigid::langevin_rigid)
add_executable(hello_static hello.c) # needs no other file to run
target_link_libraries(hello_static PRIVATE langevin_rigid::static)
set_target_properties(hello hello_static PROPERTIES C_STANDARD 99)
if(WIN32) # programs find DLLs in their own folder
    add_custom_command(TARGET hello POST_BUILD
        COMMAND ${CMAKE_COMMAND} -E copy_if_different $<TARGET_FILE:langevin_rigid::langevin_rigid> $<TARGET_FILE_DIR:hello>)
endif()
