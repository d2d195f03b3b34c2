# SPDX-License-Identifier: MIT
#
#   cmake -B build -DCMAKE_PREFIX_PATH=FOLDER_OF_THE_PACKAGE && cmake --build build
cmake_minimum_required(VERSION 3.16)
project(hello LANGUAGES C)
find_package(langevin_rigid 0.2 CONFIG REQUIRED)
add_executable(hello hello.c)
set_target_properties(hello PROPERTIES C_STANDARD 99)
target_link_libraries(hello PRIVATE langevin_rigid::langevin_rigid)
if(WIN32) # programs find DLLs in their own folder
    add_custom_command(TARGET hello POST_BUILD
        COMMAND ${CMAKE_COMMAND} -E copy_if_different $<TARGET_FILE:langevin_rigid::langevin_rigid> $<TARGET_FILE_DIR:hello>)
endif()
