// First in files that use the kernel's functions, but are not compiled for each instruction set: for the lowest, whatever the build names for the kernel.
#undef HWY_WANT_SSSE3
#undef HWY_WANT_SSE4
