// With -march=native: the best instruction set of the build machine.
#define LR_SKETCH_STEP sketch_step_native
#include "peers/sketch_step-inl.h"
