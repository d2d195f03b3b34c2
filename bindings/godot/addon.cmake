# Makes the addon: OUTPUT/ with the .gdextension file, icons and licences, and in bin/ the extension. Run by the build: cmake -D... -P addon.cmake
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
string(REPLACE darwin macos system "${system}")
if(system STREQUAL "emscripten")
  set(system web)
  set(arch wasm32)
endif()

set(bin "${OUTPUT}/bin/${system}_${arch}")
file(MAKE_DIRECTORY "${bin}")
get_filename_component(extension "${EXTENSION}" EXT)
file(COPY_FILE "${EXTENSION}" "${bin}/langevin_rigid_godot${extension}" ONLY_IF_DIFFERENT)
file(COPY "${SOURCE}/addon/" DESTINATION "${OUTPUT}")
file(COPY_FILE "${SOURCE}/../../LICENSE" "${OUTPUT}/LICENSE" ONLY_IF_DIFFERENT)

# Highway is within packaged libraries. Where it is not, games must ship it too.
if(system STREQUAL "linux")
  file(GET_RUNTIME_DEPENDENCIES LIBRARIES "${EXTENSION}" RESOLVED_DEPENDENCIES_VAR needed
       UNRESOLVED_DEPENDENCIES_VAR missing POST_INCLUDE_REGEXES "libhwy\\.so" POST_EXCLUDE_REGEXES ".*")
  if(missing MATCHES "hwy")
    message(FATAL_ERROR "the extension needs ${missing}, which is not installed")
  endif()
  foreach(file IN LISTS needed)
    get_filename_component(name "${file}" NAME)
    file(REAL_PATH "${file}" real)
    file(COPY_FILE "${real}" "${bin}/${name}" ONLY_IF_DIFFERENT)
    file(APPEND "${OUTPUT}/langevin_rigid.gdextension" "
[dependencies]

linux.single.${arch} = {
\"res://addons/langevin_rigid/bin/linux_${arch}/${name}\": \"\"
}
")
  endforeach()
endif()
message(STATUS "addon in ${OUTPUT}")
