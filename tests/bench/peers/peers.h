// Others that do similar work, in the same process and turns. Each in its own file; those whose library was not found
// when this was built are told by why_not.
#pragma once

#include "lr_bench/subject.h"

#include <vector>

namespace lr_bench {

// Rows of all peers that this build has, whatever the count of bodies below `most`; and what it lacks, in words.
std::vector<Row> peer_rows(uint32_t most, std::vector<std::string>& missing);

std::unique_ptr<Subject> make_peer(const Row& row, std::string& why_not);

// Peers keep denormals from slowing them down; ours need no such mode.
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
