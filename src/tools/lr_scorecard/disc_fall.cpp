#include "tools/lr_scorecard/disc_fall.h"

#include "tools/falls/random.h"
#include "tools/lr_scorecard/measured_bodies.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lr::scorecard {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double in_sight = 1.1;         // m above the floor, from which edge-on falls are in sight
constexpr double peak_prominence = 0.15; // of the area's range

double horizontal(const Eigen::Vector3d& v) {
    return std::hypot(v.x(), v.z());
}

// Mean over up to `reach` frames to each side, fewer near the ends.
template <class T> std::vector<T> smoothed(const std::vector<T>& values, size_t reach) {
    std::vector<T> out = values;
    for (size_t i = 0; i < values.size(); ++i) {
        const size_t r = std::min({reach, i, values.size() - 1 - i});
        for (size_t k = 1; k <= r; ++k) out[i] += values[i - k] + values[i + k];
        out[i] /= static_cast<double>(2 * r + 1);
    }
    return out;
}

size_t frame_at(double time) {
    return static_cast<size_t>(std::lround(time * frame_rate));
}

// Maxima of the area's 3-frame mean in the second half. At its ends two conventions each add half a peak on average: the first frame is a maximum if
// the area falls after it, and the missing frame after the last one has zero area.
double count_peaks(const std::vector<double>& area, size_t first) {
    std::vector<double> mean = smoothed(area, 1);
    mean.back() = (area[area.size() - 2] + area.back()) / 3.0;
    std::vector<double> half(mean.begin() + static_cast<ptrdiff_t>(first), mean.end());
    const auto [low, high] = std::minmax_element(half.begin(), half.end());
    const double prominence = peak_prominence * (*high - *low);
    if (prominence <= 0.0) return 0.0;
    half.insert(half.begin(), -std::numeric_limits<double>::infinity());
    return static_cast<double>(peaks(half, prominence).size());
}
} // namespace

std::span<const MeasuredCell> measured_cells() {
    static constexpr MeasuredCell cells[] = {
#include "tools/lr_scorecard/measured_falls.inc"
    };
    return cells;
}

double seen_area(const Eigen::Vector3d& position, const Eigen::Vector3d& normal) {
    const Eigen::Vector3d sight = camera - position;
    return std::abs(normal.dot(sight)) / std::pow(sight.norm(), 3.0);
}

std::optional<Fall> measure_fall(const Track& track, Release release) {
    const auto& samples = track.samples;
    size_t begin = 0, end = 0; // frame range, including the first on the floor
    if (release == Release::edge)
        while (begin < samples.size() && samples[begin].position.y() > in_sight) ++begin;
    for (end = begin; end < samples.size(); ++end)
        if (samples[end].position.y() <= 0.0) {
            ++end;
            break;
        }
    if (end - begin < least_frames) return std::nullopt;
    Fall fall;
    std::vector<double> area;
    for (size_t i = begin; i < end; ++i) {
        fall.path.push_back(samples[i].position);
        area.push_back(seen_area(samples[i].position, samples[i].orientation * Eigen::Vector3d::UnitZ()));
    }
    fall.path = smoothed(fall.path, 2);
    area = smoothed(area, 2); // as in the published tracks, which are smoothed as a whole
    const std::vector<Eigen::Vector3d>& p = fall.path;
    const size_t last = p.size() - 1, first = p.size() / 2;
    for (size_t i = 0; i < last; ++i) {
        const Eigen::Vector3d v = frame_rate * (p[i + 1] - p[i]);
        fall.vz.push_back(-v.y());
        fall.vh.push_back(horizontal(v));
    }
    const double time = static_cast<double>(last - first) / frame_rate;
    const Eigen::Vector3d displacement = p[last] - p[first];
    double path = 0.0;
    for (size_t i = first; i < last; ++i) path += fall.vh[i] / frame_rate;
    fall.quantity = {-displacement.y() / time, path / time,
                     std::atan2(horizontal(displacement), -displacement.y()) / degree, horizontal(p[last] - p[0]),
                     count_peaks(area, first) / time};
    fall.time = static_cast<double>(p.size()) / frame_rate;
    fall.sideways = longest_fall;
    const size_t from = frame_at(0.06);
    for (size_t i = from; i < p.size(); ++i)
        if (horizontal(p[i] - p[from]) > sideways_distance) {
            fall.sideways = static_cast<double>(i) / frame_rate;
            break;
        }
    return fall;
}

CellStatistics summarise_falls(std::span<const Fall> falls) {
    CellStatistics out;
    const auto each = [&](auto value) {
        std::vector<double> values;
        for (const Fall& f : falls) values.push_back(value(f));
        return summarise(std::move(values));
    };
    for (size_t q = 0; q < quantities.size(); ++q) out.quantity[q] = each([q](const Fall& f) { return f.quantity[q]; });
    out.time = each([](const Fall& f) { return f.time; });
    out.sideways = each([](const Fall& f) { return f.sideways; });
    std::vector<double> vz, vh;
    for (const Fall& f : falls) {
        const auto half = static_cast<ptrdiff_t>(f.path.size() / 2);
        vz.insert(vz.end(), f.vz.begin() + half, f.vz.end());
        vh.insert(vh.end(), f.vh.begin() + half, f.vh.end());
    }
    out.vz = summarise(std::move(vz));
    out.vh = summarise(std::move(vh));
    for (size_t bin = 0; bin < out.growth.size(); ++bin) {
        const double from = 0.1 * static_cast<double>(bin + 1);
        double squares = 0.0, descent = 0.0, frames = 0.0;
        for (const Fall& f : falls)
            for (size_t i = frame_at(from); i < std::min(frame_at(from + 0.1), f.vz.size()); ++i) {
                squares += f.vh[i] * f.vh[i];
                descent += f.vz[i];
                frames += 1.0;
            }
        if (frames == 0.0) continue;
        out.growth[bin] = std::sqrt(squares / frames);
        out.growth_descent[bin] = descent / frames;
    }
    return out;
}

std::vector<Start> releases(Release release, uint32_t count, uint64_t seed) {
    Random random(seed);
    // The sheet is baked in the plane z = 0; a quarter turn makes it horizontal.
    const Eigen::Quaterniond flat(Eigen::AngleAxisd(-0.5 * std::numbers::pi, Eigen::Vector3d::UnitX()));
    std::vector<Start> starts(count);
    for (Start& s : starts) {
        const double azimuth = random.real(0.0, 2.0 * std::numbers::pi);
        const double tilt = release == Release::flat ? random.real(0.0, 4.6) : 90.0 + random.real(-3.4, 3.4);
        const Eigen::Vector3d axis(std::cos(azimuth), 0.0, std::sin(azimuth));
        s.orientation = Eigen::AngleAxisd(tilt * degree, axis) * flat;
        s.position.y() = release == Release::flat ? 0.98 : 1.16;
    }
    return starts;
}

std::vector<Fall> drop_disc(const Asset& disc, Release release, const DiscFallOptions& options) {
    Run run;
    run.loads = options.loads;
    run.dt = options.dt;
    run.substeps = options.substeps;
    run.duration = longest_fall;
    run.interval = 1.0 / frame_rate;
    run.seed = options.seed;
    run.floor = 0.0;
    std::vector<Fall> falls;
    for (const Track& t : record(disc, run, releases(release, options.falls, options.seed)))
        if (std::optional<Fall> fall = measure_fall(t, release)) falls.push_back(std::move(*fall));
    return falls;
}

std::vector<Asset> bake_cell(const MeasuredCell& cell) {
    std::vector<Asset> discs;
    for (double radius : cell.radii) discs.push_back(bake_disc(radius, paper_thickness, paper_density, Fluid{}));
    return discs;
}

std::vector<Fall> drop_cell(const MeasuredCell& cell, const std::vector<Asset>& discs, DiscFallOptions options) {
    std::vector<Fall> falls;
    const auto sizes = static_cast<uint32_t>(discs.size());
    const uint32_t all = options.falls;
    options.seed *= sizes;
    for (uint32_t i = 0; i < sizes; ++i, ++options.seed) {
        options.falls = (all + sizes - 1 - i) / sizes;
        if (options.falls == 0) continue;
        for (Fall& f : drop_disc(discs[i], cell.release, options)) falls.push_back(std::move(f));
    }
    return falls;
}
} // namespace lr::scorecard
