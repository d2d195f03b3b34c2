# Warnings and floating-point flags for all targets of the project.

add_library(lr_flags INTERFACE)

# Determinism (docs/maintainers/numerics.md): a fused multiply-add differs in the last bit from a product and a sum, and with
# contraction each compiler fuses different expressions. Never use -ffast-math. -fno-math-errno only saves a call in square roots.
target_compile_options(lr_flags INTERFACE -ffp-contract=off -fno-fast-math -fno-math-errno)
# GCC 12 at -O3 drops the rounding in double -> float -> double when it packs two such conversions into one vector (seen by
# tests/api/test_views.cpp). The kernel uses explicit vectors, so omitting this pass costs no speed.
target_compile_options(lr_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)

# GCC collects garbage from 128 MB on, and a precompiled header counts. Later, files that use Eigen take a tenth less time, for as much more memory.
target_compile_options(lr_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=393216>)

target_compile_options(lr_flags INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wdouble-promotion -Wformat=2 -Wundef
    -Wcast-qual -Wnull-dereference -Wimplicit-fallthrough -Werror
    $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual -Wextra-semi>
    $<$<COMPILE_LANGUAGE:C>:-Wstrict-prototypes -Wmissing-prototypes>
    # GCC 12 reports false positives in its own library headers when it inlines at -O3.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-error=null-dereference -Wno-null-dereference>)

# GCC for 64-bit Windows keeps vectors of 32 and 64 bytes in stack slots with an alignment of 16, but moves them with aligned
# instructions (GCC bug 54412). The assembler replaces these by unaligned moves. It also takes the registers that its own copy of an
# inline function leaves alone as free over a call, though the linker may choose the copy of a file with other options: -fno-ipa-ra.
if(MINGW AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(lr_flags INTERFACE -Wa,-muse-unaligned-vector-move -fno-ipa-ra)
endif()

# Equal sources give equal bytes in any folder.
target_compile_options(lr_flags INTERFACE "-ffile-prefix-map=${PROJECT_SOURCE_DIR}=.")

if(LR_SANITIZE)
    target_compile_options(lr_flags INTERFACE -fsanitize=${LR_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(lr_flags INTERFACE -fsanitize=${LR_SANITIZE})
endif()
