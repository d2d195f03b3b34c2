// Transcendental functions in double that give the same bits with every C library: made of + - x / and exact scaling
// only. Results go into assets and constants, so that two machines must agree on them to the last bit.
#pragma once

namespace lr::shape {

// x^y for x > 0, finite arguments and results; relative error below 1e-14 for |y ln x| < 100.
double portable_pow(double x, double y);

} // namespace lr::shape
