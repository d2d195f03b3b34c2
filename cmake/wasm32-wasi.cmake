# WebAssembly with 128-bit SIMD, by clang and Debian's wasi-libc (scripts/setup.sh test). docs/guide/languages.md
#   cmake -B build/wasm -G Ninja -DCMAKE_TOOLCHAIN_FILE=cmake/wasm32-wasi.cmake -DCMAKE_BUILD_TYPE=Release
#   cmake --build build/wasm --target langevin_rigid_wasm
set(CMAKE_SYSTEM_NAME WASI)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_C_COMPILER clang-14)
set(CMAKE_CXX_COMPILER clang++-14)
set(CMAKE_C_COMPILER_TARGET wasm32-wasi)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_AR llvm-ar-14 CACHE FILEPATH "")
set(CMAKE_RANLIB llvm-ranlib-14 CACHE FILEPATH "")
set(CMAKE_C_FLAGS_INIT "-msimd128")
set(CMAKE_CXX_FLAGS_INIT "-msimd128 -fno-exceptions")
# The kernel's blocks need more than the default stack of 64 KiB. The stack is at the bottom of memory, where an overflow traps.
# -O0 is for clang's linker step alone: with more, clang runs the wasm-opt of an installed Emscripten, which refuses SIMD.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-O0 -Wl,--stack-first -Wl,-z,stack-size=262144")
set(CMAKE_CROSSCOMPILING_EMULATOR "node;${CMAKE_CURRENT_LIST_DIR}/cross/run_wasi.mjs")
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

# The runtime needs only headers of the other libraries.
list(APPEND CMAKE_MODULE_PATH "${CMAKE_CURRENT_LIST_DIR}/cross/wasi")
set(FlatBuffers_DIR "${CMAKE_CURRENT_LIST_DIR}/cross" CACHE PATH "FlatBuffers' headers and its compiler for this machine")
set(HWY_DIR "${CMAKE_CURRENT_LIST_DIR}/cross" CACHE PATH "Highway's headers")
set(doctest_DIR "${CMAKE_CURRENT_LIST_DIR}/cross/wasi" CACHE PATH "doctest's header")
