// Like sketch_native.cpp, but products and sums are rounded separately: the cost of equal bits everywhere.
#define LR_SKETCH_STEP sketch_step_native_no_fma
#define LR_SKETCH_NO_FMA
#include "peers/sketch_step-inl.h"
