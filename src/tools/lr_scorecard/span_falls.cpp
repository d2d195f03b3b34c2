#include "tools/lr_scorecard/span_falls.h"

#include "tools/falls/random.h"

#include <algorithm>
#include <cmath>

namespace lr::scorecard {

Run game_run(const Context& context, uint32_t substeps, double duration) {
    Run run;
    run.loads.load_model = context.loads.model;
    run.dt = 1.0f / 60.0f;
    run.substeps = substeps;
    run.interval = static_cast<double>(run.dt);
    run.duration = duration;
    return run;
}

std::vector<Start> released_anyhow(uint32_t count, uint64_t seed) {
    Random random(seed);
    std::vector<Start> starts(count);
    for (Start& s : starts) {
        s.orientation = random.orientation();
        s.position = 2.0 * Eigen::Vector3d(random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-1.0, 1.0));
    }
    return starts;
}

std::span<const Sample> fallen(const Track& track, double height) {
    const std::span<const Sample> all(track.samples);
    const auto finite = [](const Sample& s) {
        return s.position.allFinite() && s.velocity.allFinite() && s.spin.allFinite();
    };
    if (!std::all_of(all.begin(), all.end(), finite)) return {};
    const auto end = std::find_if(all.begin(), all.end(),
                                  [&](const Sample& s) { return s.position.y() < all.front().position.y() - height; });
    return all.first(static_cast<size_t>(end - all.begin()));
}

double descent_of(std::span<const Sample> samples, double interval) {
    return (samples.front().position.y() - samples.back().position.y()) /
           (interval * static_cast<double>(samples.size() - 1));
}

double spin_of(std::span<const Sample> samples) {
    double sum = 0.0;
    for (const Sample& s : samples) sum += s.spin.dot(up());
    return sum / static_cast<double>(samples.size());
}

double share_of(const std::vector<bool>& seen) {
    return static_cast<double>(std::count(seen.begin(), seen.end(), true)) / static_cast<double>(seen.size());
}

Statistic mean_descent(const std::vector<Track>& tracks, double part) {
    std::vector<double> speeds;
    for (const Track& t : tracks) speeds.push_back(descent_of(end_of(t.samples, part), t.interval));
    return summarise(std::move(speeds));
}

LinePlot side_view(const std::string& title, const std::vector<Track>& tracks, size_t count, double depth, double apart,
                   const Strokes& strokes) {
    static constexpr const char* colors[] = {"#1f5fa8", "#2e7d43", "#b5402a", "#7a4a9c"};
    LinePlot plot{title, "x (m)", "height (m)"};
    plot.equal_scale = true;
    for (size_t i = 0; i < std::min(count, tracks.size()); ++i) {
        const std::span<const Sample> samples = fallen(tracks[i], depth);
        if (samples.empty()) continue;
        const Eigen::Vector3d from =
            samples.front().position - apart * static_cast<double>(i) * Eigen::Vector3d::UnitX();
        Series path{"", colors[i % 4], {}};
        path.width = 1.0;
        for (size_t n = 0; n < samples.size(); ++n) {
            const Eigen::Vector3d at = samples[n].position - from;
            path.points.push_back({at.x(), at.y()});
            if (n % strokes.every) continue;
            const Eigen::Vector3d half = 0.5 * strokes.length * (samples[n].orientation * strokes.axis);
            Series stroke{"", "#333", {{at.x() - half.x(), at.y() - half.y()}, {at.x() + half.x(), at.y() + half.y()}}};
            stroke.width = 1.4;
            plot.series.push_back(std::move(stroke));
        }
        plot.series.push_back(std::move(path));
    }
    return plot;
}
} // namespace lr::scorecard
