// With -march=x86-64-v3 and what Highway's AVX2 wants besides.
#define LR_SKETCH_STEP sketch_step_avx2
#include "peers/sketch_step-inl.h"
