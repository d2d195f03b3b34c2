// Throughput of the processor's vector pipes: cycles per instruction without dependencies.
#pragma once

namespace lr_bench {

// Writes `width,operation,cycles` rows. Returns an exit code; 2 if there is nothing to measure.
int write_ports(const char* path);

} // namespace lr_bench
