# Makes the addon: OUTPUT/ with the .gdextension file, icons and licence, and in bin/ the extension, the library and the dependencies
# that a fresh machine lacks. Run by the build: cmake -D... -P addon.cmake
# SPDX-License-Identifier: MIT
cmake_minimum_required(VERSION 3.20)

if(PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
  set(arch x86_64)
elseif(PROCESSOR MATCHES "^(aarch64|arm64|ARM64)$")
  set(arch arm64)
else()
  set(arch "${PROCESSOR}")
endif()
string(TOLOWER "${SYSTEM}" system)

set(bin "${OUTPUT}/bin/${system}_${arch}")
file(MAKE_DIRECTORY "${bin}")
get_filename_component(extension "${EXTENSION}" EXT)
file(COPY_FILE "${EXTENSION}" "${bin}/langevin_rigid_godot${extension}" ONLY_IF_DIFFERENT)

if(system STREQUAL "linux")
  # The loader looks for the soname, which is a link in the package.
  file(REAL_PATH "${LIBRARY}" real)
  get_filename_component(directory "${LIBRARY}" DIRECTORY)
  file(COPY_FILE "${real}" "${bin}/liblangevin_rigid.so.0" ONLY_IF_DIFFERENT)
  file(GET_RUNTIME_DEPENDENCIES LIBRARIES "${real}" RESOLVED_DEPENDENCIES_VAR needed
       UNRESOLVED_DEPENDENCIES_VAR missing DIRECTORIES "${directory}"
       POST_INCLUDE_REGEXES "libhwy\\.so" POST_EXCLUDE_REGEXES ".*")
  if(missing MATCHES "hwy")
    message(FATAL_ERROR "the library needs ${missing}, which is not installed")
  endif()
  foreach(file IN LISTS needed)
    get_filename_component(name "${file}" NAME)
    file(REAL_PATH "${file}" real)
    file(COPY_FILE "${real}" "${bin}/${name}" ONLY_IF_DIFFERENT)
  endforeach()
else()
  get_filename_component(name "${LIBRARY}" NAME)
  file(COPY_FILE "${LIBRARY}" "${bin}/${name}" ONLY_IF_DIFFERENT)
endif()

file(COPY "${SOURCE}/addon/" DESTINATION "${OUTPUT}")
# If Highway is linked into the library, there is no file for it: game exports would look for one that is listed here.
if(NOT EXISTS "${bin}/libhwy.so.1")
  file(READ "${OUTPUT}/langevin_rigid.gdextension" names)
  string(REGEX REPLACE ",\n[^\n]*/${system}_${arch}/libhwy.so.1\": \"\"" "" names "${names}")
  file(WRITE "${OUTPUT}/langevin_rigid.gdextension" "${names}")
endif()
file(COPY_FILE "${SOURCE}/../../LICENSE" "${OUTPUT}/LICENSE" ONLY_IF_DIFFERENT)
# Licenses of code in the library, which is in PREFIX/lib, PREFIX/lib/ARCHITECTURE or PREFIX/bin.
get_filename_component(directory "${LIBRARY}" DIRECTORY)
file(GLOB licences "${directory}/../share/doc/langevin_rigid/LICENSE.*" "${directory}/../../share/doc/langevin_rigid/LICENSE.*")
file(COPY ${licences} DESTINATION "${OUTPUT}")
message(STATUS "addon in ${OUTPUT}")
