// The parts of lr_load. Each prints a row for each bound, and returns the number of violated bounds.
#pragma once

#include <cstdint>
#include <string>

namespace load {

// Prints "good" or "BAD", the name, and the measured value beside its bound; returns 1 for "BAD".
int verdict(bool good, const char* what, const char* format, ...) __attribute__((format(printf, 3, 4)));

uint64_t resident_bytes(); // of this process, at present; 0 if the system does not report it
uint64_t memory_free();    // available without swapping; 0 if the system does not report it
double seconds_now();      // of a monotonic clock

int soak(double hours, const std::string& csv); // simulated hours; csv: a line per minute, can be empty
int many_bodies(uint32_t count);
int many_worlds(uint32_t count);
int many_threads(uint32_t workers, uint32_t steps);

} // namespace load
