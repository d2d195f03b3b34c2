# 64-bit ARM, cross-compiled with Debian's compiler and run by an emulator (scripts/setup.sh arm64):
#   cmake -B build/arm64 -G Ninja -DCMAKE_TOOLCHAIN_FILE=cmake/aarch64-linux-gnu.cmake -DLR_BUILD_BAKER=OFF
#   cmake --build build/arm64 --target tests_determinism && ctest --test-dir build/arm64 -R tests_determinism
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_CROSSCOMPILING_EMULATOR "qemu-aarch64-static;-L;/usr/aarch64-linux-gnu")

# The runtime needs only headers of Highway and FlatBuffers, which this compiler finds in /usr/include.
set(HWY_DIR "${CMAKE_CURRENT_LIST_DIR}/cross" CACHE PATH "Highway's headers")
set(FlatBuffers_DIR "${CMAKE_CURRENT_LIST_DIR}/cross" CACHE PATH "FlatBuffers' headers and its compiler for this machine")
