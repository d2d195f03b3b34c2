// A timed subject: the library through its C API, the baseline, or a peer. Each is a row of the table.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace lr_bench {

struct Row {
    std::string subject;    // "langevin_rigid", "transforms" and "memcpy", or a peer's name
    std::string model;      // loads
    std::string integrator; //
    std::string
        path; // "diagonal", "sheet", "full"; "alike": without variation; "user": with user data; "stations5", "stations8"
    std::string target;   // instruction set
    uint32_t workers = 0; // threads besides the caller's
    uint32_t bodies = 1;
    uint32_t substeps = 1; // per step

    bool ours() const { return subject == "langevin_rigid"; }
    uint32_t stations() const { return path == "stations5" ? 5 : path == "stations8" ? 8 : 0; }
    // subject/model/integrator/path/target/workers/bodies/substeps
    std::string name() const;
};

// After a fixed number of steps from the start, whatever was timed since. Negative: unknown.
struct Facts {
    double memory_bytes = -1.0; // per body of capacity, from the allocator
    double state_bytes = -1.0;  // a body's share of a snapshot, its id and rounding to words included
    bool hashed = false;
    uint64_t hash = 0;
};

// For subjects that are only an array of bodies.
inline Facts array_facts(size_t bytes_per_body) {
    Facts f;
    f.memory_bytes = f.state_bytes = static_cast<double>(bytes_per_body);
    return f;
}

class Subject {
public:
    virtual ~Subject() = default;
    virtual bool step() = 0; // runs Row::substeps substeps of all bodies
    virtual Facts facts() const { return {}; }
    virtual uint64_t lost() const { return 0; } // bodies that are no longer finite
};

// All simulate the same length of a substep, so that a body-step means the same time.
constexpr float substep_seconds = 1.0f / 240.0f;

// Null, with a reason, if the row cannot run here.
std::unique_ptr<Subject> make_ours(const Row& row, std::string& why_not);
// A chain of dependent additions, a cycle each: measures the present length of a cycle.
std::unique_ptr<Subject> make_clock();
constexpr uint32_t clock_chain = 4096; // additions per step, counted as bodies

// Uniform in [0, 1), from integer arithmetic: the same numbers on every machine.
inline float uniform(uint64_t index) {
    uint64_t z = (index + 1) * 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return static_cast<float>((z ^ (z >> 31)) >> 40) * 0x1p-24f;
}

} // namespace lr_bench
