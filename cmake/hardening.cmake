# SPDX-License-Identifier: MIT
#
# Hardening: a memory error ends the process instead of being exploitable. docs/maintainers/testing.md explains each flag and its
# cost; tests/security/check_hardening.sh checks the built files.
#   lr_harden(TARGET [EXCEPT SOURCE...])     additional flags for shipped targets

set(lr_hardening "")
set(lr_no_hardening "") # reverts lr_hardening
if(LR_SANITIZE) # sanitizers find more and exclude hardening
elseif(CMAKE_SYSTEM_NAME STREQUAL "Linux")
    target_compile_options(lr_flags INTERFACE -fstack-protector-strong)
    target_link_options(lr_flags INTERFACE -Wl,-z,relro,-z,now,-z,noexecstack)
    # CMake compiles position-independent programs, but links them as such only after this check.
    include(CheckPIESupported)
    check_pie_supported(LANGUAGES C CXX)
    # _FORTIFY_SOURCE needs an optimised build.
    set(optimised "$<CONFIG:Release,RelWithDebInfo,MinSizeRel>")
    list(APPEND lr_hardening "$<${optimised}:-U_FORTIFY_SOURCE>" "$<${optimised}:-D_FORTIFY_SOURCE=2>")
    list(APPEND lr_no_hardening -U_FORTIFY_SOURCE)
    if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
        list(APPEND lr_hardening -fstack-clash-protection -fcf-protection=full)
        list(APPEND lr_no_hardening -fno-stack-clash-protection -fcf-protection=none)
    elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64)$")
        list(APPEND lr_hardening -mbranch-protection=standard $<$<CXX_COMPILER_ID:GNU>:-fstack-clash-protection>)
        list(APPEND lr_no_hardening -mbranch-protection=none $<$<CXX_COMPILER_ID:GNU>:-fno-stack-clash-protection>)
    endif()
elseif(MINGW)
    # No stack protector: GCC's gets its secret from ADVAPI32, and the library must need no DLL but KERNEL32 and msvcrt.
    target_link_options(lr_flags INTERFACE LINKER:--dynamicbase,--nxcompat,--high-entropy-va)
endif()

function(lr_harden target)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" EXCEPT)
    target_compile_options(${target} PRIVATE ${lr_hardening})
    set_property(SOURCE ${arg_EXCEPT} APPEND PROPERTY COMPILE_OPTIONS ${lr_no_hardening})
endfunction()
