#include "baker/aerodynamics/outline_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

namespace lr::baker {
namespace {

using Eigen::Vector3d;

constexpr double good_sectors = 0.88; // mean compactness of sectors
constexpr double symmetric = 1e-3;    // skewness of an outline, below which it is its own mirror image
constexpr int directions = 24, offsets = 23;

struct Dot {
    Eigen::Vector2d at;
    double area;
    double height = 0.0; // along the normal
};

struct Outline {
    double area = 0.0;
    Eigen::Vector2d first = Eigen::Vector2d::Zero();
    Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
    void add(const Dot& d) {
        area += d.area;
        first += d.area * d.at;
        second += d.area * d.at * d.at.transpose();
    }
    double compactness() const {
        if (!(area > 0.0)) return 1.0;
        const Eigen::Vector2d middle = first / area;
        const Eigen::Matrix2d central = second / area - middle * middle.transpose();
        const double det = central.determinant();
        return det > 0.0 ? area / (12.0 * std::sqrt(det)) : 1.0;
    }
};

struct Frame {
    Vector3d x, y;
};

Frame frame_across(const Vector3d& normal) {
    const Vector3d x = normal.unitOrthogonal();
    return {x, normal.cross(x)};
}

// Joins the dots in each square of a grid.
std::vector<Dot> joined(const std::vector<Dot>& dots, double step) {
    std::map<std::pair<int64_t, int64_t>, Dot> squares;
    for (const Dot& d : dots) {
        const auto index = [&](double x) { return static_cast<int64_t>(std::floor(x / step)); };
        Dot& sum = squares.try_emplace({index(d.at.x()), index(d.at.y())}, Dot{Eigen::Vector2d::Zero(), 0.0, 0.0})
                       .first->second;
        sum.at += d.area * d.at;
        sum.area += d.area;
        sum.height += d.area * d.height;
    }
    std::vector<Dot> out;
    for (const auto& [at, sum] : squares)
        if (sum.area > 0.0) out.push_back({sum.at / sum.area, sum.area, sum.height / sum.area});
    return out;
}

std::vector<Dot> dots_of(const Part& part, const Vector3d& normal, const Frame& frame) {
    constexpr std::size_t most_dots = 50000; // dense meshes have more, which are joined
    double size = 0.0;
    for (const Vector3d& e : {frame.x, frame.y}) {
        const auto [low, high] = extent_of(part, e);
        size = std::max(size, high - low);
    }
    std::vector<Dot> dots;
    for (const Facet& f : refined(part, size / 40.0)) {
        const Vector3d m = f.middle();
        dots.push_back({{frame.x.dot(m), frame.y.dot(m)}, f.area * std::abs(f.normal.dot(normal)), normal.dot(m)});
    }
    return dots.size() > most_dots ? joined(dots, size / 80.0) : dots;
}

struct Line {
    double cosine = 1.0, sine = 0.0, offset = 0.0, score = -1.0;
};

// Mean compactness of both sides by area; -1 if one is too small.
double score_of(const std::vector<Dot>& dots, const Line& line) {
    Outline below, above;
    for (const Dot& d : dots) (line.cosine * d.at.x() + line.sine * d.at.y() < line.offset ? below : above).add(d);
    const double whole = below.area + above.area;
    if (std::min(below.area, above.area) < least_share * whole) return -1.0;
    return (below.area * std::min(below.compactness(), 1.0) + above.area * std::min(above.compactness(), 1.0)) / whole;
}

struct Turn {
    double cosine = 1.0, sine = 0.0;
    Turn plus(const Turn& a) const { return {cosine * a.cosine - sine * a.sine, sine * a.cosine + cosine * a.sine}; }
    Turn half() const {
        return {std::sqrt(0.5 * (1.0 + cosine)), std::sqrt(0.5 * (1.0 - cosine))};
    } // below half a turn
};

// Equal sectors about the centroid.
struct Sectors {
    std::size_t count = 0;
    Turn first, width;
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    double score = -1.0;
    Turn border(std::size_t k) const {
        Turn a = first;
        for (std::size_t i = 0; i < k; ++i) a = a.plus(width);
        return a;
    }
};

double score_of(const std::vector<Dot>& dots, const Sectors& sectors) {
    std::vector<Outline> outlines(sectors.count);
    std::vector<Turn> borders;
    for (std::size_t k = 0; k <= sectors.count; ++k) borders.push_back(sectors.border(k));
    const auto left_of = [](const Turn& a, const Eigen::Vector2d& p) {
        return a.cosine * p.y() - a.sine * p.x() > 0.0;
    };
    double area = 0.0, sum = 0.0;
    for (const Dot& d : dots) {
        const Eigen::Vector2d p = d.at - sectors.centre;
        area += d.area;
        for (std::size_t k = 0; k < sectors.count; ++k)
            if (left_of(borders[k], p) && !left_of(borders[k + 1], p)) {
                outlines[k].add({p, d.area});
                break;
            }
    }
    for (const Outline& o : outlines) sum += o.area * std::min(o.compactness(), 1.0);
    return sum / area;
}

struct MirrorLine {
    Turn along;
    double skewness; // square of the odd part over that of the outline; 0: the outline is its own mirror image
};

// The line, through the centroid, in which a surface is most nearly its own mirror image: along x, or else the best.
MirrorLine mirror_line(const std::vector<Dot>& dots) {
    // Moments of z^m, z = x + i y, of the area and of the height. Along a mirror line all are real.
    constexpr std::size_t most = 8;
    using Complex = std::complex<double>;
    Outline all;
    double height = 0.0;
    for (const Dot& d : dots) {
        all.add(d);
        height += d.area * d.height;
    }
    const Eigen::Vector2d middle = all.first / all.area;
    const double reach = std::sqrt(2.0 * ((all.second / all.area).trace() - middle.squaredNorm()));
    std::array<std::array<Complex, 2>, most + 1> moments{};
    for (const Dot& d : dots) {
        const Complex z((d.at.x() - middle.x()) / reach, (d.at.y() - middle.y()) / reach);
        const double share = d.area / all.area, above = (d.height - height / all.area) / reach;
        Complex power = share;
        for (std::size_t m = 1; m <= most; ++m) {
            power *= z;
            moments[m][0] += power;
            moments[m][1] += above * power;
        }
    }
    double squares = 0.0;
    for (const auto& [level, raised] : moments) squares += std::norm(level) + std::norm(raised);
    const auto skewness_along = [&](const Complex& direction) {
        Complex back = 1.0;
        double sum = 0.0;
        for (const auto& [level, raised] : moments) {
            const double odd = (level * back).imag(), odd_raised = (raised * back).imag();
            sum += odd * odd + odd_raised * odd_raised;
            back *= std::conj(direction);
        }
        return sum;
    };
    constexpr double negligible = 1e-6; // of a disc whose triangles are uneven
    Complex best = 1.0;
    double lowest = skewness_along(best) - negligible;
    const auto try_along = [&](Complex direction) {
        direction /= std::sqrt(std::norm(direction));
        const double found = skewness_along(direction);
        if (!(found < lowest * (1.0 - 1e-9))) return;
        best = direction;
        lowest = found;
    };
    // Half a turn in steps of an eighth of the shortest period, and smaller ones.
    Complex direction = 1.0;
    for (int turn = 0; turn < 64; ++turn) try_along(direction *= Complex(1.0, 0.05));
    for (double step = 0.025; step > 1e-7; step *= 0.5)
        for (const double by : {step, -step}) try_along(best * Complex(1.0, by));
    return {{best.real(), best.imag()}, std::max(lowest, 0.0) / (squares + negligible)};
}

// The fewest sectors that are compact, or else the best.
Sectors best_sectors(const std::vector<Dot>& dots, std::size_t most) {
    // Cosines of 2 pi/n for n = 3 to 8.
    const double cosines[] = {-0.5, 0.0, 0.25 * (std::sqrt(5.0) - 1.0), 0.5, 0.6234898018587336, std::sqrt(0.5)};
    Sectors best;
    Outline all;
    for (const Dot& d : dots) all.add(d);
    const MirrorLine mirror = mirror_line(dots);
    for (std::size_t n = 3; n <= std::min<std::size_t>(most, 8); ++n) {
        Sectors s, found;
        s.count = n;
        s.centre = all.first / all.area;
        s.width = {cosines[n - 3], std::sqrt(1.0 - cosines[n - 3] * cosines[n - 3])};
        // Of its own mirror image the sectors are too, or a blossom would have a preferred sense of spin.
        if (mirror.skewness < symmetric) {
            s.first = mirror.along;
            for (const bool between : {false, true}) {
                if (between) s.first = s.first.plus(s.width.half());
                s.score = score_of(dots, s);
                if (s.score > found.score + 1e-9) found = s;
            }
            if (found.score > best.score + 0.01) best = found;
            if (best.score > good_sectors) break;
            continue;
        }
        // Some three degrees, over the width of a sector.
        const double small = 0.05, cosine = std::sqrt(1.0 - small * small);
        for (int turn = 0; turn < static_cast<int>(126 / n) + 1; ++turn) {
            s.score = score_of(dots, s);
            if (s.score > found.score + 1e-9) found = s;
            s.first = s.first.plus({cosine, small});
        }
        for (double step = 0.5 * small; step > 1e-3; step *= 0.5)
            for (const double by : {step, -step}) {
                s = found;
                s.first = s.first.plus({std::sqrt(1.0 - by * by), by});
                s.score = score_of(dots, s);
                if (s.score > found.score + 1e-9) found = s;
            }
        if (found.score > best.score + 0.01) best = found;
        if (best.score > good_sectors) break;
    }
    return best;
}

Line best_line(const std::vector<Dot>& dots) {
    Line best;
    double step = 0.0;
    // cos and sin of pi/24, without the C library's sine.
    const double cosine = std::sqrt(0.5 + 0.5 * std::sqrt(0.5 + 0.5 * std::sqrt(0.75))),
                 sine = std::sqrt(1.0 - cosine * cosine);
    Line line;
    for (int turn = 0; turn < directions; ++turn) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const Dot& d : dots) {
            const double x = line.cosine * d.at.x() + line.sine * d.at.y();
            low = std::min(low, x);
            high = std::max(high, x);
        }
        for (int i = 1; i <= offsets; ++i) {
            line.offset = low + (high - low) * i / (offsets + 1);
            line.score = score_of(dots, line);
            if (line.score > best.score + 1e-9) {
                best = line;
                step = (high - low) / (offsets + 1);
            }
        }
        const double c = cosine * line.cosine - sine * line.sine;
        line.sine = sine * line.cosine + cosine * line.sine;
        line.cosine = c;
    }
    // Descends in smaller and smaller steps, so that the line does not depend on the frame.
    double turn = 0.06;
    for (int round = 0; round < 12; ++round) {
        bool better = false;
        for (const auto& [by, shift] : {std::pair{turn, 0.0}, {-turn, 0.0}, {0.0, step}, {0.0, -step}}) {
            Line next = best;
            const double length = std::sqrt(1.0 + by * by);
            next.cosine = (best.cosine - by * best.sine) / length;
            next.sine = (best.sine + by * best.cosine) / length;
            next.offset = best.offset + shift;
            next.score = score_of(dots, next);
            if (next.score > best.score + 1e-9) {
                best = next;
                better = true;
            }
        }
        if (!better) {
            turn *= 0.5;
            step *= 0.5;
        }
    }
    return best;
}
} // namespace

double compactness(const Part& part, const Vector3d& normal) {
    const Frame frame = frame_across(normal);
    Outline all;
    const Vector3d origin = part.empty() ? Vector3d(Vector3d::Zero()) : part.front().at[0];
    for (const Facet& f : part) {
        const double area = f.area * std::abs(f.normal.dot(normal));
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
        for (const Vector3d& corner : f.at) {
            const Vector3d r = corner - origin;
            const Eigen::Vector2d p(frame.x.dot(r), frame.y.dot(r));
            sum += p;
            squares += p * p.transpose();
        }
        all.area += area;
        all.first += area / 3.0 * sum;
        all.second += area / 12.0 * (squares + sum * sum.transpose());
    }
    return all.compactness();
}

Vector3d mirror_line(const Part& part, const Vector3d& normal, const Vector3d& like) {
    const Frame frame{like, normal.cross(like)};
    const Turn along = mirror_line(dots_of(part, normal, frame)).along;
    return along.cosine * frame.x + along.sine * frame.y;
}

std::vector<Part> split_by_outline(Part part, const Vector3d& normal, std::size_t most) {
    if (compactness(part, normal) > least_compactness) return {std::move(part)};
    const Frame frame = frame_across(normal);
    const std::vector<Dot> dots = dots_of(part, normal, frame);
    const Sectors sectors = best_sectors(dots, most);
    std::vector<Part> out;
    if (sectors.score > good_sectors) {
        for (std::size_t i = 0; i < sectors.count; ++i) {
            const auto border = [&](std::size_t k) {
                const Turn a = sectors.border(k);
                return Vector3d(a.cosine * frame.y - a.sine * frame.x);
            };
            const Vector3d from = border(i), to = border(i + 1);
            const Vector3d at = sectors.centre.x() * frame.x + sectors.centre.y() * frame.y;
            out.push_back(cut(cut(part, from, from.dot(at)).second, to, to.dot(at)).first);
        }
        return out;
    }
    out.push_back(std::move(part));
    while (out.size() < most) {
        std::size_t worst = out.size();
        double gain = 0.0;
        for (std::size_t i = 0; i < out.size(); ++i) {
            const double c = compactness(out[i], normal), area = moments_of(out[i]).area;
            if (c < least_compactness && area * (1.0 - c) > gain) {
                gain = area * (1.0 - c);
                worst = i;
            }
        }
        if (worst == out.size()) break;
        const Line line = best_line(dots_of(out[worst], normal, frame));
        if (!(line.score > compactness(out[worst], normal))) break;
        auto [below, above] = cut(out[worst], line.cosine * frame.x + line.sine * frame.y, line.offset);
        out[worst] = std::move(below);
        out.push_back(std::move(above));
    }
    return out;
}
} // namespace lr::baker
