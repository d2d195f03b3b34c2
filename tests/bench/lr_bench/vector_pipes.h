// What the processor's vector pipes can do: cycles an instruction when nothing waits for anything.
#pragma once

namespace lr_bench {

// Writes `width,operation,cycles` rows. Returns an exit code; 2 where there is nothing to measure.
int write_ports(const char* path);

} // namespace lr_bench
