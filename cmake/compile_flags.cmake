# Warnings and floating-point flags, in one place for every target of the project.

add_library(lr_flags INTERFACE)

# Determinism (docs/maintainers/determinism.md): a fused multiply-add differs in the last bit from a product and a sum, and a compiler
# that may contract fuses where it likes. No -ffast-math, ever. -fno-math-errno only spares a call in square roots.
target_compile_options(lr_flags INTERFACE -ffp-contract=off -fno-fast-math -fno-math-errno)
# GCC 12 at -O3 drops the rounding in double -> float -> double when it packs two such conversions into one vector (seen by
# tests/api/test_views.cpp). The kernel's vectors are written out, so that nothing is lost without that pass.
target_compile_options(lr_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)

target_compile_options(lr_flags INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wdouble-promotion -Wformat=2 -Wundef
    -Wcast-qual -Wnull-dereference -Wimplicit-fallthrough -Werror
    $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual -Wextra-semi>
    $<$<COMPILE_LANGUAGE:C>:-Wstrict-prototypes -Wmissing-prototypes>
    # GCC 12 reports false positives of these inside its own library headers when it inlines at -O3.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-error=null-dereference -Wno-null-dereference>)

# GCC for 64-bit Windows keeps vectors of 32 and 64 bytes in stack slots that are aligned to 16 alone, and moves them as if they
# were aligned (GCC bug 54412). The assembler writes every such move as one that needs no alignment.
if(MINGW AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(lr_flags INTERFACE -Wa,-muse-unaligned-vector-move)
endif()

# The same sources give the same bytes wherever they are built.
target_compile_options(lr_flags INTERFACE "-ffile-prefix-map=${PROJECT_SOURCE_DIR}=.")

if(LR_SANITIZE)
    target_compile_options(lr_flags INTERFACE -fsanitize=${LR_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(lr_flags INTERFACE -fsanitize=${LR_SANITIZE})
endif()
