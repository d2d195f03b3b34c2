# SPDX-License-Identifier: MIT
#
# langevin_rigid_static: the runtime as one object. On ELF it contains the C++ runtime, and its only global symbols are those of the API: a C program
# links it without a C++ compiler, next to any C++ runtime, and no name can collide with another library's. COFF's linker finds copies of inline
# functions by name, so there all stay global, in the namespaces lr, hwy and flatbuffers, and programs link libstdc++ themselves.
set(object "${CMAKE_CURRENT_BINARY_DIR}/langevin_rigid_static${CMAKE_CXX_OUTPUT_EXTENSION}")
set(objects $<TARGET_OBJECTS:lr_core> $<TARGET_OBJECTS:lr_kernel> $<TARGET_OBJECTS:lr_assets>)
set(strip $<$<CONFIG:Release>:--strip-unneeded>)
set(needs "")
get_target_property(hwy hwy::hwy TYPE)
if(hwy STREQUAL "INTERFACE_LIBRARY") # headers alone, where there is one instruction set
elseif(LR_SELF_CONTAINED)
    list(APPEND objects $<TARGET_FILE:hwy::hwy>)
else()
    list(APPEND needs -lhwy)
endif()
if(WIN32)
    set(absorbed "")
    list(APPEND needs -l:libstdc++.a -l:libwinpthread.a) # not the DLLs
    set(finish "${CMAKE_OBJCOPY}" ${strip} --remove-section=.drectve "${object}") # the DLL's exports
else()
    # Not libgcc.a, which every program links. Without groups, of which a linker would drop those that it knows from other files, with local
    # symbols in use.
    set(absorbed -Wl,--force-group-allocation -l:libstdc++.a -l:libgcc_eh.a)
    list(APPEND needs -lm -pthread)
    # Unique symbols must be weak before they can be local. A function of Highway that another library defines must not be.
    set(finish "${CMAKE_OBJCOPY}" --wildcard --weaken-symbol=!_ZN3hwy* --weaken-symbol=_Z* "${object}"
        COMMAND "${CMAKE_OBJCOPY}" --wildcard --keep-global-symbol=lr_* ${strip} "${object}")
endif()
add_custom_command(OUTPUT "${object}"
    COMMAND "${CMAKE_CXX_COMPILER}" -r -nostdlib -o "${object}" ${objects} ${absorbed}
    COMMAND ${finish}
    DEPENDS lr_core lr_kernel lr_assets ${objects} COMMAND_EXPAND_LISTS VERBATIM)
add_library(langevin_rigid_static STATIC "${object}")
set_source_files_properties("${object}" PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
set_target_properties(langevin_rigid_static PROPERTIES LINKER_LANGUAGE C EXPORT_NAME static)
target_compile_definitions(langevin_rigid_static INTERFACE LR_STATIC)
target_include_directories(langevin_rigid_static INTERFACE
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_link_libraries(langevin_rigid_static INTERFACE ${needs})
add_library(langevin_rigid::static ALIAS langevin_rigid_static)
