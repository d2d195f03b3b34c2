#include "tools/lr_drop/paths_picture.h"

#include "baker/eigensystem.h"
#include "baker/length_text.h"
#include "tools/encode_png.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

namespace lr::tools {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int width = 2000, height = 1210;                                       // px
constexpr double margin = 48.0, header = 118.0, side = 470.0, least_body = 20.0; // px; side: width of the right column

Colour ink(size_t i) {
    static constexpr std::array<std::array<int, 3>, 7> inks{
        {{24, 104, 118}, {186, 78, 42}, {58, 84, 148}, {188, 134, 26}, {112, 58, 108}, {92, 116, 44}, {184, 66, 92}}};
    const auto& c = inks[i % inks.size()];
    return from_srgb(c[0], c[1], c[2]);
}
const Colour paper = from_srgb(252, 250, 245), black = from_srgb(44, 42, 40), grey = from_srgb(150, 146, 140),
             pale = from_srgb(226, 221, 211), slate = from_srgb(104, 99, 92);

Point operator+(Point a, const Vector2d& b) {
    return {a.x + b.x(), a.y + b.y()};
}

// The picture's axes in the world. right: direction of the wind, if any; toward_viewer: out of the side view.
struct Axes {
    Vector3d right = Vector3d::UnitX(), toward_viewer = Vector3d::UnitZ();

    explicit Axes(const Vector3d& wind) {
        const Vector3d level(wind.x(), 0.0, wind.z());
        if (level.norm() > 0.0) right = level.normalized();
        toward_viewer = right.cross(falls::up());
    }
    Vector2d from_side(const Vector3d& p) const { return {p.dot(right), -p.y()}; }
    Vector2d from_above(const Vector3d& p) const { return {p.dot(right), p.dot(toward_viewer)}; }
};

// The largest of 1, 2, 5 times a power of ten up to `most`.
double round_length(double most) {
    const double power = std::pow(10.0, std::floor(std::log10(most)));
    return most >= 5.0 * power ? 5.0 * power : most >= 2.0 * power ? 2.0 * power : power;
}

void centred(Picture& picture, Point at, double size, Colour colour, const std::string& text) {
    write_text(picture, {at.x - 0.5 * text_width(size, text), at.y}, size, colour, text);
}

void scale_bar(Picture& picture, Point left, double scale, double most) {
    const double bar = round_length(most / scale);
    const Point end{left.x + bar * scale, left.y};
    picture.line(left, end, 2.0, black);
    for (const Point& p : {left, end}) picture.line({p.x, p.y - 5.0}, {p.x, p.y + 5.0}, 2.0, black);
    centred(picture, {0.5 * (left.x + end.x), left.y - 11.0}, 13.0, black, length_text(bar, 6));
}

void circle(Picture& picture, Point centre, double radius, double thickness, Colour colour) {
    constexpr int parts = 120;
    Point from{centre.x + radius, centre.y};
    for (int i = 1; i <= parts; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / parts;
        const Point to{centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)};
        picture.line(from, to, thickness, colour);
        from = to;
    }
}

// Silhouette of the body's ellipsoid, with one face darker so that turns are visible. scale: px per metre.
void draw_body(Picture& picture, Point at, const falls::Shape& shape, const falls::Sample& sample, const Axes& axes,
               double scale, Colour colour) {
    const Eigen::Matrix3d turned =
        sample.orientation.toRotationMatrix() * shape.ellipsoid * sample.orientation.toRotationMatrix().transpose();
    Eigen::Matrix<double, 3, 2> plane;
    plane << axes.right, -falls::up();
    const baker::Eigensystem<Eigen::Matrix2d> silhouette =
        baker::eigensystem(Eigen::Matrix2d(plane.transpose() * turned * plane));
    const Vector2d half = silhouette.values.cwiseMax(0.0).cwiseSqrt() * scale;
    const Vector2d along = silhouette.vectors.col(1);
    const bool front = (sample.orientation * shape.normal).dot(axes.toward_viewer) > 0.0;
    const auto ellipse = [&](double grown, Colour fill, float alpha) {
        const double major = half[1] + grown, minor = std::max(half[0] + grown, 0.8);
        picture.ellipse(at, {major * along.x(), major * along.y()}, minor / major, fill, alpha);
    };
    ellipse(1.1, mixed(colour, black, 0.35f), 0.95f);
    if (half[0] > 0.9) ellipse(-0.3, front ? mixed(colour, paper, 0.12f) : mixed(colour, paper, 0.68f), 1.0f);
}

struct Lanes {
    size_t rows = 1, columns = 1;
    double scale = 1.0, width = 1.0; // px per metre; m, of a cell
    double left = 0.0;               // m, from a cell's left edge to the point of release
    double above = 0.0;              // m, from a cell's top to the point of release
};

// A cell holds four fifths of the falls whole; the others reach into neighbours. More rows fill the page better, if the scale does not suffer much.
Lanes arrange(const Results& results, const Axes& axes, double drop_height, double wide, double high) {
    std::vector<double> left, right, top;
    for (const falls::Track& t : results.tracks) {
        Vector2d low = Vector2d::Zero(), far = Vector2d::Zero();
        for (const falls::Sample& s : t.samples) {
            low = low.cwiseMin(axes.from_side(s.position));
            far = far.cwiseMax(axes.from_side(s.position));
        }
        left.push_back(-low.x());
        right.push_back(far.x());
        top.push_back(-low.y());
    }
    for (std::vector<double>* sorted : {&left, &right, &top}) std::sort(sorted->begin(), sorted->end());
    const double d = results.shape.length, before = falls::quantile(left, 0.8), after = falls::quantile(right, 0.8);
    const double risen = top.back(), fallen = results.falls.descent.mean < 0.0 ? 0.0 : drop_height;
    Lanes best;
    double largest = 0.0; // of the scale, reduced for empty cells
    for (size_t rows = 1; rows <= results.tracks.size(); ++rows) {
        Lanes lanes;
        lanes.rows = rows;
        lanes.columns = (results.tracks.size() + rows - 1) / rows;
        const double width_needed = std::max(before + after, 0.12 * drop_height) + 1.2 * d;
        lanes.scale = std::min(wide / (width_needed * static_cast<double>(lanes.columns)),
                               high / static_cast<double>(rows) / (risen + 1.08 * fallen + 1.6 * d));
        lanes.width = wide / lanes.scale / static_cast<double>(lanes.columns);
        lanes.left = before + 0.5 * (lanes.width - before - after);
        lanes.above = 0.8 * d + risen;
        const double filled = static_cast<double>(results.tracks.size()) / static_cast<double>(rows * lanes.columns);
        largest = std::max(largest, filled * lanes.scale);
        if (filled * lanes.scale >= 0.88 * largest) best = lanes;
    }
    return best;
}

void draw_falls(Picture& picture, const DropCommand& command, const Results& results, const Axes& axes) {
    const double wide = width - side - 3.0 * margin, high = height - header - 2.0 * margin;
    const double drop_height = command.drop.height;
    const Lanes lanes = arrange(results, axes, drop_height, wide, high);
    const double row = high / static_cast<double>(lanes.rows);
    const double enlarged = std::max(1.0, least_body / (lanes.scale * results.shape.length));
    const double speed = std::max(std::hypot(results.falls.descent.mean, results.falls.horizontal_speed.mean), 1e-6);
    const double longest =
        std::max(0.001, results.falls.time.mean > 0.0 ? results.falls.time.mean : results.tracks[0].time);
    const double every = round_length(std::min(1.05 * enlarged * results.shape.length / speed, 0.25 * longest));

    for (size_t r = 0; r < lanes.rows; ++r) {
        const double top = header + row * static_cast<double>(r) + lanes.scale * lanes.above;
        const double floor = top + lanes.scale * (results.falls.descent.mean < 0.0 ? -drop_height : drop_height);
        picture.line({margin, floor}, {margin + wide, floor}, 1.6, grey);
    }
    for (size_t i = 0; i < results.tracks.size(); ++i) {
        const Point start{margin + lanes.scale * (lanes.width * static_cast<double>(i % lanes.columns) + lanes.left),
                          header + row * static_cast<double>(i / lanes.columns) + lanes.scale * lanes.above};
        const falls::Track& t = results.tracks[i];
        const auto at = [&](const Vector3d& p) { return start + Vector2d(lanes.scale * axes.from_side(p)); };
        const Colour line = mixed(ink(i), paper, 0.45f);
        for (size_t k = 1; k < t.samples.size(); ++k)
            picture.line(at(t.samples[k - 1].position), at(t.samples[k].position), 1.3, line);
        picture.line(at(t.samples.back().position), at(t.end), 1.3, line);
        double due = 0.0;
        for (size_t k = 0; k < t.samples.size(); ++k)
            if (static_cast<double>(k) * t.interval >= due - 1e-9) {
                draw_body(picture, at(t.samples[k].position), results.shape, t.samples[k], axes, lanes.scale * enlarged,
                          ink(i));
                due += every;
            }
    }
    char text[160];
    std::snprintf(text, sizeof text, "%zu of them from the side, a body every %g s%s", results.tracks.size(), every,
                  enlarged > 1.05 ? ", drawn " : "");
    std::string caption = text;
    if (enlarged > 1.05) {
        std::snprintf(text, sizeof text, "%.*f times as large", enlarged < 9.95 ? 1 : 0, enlarged);
        caption += text;
    }
    write_text(picture, {margin, 84.0}, 14.0, grey, caption);
    scale_bar(picture, {margin, height - 30.0}, lanes.scale, 0.12 * wide);
    // Keeps falls that reach beyond their lanes out of the right column.
    const int column = static_cast<int>(width - 1.5 * margin - side);
    picture.fill(column, 0, width - column, height, paper, 1.0f);
}

void draw_landings(Picture& picture, const DropCommand& command, const Results& results, const Axes& axes) {
    const double left = width - margin - side, top = header + 26.0;
    write_text(picture, {left, 84.0}, 14.0, grey, "all landings from above");
    const Vector2d mean = axes.from_above(results.falls.drift);
    const double reach = std::max(1.15 * results.falls.most_radius, 0.5 * results.shape.length);
    const bool far_away = mean.norm() > 4.0 * reach; // the release point is left out
    const Vector2d border(reach, reach), release_border = 0.1 * border;
    const Vector2d low = far_away ? Vector2d(mean - border) : (mean - border).cwiseMin(-release_border);
    const Vector2d high = far_away ? Vector2d(mean + border) : (mean + border).cwiseMax(release_border);
    const double scale = side / (high - low).maxCoeff();
    const Vector2d middle = 0.5 * (low + high);
    const auto at = [&](const Vector2d& p) {
        return Point{left + 0.5 * side, top + 0.5 * side} + Vector2d(scale * (p - middle));
    };
    const auto inside = [&](Point p) {
        return p.x > left - 0.4 * margin && p.x < left + side + 0.4 * margin && p.y > top - 0.4 * margin &&
               p.y < top + side + 0.4 * margin;
    };
    for (const double radius : {results.falls.half_radius, results.falls.most_radius})
        picture.ellipse(at(mean), {scale * radius, 0.0}, 1.0, pale, 0.42f);
    const double dot = std::clamp(60.0 / std::sqrt(static_cast<double>(results.each.size())), 1.4, 4.0);
    for (const falls::Fall& f : results.each) {
        const Point p = at(axes.from_above(f.end));
        if (inside(p)) picture.ellipse(p, {dot, 0.0}, 1.0, black, 0.42f);
    }
    for (size_t i = 0; i < results.tracks.size(); ++i) {
        const Point p = at(axes.from_above(results.tracks[i].end));
        if (inside(p)) picture.ellipse(p, {dot + 2.0, 0.0}, 1.0, ink(i), 1.0f);
    }
    circle(picture, at(mean), scale * results.falls.half_radius, 1.6, black);
    circle(picture, at(mean), scale * results.falls.most_radius, 1.6, grey);
    const Point release = at(Vector2d::Zero());
    for (const Vector2d& arm : {Vector2d(9.0, 9.0), Vector2d(9.0, -9.0)})
        if (!far_away) picture.line(release + arm, release + Vector2d(-arm), 2.2, black);
    const Vector3d& wind = command.drop.wind;
    if (wind.x() != 0.0 || wind.z() != 0.0) {
        const Point tip{left + side, 78.0}, tail{left + side - 90.0, 78.0};
        picture.line(tail, tip, 2.2, black);
        for (const double up : {-7.0, 7.0}) picture.line({tip.x - 12.0, tip.y + up}, tip, 2.2, black);
        write_text(picture, {tail.x - 10.0 - text_width(14.0, "wind"), 84.0}, 14.0, black, "wind");
    }
    scale_bar(picture, {left, top + side + 44.0}, scale, 0.4 * side);
    write_text(picture, {left + 0.48 * side, top + side + 49.0}, 13.0, grey, "circles: half, and 95 %");
}

void draw_shares(Picture& picture, const Results& results) {
    const double left = width - margin - side, bars = left + 150.0, most = side - 150.0 - 60.0;
    double y = header + side + 140.0;
    for (size_t i = 0; i < results.falls.shares.size(); ++i, y += 34.0) {
        const double share = results.falls.shares[i];
        char text[16];
        std::snprintf(text, sizeof text, "%.0f %%", 100.0 * share);
        const Colour words = share >= 0.005 ? black : grey;
        write_text(picture, {left, y}, 14.0, words, falls::motion_names[i]);
        picture.fill(static_cast<int>(bars), static_cast<int>(y - 14.0), static_cast<int>(most), 16, pale, 0.6f);
        picture.fill(static_cast<int>(bars), static_cast<int>(y - 14.0), static_cast<int>(std::lround(most * share)),
                     16, slate, 1.0f);
        write_text(picture, {bars + most + 12.0, y}, 14.0, words, text);
    }
    const falls::Falls& f = results.falls;
    const auto line = [&](const std::string& text) {
        write_text(picture, {left, y += 30.0}, std::min(14.0, 14.0 * side / text_width(14.0, text)), black, text);
    };
    line(falls::sentence(f, results.shape));
    if (f.arrived > 0)
        line("time of fall " + number(f.time.mean) + " s, " + number(f.time.p5) + " to " + number(f.time.p95));
    if (f.drift.norm() > f.half_radius) line("drift " + number(f.drift.norm()) + " m");
    line("half land within " + number(f.half_radius) + " m, 95 % within " + number(f.most_radius) + " m");
}
} // namespace

std::vector<uint8_t> draw_paths(const DropCommand& command, const Results& results) {
    Picture picture(width, height, paper);
    const Axes axes(command.drop.wind);
    std::string heading = title(command, results);
    std::erase(heading, '^'); // the font has no '^'
    draw_falls(picture, command, results, axes);
    const double space = width - 2.0 * margin;
    write_text(picture, {margin, 48.0}, std::min(20.0, 20.0 * space / text_width(20.0, heading)), black, heading);
    draw_landings(picture, command, results, axes);
    draw_shares(picture, results);
    return encode_png(picture);
}
} // namespace lr::tools
