// Averages, peaks and measures of a fall, on known tracks.
#include "tools/falls/random.h"
#include "tools/lr_scorecard/disc_fall.h"
#include "tools/lr_scorecard/measured_bodies.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <numbers>

using namespace lr::scorecard;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double frame = 1.0 / frame_rate;

using Place = std::function<Eigen::Vector3d(double)>;

// A fall from time 0, with a normal that turns in the plane of x and y; 3 s long, also below the floor.
Track film(const Place& place, const std::function<double(double)>& angle) {
    Track t;
    t.interval = frame;
    for (double time = 0.0; time <= longest_fall; time += frame) {
        Sample s;
        s.position = place(time);
        s.velocity = s.spin = Eigen::Vector3d::Zero();
        const Eigen::Vector3d normal(std::cos(angle(time)), std::sin(angle(time)), 0.0);
        s.orientation = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), normal);
        t.samples.push_back(s);
    }
    return t;
}
double upright(double) {
    return 0.5 * pi;
}
Fall measured(const Track& track, Release release = Release::flat) {
    std::optional<Fall> fall = measure_fall(track, release);
    REQUIRE(fall.has_value());
    return *fall;
}
enum Index { descent, horizontal_speed, drift, landing, area_peaks };

} // namespace

TEST_CASE("fall measures: a straight glide to the floor") {
    const Fall f = measured(film([](double t) { return Eigen::Vector3d(0.0, 0.98 - 0.7 * t, 0.5 * t); }, upright));
    CHECK(f.quantity[descent] == doctest::Approx(0.7));
    CHECK(f.quantity[horizontal_speed] == doctest::Approx(0.5));
    CHECK(f.quantity[drift] == doctest::Approx(std::atan(0.5 / 0.7) * 180.0 / pi));
    // The floor is reached after 1.4 s, in frame 138: the first that is on it or below.
    CHECK(f.quantity[landing] == doctest::Approx(0.5 * 138.0 * frame));
    CHECK(f.time == doctest::Approx(139.0 * frame));
    // 5 cm sideways after 0.1 s, counted from frame 6.
    CHECK(f.sideways == doctest::Approx(0.06 + 0.1).epsilon(0.1));
    for (double v : f.vz) CHECK(v == doctest::Approx(0.7));
    for (double v : f.vh) CHECK(v == doctest::Approx(0.5));
}

TEST_CASE("fall measures: only the second half counts, from frame n/2, except for landing") {
    const auto place = [](double t) {
        const double side = t < 0.65 ? 0.2 * std::sin(40.0 * t) : 0.2 * std::sin(26.0) + 0.3 * (t - 0.65);
        return Eigen::Vector3d(side, 0.98 - 0.7 * t, 0.0);
    };
    const Fall f = measured(film(place, upright));
    CHECK(f.quantity[horizontal_speed] == doctest::Approx(0.3));
    CHECK(f.quantity[drift] == doctest::Approx(std::atan(0.3 / 0.7) * 180.0 / pi));
    CHECK(f.quantity[landing] == doctest::Approx(0.2 * std::sin(26.0) + 0.3 * (138.0 * frame - 0.65)));
}

TEST_CASE("fall measures: a fall released on edge is in sight from 1.1 m on") {
    const auto place = [](double t) { return Eigen::Vector3d(2.0 * t, 1.16 - 0.8 * t, 0.0); };
    const Fall f = measured(film(place, upright), Release::edge);
    CHECK(f.path.front().y() <= 1.1);
    CHECK(f.path.front().y() > 1.1 - 0.8 * frame);
    CHECK(f.quantity[landing] == doctest::Approx(2.0 * static_cast<double>(f.path.size() - 1) * frame));
    CHECK(measured(film(place, upright), Release::flat).path.front().y() == 1.16);
    CHECK_FALSE(measure_fall(film([](double) { return Eigen::Vector3d(0.0, 2.0, 0.0); }, upright), Release::edge));
}

TEST_CASE("fall measures: positions are means of five frames, fewer at the ends") {
    const auto place = [](double t) {
        const double n = std::round(t / frame);
        return Eigen::Vector3d(n == 50.0 ? 1.0 : 0.0, 0.98 - 0.7 * t, 0.0);
    };
    const std::vector<Eigen::Vector3d> path = measured(film(place, upright)).path;
    for (size_t i = 40; i < 60; ++i) CHECK(std::abs(path[i].x() - (i >= 48 && i <= 52 ? 0.2 : 0.0)) < 1e-12);
    CHECK(path[0].y() == doctest::Approx(0.98));
    CHECK(path[1].y() == doctest::Approx(0.98 - 0.7 * frame));
}

TEST_CASE("fall measures: time to 5 cm sideways of a disc that starts to slide late") {
    for (double start : {0.2, 0.4, 0.6}) {
        const auto place = [start](double t) {
            const double slide = std::max(0.0, t - start);
            return Eigen::Vector3d(0.0, 0.98 - 0.7 * t, slide * slide);
        };
        CHECK(std::abs(measured(film(place, upright)).sideways - (start + std::sqrt(0.05))) < 1.01 * frame);
    }
    const auto straight = [](double t) { return Eigen::Vector3d(0.0, 0.98 - 0.7 * t, 0.0); };
    CHECK(measured(film(straight, upright)).sideways == longest_fall);
}

TEST_CASE("camera: broadside from a metre is 1, and perspective makes the far side smaller") {
    const Eigen::Vector3d sight = Eigen::Vector3d(0.3, -0.8, 0.5).normalized();
    for (double distance : {0.5, 1.0, 2.0}) {
        const Eigen::Vector3d place = camera + distance * sight;
        CHECK(seen_area(place, sight) == doctest::Approx(1.0 / (distance * distance)));
        CHECK(seen_area(place, -sight) == doctest::Approx(1.0 / (distance * distance)));
        CHECK(std::abs(seen_area(place, sight.unitOrthogonal())) < 1e-12);
    }
    // A flat disc on the floor below the drop point is seen from 56 degrees above the horizontal; farther away from lower.
    CHECK(seen_area({0, 0, 0}, Eigen::Vector3d::UnitY()) * camera.squaredNorm() ==
          doctest::Approx(1.81 / std::hypot(1.81, 1.2)));
    CHECK(seen_area({0.5, 0, 0}, Eigen::Vector3d::UnitY()) < seen_area({0, 0, 0}, Eigen::Vector3d::UnitY()));
}

TEST_CASE("area peaks: two for each turn") {
    // Far from the camera's side of the floor perspective changes little during a fall of 1.4 s.
    const auto place = [](double t) { return Eigen::Vector3d(20.0, 0.98 - 0.7 * t, 0.0); };
    for (double rate : {1.5, 3.0, 5.0}) {
        double sum = 0.0;
        const int phases = 60;
        for (int k = 0; k < phases; ++k)
            sum += measured(film(place, [&](double t) {
                       return 2.0 * pi * rate * t + pi * k / phases;
                   })).quantity[area_peaks];
        // On average over the phase a window of 0.7 s gains or loses up to a peak at its ends.
        CHECK(std::abs(sum / phases - 2.0 * rate) < 1.0 / 0.7);
    }
}

TEST_CASE("area peaks: bumps below 15 % of the range are left out, and so are those of a single frame") {
    const auto place = [](double t) { return Eigen::Vector3d(20.0, 0.98 - 0.7 * t, 0.0); };
    // Broadside until 0.8 s, then 0.3 of it, with a bump at 1.1 s. The first frame of the window, at 0.7 s, is a maximum.
    const auto peaks_with_bump = [&](double height, double duration) {
        const Fall f = measured(film(place, [=](double t) {
            const double area = t < 0.8 ? 1.0 : std::abs(t - 108.0 * frame) < 0.5 * duration ? 0.3 + height : 0.3;
            return std::acos(area);
        }));
        return std::lround(f.quantity[area_peaks] * 69.0 * frame);
    };
    CHECK(peaks_with_bump(0.0, 0.1) == 1);
    CHECK(peaks_with_bump(0.09, 0.1) == 1);
    CHECK(peaks_with_bump(0.15, 0.1) == 2);
    CHECK(peaks_with_bump(0.42, 0.9 * frame) == 1);
    CHECK(peaks_with_bump(0.42, 2.9 * frame) == 2);
}

TEST_CASE(
    "area peaks: the window's first frame counts if the area falls after it, and so does its last if it is high") {
    const auto place = [](double t) { return Eigen::Vector3d(20.0, 0.98 - 0.7 * t, 0.0); };
    // From broadside at the window's begin, 0.7 s, to edge-on at its end, and the other way round.
    const auto hides = [](double t) { return t < 0.7 ? 0.0 : 0.5 * pi * (t - 0.7) / 0.7; };
    const auto shows = [](double t) { return 0.5 * pi * std::clamp(1.4 - t, 0.0, 0.7) / 0.7; };
    const double window = (138.0 - 69.0) * frame;
    CHECK(measured(film(place, hides)).quantity[area_peaks] == doctest::Approx(1.0 / window));
    CHECK(measured(film(place, shows)).quantity[area_peaks] == doctest::Approx(1.0 / window));
    // So does a constant one, for the frame that is missing behind it; a disc seen edge-on has no area to fall.
    CHECK(measured(film(place, [](double) { return 0.3; })).quantity[area_peaks] == doctest::Approx(1.0 / window));
    Track hidden = film(place, upright); // the camera is in the plane z = 0 with them
    for (Sample& sample : hidden.samples) sample.orientation = Eigen::Quaterniond::Identity();
    CHECK(measured(hidden).quantity[area_peaks] == 0.0);
}

TEST_CASE("cells: statistics are pooled over falls, growth by time") {
    const auto speeding = [](double t) { return Eigen::Vector3d(0.5 * 0.4 * t * t, 0.98 - 0.7 * t, 0.0); };
    const std::vector<Fall> falls(3, measured(film(speeding, upright)));
    const CellStatistics s = summarise_falls(falls);
    CHECK(s.quantity[descent].mean == doctest::Approx(0.7));
    CHECK(s.quantity[descent].deviation < 1e-6);
    CHECK(s.vh.count == 3 * 69);
    CHECK(s.vh.p50 == doctest::Approx(0.4 * 1.05).epsilon(0.02));
    CHECK(s.vz.deviation < 1e-6);
    for (size_t bin = 0; bin < s.growth.size(); ++bin) {
        CHECK(s.growth[bin] == doctest::Approx(0.4 * (0.15 + 0.1 * static_cast<double>(bin))).epsilon(0.05));
        CHECK(s.growth_descent[bin] == doctest::Approx(0.7));
    }
}

TEST_CASE("releases: flat within 4.6 degrees, edge-on within 3.4, to all sides, at rest") {
    const std::vector<Start> flat = releases(Release::flat, 2000, 3), edge = releases(Release::edge, 2000, 3);
    double mean = 0.0, side = 0.0;
    for (const Start& s : flat) {
        const Eigen::Vector3d n = s.orientation * Eigen::Vector3d::UnitZ();
        const double tilt = std::acos(std::min(1.0, n.y())) * 180.0 / pi;
        CHECK(tilt <= 4.6 + 1e-6);
        mean += tilt / 2000.0;
        side += n.x() / 2000.0;
        CHECK(s.position == Eigen::Vector3d(0.0, 0.98, 0.0));
        CHECK(s.velocity.norm() + s.spin.norm() == 0.0);
    }
    CHECK(mean == doctest::Approx(2.3).epsilon(0.03));
    CHECK(std::abs(side) < 0.003);
    for (const Start& s : edge) {
        const double height = (s.orientation * Eigen::Vector3d::UnitZ()).y();
        CHECK(std::abs(std::asin(height)) * 180.0 / pi <= 3.4 + 1e-6);
        CHECK(s.position.y() == 1.16);
    }
}

TEST_CASE("measured falls: four sizes, each released in two ways, thirds around the mean radius") {
    REQUIRE(measured_cells().size() == 8);
    for (size_t i = 0; i < 8; ++i) {
        const MeasuredCell& cell = measured_cells()[i];
        CHECK((cell.release == Release::flat) == (i % 2 == 0));
        CHECK((cell.radii[0] + cell.radii[1] + cell.radii[2]) / 3.0 == doctest::Approx(cell.radius).epsilon(0.02));
        CHECK(std::is_sorted(cell.vz.begin(), cell.vz.end()));
        CHECK((cell.sideways > 0.0) == (cell.release == Release::flat));
        // Descent and drift are of one line: its horizontal part is at most the mean horizontal speed.
        CHECK(cell.mean[descent] * std::tan(cell.mean[drift] * pi / 180.0) < 1.05 * cell.mean[horizontal_speed]);
    }
}

TEST_CASE("peaks: those lower than the hysteresis and the ends do not count") {
    CHECK(peaks(std::vector<double>{}, 0.1).empty());
    CHECK(peaks(std::vector<double>{1.0, 0.0, 1.0}, 0.1).empty());
    CHECK(peaks(std::vector<double>{0.0, 1.0, 0.0}, 0.1) == std::vector<size_t>{1});
    CHECK(peaks(std::vector<double>{0.0, 1.0, 0.95, 1.1, 0.0}, 0.1) == std::vector<size_t>{3});
    CHECK(peaks(std::vector<double>{0.0, 1.0, 0.8, 1.1, 0.0}, 0.1) == std::vector<size_t>{1, 3});
    CHECK(peaks(std::vector<double>{0.0, 0.05, 0.0, 0.05, 0.0}, 0.1).empty());
}

TEST_CASE("statistics: mean, error, percentiles") {
    std::vector<double> values;
    for (int i = 100; i >= 0; --i) values.push_back(i);
    const Statistic s = summarise(values);
    CHECK(s.mean == doctest::Approx(50.0));
    CHECK(s.deviation == doctest::Approx(std::sqrt(101.0 * 102.0 / 12.0)));
    CHECK(s.standard_error == doctest::Approx(s.deviation / std::sqrt(101.0)));
    CHECK(s.p5 == doctest::Approx(5.0));
    CHECK(s.p50 == doctest::Approx(50.0));
    CHECK(s.p95 == doctest::Approx(95.0));
    CHECK(summarise({}).count == 0);
    CHECK(summarise({3.0}).standard_error == 0.0);
}

TEST_CASE("a baked disc is a disc: mass, inertia and added mass") {
    const double a = 0.02, density = 0.07;
    const lr_asset_info info = info_of(bake_disc(a, 1e-4, density, Fluid{}));
    const double mass = density * pi * a * a;
    CHECK(info.mass == doctest::Approx(mass).epsilon(1e-6));
    CHECK(info.inertia[0] == doctest::Approx(mass * a * a / 4.0).epsilon(2e-3));
    CHECK(info.inertia[8] == doctest::Approx(mass * a * a / 2.0).epsilon(2e-3));
    CHECK(info.added_mass[14] == doctest::Approx(1.2 * 8.0 / 3.0 * a * a * a).epsilon(0.01));
    CHECK(info.added_mass[21] == doctest::Approx(1.2 * 16.0 / 45.0 * std::pow(a, 5.0)).epsilon(0.01));
}

TEST_CASE("random orientations are uniform: the normal's height is") {
    Random random(4);
    double mean = 0.0, square = 0.0, spin = 0.0;
    const int n = 20000;
    for (int i = 0; i < n; ++i) {
        const Eigen::Quaterniond q = random.orientation();
        const double y = (q * Eigen::Vector3d::UnitZ()).y();
        mean += y / n, square += y * y / n;
        spin += (q * Eigen::Vector3d::UnitX()).y() * y / n;
    }
    CHECK(std::abs(mean) < 5.0 / std::sqrt(3.0 * n));
    CHECK(square == doctest::Approx(1.0 / 3.0).epsilon(0.02));
    CHECK(std::abs(spin) < 0.02);
}

TEST_CASE("a recording of a body in vacuum's stead falls as Galileo says, at times between steps too") {
    const Asset ball = make_ellipsoid({0.05, 0.05, 0.05}, 1e4, {1e-3, 1.5e-5});
    Run run;
    run.loads.load_model = LR_LOADS_NONE;
    run.duration = 0.5;
    run.interval = 1.0 / 98.0;
    Start start;
    start.velocity = {1.0, 0.0, 0.0};
    start.spin = {0.0, 2.0, 0.0};
    const std::vector<Track> tracks = record(ball, run, {start, Start{}});
    REQUIRE(tracks.size() == 2);
    REQUIRE(tracks[0].samples.size() == 50);
    for (size_t i = 0; i < 50; ++i) {
        const double t = run.interval * static_cast<double>(i);
        const Sample& s = tracks[0].samples[i];
        CHECK((s.position - Eigen::Vector3d(t, -0.5 * 9.81 * t * t, 0.0)).norm() < 2e-5);
        CHECK((s.velocity - Eigen::Vector3d(1.0, -9.81 * t, 0.0)).norm() < 2e-4);
        const Eigen::Vector3d x = s.orientation * Eigen::Vector3d::UnitX();
        CHECK((x - Eigen::Vector3d(std::cos(2.0 * t), 0.0, -std::sin(2.0 * t))).norm() < 1e-3);
        CHECK(std::abs(tracks[1].samples[i].position.x()) < 1e-9);
    }
}

TEST_CASE("a recording with long steps keeps to the curve between them") {
    const Asset ball = make_ellipsoid({0.05, 0.05, 0.05}, 1e4, {1e-3, 1.5e-5});
    Run run;
    run.loads.load_model = LR_LOADS_NONE;
    run.dt = 0.05f;
    run.duration = 0.5;
    run.interval = 0.0125;
    const std::vector<Track> tracks = record(ball, run, {Start{}});
    for (size_t i = 0; i < tracks[0].samples.size(); ++i) {
        const double t = run.interval * static_cast<double>(i);
        CHECK(std::abs(tracks[0].samples[i].position.y() + 0.5 * 9.81 * t * t) < 1e-5); // a chord is off by 3 mm
    }
}

TEST_CASE("a recording ends when all bodies are below its floor") {
    const Asset ball = make_ellipsoid({0.05, 0.05, 0.05}, 1e4, {1e-3, 1.5e-5});
    Run run;
    run.loads.load_model = LR_LOADS_NONE;
    run.duration = 3.0;
    run.floor = -0.5 * 9.81;
    Start late;
    late.position.y() = 0.5 * 9.81 * (1.44 - 1.0); // reaches it after 1.2 s
    const std::vector<Track> tracks = record(ball, run, {Start{}, late});
    for (const Track& t : tracks) CHECK(std::abs(static_cast<double>(t.samples.size()) - 121.0) <= 1.0);
    CHECK(tracks[1].samples.back().position.y() < run.floor);
}

TEST_CASE("a leaf's upper page has half of its faces and its outline's area") {
    const Triangles page = upper_page(LR_ASSETS "/leaf.obj");
    CHECK(page.indices.size() == 3 * 600);
    const lr_asset_info info = info_of(load(page.bake(sheet_options(3e-4, 0.08, Fluid{}))));
    CHECK(info.mass / 0.08 == doctest::Approx(0.7 * 0.07 * 0.04).epsilon(0.15)); // an oval is 0.7 of its box
    CHECK_THROWS(upper_page("no such file"));
}

TEST_CASE("a disc made for a Reynolds number weighs what its drag at that speed carries") {
    const double d = 3e-3, re = 360.0, speed = re * 1.5e-5 / d;
    const lr_asset_info info = info_of(disc_sinking_at(re, d));
    CHECK(info.mass * 9.81 == doctest::Approx(0.5 * 1.2 * speed * speed * 0.25 * pi * d * d * (1.17 + 20.4 / re)));
}
