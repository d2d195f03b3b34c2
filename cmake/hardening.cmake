# SPDX-License-Identifier: MIT
#
# What makes a defect of memory an end of the process rather than a way in. docs/maintainers/testing.md says what each flag is for and what it
# costs; tests/security/check_hardening.sh looks for it in the built files.
#   lr_harden(TARGET [EXCEPT SOURCE...])     for what ships, besides what all targets have

set(lr_hardening "")
set(lr_no_hardening "") # takes it back
if(LR_SANITIZE) # sees more, and does not go together with it
elseif(CMAKE_SYSTEM_NAME STREQUAL "Linux")
    target_compile_options(lr_flags INTERFACE -fstack-protector-strong)
    target_link_options(lr_flags INTERFACE -Wl,-z,relro,-z,now,-z,noexecstack)
    # CMake compiles for programs at any address, but links them so only when it has been asked whether the linker can.
    include(CheckPIESupported)
    check_pie_supported(LANGUAGES C CXX)
    # Fortified functions are those of an optimised build.
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
    # Not the stack protector: GCC's takes its secret from ADVAPI32, and the library needs no DLL but KERNEL32 and msvcrt.
    target_link_options(lr_flags INTERFACE LINKER:--dynamicbase,--nxcompat,--high-entropy-va)
endif()

function(lr_harden target)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" EXCEPT)
    target_compile_options(${target} PRIVATE ${lr_hardening})
    set_property(SOURCE ${arg_EXCEPT} APPEND PROPERTY COMPILE_OPTIONS ${lr_no_hardening})
endfunction()
