// Other programs with similar work, in the same process and turns, each in its own file. why_not lists those whose library was
// not found by the build.
#pragma once

#include "lr_bench/subject.h"

#include <vector>

namespace lr_bench {

// Rows of all peers in this build, for numbers of bodies below `most`; and the missing peers, in words.
std::vector<Row> peer_rows(uint32_t most, std::vector<std::string>& missing);

std::unique_ptr<Subject> make_peer(const Row& row, std::string& why_not);

// Keeps denormals from slowing peers down; the library needs no such mode.
class DenormalsFlushed {
public:
    DenormalsFlushed();
    ~DenormalsFlushed();
    DenormalsFlushed(const DenormalsFlushed&) = delete;
    DenormalsFlushed& operator=(const DenormalsFlushed&) = delete;

private:
    uint32_t before_;
};

std::unique_ptr<Subject> make_sketch(const Row& row, std::string& why_not);
std::unique_ptr<Subject> make_scalar(const Row& row);
std::unique_ptr<Subject> make_eigen(const Row& row);
std::unique_ptr<Subject> make_bullet(const Row& row);
std::unique_ptr<Subject> make_ode(const Row& row);
std::unique_ptr<Subject> make_mujoco(const Row& row, std::string& why_not);

} // namespace lr_bench
