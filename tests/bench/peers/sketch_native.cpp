// With -march=native: the best that the machine that builds it has.
#define LR_SKETCH_STEP sketch_step_native
#include "peers/sketch_step-inl.h"
