// The parts of lr_load. Each prints a row for each thing that it holds against a bound, and returns how many did not hold.
#pragma once

#include <cstdint>
#include <string>

namespace load {

// Prints "good" or "BAD", what, and the measured value beside its bound; 1 when bad.
int verdict(bool good, const char* what, const char* format, ...) __attribute__((format(printf, 3, 4)));

uint64_t resident_bytes(); // of this process, at present; 0 where the system does not say
uint64_t memory_free();    // what may still be taken without swapping; 0 where the system does not say
double seconds_now();      // of a clock that goes on evenly

int soak(double hours, const std::string& csv); // simulated hours; csv: a line a minute, may be empty
int many_bodies(uint32_t count);
int many_worlds(uint32_t count);
int many_threads(uint32_t workers, uint32_t steps);

} // namespace load
