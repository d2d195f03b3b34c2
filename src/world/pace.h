// How a batch keeps up with its world: what of the world's time it has still to make up for, and when it does.
#pragma once

#include "field/wind_field.h"
#include "langevin_rigid.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace lr {

class Pace {
public:
    static constexpr uint32_t largest_of_all = 1024;

    // length: of the bodies, m.
    explicit Pace(double length);

    // What a snapshot holds.
    struct Record {
        uint32_t divisor;
        uint32_t steps;         // since it was last stepped,
        uint64_t substeps;      // of the world in them
        uint64_t first_substep; // of the world, the first of them
        double begin, behind;   // s: world time where they began, and how long they were
        double lost;            // s, in all
        uint64_t taken;         // body-substeps, in all
        double drift[3];        // m, way of the uniform wind where they began
        float wind[3];          // m/s, the uniform wind there
        uint32_t passed_over;   // of the steps the last, by the budget
    };
    static bool consistent(const Record& record, double time, uint64_t substep_count);
    const Record& record() const { return record_; }
    void restore(const Record& record);

    // At the world's own rate, and up with it.
    bool plain() const { return !waits() && record_.divisor == 1; }
    // Words that matter for what comes; none while it is plain.
    template <class Take> void hash(Take&& take) const {
        if (plain()) return;
        const Record& r = record_;
        take(r.divisor | uint64_t{r.passed_over} << 32);
        if (!waits()) return;
        take(r.substeps);
        take(r.first_substep);
        for (double v : {r.begin, r.behind, r.drift[0], r.drift[1], r.drift[2]}) take(std::bit_cast<uint64_t>(v));
        for (float v : r.wind) take(std::bit_cast<uint32_t>(v));
    }

    void set_divisor(uint32_t divisor) { record_.divisor = divisor; }

    // A step of the world begins, `dt` long: it is added to what the batch has to make up for.
    void wait(double dt, uint32_t substeps, double time, uint64_t substep_count, const UniformWind& wind);
    // Nobody is there to wait.
    void rest();

    // The divisor, as far as it keeps to the longest substep when the world's are `h` long.
    uint32_t divisor(double h) const;
    // Whether a batch of this phase is stepped in the world's step of this number: in every one, unless `divisor` is more
    // than all of its substeps.
    bool due(uint32_t divisor, uint32_t substeps, uint64_t step, uint32_t phase) const;
    // Substeps that make up for what is behind, none longer than the longest or than the world's,
    uint32_t least() const;
    // nor than `divisor` of the world's.
    uint32_t wanted(uint32_t divisor) const;

    // The outcome: 0 substeps is waiting on. h: s, the world's substep.
    void grant(uint32_t substeps, bool passed_over, double h);
    uint32_t granted() const { return granted_; }
    double lost_now() const { return lost_now_; } // s, in this step
    // After the step has been taken.
    void stepped(uint32_t bodies);

    bool waits() const { return record_.steps != 0; }
    bool passed_over() const { return record_.passed_over != 0; }
    double behind() const { return record_.behind; }
    bool at_same_time(const Pace& other) const;
    StepTime time() const { return {record_.begin, h_, granted_}; }
    UniformWind wind(const UniformWind& now) const; // over the time that is made up for

private:
    uint32_t most() const { return static_cast<uint32_t>(std::min<uint64_t>(record_.substeps, LR_MAX_SUBSTEPS)); }

    Record record_;
    double longest_;        // s, substep
    double h_ = 0.0;        // s, of the substeps granted
    double lost_now_ = 0.0; // s
    uint32_t granted_ = 0;
};
static_assert(sizeof(Pace::Record) % 8 == 0);

} // namespace lr
