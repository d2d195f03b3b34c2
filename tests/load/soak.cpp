// A storm of many hours: memory, quaternions, ages, time, and the statistics of the last hour compared to the first.
#include "load/load.h"
#include "load/storm.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>

namespace load {
namespace {

constexpr size_t block_minutes = 5;
// Steps between two samples: coprime to the lives of seeds, which spawn together; else each sample would see them at the same age.
constexpr uint64_t between_looks = 31;

struct Mean {
    double sum = 0.0;
    uint64_t count = 0;
    void add(double x) { sum += x, ++count; }
    double value() const { return count ? sum / static_cast<double>(count) : 0.0; }
};

// Quantities averaged over some minutes, and compared.
struct Series {
    std::string name;
    Mean block;
    std::vector<double> blocks;
};

// Mean and its standard error over the blocks [from, to).
struct Estimate {
    double mean = 0.0, error = 0.0;
};
Estimate estimate(const std::vector<double>& blocks, size_t from, size_t to) {
    Estimate e;
    const auto n = static_cast<double>(to - from);
    for (size_t i = from; i < to; ++i) e.mean += blocks[i] / n;
    for (size_t i = from; i < to; ++i) e.error += (blocks[i] - e.mean) * (blocks[i] - e.mean);
    e.error = std::sqrt(e.error / (n - 1.0) / n);
    return e;
}

// Slope per hour of a straight line through the blocks [from, end), by least squares.
Estimate drift(const std::vector<double>& blocks, size_t from) {
    const auto n = static_cast<double>(blocks.size() - from), hour = 60.0 / block_minutes;
    const double mean = estimate(blocks, from, blocks.size()).mean, middle = 0.5 * (n - 1.0);
    double xx = 0.0, xy = 0.0, rest = 0.0;
    for (size_t i = from; i < blocks.size(); ++i) {
        const double x = static_cast<double>(i - from) - middle;
        xx += x * x, xy += x * (blocks[i] - mean);
    }
    for (size_t i = from; i < blocks.size(); ++i) {
        const double off = blocks[i] - mean - xy / xx * (static_cast<double>(i - from) - middle);
        rest += off * off;
    }
    return {hour * xy / xx, hour * std::sqrt(rest / (n - 2.0) / xx)};
}

class Soak {
public:
    Soak(double hours, const std::string& csv)
        : steps_(static_cast<uint64_t>(std::llround(hours * 60.0)) * minute), storm_(12345, 0),
          csv_(csv.empty() ? nullptr : std::fopen(csv.c_str(), "w"), &std::fclose) {
        for (const Kind& kind : storm_.kinds()) {
            series_.push_back({std::string("bodies: ") + kind.name, {}, {}});
            series_.push_back({std::string("awake: ") + kind.name, {}, {}});
            series_.push_back({std::string("speed m/s: ") + kind.name, {}, {}});
            series_.push_back({std::string("spin rad/s: ") + kind.name, {}, {}});
        }
        if (csv_)
            std::fputs("minute,world_bytes,resident_bytes,quaternion_error,us_a_step,leaves_speed,discs_speed,"
                       "petals_speed,wanderers_speed,bodies\n",
                       csv_.get());
    }

    int run() {
        double since = seconds_now();
        for (steps_done_ = 1; steps_done_ <= steps_; ++steps_done_) {
            storm_.step();
            if (steps_done_ % between_looks == 0) look();
            if (steps_done_ % minute == 0) {
                const double now = seconds_now();
                end_minute((now - since) * 1e6 / minute);
                since = now;
            }
        }
        return judge();
    }

private:
    lr_world_info info() const {
        lr_world_info i;
        must(lr_world_info_init(&i, sizeof i), "init");
        must(lr_world_get_info(storm_.world(), &i), "info");
        return i;
    }
    double time() const { return static_cast<double>(steps_done_) * static_cast<double>(frame); }

    void look() {
        for (size_t k = 0; k < storm_.kinds().size(); ++k) {
            const Kind& kind = storm_.kinds()[k];
            lr_batch_view v;
            must(lr_batch_view_init(&v, sizeof v), "init");
            must(lr_batch_get_view(storm_.world(), kind.batch, &v), "view");
            series_[4 * k].block.add(v.count);
            series_[4 * k + 1].block.add(v.awake_count);
            velocities_.resize(size_t{6} * v.count);
            must(lr_batch_write_velocities(storm_.world(), kind.batch, velocities_.data(), 0, v.count, nullptr),
                 "velocities");
            for (uint32_t i = 0; i < v.count; ++i) look_at(kind, v, i, 4 * k);
        }
    }

    void look_at(const Kind& kind, const lr_batch_view& v, uint32_t i, size_t at) {
        double norm = 0.0, speed = 0.0, spin = 0.0, all = 0.0;
        for (const float* q : v.orientation) norm += square(q[i]);
        for (size_t n = 0; n < 3; ++n)
            speed += square(velocities_[6 * i + n]), spin += square(velocities_[6 * i + 3 + n]);
        for (const float* x : v.position) all += static_cast<double>(x[i]);
        if (!std::isfinite(norm + speed + spin + all)) ++not_finite_;
        quaternion_ = std::max(quaternion_, std::abs(std::sqrt(norm) - 1.0));
        if (i < v.awake_count) {
            series_[at + 2].block.add(std::sqrt(speed));
            series_[at + 3].block.add(std::sqrt(spin));
        }
        lr_body_state s;
        must(lr_body_state_init(&s, sizeof s), "init");
        must(lr_body_get_state(storm_.world(), v.ids[i], &s), "state");
        // Rules check sleeping bodies in every 16th step.
        if (kind.max_age > 0.0f)
            over_age_ = std::max(over_age_, static_cast<double>(s.age - kind.max_age) / static_cast<double>(frame));
        else
            wrong_age_ = std::max(wrong_age_, (std::abs(static_cast<double>(s.age) - time()) - early) / ulp(time()));
    }
    static constexpr double early = 2e-6; // s: the error of ages in the first two seconds
    static double square(float x) { return static_cast<double>(x) * static_cast<double>(x); }
    // A float's last place at x.
    static double ulp(double x) { return std::ldexp(1.0, std::ilogb(x) - 23); }

    void end_minute(double microseconds) {
        const lr_world_info i = info();
        const uint64_t resident = resident_bytes();
        world_bytes_.push_back(i.memory_bytes);
        resident_.push_back(resident);
        most_quaternion_ = std::max(most_quaternion_, quaternion_);
        if (csv_) {
            std::fprintf(csv_.get(), "%zu,%llu,%llu,%.3g,%.2f", world_bytes_.size(),
                         static_cast<unsigned long long>(i.memory_bytes), static_cast<unsigned long long>(resident),
                         quaternion_, microseconds);
            for (size_t k : {0u, 1u, 2u, 4u}) std::fprintf(csv_.get(), ",%.4f", series_[4 * k + 2].block.value());
            std::fprintf(csv_.get(), ",%llu\n", static_cast<unsigned long long>(i.body_count));
            std::fflush(csv_.get());
        }
        quaternion_ = 0.0;
        if (world_bytes_.size() % block_minutes != 0) return;
        for (Series& s : series_) {
            s.blocks.push_back(s.block.value());
            s.block = {};
        }
    }

    int judge() {
        int bad = 0;
        const lr_world_info i = info();
        --steps_done_;
        bad += verdict(not_finite_ == 0, "numbers that are not finite", "%llu",
                       static_cast<unsigned long long>(not_finite_));
        bad += verdict(most_quaternion_ < 1e-6, "quaternions, | |q| - 1 |", "%.3g, bound 1e-6", most_quaternion_);
        bad += verdict(over_age_ <= 17.0, "ages over the limit", "%.1f steps, bound 17", over_age_);
        bad += verdict(wrong_age_ <= 1.0, "ages of those that lived all along", "%.2f last places of float, bound 1",
                       wrong_age_);
        const double drift = std::abs(i.time - time()) / time();
        bad += verdict(drift < 1e-10, "time against steps times dt", "%.3g relative, bound 1e-10", drift);
        bad += verdict(i.substep_count == steps_, "substeps", "%llu", static_cast<unsigned long long>(i.substep_count));
        bad += judge_memory();
        bad += judge_series();
        return bad;
    }

    // From the end of the warm-up: an hour, or half of shorter runs.
    int judge_memory() const {
        const size_t minutes = world_bytes_.size(), warm = std::min<size_t>(60, minutes / 2);
        const auto most = [&](const std::vector<uint64_t>& v, size_t from, size_t to) {
            return *std::max_element(v.begin() + static_cast<std::ptrdiff_t>(from),
                                     v.begin() + static_cast<std::ptrdiff_t>(to));
        };
        const uint64_t before = most(world_bytes_, 0, warm), after = most(world_bytes_, warm, minutes);
        int bad = verdict(after <= before + before / 10, "world's memory after the warm-up",
                          "%llu bytes at most, %llu before, bound a tenth more", static_cast<unsigned long long>(after),
                          static_cast<unsigned long long>(before));
        // A heap with more contacts than ever allocates more, which becomes ever rarer. A leak, however small, would show in every
        // hour.
        uint64_t highest = before;
        size_t rises = 0;
        for (size_t m = warm; m < minutes; ++m) {
            if (world_bytes_[m] > highest) ++rises;
            highest = std::max(highest, world_bytes_[m]);
        }
        const size_t allowed = 1 + (minutes - warm) / 360;
        bad += verdict(rises <= allowed, "minutes in which it was higher than ever", "%zu, bound %zu", rises, allowed);
        const uint64_t resident = most(resident_, warm, minutes), first = most(resident_, 0, warm);
        bad += verdict(resident <= first + (1u << 20), "process's memory after the warm-up",
                       "%llu bytes at most, %llu before, bound 1 MB more", static_cast<unsigned long long>(resident),
                       static_cast<unsigned long long>(first));
        return bad;
    }

    int judge_series() const {
        constexpr size_t hour = 60 / block_minutes;
        int bad = 0;
        if (series_[0].blocks.size() < 2 * hour + 2) return bad;
        for (size_t at = 0; at < series_.size(); ++at) {
            // Bodies as old as the storm end up elsewhere: the higher they are, the stronger the wind.
            if (storm_.kinds()[at / 4].max_age == 0.0f) continue;
            const Series& s = series_[at];
            // The first ten minutes are the storm's warm-up.
            const size_t n = s.blocks.size();
            const Estimate first = estimate(s.blocks, 2, 2 + hour), last = estimate(s.blocks, n - hour, n);
            const double error = std::hypot(first.error, last.error), apart = std::abs(last.mean - first.mean);
            bad += verdict(apart <= 4.0 * error + 1e-9, s.name.c_str(),
                           "%.4f +- %.4f in the first hour, %.4f +- %.4f in the last", first.mean, first.error,
                           last.mean, last.error);
            const Estimate line = drift(s.blocks, 2);
            bad += verdict(std::abs(line.mean) <= 4.0 * line.error + 1e-9, "    its drift",
                           "%.2g +- %.2g an hour, over all of them", line.mean, line.error);
        }
        return bad;
    }

    uint64_t steps_, steps_done_ = 0;
    Storm storm_;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> csv_;
    std::vector<Series> series_;
    std::vector<float> velocities_; // 6 for each body
    std::vector<uint64_t> world_bytes_, resident_;
    uint64_t not_finite_ = 0;
    double quaternion_ = 0.0, most_quaternion_ = 0.0, over_age_ = -1e9, wrong_age_ = 0.0;
};

} // namespace

int soak(double hours, const std::string& csv) {
    return Soak(hours, csv).run();
}

} // namespace load
