// As sketch_native.cpp, products and sums each rounded: what the promise of equal bits everywhere costs.
#define LR_SKETCH_STEP sketch_step_native_no_fma
#define LR_SKETCH_NO_FMA
#include "peers/sketch_step-inl.h"
