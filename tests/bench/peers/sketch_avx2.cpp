// With -march=x86-64-v3 and Highway's further requirements for AVX2.
#define LR_SKETCH_STEP sketch_step_avx2
#include "peers/sketch_step-inl.h"
