# WASI has no threads.
add_library(Threads::Threads INTERFACE IMPORTED)
set(Threads_FOUND TRUE)
