# Installs the library, a CMake package, a pkg-config file and the tools. Components: runtime, bake (lr_bake, lr_drop, lr_replay), development (the rest).
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)
foreach(library langevin_rigid langevin_rigid_static)
    if(TARGET ${library})
        install(TARGETS ${library} EXPORT langevin_rigid_targets COMPONENT runtime
            LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime
            ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime)
    endif()
endforeach()
if(TARGET lr_bake)
    install(TARGETS lr_bake lr_drop lr_replay RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT bake)
endif()
if(TARGET langevin_rigid_baker)
    # Separate from the runtime's targets, whose users must not need assimp.
    install(TARGETS langevin_rigid_baker EXPORT langevin_rigid_baker_targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
    install(FILES include/langevin_rigid_baker.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
    install(EXPORT langevin_rigid_baker_targets NAMESPACE langevin_rigid::
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/langevin_rigid)
endif()
install(FILES include/langevin_rigid.h include/langevin_rigid.hpp include/langevin_rigid_research.h
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT runtime)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/langevin_rigid)
install(EXPORT langevin_rigid_targets NAMESPACE langevin_rigid:: DESTINATION ${package_dir} COMPONENT runtime)
configure_package_config_file(cmake/langevin_rigid-config.cmake.in
    "${PROJECT_BINARY_DIR}/langevin_rigid-config.cmake" INSTALL_DESTINATION ${package_dir})
# Before 1.0 each minor version has its own ABI.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/langevin_rigid-config-version.cmake"
    COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/langevin_rigid-config.cmake"
    "${PROJECT_BINARY_DIR}/langevin_rigid-config-version.cmake" DESTINATION ${package_dir} COMPONENT runtime)

# Relative path from the .pc file to the prefix, so that the package can be moved: two folders up, or three on multiarch systems.
file(RELATIVE_PATH LR_PC_UP "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
string(REGEX REPLACE "/$" "" LR_PC_UP "${LR_PC_UP}")
function(lr_pkg_config target component requires cflags)
    if(TARGET ${target})
        string(JOIN " " libs -l${target} ${ARGN})
        configure_file(cmake/langevin_rigid.pc.in "${PROJECT_BINARY_DIR}/${target}.pc" @ONLY)
        install(FILES "${PROJECT_BINARY_DIR}/${target}.pc" DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT ${component})
    endif()
endfunction()
lr_pkg_config(langevin_rigid runtime "" "")
if(TARGET langevin_rigid_static)
    get_target_property(static_needs langevin_rigid_static INTERFACE_LINK_LIBRARIES)
    if(NOT static_needs)
        set(static_needs "")
    endif()
    lr_pkg_config(langevin_rigid_static runtime "" "-DLR_STATIC" ${LR_PC_CXX} ${static_needs})
endif()
lr_pkg_config(langevin_rigid_baker development "libhwy assimp libpng zlib" "" -lstdc++ -lm -pthread)
