// Transcendental functions in double from + - x / and exact scaling: same bits for every C library, since assets and constants depend on them.
#pragma once

namespace lr::shape {

// x^y for x > 0, finite arguments and results; relative error below 1e-14 for |y ln x| < 100.
double portable_pow(double x, double y);

// ln x for normal x > 0; absolute error below 1e-16 + 2e-16 |ln x|.
double portable_log(double x);

// e^x for |x| < 700; relative error below 1e-15 (1 + |x|).
double portable_exp(double x);
} // namespace lr::shape
