# Headers without the library: enough for one instruction set, which is then chosen when compiled.
add_library(hwy::hwy INTERFACE IMPORTED)
